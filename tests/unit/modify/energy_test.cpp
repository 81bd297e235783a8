// The quadratic form of an energy: exact values of single polynomials, and laws.
#include "modify/deform/energy.h"
#include "unit/shapes.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace energy_test {

namespace {

using nrb::Entry;
using nrb::SplinePtr;

constexpr double eps = std::numeric_limits<double>::epsilon();

double energy(const SplinePtr &spline, int order) {
    const std::vector<double> x = shapes::vector_of(spline->points());
    const std::vector<double> kx = nrb::times(nrb::modify::energy_entries(*spline, order), x, spline->dim());
    return std::inner_product(x.begin(), x.end(), kx.begin(), 0.0);
}

// t^2: its second derivative is 2 everywhere.
TEST(Energy, of_a_parabola_is_exact) {
    EXPECT_EQ(energy(shapes::bezier(1, {0, 0, 1}), 2), 4);
}

// t^3: the integral of 9 t^4 is 9/5, that of 36 t^2 is 12.
TEST(Energy, of_a_cubic) {
    const SplinePtr cubic = shapes::bezier(1, {0, 0, 0, 1});
    EXPECT_NEAR(energy(cubic, 1), 1.8, 8 * eps * 1.8);
    EXPECT_NEAR(energy(cubic, 2), 12, 8 * eps * 12);
    EXPECT_NEAR(energy(cubic, 3), 36, 8 * eps * 36);
}

// u^2 + v^3 in one coordinate over two axes: the sum of both energies.
TEST(Energy, of_a_surface_is_the_sum_over_its_axes) {
    std::vector<double> points;
    for (const double u : {0, 0, 1}) {
        for (const double v : {0, 0, 0, 1}) {
            points.push_back(u + v);
        }
    }
    const SplinePtr surface = nrb::make_spline({shapes::bezier_axis(2), shapes::bezier_axis(3)}, 1,
                                               nrb::Form::polynomial, std::move(points));
    EXPECT_NEAR(energy(surface, 2), 4 + 12, 64 * eps * 16);
    EXPECT_NEAR(energy(surface, 3), 36, 64 * eps * 36); // the first axis has degree 2
}

TEST(Energy, of_a_degree_below_the_order_is_none) {
    EXPECT_TRUE(nrb::modify::energy_entries(*shapes::bezier(1, {1, 5}), 2).empty() ||
                energy(shapes::bezier(1, {1, 5}), 2) == 0);
}

std::map<std::pair<int64_t, int64_t>, double> matrix_of(const nrb::Spline &spline, int order) {
    std::map<std::pair<int64_t, int64_t>, double> matrix;
    for (const Entry &entry : nrb::modify::energy_entries(spline, order)) {
        matrix[{entry.row, entry.column}] += entry.value;
    }
    return matrix;
}

// Symmetric, and no energy in a constant: over knots in all three forms, with multiplicities to degree + 1.
TEST(Energy, is_symmetric_and_constants_have_none) {
    const SplinePtr splines[] = {
        shapes::curve(3, {0, 0, 0, 0, 1, 2, 2, 3, 3, 3, 3}, 1, std::vector<double>(7, 1)),
        shapes::curve(2, {0, 1, 2, 4, 4, 4, 5, 6, 7}, 1, std::vector<double>(6, 1)),
        shapes::curve(2, {-2, -1, 0, 1, 2, 3, 4, 5}, 1, std::vector<double>(5, 1), true)};
    for (const SplinePtr &spline : splines) {
        const auto matrix = matrix_of(*spline, 1);
        const int64_t unknowns = spline->axis(0).distinct_layers();
        std::vector<double> sums(static_cast<size_t>(unknowns)), sizes(sums);
        for (const auto &[at, value] : matrix) {
            ASSERT_LT(at.first, unknowns); // the first copies alone
            ASSERT_LT(at.second, unknowns);
            // Terms of the spans, none above the root of the product of both diagonal elements, in another
            // order.
            const double size =
                std::sqrt(matrix.at({at.first, at.first}) * matrix.at({at.second, at.second}));
            EXPECT_NEAR(value, matrix.at({at.second, at.first}), 4 * eps * size);
            sums[static_cast<size_t>(at.first)] += value;
            sizes[static_cast<size_t>(at.first)] += std::abs(value);
        }
        for (size_t i = 0; i < sums.size(); ++i) {
            EXPECT_LE(std::abs(sums[i]), 16 * eps * sizes[i]);
        }
    }
}

} // namespace

} // namespace energy_test
