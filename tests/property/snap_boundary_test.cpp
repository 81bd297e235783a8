// Boundaries that are moved onto each other: one curve, and one tangent plane.
#include "property/deform_cases.h"

namespace snap_boundary_test {

using namespace support;
using namespace support::deform;

namespace {

TEST(SnapBoundary, surfaces_meet_with_one_tangent_plane) {
    int refused = 0;
    for_each_case(1580000, 80, [&](Random &random, uint64_t seed) {
        Recipe recipe = calm_recipe(random, 2, 3, 3);
        for (AxisRecipe &axis : recipe.axes) {
            axis.form = random.chance(70) ? KnotForm::clamped : KnotForm::unclamped;
        }
        const SplineData a = random_spline(random, recipe);
        SplineData b = random_spline(random, calm_recipe(random, 2, 3, 3));
        const double scale = extent(a) / extent(b); // shapes of about one size
        std::transform(b.points.begin(), b.points.end(), b.points.begin(),
                       [scale](double x) { return scale * x; });
        const int axis = random.whole(0, 1), other_axis = random.whole(0, 1), end = random.whole(0, 1),
                  other_end = random.whole(0, 1), order = random.whole(0, 1);
        const bool reversed = random.chance(50);
        const Handle g = create(a), f = create(b);
        double bound = -1;
        nurbs *out = nullptr;
        const nurbs_status status = nurbs_snap_boundary(g.get(), axis, end, f.get(), other_axis, other_end,
                                                        order, reversed ? NURBS_REVERSED : 0, &bound, &out);
        const Handle h(out);
        if (b.periodic(other_axis)) {
            ASSERT_EQ(status, NURBS_ERROR_PERIODIC);
            return;
        }
        if (status == NURBS_ERROR_WEIGHT_SIGN) {
            ++refused;
            return;
        }
        ASSERT_EQ(status, NURBS_OK) << last_error() << where(seed, a) << where(seed, b);
        const SplineData after = read_back(h.get());
        const long double size = extent(a) + extent(b);
        long double ratio = -1;
        for (int n = 0; n < 5; ++n) {
            const double part = random.unit();
            const auto along = static_cast<size_t>(1 - axis),
                       other_along = static_cast<size_t>(1 - other_axis);
            std::vector<double> here(2), there(2);
            here[static_cast<size_t>(axis)] = end == 1 ? a.upper(axis) : a.lower(axis);
            here[along] = a.lower(1 - axis) + part * (a.upper(1 - axis) - a.lower(1 - axis));
            there[static_cast<size_t>(other_axis)] =
                other_end == 1 ? b.upper(other_axis) : b.lower(other_axis);
            const double share = reversed ? 1 - part : part;
            there[other_along] =
                b.lower(1 - other_axis) + share * (b.upper(1 - other_axis) - b.lower(1 - other_axis));
            const reference::Sides left{axis == 0 && end == 1, axis == 1 && end == 1},
                other_left{other_axis == 0 && other_end == 1, other_axis == 1 && other_end == 1};
            const auto p = reference::exact_derivatives(after, 1, here.data(), left),
                       q = reference::exact_derivatives(b, 1, there.data(), other_left);
            const auto vector = [](const std::vector<reference::Fraction> &x) {
                std::vector<long double> v;
                for (const reference::Fraction &value : x) {
                    v.push_back(reference::quotient(value.numerator, value.denominator));
                }
                return v;
            };
            const auto on = vector(p[0]), to = vector(q[0]);
            for (size_t c = 0; c < 3; ++c) { // knots along, and parameters, are rounded
                ASSERT_NEAR(static_cast<double>(on[c]), static_cast<double>(to[c]),
                            1e-10 * static_cast<double>(size))
                    << where(seed, a) << where(seed, b);
            }
            if (order == 0) {
                continue;
            }
            const auto across = vector(p[static_cast<size_t>(axis) + 1]),
                       outward = vector(q[static_cast<size_t>(other_axis) + 1]);
            long double dot = 0, own = 0, others = 0;
            for (size_t c = 0; c < 3; ++c) {
                dot += across[c] * outward[c] * (end == 1 ? -1 : 1) * (other_end == 1 ? 1 : -1);
                own += across[c] * across[c];
                others += outward[c] * outward[c];
            }
            ASSERT_GE(dot, std::sqrt(own * others) * (1 - 1e-8L)) << where(seed, a) << where(seed, b);
            const long double here_ratio = std::sqrt(own / others);
            ASSERT_TRUE(ratio < 0 || std::fabs(here_ratio / ratio - 1) < 1e-6L)
                << where(seed, a) << where(seed, b);
            ratio = here_ratio;
        }
        for (int n = 0; n < 5; ++n) {
            const std::vector<double> param = random_params(random, a, 1);
            const std::vector<double> before = eval(g.get(), param), moved = eval(h.get(), param);
            long double gap = 0;
            for (size_t c = 0; c < 3; ++c) {
                gap = std::hypot(gap, static_cast<long double>(before[c]) - moved[c]);
            }
            ASSERT_LE(gap, bound * (1 + 1e-12L) + 1e-12L * size) << where(seed, a) << where(seed, b);
        }
    });
    std::printf("%d refused for their weights\n", refused);
    ASSERT_LE(refused, 20);
}

} // namespace

} // namespace snap_boundary_test
