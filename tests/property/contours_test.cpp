// Contours, algebraic levels and level curves of surfaces: closed forms, sections by another way, and functions that have to
// change their sign on branches only.
#include "sections.h"
#include "support/cases.h"

#include <functional>
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

SplineData tame_surface(Random &random, int least_degree = 0) {
    Recipe recipe = random_recipe(random, 2, 3);
    recipe.dim = 3;
    recipe.weights = random.chance(50) ? Weights::moderate : Weights::none;
    for (AxisRecipe &axis : recipe.axes) {
        axis.spacing = Spacing::few_bits;
        axis.placement = Placement::origin;
        axis.degree = std::max(axis.degree, least_degree);
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

Point3 cross(const Point3 &a, const Point3 &b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// A point of a surface and its normal, not of length 1.
struct Facet {
    Point3 point, normal;
};
Facet facet_at(const nurbs *g, const Place &at) {
    std::array<double, 9> jet{};
    require_ok(nurbs_eval_derivs(g, 1, 1, at.data(), 0, 0, jet.data(), 0, 0, 0));
    return {{jet[0], jet[1], jet[2]}, cross({jet[3], jet[4], jet[5]}, {jet[6], jet[7], jet[8]})};
}
using FacetFunction = std::function<double(const Facet &)>;

// Whether the surface may have a crease between two parameters.
bool has_crease(const SplineData &data, size_t axis, double from, double to) {
    const std::vector<double> &knots = data.knots[axis];
    return std::ranges::any_of(knots, [&](double knot) {
        return knot >= from && knot <= to && std::ranges::count(knots, knot) >= data.degrees[axis];
    });
}

} // namespace

namespace {

struct Tally {
    int64_t complete = 0, changes = 0;
};

void expect_on_surface(const SplineData &data, const nurbs *g, const Found &found) {
    const Ground ground(g, data);
    for (const Branch &branch : found.branches) {
        const std::vector<double> t = branch.params(50);
        const std::vector<Point3> in_space = points_on(branch.space.get(), t);
        const std::vector<Place> on = places_on(branch.on.get(), t);
        for (size_t i = 0; i < t.size(); ++i) {
            ASSERT_TRUE(ground.contains(on[i]));
            ASSERT_LE(ground.gap(on[i], in_space[i]), 2 * branch.deviation + 1e-9 * extent(data));
        }
    }
}

bool in_touch(const Found &found, double u, double from, double to) {
    return std::ranges::any_of(found.nodes, [&](const MeetPart &node) {
        return node.kind == NURBS_NODE_TOUCH && node.range[0][0] <= u && u <= node.range[0][1] &&
               node.range[1][0] <= to && from <= node.range[1][1];
    });
}

// Between samples on the isoparametric line at which f differs in sign there is a branch, or a touch along a crease.
void expect_changes_on(const SplineData &data, const nurbs *g, const Found &found, double u,
                       const FacetFunction &f, Tally &tally) {
    constexpr int samples = 150;
    const double step = (data.upper(1) - data.lower(1)) / (samples + 1);
    Facet before{};
    for (int i = 0; i <= samples; ++i) {
        const Place at{u, data.lower(1) + step * (i + 0.5)};
        const Facet now = facet_at(g, at);
        if (i > 0 && f(before) * f(now) < 0 && !has_crease(data, 1, at[1] - step, at[1]) &&
            !in_touch(found, u, at[1] - step, at[1])) {
            ++tally.changes;
            double least = HUGE_VAL;
            for (const Branch &branch : found.branches) {
                double away = 0;
                require_ok(nurbs_closest_points(branch.space.get(), 1, now.point.data(), 0, 0, nullptr, 0, 0,
                                                nullptr, 0, 0, nullptr, 0, 0, &away, 0, nullptr, 0));
                least = std::min(least, away);
            }
            ASSERT_LE(least, 4 * distance(now.point, before.point) + 1e-3 * extent(data))
                << "at " << at[0] << ", " << at[1];
        }
        before = now;
    }
}

void expect_all_changes(Random &random, const SplineData &data, const nurbs *g, const Found &found,
                        const FacetFunction &f, Tally &tally) {
    expect_on_surface(data, g, found);
    tally.complete += found.complete ? 1 : 0;
    if (!found.complete) {
        return;
    }
    for (int line = 0; line < 10; ++line) {
        expect_changes_on(data, g, found, random.between(data.lower(0), data.upper(0)), f, tally);
    }
}

} // namespace

TEST(Contours, of_random_surfaces_miss_no_change_of_sign) {
    Tally tally;
    for_each_case(3400000, 60, [&](Random &random, uint64_t seed) {
        const SplineData data = tame_surface(random, random.chance(10) ? 0 : 1);
        SCOPED_TRACE(where(seed, data));
        const Handle g = create(data);
        const Point3 d = unit(random_vector(random));
        const Found found = contours_of(g.get(), NURBS_CONTOUR_SILHOUETTE, d, {}, 1e-4 * extent(data));
        expect_all_changes(
            random, data, g.get(), found, [&](const Facet &facet) { return dot(facet.normal, d); }, tally);
    });
    EXPECT_GE(tally.complete, 50 * scale());
    EXPECT_GE(tally.changes, 100 * scale());
}

namespace {

Point3 along(const Point3 &from, double by, const Point3 &d) {
    return {from[0] + by * d[0], from[1] + by * d[1], from[2] + by * d[2]};
}

// The directions in which a light seen by reflection lies (Householder's formula), or the normal for highlight lines.
Point3 to_light(int32_t kind, const Facet &facet, const Point3 &eye) {
    if (kind == NURBS_REFLECTION_HIGHLIGHT) {
        return facet.normal;
    }
    const Point3 v = kind == NURBS_REFLECTION_ALONG ? eye : minus(facet.point, eye);
    return along(v, -2 * dot(facet.normal, v) / dot(facet.normal, facet.normal), facet.normal);
}

Place random_place(Random &random, const SplineData &data) {
    return {random.between(data.lower(0), data.upper(0)), random.between(data.lower(1), data.upper(1))};
}

} // namespace

TEST(Reflections, of_random_surfaces_miss_no_change_of_sign) {
    Tally tally;
    for_each_case(3450000, 60, [&](Random &random, uint64_t seed) {
        const SplineData data = tame_surface(random, random.chance(10) ? 0 : 1);
        SCOPED_TRACE(where(seed, data));
        const Handle g = create(data);
        const double size = extent(data);
        const int32_t kind = random.whole(NURBS_REFLECTION_HIGHLIGHT, NURBS_REFLECTION_FROM);
        const Point3 l = unit(random_vector(random)), origin{};
        const Point3 eye = kind == NURBS_REFLECTION_ALONG ? unit(random_vector(random))
                                                          : along(origin, 3 * size, random_vector(random));
        // The line of light is one that a place of the surface reflects, or else most surfaces show none.
        const Facet shown = facet_at(g.get(), random_place(random, data));
        const bool flat = dot(shown.normal, shown.normal) == 0;
        const Point3 a =
            along(shown.point, 3 * size, unit(flat ? random_vector(random) : to_light(kind, shown, eye)));
        nurbs_meet *meet = nullptr;
        require_ok(nurbs_surface_reflections(g.get(), kind, eye.data(), l.data(), 1, a.data(), 0, 0,
                                             1e-4 * size, &meet));
        const Found found = found_in(MeetHandle(meet).get());
        expect_all_changes(
            random, data, g.get(), found,
            [&](const Facet &facet) {
                return dot(to_light(kind, facet, eye), cross(minus(facet.point, a), l));
            },
            tally);
    });

    EXPECT_GE(tally.complete, 45 * scale());
    EXPECT_GE(tally.changes, 100 * scale());
}

// Normals of a surface of revolution meet its axis; those of a ball meet any line in the plane of the centre and the line.
TEST(Reflections, highlight_lines_are_circular_silhouettes) {
    nurbs *made = nullptr;
    const double turn = 2 * std::numbers::pi;
    const Point3 up{0, 0, 1}, origin{}, aside{0.5, 0.25, 0};
    require_ok(
        nurbs_surface_torus(nullptr, nullptr, nullptr, 2, 0.5, 0, turn, 0, turn, NURBS_ARC_THIRDS, &made));
    const Handle torus(made);
    nurbs_meet *meet = nullptr;
    require_ok(nurbs_surface_reflections(torus.get(), NURBS_REFLECTION_HIGHLIGHT, nullptr, up.data(), 1,
                                         origin.data(), 0, 0, 1e-6, &meet));
    const Found all = found_in(MeetHandle(meet).get());
    EXPECT_EQ(all.branches.size(), 0U);
    EXPECT_EQ(all.count(NURBS_NODE_TOUCH), 1);
    // Normals of the torus and the line are in one plane through both axes, or along the highest and lowest circles.
    require_ok(nurbs_surface_reflections(torus.get(), NURBS_REFLECTION_HIGHLIGHT, nullptr, up.data(), 1,
                                         aside.data(), 0, 0, 1e-6, &meet));
    const Found found = found_in(MeetHandle(meet).get());
    EXPECT_TRUE(found.complete);
    EXPECT_GE(found.branches.size(), 4U);
    for (const Branch &branch : found.branches) {
        for (const Point3 &x : points_on(branch.space.get(), branch.params(100))) {
            const double off_plane =
                             std::abs(x[1] * aside[0] - x[0] * aside[1]) / std::hypot(aside[0], aside[1]),
                         off_circle = std::hypot(std::abs(x[2]) - 0.5, std::hypot(x[0], x[1]) - 2);
            EXPECT_LE(std::min(off_plane, off_circle), branch.deviation + 1e-12);
        }
    }
    EXPECT_NEAR(length_of(found), 2 * 2 * turn + 2 * 0.5 * turn, 1e-2); // nodes are where they cross
}

} // namespace contours_test
