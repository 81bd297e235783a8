// The accuracy contract for derivatives: |error| <= 2 (c + 2 k) eps H_a, with E_a for H_a when rational.
#include "reference/magnitudes.h"
#include "support/cases.h"
#include "support/handle.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

namespace derivatives_test {

using namespace support;
using reference::eps;

namespace {

void check_derivatives(Random &random, uint64_t seed, const SplineData &data, int order, int n,
                       WorstErrors &worst) {
    const auto g = create(data);
    const auto params = away_from_underflow(random_params(random, data, n));
    const auto derivs = eval_derivs(g.get(), order, params);
    const auto indices = graded_indices(data.axes(), order);
    const long double c = reference::c_of(data);
    auto value = derivs.begin();
    for (size_t i = 0; i < static_cast<size_t>(n); ++i) {
        const double *param = params.data() + i * data.degrees.size();
        const auto want = reference::exact_derivatives(data, order, param);
        const auto sizes = reference::magnitudes(data, order, param);
        const double hull = reference::exact_hull(data, param);
        for (size_t slot = 0; slot < indices.size(); ++slot) {
            const int k = std::accumulate(indices[slot].begin(), indices[slot].end(), 0);
            for (size_t d = 0; d < want[slot].size(); ++d, ++value) {
                // Slot 0 is the point and keeps the promise of points.
                const long double factor =
                    k == 0 ? c * reference::weight_factor(data, param) : 2 * (c + 2 * k);
                const long double unit = k == 0 ? eps * hull : eps * sizes[slot][d];
                const long double error = reference::error_ratio(*value, want[slot][d], unit);
                worst.add(k, error / factor, error);
                ASSERT_LE(error, factor)
                    << where(seed, data) << "slot " << slot << " coordinate " << d << " at "
                    << hex({param, param + data.axes()}) << " is " << hex(*value) << " in place of "
                    << hex(reference::nearest(want[slot][d])) << ", magnitude "
                    << static_cast<double>(sizes[slot][d]);
            }
        }
    }
}

void check_derivatives(Random &random, uint64_t seed, const Recipe &recipe, int order, int n,
                       WorstErrors &worst) {
    check_derivatives(random, seed, random_spline(random, recipe), order, n, worst);
}

void check_curves(const char *title, uint64_t base, bool rational, int cases) {
    WorstErrors worst(title);
    for (int degree = 0; degree <= 15; ++degree) {
        for_each_case(base + 10000 * static_cast<uint64_t>(degree), cases,
                      [&](Random &random, uint64_t seed) {
                          Recipe recipe = random_recipe(random, 1, degree);
                          recipe.axes[0].degree = degree;
                          if ((recipe.weights != Weights::none) != rational) {
                              recipe.weights = rational ? Weights::extreme : Weights::none;
                          }
                          check_derivatives(random, seed, recipe, 3, 6, worst);
                      });
    }
}

TEST(Derivatives, polynomial_curves) {
    check_curves("polynomial curves by order, unit eps * H", 11000000, false, 150);
}

TEST(Derivatives, rational_curves) {
    check_curves("rational curves by order, unit eps * E", 12000000, true, 150);
}

TEST(Derivatives, surfaces) {
    WorstErrors worst("surfaces by order, unit eps * E");
    for_each_case(13000000, 1200, [&](Random &random, uint64_t seed) {
        check_derivatives(random, seed, random_recipe(random, 2, random.chance(10) ? 9 : 5), 3, 3, worst);
    });
}

TEST(Derivatives, volumes) {
    WorstErrors worst("volumes by order, unit eps * E");
    for_each_case(14000000, 500, [&](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, 3, 3);
        for (AxisRecipe &axis : recipe.axes) {
            axis.spans = std::min(axis.spans, 3);
        }
        check_derivatives(random, seed, recipe, random.whole(1, 3), 2, worst);
    });
}

// To up to 1e15 times the size of the shape, where few bits of it are left: the exact derivatives are those
// of what is stored, whose errors are measured by its own differences. Periodic copies stay equal.
SplineData moved(Random &random, SplineData data) {
    const double distance = random.magnitude(1, 1e15) * extent(data);
    std::vector<double> shift;
    for (int c = 0; c < data.dim; ++c) {
        shift.push_back(random.chance(20) ? 0 : random.between(-1, 1) * distance);
    }
    for (size_t i = 0; i < data.points.size(); ++i) {
        data.points[i] += shift[i % shift.size()];
    }
    return data;
}

void check_moved(Random &random, uint64_t seed, Recipe recipe, int order, int n, WorstErrors &worst) {
    for (AxisRecipe &axis : recipe.axes) {
        axis.spans = std::min(axis.spans, 3);
    }
    check_derivatives(random, seed, moved(random, random_spline(random, recipe)), order, n, worst);
}

TEST(Derivatives, of_moved_curves) {
    WorstErrors worst("moved curves by order, unit eps * E");
    for (int degree = 0; degree <= 31; ++degree) {
        for_each_case(16000000 + 10000 * static_cast<uint64_t>(degree), degree > 15 ? 12 : 60,
                      [&](Random &random, uint64_t seed) {
                          Recipe recipe = random_recipe(random, 1, degree);
                          recipe.axes[0].degree = degree;
                          check_moved(random, seed, recipe, 3, 3, worst);
                      });
    }
}

TEST(Derivatives, of_moved_surfaces) {
    WorstErrors worst("moved surfaces by order, unit eps * E");
    for_each_case(17000000, 600, [&](Random &random, uint64_t seed) {
        check_moved(random, seed, random_recipe(random, 2, random.chance(10) ? 11 : 5), 2, 2, worst);
    });
}

TEST(Derivatives, of_moved_volumes) {
    WorstErrors worst("moved volumes by order, unit eps * E");
    for_each_case(18000000, 200, [&](Random &random, uint64_t seed) {
        check_moved(random, seed, random_recipe(random, 3, 3), random.whole(1, 2), 2, worst);
    });
}

// The greatest distance between two control points that follow each other bounds the derivative of a Bezier
// curve, and its rounding error, wherever the curve lies.
TEST(Derivatives, of_moved_bezier_curves_are_within_rounding_of_their_hodographs) {
    Random random(19000000);
    for (int degree = 1; degree <= 31; ++degree) {
        SplineData data;
        data.degrees = {degree};
        data.counts = {degree + 1};
        data.knots = {std::vector<double>(static_cast<size_t>(degree) + 1, 0.0)};
        data.knots[0].resize(2 * data.knots[0].size(), 1.0);
        data.dim = 1;
        double step = 0;
        for (int i = 0; i <= degree; ++i) {
            data.points.push_back(1e8 + random.unit());
            step = i == 0 ? 0 : std::max(step, std::fabs(data.points.back() - *(data.points.end() - 2)));
        }
        const auto g = create(data);
        const auto hodograph = made([&](nurbs **out) { return nurbs_derivative(g.get(), 0, 1, out); });
        for (int i = 1; i < 64; ++i) {
            const std::vector<double> t = {i / 64.0};
            const double bound = 4 * (static_cast<double>(reference::c_of(degree)) + 2) * degree * step *
                                 static_cast<double>(eps);
            EXPECT_NEAR(eval_derivs(g.get(), 1, t)[1], eval(hodograph.get(), t)[0], bound)
                << "degree " << degree;
        }
    }
}

// Orders above the degree: exactly 0 when polynomial, ordinary values when rational.
TEST(Derivatives, orders_above_the_degree) {
    WorstErrors worst("orders to degree + 2, unit eps * E");
    for_each_case(15000000, 800, [&](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 2);
        Recipe recipe = random_recipe(random, axes, axes == 1 ? 6 : 3);
        int highest = 0;
        for (AxisRecipe &axis : recipe.axes) {
            axis.placement = Placement::origin; // 1e-17 to the power -8 would leave the range of double
            highest = std::max(highest, axis.degree);
        }
        check_derivatives(random, seed, recipe, highest + 2, 3, worst);
    });
}

} // namespace

} // namespace derivatives_test
