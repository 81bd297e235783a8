#include "basis/bspline.h"
#include "eval/evaluate.h"
#include "refine/knots/axis_table.h"
#include "refine/knots/insert.h"
#include "refine/parts/cut.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numeric>
#include <random>

namespace insert_test {

namespace {

using nrb::Form;
using nrb::LayerTable;
using nrb::make_knot_vector;
using nrb::make_spline;
using nrb::SplinePtr;

constexpr double eps = std::numeric_limits<double>::epsilon();

std::vector<double> points_of(const nrb::Spline &spline, const std::vector<double> &params) {
    const auto n = static_cast<int64_t>(params.size()) / spline.axes();
    std::vector<double> result(static_cast<size_t>(n * spline.dim()));
    nrb::eval::evaluate_points(spline, nrb::eval::AxisRules{}, 0,
                               {params.data(), n, spline.axes(), spline.axes(), 1},
                               {result.data(), n, spline.dim(), spline.dim(), 1});
    return result;
}

SplinePtr random_curve(std::mt19937_64 &random, int degree, std::vector<double> knots) {
    std::uniform_real_distribution<double> uniform(-1, 1);
    const auto axis = make_knot_vector(degree, std::move(knots));
    std::vector<double> points(static_cast<size_t>(axis->count()) * 2);
    std::generate(points.begin(), points.end(), [&] { return uniform(random); });
    return make_spline({axis}, 2, Form::polynomial, std::move(points));
}

// Every knot of the list any number of times, up to multiplicity degree + 1.
TEST(Refinement, rows_are_convex_combinations) {
    std::mt19937_64 random(12);
    const std::vector<double> knots{0, 0.1, 0.2, 0.2, 0.5, 0.500001, 0.7, 1, 1, 1};
    const std::vector<double> places{0.2, 0.3, 0.3 + 1e-12, 0.5, 0.5000005, 0.500001, 0.6, 0.7};
    for (int trial = 0; trial < 200; ++trial) {
        std::vector<double> fine = knots;
        for (const double knot : places) {
            const auto room = static_cast<uint64_t>(4 - nrb::multiplicity(knots, knot));
            fine.insert(fine.end(), random() % (room + 1), knot);
        }
        std::sort(fine.begin(), fine.end());
        const nrb::refine::Refinement refinement(3, knots, fine);
        ASSERT_EQ(refinement.rows(), static_cast<int64_t>(fine.size()) - 4);
        const LayerTable table = nrb::refine::rows_of(refinement, 0, refinement.rows());
        for (const LayerTable::Row &row : table.all()) {
            const double copy = 1;
            const double *c = row.size == 0 ? &copy : table.coefficients(row);
            const int size = std::max(row.size, 1);
            ASSERT_TRUE(row.first >= 0 && row.first + size <= 6);
            EXPECT_TRUE(std::all_of(c, c + size, [](double x) { return x >= 0 && x <= 1; }));
            EXPECT_NEAR(std::accumulate(c, c + size, 0.0), 1, 4 * eps);
        }
    }
}

TEST(RestrictAxis, keeps_the_shape_and_clamps_the_new_ends) {
    std::mt19937_64 random(11);
    for (const auto &[lower, upper] :
         {std::pair{0.25, 0.75}, {0.0, 0.6}, {0.3, 1.0}, {0.5, 0.55}, {0.3, 0.5}}) {
        const SplinePtr curve =
            random_curve(random, 3, {-0.3, -0.2, -0.1, 0, 0.3, 0.3, 0.5, 0.5, 0.5, 0.5, 0.9, 1, 1.5, 1.5, 2});
        const SplinePtr part = nrb::refine::restrict_axis(curve, 0, lower, upper);
        EXPECT_EQ(part->axis(0).domain().lower, lower);
        EXPECT_EQ(part->axis(0).domain().upper, upper);
        EXPECT_EQ(part->axis(0).clamped_start(), lower != 0.0);
        EXPECT_EQ(part->axis(0).clamped_end(), upper != 1.0);
        std::vector<double> params(200);
        for (size_t i = 0; i < params.size(); ++i) {
            params[i] = std::lerp(lower, upper, static_cast<double>(i) / static_cast<double>(params.size()));
        }
        const std::vector<double> whole = points_of(*curve, params);
        const std::vector<double> cut = points_of(*part, params);
        for (size_t i = 0; i < whole.size(); ++i) {
            ASSERT_LE(std::abs(whole[i] - cut[i]), 12 * eps) << lower << " " << upper << " " << i;
        }
    }
}

TEST(RestrictAxis, opens_a_periodic_axis) {
    std::vector<double> points;
    for (int i = 0; i < 7; ++i) {
        points.push_back(std::cos(i % 4 * 1.5707963267948966));
    }
    const auto axis = make_knot_vector(3, {-3, -2, -1, 0, 1, 2, 3, 4, 5, 6, 7}, true);
    const SplinePtr closed = make_spline({axis}, 1, Form::polynomial, points);
    const SplinePtr part = nrb::refine::restrict_axis(closed, 0, 0.5, 4);
    EXPECT_FALSE(part->axis(0).periodic());
    EXPECT_NEAR(points_of(*part, {1.25})[0], points_of(*closed, {1.25})[0], 4 * eps);
}

TEST(InsertKnot, leaves_points_out_of_reach_bit_for_bit) {
    std::mt19937_64 random(3);
    const SplinePtr curve = random_curve(random, 2, {0, 0, 0, 1, 2, 3, 4, 5, 5, 5});
    const SplinePtr refined = nrb::refine::insert_knot(curve, 0, 2.5, 1);
    EXPECT_TRUE(std::equal(curve->points().begin(), curve->points().begin() + 6, refined->points().begin()));
    EXPECT_TRUE(std::equal(curve->points().end() - 6, curve->points().end(), refined->points().end() - 6));
}

} // namespace

} // namespace insert_test
