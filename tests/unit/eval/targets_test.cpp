// Every instruction set that this machine offers, one after the other: each keeps the stated accuracy, and
// within each a parameter gives the same bits however it is asked for. Handles are made anew for each,
// because the tables of a handle come from the instruction set that was chosen when they were built.
#include "unit/targets.h"

#include "basis/power_spans.h"
#include "eval/kernels/slots.h"
#include "property/surface_normals.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace targets_test {

using namespace support;
using nrb::eval::slot_count;
using reference::eps;
using targets::choose;
using targets::offered_targets;

namespace {

enum class Balance { polynomial, even, uneven }; // even: ratios of weights to 4, the centred powers' limit

SplineData make_data(Random &random, std::vector<AxisRecipe> axes, Balance balance, int dim) {
    Recipe recipe;
    recipe.axes = std::move(axes);
    recipe.dim = dim;
    recipe.weights = balance == Balance::polynomial ? Weights::none
                     : balance == Balance::even     ? Weights::moderate
                                                    : Weights::extreme;
    SplineData data = random_spline(random, recipe);
    if (balance == Balance::even) {
        for (double &weight : data.weights) {
            weight = 1 + weight / 2; // 0.2 to 5 becomes 1.1 to 3.5; equal weights stay equal
        }
    }
    return data;
}

using Targets = targets::Targets;

constexpr Balance balances[] = {Balance::polynomial, Balance::even, Balance::uneven};
constexpr KnotForm forms[] = {KnotForm::clamped, KnotForm::unclamped, KnotForm::periodic};
constexpr int dims[] = {1, 2, 3, 6};

AxisRecipe axis(int degree, KnotForm form) {
    return {degree, form, Spacing::full, Placement::origin, 4};
}

using Body = void (*)(Random &random, const SplineData &data);

void for_curves(Body body) {
    uint64_t seed = 90000;
    for (const int degree : {1, 2, 3, 5, 9, 12}) {
        for (const KnotForm form : forms) {
            for (const Balance balance : balances) {
                for (const int dim : dims) {
                    Random random(++seed);
                    body(random, make_data(random, {axis(degree, form)}, balance, dim));
                }
            }
        }
    }
}

// Every balance and dimension with every list of degrees; the forms take turns on the axes.
void for_tensors(uint64_t seed, const std::vector<std::vector<int>> &degrees, Body body) {
    size_t turn = 0;
    for (const auto &list : degrees) {
        for (const Balance balance : balances) {
            for (const int dim : dims) {
                Random random(++seed);
                std::vector<AxisRecipe> axes;
                for (const int degree : list) {
                    axes.push_back(axis(degree, forms[turn++ % std::size(forms)]));
                }
                body(random, make_data(random, axes, balance, dim));
            }
        }
    }
}

void for_surfaces(Body body) {
    for_tensors(91000, {{3, 3}, {1, 2}, {5, 3}, {9, 1}, {2, 12}}, body);
}

void for_volumes(Body body) {
    for_tensors(92000, {{3, 3, 3}, {2, 1, 3}}, body);
}

// Derivatives to order 2 of a few points, each against its own bound.
template <int kPoints>
void check_accuracy(Random &random, const SplineData &data) {
    const auto g = create(data);
    const auto params = away_from_underflow(random_params(random, data, 40));
    const auto derivs = eval_derivs(g.get(), 2, params); // more than there are spans: with tables
    const auto indices = graded_indices(data.axes(), 2);
    const long double c = reference::c_of(data);
    auto value = derivs.begin();
    for (size_t i = 0; i < kPoints; ++i) {
        const double *param = params.data() + i * data.degrees.size();
        const auto want = reference::exact_derivatives(data, 2, param);
        const auto sizes = reference::magnitudes(data, 2, param);
        const long double factor = reference::weight_factor(data, param);
        for (size_t slot = 0; slot < indices.size(); ++slot) {
            const int k = std::accumulate(indices[slot].begin(), indices[slot].end(), 0);
            for (size_t d = 0; d < want[slot].size(); ++d, ++value) {
                const long double bound = k == 0 ? c * factor * eps * reference::exact_hull(data, param)
                                                 : 2 * (c + 2 * k) * eps * sizes[slot][d];
                ASSERT_LE(reference::error_ratio(*value, want[slot][d], bound), 1)
                    << describe(data) << "slot " << slot << " at " << hex({param, param + data.axes()});
            }
        }
    }
}

std::vector<double> rearranged(const std::vector<double> &records, size_t width,
                               const std::vector<size_t> &order) {
    std::vector<double> result;
    for (const size_t i : order) {
        const auto from = records.begin() + static_cast<std::ptrdiff_t>(i * width);
        result.insert(result.end(), from, from + static_cast<std::ptrdiff_t>(width));
    }
    return result;
}

bool rounds_to(float single, double value) {
    return same_bits(single, static_cast<float>(value));
}

// What one target gives for a batch of parameters, to be compared with every other way to ask.
struct Batch {
    const SplineData &data;
    Handle g;
    size_t n;
    size_t width; // of a record of derivatives
    std::vector<double> params;
    std::vector<double> derivs;

    Batch(Random &random, const SplineData &spline, int count)
        : data(spline), g(create(spline)), n(static_cast<size_t>(count)),
          params(random_params(random, spline, count)), derivs(eval_derivs(g.get(), 2, params)) {
        width = derivs.size() / n;
    }
    [[nodiscard]] size_t axes() const { return data.degrees.size(); }
    [[nodiscard]] auto dim() const { return static_cast<size_t>(data.dim); }
    [[nodiscard]] std::vector<double> param(size_t i) const { return rearranged(params, axes(), {i}); }
    [[nodiscard]] std::vector<double> record(size_t i) const { return rearranged(derivs, width, {i}); }
    // The first components of every record: the points, or the derivatives of lower order.
    [[nodiscard]] std::vector<double> heads(size_t size) const {
        std::vector<double> result;
        for (size_t i = 0; i < n; ++i) {
            const auto from = derivs.begin() + static_cast<std::ptrdiff_t>(i * width);
            result.insert(result.end(), from, from + static_cast<std::ptrdiff_t>(size));
        }
        return result;
    }
};

void check_alone(const Batch &batch) {
    for (size_t i = 0; i < batch.n; ++i) {
        // A fresh handle has no tables yet.
        const Handle fresh = i < 4 ? create(batch.data) : nullptr;
        const nurbs *g = i < 4 ? fresh.get() : batch.g.get();
        ASSERT_TRUE(same_bits(eval_derivs(g, 2, batch.param(i)), batch.record(i)))
            << describe(batch.data) << "at " << hex(batch.param(i));
    }
}

// Sorted parameters come in blocks inside one span, shuffled ones do not. Lower orders have other loops.
void check_orders(Random &random, const Batch &batch) {
    std::vector<size_t> places(batch.n);
    std::iota(places.begin(), places.end(), 0U);
    const auto check = [&](const char *name) {
        const auto params = rearranged(batch.params, batch.axes(), places);
        for (int order = 0; order <= 2; ++order) {
            const auto width =
                static_cast<size_t>(nrb::eval::slot_count(batch.data.axes(), order)) * batch.dim();
            const auto want = rearranged(batch.heads(width), width, places);
            ASSERT_TRUE(same_bits(eval_derivs(batch.g.get(), order, params), want))
                << name << ", order " << order << describe(batch.data);
        }
    };
    check("as given");
    std::sort(places.begin(), places.end(),
              [&](size_t i, size_t j) { return batch.param(i) < batch.param(j); });
    check("sorted");
    for (size_t i = places.size(); i > 1; --i) {
        std::swap(places[i - 1], places[random.bits() % i]);
    }
    check("shuffled");
}

// Parameters apart, results in columns, both at odd places.
void check_strides(const Batch &batch) {
    const size_t stride = batch.axes() + 3;
    std::vector<double> params(1 + batch.n * stride);
    for (size_t i = 0; i < batch.params.size(); ++i) {
        params[1 + i / batch.axes() * stride + i % batch.axes()] = batch.params[i];
    }
    const size_t column = batch.n + 1;
    std::vector<double> out(1 + batch.width * column);
    require_ok(nurbs_eval_derivs(batch.g.get(), 2, static_cast<int64_t>(batch.n), params.data() + 1,
                                 static_cast<int64_t>(stride), 0, out.data() + 1, 1,
                                 static_cast<int64_t>(column), 0));
    for (size_t i = 0; i < batch.derivs.size(); ++i) {
        ASSERT_TRUE(same_bits(out[1 + i / batch.width + i % batch.width * column], batch.derivs[i]))
            << describe(batch.data);
    }
}

// Points are derivatives of order 0; in single precision they are rounded once.
void check_points(const Batch &batch) {
    const auto points = batch.heads(batch.dim());
    ASSERT_TRUE(same_bits(eval(batch.g.get(), batch.params), points)) << describe(batch.data);
    std::vector<float> singles(points.size());
    require_ok(nurbs_eval_f32(batch.g.get(), static_cast<int64_t>(batch.n), batch.params.data(), 0, 0,
                              singles.data(), 0, 0, 0));
    ASSERT_TRUE(std::equal(singles.begin(), singles.end(), points.begin(), rounds_to))
        << describe(batch.data);
}

// Parameters of a grid, and the list of all its points.
struct Grid {
    std::vector<std::vector<double>> axes;
    std::vector<double> params;

    Grid(Random &random, const SplineData &data) : params{0} {
        size_t width = 0;
        for (size_t k = 0; k < data.degrees.size(); ++k, ++width) {
            axes.emplace_back();
            for (int i = data.axes() == 3 ? 5 : 11 + data.axes(); i > 0; --i) {
                axes[k].push_back(random_param(random, data.knots[k], data.degrees[k]));
            }
            std::vector<double> longer;
            for (size_t i = 0; i < std::max<size_t>(params.size() / std::max<size_t>(width, 1), 1); ++i) {
                for (const double t : axes[k]) {
                    const auto from = params.begin() + static_cast<std::ptrdiff_t>(i * width);
                    longer.insert(longer.end(), from, from + static_cast<std::ptrdiff_t>(width));
                    longer.push_back(t);
                }
            }
            params = std::move(longer);
        }
    }
};

void check_grid(Random &random, const Batch &batch) {
    const Grid grid(random, batch.data);
    const auto points = eval(batch.g.get(), grid.params);
    ASSERT_TRUE(same_bits(eval_grid(batch.g.get(), grid.axes), points)) << describe(batch.data);
    for (const int order : {1, 2}) {
        ASSERT_TRUE(same_bits(eval_grid_derivs(batch.g.get(), order, grid.axes),
                              eval_derivs(batch.g.get(), order, grid.params)))
            << describe(batch.data);
    }
    std::vector<int64_t> counts;
    std::vector<double> joined;
    for (const auto &params : grid.axes) {
        counts.push_back(std::ssize(params));
        joined.insert(joined.end(), params.begin(), params.end());
    }
    std::vector<float> singles(points.size());
    require_ok(nurbs_eval_grid_f32(batch.g.get(), counts.data(), joined.data(), singles.data(), 0, 0, 0));
    ASSERT_TRUE(std::equal(singles.begin(), singles.end(), points.begin(), rounds_to))
        << describe(batch.data);
}

template <int kPoints>
void check_bits(Random &random, const SplineData &data) {
    const Batch batch(random, data, kPoints);
    check_alone(batch);
    check_orders(random, batch);
    check_strides(batch);
    check_points(batch);
    check_grid(random, batch);
}

// The tests below would pass without testing anything if the choice did not reach the kernels.
TEST_P(Targets, are_chosen_for_the_kernels) {
    const bool widest = (GetParam() & (HWY_AVX3 | HWY_AVX3_DL)) != 0;
    const int lanes = widest ? 8 : GetParam() == HWY_AVX2 ? 4 : GetParam() == HWY_SCALAR ? 1 : 2;
    EXPECT_EQ(nrb::power_spans_together(), lanes);
}

TEST_P(Targets, keep_the_accuracy_of_curves) {
    for_curves(check_accuracy<5>);
}

TEST_P(Targets, keep_the_accuracy_of_surfaces_and_volumes) {
    for_surfaces(check_accuracy<4>);
    for_volumes(check_accuracy<4>);
}

TEST_P(Targets, give_a_parameter_of_a_curve_the_same_bits) {
    for_curves(check_bits<101>);
}

TEST_P(Targets, give_a_parameter_of_a_surface_the_same_bits) {
    for_surfaces(check_bits<67>);
}

TEST_P(Targets, give_a_parameter_of_a_volume_the_same_bits) {
    for_volumes(check_bits<37>);
}

// Surfaces in space of every balance, whose second axis is periodic.
void for_frames(Body body) {
    for (const int degree : {1, 2, 3, 5, 9}) {
        for (const Balance balance : balances) {
            Random random(93000 + static_cast<uint64_t>(degree));
            body(random, make_data(random, {axis(degree, KnotForm::clamped), axis(3, KnotForm::periodic)},
                                   balance, 3));
        }
    }
}

// Distance of the unit normal from the exact one, over the header's bound.
long double normal_error(const SurfaceFrames &frames, size_t i, const surface_normals::Exact &exact) {
    const long double size = norm(surface_normals::approximate(exact.product));
    const auto want = surface_normals::direction(exact.product);
    return norm(minus(vector_at(frames.normals, i), want)) / (exact.noise() / size + 4 * eps);
}

TEST_P(Targets, keep_the_accuracy_of_normals) {
    for_frames([](Random &random, const SplineData &data) {
        const auto params = away_from_underflow(random_params(random, data, 40));
        const auto frames = surface_frames(create(data).get(), params);
        for (size_t i = 0; i < 8; ++i) {
            const auto exact = surface_normals::exact_at(data, params.data() + 2 * i);
            if (frames.status[i] == 0) {
                ASSERT_LE(normal_error(frames, i, exact), 2) << describe(data);
            } else { // only where the normal drowns in the derivatives' errors
                const long double size = norm(surface_normals::approximate(exact.product));
                ASSERT_LE(size, 2.1L * exact.noise()) << describe(data);
            }
        }
    });
}

TEST_P(Targets, give_a_parameter_of_a_frame_the_same_bits) {
    for_frames([](Random &random, const SplineData &data) {
        const auto g = create(data);
        const Grid grid(random, data);
        const auto batch = surface_frames(g.get(), grid.params);
        const auto rows = surface_grid_frames(g.get(), grid.axes);
        ASSERT_TRUE(same_bits(batch.normals, rows.normals) && same_bits(batch.du, rows.du) &&
                    same_bits(batch.dv, rows.dv) && same_bits(batch.points, rows.points))
            << describe(data);
        for (size_t i = 0; i < batch.status.size(); ++i) {
            const auto param = rearranged(grid.params, 2, {i});
            const auto alone = surface_frames(g.get(), param);
            auto derivs = alone.points;
            derivs.insert(derivs.end(), alone.du.begin(), alone.du.end());
            derivs.insert(derivs.end(), alone.dv.begin(), alone.dv.end());
            ASSERT_TRUE(same_bits(alone.normals, rearranged(batch.normals, 3, {i}))) << describe(data);
            ASSERT_TRUE(same_bits(derivs, eval_derivs(g.get(), 1, param))) << describe(data);
        }
    });
}

INSTANTIATE_TEST_SUITE_P(All, Targets, targets::every_target(), targets::target_name);

// Only whether multiplications and additions are fused may show, not how wide the vectors are.
TEST(AllTargets, differ_only_by_fused_multiplication) {
    static std::vector<double> results;
    std::map<int64_t, std::vector<double>> of_class;
    for (const int64_t target : offered_targets()) {
        choose(target);
        results.clear();
        const Body collect = [](Random &random, const SplineData &data) {
            const auto more = eval_derivs(create(data).get(), 2, random_params(random, data, 37));
            results.insert(results.end(), more.begin(), more.end());
        };
        for_curves(collect);
        for_surfaces(collect);
        for_volumes(collect);
        const auto &first = of_class.try_emplace(targets::rounding_class(target), results).first->second;
        EXPECT_TRUE(same_bits(results, first)) << hwy::TargetName(target);
    }
    choose(0);
}

} // namespace

} // namespace targets_test
