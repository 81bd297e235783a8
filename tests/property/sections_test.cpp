// Sections of surfaces by planes: known curves, tangential planes, borders and corners, and the same surface in other
// forms.
#include "sections.h"
#include "support/cases.h"

#include <numbers>

namespace sections_test {

using namespace surface_sections;

namespace {

constexpr double pi = std::numbers::pi;
constexpr Point3 x_axis{1, 0, 0}, y_axis{0, 1, 0}, z_axis{0, 0, 1};

Handle sphere(double radius, const Point3 &centre = {}) {
    return made([&](nurbs **out) {
        return nurbs_surface_sphere(centre.data(), nullptr, nullptr, radius, NURBS_ARC_QUARTERS, out);
    });
}
Handle cylinder() { // radius 1, height 2
    return made([](nurbs **out) {
        return nurbs_surface_cylinder(nullptr, nullptr, nullptr, 1, 2, 0, 2 * pi, NURBS_ARC_QUARTERS, out);
    });
}
Handle torus() { // radii 3 and 1
    return made([](nurbs **out) {
        return nurbs_surface_torus(nullptr, nullptr, nullptr, 3, 1, 0, 2 * pi, 0, 2 * pi, NURBS_ARC_QUARTERS,
                                   out);
    });
}

// Bilinear patches over points (i, j, heights[i][j]).
Handle terrain(const std::vector<std::vector<double>> &heights) {
    SplineData data{{1, 1}, {std::ssize(heights), std::ssize(heights[0])}, {{0}, {0}}, 3, {}, {}, 0};
    for (size_t k = 0; k < 2; ++k) {
        for (int64_t i = 0; i < data.counts[k]; ++i) {
            data.knots[k].push_back(static_cast<double>(i));
        }
        data.knots[k].push_back(data.knots[k].back());
    }
    for (size_t i = 0; i < heights.size(); ++i) {
        for (size_t j = 0; j < heights[i].size(); ++j) {
            data.points.insert(data.points.end(),
                               {static_cast<double>(i), static_cast<double>(j), heights[i][j]});
        }
    }
    return create(data);
}

Point3 random_direction(Random &random) {
    for (;;) {
        const Point3 x{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
        const double length = std::sqrt(dot(x, x));
        if (length > 0.1 && length < 1) {
            return {x[0] / length, x[1] / length, x[2] / length};
        }
    }
}
Point3 cross(const Point3 &a, const Point3 &b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Point3 minus(const Point3 &a, const Point3 &b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

// Open branches, but for small ones that begin and end in one touch.
int64_t open_branches(const Found &found) {
    return std::ranges::count_if(found.branches, [&](const Branch &branch) {
        return branch.loop < 0 && (branch.nodes[0] != branch.nodes[1] || branch.domain[1] > 0.01);
    });
}
// loops, branches that are of none, touches; complete.
void expect_found(const Found &found, int64_t loops, int64_t open, int64_t touches) {
    EXPECT_TRUE(found.complete);
    EXPECT_EQ(found.loops(), loops);
    EXPECT_EQ(open_branches(found), open);
    EXPECT_EQ(found.count(NURBS_NODE_TOUCH), touches);
}

// Branches lie on a circle about the axis through the centre, and run anticlockwise as seen from its tip.
void expect_circle(const Found &found, const Point3 &centre, const Point3 &axis, double radius,
                   double noise) {
    double turned = 0;
    for (const Branch &branch : found.branches) {
        const std::vector<Point3> points = points_on(branch.space.get(), branch.params(1000));
        for (size_t i = 0; i < points.size(); ++i) {
            const Point3 x = minus(points[i], centre);
            const double height = dot(x, axis),
                         from_axis = std::sqrt(std::max(dot(x, x) - height * height, 0.0));
            ASSERT_LE(std::hypot(height, from_axis - radius), branch.deviation + noise);
            if (i > 0) {
                turned += dot(cross(minus(points[i - 1], centre), x), axis);
            }
        }
    }
    EXPECT_NEAR(turned, 2 * pi * radius * radius, 0.01 * radius * radius + noise * radius);
}

} // namespace

TEST(Sections, of_spheres_are_circles_with_the_body_on_their_left) {
    for_each_case(3120000, 60, [](Random &random, uint64_t) {
        const double radius = random.magnitude(1e-6, 1e6), height = radius * random.between(-0.99, 0.99);
        const Point3 centre{radius * random.between(-5, 5), radius * random.between(-5, 5),
                            radius * random.between(-5, 5)};
        const Point3 normal = random_direction(random);
        const double tolerance = radius * random.magnitude(1e-9, 1e-3), offset = dot(normal, centre) + height;
        const Handle g = sphere(radius, centre);
        const Found found = sections_of(g.get(), normal, {offset}, tolerance);
        expect_found(found, 1, 0, 0);
        const Point3 middle{centre[0] + height * normal[0], centre[1] + height * normal[1],
                            centre[2] + height * normal[2]};
        expect_circle(found, middle, normal, std::sqrt(radius * radius - height * height), 1e-13 * radius);
        for (const Branch &branch : found.branches) {
            EXPECT_LE(branch.deviation, tolerance);
            EXPECT_EQ(branch.level, 0);
        }
    });
}

TEST(Sections, of_tangential_planes_are_touches) {
    const Handle ball = sphere(1);
    for (const Point3 &normal :
         {x_axis, y_axis, z_axis, Point3{0, 0, -1}, Point3{-1, 0, 0}, Point3{0.6, 0.8, 0}}) {
        SCOPED_TRACE(normal[0]);
        expect_found(sections_of(ball.get(), normal, {1}, 1e-6), 0, 0, 1);
        expect_found(sections_of(ball.get(), normal, {1 - 1e-7}, 1e-6), 0, 0, 1);
        expect_found(sections_of(ball.get(), normal, {1 + 5e-6}, 1e-6), 0, 0, 0);
        expect_found(sections_of(ball.get(), normal, {1 - 1e-5}, 1e-6), 1, 0, 0);
    }
    const MeetPart top = sections_of(ball.get(), z_axis, {1}, 1e-6).nodes.front();
    EXPECT_EQ(top.range[0], (surface_sections::Place{0, 1}));
    EXPECT_EQ(top.range[1][1], 1);
    EXPECT_GT(top.range[1][0], 0.99);
    const MeetPart east = sections_of(ball.get(), x_axis, {1}, 1e-6).nodes.front();
    EXPECT_NEAR(east.range[0][0], 1, 1e-3); // it runs beyond the seam
    EXPECT_NEAR(east.range[0][1], 1, 1e-3);
    EXPECT_LT(east.range[0][0], 1);
    EXPECT_GT(east.range[0][1], 1);
}

// Through the pole, where one side of the surface is a point.
TEST(Sections, go_through_poles) {
    const Handle ball = sphere(1);
    for (const double u : {1.0, 0.5, 0.25, -0.75}) {
        const Found found = sections_of(ball.get(), {u, 0.3, 1}, {1}, 1e-6);
        EXPECT_TRUE(found.complete);
        EXPECT_EQ(found.count(NURBS_NODE_TOUCH), 1);
        for (const MeetPart &node : found.nodes) {
            EXPECT_TRUE(node.kind != NURBS_NODE_TOUCH || node.range[1][1] == 1);
        }
        double length = 0;
        for (const Branch &branch : found.branches) {
            length += branch.domain[1] - branch.domain[0];
        }
        const double size = std::sqrt(u * u + 0.09 + 1), radius = std::sqrt(1 - 1 / (size * size));
        EXPECT_NEAR(length, 2 * pi * radius, 0.01);
    }
    expect_found(sections_of(ball.get(), x_axis, {0}, 1e-6), 0, 2, 2); // two meridians
}

TEST(Sections, of_cylinders) {
    const Handle g = cylinder();
    const Found circle = sections_of(g.get(), z_axis, {0, 0.5, 2}, 1e-7);
    expect_found(circle, 3, 0, 0); // both ends too
    for (size_t i = 0; i < circle.branches.size(); ++i) {
        EXPECT_EQ(circle.branches[i].level, static_cast<int64_t>(i));
    }
    expect_found(sections_of(g.get(), x_axis, {0.3}, 1e-7), 0, 2, 0);
    expect_found(sections_of(g.get(), y_axis, {0}, 1e-7), 0, 2, 0); // along the seam
    expect_found(sections_of(g.get(), x_axis, {1}, 1e-7), 0, 0, 1);
    expect_found(sections_of(g.get(), x_axis, {-1}, 1e-7), 0, 0, 1);
    expect_found(sections_of(g.get(), {0.3, 0.2, 1}, {1}, 1e-7), 1, 0, 0); // an ellipse
    expect_found(sections_of(g.get(), {1, 0.1, 1}, {0.5}, 1e-7), 0, 1, 0);
    const Found line = sections_of(g.get(), x_axis, {0.3}, 1e-7);
    for (const Branch &branch : line.branches) {
        const std::vector<Point3> ends = points_on(branch.space.get(), branch.params(1));
        EXPECT_NEAR(distance(ends[0], ends[1]), 2, 1e-12);
        EXPECT_LE(branch.deviation, 1e-12);
    }
}

TEST(Sections, of_a_torus_at_all_heights) {
    const Handle g = torus();
    const double tolerance = 1e-6;
    expect_found(sections_of(g.get(), z_axis, {0}, tolerance), 2, 0, 0);
    expect_found(sections_of(g.get(), z_axis, {-0.7}, tolerance), 2, 0, 0);
    expect_found(sections_of(g.get(), z_axis, {1}, tolerance), 0, 0, 1);
    expect_found(sections_of(g.get(), z_axis, {1.1}, tolerance), 0, 0, 0);
    expect_found(sections_of(g.get(), x_axis, {0}, tolerance), 2, 0, 0);
    expect_found(sections_of(g.get(), x_axis, {1.99}, tolerance), 2, 0, 0);
    expect_found(sections_of(g.get(), x_axis, {2.01}, tolerance), 1, 0, 0);
    expect_found(sections_of(g.get(), x_axis, {3.999}, tolerance), 1, 0, 0);
    expect_found(sections_of(g.get(), x_axis, {4}, tolerance), 0, 0, 1);
    expect_found(sections_of(g.get(), x_axis, {4.1}, tolerance), 0, 0, 0);
    const Found eight = sections_of(g.get(), x_axis, {2}, tolerance); // a figure of eight, cut at the seam
    expect_found(eight, 0, 4, 1);
    EXPECT_EQ(eight.count(NURBS_NODE_SEAM), 4);
    const double tilt = std::asin(1.0 / 3); // two circles of Villarceau that cross twice
    const Found circles = sections_of(g.get(), {std::sin(tilt), 0, std::cos(tilt)}, {0}, tolerance);
    EXPECT_TRUE(circles.complete);
    EXPECT_EQ(circles.loops(), 0);
    double length = 0;
    for (const Branch &branch : circles.branches) {
        length += branch.domain[1] - branch.domain[0];
    }
    EXPECT_NEAR(length, 2 * 2 * pi * 3, 0.05);
    EXPECT_EQ(circles.count(NURBS_NODE_TOUCH), 2);
}

TEST(Sections, at_saddles) {
    const Handle g = terrain({{0.25, -0.25}, {-0.25, 0.25}}); // (x - 1/2) (y - 1/2)
    for (const double height : {0.0, 1e-8, -1e-8}) {
        const Found found = sections_of(g.get(), z_axis, {height}, 1e-6);
        expect_found(found, 0, 4, 1);
        const MeetPart &touch = *std::ranges::find(found.nodes, NURBS_NODE_TOUCH, &MeetPart::kind);
        EXPECT_NEAR(touch.at[0], 0.5, 1e-3);
        EXPECT_NEAR(touch.at[1], 0.5, 1e-3);
    }
    for (const double height : {0.2, 1e-5, -1e-5, -0.2}) {
        const Found found = sections_of(g.get(), z_axis, {height}, 1e-6);
        expect_found(found, 0, 2, 0);
        for (const Branch &branch : found.branches) {
            for (const surface_sections::Place &at : places_on(branch.on.get(), branch.params(100))) {
                EXPECT_EQ((at[0] - 0.5) * (at[1] - 0.5) > 0, height > 0);
            }
        }
    }
    expect_found(sections_of(g.get(), z_axis, {0.25}, 1e-6), 0, 0, 2); // two corners, from below
    expect_found(sections_of(g.get(), z_axis, {-0.25}, 1e-6), 0, 0, 2);
}

TEST(Sections, along_borders_and_through_corners) {
    const Handle flat = terrain({{0, 0}, {0, 0}}), slope = terrain({{-1, -1, -1}, {0, 0, 0}, {1, 1, 1}}),
                 valley = terrain({{1, 1, 1}, {0, 0, 0}, {1, 1, 1}}),
                 ridge = terrain({{-1, -1, -1}, {0, 0, 0}, {-1, -1, -1}});
    const double tolerance = 1e-9;
    expect_found(sections_of(flat.get(), z_axis, {0}, tolerance), 0, 0, 1);
    for (const double side : {1.0, -1.0}) { // in both directions
        expect_found(sections_of(flat.get(), {side, 0, 0}, {0}, tolerance), 0, 1, 0);
        expect_found(sections_of(flat.get(), {side, 0, 0}, {side}, tolerance), 0, 1, 0);
        expect_found(sections_of(flat.get(), {side, -side, 0}, {0}, tolerance), 0, 1, 0);
        expect_found(sections_of(flat.get(), {side, side, 0}, {0}, tolerance), 0, 0, 1);
        expect_found(sections_of(flat.get(), {side, side, 0}, {2 * side}, tolerance), 0, 0, 1);
        expect_found(sections_of(slope.get(), {0, 0, side}, {0}, tolerance), 0, 1, 0);
        expect_found(sections_of(slope.get(), {side, -side, 0}, {0}, tolerance), 0, 1, 0);
        expect_found(sections_of(slope.get(), {side, 2 * side, 0}, {3 * side}, tolerance), 0, 1, 0);
        expect_found(sections_of(valley.get(), {0, 0, side}, {side}, tolerance), 0, 2, 0);
    }
    expect_found(sections_of(valley.get(), z_axis, {0}, tolerance), 0, 0, 1); // a crease, from above
    expect_found(sections_of(ridge.get(), z_axis, {0}, tolerance), 0, 2, 0); // and from below, there and back
    const MeetPart crease = sections_of(valley.get(), z_axis, {0}, tolerance).nodes.front();
    EXPECT_EQ(crease.range[0], (surface_sections::Place{1, 1}));
    EXPECT_EQ(crease.range[1], (surface_sections::Place{0, 2}));
}

TEST(Sections, of_level_pieces_are_touches_with_the_curves_around_them) {
    const Handle table = terrain({{0, 0, 0, 0}, {0, 1, 1, 0}, {0, 1, 1, 0}, {0, 0, 0, 0}});
    expect_found(sections_of(table.get(), z_axis, {1}, 1e-6), 1, 0, 1);
    expect_found(sections_of(table.get(), z_axis, {0.5}, 1e-6), 1, 0, 0);
    const Found rim =
        sections_of(table.get(), z_axis, {0}, 1e-6); // corners are level to within the tolerance
    EXPECT_TRUE(rim.complete);
    EXPECT_EQ(open_branches(rim), 4);
    EXPECT_EQ(rim.count(NURBS_NODE_TOUCH), 4);
    const Handle peak = terrain({{-1, -1, -1}, {-1, 0, -1}, {-1, -1, -1}}),
                 pit = terrain({{1, 1, 1}, {1, 0, 1}, {1, 1, 1}});
    for (const Handle *g : {&peak, &pit}) {
        const Found found = sections_of(g->get(), z_axis, {0}, 1e-6);
        expect_found(found, 0, 0, 1);
        EXPECT_EQ(found.nodes.front().at, (surface_sections::Place{1, 1}));
    }
}

TEST(Sections, do_not_depend_on_the_length_of_the_normal_or_the_size_of_the_model) {
    const Handle g = torus();
    const SplineData data = read_back(g.get());
    for (const double length : {1.0, 1e-300, 1e-310, 1e300, -3.0}) {
        const Found found = sections_of(g.get(), {length, 0, 0}, {2.5 * length}, 1e-6);
        expect_found(found, 1, 0, 0);
    }
    for (const double size : {1e-140, 1e-30, 1e30, 1e140}) {
        const Handle other = create(scaled(data, size, size > 1 ? 1e9 : 1e-9));
        const Found found = sections_of(other.get(), x_axis, {2.5 * size}, 1e-6 * size);
        expect_found(found, 1, 0, 0);
        for (const Branch &branch : found.branches) {
            EXPECT_LE(branch.deviation, 1e-6 * size);
        }
    }
    expect_found(sections_of(g.get(), {1e-300, 0, 0}, {1e300}, 1e-6), 0, 0, 0); // farther than numbers reach
}

// Cylinders of radius 1 over arcs from -angle to angle: of a quarter and more the control point between is at infinity, or
// has a negative weight.
TEST(Sections, of_homogeneous_forms) {
    const int32_t degrees[] = {2, 1};
    const int64_t counts[] = {3, 2};
    const double knots[] = {0, 0, 0, 1, 1, 1, 0, 0, 1, 1};
    for (const double angle : {1.0, pi / 2, 1.8, 2.2}) {
        const double c = angle == pi / 2 ? 0 : std::cos(angle), s = std::sin(angle);
        std::vector<double> points;
        for (const std::array<double, 3> &p : {std::array<double, 3>{c, -s, 1}, {1, 0, c}, {c, s, 1}}) {
            for (const double z : {0.0, 2.0}) {
                points.insert(points.end(), {p[0], p[1], z * p[2], p[2]});
            }
        }
        const Handle g = made([&](nurbs **out) {
            return nurbs_create_homogeneous(2, degrees, counts, knots, 10, 3, points.data(), 0, 0, 0, out);
        });
        const Found found = sections_of(g.get(), {0.1, 0.1, 1}, {1}, 1e-6);
        expect_found(found, 0, 1, 0);
        for (const Branch &branch : found.branches) {
            EXPECT_LE(branch.deviation, 1e-6);
            for (const Point3 &x : points_on(branch.space.get(), branch.params(1000))) {
                EXPECT_LE(std::abs(std::hypot(x[0], x[1]) - 1), branch.deviation);
                EXPECT_LE(std::abs(0.1 * x[0] + 0.1 * x[1] + x[2] - 1), 1.02 * branch.deviation);
            }
        }
        expect_found(sections_of(g.get(), x_axis, {-0.1}, 1e-6), 0, angle > 1.7 ? 2 : 0, 0);
    }
}

TEST(Sections, of_the_same_surface_in_other_forms_have_the_same_topology) {
    int64_t loops = 0, open = 0;
    for_each_case(3130000, 60, [&](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, 2, 3);
        recipe.dim = 3;
        for (AxisRecipe &axis : recipe.axes) { // knots of degree 0 are jumps
            axis.degree = std::max(axis.degree, 1);
        }
        recipe.weights = random.chance(50) ? Weights::none : Weights::moderate;
        const SplineData data = random_spline(random, recipe);
        SCOPED_TRACE(where(seed, data));
        const Handle g = create(data);
        const Point3 normal = random_direction(random);
        const surface_sections::Place at{random.between(data.lower(0), data.upper(0)),
                                         random.between(data.lower(1), data.upper(1))};
        const double offset = dot(normal, points_of(g.get(), {at}).front()), tolerance = 1e-7 * extent(data);
        const Found found = sections_of(g.get(), normal, {offset}, tolerance);
        const auto expect_same = [&](const Handle &other) {
            const Found again = sections_of(other.get(), normal, {offset}, tolerance);
            EXPECT_EQ(again.complete, found.complete);
            EXPECT_EQ(again.loops(), found.loops());
            EXPECT_EQ(open_branches(again), open_branches(found));
            EXPECT_EQ(again.nodes.size(), found.nodes.size());
        };
        const int32_t axis = random.whole(0, 1), order[] = {1, 0};
        expect_same(made([&](nurbs **out) { return nurbs_refine_uniform(g.get(), axis, 3, out); }));
        expect_same(elevate(g.get(), axis, 2));
        expect_same(made([&](nurbs **out) { return nurbs_reverse(g.get(), axis, 0, out); }));
        expect_same(made([&](nurbs **out) { return nurbs_transpose(g.get(), order, out); }));
        loops += found.loops();
        open += open_branches(found);
    });
    EXPECT_GE(loops, of_whole_run(20));
    EXPECT_GE(open, of_whole_run(100));
}

// Many planes are what one plane is, each, in their order.
TEST(Sections, of_many_planes) {
    const Handle g = torus();
    std::vector<double> offsets;
    Random random(3140000);
    for (int i = 0; i < 50; ++i) {
        offsets.push_back(random.between(-4.5, 4.5));
    }
    const Found all = sections_of(g.get(), {1, 2, 2}, offsets, 1e-5);
    size_t next = 0;
    int64_t loop = 0;
    for (size_t i = 0; i < offsets.size(); ++i) {
        const Found one = sections_of(g.get(), {1, 2, 2}, {offsets[i]}, 1e-5);
        for (const Branch &branch : one.branches) {
            ASSERT_LT(next, all.branches.size());
            const Branch &same = all.branches[next++];
            EXPECT_EQ(same.level, static_cast<int64_t>(i));
            EXPECT_EQ(same.deviation, branch.deviation);
            EXPECT_EQ(same.loop, branch.loop < 0 ? -1 : loop + branch.loop);
            for (const int64_t node : same.nodes) {
                EXPECT_TRUE(node < 0 || all.nodes[static_cast<size_t>(node)].level == same.level);
            }
        }
        loop += one.loops();
    }
    EXPECT_EQ(next, all.branches.size());
}

} // namespace sections_test
