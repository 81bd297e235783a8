// Degree elevation: every control point against its exact value, the knots it must have, and the shape that
// does not move.
#include "reference/definition.h"
#include "reference/magnitudes.h"
#include "reference/number.h"
#include "support/cases.h"
#include "support/handle.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>

namespace elevation_test {

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

Recipe elevated_recipe(Random &random, int axes, int max_degree) {
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
    for_each_case(96000, 400, [&](Random &random, uint64_t seed) {
        const int axes = random.chance(60) ? 1 : random.whole(2, 3);
        auto recipe = elevated_recipe(random, axes, axes == 1 ? 9 : 3);
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

// Points computed before and after agree within both evaluations' promises and the moves of the control
// points, on every form of knots.
TEST(Elevation, commutes_with_evaluation) {
    for_each_case(97000, 999, [](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, random.whole(1, 3), 4);
        recipe.weights = random.chance(50) ? Weights::none : Weights::moderate;
        for (AxisRecipe &axis : recipe.axes) {
            if (axis.form == KnotForm::periodic) { // whose knots repeat exactly
                axis.spacing = Spacing::few_bits;
                axis.placement = Placement::origin;
            }
        }
        const auto data = random_spline(random, recipe);
        const Elevation elevation{random.whole(0, data.axes() - 1), random.whole(1, 3)};
        const auto g = create(data);
        const auto raised = elevate(g.get(), elevation.axis, elevation.times);
        const auto params = random_params(random, data, 10);
        const auto before = eval(g.get(), params);
        const auto after = eval(raised.get(), params);
        const auto hulls = hull_sizes(g.get(), params);
        // Weights lie in [0.2, 5]: numerator and denominator move by up to 25 times what the points do.
        const long double moved = (2 * elevation.times + 1) * (data.rational() ? 50 : 1);
        const long double bound =
            (reference::c_of(data) + reference::c_of(read_back(raised.get())) + moved) * eps;
        for (size_t i = 0; i < before.size(); ++i) {
            const double hull = hulls[i / static_cast<size_t>(data.dim)];
            ASSERT_LE(std::fabs(static_cast<long double>(before[i]) - after[i]), bound * hull)
                << where(seed, data) << text(elevation) << " point " << i;
        }
    });
}

// The result is one that nurbs_create() accepts as periodic: its layers repeat bit for bit and its knots with
// the period.
TEST(Elevation, periodic_axes_stay_periodic) {
    int cases = 0;
    int refused = 0;
    for_each_case(98000, 999, [&](Random &random, uint64_t seed) {
        ++cases;
        const int axes = random.whole(1, 3);
        Recipe recipe = random_recipe(random, axes, axes == 1 ? 9 : 3);
        const Elevation elevation{random.whole(0, axes - 1), random.whole(1, 3)};
        recipe.axes[static_cast<size_t>(elevation.axis)].form = KnotForm::periodic;
        const auto data = random_spline(random, recipe);
        nurbs *out = nullptr;
        const nurbs_status status = nurbs_elevate(create(data).get(), elevation.axis, elevation.times, &out);
        const Handle raised(out);
        if (status == NURBS_ERROR_PERIODIC_KNOTS) {
            ++refused; // knots that rounding makes equal in one period and not in another
            return;
        }
        ASSERT_EQ(status, NURBS_OK) << last_error() << where(seed, data) << text(elevation);
        const auto got = read_back(raised.get());
        expect_knots(data, got, elevation, where(seed, data) + text(elevation));
        Handle again;
        ASSERT_EQ(try_create(got, again), NURBS_OK) << last_error() << where(seed, data) << text(elevation);
    });
    std::printf("%d of %d refused\n", refused, cases);
    ASSERT_LE(refused, cases / 50);
}

// Three steps at once and one after the other: one rounding of the control points against three.
TEST(Elevation, steps_compose) {
    for_each_case(99000, 300, [](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, random.whole(1, 2), 4);
        recipe.weights = Weights::none;
        const auto data = random_spline(random, recipe);
        const int axis = random.whole(0, data.axes() - 1);
        const auto g = create(data);
        nurbs *out = nullptr;
        const nurbs_status status = nurbs_elevate(g.get(), axis, 3, &out);
        const Handle at_once(out);
        if (status == NURBS_ERROR_PERIODIC_KNOTS) {
            return;
        }
        ASSERT_EQ(status, NURBS_OK) << last_error() << where(seed, data);
        const auto in_steps = elevate(elevate(elevate(g.get(), axis, 1).get(), axis, 1).get(), axis, 1);
        const auto one = read_back(at_once.get());
        const auto three = read_back(in_steps.get());
        ASSERT_TRUE(same_bits(one.all_knots(), three.all_knots())) << where(seed, data);
        double hull = 0;
        for (const double x : data.points) {
            hull = std::max(hull, std::fabs(x));
        }
        for (size_t i = 0; i < one.points.size(); ++i) {
            ASSERT_LE(std::fabs(one.points[i] - three.points[i]), 12 * 0x1p-52 * hull) << where(seed, data);
        }
    });
}

} // namespace

} // namespace elevation_test
