// Lengths, areas and moments: closed forms, and the laws of integrals.
#include "property/measures.h"

namespace measure_test {

using namespace support;
using namespace support::measures;

namespace {

// One in 1e13, and in fact a few units of rounding.
TEST(Measure, circles_and_ellipses_have_their_lengths_and_areas) {
    for (const int32_t form : {NURBS_ARC_QUARTERS, NURBS_ARC_THIRDS, NURBS_ARC_SMOOTH}) {
        for (const double r : {1.0, 1e-6, 3e6, 1e-150, 1e120}) {
            const Handle circle = ellipse(r, r, form);
            const Measured m = length(circle.get());
            EXPECT_NEAR(m.value / (2 * pi * r), 1, 16 * double_eps) << form << ' ' << r;
            EXPECT_LE(std::fabs(m.value - 2 * pi * r), m.error);
            EXPECT_LE(m.error, 1e-13 * m.value);
            if (r < 1e100 && r > 1e-50) {
                const Body disc = enclosed_area({circle.get()});
                EXPECT_NEAR(disc.content / (pi * r * r), 1, 16 * double_eps);
                EXPECT_NEAR(disc.inertia[0] / (pi / 4 * r * r * r * r), 1, 32 * double_eps);
                EXPECT_NEAR(disc.inertia[3] / (pi / 4 * r * r * r * r), 1, 32 * double_eps);
            }
        }
        for (const double ratio : {0.9, 0.5, 0.1, 1e-3}) {
            const double k = std::sqrt((1 - ratio) * (1 + ratio));
            EXPECT_NEAR(length(ellipse(1, ratio, form).get()).value / (4 * std::comp_ellint_2(k)), 1, 1e-13)
                << form << ' ' << ratio;
            EXPECT_NEAR(enclosed_area({ellipse(1, ratio, form).get()}).content / (pi * ratio), 1, 1e-13);
        }
    }
}

TEST(Measure, spheres_and_tori_have_their_areas_and_volumes) {
    for (const int32_t form : {NURBS_ARC_QUARTERS, NURBS_ARC_THIRDS, NURBS_ARC_SMOOTH}) {
        for (const double r : {1.0, 2e-6, 5e6}) {
            const Handle sphere = ellipsoid(r, r, r, form), ring = torus(3 * r, r, form);
            EXPECT_NEAR(area(sphere.get()).value / (4 * pi * r * r), 1, 1e-13);
            EXPECT_NEAR(area(ring.get()).value / (12 * pi * pi * r * r), 1, 1e-13);
            const Body ball = enclosed_volume({sphere.get()}), solid = enclosed_volume({ring.get()});
            EXPECT_NEAR(ball.content / (4 * pi / 3 * r * r * r), 1, 1e-13);
            EXPECT_NEAR(solid.content / (6 * pi * pi * r * r * r), 1, 1e-13);
            EXPECT_LE(ball.openness, 1e-13 * r * r);
            EXPECT_LE(solid.openness, 1e-12 * r * r);
            for (size_t i = 0; i < 9; ++i) {
                const double unit = i % 4 == 0 ? 1 : 0;
                EXPECT_NEAR(ball.inertia[i] / (0.4 * ball.content * r * r), unit, 1e-13);
            }
            // 5/8 m r^2 + m R^2 / 2 across the axis, m R^2 + 3/4 m r^2 about it
            EXPECT_NEAR(solid.inertia[0] / (solid.content * r * r), 0.625 + 4.5, 1e-12);
            EXPECT_NEAR(solid.inertia[8] / (solid.content * r * r), 9.75, 1e-12);
            const Body shell = moments(sphere.get(), 3);
            EXPECT_NEAR(shell.inertia[4] / (2.0 / 3 * shell.content * r * r), 1, 1e-12);
        }
        for (const double c : {2.0, 100.0}) { // a prolate spheroid along either axis of the parameters
            const double e = std::sqrt(1 - 1 / (c * c)), exact = 2 * pi * (1 + c / e * std::asin(e));
            for (const double tolerance : {1e-6, 1e-10}) {
                for (const Handle &g : {ellipsoid(1, 1, c, form), ellipsoid(c, 1, 1, form)}) {
                    const Measured m = area(g.get(), tolerance);
                    EXPECT_LE(std::fabs(m.value - exact), m.error) << form << ' ' << c;
                    EXPECT_LE(m.error, 4 * tolerance * exact);
                }
            }
        }
    }
}

TEST(Measure, parts_add_up_and_forms_agree) {
    Random random(5522);
    int curves = 0;
    for (int i = 0; i < 150; ++i) {
        const SplineData data = random_spline(random, random_recipe(random, 1, 6));
        Handle g;
        if (try_create(data, g) != NURBS_OK) {
            continue;
        }
        const Measured whole = length(g.get(), 1e-9);
        const double t = random_param(random, data.knots[0], data.degrees[0]);
        const double lower = data.lower(0), upper = data.upper(0);
        ++curves;
        // elevation moves points
        const double allowed =
            4 * whole.error + 64 * double_eps * extent(data) * static_cast<double>(data.counts[0]);
        if (t > lower && t < upper) {
            const double sum =
                length(g.get(), 1e-9, {lower, t}).value + length(g.get(), 1e-9, {t, upper}).value;
            EXPECT_NEAR(sum, whole.value, allowed + 1e-9 * sum) << describe(data);
        }
        if (!data.periodic(0)) { // whose knots may repeat to rounding only
            EXPECT_NEAR(length(elevate(g.get(), 0, 1).get(), 1e-9).value, whole.value, allowed)
                << describe(data);
        }
        const Handle back = made([&](nurbs **out) { return nurbs_reverse(g.get(), 0, 0, out); });
        EXPECT_NEAR(length(back.get(), 1e-9).value, whole.value, allowed) << describe(data);
        EXPECT_NEAR(lengths_at(g.get(), {lower, upper})[1], whole.value, allowed) << describe(data);
    }
    EXPECT_GT(curves, 100);
}

// The six faces of a trilinear volume enclose what the volume holds, and both are polynomials of degree 5.
TEST(Measure, faces_enclose_what_a_volume_holds) {
    Random random(5526);
    for (int i = 0; i < 10; ++i) {
        SplineData data;
        data.degrees = {1, 1, 1};
        data.counts = {2, 2, 2};
        data.knots = {{0, 0, 1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1}};
        data.dim = 3;
        for (int at = 0; at < 8; ++at) {
            for (const int c : {at / 4, at / 2 % 2, at % 2}) {
                data.points.push_back(c + random.between(-0.2, 0.2));
            }
        }
        const Handle g = create(data);
        nurbs_list *list = nullptr;
        require_ok(nurbs_boundaries(g.get(), &list));
        std::vector<Handle> faces;
        std::vector<const nurbs *> all;
        for (int64_t f = 0; f < 6; ++f) {
            nurbs *face = nullptr;
            require_ok(nurbs_list_get(list, f, &face));
            faces.emplace_back(face);
            if (f == 0 || f == 3 || f == 4) { // their normals point inwards
                nurbs *turned = nullptr;
                require_ok(nurbs_reverse(face, 0, 0, &turned));
                faces.emplace_back(turned);
            }
            all.push_back(faces.back().get());
        }
        nurbs_list_destroy(list);
        const Body inside = moments(g.get(), 3), outside = enclosed_volume(all);
        EXPECT_NEAR(outside.content, inside.content, 64 * double_eps);
        EXPECT_LE(outside.openness, 64 * double_eps);
        for (size_t k = 0; k < 3; ++k) {
            EXPECT_NEAR(outside.centroid[k], inside.centroid[k], 64 * double_eps);
        }
        for (size_t k = 0; k < 9; ++k) {
            EXPECT_NEAR(outside.inertia[k], inside.inertia[k], 64 * double_eps);
        }
    }
}

// Pappus: the area of a surface of revolution is the length of its profile times the way of its centroid.
TEST(Measure, wires_and_sheets_obey_pappus) {
    Random random(5527);
    for (int i = 0; i < 10; ++i) {
        SplineData data = tangle(random, 3, 6, 3, random.chance(50));
        for (size_t k = 0; k < data.points.size(); k += 3) {
            data.points[k] += 2;
            data.points[k + 1] = 0;
        }
        const Handle profile = create(data);
        const Handle surface = made([&](nurbs **out) {
            return nurbs_revolve(profile.get(), origin, up, 2 * pi, NURBS_ARC_QUARTERS, out);
        });
        const Body wire = moments(profile.get(), 3);
        EXPECT_NEAR(wire.content, length(profile.get()).value, 1e-12 * wire.content);
        EXPECT_NEAR(area(surface.get(), 1e-10).value, 2 * pi * wire.centroid[0] * wire.content, 1e-9);
    }
}

// A bilinear patch of the plane whose determinant is 1 + 0.7 u - 1.5 v: its magnitude has a kink along a line
// that no halving meets. What cannot be reached is refused, but 0 asks for what can.
TEST(Measure, a_fold_is_measured_as_well_as_the_work_limit_allows) {
    const double exact = 0.6 + 0.25 / 6.3;
    for (const bool space : {false, true}) {
        SplineData data;
        data.degrees = {1, 1};
        data.counts = {2, 2};
        data.knots = {{0, 0, 1, 1}, {0, 0, 1, 1}};
        data.dim = space ? 3 : 2;
        for (const auto &[x, y] : {std::pair{0.0, 0.0}, {0.0, 1.0}, {1.0, 0.0}, {-0.5, 1.7}}) {
            data.points.insert(data.points.end(), {x, y});
            data.points.resize(data.points.size() + (space ? 1 : 0));
        }
        const Handle g = create(data);
        const Measured best = area(g.get());
        EXPECT_LE(std::fabs(best.value - exact), best.error);
        EXPECT_LE(best.error, 1e-8);
        const Body sheet = moments(g.get(), data.dim, 0);
        EXPECT_LE(std::fabs(sheet.content - exact), sheet.error);
        EXPECT_LE(sheet.error, 1e-5);
        double value = -1, error = -1;
        EXPECT_EQ(nurbs_surface_area(g.get(), nullptr, 1e-14, &value, &error), NURBS_ERROR_NOT_CONVERGED);
        EXPECT_EQ(value, -1);
        EXPECT_EQ(error, -1);
    }
}

TEST(Measure, parts_of_surfaces_add_up) {
    Random random(5528);
    int surfaces = 0;
    for (int i = 0; i < 40; ++i) {
        Recipe recipe = random_recipe(random, 2, 3);
        recipe.weights = random.chance(50) ? Weights::none : Weights::moderate;
        const SplineData data = random_spline(random, recipe);
        Handle g;
        Measured whole;
        if (try_create(data, g) != NURBS_OK || data.dim < 2 ||
            nurbs_surface_area(g.get(), nullptr, 1e-5, &whole.value, &whole.error) != NURBS_OK) {
            continue;
        }
        ++surfaces;
        const double u = (data.lower(0) + data.upper(0)) / 2, v = (data.lower(1) + data.upper(1)) / 2;
        double sum = 0;
        for (const bool high : {false, true}) {
            for (const bool far : {false, true}) {
                sum += area(g.get(), 1e-5,
                            {high ? u : data.lower(0), high ? data.upper(0) : u, far ? v : data.lower(1),
                             far ? data.upper(1) : v})
                           .value;
            }
        }
        EXPECT_NEAR(sum, whole.value, 3e-5 * whole.value + 1e-13 * extent(data) * extent(data))
            << describe(data);
    }
    EXPECT_GT(surfaces, 15);
}

// Without a jump there is no end that rounding could keep from its start.
TEST(Measure, periodic_curves_enclose_without_a_tolerance) {
    Random random(5531);
    int continuous = 0;
    for (int i = 0; i < 300; ++i) {
        Recipe recipe{{random_axis(random, random.whole(1, 5))}};
        recipe.axes[0].form = KnotForm::periodic;
        recipe.axes[0].placement = Placement::origin;
        recipe.axes[0].spacing = random.chance(50) ? Spacing::integers : Spacing::full;
        recipe.dim = 2;
        recipe.weights = random.chance(50) ? Weights::none : Weights::moderate;
        const SplineData data = random_spline(random, recipe);
        const std::vector<double> &knots = data.knots[0];
        const auto copies = static_cast<size_t>(data.degrees[0]) + 1;
        bool jumps = false;
        for (size_t k = 0; k + copies <= knots.size(); ++k) {
            jumps = jumps || knots[k] == knots[k + copies - 1];
        }
        if (jumps) {
            continue;
        }
        ++continuous;
        const Handle g = create(data);
        const nurbs *curve = g.get();
        double area = 0, error = 0;
        ASSERT_EQ(nurbs_enclosed_area(1, &curve, 0, 1e-9, &area, nullptr, nullptr, &error), NURBS_OK)
            << last_error() << describe(data);
        const Handle open = made([&](nurbs **out) {
            return nurbs_clamp_ends(g.get(), 0, NURBS_FORM_CLAMPED_START | NURBS_FORM_CLAMPED_END, out);
        });
        const nurbs *cut = open.get();
        double again = 0;
        require_ok(
            nurbs_enclosed_area(1, &cut, 1e-9 * extent(data), 1e-9, &again, nullptr, nullptr, nullptr));
        ASSERT_NEAR(area, again, 4 * error + 1e-9 * (std::fabs(area) + extent(data) * extent(data)))
            << describe(data);
    }
    ASSERT_GT(continuous, 100);
}

} // namespace

} // namespace measure_test
