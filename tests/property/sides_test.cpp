// The evaluation flags: sides at knots, and what happens outside the domain, against the exact one-sided
// values.
#include "reference/magnitudes.h"
#include "support/cases.h"
#include "support/handle.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace sides_test {

using namespace support;
using reference::eps;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
const double nan_value = std::numeric_limits<double>::quiet_NaN();

uint32_t flags_of(const reference::Sides &left, int axes) {
    uint32_t flags = 0;
    for (int k = 0; k < axes; ++k) {
        flags |= left[static_cast<size_t>(k)] ? NURBS_ON_AXIS(k, NURBS_LEFT) : 0U;
    }
    return flags;
}

// Every axis on its own side, at knots above all; points, derivatives and hull.
TEST(Sides, left_limits_are_the_exact_left_limits) {
    for_each_case(130000, 1000, [](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 3);
        const auto data = random_spline(random, random_recipe(random, axes, axes == 1 ? 7 : 3));
        const auto g = create(data);
        const long double c = reference::c_of(data);
        for (int i = 0; i < 4; ++i) {
            reference::Sides left{};
            std::vector<double> param;
            for (int k = 0; k < axes; ++k) {
                const auto axis = static_cast<size_t>(k);
                left[axis] = random.chance(70);
                const double knot = data.knots[axis][random.bits() % data.knots[axis].size()];
                param.push_back(std::clamp(knot, data.lower(k), data.upper(k)));
            }
            const uint32_t flags = flags_of(left, axes);
            const auto derivs = eval_derivs(g.get(), 1, param, flags);
            const auto want = reference::exact_derivatives(data, 1, param.data(), left);
            const auto sizes = reference::magnitudes(data, 1, param.data(), left);
            const double hull = reference::exact_hull(data, param.data(), left);
            ASSERT_EQ(hull_sizes(g.get(), param, flags)[0], hull) << where(seed, data) << "at " << hex(param);
            auto value = derivs.begin();
            for (size_t slot = 0; slot < want.size(); ++slot) {
                for (size_t d = 0; d < want[slot].size(); ++d) {
                    const long double bound = slot == 0 ? c * hull : 2 * (c + 2) * sizes[slot][d];
                    ASSERT_LE(reference::error_ratio(*value++, want[slot][d], bound * eps), 1)
                        << where(seed, data) << "at " << hex(param) << " flags " << flags << " slot " << slot;
                }
            }
            ASSERT_TRUE(same_bits(eval(g.get(), param, flags), {derivs.begin(), derivs.begin() + data.dim}))
                << where(seed, data);
        }
    });
}

TEST(Sides, a_jump_has_two_values) {
    // Degree 1 with a double knot inside: the line from 0 to 1, then from 5 to 7.
    const SplineData data = {{1}, {4}, {{0, 0, 1, 1, 2, 2}}, 1, {0, 1, 5, 7}, {}, 0};
    const auto g = create(data);
    EXPECT_EQ(eval(g.get(), {1}), std::vector<double>{5});
    EXPECT_EQ(eval(g.get(), {1}, NURBS_LEFT), std::vector<double>{1});
    EXPECT_EQ(eval_derivs(g.get(), 1, {1}, NURBS_LEFT), (std::vector<double>{1, 1}));
    EXPECT_EQ(eval_derivs(g.get(), 1, {1}), (std::vector<double>{5, 2}));
}

TEST(Sides, clamped_parameters_give_the_ends) {
    for_each_case(131000, 500, [](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 3);
        const auto data = random_spline(random, random_recipe(random, axes, 4));
        const auto g = create(data);
        const uint32_t flags = NURBS_ON_ALL_AXES(axes, NURBS_CLAMP);
        std::vector<double> outside;
        std::vector<double> inside;
        for (int k = 0; k < axes; ++k) {
            const bool below = random.chance(50);
            const double end = below ? data.lower(k) : data.upper(k);
            inside.push_back(end);
            const double beyond = random.chance(30) ? infinity : 1e3 * std::max(1.0, std::fabs(end));
            outside.push_back(random.chance(30) ? std::nextafter(end, below ? -infinity : infinity)
                                                : (below ? -beyond : beyond));
        }
        ASSERT_TRUE(same_bits(eval(g.get(), outside, flags), eval(g.get(), inside)))
            << where(seed, data) << hex(outside);
        ASSERT_TRUE(same_bits(eval_derivs(g.get(), 2, outside, flags), eval_derivs(g.get(), 2, inside)))
            << where(seed, data) << hex(outside);
        const auto params = random_params(random, data, 5);
        ASSERT_TRUE(same_bits(eval(g.get(), params, flags), eval(g.get(), params))) << where(seed, data);
    });
}

// Outside the domain the factors of the recurrence change sign; the bound is that of points with the sum in
// magnitudes in place of the hull, twice since errors of opposite signs no longer average.
TEST(Sides, extrapolation_continues_the_end_pieces) {
    WorstErrors worst("extrapolated points by degree, unit eps * sum in magnitudes");
    for_each_case(132000, 1000, [&](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, random.whole(1, 2), 6);
        recipe.weights = Weights::none;
        const auto data = random_spline(random, recipe);
        const auto g = create(data);
        const uint32_t flags = NURBS_ON_ALL_AXES(data.axes(), NURBS_EXTRAPOLATE);
        for (int i = 0; i < 4; ++i) {
            std::vector<double> param;
            bool outside = false; // unless the step vanishes beside a large knot
            for (int k = 0; k < data.axes(); ++k) {
                const double width = data.upper(k) - data.lower(k);
                const double step = random.magnitude(1e-3, 2) * width;
                param.push_back(random.chance(50) ? data.lower(k) - step : data.upper(k) + step);
                outside = outside || param.back() < data.lower(k) || param.back() > data.upper(k);
            }
            const auto want = reference::exact_point(data, param.data());
            const auto sizes = reference::magnitudes(data, 0, param.data());
            const auto points = eval(g.get(), param, flags);
            const long double c = reference::c_of(data);
            for (size_t d = 0; d < want.size(); ++d) {
                const long double error = reference::error_ratio(points[d], want[d], eps * sizes[0][d]);
                worst.add(data.degrees[0], error / (2 * c), error);
                ASSERT_LE(error, 2 * c + 1) << where(seed, data) << "at " << hex(param);
            }
            std::vector<double> unused(want.size());
            ASSERT_EQ(nurbs_eval(g.get(), 1, param.data(), 0, 0, unused.data(), 0, 0, 0),
                      outside ? NURBS_ERROR_OUTSIDE_DOMAIN : NURBS_OK);
        }
    });
}

TEST(Sides, extrapolation_of_small_numbers_is_exact) {
    // (t, t^2, t^3) over [0, 2] as cubic with a knot at 1; every operation is exact in binary.
    const SplineData data = {{3}, {4}, {{0, 0, 0, 0, 1, 1, 1, 1}}, 1, {0, 0, 0, 1}, {}, 0};
    const auto g = create(data);
    for (const double t : {-2.0, -0.5, 1.25, 4.0}) {
        EXPECT_EQ(eval_derivs(g.get(), 3, {t}, NURBS_EXTRAPOLATE),
                  (std::vector<double>{t * t * t, 3 * t * t, 6 * t, 6}));
    }
}

// Domains and parameters of few bits: the reduced parameter is exact, so the bits are those of the place it
// stands for.
TEST(Sides, wrapped_parameters_stand_for_their_place) {
    for_each_case(133000, 800, [](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, random.whole(1, 3), 4);
        for (AxisRecipe &axis : recipe.axes) {
            axis.spacing = Spacing::few_bits;
            axis.placement = Placement::origin;
        }
        const auto data = random_spline(random, recipe);
        const auto g = create(data);
        const uint32_t wrap = NURBS_ON_ALL_AXES(data.axes(), NURBS_WRAP);
        const uint32_t left = NURBS_ON_ALL_AXES(data.axes(), NURBS_LEFT);
        std::vector<double> inside;
        std::vector<double> outside;
        std::vector<double> starts;
        std::vector<double> ends;
        for (int k = 0; k < data.axes(); ++k) {
            const double width = data.upper(k) - data.lower(k);
            inside.push_back(data.lower(k) + std::floor(random.unit() * width * 64) / 64);
            outside.push_back(inside.back() + random.whole(-5, 5) * width);
            starts.push_back(data.lower(k));
            ends.push_back(data.upper(k) + random.whole(-3, 3) * width);
        }
        ASSERT_TRUE(same_bits(eval(g.get(), outside, wrap), eval(g.get(), inside)))
            << where(seed, data) << hex(outside) << " for " << hex(inside);
        ASSERT_TRUE(same_bits(eval_derivs(g.get(), 2, outside, wrap), eval_derivs(g.get(), 2, inside)))
            << where(seed, data) << hex(outside);
        // Start and end are one place, seen from the right, or from the left at the end.
        ASSERT_TRUE(same_bits(eval(g.get(), ends, wrap), eval(g.get(), starts)))
            << where(seed, data) << hex(ends);
        const std::vector<double> tops = [&] {
            std::vector<double> values;
            for (int k = 0; k < data.axes(); ++k) {
                values.push_back(data.upper(k));
            }
            return values;
        }();
        ASSERT_TRUE(same_bits(eval(g.get(), ends, wrap | left), eval(g.get(), tops, left)))
            << where(seed, data) << hex(ends);
    });
}

TEST(Sides, periodic_splines_close) {
    for_each_case(134000, 500, [](Random &random, uint64_t seed) {
        Recipe recipe;
        recipe.axes = {{random.whole(1, 9), KnotForm::periodic, Spacing::few_bits, Placement::origin,
                        random.whole(1, 6)}};
        recipe.weights = random.chance(50) ? Weights::none : Weights::extreme;
        const auto data = random_spline(random, recipe);
        if (std::count(data.knots[0].begin(), data.knots[0].end(), data.lower(0)) > data.degrees[0]) {
            return; // a full knot at the seam may leave a gap
        }
        const auto points = eval(create(data).get(), {data.lower(0), data.upper(0)});
        const double hull = reference::exact_hull(data, &data.knots[0][static_cast<size_t>(data.degrees[0])]);
        for (size_t d = 0; d < 3; ++d) {
            // Both ends have the same exact value; the active points of positive basis value are the same
            // ones.
            ASSERT_NEAR(points[d], points[3 + d], static_cast<double>(2 * reference::c_of(data) * eps) * hull)
                << where(seed, data);
        }
    });
}

TEST(Sides, nan_marks_what_cannot_be_evaluated) {
    for_each_case(135000, 400, [](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 3);
        const auto data = random_spline(random, random_recipe(random, axes, 4));
        const auto g = create(data);
        const uint32_t flags = NURBS_ON_ALL_AXES(axes, NURBS_NAN);
        auto params = random_params(random, data, 6);
        const auto good = eval_derivs(g.get(), 1, params);
        const size_t width = good.size() / 6;
        const auto bad_axis = static_cast<size_t>(random.whole(0, axes - 1));
        const double above = std::nextafter(data.upper(static_cast<int>(bad_axis)), infinity);
        for (const double bad : {nan_value, infinity, -infinity, above}) {
            auto mixed = params;
            mixed[2 * static_cast<size_t>(axes) + bad_axis] = bad;
            const auto values = eval_derivs(g.get(), 1, mixed, flags);
            for (size_t i = 0; i < values.size(); ++i) {
                ASSERT_TRUE(i / width == 2 ? std::isnan(values[i]) : same_bits(values[i], good[i]))
                    << where(seed, data) << "bad value " << hex(bad) << " place " << i;
            }
        }
        // Together with CLAMP only a NaN remains that cannot be evaluated.
        params[0] = nan_value;
        params[static_cast<size_t>(axes)] = infinity;
        const auto values = eval(g.get(), params, flags | NURBS_ON_ALL_AXES(axes, NURBS_CLAMP));
        ASSERT_TRUE(std::isnan(values[0])) << where(seed, data);
        ASSERT_FALSE(std::isnan(values[static_cast<size_t>(data.dim)])) << where(seed, data);
    });
}

} // namespace

} // namespace sides_test
