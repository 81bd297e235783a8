// Degree elevation: every control point against its exact value, the knots it must have, and the shape that
// does not move.
#include "reference/definition.h"
#include "reference/magnitudes.h"
#include "reference/number.h"
#include "support/cases.h"
#include "support/handle.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

using namespace support;
using reference::eps;
using reference::Rational;

namespace {

struct Elevation {
    int axis;
    int times;
};

std::string text(const Elevation &elevation) {
    return "axis " + std::to_string(elevation.axis) + " times " + std::to_string(elevation.times);
}

Recipe open_recipe(Random &random, int axes, int max_degree) {
    Recipe recipe = random_recipe(random, axes, max_degree);
    for (AxisRecipe &axis : recipe.axes) {
        if (axis.form == KnotForm::periodic) {
            axis.form = KnotForm::unclamped;
        }
    }
    return recipe;
}

int copies(const std::vector<double> &knots, double knot) {
    return static_cast<int>(std::count(knots.begin(), knots.end(), knot));
}

// Every knot of the open domain `times` more often, the ends at the places that the degree gives them, and
// nothing that was not a knot.
void expect_knots(const SplineData &before, const SplineData &after, const Elevation &elevation,
                  const std::string &place) {
    const auto k = static_cast<size_t>(elevation.axis);
    const std::vector<double> &old = before.knots[k];
    const std::vector<double> &knots = after.knots[k];
    ASSERT_EQ(after.degrees[k], before.degrees[k] + elevation.times) << place;
    ASSERT_EQ(after.flags, before.flags) << place;
    ASSERT_TRUE(same_bits(after.lower(elevation.axis), before.lower(elevation.axis))) << place;
    ASSERT_TRUE(same_bits(after.upper(elevation.axis), before.upper(elevation.axis))) << place;
    for (const double knot : knots) {
        const int had = copies(old, knot);
        const bool inside = before.lower(elevation.axis) < knot && knot < before.upper(elevation.axis);
        if (inside) {
            ASSERT_EQ(copies(knots, knot), had + elevation.times) << place << " knot " << hex(knot);
        } else if (!before.periodic(elevation.axis)) {
            ASSERT_GT(had, 0) << place << " knot " << hex(knot);
            ASSERT_LE(copies(knots, knot), had + elevation.times) << place << " knot " << hex(knot);
        }
    }
    for (const double knot : old) {
        const bool inside = before.lower(elevation.axis) < knot && knot < before.upper(elevation.axis);
        ASSERT_TRUE(!inside || copies(knots, knot) > 0) << place << " knot " << hex(knot);
    }
}

// 2 eps, for each step, of the largest magnitude of the same homogeneous coordinate among the old points
// whose support holds that of the new one. Old points are products of two doubles and new ones are handed out
// rounded again, half an eps each, when rational.
TEST(Elevation, control_points_are_exact_to_two_eps_a_step) {
    WorstErrors worst("elevated control points by old degree, unit eps * hull * steps");
    for_each_case(96000, 999, [&](Random &random, uint64_t seed) {
        const int axes = random.chance(60) ? 1 : random.whole(2, 3);
        auto recipe = open_recipe(random, axes, axes == 1 ? 9 : 3);
        recipe.dim = random.whole(1, 2);
        const auto data = random_spline(random, recipe);
        Elevation elevation{random.whole(0, axes - 1), 1};
        const auto k = static_cast<size_t>(elevation.axis);
        elevation.times = data.degrees[k] < 5 ? random.whole(1, 3) : 1;
        const auto g = create(data);
        const auto raised = elevate(g.get(), elevation.axis, elevation.times);
        const auto got = read_back(raised.get());
        const std::string place = where(seed, data) + text(elevation);
        expect_knots(data, got, elevation, place);
        const auto want = reference::defined_elevation(data, elevation.axis, elevation.times, got.knots[k]);
        const auto old_points = homogeneous_points(g.get());
        const auto new_points = homogeneous_points(raised.get());
        const auto width = static_cast<size_t>(data.dim) + 1;
        ASSERT_EQ(want.size() * width, new_points.size()) << place;
        size_t inner = 1;
        for (size_t axis = k + 1; axis < data.counts.size(); ++axis) {
            inner *= static_cast<size_t>(data.counts[axis]);
        }
        const auto old_count = static_cast<size_t>(data.counts[k]);
        const auto new_count = static_cast<size_t>(got.counts[k]);
        const auto p = static_cast<size_t>(data.degrees[k]);
        for (size_t record = 0; record < want.size(); ++record) {
            const size_t layer = record / inner % new_count;
            const size_t outer = record / inner / new_count;
            const double start = got.knots[k][layer];
            const double end = got.knots[k][layer + p + static_cast<size_t>(elevation.times) + 1];
            const bool active = data.lower(elevation.axis) < end && start < data.upper(elevation.axis);
            for (size_t c = 0; active && c < width; ++c) {
                double hull = 0;
                for (size_t from = 0; from < old_count; ++from) {
                    if (data.knots[k][from] <= start && end <= data.knots[k][from + p + 1]) {
                        hull = std::max(
                            hull,
                            std::fabs(
                                old_points[((outer * old_count + from) * inner + record % inner) * width +
                                           c]));
                    }
                }
                const long double error = reference::error_ratio(
                    new_points[record * width + c], reference::fraction(want[record][c]), eps * hull);
                const long double bound = 2 * elevation.times + (data.rational() ? 1 : 0);
                worst.add(data.degrees[k], error / bound, error / elevation.times);
                ASSERT_LE(error, bound) << place << " layer " << layer << " component " << c;
            }
        }
    });
}

} // namespace
