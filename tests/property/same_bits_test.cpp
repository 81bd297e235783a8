// One parameter gives the same bits alone, in a batch of any layout and order, on a grid and from any thread.
#include "support/cases.h"
#include "support/handle.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>
#include <thread>

namespace same_bits_test {

using namespace support;

namespace {

Recipe batch_recipe(int axes, Weights weights) {
    Recipe recipe;
    for (int k = 0; k < axes; ++k) {
        recipe.axes.push_back(
            {3, k == 0 ? KnotForm::clamped : KnotForm::periodic, Spacing::ratio, Placement::origin, 12});
    }
    recipe.weights = weights;
    return recipe;
}

// A million points in one call, in that order and shuffled, and each by a call of its own.
void check_million(int axes, Weights weights, uint64_t seed) {
    Random random(seed);
    const auto data = random_spline(random, batch_recipe(axes, weights));
    const auto g = create(data);
    const size_t n = 1000000;
    const auto params = random_params(random, data, static_cast<int>(n));
    const auto points = eval(g.get(), params);
    const auto width = static_cast<size_t>(axes);
    const auto dim = static_cast<size_t>(data.dim);
    double alone[6];
    for (size_t i = 0; i < n; ++i) {
        require_ok(nurbs_eval(g.get(), 1, params.data() + i * width, 0, 0, alone, 0, 0, 0));
        for (size_t c = 0; c < dim; ++c) {
            ASSERT_TRUE(same_bits(alone[c], points[i * dim + c])) << where(seed, data) << "parameter " << i;
        }
    }
    // i -> i * step mod n visits every point once in a scattered order, since step is prime to n.
    std::vector<double> scattered(params.size());
    const size_t step = 618033;
    for (size_t i = 0; i < n; ++i) {
        std::copy_n(params.begin() + static_cast<std::ptrdiff_t>(i * step % n * width), width,
                    scattered.begin() + static_cast<std::ptrdiff_t>(i * width));
    }
    const auto again = eval(g.get(), scattered);
    for (size_t i = 0; i < n * dim; ++i) {
        ASSERT_TRUE(same_bits(again[i], points[i / dim * step % n * dim + i % dim])) << where(seed, data);
    }
}

TEST(SameBits, a_million_points_of_a_curve) {
    check_million(1, Weights::moderate, 80000);
}

TEST(SameBits, a_million_points_of_a_surface) {
    check_million(2, Weights::none, 80001);
}

// Points and derivatives of one case in a reference layout, to compare every other way with.
struct Batch {
    SplineData data;
    Handle g;
    int order;
    size_t n;
    size_t width; // of a derivative record
    std::vector<double> params;
    std::vector<double> points;
    std::vector<double> derivs;
};

Batch make_batch(Random &random, int n) {
    Batch batch;
    batch.data = random_spline(random, random_recipe(random, random.whole(1, 3), 6));
    if (random.chance(30)) { // derivatives come from a copy at the origin
        for (double &x : batch.data.points) {
            x += 1e6;
        }
    }
    batch.g = create(batch.data);
    batch.order = random.whole(0, 3);
    batch.n = static_cast<size_t>(n);
    batch.params = random_params(random, batch.data, n);
    batch.points = eval(batch.g.get(), batch.params);
    batch.derivs = eval_derivs(batch.g.get(), batch.order, batch.params);
    batch.width = batch.derivs.size() / batch.n;
    return batch;
}

std::vector<double> part(const std::vector<double> &values, size_t record, size_t width) {
    const auto from = values.begin() + static_cast<std::ptrdiff_t>(record * width);
    return {from, from + static_cast<std::ptrdiff_t>(width)};
}

TEST(SameBits, alone_and_in_batches) {
    for_each_case(81000, 600, [](Random &random, uint64_t seed) {
        const Batch batch = make_batch(random, random.whole(1, 70));
        const auto axes = batch.data.degrees.size();
        const auto dim = static_cast<size_t>(batch.data.dim);
        for (size_t i = 0; i < batch.n; ++i) {
            const auto param = part(batch.params, i, axes);
            ASSERT_TRUE(same_bits(eval(batch.g.get(), param), part(batch.points, i, dim)))
                << where(seed, batch.data) << "at " << hex(param);
            ASSERT_TRUE(
                same_bits(eval_derivs(batch.g.get(), batch.order, param), part(batch.derivs, i, batch.width)))
                << where(seed, batch.data) << "at " << hex(param);
        }
        // A second handle on equal data has tables of its own.
        ASSERT_TRUE(same_bits(eval(create(batch.data).get(), batch.params), batch.points))
            << where(seed, batch.data);
    });
}

// Sizes between those of which differences of records surely do not overflow, and those of which they may.
TEST(SameBits, of_weights_that_bring_points_near_overflow) {
    for_each_case(81500, 20, [](Random &random, uint64_t seed) {
        SplineData data;
        data.degrees = {3};
        data.counts = {40};
        data.dim = 2;
        data.knots = {{0, 0, 0, 0}};
        for (int i = 1; i < 37; ++i) {
            data.knots[0].push_back(i);
        }
        data.knots[0].insert(data.knots[0].end(), 4, 37.0);
        const int size = random.whole(900, 960), weight = random.whole(-40, 60);
        for (int i = 0; i < 40; ++i) {
            data.points.insert(data.points.end(),
                               {std::ldexp(random.between(1, 2), size), std::ldexp(1.0, size)});
            data.weights.push_back(std::ldexp(random.between(1, 2), weight));
        }
        const Handle g = create(data);
        std::vector<double> params;
        for (int i = 0; i < 400; ++i) {
            params.push_back(random.between(0, 37));
        }
        const std::vector<double> first = eval_derivs(g.get(), 2, {params[0]});
        const std::vector<double> all = eval_derivs(g.get(), 2, params);
        ASSERT_TRUE(same_bits(first, part(all, 0, first.size()))) << where(seed, data);
        ASSERT_TRUE(same_bits(first, eval_derivs(g.get(), 2, {params[0]}))) << where(seed, data);
    });
}

// Order 0 of the derivatives is the point, whatever the order asked for.
TEST(SameBits, slot_zero_is_the_point_and_low_orders_do_not_change) {
    for_each_case(82000, 600, [](Random &random, uint64_t seed) {
        const Batch batch = make_batch(random, 20);
        const auto dim = static_cast<size_t>(batch.data.dim);
        const auto more = eval_derivs(batch.g.get(), batch.order + 2, batch.params);
        const size_t wide = more.size() / batch.n;
        for (size_t i = 0; i < batch.n; ++i) {
            auto head = part(more, i, wide);
            head.resize(batch.width);
            ASSERT_TRUE(same_bits(head, part(batch.derivs, i, batch.width)))
                << where(seed, batch.data) << "order " << batch.order;
            head.resize(dim);
            ASSERT_TRUE(same_bits(head, part(batch.points, i, dim))) << where(seed, batch.data);
        }
    });
}

// Parameters in separate columns or in wide records, results the same, everything one double off any
// alignment.
TEST(SameBits, strides_and_alignment) {
    for_each_case(83000, 600, [](Random &random, uint64_t seed) {
        const Batch batch = make_batch(random, random.whole(1, 40));
        const auto axes = static_cast<int64_t>(batch.data.degrees.size());
        const auto n = static_cast<int64_t>(batch.n);
        const auto width = static_cast<int64_t>(batch.width);
        const bool columns = random.chance(50);
        const int64_t from_stride = columns ? 1 : axes + 2;
        const int64_t from_component = columns ? n + 3 : 1;
        std::vector<double> params(static_cast<size_t>(1 + n * (axes + 2) + 3 * axes));
        for (int64_t i = 0; i < n * axes; ++i) {
            params[static_cast<size_t>(1 + i / axes * from_stride + i % axes * from_component)] =
                batch.params[static_cast<size_t>(i)];
        }
        const bool planes = random.chance(50);
        const int64_t to_stride = planes ? 1 : 2 * width + 1;
        const int64_t to_component = planes ? n + 1 : 2;
        const double untouched = -12345.5;
        std::vector<double> out(static_cast<size_t>(2 + n * (2 * width + 1) + width), untouched);
        require_ok(nurbs_eval_derivs(batch.g.get(), batch.order, n, params.data() + 1, from_stride,
                                     from_component, out.data() + 1, to_stride, to_component, 0));
        for (int64_t i = 0; i < n * width; ++i) {
            double &value = out[static_cast<size_t>(1 + i / width * to_stride + i % width * to_component)];
            ASSERT_TRUE(same_bits(value, batch.derivs[static_cast<size_t>(i)])) << where(seed, batch.data);
            value = untouched;
        }
        ASSERT_TRUE(std::all_of(out.begin(), out.end(), [&](double x) { return x == untouched; }))
            << where(seed, batch.data) << "something was written between the records";
    });
}

// Parameters that give NaN take nothing from those around them, whichever vectors they share.
TEST(SameBits, among_parameters_that_give_nan) {
    for_each_case(86000, 600, [](Random &random, uint64_t seed) {
        const Batch batch = make_batch(random, random.whole(1, 70));
        const auto axes = static_cast<int64_t>(batch.data.degrees.size());
        const auto n = static_cast<int64_t>(batch.n);
        const auto width = static_cast<int64_t>(batch.width);
        const auto dim = static_cast<int64_t>(batch.data.dim);
        std::vector<double> params = batch.params;
        std::vector<bool> empty(batch.n);
        for (size_t i = 0; i < batch.n; ++i) {
            empty[i] = random.chance(25);
            params[i * static_cast<size_t>(axes)] =
                empty[i] ? NAN : batch.params[i * static_cast<size_t>(axes)];
        }
        const uint32_t flags = NURBS_ON_ALL_AXES(static_cast<uint32_t>(axes), NURBS_NAN);
        std::vector<double> planes(batch.derivs.size());
        require_ok(nurbs_eval_derivs(batch.g.get(), batch.order, n, params.data(), 0, 0, planes.data(), 1, n,
                                     flags));
        std::vector<double> packed(batch.derivs.size());
        require_ok(nurbs_eval_derivs(batch.g.get(), batch.order, n, params.data(), 0, 0, packed.data(), 0, 0,
                                     flags));
        std::vector<float> single(batch.points.size());
        require_ok(nurbs_eval_f32(batch.g.get(), n, params.data(), 0, 0, single.data(), 0, 0, flags));
        for (int64_t i = 0; i < n; ++i) {
            for (int64_t c = 0; c < width; ++c) {
                const double expected =
                    empty[static_cast<size_t>(i)] ? NAN : batch.derivs[static_cast<size_t>(i * width + c)];
                const double plane = planes[static_cast<size_t>(c * n + i)];
                const double record = packed[static_cast<size_t>(i * width + c)];
                ASSERT_TRUE(std::isnan(expected) ? std::isnan(plane) : same_bits(plane, expected))
                    << where(seed, batch.data) << "parameter " << i << " of " << n;
                ASSERT_TRUE(std::isnan(expected) ? std::isnan(record) : same_bits(record, expected))
                    << where(seed, batch.data) << "parameter " << i << " of " << n;
                if (c < dim) {
                    const float rounded = single[static_cast<size_t>(i * dim + c)];
                    ASSERT_TRUE(std::isnan(expected) ? std::isnan(rounded)
                                                     : rounded == static_cast<float>(expected))
                        << where(seed, batch.data) << "parameter " << i << " of " << n;
                }
            }
        }
    });
}

// Too few rows or columns for the grid's own way.
TEST(SameBits, on_a_narrow_grid) {
    for_each_case(84500, 40, [](Random &random, uint64_t seed) {
        const Batch batch = make_batch(random, 1);
        const size_t axes = batch.data.degrees.size();
        const auto longest = static_cast<size_t>(random.whole(0, static_cast<int>(axes) - 1));
        std::vector<std::vector<double>> grid(axes);
        std::vector<double> params;
        for (size_t k = 0; k < axes; ++k) {
            for (int i = k == longest ? 300 : 1; i > 0; --i) {
                grid[k].push_back(random_param(random, batch.data.knots[k], batch.data.degrees[k]));
            }
        }
        for (size_t i = 0; i < 300; ++i) {
            for (size_t k = 0; k < axes; ++k) {
                params.push_back(grid[k][k == longest ? i : 0]);
            }
        }
        ASSERT_TRUE(same_bits(eval_grid(batch.g.get(), grid), eval(batch.g.get(), params)))
            << where(seed, batch.data);
    });
}

TEST(SameBits, on_a_grid) {
    for_each_case(84000, 600, [](Random &random, uint64_t seed) {
        const Batch batch = make_batch(random, 1);
        const size_t axes = batch.data.degrees.size();
        std::vector<std::vector<double>> grid(axes);
        std::vector<double> params;
        size_t size = 1;
        for (size_t k = 0; k < axes; ++k) {
            for (int i = random.whole(1, axes == 3 ? 5 : 11); i > 0; --i) {
                grid[k].push_back(random_param(random, batch.data.knots[k], batch.data.degrees[k]));
            }
            size *= grid[k].size();
        }
        for (size_t i = 0; i < size; ++i) {
            size_t rest = i;
            std::vector<double> param(axes);
            for (size_t k = axes; k-- > 0;) {
                param[k] = grid[k][rest % grid[k].size()];
                rest /= grid[k].size();
            }
            params.insert(params.end(), param.begin(), param.end());
        }
        ASSERT_TRUE(same_bits(eval_grid(batch.g.get(), grid), eval(batch.g.get(), params)))
            << where(seed, batch.data);
        ASSERT_TRUE(same_bits(eval_grid_derivs(batch.g.get(), batch.order, grid),
                              eval_derivs(batch.g.get(), batch.order, params)))
            << where(seed, batch.data);
    });
}

// Four threads meet on a handle whose tables nobody has built yet.
TEST(SameBits, from_several_threads) {
    for_each_case(85000, 60, [](Random &random, uint64_t seed) {
        const Batch batch = make_batch(random, 300);
        const auto fresh = create(batch.data);
        std::atomic<int> different = 0;
        std::vector<std::thread> threads;
        for (int i = 0; i < 4; ++i) {
            threads.emplace_back([&, i] {
                const bool points_first = i % 2 == 0;
                for (const bool points : {points_first, !points_first}) {
                    const bool same =
                        points ? same_bits(eval(fresh.get(), batch.params), batch.points)
                               : same_bits(eval_derivs(fresh.get(), batch.order, batch.params), batch.derivs);
                    different += same ? 0 : 1;
                }
            });
        }
        for (auto &thread : threads) {
            thread.join();
        }
        ASSERT_EQ(different, 0) << where(seed, batch.data);
    });
}

} // namespace

} // namespace same_bits_test
