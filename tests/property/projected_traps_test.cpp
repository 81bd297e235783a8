// Projections that are easily got wrong: along knots, borders and seams, with kinks, at all sizes, of points and of lines along the
// direction.
#include "crossings.h"
#include "made_shapes.h"

#include <numbers>

namespace projected_traps {

using namespace surface_crossings;

namespace {

constexpr double pi = std::numbers::pi;

Crossing projection(const nurbs *g, const nurbs *curve, const Point3 &direction, double tolerance = 1e-7) {
    nurbs_meet *meet = nullptr;
    require_ok(nurbs_surface_project_curve(g, curve, direction.data(), tolerance, &meet));
    return crossing_in(MeetHandle(meet).get());
}

Handle polyline(const std::vector<Point3> &points) {
    SplineData data{{1}, {std::ssize(points)}, {{0}}, 3, {}, {}, 0};
    for (size_t i = 0; i < points.size(); ++i) {
        data.points.insert(data.points.end(), points[i].begin(), points[i].end());
        data.knots[0].push_back(static_cast<double>(i));
    }
    data.knots[0].push_back(static_cast<double>(points.size() - 1));
    return create(data);
}

// The ways along t, in the order of branches.
std::vector<Place> ranges_of(const Crossing &found) {
    std::vector<Place> ranges;
    for (size_t i = 0; i < found.on_second.size(); ++i) {
        const Branch &branch = found.found.branches[i];
        ranges.push_back({places_on(found.on_second[i].get(), {branch.domain[0]})[0][0],
                          places_on(found.on_second[i].get(), {branch.domain[1]})[0][0]});
    }
    return ranges;
}
double projected(const Crossing &found) {
    double sum = 0;
    for (const Place &range : ranges_of(found)) {
        sum += range[1] - range[0];
    }
    return sum;
}

// z = x^2 - y^2 over [-1, 1]^2, in four pieces or one.
SplineData saddle(bool pieces) {
    SplineData data = quadratic_graph(1, 0, -1, 0, -1, -1);
    if (!pieces) {
        return data;
    }
    const Handle g = create(data),
                 finer = made([&](nurbs **out) { return nurbs_refine_uniform(g.get(), 0, 2, out); });
    data.counts[0] = 4;
    data.knots[0] = {0, 0, 0, 0.5, 1, 1, 1};
    data.points.resize(36);
    require_ok(nurbs_points(finer.get(), 12, data.points.data(), 0, 0));
    return data;
}

// Above knots, middles, borders and corners.
TEST(ProjectedTraps, AlongKnotsAndBorders) {
    for (const bool pieces : {false, true}) {
        const Handle g = create(saddle(pieces));
        for (const double at : {0.0, 0.5, -0.25, 1.0, -1.0}) {
            for (const bool along_x : {true, false}) {
                SCOPED_TRACE(testing::Message() << "at " << at << (along_x ? " along x" : " along y"));
                const Handle line =
                    along_x ? polyline({{-2, at, 3}, {2, at, 3}}) : polyline({{at, -2, 3}, {at, 2, 3}});
                const Crossing found = projection(g.get(), line.get(), {0, 0, 1});
                EXPECT_TRUE(found.found.complete);
                ASSERT_EQ(found.found.branches.size(), 1U);
                EXPECT_NEAR(projected(found), 0.5, 1e-9);
                EXPECT_EQ(found.found.count(NURBS_NODE_BORDER), 2);
            }
        }
        const Handle diagonal = polyline({{-1, -1, 3}, {1, 1, 3}}); // from corner to corner, where z = 0
        const Crossing found = projection(g.get(), diagonal.get(), {0, 0, 1});
        EXPECT_TRUE(found.found.complete);
        EXPECT_NEAR(projected(found), 1, 1e-9);
        EXPECT_NEAR(length_of(found.found), std::sqrt(8), 1e-7);
    }
}

// Corners of the curve are corners of branches, and closed ones close.
TEST(ProjectedTraps, Kinks) {
    const Handle g = create(saddle(true)),
                 square = polyline(
                     {{-0.5, -0.5, 3}, {0.5, -0.5, 3}, {0.5, 0.5, 3}, {-0.5, 0.5, 3}, {-0.5, -0.5, 3}});
    const Crossing found = projection(g.get(), square.get(), {0, 0, 1});
    EXPECT_TRUE(found.found.complete);
    EXPECT_NEAR(projected(found), 4, 1e-9);
    EXPECT_EQ(found.closed_ways + found.open_ways, 1);
    // Over a leg along the direction the branch stays in a point.
    const Handle upright = polyline({{-0.5, 0.1, 3}, {0.1, 0.1, 3}, {0.1, 0.1, 4}, {0.5, 0.2, 4}});
    const Crossing broken = projection(g.get(), upright.get(), {0, 0, 1});
    EXPECT_TRUE(broken.found.complete);
    EXPECT_EQ(broken.found.branches.size(), 1U);
    EXPECT_NEAR(projected(broken), 3, 1e-9);
}

// Circles inside of a tube and wider than it, seen across its axis.
TEST(ProjectedTraps, ClosedCurvesOverSeams) {
    const Handle g = create(revolved(segment(1, -2, 1, 2), 0, 2 * pi));
    const double centre[] = {0, 0, 0}, axis[] = {1, 0, 0};
    const Handle ring = made([&](nurbs **out) {
        return nurbs_curve_circle(3, centre, axis, nullptr, 0.5, NURBS_ARC_QUARTERS, out);
    });
    const Crossing found = projection(g.get(), ring.get(), {1, 0, 0}); // onto both sides
    EXPECT_TRUE(found.found.complete);
    EXPECT_NEAR(projected(found), 2, 1e-9);
    EXPECT_EQ(found.closed_ways, 2);
    EXPECT_EQ(found.found.count(NURBS_NODE_FOLD), 0);
    const Handle wide = made([&](nurbs **out) {
        return nurbs_curve_circle(3, centre, axis, nullptr, 1.5, NURBS_ARC_QUARTERS, out);
    });
    const Crossing cut =
        projection(g.get(), wide.get(), {1, 0, 0}); // |y| < 1: upper and lower arcs, there and back
    EXPECT_TRUE(cut.found.complete);
    EXPECT_EQ(cut.found.count(NURBS_NODE_FOLD), 8);
    double most = 0;
    for (const MeetPart &node : cut.on_b) {
        if (node.kind == NURBS_NODE_FOLD) {
            const Point3 x = points_on(wide.get(), {node.at[0]})[0];
            most = std::max(most, std::abs(std::abs(x[1]) - 1));
        }
    }
    EXPECT_LE(most, 1e-6);
}

// Sizes of model and direction change nothing.
TEST(ProjectedTraps, AnySize) {
    for (const double size : {1e-9, 1e-3, 1e6, 1e12}) {
        SCOPED_TRACE(size);
        SplineData data = saddle(true);
        for (double &x : data.points) {
            x *= size;
        }
        const Handle g = create(data),
                     line = polyline({{-2 * size, 0.3 * size, 5 * size}, {2 * size, 0.1 * size, 4 * size}});
        for (const double length : {1e-300, 1.0, 1e300}) {
            const Crossing found = projection(g.get(), line.get(), {0.1 * length, 0, length}, 1e-7 * size);
            EXPECT_TRUE(found.found.complete);
            EXPECT_EQ(found.found.branches.size(), 1U);
            EXPECT_LE(found.found.branches[0].deviation, 1e-7 * size);
        }
    }
}

// What has no extent, and what is in the surface.
TEST(ProjectedTraps, Degenerate) {
    const Handle g = create(saddle(false)), point = polyline({{0.1, 0.2, 3}, {0.1, 0.2, 3}}),
                 upright = polyline({{0.1, 0.2, 3}, {0.1, 0.2, 5}});
    for (const Handle *curve : {&point, &upright}) {
        const Crossing found = projection(g.get(), curve->get(), {0, 0, 1});
        EXPECT_TRUE(found.found.complete);
        ASSERT_EQ(found.found.branches.size(), 1U);
        EXPECT_NEAR(projected(found), 1, 1e-9);
        for (const MeetPart &node : found.found.nodes) {
            EXPECT_NEAR(node.at[0], 0.55, 1e-9);
            EXPECT_NEAR(node.at[1], 0.6, 1e-9);
        }
    }
    // From a curve on the surface itself the ways are 0.
    const Handle on = made([&](nurbs **out) { return nurbs_iso(g.get(), 0, 0.3, 0, out); });
    const Crossing same = projection(g.get(), on.get(), {0.2, 0.1, 1});
    EXPECT_TRUE(same.found.complete);
    EXPECT_NEAR(projected(same), 1, 1e-6);
    for (size_t i = 0; i < same.on_second.size(); ++i) {
        for (const Place &x : places_on(same.on_second[i].get(), same.found.branches[i].params(20))) {
            EXPECT_NEAR(x[1], 0, 1e-7);
        }
    }
}

} // namespace

} // namespace projected_traps
