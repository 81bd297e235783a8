// Laws of the points that three surfaces have in common.
#include "crossings.h"
#include "made_shapes.h"
#include "support/cases.h"
#include "support/scale.h"

#include <numbers>

namespace common_points {

using namespace surface_crossings;

namespace {

constexpr double pi = std::numbers::pi;

struct Common {
    std::vector<double> params, ranges;
    std::vector<Point3> points;
    std::vector<int32_t> kinds;
    bool complete = false;

    [[nodiscard]] size_t size() const { return points.size(); }
};

Common common_of(const nurbs *a, const nurbs *b, const nurbs *c, double tolerance = 0,
                 const nurbs_call_options *call = nullptr) {
    int64_t count = 0;
    int32_t complete = 0;
    require_ok(nurbs_surfaces_common_points_with(a, b, c, tolerance, 0, nullptr, nullptr, nullptr, nullptr,
                                                 &count, nullptr, call));
    Common found;
    const auto n = static_cast<size_t>(count);
    found.params.resize(6 * n);
    found.ranges.resize(12 * n);
    found.points.resize(n);
    found.kinds.resize(n);
    require_ok(nurbs_surfaces_common_points_with(
        a, b, c, tolerance, count, found.params.data(), n > 0 ? found.points.front().data() : nullptr,
        found.kinds.data(), found.ranges.data(), &count, &complete, call));
    found.complete = complete == 1;
    EXPECT_EQ(std::ranges::count(found.kinds, NURBS_HIT_UNDECIDED) == 0, found.complete);
    return found;
}

// Every point is on all three surfaces, and its parameters are in the ranges.
void check_points(const Common &found, const std::array<const nurbs *, 3> &surfaces, double near) {
    for (size_t i = 0; i < found.size(); ++i) {
        for (size_t k = 0; k < 6; ++k) {
            const double *range = found.ranges.data() + 12 * i + 2 * k, at = found.params[6 * i + k];
            EXPECT_TRUE((range[0] <= at && at <= range[1]) ||
                        (range[0] <= at + 1 && at + 1 <= range[1])); // of axes that close, from 0 to 1
            if (found.kinds[i] == NURBS_HIT_CROSSING) {
                EXPECT_LE(range[1] - range[0], 1e-9);
            }
        }
        for (size_t s = 0; found.kinds[i] == NURBS_HIT_CROSSING && s < 3; ++s) {
            const std::vector<Place> at{{found.params[6 * i + 2 * s], found.params[6 * i + 2 * s + 1]}};
            EXPECT_LE(distance(points_of(surfaces[s], at)[0], found.points[i]), near)
                << "point " << i << ", surface " << s;
        }
    }
}

SplineData ball(double r, const Point3 &centre) {
    return support::moved(revolved(ellipse_arc(0, 0, r, r, -pi / 2, pi), 0, 2 * pi), centre);
}
SplineData tube(double r, double half) {
    return revolved(segment(r, -half, r, half), 0, 2 * pi);
}
// The points p + x u + y v, x and y in [-3, 3].
SplineData flat(const Point3 &p, const Point3 &u, const Point3 &v) {
    return net_of({2, 2}, {1, 1}, false, [&](double s, double t) {
        std::array<double, 4> x{0, 0, 0, 1};
        for (size_t c = 0; c < 3; ++c) {
            x[c] = p[c] + (6 * s - 3) * u[c] + (6 * t - 3) * v[c];
        }
        return x;
    });
}

void expect_points(const std::array<SplineData, 3> &data, std::vector<Point3> expected, const char *name) {
    SCOPED_TRACE(name);
    const std::array<Handle, 3> shapes{create(data[0]), create(data[1]), create(data[2])};
    for (const auto &[i, j, k] : {std::array<size_t, 3>{0, 1, 2}, {2, 0, 1}, {1, 0, 2}}) {
        const std::array<const nurbs *, 3> own{shapes[i].get(), shapes[j].get(), shapes[k].get()};
        const Common found = common_of(own[0], own[1], own[2]);
        EXPECT_TRUE(found.complete);
        ASSERT_EQ(found.size(), expected.size());
        check_points(found, own, 1e-12);
        for (const Point3 &x : expected) {
            EXPECT_TRUE(
                std::ranges::any_of(found.points, [&](const Point3 &y) { return distance(x, y) < 1e-12; }));
        }
    }
}

TEST(CommonPoints, KnownShapes) {
    const double h = std::sqrt(1 - 0.16 - 0.09);
    expect_points({ball(1, {0, 0, 0}), flat({0.4, 0.1, 0.2}, {0, 1, 0}, {0, 0, 1}),
                   flat({0.1, 0.2, 0.3}, {1, 0, 0}, {0, 1, 0})},
                  {{0.4, h, 0.3}, {0.4, -h, 0.3}}, "a ball and two planes");
    // x^2 + y^2 = 1, y^2 + z^2 = 1, and a ball of radius r: x^2 = z^2 = r^2 - 1, y^2 = 2 - r^2.
    const double r = 1.3, x = std::sqrt(r * r - 1), y = std::sqrt(2 - r * r);
    std::vector<Point3> eight;
    for (int i = 0; i < 8; ++i) {
        eight.push_back({(i & 1) != 0 ? x : -x, (i & 2) != 0 ? y : -y, (i & 4) != 0 ? x : -x});
    }
    expect_points({tube(1, 2), turned(tube(1, 2)), ball(r, {0, 0, 0})}, eight, "three quadrics");
    std::vector<Point3> two; // z^2 + (0.52 - 0.2 z)^2 = 3 / 4
    for (const double sign : {-1.0, 1.0}) {
        const double z = (0.104 + sign * std::sqrt(0.104 * 0.104 + 1.04 * (0.75 - 0.52 * 0.52))) / 1.04;
        two.push_back({0.5, 0.52 - 0.2 * z, z});
    }
    expect_points({ball(1, {0, 0, 0}), ball(1, {1, 0, 0}), ball(1, {0, 1, 0.2})}, two, "three balls");
}

// What touches, and what runs along a curve, is left open where it is.
TEST(CommonPoints, TouchesAreOpen) {
    const Handle a = create(ball(1, {0, 0, 0})), b = create(flat({0, 0, 0}, {1, 0, 0}, {0, 1, 1})),
                 c = create(flat({0, 0, 0}, {1, 0, 0}, {0, 1, -2})),
                 d = create(flat({1, 0, 0}, {0, 1, 0}, {0, 0, 1}));
    const Common along = common_of(b.get(), c.get(), create(flat({0, 0, 0}, {1, 0, 0}, {0, 1, 3})).get());
    EXPECT_FALSE(along.complete);
    const Common line = common_of(a.get(), b.get(), c.get()); // in the points (1, 0, 0) and (-1, 0, 0)
    EXPECT_TRUE(line.complete);
    EXPECT_EQ(line.size(), 2U);
    const Common touch = common_of(a.get(), d.get(), b.get());
    EXPECT_FALSE(touch.complete);
    for (const Point3 &x : touch.points) {
        EXPECT_LE(distance(x, {1, 0, 0}), 1e-3);
    }
}

// A patch over the square [-1, 1]^2, about, and beyond.
SplineData any_patch(Random &random) {
    const std::array<int, 2> degrees{random.whole(1, 3), random.whole(1, 3)};
    const std::array<int, 2> counts{degrees[0] + random.whole(1, 3), degrees[1] + random.whole(1, 3)};
    return net_of(counts, degrees, random.chance(50), [&](double u, double v) {
        return std::array<double, 4>{2.4 * u - 1.2 + random.between(-0.3, 0.3),
                                     2.4 * v - 1.2 + random.between(-0.3, 0.3), random.between(-0.7, 0.7),
                                     random.between(0.5, 2)};
    });
}

// y = m x + k, as large as all others.
SplineData upright(double m, double k) {
    return flat({0, k, 0}, {1, m, 0}, {0, 0, 1});
}

// A quadratic graph and an upright plane have a parabola in common, which meets the patch as curves do.
TEST(CommonPoints, AsACurveMeetsASurface) {
    Random random(0x3b01);
    int64_t compared = 0, points = 0;
    const int64_t cases = scaled(200);
    for (int64_t i = 0; i < cases; ++i) {
        SCOPED_TRACE(i);
        const double a = random.between(-0.6, 0.6), b = random.between(-0.6, 0.6),
                     c = random.between(-0.6, 0.6), d = random.between(-0.3, 0.3),
                     m = random.between(-0.5, 0.5), k = random.between(-0.3, 0.3);
        const Handle patch = create(any_patch(random)), plane = create(upright(m, k)),
                     graph = create(quadratic_graph(a, b, c, d, -1, -1));
        // z over x: a x^2 + b x (m x + k) + c (m x + k)^2 + d, where -1 <= y <= 1; x is in [-1, 1].
        const double square = a + b * m + c * m * m, linear = b * k + 2 * c * m * k, rest = c * k * k + d;
        const auto y = [&](double x) { return m * x + k; };
        double from = -1, to = 1;
        for (const double edge : {-1.0, 1.0}) { // |k| < 1: y is inside for x = 0
            const double x = (edge - k) / m;
            to = x > 0 ? std::min(to, x) : to;
            from = x < 0 ? std::max(from, x) : from;
        }
        const auto z = [&](double x) { return square * x * x + linear * x + rest; };
        const double half = (to - from) / 2, middle = from + half;
        const double top = z(from) + (2 * square * from + linear) * half;
        const Handle curve = create({{2},
                                     {3},
                                     {{from, from, from, to, to, to}},
                                     3,
                                     {from, y(from), z(from), middle, y(middle), top, to, y(to), z(to)},
                                     {},
                                     0});
        int64_t count = 0;
        int32_t complete = 0;
        require_ok(nurbs_curve_surface_intersections(curve.get(), patch.get(), 0, 0, nullptr, nullptr,
                                                     nullptr, nullptr, nullptr, &count, &complete));
        const std::array<const nurbs *, 3> own{patch.get(), graph.get(), plane.get()};
        const Common found = common_of(own[0], own[1], own[2]);
        check_points(found, own, 1e-10);
        if (complete == 0 || !found.complete) {
            continue;
        }
        ++compared;
        points += count;
        EXPECT_EQ(found.size(), static_cast<size_t>(count));
    }
    EXPECT_GE(compared, cases * 97 / 100);
    EXPECT_GE(points, cases / 2);
}

// The same whatever their order, their knots and degrees, and how they are moved.
TEST(CommonPoints, OrdersKnotsAndMotions) {
    Random random(0x3b02);
    int64_t compared = 0, points = 0;
    const int64_t cases = scaled(60);
    for (int64_t i = 0; i < cases; ++i) {
        SCOPED_TRACE(i);
        const SplineData a = any_patch(random), b = turned(any_patch(random)),
                         c = turned(turned(any_patch(random)));
        const Handle first = create(a), second = create(b), third = create(c);
        const std::array<const nurbs *, 3> own{first.get(), second.get(), third.get()};
        const Common found = common_of(own[0], own[1], own[2]);
        check_points(found, own, 1e-10);
        const Handle finer = made([&](nurbs **out) { return nurbs_refine_uniform(own[1], 0, 3, out); }),
                     higher = made([&](nurbs **out) { return nurbs_elevate(own[2], 1, 1, out); });
        const Common other = common_of(higher.get(), own[0], finer.get());
        if (!found.complete || !other.complete) {
            continue;
        }
        ++compared;
        points += std::ssize(found.points);
        ASSERT_EQ(found.size(), other.size());
        for (const Point3 &x : found.points) {
            EXPECT_TRUE(
                std::ranges::any_of(other.points, [&](const Point3 &y) { return distance(x, y) < 1e-9; }));
        }
    }
    EXPECT_GE(compared, cases * 95 / 100);
    EXPECT_GE(points, cases / 2);
}

// Beside a seam by more or less than what rounding makes of it, each is told once, too.
TEST(CommonPoints, BesideSeams) {
    const Handle a = create(ball(1, {0, 0, 0}));
    for_each_case(9560, 200, [&](Random &random, uint64_t) {
        const double off = (random.chance(50) ? 1 : -1) * std::pow(10, random.between(-17, -8)),
                     height = 1 - std::pow(10, random.between(-4, -0.1)),
                     out = std::sqrt(1 - height * height - off * off);
        const Handle beside = create(flat({0, off, 0}, {1, 0, 0}, {0, 0, 1})),
                     level = create(flat({0, 0, height}, {1, 0, 0}, {0, 1, 0}));
        const Common found = common_of(a.get(), beside.get(), level.get());
        EXPECT_TRUE(found.complete);
        ASSERT_EQ(found.size(), 2U) << off << " " << height;
        for (const Point3 &x : found.points) {
            EXPECT_LE(distance(x, {x[0] > 0 ? out : -out, off, height}), 1e-11);
        }
    });
}

// On knots, middles, borders, corners and seams each point is told once.
TEST(CommonPoints, OnKnotsBordersAndSeams) {
    const auto saddle = [](double x0, double y0) { return quadratic_graph(1, 0, -1, 0, x0, y0); };
    const Handle whole = create(saddle(-1, -1)),
                 pieces = made([&](nurbs **out) { return nurbs_refine_uniform(whole.get(), 0, 2, out); }),
                 corner = create(saddle(0, 0)), // which ends at x = 0 and at y = 0
        upright = create(flat({0, 0, 0}, {0, 1, 0}, {0, 0, 1})),
                 across = create(flat({0, 0, 0}, {1, 0, 0}, {0, 0.1, 1}));
    for (const Handle *g : {&whole, &pieces, &corner}) {
        const std::array<const nurbs *, 3> own{g->get(), upright.get(), across.get()};
        const Common found = common_of(own[0], own[1], own[2]);
        EXPECT_TRUE(found.complete);
        ASSERT_EQ(found.size(), 1U); // on knots, middles and corners of two or three
        EXPECT_LE(distance(found.points[0], {0, 0, 0}), 1e-14);
        check_points(found, own, 1e-14);
    }
    // The seam of a ball is at y = 0, x > 0.
    const Handle a = create(ball(1, {0, 0, 0})), seam = create(flat({0, 0, 0}, {1, 0, 0}, {0, 0, 1})),
                 level = create(flat({0, 0, 0.6}, {1, 0, 0}, {0, 1, 0}));
    const Common on_seam = common_of(a.get(), seam.get(), level.get());
    EXPECT_TRUE(on_seam.complete);
    ASSERT_EQ(on_seam.size(), 2U);
    for (const Point3 &x : on_seam.points) {
        EXPECT_LE(distance(x, {x[0] > 0 ? 0.8 : -0.8, 0, 0.6}), 1e-14);
    }
    // At a pole a derivative vanishes.
    const Common pole = common_of(a.get(), seam.get(), create(flat({0, 0, 0}, {0, 1, 0.1}, {0, 0, 1})).get());
    EXPECT_FALSE(pole.complete);
    for (const Point3 &x : pole.points) {
        EXPECT_LE(distance(x, {0, 0, x[2] > 0 ? 1.0 : -1.0}), 1e-2);
    }
}

TEST(CommonPoints, AnySize) {
    for (const double size : {1e-9, 1e-3, 1e6, 1e12}) {
        SCOPED_TRACE(size);
        const double r = size;
        const Handle a = create(ball(r, {0, 0, 0})), b = create(ball(r, {r, 0, 0})),
                     c = create(ball(r, {0, r, 0.2 * r}));
        const Common found = common_of(a.get(), b.get(), c.get());
        EXPECT_TRUE(found.complete);
        EXPECT_EQ(found.size(), 2U);
        check_points(found, {a.get(), b.get(), c.get()}, 1e-14 * size);
    }
}

} // namespace

} // namespace common_points
