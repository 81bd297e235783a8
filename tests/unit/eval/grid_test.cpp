// Grids that need few layers of a large net, and weights of any magnitude.
#include "eval/evaluate.h"
#include "eval/kernels/slots.h"

#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace grid_test {

namespace {

using nrb::Form;
using nrb::SplinePtr;
using nrb::eval::AxisRules;

nrb::KnotVectorPtr clamped_axis(int degree, int64_t count) {
    std::vector<double> knots(static_cast<size_t>(degree) + 1, 0.0);
    for (int64_t i = 1; i < count - degree; ++i) {
        knots.push_back(static_cast<double>(i));
    }
    knots.insert(knots.end(), static_cast<size_t>(degree) + 1, static_cast<double>(count - degree));
    return nrb::make_knot_vector(degree, std::move(knots));
}

SplinePtr random_net(const std::vector<int64_t> &counts, int degree, double weight_scale) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> uniform(0.5, 2);
    nrb::Spline::Axes axes;
    size_t size = 1;
    for (const int64_t count : counts) {
        axes.push_back(clamped_axis(degree, count));
        size *= static_cast<size_t>(count);
    }
    std::vector<double> points(size * 2);
    std::vector<double> weights(size);
    for (size_t i = 0; i < size; ++i) {
        points[2 * i] = uniform(random);
        points[2 * i + 1] = uniform(random);
        weights[i] = uniform(random) * weight_scale;
    }
    return nrb::make_spline(std::move(axes), 2, Form::rational, std::move(points), std::move(weights));
}

std::vector<double> on_grid(const nrb::Spline &spline, const std::vector<std::vector<double>> &params,
                            int order) {
    std::array<nrb::ConstRecords, nrb::max_axes> views;
    int64_t count = 1;
    for (size_t k = 0; k < params.size(); ++k) {
        views[k] = {params[k].data(), std::ssize(params[k]), 1, 1, 1};
        count *= std::ssize(params[k]);
    }
    const int64_t width = nrb::eval::slot_count(spline.axes(), order) * spline.dim();
    std::vector<double> result(static_cast<size_t>(count * width));
    AxisRules rules;
    rules.fill({false, true, nrb::eval::Outside::refuse});
    nrb::eval::evaluate_grid(spline, rules, order, views, {result.data(), count, width, width, 1});
    return result;
}

std::vector<double> one_by_one(const nrb::Spline &spline, const std::vector<std::vector<double>> &params,
                               int order) {
    std::vector<double> tuples;
    int64_t count = 1;
    for (const std::vector<double> &axis : params) {
        count *= std::ssize(axis);
    }
    for (int64_t i = 0; i < count; ++i) {
        int64_t rest = count;
        int64_t index = i;
        for (const std::vector<double> &axis : params) {
            rest /= std::ssize(axis);
            tuples.push_back(axis[static_cast<size_t>(index / rest)]);
            index %= rest;
        }
    }
    const int64_t width = nrb::eval::slot_count(spline.axes(), order) * spline.dim();
    std::vector<double> result(static_cast<size_t>(count * width));
    AxisRules rules;
    rules.fill({false, true, nrb::eval::Outside::refuse});
    nrb::eval::evaluate_points(spline, rules, order, {tuples.data(), count, spline.axes(), spline.axes(), 1},
                               {result.data(), count, width, width, 1});
    return result;
}

void expect_same_bits(const std::vector<double> &a, const std::vector<double> &b) {
    ASSERT_EQ(a.size(), b.size());
    EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(double)), 0);
}

TEST(Grid, leaves_out_layers_without_changing_a_bit) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const SplinePtr surface = random_net({5, 3000}, 3, 1);
    const std::vector<std::vector<double>> scattered{{1.5, 0, 2, nan},
                                                     {2997, 17.25, 17.5, 0, 17.25, nan, 1500, 20.5}};
    const SplinePtr volume = random_net({12, 15, 18}, 2, 1);
    const std::vector<std::vector<double>> block{{3.25, 10}, {12.5, 0.5, 13}, {7.75, 0, nan, 16, 7.5}};
    for (const int order : {0, 2}) {
        expect_same_bits(on_grid(*surface, scattered, order), one_by_one(*surface, scattered, order));
        expect_same_bits(on_grid(*volume, block, order), one_by_one(*volume, block, order));
    }
}

// A power of two that all weights share changes nothing at all.
TEST(Weights, may_have_any_common_scale) {
    const std::vector<std::vector<double>> params{{0.3, 1.25, 2}, {0, 0.5, 1.75}};
    const SplinePtr plain = random_net({5, 5}, 3, 1);
    for (const int exponent : {-1000, -600, -257, -3, 255, 400, 1020}) {
        const SplinePtr scaled = random_net({5, 5}, 3, std::ldexp(1.0, exponent));
        expect_same_bits(one_by_one(*scaled, params, 2), one_by_one(*plain, params, 2));
    }
}

TEST(Weights, may_all_be_the_smallest_number) {
    const double tiny = std::numeric_limits<double>::denorm_min();
    const auto axis = clamped_axis(2, 3);
    const SplinePtr curve = nrb::make_spline({axis}, 1, Form::rational, {1, 2, 4}, {tiny, tiny, tiny});
    EXPECT_EQ(one_by_one(*curve, {{0.5}}, 0), (std::vector<double>{2.25}));
}

} // namespace

} // namespace grid_test
