// Periodic splines from what they do not repeat, and that back.
#include "support/cases.h"
#include "support/handle.h"

#include <gtest/gtest.h>

namespace unwrapped_test {

using namespace support;

namespace {

// The arguments of nurbs_create_periodic(): counts of control points that differ, knots of one period.
struct Unwrapped {
    SplineData data;
    std::vector<double> knots;
};

template <class Ask>
std::vector<double> counted(Ask &&ask) {
    int64_t count = 0;
    require_ok(ask(0, nullptr, &count));
    std::vector<double> values(static_cast<size_t>(count));
    require_ok(ask(count, values.data(), &count));
    return values;
}

Unwrapped unwrapped(const nurbs *g) {
    Unwrapped found{read_back(g), {}};
    int64_t total = 0;
    for (int k = 0; k < found.data.axes(); ++k) {
        require_ok(nurbs_unwrapped_count(g, k, &found.data.counts[static_cast<size_t>(k)]));
        const auto knots = counted([&](int64_t cap, double *values, int64_t *count) {
            return nurbs_unwrapped_knots(g, k, cap, values, count);
        });
        found.knots.insert(found.knots.end(), knots.begin(), knots.end());
    }
    require_ok(nurbs_unwrapped_points(g, 0, nullptr, nullptr, &total));
    const bool rational = found.data.rational();
    found.data.points.resize(static_cast<size_t>(total * found.data.dim));
    found.data.weights.resize(rational ? static_cast<size_t>(total) : 0);
    require_ok(nurbs_unwrapped_points(g, total, found.data.points.data(),
                                      rational ? found.data.weights.data() : nullptr, nullptr));
    return found;
}

nurbs_status create_periodic(const Unwrapped &given, Handle &out) {
    const SplineData &data = given.data;
    nurbs *g = nullptr;
    const nurbs_status status =
        nurbs_create_periodic(data.axes(), data.degrees.data(), data.counts.data(), given.knots.data(),
                              std::ssize(given.knots), data.dim, data.points.data(), 0, 0,
                              data.rational() ? data.weights.data() : nullptr, 0, data.flags, &g);
    out.reset(g);
    return status;
}

void expect_same(const Unwrapped &a, const Unwrapped &b, uint64_t seed) {
    ASSERT_EQ(a.data.counts, b.data.counts) << "seed " << seed;
    ASSERT_EQ(a.data.flags, b.data.flags) << "seed " << seed;
    ASSERT_TRUE(same_bits(a.knots, b.knots)) << "seed " << seed;
    ASSERT_TRUE(same_bits(a.data.points, b.data.points)) << "seed " << seed;
    ASSERT_TRUE(same_bits(a.data.weights, b.data.weights)) << "seed " << seed;
}

// Knots of few bits, whose copies a period away are exact: the full vector comes back bit for bit.
TEST(Unwrapped, makes_the_same_spline) {
    for_each_case(901000, 300, [](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, random.whole(1, 3), 4);
        for (AxisRecipe &axis : recipe.axes) {
            axis.spacing = Spacing::few_bits;
            axis.placement = Placement::origin;
            axis.form = random.chance(60) ? KnotForm::periodic : axis.form;
        }
        const SplineData data = random_spline(random, recipe);
        const Handle g = create(data);
        Handle again;
        ASSERT_EQ(create_periodic(unwrapped(g.get()), again), NURBS_OK) << where(seed, data) << last_error();
        const SplineData found = read_back(again.get());
        ASSERT_EQ(found.counts, data.counts) << where(seed, data);
        ASSERT_EQ(found.flags, data.flags) << where(seed, data);
        ASSERT_TRUE(same_bits(found.all_knots(), data.all_knots())) << where(seed, data) << describe(found);
        ASSERT_TRUE(same_bits(found.points, data.points)) << where(seed, data) << describe(found);
        ASSERT_TRUE(same_bits(found.weights, data.weights)) << where(seed, data) << describe(found);
    });
}

Unwrapped random_period(Random &random, int axes, int highest) {
    Unwrapped made;
    int64_t total = 1;
    made.data.dim = random.whole(1, 3);
    for (int k = 0; k < axes; ++k) {
        const int degree = random.whole(0, highest);
        const int64_t count = random.whole(1, axes == 1 ? 40 : 5);
        made.data.degrees.push_back(degree);
        made.data.counts.push_back(count);
        made.data.flags |= NURBS_ON_AXIS(static_cast<uint32_t>(k), NURBS_PERIODIC);
        total *= count;
        double t = random.between(-2, 2);
        int copies = 0;
        for (int64_t i = 0; i <= count; ++i) {
            made.knots.push_back(t);
            const bool again = copies < degree - 1 && i + 1 < count && random.chance(30);
            copies = again ? copies + 1 : 0;
            t += again ? 0 : random.magnitude(1e-3, 1);
        }
    }
    for (int64_t i = 0; i < total * made.data.dim; ++i) {
        made.data.points.push_back(random.between(-1, 1));
    }
    for (int64_t n = random.chance(50) ? total : 0; n > 0; --n) {
        made.data.weights.push_back(random.magnitude(0.1, 10));
    }
    return made;
}

// Any knots, all degrees, and fewer control points than the degree: what was given comes back bit for bit.
TEST(Unwrapped, gives_back_what_it_was_given) {
    for_each_case(902000, 400, [](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 3);
        const Unwrapped given = random_period(random, axes, axes == 1 ? 31 : 5);
        Handle g;
        ASSERT_EQ(create_periodic(given, g), NURBS_OK) << "seed " << seed << last_error();
        expect_same(unwrapped(g.get()), given, seed);
        SplineData full = read_back(g.get());
        Handle same; // what is stored is a spline of nurbs_create()
        ASSERT_EQ(try_create(full, same), NURBS_OK) << where(seed, full) << last_error();
    });
}

// The basis functions go on around the period: turning knots and points by one leaves the curve where it is.
TEST(Unwrapped, may_begin_at_any_knot) {
    for_each_case(903000, 200, [](Random &random, uint64_t seed) {
        const int degree = random.whole(1, 6);
        const int64_t count = random.whole(degree + 2, 20);
        Unwrapped given;
        given.data.degrees = {degree};
        given.data.counts = {count};
        given.data.dim = 1;
        given.data.flags = NURBS_PERIODIC;
        double t = 0;
        for (int64_t i = 0; i <= count; ++i, t += random.whole(1, 16) / 8.0) {
            given.knots.push_back(t); // sums of these are exact
        }
        for (int64_t i = 0; i < count; ++i) {
            given.data.points.push_back(random.whole(-8, 8));
        }
        Unwrapped turned = given;
        const double period = given.knots.back();
        turned.knots.erase(turned.knots.begin());
        turned.knots.push_back(turned.knots.front() + period);
        std::rotate(turned.data.points.begin(), turned.data.points.begin() + 1, turned.data.points.end());
        Handle a, b;
        ASSERT_EQ(create_periodic(given, a), NURBS_OK) << last_error();
        ASSERT_EQ(create_periodic(turned, b), NURBS_OK) << last_error();
        std::vector<double> params(20);
        std::generate(params.begin(), params.end(), [&] { return period * random.unit(); });
        const auto x = eval(a.get(), params, NURBS_WRAP), y = eval(b.get(), params, NURBS_WRAP);
        for (size_t i = 0; i < params.size(); ++i) {
            // one knot span is the same polynomial, whose parameter a period away is rounded once
            ASSERT_NEAR(x[i], y[i], 8 * 0x1p-52 * 64 * (degree + 1) * period) << "seed " << seed;
        }
    });
}

// Of short vectors the missing knots influence nothing.
TEST(Unwrapped, short_knots_come_back) {
    for_each_case(904000, 200, [](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, random.whole(1, 3), 4);
        for (AxisRecipe &axis : recipe.axes) {
            axis.degree = std::max(axis.degree, 1);
        }
        const SplineData data = random_spline(random, recipe);
        const Handle g = create(data);
        std::vector<double> knots;
        for (int k = 0; k < data.axes(); ++k) {
            const auto own = counted([&](int64_t cap, double *values, int64_t *count) {
                return nurbs_short_knots(g.get(), k, cap, values, count);
            });
            const auto &full = data.knots[static_cast<size_t>(k)];
            ASSERT_TRUE(same_bits(own, {full.begin() + 1, full.end() - 1})) << where(seed, data);
            knots.insert(knots.end(), own.begin(), own.end());
        }
        nurbs *made = nullptr;
        const nurbs_status status = nurbs_create_short(
            data.axes(), data.degrees.data(), data.counts.data(), knots.data(), std::ssize(knots), data.dim,
            data.points.data(), 0, 0, data.rational() ? data.weights.data() : nullptr, 0, data.flags, &made);
        const Handle again(made);
        if (status != NURBS_OK) {
            return; // an end knot of full multiplicity would occur once more
        }
        const auto params = random_params(random, data, 10);
        ASSERT_TRUE(same_bits(eval(again.get(), params), eval(g.get(), params))) << where(seed, data);
    });
}

} // namespace
} // namespace unwrapped_test
