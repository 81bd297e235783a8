// Contours, algebraic levels and level curves of surfaces: closed forms, sections by another way, and functions that have to
// change their sign on branches only.
#include "sections.h"
#include "support/cases.h"

#include <numbers>

namespace contours_test {

using namespace surface_sections;

namespace {

Found contours_of(const nurbs *g, int32_t kind, const Point3 &d, const std::vector<double> &cosines,
                  double tolerance) {
    nurbs_meet *meet = nullptr;
    require_ok(nurbs_surface_contours(g, kind, d.data(), static_cast<int64_t>(cosines.size()), cosines.data(),
                                      tolerance, &meet));
    return found_in(MeetHandle(meet).get());
}
Found level_of(const nurbs *g, int32_t degree, const std::vector<double> &coefficients, double tolerance) {
    nurbs_meet *meet = nullptr;
    require_ok(nurbs_surface_level(g, degree, coefficients.data(), tolerance, &meet));
    return found_in(MeetHandle(meet).get());
}
Found level_curves_of(const nurbs *g, const nurbs *scalar, const std::vector<double> &values,
                      double tolerance) {
    nurbs_meet *meet = nullptr;
    require_ok(nurbs_surface_level_curves(g, scalar, static_cast<int64_t>(values.size()), values.data(),
                                          tolerance, &meet));
    return found_in(MeetHandle(meet).get());
}

Point3 minus(const Point3 &a, const Point3 &b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Point3 unit(const Point3 &d) {
    const double length = std::sqrt(dot(d, d));
    return {d[0] / length, d[1] / length, d[2] / length};
}
Point3 random_vector(Random &random) {
    return {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
}

struct Sphere {
    Point3 centre, axis, x;
    double radius;
    Handle g;

    explicit Sphere(Random &random)
        : centre(random_vector(random)), axis(random_vector(random)), x(random_vector(random)),
          radius(random.between(0.5, 2)) {
        nurbs *made = nullptr;
        require_ok(
            nurbs_surface_sphere(centre.data(), axis.data(), x.data(), radius, NURBS_ARC_QUARTERS, &made));
        g = Handle(made);
    }
};

// Circles on the sphere, where (x - centre) . d = height.
void expect_circle(const Sphere &sphere, const Found &found, int64_t level, const Point3 &d, double height) {
    double length = 0;
    for (const Branch &branch : found.branches) {
        if (branch.level != level) {
            continue;
        }
        EXPECT_GE(branch.loop, 0);
        for (const Point3 &x : points_on(branch.space.get(), branch.params(100))) {
            EXPECT_NEAR(dot(minus(x, sphere.centre), d), height, branch.deviation + 1e-12);
            EXPECT_NEAR(distance(x, sphere.centre), sphere.radius, branch.deviation + 1e-12);
        }
        double own = 0;
        require_ok(nurbs_curve_length(branch.space.get(), nullptr, 1e-9, &own, nullptr));
        length += own;
    }
    const double radius = std::sqrt(sphere.radius * sphere.radius - height * height);
    EXPECT_NEAR(length, 2 * std::numbers::pi * radius, 1e-3);
}

} // namespace

TEST(Contours, of_spheres_are_circles) {
    for_each_case(3200000, 40, [](Random &random, uint64_t seed) {
        SCOPED_TRACE(seed);
        const Sphere sphere(random);
        const Point3 d = unit(random_vector(random));
        const Found outline = contours_of(sphere.g.get(), NURBS_CONTOUR_SILHOUETTE, d, {}, 1e-6);
        EXPECT_TRUE(outline.complete);
        EXPECT_EQ(outline.loops(), 1);
        expect_circle(sphere, outline, 0, d, 0);

        const double far = random.between(1.1, 4) * sphere.radius;
        const Point3 eye{sphere.centre[0] + far * d[0], sphere.centre[1] + far * d[1],
                         sphere.centre[2] + far * d[2]};
        const Found seen = contours_of(sphere.g.get(), NURBS_CONTOUR_PERSPECTIVE, eye, {}, 1e-6);
        EXPECT_TRUE(seen.complete);
        EXPECT_EQ(seen.loops(), 1);
        expect_circle(sphere, seen, 0, d, sphere.radius * sphere.radius / far);

        // Normals of the library's spheres point outwards.
        const std::vector<double> cosines{0.3, -0.6, 0};
        const Found isophotes = contours_of(sphere.g.get(), NURBS_CONTOUR_ISOPHOTE,
                                            {5 * d[0], 5 * d[1], 5 * d[2]}, cosines, 1e-6);
        EXPECT_TRUE(isophotes.complete);
        EXPECT_EQ(isophotes.loops(), 3);
        for (size_t i = 0; i < cosines.size(); ++i) {
            expect_circle(sphere, isophotes, static_cast<int64_t>(i), d, sphere.radius * cosines[i]);
        }
        EXPECT_EQ(contours_of(sphere.g.get(), NURBS_CONTOUR_PARABOLIC, d, {}, 1e-6).branches.size(), 0U);
    });
}

TEST(Contours, parabolic_curves_of_a_torus_are_its_highest_circles) {
    nurbs *made = nullptr;
    const double turn = 2 * std::numbers::pi;
    require_ok(
        nurbs_surface_torus(nullptr, nullptr, nullptr, 2, 0.5, 0, turn, 0, turn, NURBS_ARC_THIRDS, &made));
    const Handle torus(made);
    const Found found = contours_of(torus.get(), NURBS_CONTOUR_PARABOLIC, {0, 0, 1}, {}, 1e-6);
    EXPECT_TRUE(found.complete);
    EXPECT_EQ(found.loops(), 2);
    for (const Branch &branch : found.branches) {
        for (const Point3 &x : points_on(branch.space.get(), branch.params(100))) {
            EXPECT_NEAR(std::abs(x[2]), 0.5, branch.deviation + 1e-12);
            EXPECT_NEAR(std::hypot(x[0], x[1]), 2, branch.deviation + 1e-12);
        }
    }
    EXPECT_NEAR(length_of(found), 2 * 2 * turn, 1e-4);
}

// A cylinder seen along its axis is an outline all over.
TEST(Contours, where_the_function_vanishes_all_over_are_a_touch) {
    nurbs *made = nullptr;
    require_ok(nurbs_surface_cylinder(nullptr, nullptr, nullptr, 1, 2, 0, 2 * std::numbers::pi,
                                      NURBS_ARC_QUARTERS, &made));
    const Handle cylinder(made);
    const Found along = contours_of(cylinder.get(), NURBS_CONTOUR_SILHOUETTE, {0, 0, 1}, {}, 1e-6);
    EXPECT_TRUE(along.complete);
    EXPECT_EQ(along.branches.size(), 0U);
    ASSERT_EQ(along.nodes.size(), 1U);
    EXPECT_EQ(along.nodes[0].kind, NURBS_NODE_TOUCH);
    EXPECT_EQ(along.nodes[0].range[1], (Place{0, 1}));
    const Found across = contours_of(cylinder.get(), NURBS_CONTOUR_SILHOUETTE, {1, 0, 0}, {}, 1e-6);
    EXPECT_EQ(across.branches.size(), 2U);
    EXPECT_NEAR(length_of(across), 4, 1e-9);
}

TEST(Levels, of_a_sphere_and_a_cylinder_through_its_centre_are_the_curve_of_viviani) {
    nurbs *made = nullptr;
    require_ok(nurbs_surface_sphere(nullptr, nullptr, nullptr, 2, NURBS_ARC_QUARTERS, &made));
    const Handle sphere(made);
    const Found found = level_of(sphere.get(), 2, {1, 0, 0, -2, 1, 0, 0, 0, 0, 0}, 1e-7);
    EXPECT_TRUE(found.complete);
    EXPECT_EQ(found.count(NURBS_NODE_TOUCH),
              3); // where it crosses itself, and both poles, through which it runs
    for (const Branch &branch : found.branches) {
        for (const Point3 &x : points_on(branch.space.get(), branch.params(100))) {
            EXPECT_NEAR(std::hypot(x[0] - 1, x[1]), 1, branch.deviation + 1e-12);
            EXPECT_NEAR(std::hypot(x[0], x[1], x[2]), 2, branch.deviation + 1e-12);
        }
    }
    EXPECT_NEAR(length_of(found), 15.280790156219, 1e-4);
    const Found itself = level_of(sphere.get(), 2, {1, 0, 0, 0, 1, 0, 0, 1, 0, -4}, 1e-7);
    EXPECT_EQ(itself.branches.size(), 0U);
    EXPECT_EQ(itself.count(NURBS_NODE_TOUCH), 1);
}

namespace {

SplineData tame_surface(Random &random) {
    Recipe recipe = random_recipe(random, 2, 3);
    recipe.dim = 3;
    recipe.weights = random.chance(50) ? Weights::moderate : Weights::none;
    for (AxisRecipe &axis : recipe.axes) {
        axis.spacing = Spacing::few_bits;
        axis.placement = Placement::origin;
    }
    return random_spline(random, recipe);
}

// The coordinate x . normal as a spline with the same knots and weights.
Handle height_of(const SplineData &data, const Point3 &normal) {
    SplineData scalar = data;
    scalar.dim = 1;
    scalar.points.clear();
    for (size_t i = 0; i < data.points.size(); i += 3) {
        scalar.points.push_back(dot(normal, {data.points[i], data.points[i + 1], data.points[i + 2]}));
    }
    return create(scalar);
}

void expect_same(const Found &a, const Found &b, double near) {
    EXPECT_EQ(a.branches.size(), b.branches.size());
    EXPECT_EQ(a.loops(), b.loops());
    EXPECT_NEAR(length_of(a), length_of(b), near);
}

} // namespace

TEST(Levels, of_planes_and_of_heights_are_sections) {
    int64_t compared = 0;
    for_each_case(3300000, 100, [&](Random &random, uint64_t seed) {
        const SplineData data = tame_surface(random);
        SCOPED_TRACE(where(seed, data));
        const Handle g = create(data);
        const double size = extent(data);
        const Point3 normal = unit(random_vector(random));
        Point3 x{};
        const Place at{random.between(data.lower(0), data.upper(0)),
                       random.between(data.lower(1), data.upper(1))};
        require_ok(nurbs_eval(g.get(), 1, at.data(), 0, 0, x.data(), 0, 0, 0));
        const double offset = dot(normal, x), tolerance = 1e-5 * size;
        const Found section = sections_of(g.get(), normal, {offset}, tolerance);
        const Found plane = level_of(g.get(), 1, {normal[0], normal[1], normal[2], -offset}, tolerance);
        const Found height = level_curves_of(g.get(), height_of(data, normal).get(), {offset}, tolerance);
        const bool simple = section.count(NURBS_NODE_TOUCH) + plane.count(NURBS_NODE_TOUCH) == 0;
        if (section.complete && plane.complete && height.complete && simple) {
            ++compared;
            expect_same(section, plane, 1e-2 * size);
            expect_same(section, height, 1e-2 * size);
        }
    });
    EXPECT_GE(compared, 60 * scale());
}

namespace {

// N . d, N not of length 1.
double facing(const nurbs *g, const Place &at, const Point3 &d) {
    std::array<double, 9> jet{};
    require_ok(nurbs_eval_derivs(g, 1, 1, at.data(), 0, 0, jet.data(), 0, 0, 0));
    const Point3 u{jet[3], jet[4], jet[5]}, v{jet[6], jet[7], jet[8]};
    return d[0] * (u[1] * v[2] - u[2] * v[1]) + d[1] * (u[2] * v[0] - u[0] * v[2]) +
           d[2] * (u[0] * v[1] - u[1] * v[0]);
}

// Whether the surface may have a crease between two parameters.
bool has_crease(const SplineData &data, size_t axis, double from, double to) {
    const std::vector<double> &knots = data.knots[axis];
    return std::ranges::any_of(knots, [&](double knot) {
        return knot >= from && knot <= to && std::ranges::count(knots, knot) >= data.degrees[axis];
    });
}

} // namespace

// Between samples on an isoparametric line at which N . d differs in sign there is a branch.
TEST(Contours, of_random_surfaces_miss_no_change_of_sign) {
    int64_t complete = 0, changes = 0;
    for_each_case(3400000, 60, [&](Random &random, uint64_t seed) {
        const SplineData data = tame_surface(random);
        SCOPED_TRACE(where(seed, data));
        const Handle g = create(data);
        const Point3 d = unit(random_vector(random));
        const Found found = contours_of(g.get(), NURBS_CONTOUR_SILHOUETTE, d, {}, 1e-4 * extent(data));
        const Ground ground(g.get(), data);
        for (const Branch &branch : found.branches) {
            const std::vector<double> t = branch.params(50);
            const std::vector<Point3> in_space = points_on(branch.space.get(), t);
            const std::vector<Place> on = places_on(branch.on.get(), t);
            for (size_t i = 0; i < t.size(); ++i) {
                ASSERT_TRUE(ground.contains(on[i]));
                ASSERT_LE(ground.gap(on[i], in_space[i]), 2 * branch.deviation + 1e-9 * extent(data));
            }
        }
        complete += found.complete ? 1 : 0;
        if (!found.complete || found.count(NURBS_NODE_TOUCH) > 0) {
            return;
        }
        const double u = random.between(data.lower(0), data.upper(0));
        constexpr int samples = 300;
        double last = 0;
        for (int i = 0; i <= samples; ++i) {
            const Place at{u, data.lower(1) + (data.upper(1) - data.lower(1)) * (i + 0.5) / (samples + 1)};
            const double now = facing(g.get(), at, d);
            const double before_v = at[1] - (data.upper(1) - data.lower(1)) / (samples + 1);
            if (i > 0 && last * now < 0 && !has_crease(data, 1, before_v, at[1])) {
                ++changes;
                Point3 x{};
                require_ok(nurbs_eval(g.get(), 1, at.data(), 0, 0, x.data(), 0, 0, 0));
                double least = HUGE_VAL;
                for (const Branch &branch : found.branches) {
                    double away = 0;
                    require_ok(nurbs_closest_points(branch.space.get(), 1, x.data(), 0, 0, nullptr, 0, 0,
                                                    nullptr, 0, 0, nullptr, 0, 0, &away, 0, nullptr, 0));
                    least = std::min(least, away);
                }
                Place before = at;
                before[1] = before_v;
                Point3 y{};
                require_ok(nurbs_eval(g.get(), 1, before.data(), 0, 0, y.data(), 0, 0, 0));
                ASSERT_LE(least, 4 * distance(x, y) + 1e-3 * extent(data)) << "at " << at[0] << ", " << at[1];
            }
            last = now;
        }
    });
    EXPECT_GE(complete, 50 * scale());
    EXPECT_GE(changes, 10 * scale());
}

} // namespace contours_test
