// Knot insertion: every new control point against its exact value, and the shape that does not move.
#include "property/same_shape.h"
#include "reference/definition.h"
#include "reference/magnitudes.h"
#include "reference/number.h"
#include "support/cases.h"
#include "support/handle.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace insertion_test {

using namespace support;
using reference::eps;
using reference::Rational;

namespace {

struct Insertion {
    int axis;
    double knot;
    int times;
    int present;
};

// A knot anywhere in the closed domain, as often as there is room for.
Insertion random_insertion(Random &random, const SplineData &data) {
    const int axis = random.whole(0, data.axes() - 1);
    const auto k = static_cast<size_t>(axis);
    const double knot = random_new_knot(random, data, axis);
    const auto present = static_cast<int>(std::count(data.knots[k].begin(), data.knots[k].end(), knot));
    const int room = data.degrees[k] + 1 - present;
    return {axis, knot, random.whole(std::min(1, room), room), present};
}

std::string text(const Insertion &insertion) {
    return "axis " + std::to_string(insertion.axis) + " knot " + hex(insertion.knot) + " times " +
           std::to_string(insertion.times);
}

// 2 eps of the largest magnitude of the same homogeneous coordinate among the old points that can contribute,
// for each step. Old points are products of two doubles and new ones are handed out rounded again, half an
// eps each, when rational.
TEST(Insertion, control_points_are_exact_to_two_eps_a_step) {
    WorstErrors worst("inserted control points by degree, unit eps * hull * steps");
    for_each_case(90000, 999, [&](Random &random, uint64_t seed) {
        const int axes = random.chance(60) ? 1 : random.whole(2, 3);
        auto recipe = open_recipe(random, axes, axes == 1 ? (random.chance(15) ? 15 : 7) : 3);
        recipe.dim = random.whole(1, 2);
        const auto data = random_spline(random, recipe);
        const auto insertion = random_insertion(random, data);
        const auto g = create(data);
        const auto refined = insert(g.get(), insertion.axis, insertion.knot, insertion.times);
        const auto want = reference::defined_insertion(data, insertion.axis, insertion.knot, insertion.times);
        const auto got = read_back(refined.get());
        const auto k = static_cast<size_t>(insertion.axis);
        ASSERT_TRUE(same_bits(got.knots[k], want.knots)) << where(seed, data) << text(insertion);
        const Layers before(data, insertion.axis);
        const Layers after(got, insertion.axis);
        const auto old_points = homogeneous_points(g.get());
        const auto new_points = homogeneous_points(refined.get());
        const auto width = static_cast<int64_t>(data.dim) + 1;
        size_t record = 0;
        for (int64_t o = 0; o < after.outer; ++o) {
            for (int64_t layer = 0; layer < after.count; ++layer) {
                const bool fresh = layer >= want.first && layer <= want.last;
                for (int64_t i = 0; i < after.inner; ++i, record += fresh ? 1U : 0U) {
                    for (int64_t c = 0; c < width; ++c) {
                        const double value =
                            new_points[static_cast<size_t>(after.place(o, layer, i) * width + c)];
                        const auto old = [&](int64_t from) {
                            return old_points[static_cast<size_t>(before.place(o, from, i) * width + c)];
                        };
                        if (!fresh) {
                            ASSERT_TRUE(
                                same_bits(value, old(layer < want.first ? layer : layer - insertion.times)))
                                << where(seed, data) << text(insertion) << " layer " << layer
                                << " must not change";
                            continue;
                        }
                        double hull = 0;
                        for (int64_t from = layer - insertion.times; from <= layer; ++from) {
                            hull = from < 0 || from >= before.count ? hull
                                                                    : std::max(hull, std::fabs(old(from)));
                        }
                        const Rational &exact = want.records[record][static_cast<size_t>(c)];
                        const long double unit = eps * hull;
                        const long double error =
                            reference::error_ratio(value, reference::fraction(exact), unit);
                        const long double bound = 2 * insertion.times + (data.rational() ? 1 : 0);
                        worst.add(data.degrees[k], error / bound, error / insertion.times);
                        ASSERT_LE(error, bound) << where(seed, data) << text(insertion) << " layer " << layer
                                                << " component " << c << " is " << hex(value);
                    }
                }
            }
        }
    });
}

TEST(Insertion, the_shape_does_not_move) {
    for_each_case(91000, 999, [](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 3);
        Recipe recipe = random_recipe(random, axes, axes == 1 ? 9 : 5 - axes);
        for (AxisRecipe &axis : recipe.axes) {
            if (axis.form == KnotForm::periodic && random.chance(60)) {
                axis.spacing = Spacing::few_bits;
                axis.placement = Placement::origin;
            }
        }
        const auto data = random_spline(random, recipe);
        auto insertion = random_insertion(random, data);
        const double rounded = std::ldexp(std::floor(std::ldexp(insertion.knot, 10)), -10);
        if (insertion.present == 0 && rounded > data.lower(insertion.axis) &&
            wrapping(data, insertion.axis, rounded) == 0) {
            insertion.knot = rounded; // of few bits, too
            const auto &t = data.knots[static_cast<size_t>(insertion.axis)];
            const auto present = static_cast<int>(std::count(t.begin(), t.end(), rounded));
            insertion.times =
                std::min(insertion.times, data.degrees[static_cast<size_t>(insertion.axis)] + 1 - present);
        }
        const auto g = create(data);
        const auto refined = insert(g.get(), insertion.axis, insertion.knot, insertion.times);
        // On a periodic axis the copies that a short period brings along count as well.
        const int copies = data.periodic(insertion.axis) ? 4 : 1;
        const long double moved =
            2 * insertion.times * copies + wrapping(data, insertion.axis, insertion.knot);
        expect_same_shape(g.get(), refined.get(), moved, random, where(seed, data) + text(insertion));
    });
}

TEST(Insertion, no_times_is_the_same_spline) {
    for_each_case(92000, 50, [](Random &random, uint64_t seed) {
        const auto data = random_spline(random, random_recipe(random, random.whole(1, 3), 4));
        const auto insertion = random_insertion(random, data);
        const auto got = read_back(insert(create(data).get(), insertion.axis, insertion.knot, 0).get());
        ASSERT_TRUE(same_bits(got.all_knots(), data.all_knots())) << where(seed, data);
        ASSERT_TRUE(same_bits(got.points, data.points)) << where(seed, data);
        ASSERT_TRUE(same_bits(got.weights, data.weights)) << where(seed, data);
    });
}

TEST(Insertion, a_knot_too_many_is_refused) {
    for_each_case(93000, 50, [](Random &random, uint64_t seed) {
        const auto data = random_spline(random, random_recipe(random, random.whole(1, 3), 4));
        const auto insertion = random_insertion(random, data);
        const auto k = static_cast<size_t>(insertion.axis);
        const auto g = create(data);
        nurbs *out = g.get();
        const int room = data.degrees[k] + 1 - insertion.present;
        ASSERT_EQ(nurbs_insert_knot(g.get(), insertion.axis, insertion.knot, room + 1, &out),
                  NURBS_ERROR_MULTIPLICITY)
            << where(seed, data) << text(insertion);
        ASSERT_EQ(out, nullptr);
    });
}

// A knot of multiplicity p makes a control point a point of the curve.
TEST(Insertion, full_multiplicity_puts_a_control_point_on_the_curve) {
    for_each_case(94000, 999, [](Random &random, uint64_t seed) {
        Recipe recipe = open_recipe(random, 1, 9);
        recipe.weights = Weights::none;
        const auto data = random_spline(random, recipe);
        const int p = data.degrees[0];
        const auto insertion = random_insertion(random, data);
        const double t = insertion.knot;
        if (insertion.present >= p || t == data.upper(0)) {
            return;
        }
        const auto got = read_back(insert(create(data).get(), 0, t, p - insertion.present).get());
        const auto first =
            std::lower_bound(got.knots[0].begin(), got.knots[0].end(), t) - got.knots[0].begin();
        const auto want = reference::exact_point(data, &t);
        const double hull = reference::exact_hull(data, &t);
        for (int c = 0; c < data.dim; ++c) {
            ASSERT_LE(reference::error_ratio(got.coordinate(first - 1, c), want[static_cast<size_t>(c)],
                                             2 * p * eps * hull),
                      1)
                << where(seed, data) << text(insertion);
        }
        ASSERT_TRUE(same_bits(eval(create(got).get(), {t})[0], got.coordinate(first - 1, 0)))
            << where(seed, data) << text(insertion);
    });
}

// Points computed before and after agree within both evaluations' promises and the moves of the control
// points. A weight of the denominator may be as small as the smallest active one.
TEST(Insertion, commutes_with_evaluation) {
    for_each_case(95000, 999, [](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, random.whole(1, 3), 3);
        recipe.weights = random.chance(50) ? Weights::none : Weights::moderate;
        const auto data = random_spline(random, recipe);
        const auto insertion = random_insertion(random, data);
        const auto g = create(data);
        const auto refined = insert(g.get(), insertion.axis, insertion.knot, insertion.times);
        const auto params = random_params(random, data, 10);
        const auto before = eval(g.get(), params);
        const auto after = eval(refined.get(), params);
        const auto hulls = hull_sizes(g.get(), params);
        const long double copies = data.periodic(insertion.axis) ? 4 : 1;
        // Weights lie in [0.2, 5]: numerator and denominator move by up to 25 times what the points do.
        const long double moved =
            (2 * insertion.times * copies + 1 + wrapping(data, insertion.axis, insertion.knot)) *
            (data.rational() ? 50 : 1);
        const long double bound = (2 * reference::c_of(data) + moved) * eps;
        for (size_t i = 0; i < before.size(); ++i) {
            const double hull = hulls[i / static_cast<size_t>(data.dim)];
            ASSERT_LE(std::fabs(static_cast<long double>(before[i]) - after[i]), bound * hull)
                << where(seed, data) << text(insertion);
        }
    });
}

} // namespace

} // namespace insertion_test
