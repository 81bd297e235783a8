// Fairing: the energy against exact quadrature, and that it is the least.
#include "property/deform_cases.h"

namespace fair_test {

using namespace support;
using namespace support::deform;

namespace {

// The integral of the squared derivative of an order of a polynomial curve, by Gauss' rule of five points on
// each span, which is exact to degree 9.
long double energy_of(const SplineData &data, int order) {
    static const long double nodes[] = {0, 0.538469310105683091036314420700208805L,
                                        0.906179845938663992797626878299392965L};
    static const long double weights[] = {0.568888888888888888888888888888888889L,
                                          0.478628670499366468041291514835638193L,
                                          0.236926885056189087514264040719917363L};
    long double sum = 0;
    const std::vector<double> &t = data.knots[0];
    for (size_t i = 0; i + 1 < t.size(); ++i) {
        if (t[i] < data.lower(0) || t[i + 1] > data.upper(0) || t[i] == t[i + 1]) {
            continue;
        }
        for (int j = -2; j <= 2; ++j) {
            const long double half = (t[i + 1] - t[i]) / 2.0L, x = nodes[std::abs(j)] * (j < 0 ? -1 : 1);
            const auto at = static_cast<double>(t[i] + half + half * x);
            const auto derivatives = reference::exact_derivatives(data, order, &at);
            for (const reference::Fraction &value : derivatives[static_cast<size_t>(order)]) {
                const long double v = reference::quotient(value.numerator, value.denominator);
                sum += half * weights[std::abs(j)] * v * v;
            }
        }
    }
    return sum;
}

TEST(Fair, lowers_the_energy_within_the_bound) {
    for_each_case(1560000, 60, [](Random &random, uint64_t seed) {
        Recipe recipe = calm_recipe(random, 1, 5, random.whole(1, 3));
        recipe.weights = Weights::none;
        recipe.axes[0].spacing = Spacing::integers;
        recipe.axes[0].spans = random.whole(4, 12);
        const SplineData data = random_spline(random, recipe);
        const int order = random.whole(1, std::min(3, data.degrees[0]));
        const double tolerance = extent(data) * random.magnitude(1e-3, 1);
        const Handle g = create(data);
        double energies[2] = {-1, -1}, bound = -1;
        nurbs *out = nullptr;
        require_ok(nurbs_fair(g.get(), order, nullptr, tolerance, energies, &bound, &out));
        const Handle h(out);
        const SplineData after = read_back(h.get());
        const long double before = energy_of(data, order), rounding = 1e-10L * before;
        ASSERT_NEAR(static_cast<double>(energies[0] / before), 1, 1e-9) << where(seed, data);
        ASSERT_LE(std::fabs(energies[1] - energy_of(after, order)), rounding) << where(seed, data);
        ASSERT_LE(energies[1], energies[0]);
        ASSERT_LE(bound, tolerance);
        ASSERT_EQ(after.knots, data.knots);
        for (int n = 0; n < 10; ++n) {
            ASSERT_LE(length(step_between(g.get(), h.get(), random_params(random, data, 1))),
                      bound * (1 + 1e-12))
                << where(seed, data);
        }
        if (!data.periodic(0)) {
            for (const double end : {data.lower(0), data.upper(0)}) {
                ASSERT_LE(length(step_between(g.get(), h.get(), {end})), 0) << where(seed, data);
            }
        }
    });
}

// Without a limit the least energy is what the derivative of the Lagrangian says: no control point that may
// move has a slope of the energy.
TEST(Fair, finds_the_minimum_where_the_tolerance_allows_it) {
    for_each_case(1570000, 30, [](Random &random, uint64_t seed) {
        Recipe recipe = calm_recipe(random, 1, 4, 2);
        recipe.weights = Weights::none;
        recipe.axes[0].form = KnotForm::clamped;
        recipe.axes[0].spacing = Spacing::integers;
        recipe.axes[0].spans = 6;
        const SplineData data = random_spline(random, recipe);
        const int order = random.whole(1, std::min(2, data.degrees[0]));
        double energies[2] = {-1, -1};
        nurbs *out = nullptr;
        require_ok(
            nurbs_fair(create(data).get(), order, nullptr, 100 * extent(data), energies, nullptr, &out));
        const Handle h(out);
        SplineData after = read_back(h.get());
        for (int64_t i = 1; i + 1 < after.point_count(); ++i) {
            SplineData other = after;
            const double step = 1e-3 * extent(data);
            other.points[static_cast<size_t>(2 * i)] += step;
            const long double up = energy_of(other, order);
            other.points[static_cast<size_t>(2 * i)] -= 2 * step;
            const long double down = energy_of(other, order), least = energy_of(after, order);
            ASSERT_GE(up, least * (1 - 1e-6L)) << where(seed, data);
            // The slope is that between the two, the curvature their sum.
            ASSERT_LE(std::fabs(up - down), 1e-3L * (up + down - 2 * least) + 1e-8L * energies[0])
                << where(seed, data);
        }
    });
}

// Without `keep` the boundaries of axes that are not periodic stay, and nothing else is asked.
TEST(Fair, keeps_the_boundaries_of_plain_axes_by_default) {
    for_each_case(1590000, 40, [](Random &random, uint64_t seed) {
        const int axes = random.whole(2, 3);
        Recipe recipe = calm_recipe(random, axes, 2, 2);
        std::vector<int32_t> keep;
        for (AxisRecipe &axis : recipe.axes) {
            axis = {2, random.chance(50) ? KnotForm::periodic : KnotForm::clamped, Spacing::integers,
                    Placement::origin, 4};
            keep.insert(keep.end(), 2, axis.form == KnotForm::periodic ? -1 : 0);
        }
        const SplineData data = random_spline(random, recipe);
        const double tolerance = 0.1 * extent(data);
        const Handle g = create(data);
        const Handle by_default = made(
            [&](nurbs **out) { return nurbs_fair(g.get(), 2, nullptr, tolerance, nullptr, nullptr, out); });
        const Handle asked = made([&](nurbs **out) {
            return nurbs_fair(g.get(), 2, keep.data(), tolerance, nullptr, nullptr, out);
        });
        ASSERT_EQ(read_back(by_default.get()).points, read_back(asked.get()).points) << where(seed, data);
        ASSERT_NE(read_back(asked.get()).points, data.points) << where(seed, data);
    });
}

struct FairedShape {
    SplineData data;
    double energies[2] = {};
    double bound = -1;
};

FairedShape faired(const SplineData &data, int order, double tolerance, bool energies) {
    FairedShape result;
    const Handle h = made([&, g = create(data)](nurbs **out) {
        return nurbs_fair(g.get(), order, nullptr, tolerance, energies ? result.energies : nullptr,
                          &result.bound, out);
    });
    result.data = read_back(h.get());
    return result;
}

// A model and knots multiplied by powers of two give what the model gives, and an energy that overflows
// stands in the way only of those who ask for it.
TEST(Fair, has_no_size) {
    int moved = 0;
    for_each_case(1595000, 40, [&](Random &random, uint64_t seed) {
        Recipe recipe = calm_recipe(random, random.whole(1, 2), 4, random.whole(1, 3));
        recipe.short_numbers = true;
        recipe.weights = random.chance(50) ? Weights::none : Weights::moderate;
        for (AxisRecipe &axis : recipe.axes) {
            axis = {random.whole(2, 4), axis.form, Spacing::integers, Placement::origin, 5};
        }
        const SplineData data = random_spline(random, recipe);
        const int order = random.whole(1, 2), points = random.whole(-900, 900),
                  knots = random.chance(50) ? 0 : random.whole(-300, 300);
        const double tolerance = 0.125 * extent(data);
        const FairedShape base = faired(data, order, tolerance, true);
        const SplineData large = scaled(data, std::ldexp(1, points), std::ldexp(1, knots));
        const FairedShape found = faired(large, order, std::ldexp(tolerance, points), false);
        ASSERT_TRUE(same_bits(found.data.points, scaled(base.data, std::ldexp(1, points)).points))
            << "2^" << points << " 2^" << knots << where(seed, data);
        ASSERT_EQ(found.data.knots, large.knots);
        ASSERT_EQ(found.data.weights, data.weights);
        ASSERT_EQ(found.bound, std::ldexp(base.bound, points)) << where(seed, data);
        moved += base.data.points != data.points ? 1 : 0;
        const int power = 2 * points + (data.axes() - 2 * order) * knots;
        const double energy = std::ldexp(base.energies[1], power);
        if (std::isfinite(std::ldexp(base.energies[0], power))) {
            const FairedShape asked = faired(large, order, std::ldexp(tolerance, points), true);
            ASSERT_EQ(asked.energies[0], std::ldexp(base.energies[0], power)) << where(seed, data);
            ASSERT_EQ(asked.energies[1], energy) << where(seed, data);
        } else {
            nurbs *out = nullptr;
            double energies[2];
            ASSERT_EQ(nurbs_fair(create(large).get(), order, nullptr, std::ldexp(tolerance, points), energies,
                                 nullptr, &out),
                      NURBS_ERROR_NOT_REPRESENTABLE);
        }
    });
    EXPECT_GE(moved, of_whole_run(30));
}

// Ends that are kept keep their bits, however small they are beside the rest.
TEST(Fair, keeps_what_it_does_not_move) {
    SplineData data{
        {3}, {6}, {{0, 0, 0, 0, 1, 2, 3, 3, 3, 3}}, 2, {1e-200, 3e-200, 1, 1, 2, -1, 3, 1, 4, -1, 5, 0},
        {},  0};
    for (size_t i = 2; i < data.points.size(); ++i) {
        data.points[i] = std::ldexp(data.points[i], 600);
    }
    const FairedShape found = faired(data, 2, std::ldexp(0.3, 600), false);
    ASSERT_NE(found.data.points, data.points);
    ASSERT_EQ(found.data.points[0], data.points[0]);
    ASSERT_EQ(found.data.points[1], data.points[1]);
}

} // namespace

} // namespace fair_test
