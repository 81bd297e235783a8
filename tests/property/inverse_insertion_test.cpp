// Inverse knot insertion: the knot by its formula, the shape kept, and the point of the leg a control point.
#include "property/same_shape.h"

namespace inverse_insertion_test {

using namespace support;

namespace {

using reference::exact;
using reference::Rational;

// A leg of the control polygon, the knots it belongs to, and its point.
struct LegCase {
    SplineData data;
    Handle g;
    int axis;
    int64_t layer;
    int64_t from;
    int64_t to;
    double ratio;

    LegCase(Random &random, const Recipe &recipe)
        : data(random_spline(random, recipe)), g(create(data)), axis(random.whole(0, data.axes() - 1)) {
        const Layers layers(data, axis);
        layer = random.whole(0, static_cast<int>(layers.count) - 2);
        const int64_t o = random.whole(0, static_cast<int>(layers.outer) - 1),
                      i = random.whole(0, static_cast<int>(layers.inner) - 1);
        from = layers.place(o, layer, i);
        to = layers.place(o, layer + 1, i);
        ratio = random.chance(15) ? random.whole(0, 1) : random.chance(20) ? 0.5 : random.unit();
    }
    [[nodiscard]] const std::vector<double> &knots() const { return data.knots[static_cast<size_t>(axis)]; }
    [[nodiscard]] int degree() const { return data.degrees[static_cast<size_t>(axis)]; }
    [[nodiscard]] double low() const { return knots()[static_cast<size_t>(layer) + 1]; }
    [[nodiscard]] double high() const { return knots()[static_cast<size_t>(layer + degree()) + 1]; }
    [[nodiscard]] Rational s() const {
        const Rational r = exact(ratio), w = exact(data.weight(from)), v = exact(data.weight(to));
        return ratio == 0 || ratio == 1 || (w == 0 && v == 0) ? r : Rational(r * w / (r * w + (1 - r) * v));
    }
    // (w Q, w) for a share of the end.
    [[nodiscard]] std::vector<Rational> record(const Rational &share) const {
        std::vector<Rational> result;
        for (int c = 0; c <= data.dim; ++c) {
            const Rational x = c < data.dim ? exact(data.coordinate(from, c)) : Rational(1),
                           y = c < data.dim ? exact(data.coordinate(to, c)) : Rational(1);
            result.push_back((1 - share) * x * exact(data.weight(from)) + share * y * exact(data.weight(to)));
        }
        return result;
    }
    [[nodiscard]] std::string place(uint64_t seed) const {
        return where(seed, data) + " axis " + std::to_string(axis) + " layer " + std::to_string(layer) +
               " ratio " + hex(ratio);
    }
};

Recipe leg_recipe(Random &random, bool periodic) {
    const int axes = random.chance(60) ? 1 : random.whole(2, 3), highest = axes == 1 ? 9 : axes == 2 ? 4 : 2;
    Recipe recipe = periodic ? random_recipe(random, axes, highest) : open_recipe(random, axes, highest);
    for (AxisRecipe &axis : recipe.axes) {
        axis.degree = std::max(axis.degree, 1);
    }
    return recipe;
}

long double as_long_double(const Rational &x) {
    return reference::quotient(numerator(x), denominator(x));
}

// The least distance of a control point of the result from a record, homogeneous components together.
long double nearest_record(const nurbs *g, const std::vector<Rational> &record) {
    const SplineData all = homogeneous(g);
    long double nearest = HUGE_VALL;
    for (int64_t i = 0; i < all.point_count(); ++i) {
        long double gap = 0;
        for (int c = 0; c < all.dim; ++c) {
            gap = std::max(gap, std::fabs(as_long_double(
                                    Rational(exact(all.coordinate(i, c)) - record[static_cast<size_t>(c)]))));
        }
        nearest = std::min(nearest, gap);
    }
    return nearest;
}

// What the ends of a leg are, largest component.
long double size_of(const LegCase &leg) {
    long double size = 0;
    for (const Rational &share : {Rational(0), Rational(1)}) {
        for (const Rational &x : leg.record(share)) {
            size = std::max(size, std::fabs(as_long_double(x)));
        }
    }
    return size;
}

nurbs_status insert_on(const LegCase &leg, double &knot, Handle &made) {
    nurbs *out = nullptr;
    const nurbs_status status = nurbs_insert_on_leg(leg.g.get(), leg.axis, leg.from, leg.ratio, &knot, &out);
    made.reset(out);
    return status;
}

// Whether the rule of the header lets the knot go in.
nurbs_status expected(const LegCase &leg) {
    const double w = leg.data.weight(leg.from), v = leg.data.weight(leg.to);
    return leg.ratio > 0 && leg.ratio < 1 && (w == 0) != (v == 0) ? NURBS_ERROR_WEIGHT_SIGN : NURBS_OK;
}

TEST(InsertOnLeg, makes_the_point_a_control_point) {
    WorstErrors worst("points of legs by degree, unit eps * largest record");
    int outside = 0, full = 0;
    for_each_case(1310000, 1200, [&](Random &random, uint64_t seed) {
        const LegCase leg(random, leg_recipe(random, false));
        double knot = 0;
        Handle made;
        const nurbs_status status = insert_on(leg, knot, made);
        if (expected(leg) != NURBS_OK) {
            ASSERT_EQ(status, expected(leg)) << leg.place(seed);
            return;
        }
        const Rational s = leg.s(), low = exact(leg.low()), high = exact(leg.high());
        if (status == NURBS_ERROR_MULTIPLICITY) {
            ++full;
            const double end = s < Rational(1, 2) ? leg.low() : leg.high();
            ASSERT_EQ(std::count(leg.knots().begin(), leg.knots().end(), end), leg.degree() + 1)
                << leg.place(seed);
            return;
        }
        ASSERT_EQ(status, NURBS_OK) << last_error() << leg.place(seed);
        const long double reach = std::max(std::fabs(leg.low()), std::fabs(leg.high()));
        const long double error = std::fabs(as_long_double(Rational(exact(knot) - (low + s * (high - low)))));
        ASSERT_LE(error, 2 * eps * reach + 4 * eps * (leg.high() - leg.low())) << leg.place(seed);
        const SplineData after = read_back(made.get());
        ASSERT_EQ(after.lower(leg.axis), leg.data.lower(leg.axis)) << leg.place(seed);
        ASSERT_EQ(after.upper(leg.axis), leg.data.upper(leg.axis)) << leg.place(seed);
        outside += knot < leg.data.lower(leg.axis) || knot > leg.data.upper(leg.axis) ? 1 : 0;
        expect_same_shape(leg.g.get(), made.get(), 3, random, leg.place(seed));
        // The control point is that of the rounded knot, and its share of the leg differs from s by that
        // rounding.
        const Rational share = high == low ? s : Rational((exact(knot) - low) / (high - low));
        const long double unit = eps * size_of(leg), gap = nearest_record(made.get(), leg.record(share));
        worst.add(leg.degree(), unit == 0 ? 0 : gap / unit / 3, unit == 0 ? 0 : gap / unit);
        ASSERT_LE(gap, 3 * unit) << leg.place(seed);
    });
    std::printf("%d knots outside the domain, %d full ones\n", outside, full);
    ASSERT_GT(outside, support::of_whole_run(20));
}

TEST(InsertOnLeg, goes_round_on_periodic_axes) {
    int cases = 0, refused = 0;
    for_each_case(1320000, 500, [&](Random &random, uint64_t seed) {
        Recipe recipe = leg_recipe(random, true);
        recipe.axes[0].form = KnotForm::periodic;
        recipe.axes[0].spacing = random.chance(50) ? Spacing::few_bits : Spacing::integers;
        recipe.axes[0].placement = Placement::origin;
        LegCase leg(random, recipe);
        if (!leg.data.periodic(leg.axis) || expected(leg) != NURBS_OK) {
            return;
        }
        double knot = 0;
        Handle made;
        ++cases;
        const nurbs_status status = insert_on(leg, knot, made);
        const Layers layers(leg.data, leg.axis);
        if (layers.count - leg.degree() < leg.degree()) {
            ASSERT_EQ(status, NURBS_ERROR_PERIODIC) << leg.place(seed);
            return;
        }
        if (status == NURBS_ERROR_MULTIPLICITY || status == NURBS_ERROR_PERIODIC_KNOTS) {
            ++refused;
            return;
        }
        ASSERT_EQ(status, NURBS_OK) << last_error() << leg.place(seed);
        const SplineData after = read_back(made.get());
        ASSERT_TRUE(after.periodic(leg.axis));
        ASSERT_GE(knot, leg.data.lower(leg.axis));
        ASSERT_LT(knot, leg.data.upper(leg.axis));
        const long double rounding = wrapping(leg.data, leg.axis, knot);
        expect_same_shape(leg.g.get(), made.get(), 3 + rounding, random, leg.place(seed));
        const long double share = 4 * eps * std::max(std::fabs(leg.low()), std::fabs(leg.high())) /
                                  std::max<long double>(leg.high() - leg.low(), LDBL_MIN);
        ASSERT_LE(nearest_record(made.get(), leg.record(leg.s())),
                  (8 * eps + share + rounding * eps) * 2 * size_of(leg))
            << leg.place(seed);
    });
    std::printf("%d of %d refused\n", refused, cases);
    ASSERT_LE(refused, cases / 3);
}

TEST(InsertAtPoint, finds_the_leg) {
    for_each_case(1330000, 400, [&](Random &random, uint64_t seed) {
        Recipe recipe = leg_recipe(random, false);
        recipe.weights = random.chance(50) ? Weights::none : Weights::moderate;
        const LegCase leg(random, recipe);
        std::vector<double> point;
        for (int c = 0; c < leg.data.dim; ++c) {
            const double a = leg.data.coordinate(leg.from, c), b = leg.data.coordinate(leg.to, c);
            point.push_back(a + leg.ratio * (b - a));
        }
        const auto tolerance = static_cast<double>(4 * eps) * extent(leg.data);
        int64_t index = -1;
        double ratio = -1, knot = 0;
        nurbs *out = nullptr;
        const nurbs_status status = nurbs_insert_at_point(leg.g.get(), leg.axis, point.data(), tolerance,
                                                          &index, &ratio, &knot, &out);
        const Handle made(out);
        if (status == NURBS_ERROR_MULTIPLICITY) {
            return;
        }
        ASSERT_EQ(status, NURBS_OK) << last_error() << leg.place(seed);
        // Legs may cross; that of the answer has the point in any case.
        const int64_t step = leg.to - leg.from;
        for (int c = 0; c < leg.data.dim; ++c) {
            const double a = leg.data.coordinate(index, c), b = leg.data.coordinate(index + step, c);
            ASSERT_NEAR(a + ratio * (b - a), point[static_cast<size_t>(c)], 2 * tolerance) << leg.place(seed);
        }
        nurbs *again = nullptr;
        double same = 0;
        require_ok(nurbs_insert_on_leg(leg.g.get(), leg.axis, index, ratio, &same, &again));
        const Handle other(again);
        ASSERT_EQ(same, knot);
        point[0] += 1e3 * extent(leg.data);
        ASSERT_EQ(nurbs_insert_at_point(leg.g.get(), leg.axis, point.data(), tolerance, nullptr, nullptr,
                                        nullptr, &again),
                  extent(leg.data) == 0 ? NURBS_OK : NURBS_ERROR_OFF_POLYGON);
        nurbs_destroy(again);
    });
}

} // namespace

} // namespace inverse_insertion_test
