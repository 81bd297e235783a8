// The accuracy contract for points: |error| <= c * eps * hull per coordinate, c the sum of c(p) over the
// axes.
#include "reference/magnitudes.h"
#include "support/cases.h"
#include "support/handle.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace points_test {

using namespace support;
using reference::eps;

namespace {

int highest_degree(const SplineData &data) {
    return *std::max_element(data.degrees.begin(), data.degrees.end());
}

// Compares n points, and the hull that the contract is about, with the exact values.
void check_points(Random &random, uint64_t seed, const Recipe &recipe, int n, WorstErrors &worst) {
    const auto data = random_spline(random, recipe);
    const auto g = create(data);
    const auto params = random_params(random, data, n);
    const auto points = eval(g.get(), params);
    const auto hulls = hull_sizes(g.get(), params);
    const long double c = reference::c_of(data);
    const auto dim = static_cast<size_t>(data.dim);
    for (size_t i = 0; i < hulls.size(); ++i) {
        const double *param = params.data() + i * data.degrees.size();
        const double hull = reference::exact_hull(data, param);
        const long double bound = c * reference::weight_factor(data, param);
        const auto want = reference::exact_point(data, param);
        ASSERT_EQ(hulls[i], hull) << where(seed, data) << "at " << hex({param, param + data.axes()});
        for (size_t d = 0; d < dim; ++d) {
            const long double error = reference::error_ratio(points[i * dim + d], want[d], eps * hull);
            worst.add(highest_degree(data), error / bound, error);
            ASSERT_LE(error, bound) << where(seed, data) << "coordinate " << d << " at "
                                    << hex({param, param + data.axes()}) << " is " << hex(points[i * dim + d])
                                    << " in place of " << hex(reference::nearest(want[d]));
        }
    }
}

void check_curves(const char *title, uint64_t base, bool rational, int low, int high, int cases) {
    WorstErrors worst(title);
    for (int degree = low; degree <= high; ++degree) {
        const auto seeds = base + 10000 * static_cast<uint64_t>(degree);
        for_each_case(seeds, cases, [&](Random &random, uint64_t seed) {
            Recipe recipe = random_recipe(random, 1, degree);
            recipe.axes[0].degree = degree;
            if ((recipe.weights != Weights::none) != rational) {
                recipe.weights = rational ? Weights::extreme : Weights::none;
            }
            check_points(random, seed, recipe, 10, worst);
        });
    }
}

TEST(Points, polynomial_curves) {
    check_curves("polynomial curves, unit eps * hull", 1000000, false, 0, 15, 300);
}

TEST(Points, rational_curves) {
    check_curves("rational curves, unit eps * hull", 2000000, true, 0, 15, 300);
}

TEST(Points, curves_of_high_degree) {
    check_curves("polynomial curves of high degree, unit eps * hull", 3000000, false, 16, 31, 12);
    check_curves("rational curves of high degree, unit eps * hull", 4000000, true, 16, 31, 12);
}

TEST(Points, surfaces) {
    WorstErrors worst("surfaces by higher degree, unit eps * hull");
    for_each_case(5000000, 2000, [&](Random &random, uint64_t seed) {
        check_points(random, seed, random_recipe(random, 2, random.chance(10) ? 12 : 6), 6, worst);
    });
}

TEST(Points, volumes) {
    WorstErrors worst("volumes by highest degree, unit eps * hull");
    for_each_case(6000000, 800, [&](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, 3, random.chance(10) ? 5 : 3);
        for (AxisRecipe &axis : recipe.axes) {
            axis.spans = std::min(axis.spans, 3);
        }
        check_points(random, seed, recipe, 4, worst);
    });
}

} // namespace

} // namespace points_test
