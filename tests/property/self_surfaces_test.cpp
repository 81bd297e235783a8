// Laws of the curves in which a surface meets itself.
#include "crossings.h"
#include "made_shapes.h"
#include "support/scale.h"

#include <numbers>

namespace surface_crossings {

namespace {

constexpr double pi = std::numbers::pi, tolerance = 1e-6;

Crossing itself(const nurbs *g, double within = tolerance, const nurbs_call_options *call = nullptr) {
    nurbs_meet *meet = nullptr;
    require_ok(nurbs_surface_self_intersections_with(g, within, call, &meet));
    return crossing_in(MeetHandle(meet).get());
}

bool is_simple(const Crossing &found) {
    return found.found.complete && found.found.branches.empty() && found.found.nodes.empty();
}

struct Counts {
    int64_t open, closed, touches = 0;
};
Crossing expect_complete(const SplineData &data, Counts expected, const char *name) {
    SCOPED_TRACE(name);
    const Handle g = create(data);
    Crossing found = itself(g.get());
    EXPECT_TRUE(found.found.complete);
    EXPECT_EQ(found.open_ways, expected.open);
    EXPECT_EQ(found.closed_ways, expected.closed);
    EXPECT_EQ(found.found.count(NURBS_NODE_TOUCH), expected.touches);
    for (const Branch &branch : found.found.branches) {
        EXPECT_LE(branch.deviation, tolerance);
    }
    const Ground ground(g.get(), data);
    check_curves(found, ground, ground);
    return found;
}

template <class Function>
SplineData over_square(std::array<int, 2> counts, int degree, Function &&f) {
    return net_of(counts, {degree, degree}, false, [&](double u, double v) {
        const Point3 p = f(u, v);
        return std::array<double, 4>{p[0], p[1], p[2], 1};
    });
}

SplineData ring(double big, double small) {
    return revolved(ellipse_arc(big, 0, small, small, 0, 2 * pi), 0, 2 * pi);
}

// Shapes of the makers, with seams and poles, and what bends a lot or has edges, are proven to be simple.
TEST(SelfSurfaces, SimpleShapes) {
    const PlaneCurve meridian = ellipse_arc(0, 0, 1, 1, -pi / 2, pi);
    struct Case {
        SplineData data;
        const char *name;
    };
    const std::vector<Case> cases{
        {parallelogram(2, 1, 0.5), "plane"},
        {revolved(segment(1, -1, 1, 1), 0, 2 * pi), "cylinder"},
        {revolved(segment(0, -1, 1, 1), 0, 2 * pi), "cone with its apex"},
        {revolved(segment(1, 1, 0, -1), 0, 2 * pi), "cone with its apex above"},
        {revolved(segment(0.5, -1, 1, 1), 1, 5.5), "a part of a cone"},
        {revolved(segment(0, 0, 1, 0), 0, 2 * pi), "disc"},
        {revolved(meridian, 0, 2 * pi), "sphere"},
        {revolved(meridian, 0, pi), "half a sphere"},
        {revolved(meridian, 1, 1.5 * pi), "three quarters of a sphere"},
        {revolved(ellipse_arc(0, 0, 1, 0.1, -pi / 2, pi), 0, 2 * pi), "a flat spheroid"},
        {revolved(ellipse_arc(0, 0, 0.1, 1, -pi / 2, pi), 0, 2 * pi), "a long spheroid"},
        {ring(2, 0.5), "torus"},
        {ring(2, 0.05), "a thin torus"},
        {ring(1, 0.99), "a torus that all but meets itself"},
        {over_square({20, 20}, 3,
                     [](double u, double v) {
                         return Point3{u, v, 0.2 * std::sin(6 * pi * u) + 0.03 * std::cos(5 * v)};
                     }),
         "waves"},
        {over_square({30, 4}, 3,
                     [](double u, double v) {
                         return Point3{(1 + u) * std::cos(15 * u), (1 + u) * std::sin(15 * u), v};
                     }),
         "a scroll"},
        {over_square({9, 2}, 1,
                     [](double u, double v) {
                         return Point3{u, 0.3 * std::fabs(std::sin(8 * u)), v};
                     }),
         "folds"}};
    for (const Case &test : cases) {
        SCOPED_TRACE(test.name);
        EXPECT_TRUE(is_simple(itself(create(test.data).get())));
        EXPECT_TRUE(is_simple(itself(create(turned(test.data)).get(), 1e-9)));
    }
}

TEST(SelfSurfaces, PeriodicAxes) {
    for (const SplineData &data : {ring(2, 0.5), revolved(segment(1, -1, 1, 1), 0, 2 * pi)}) {
        Handle g = create(data);
        int periodic_axes = 0;
        for (int32_t axis = 0; axis < 2; ++axis) {
            nurbs *periodic = nullptr;
            if (nurbs_make_periodic(g.get(), axis, 1e-12, nullptr, nullptr, &periodic) == NURBS_OK) {
                g.reset(periodic);
                ++periodic_axes;
            }
        }
        EXPECT_GE(periodic_axes, 1);
        EXPECT_TRUE(is_simple(itself(g.get())));
        EXPECT_TRUE(is_simple(itself(elevate(g.get(), 1, 1).get())));
    }
}

// A closed curve with a loop inside, along a line, on a periodic axis that begins anywhere.
TEST(SelfSurfaces, PeriodicLoops) {
    constexpr int n = 16;
    for (const double from : {0.0, 0.3, 2.1, 3.9}) {
        SCOPED_TRACE(from);
        SplineData data{{3, 1}, {n + 3, 2}, {{}, {0, 0, 1, 1}}, 3, {}, {}, NURBS_ON_AXIS(0, NURBS_PERIODIC)};
        for (int i = -3; i <= n + 3; ++i) {
            data.knots[0].push_back(i);
        }
        for (int i = 0; i < n + 3; ++i) {
            const double t = from + 2 * pi * (i % n) / n, r = 1 + 2 * std::cos(t);
            for (const double v : {0.0, 1.0}) {
                data.points.insert(data.points.end(), {r * std::cos(t), r * std::sin(t), v});
            }
        }
        const Crossing found = expect_complete(data, {1, 0}, "extruded");
        EXPECT_NEAR(length_of(found.found), 1, 1e-6);
        check_nodes(found, 1e-6);
    }
}

// Graphs over a plane, in general position.
TEST(SelfSurfaces, Graphs) {
    Random random(0x5e2);
    const int64_t cases = scaled(60);
    for (int64_t i = 0; i < cases; ++i) {
        const int degree = random.whole(1, 4), more = random.whole(1, 5);
        SplineData data =
            over_square({degree + more, degree + random.whole(1, 5)}, degree, [&](double u, double v) {
                return Point3{u, v, random.between(-0.3, 0.3)};
            });
        move(data, random_motion(random, 3, 1, 0.3));
        EXPECT_TRUE(is_simple(itself(create(data).get()))) << describe(data);
    }
}

// (t^2, t^3 - t) for -1.5 <= t <= 1.5 along v, which crosses itself at (1, 0).
SplineData loop(bool rational) {
    const double a = 1.5, far = a * a * a;
    const std::array<double, 4> x{a * a, -a * a / 3, -a * a / 3, a * a},
        y{a - far, a / 3 + far, -a / 3 - far, far - a};
    SplineData data{{3, 1}, {4, 2}, {{0, 0, 0, 0, 1, 1, 1, 1}, {0, 0, 1, 1}}, 3, {}, {}, 0};
    for (size_t i = 0; i < 4; ++i) {
        for (const double v : {0.0, 1.0}) {
            data.points.insert(data.points.end(), {x[i], y[i], v});
            if (rational) {
                data.weights.push_back(1 +
                                       v / 4); // positive also where the surface goes on without clamped ends
            }
        }
    }
    return data;
}

// In every form, its axes either way, turned and sheared: the line is as long, and both places are t and -t.
TEST(SelfSurfaces, ExtrudedLoops) {
    Random random(0x5e3);
    for (int64_t i = 0; i < scaled(40); ++i) {
        SCOPED_TRACE(i);
        Handle g = create(loop(random.chance(50)));
        if (random.chance(50)) {
            const std::array<int32_t, 2> order{1, 0};
            g = made([&](nurbs **out) { return nurbs_transpose(g.get(), order.data(), out); });
        }
        g = disguised(random, std::move(g), 2);
        const SplineData data = read_back(g.get());
        const Crossing found = itself(g.get());
        EXPECT_TRUE(found.found.complete) << describe(data);
        EXPECT_EQ(found.open_ways, 1);
        EXPECT_EQ(found.closed_ways, 0);
        EXPECT_NEAR(length_of(found.found), 1, 1e-6);
        const Ground ground(g.get(), data);
        check_curves(found, ground, ground);
        check_nodes(found, 1e-6);
        for (const Branch &branch : found.found.branches) {
            for (const Point3 &x : points_on(branch.space.get(), branch.params(20))) {
                EXPECT_NEAR(x[0], 1, 1e-6);
                EXPECT_NEAR(x[1], 0, 1e-6);
            }
        }
    }
}

// As many branches as the profile has crossings, which are found in another way.
TEST(SelfSurfaces, AsManyAsCrossingsOfTheProfile) {
    Random random(0x5e4);
    int64_t compared = 0, crossings = 0;
    const int64_t cases = scaled(60);
    for (int64_t i = 0; i < cases; ++i) {
        SCOPED_TRACE(i);
        SplineData profile{{3}, {random.whole(5, 12)}, {{}}, 2, {}, {}, 0};
        for (int64_t k = -3; k <= profile.counts[0]; ++k) {
            profile.knots[0].push_back(
                std::clamp<double>(static_cast<double>(k), 0, static_cast<double>(profile.counts[0]) - 3));
        }
        for (int64_t k = 0; k < 2 * profile.counts[0]; ++k) {
            profile.points.push_back(random.between(-1, 1));
        }
        const Handle curve = create(profile);
        int64_t count = 0;
        int32_t whole = 0;
        require_ok(nurbs_curve_self_intersections(curve.get(), 1e-9, 0, nullptr, nullptr, nullptr, nullptr,
                                                  nullptr, &count, &whole));
        const std::array<double, 6> lift{1, 0, 0, 1, 0.3, -0.2};
        const std::array<double, 3> along{0.1, 0.2, 1};
        const Handle in_space =
            made([&](nurbs **out) { return nurbs_transform(curve.get(), 3, lift.data(), nullptr, out); });
        const Handle g = made([&](nurbs **out) { return nurbs_extrude(in_space.get(), along.data(), out); });
        const Crossing found = itself(g.get());
        if (whole == 0 || !found.found.complete) {
            continue;
        }
        ++compared;
        crossings += count;
        EXPECT_EQ(found.open_ways, count);
        EXPECT_NEAR(length_of(found.found), static_cast<double>(count) * std::sqrt(1.05), 1e-5);
    }
    EXPECT_GE(compared, cases * 9 / 10);
    EXPECT_GE(crossings, compared);
}

// (s t, s, t^2): it meets itself along the axis z, from z = 1 to the pinch point at the origin.
TEST(SelfSurfaces, WhitneyUmbrella) {
    SplineData data{{1, 2}, {2, 3}, {{-1, -1, 1, 1}, {-1, -1, -1, 1, 1, 1}}, 3, {}, {}, 0};
    for (const double s : {-1.0, 1.0}) {
        data.points.insert(data.points.end(), {-s, s, 1, 0, s, -1, s, s, 1});
    }
    const Crossing found = expect_complete(data, {1, 0, 1}, "umbrella");
    EXPECT_NEAR(length_of(found.found), 1, 1e-4);
    const auto touch = std::ranges::find(found.found.nodes, NURBS_NODE_TOUCH, &MeetPart::kind);
    ASSERT_NE(touch, found.found.nodes.end());
    for (const Place &range : touch->range) {
        EXPECT_TRUE(range[0] <= 0 && range[1] >= 0 && range[1] - range[0] < 0.05);
    }
}

TEST(SelfSurfaces, KnownShapes) {
    const auto eight = [](double u, double v) {
        return Point3{std::sin(4 * pi * u), std::sin(2 * pi * u) + 0.2 * v, 3 * v};
    };
    const Crossing along =
        expect_complete(over_square({16, 4}, 3, eight), {1, 0}, "a tube like a figure of eight");
    EXPECT_NEAR(length_of(along.found), std::hypot(3, 0.2), 1e-2);
    // Its ends are at u = 0 and 1/2 in either order.
    for (const MeetPart &node : along.found.nodes) {
        EXPECT_EQ(node.kind, NURBS_NODE_BORDER);
        EXPECT_NEAR(std::min(std::fabs(node.at[0] - 0.5), node.at[0]), 0, 1e-9);
    }
    // A band that winds round twice while it rises and falls meets itself in one curve.
    expect_complete(
        over_square({24, 4}, 3,
                    [](double u, double v) {
                        const double t = 4 * pi * u, r = 2 + 0.8 * std::cos(t / 2);
                        return Point3{r * std::cos(t), r * std::sin(t), v + 0.3 * std::sin(t / 2)};
                    }),
        {1, 0}, "a band that winds round twice");
    // A sheet that folds back over itself, with a bump on its lower half that goes through the upper one.
    expect_complete(
        over_square({30, 16}, 3,
                    [](double u, double v) {
                        const double bump = std::exp(-80 * (std::pow(u - 0.2, 2) + std::pow(v - 0.5, 2)));
                        return Point3{2 * std::sin(pi * u), 2 * v, -std::cos(pi * u) + 2.5 * bump};
                    }),
        {0, 1}, "a bump through a sheet");
}

// Where a surface jumps, both parts meet as two surfaces do.
SplineData joined(const SplineData &a, const SplineData &b) {
    SplineData both = a;
    both.counts[0] *= 2;
    both.knots[0].resize(static_cast<size_t>(a.counts[0]));
    for (const double t : b.knots[0]) {
        both.knots[0].push_back(t + 1);
    }
    both.points.insert(both.points.end(), b.points.begin(), b.points.end());
    return both;
}

TEST(SelfSurfaces, JoinedPatches) {
    Random random(0x5e5);
    int64_t compared = 0, branches = 0;
    const int64_t cases = scaled(30);
    for (int64_t i = 0; i < cases; ++i) {
        SCOPED_TRACE(i);
        const auto patch = [&] {
            SplineData data = over_square({5, 4}, 3, [&](double u, double v) {
                return Point3{2 * u - 1, 2 * v - 1, random.between(-0.3, 0.3)};
            });
            move(data, random_motion(random, 3, 1, 0.3));
            return data;
        };
        const SplineData a = patch(), b = patch(), both = joined(a, b);
        const Handle first = create(a), second = create(b), g = create(both);
        const Crossing expected = crossing_of(first.get(), second.get(), tolerance), found = itself(g.get());
        if (!expected.found.complete || !found.found.complete) {
            continue;
        }
        ++compared;
        branches += found.open_ways + found.closed_ways;
        EXPECT_EQ(found.open_ways, expected.open_ways);
        EXPECT_EQ(found.closed_ways, expected.closed_ways);
        EXPECT_NEAR(length_of(found.found), length_of(expected.found), 1e-5);
        const Ground ground(g.get(), both);
        check_curves(found, ground, ground, 200);
    }
    EXPECT_GE(compared, cases * 9 / 10);
    EXPECT_GE(branches, cases / 2);
}

// Parts that touch in a point, and along a curve, do so once.
TEST(SelfSurfaces, JoinedTouches) {
    const SplineData plane = quadratic_graph(0, 0, 0, 0, -1.1, -0.9);
    const Crossing point =
        expect_complete(joined(quadratic_graph(1, 0, 1, 0, -1.1, -0.9), plane), {0, 0, 1}, "a bowl");
    EXPECT_EQ(point.found.nodes.size(), 1);
    const Crossing line =
        expect_complete(joined(plane, quadratic_graph(1, 0, 0, 0, -1.1, -0.9)), {1, 0}, "a trough");
    ASSERT_EQ(line.kinds.size(), 1);
    EXPECT_EQ(line.kinds[0], NURBS_BRANCH_TOUCH);
    EXPECT_EQ(line.found.nodes.size(), 2);
}

// Turned inside out at random, so that sheets go through each other.
SplineData crumpled(Random &random, double by) {
    const bool rational = random.chance(40);
    return net_of({6, 6}, {3, 3}, rational, [&](double u, double v) {
        return std::array<double, 4>{u + random.between(-by, by), v + random.between(-by, by),
                                     random.between(-by, by), random.between(0.5, 1.5)};
    });
}

struct Ways {
    bool complete;
    int64_t open, closed;
    double length;
};
Ways ways_of(const nurbs *g) {
    const Crossing found = itself(g, 1e-5);
    return {found.found.complete, found.open_ways, found.closed_ways, length_of(found.found)};
}
void expect_same(const Ways &a, const Ways &b, const char *law) {
    SCOPED_TRACE(law);
    if (a.complete && b.complete) {
        EXPECT_EQ(a.open, b.open);
        EXPECT_EQ(a.closed, b.closed);
        EXPECT_NEAR(a.length, b.length, 1e-2);
    }
}

TEST(SelfSurfaces, LawsOfForms) {
    Random random(0x5e6);
    int64_t complete = 0, branches = 0;
    const int64_t cases = scaled(20);
    for (int64_t i = 0; i < cases; ++i) {
        SCOPED_TRACE(i);
        const SplineData data = crumpled(random, 0.16);
        const Handle g = create(data);
        const Crossing found = itself(g.get(), 1e-5);
        const Ground ground(g.get(), data);
        check_curves(found, ground, ground, 200);
        const Ways ways{found.found.complete, found.open_ways, found.closed_ways, length_of(found.found)};
        complete += ways.complete ? 1 : 0;
        branches += ways.open + ways.closed;
        const Handle fine =
            made([&](nurbs **out) { return nurbs_refine_uniform(g.get(), random.whole(0, 1), 2, out); });
        expect_same(ways, ways_of(fine.get()), "refined");
        expect_same(ways, ways_of(elevate(g.get(), random.whole(0, 1), 1).get()), "elevated");
        const std::array<double, 9> matrix{1, 0, 0, 0, 0, 1, 0, -1, 0};
        const std::array<double, 3> shift{3, -40, 7};
        const Handle other =
            made([&](nurbs **out) { return nurbs_transform(g.get(), 3, matrix.data(), shift.data(), out); });
        expect_same(
            ways,
            ways_of(
                disguised(random, made([&](nurbs **out) { return nurbs_clone(other.get(), out); }), 2).get()),
            "moved, in another form");
    }
    EXPECT_GE(complete, cases * 3 / 4);
    EXPECT_GE(branches, cases / 2);
}

// Of random surfaces, fine meshes cross themselves only beside curves that are told, or in parts that are left open.
struct Triangle {
    std::array<Point3, 3> corners;
    Place at; // in the domain, its middle
};
std::vector<Triangle> triangles_of(const nurbs *g, int n) {
    std::vector<Place> places;
    for (int i = 0; i <= n; ++i) {
        for (int j = 0; j <= n; ++j) {
            places.push_back({static_cast<double>(i) / n, static_cast<double>(j) / n});
        }
    }
    const std::vector<Point3> points = points_of(g, places);
    std::vector<Triangle> triangles;
    const auto row = static_cast<size_t>(n) + 1;
    for (size_t i = 0; i + 1 < row; ++i) {
        for (size_t j = 0; j + 1 < row; ++j) {
            const size_t a = i * row + j, b = a + row;
            for (const std::array<size_t, 3> &c : {std::array<size_t, 3>{a, b, b + 1}, {a, b + 1, a + 1}}) {
                Triangle triangle{{points[c[0]], points[c[1]], points[c[2]]}, {}};
                for (size_t k = 0; k < 2; ++k) {
                    triangle.at[k] = (places[c[0]][k] + places[c[1]][k] + places[c[2]][k]) / 3;
                }
                triangles.push_back(triangle);
            }
        }
    }
    return triangles;
}
double volume(const Point3 &a, const Point3 &b, const Point3 &c, const Point3 &d) {
    std::array<Point3, 3> e{};
    for (size_t k = 0; k < 3; ++k) {
        e[0][k] = b[k] - a[k];
        e[1][k] = c[k] - a[k];
        e[2][k] = d[k] - a[k];
    }
    return e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
           e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
           e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
}
bool pierces(const Point3 &p, const Point3 &q, const Triangle &t) {
    const auto &[a, b, c] = t.corners;
    if (volume(a, b, c, p) * volume(a, b, c, q) >= 0) {
        return false;
    }
    const double x = volume(p, q, a, b), y = volume(p, q, b, c), z = volume(p, q, c, a);
    return (x > 0 && y > 0 && z > 0) || (x < 0 && y < 0 && z < 0);
}
bool cross(const Triangle &s, const Triangle &t) {
    for (size_t k = 0; k < 3; ++k) {
        const auto [a0, a1] = std::minmax({s.corners[0][k], s.corners[1][k], s.corners[2][k]});
        const auto [b0, b1] = std::minmax({t.corners[0][k], t.corners[1][k], t.corners[2][k]});
        if (a1 < b0 || b1 < a0) {
            return false;
        }
    }
    for (size_t i = 0; i < 3; ++i) {
        if (pierces(s.corners[i], s.corners[(i + 1) % 3], t) ||
            pierces(t.corners[i], t.corners[(i + 1) % 3], s)) {
            return true;
        }
    }
    return false;
}
double apart(const Place &a, const Place &b) {
    return std::max(std::fabs(a[0] - b[0]), std::fabs(a[1] - b[1]));
}

TEST(SelfSurfaces, NothingIsMissedThatMeshesShow) {
    Random random(0x5e7);
    constexpr int n = 28;
    constexpr double near = 3.0 / n;
    int64_t crossings = 0, missed = 0;
    for (int64_t i = 0; i < scaled(16); ++i) {
        SCOPED_TRACE(i);
        const SplineData data = crumpled(random, 0.4);
        const Handle g = create(data);
        const Crossing found = itself(g.get(), 1e-4);
        std::vector<std::array<Place, 2>> told;
        for (size_t b = 0; b < found.found.branches.size(); ++b) {
            const std::vector<double> t = found.found.branches[b].params(200);
            const std::vector<Place> on_a = places_on(found.found.branches[b].on.get(), t),
                                     on_b = places_on(found.on_second[b].get(), t);
            for (size_t k = 0; k < t.size(); ++k) {
                told.push_back({on_a[k], on_b[k]});
            }
        }
        for (size_t k = 0; k < found.found.nodes.size(); ++k) {
            told.push_back({found.found.nodes[k].at, found.on_b[k].at});
        }
        const std::vector<Triangle> triangles = triangles_of(g.get(), n);
        for (size_t s = 0; s < triangles.size(); ++s) {
            for (size_t t = s + 1; t < triangles.size(); ++t) {
                const Place &a = triangles[s].at, &b = triangles[t].at;
                if (apart(a, b) < 2 * near || !cross(triangles[s], triangles[t])) {
                    continue;
                }
                ++crossings;
                missed += std::ranges::none_of(told, [&](const std::array<Place, 2> &place) {
                    return std::max(apart(a, place[0]), apart(b, place[1])) < near ||
                           std::max(apart(a, place[1]), apart(b, place[0])) < near;
                });
            }
        }
    }
    EXPECT_GE(crossings, 5 * scaled(16));
    EXPECT_LE(missed, crossings / 100);
}

// What cannot be told is told as such, where it is.
TEST(SelfSurfaces, LeftOpen) {
    struct Case {
        SplineData data;
        Place at;
        const char *name;
    };
    SplineData cusp{{3, 1}, {4, 2}, {{0, 0, 0, 0, 1, 1, 1, 1}, {0, 0, 1, 1}}, 3, {}, {}, 0};
    for (const auto &[x, y] : {std::pair(1.0, -1.0), {-1.0 / 3, 1.0}, {-1.0 / 3, -1.0}, {1.0, 1.0}}) {
        cusp.points.insert(cusp.points.end(), {x, y, 0, x, y, 1});
    }
    const std::vector<Case> cases{
        {cusp, {0.5, 0.3}, "a cuspidal edge"},
        {{{1, 1},
          {3, 2},
          {{0, 0, 0.5, 1, 1}, {0, 0, 1, 1}},
          3,
          {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 0, 1, 0},
          {},
          0},
         {0.5, 0.7},
         "folded flat"},
        {{{1, 1}, {2, 2}, {{0, 0, 1, 1}, {0, 0, 1, 1}}, 3, {0, 0, 0, 1, 1, 1, 0, 0, 0, 1, 1, 1}, {}, 0},
         {0.5, 0.5},
         "a line"}};
    for (const Case &test : cases) {
        SCOPED_TRACE(test.name);
        const Handle g = create(test.data);
        const Crossing found = itself(g.get());
        EXPECT_FALSE(found.found.complete);
        EXPECT_TRUE(std::ranges::any_of(found.found.nodes, [&](const MeetPart &node) {
            return node.kind == NURBS_NODE_UNDECIDED && node.range[0][0] <= test.at[0] &&
                   node.range[0][1] >= test.at[0] && node.range[1][0] <= test.at[1] &&
                   node.range[1][1] >= test.at[1];
        }));
    }
    // Axes of revolution that are met away from sides: all of a circle is one point there.
    EXPECT_FALSE(is_simple(itself(create(ring(0.5, 1)).get())));
    EXPECT_FALSE(is_simple(itself(create(ring(1, 1)).get())));
    EXPECT_FALSE(is_simple(itself(create(revolved(segment(-1, -1, 1, 1), 0, 2 * pi)).get())));
}

// Whatever the limit of work, nothing is proven that is not so, and what is found is right.
TEST(SelfSurfaces, Budgets) {
    Random random(0x5e8);
    std::vector<SplineData> shapes{loop(false), loop(true), ring(2, 0.5)};
    for (int i = 0; i < 3; ++i) {
        shapes.push_back(crumpled(random, 0.2));
    }
    for (const SplineData &data : shapes) {
        const Handle g = create(data);
        const Ground ground(g.get(), data);
        const bool simple = is_simple(itself(g.get()));
        nurbs_call_options call;
        require_ok(nurbs_call_options_init(&call, sizeof call));
        for (const int64_t work : {1, 10, 100, 1000, 10000, 100000, 1000000}) {
            call.work = work;
            const Crossing found = itself(g.get(), tolerance, &call);
            EXPECT_TRUE(simple || !is_simple(found)) << work;
            EXPECT_TRUE(work > 1000 || !found.found.complete);
            check_curves(found, ground, ground, 20);
        }
    }
}

} // namespace

} // namespace surface_crossings
