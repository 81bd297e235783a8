// Continuity at knots and between ends against exact derivatives from both sides.
#include "property/same_shape.h"

namespace continuity_test {

using namespace support;

namespace {

struct Row {
    double knot;
    int32_t knot_order;
    int32_t order;
    int32_t geometric;
    double position_gap;
    double angle;
    double curvature_gap;
};

std::vector<Row> continuity(const nurbs *g, int axis, double position = 0, double derivative = 0,
                            double angle = 0) {
    int64_t n = 0;
    require_ok(nurbs_continuity(g, axis, position, derivative, angle, 0, nullptr, nullptr, nullptr, nullptr,
                                nullptr, nullptr, nullptr, &n));
    const auto size = static_cast<size_t>(n);
    std::vector<double> knots(size), gaps(size), angles(size), curvatures(size);
    std::vector<int32_t> knot_orders(size), orders(size), geometric(size);
    require_ok(nurbs_continuity(g, axis, position, derivative, angle, n, knots.data(), knot_orders.data(),
                                orders.data(), geometric.data(), gaps.data(), angles.data(),
                                curvatures.data(), nullptr));
    std::vector<Row> rows;
    for (size_t i = 0; i < size; ++i) {
        rows.push_back(
            {knots[i], knot_orders[i], orders[i], geometric[i], gaps[i], angles[i], curvatures[i]});
    }
    return rows;
}

struct Between {
    int32_t order = -7;
    int32_t geometric = -7;
    double gap = -7;
    double angle = -7;
    double curvature = -7;
};

Between between(const nurbs *a, int32_t end_a, const nurbs *b, int32_t end_b) {
    Between r;
    require_ok(nurbs_continuity_between(a, end_a, b, end_b, 0, 1e-9, 1e-9, &r.order, &r.geometric, &r.gap,
                                        &r.angle, &r.curvature));
    return r;
}

bool equal(const reference::Fraction &a, const reference::Fraction &b) {
    return a.numerator * b.denominator == b.numerator * a.denominator;
}

int exact_order(const SplineData &data, double below, double above) {
    const int p = data.degrees[0];
    const auto left = reference::exact_derivatives(data, p, &below, {true});
    const auto right = reference::exact_derivatives(data, p, &above, {false});
    for (int k = 0; k <= p; ++k) {
        for (size_t c = 0; c < left[0].size(); ++c) {
            if (!equal(left[static_cast<size_t>(k)][c], right[static_cast<size_t>(k)][c])) {
                return k - 1;
            }
        }
    }
    return p;
}

TEST(Continuity, of_curves_is_never_less_than_the_exact_one) {
    for_each_case(310000, 500, [](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, 1, 7);
        recipe.short_numbers = random.chance(50);
        const SplineData data = random_spline(random, recipe);
        const auto rows = continuity(create(data).get(), 0);
        const std::string place = where(seed, data);
        size_t inside = 0;
        for (const Row &row : rows) {
            const bool seam = row.knot == data.upper(0);
            const int exact = exact_order(data, row.knot, seam ? data.lower(0) : row.knot);
            const auto times = std::count(data.knots[0].begin(), data.knots[0].end(), row.knot);
            inside += seam ? 0 : 1;
            ASSERT_GE(row.order, exact) << place << hex(row.knot);
            ASSERT_GE(row.geometric, std::min(exact, 0)) << place << hex(row.knot);
            if (!seam) {
                ASSERT_EQ(row.knot_order, data.degrees[0] - times) << place << hex(row.knot);
                ASSERT_GE(row.order, row.knot_order) << place << hex(row.knot);
            }
            if (recipe.axes[0].spacing == Spacing::integers && recipe.weights == Weights::none && !seam) {
                ASSERT_EQ(row.order, exact) << place << hex(row.knot);
            }
        }
        auto distinct = data.knots[0];
        distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
        std::erase_if(distinct, [&](double t) { return t <= data.lower(0) || t >= data.upper(0); });
        ASSERT_EQ(inside, distinct.size()) << place;
        ASSERT_TRUE(!data.periodic(0) || rows.back().knot == data.upper(0)) << place;
    });
}

// An inserted knot is no break, on curves, surfaces and volumes; tolerances are for what rounding moved.
TEST(Continuity, of_an_inserted_knot_is_complete) {
    for_each_case(311000, 200, [](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 3);
        Recipe recipe = open_recipe(random, axes, axes == 1 ? 5 : 3);
        recipe.weights = recipe.weights == Weights::some_zero ? Weights::moderate : recipe.weights;
        for (AxisRecipe &axis : recipe.axes) {
            axis.spacing = Spacing::integers;
            axis.placement = Placement::origin;
        }
        const SplineData data = random_spline(random, recipe);
        const int axis = random.whole(0, axes - 1);
        const auto k = static_cast<size_t>(axis);
        const double t = data.lower(axis) + 0.4375 * (data.upper(axis) - data.lower(axis));
        if (std::count(data.knots[k].begin(), data.knots[k].end(), t) != 0) {
            return;
        }
        const Handle finer = insert(create(data).get(), axis, t, random.whole(1, data.degrees[k] + 1));
        for (const Row &row : continuity(finer.get(), axis, 0, 1e-6, 1e-6)) {
            if (row.knot == t) {
                ASSERT_EQ(row.order, data.degrees[k]) << where(seed, data);
            }
        }
    });
}

TEST(Continuity, of_the_halves_of_a_curve) {
    for_each_case(312000, 300, [](Random &random, uint64_t seed) {
        Recipe recipe = open_recipe(random, 1, 5);
        recipe.weights = random.chance(50) ? Weights::none : Weights::moderate;
        recipe.dim = random.whole(2, 3);
        recipe.axes[0] = {random.whole(2, 5), KnotForm::clamped, Spacing::integers, Placement::origin, 4};
        const SplineData data = random_spline(random, recipe);
        const double t = data.lower(0) + 0.4375 * (data.upper(0) - data.lower(0));
        nurbs *below = nullptr, *above = nullptr, *turned = nullptr, *faster = nullptr;
        require_ok(nurbs_split(create(data).get(), 0, t, &below, &above));
        const Handle lower(below), upper(above);
        require_ok(nurbs_reverse(above, 0, 0, &turned));
        require_ok(nurbs_reparametrize(above, 0, 0, 0.125 * (data.upper(0) - t), &faster));
        const Handle back(turned), fast(faster);
        const std::string place = where(seed, data);
        const auto times = std::count(data.knots[0].begin(), data.knots[0].end(), t);
        if (times != 0) {
            return;
        }
        const Between whole = between(below, NURBS_END, above, NURBS_START);
        ASSERT_EQ(whole.order, data.degrees[0]) << place;
        ASSERT_EQ(whole.geometric, 2) << place;
        ASSERT_EQ(whole.gap, 0) << place;
        const Between reversed = between(below, NURBS_END, turned, NURBS_END);
        ASSERT_TRUE(reversed.order == whole.order && reversed.geometric == 2) << place;
        const Between back_again = between(turned, NURBS_START, below, NURBS_START);
        ASSERT_LE(back_again.order, 0) << place; // other ends, unless the curve is closed there by chance
        const Between speed = between(below, NURBS_END, faster, NURBS_START);
        ASSERT_TRUE(speed.order == 0 && speed.geometric == 2) << place << speed.order << speed.geometric;
    });
}

// A model and knots multiplied by powers of two: the same orders, and gaps times the power.
TEST(Continuity, has_no_size) {
    for_each_case(780000, 200, [](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, random.whole(1, 2), 4);
        recipe.short_numbers = true;
        const SplineData data = random_spline(random, recipe);
        const int points = random.whole(-900, 900), knots = random.chance(30) ? 0 : random.whole(-300, 300);
        const SplineData other = scaled(data, std::ldexp(1, points), std::ldexp(1, knots));
        const Handle g = create(data), h = create(other);
        const auto rows = continuity(g.get(), 0), found = continuity(h.get(), 0);
        ASSERT_EQ(found.size(), rows.size()) << where(seed, data);
        for (size_t i = 0; i < rows.size(); ++i) {
            const std::string place = where(seed, data) + " points 2^" + std::to_string(points) +
                                      " knots 2^" + std::to_string(knots) + " row " + std::to_string(i);
            ASSERT_EQ(found[i].knot, std::ldexp(rows[i].knot, knots)) << place;
            ASSERT_EQ(found[i].order, rows[i].order) << place;
            ASSERT_EQ(found[i].geometric, rows[i].geometric) << place;
            ASSERT_EQ(found[i].position_gap, std::ldexp(rows[i].position_gap, points)) << place;
        }
        if (data.axes() == 1) {
            const Between here = between(g.get(), NURBS_END, g.get(), NURBS_START),
                          there = between(h.get(), NURBS_END, h.get(), NURBS_START);
            ASSERT_EQ(there.order, here.order) << where(seed, data);
            ASSERT_EQ(there.geometric, here.geometric) << where(seed, data);
            ASSERT_EQ(there.gap, std::ldexp(here.gap, points)) << where(seed, data);
        }
    });
}

} // namespace

} // namespace continuity_test
