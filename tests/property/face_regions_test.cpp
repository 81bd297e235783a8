// Laws of the regions that two faces have in common: of polygons in a plane their areas are known.
#include "face_regions.h"
#include "faces.h"
#include "support/cases.h"
#include "support/scale.h"

#include <numbers>

namespace face_regions {

namespace {

using namespace support;

constexpr double tolerance = 1e-7;

using Corner = std::array<double, 2>;
using Polygon = std::vector<Corner>; // anticlockwise, or clockwise around a hole

// x = origin + s first + t second.
struct Plane {
    Point3 origin{}, first{1, 0, 0}, second{0, 1, 0};

    [[nodiscard]] Point3 at(const Corner &place) const {
        Point3 x{};
        for (size_t k = 0; k < 3; ++k) {
            x[k] = origin[k] + place[0] * first[k] + place[1] * second[k];
        }
        return x;
    }
    // Of a point in it.
    [[nodiscard]] Corner place_of(const Point3 &x) const {
        const Point3 from{x[0] - origin[0], x[1] - origin[1], x[2] - origin[2]};
        const auto dot = [](const Point3 &a, const Point3 &b) {
            return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        };
        const double p = dot(first, first), q = dot(first, second), r = dot(second, second),
                     f = dot(first, from), g = dot(second, from), det = p * r - q * q;
        return {(r * f - q * g) / det, (p * g - q * f) / det};
    }
};

Plane random_plane(Random &random) {
    Plane plane;
    for (size_t k = 0; k < 3; ++k) {
        plane.origin[k] = random.between(-1, 1);
        plane.first[k] += random.between(-0.3, 0.3);
        plane.second[k] += random.between(-0.3, 0.3);
    }
    return plane;
}

// The parallelogram corner + p u + q v of a plane.
struct Patch {
    Corner corner{-4, -4}, u{9, 0}, v{0, 9};
};
Patch random_patch(Random &random) {
    const double turn = random.between(-3, 3), far = random.between(10, 14);
    const Corner u{far * std::cos(turn), far * std::sin(turn)};
    const double sense = random.chance(50) ? 1 : -1, skew = random.between(-0.2, 0.2);
    const Corner v{sense * (-u[1] + skew * u[0]), sense * (u[0] + skew * u[1])};
    return {{1.5 - (u[0] + v[0]) / 2, 1 - (u[1] + v[1]) / 2}, u, v};
}

// Sides that are all but parallel cross where rounding tells, and may be left open.
bool are_all_but_parallel(const Patch &a, const Patch &b) {
    const auto parallel = [](const Corner &x, const Corner &y) {
        return std::abs(x[0] * y[1] - x[1] * y[0]) < 0.01 * std::hypot(x[0], x[1]) * std::hypot(y[0], y[1]);
    };
    return parallel(a.u, b.u) || parallel(a.u, b.v) || parallel(a.v, b.u) || parallel(a.v, b.v);
}
Patch patch_beside(Random &random, const Patch &other) {
    for (;;) {
        const Patch patch = random_patch(random);
        if (!are_all_but_parallel(patch, other)) {
            return patch;
        }
    }
}

Handle segment(const Corner &from, const Corner &to) {
    return create({{1}, {2}, {{0, 0, 1, 1}}, 2, {from[0], from[1], to[0], to[1]}, {}});
}

// The part of a patch that polygons bound; without any all of it.
Face face_in(const Plane &plane, const Patch &patch, const std::vector<Polygon> &loops, double size = 1) {
    SplineData data{{1, 1}, {2, 2}, {{0, 0, 1, 1}, {0, 0, 1, 1}}, 3, {}, {}, 0};
    for (const double p : {0.0, 1.0}) {
        for (const double q : {0.0, 1.0}) {
            const Point3 x = plane.at({patch.corner[0] + p * patch.u[0] + q * patch.v[0],
                                       patch.corner[1] + p * patch.u[1] + q * patch.v[1]});
            data.points.insert(data.points.end(), x.begin(), x.end());
        }
    }
    const double det = patch.u[0] * patch.v[1] - patch.u[1] * patch.v[0];
    const auto param = [&](const Corner &x) {
        const double s = x[0] - patch.corner[0], t = x[1] - patch.corner[1];
        return Corner{(s * patch.v[1] - t * patch.v[0]) / det, (t * patch.u[0] - s * patch.u[1]) / det};
    };
    std::vector<Handle> curves;
    faces::Curves given;
    for (const Polygon &loop : loops) {
        given.emplace_back();
        for (size_t i = 0; i < loop.size(); ++i) {
            curves.push_back(segment(param(loop[i]), param(loop[(i + 1) % loop.size()])));
            given.back().push_back(curves.back().get());
        }
    }
    return Face(faces::face_of(create(data).get(), given, 1e-9 * size).release());
}

Polygon rectangle(double left, double low, double right, double high) {
    return {{left, low}, {right, low}, {right, high}, {left, high}};
}
Polygon rectangle_of(const Patch &patch) {
    const auto &[c, u, v] = patch;
    return {
        c, {c[0] + u[0], c[1] + u[1]}, {c[0] + u[0] + v[0], c[1] + u[1] + v[1]}, {c[0] + v[0], c[1] + v[1]}};
}
Polygon backwards(Polygon polygon) {
    std::ranges::reverse(polygon);
    return polygon;
}

// By the curves in space, in the coordinates of the plane.
double area_in(const Overlap &overlap, const Plane &plane) {
    double area = 0;
    for (const Region &region : overlap.regions) {
        double own = 0;
        for (const std::vector<size_t> &loop : region.loops) {
            for (const size_t i : loop) {
                const Branch &branch = overlap.crossing.found.branches[i];
                const std::vector<Point3> x = points_on(branch.space.get(), branch.params(64));
                for (size_t k = 0; k + 1 < x.size(); ++k) {
                    const Corner p = plane.place_of(x[k]), q = plane.place_of(x[k + 1]);
                    own += (p[0] * q[1] - q[0] * p[1]) / 2;
                }
            }
        }
        area += std::abs(own);
    }
    return area;
}

// All that holds of faces in a plane.
Overlap expect_regions(const nurbs_face *a, const nurbs_face *b, size_t count, int samples = 9) {
    Overlap overlap = regions_of(a, b, tolerance);
    EXPECT_TRUE(overlap.crossing.found.complete);
    EXPECT_EQ(overlap.regions.size(), count);
    check_loops(overlap);
    const Handle on_a = surface_of(a), on_b = surface_of(b);
    check_curves(overlap.crossing, Ground(on_a.get(), {false, false}), Ground(on_b.get(), {false, false}),
                 40);
    check_nodes(overlap.crossing, 1e-9);
    for (const Branch &branch : overlap.crossing.found.branches) {
        EXPECT_LE(branch.deviation, tolerance);
    }
    check_places(overlap, a, b, tolerance, samples);
    return overlap;
}

struct FlatCase {
    const char *name;
    std::vector<Polygon> a, b;
    size_t regions;
    double area, edges;
};

const Polygon square = rectangle(0, 0, 1, 1);

std::vector<FlatCase> flat_cases() {
    const Polygon bay{{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
    const Polygon corner{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}},
        other_corner{{2, 2}, {0.5, 2}, {0.5, 1.5}, {1.5, 1.5}, {1.5, 0.5}, {2, 0.5}};
    const Polygon hole = backwards(rectangle(0.25, 0.25, 0.75, 0.75));
    return {
        {"a quarter", {square}, {rectangle(0.5, 0.5, 1.5, 1.5)}, 1, 0.25, 0},
        {"inside", {square}, {rectangle(0.25, 0.375, 0.5, 0.875)}, 1, 0.125, 0},
        {"a hole that is covered", {square, hole}, {rectangle(-1, -1, 2, 2)}, 1, 0.75, 0},
        {"a hole that is cut", {square, hole}, {rectangle(0.5, -1, 2, 2)}, 1, 0.375, 0},
        {"a hole that is filled", {square, hole}, {rectangle(0.25, 0.25, 0.75, 0.75)}, 0, 0, 2},
        {"a hole in each",
         {rectangle(0, 0, 3, 2), backwards(rectangle(0.5, 0.5, 1, 1.5))},
         {rectangle(0, 0, 3, 2), backwards(rectangle(2, 0.5, 2.5, 1.5))},
         1,
         5,
         0},
        {"side by side", {square}, {rectangle(1, 0, 2, 1)}, 0, 0, 1},
        {"half a side", {square}, {rectangle(1, 0.5, 2, 1.5)}, 0, 0, 0.5},
        {"at a corner", {square}, {rectangle(1, 1, 2, 2)}, 0, 0, 0},
        {"apart", {square}, {rectangle(1.25, 0, 2, 1)}, 0, 0, 0},
        {"identical", {square}, {square}, 1, 1, 0},
        {"a common side", {square}, {rectangle(0, 0.25, 1, 0.75)}, 1, 0.5, 0},
        {"two regions", {bay}, {rectangle(-1, 1.25, 4, 1.75)}, 2, 1, 0},
        {"corners", {corner}, {other_corner}, 2, 0.5, 0},
        {"a bay that is filled", {bay}, {rectangle(1, 1, 2, 2)}, 0, 0, 3},
        {"a side and a region", {bay}, {rectangle(1, 0.5, 2, 2)}, 1, 0.5, 2},
    };
}

} // namespace

TEST(FaceRegions, PolygonsInAPlane) {
    for_each_case(7710000, 8, [](Random &random, uint64_t seed) {
        SCOPED_TRACE(seed);
        const Plane plane = random_plane(random);
        for (const FlatCase &own : flat_cases()) {
            SCOPED_TRACE(own.name);
            const Patch patch = random_patch(random);
            const Face a = face_in(plane, patch, own.a),
                       b = face_in(plane, patch_beside(random, patch), own.b);
            const Overlap overlap = expect_regions(a.get(), b.get(), own.regions),
                          exchanged = expect_regions(b.get(), a.get(), own.regions);
            for (const Overlap *found : {&overlap, &exchanged}) {
                EXPECT_NEAR(area_in(*found, plane), own.area, 1e-9);
                EXPECT_EQ(found->crossing.found.count(NURBS_NODE_OVERLAP), static_cast<int64_t>(own.regions));
            }
            EXPECT_NEAR(length_of(overlap, NURBS_BRANCH_EDGE), length_of(exchanged, NURBS_BRANCH_EDGE), 1e-9);
            EXPECT_EQ(length_of(overlap, NURBS_BRANCH_EDGE) > 0, own.edges > 0);
        }
    });
}

// In the plane of the coordinates lengths are what they are.
TEST(FaceRegions, EdgesOfPolygons) {
    for (const FlatCase &own : flat_cases()) {
        SCOPED_TRACE(own.name);
        const Face a = face_in({}, {}, own.a), b = face_in({}, {{-3, -2}, {0, 8}, {7, 1}}, own.b);
        const Overlap overlap = expect_regions(a.get(), b.get(), own.regions);
        EXPECT_NEAR(length_of(overlap, NURBS_BRANCH_EDGE), own.edges, 1e-9);
        EXPECT_NEAR(area_in(overlap, {}), own.area, 1e-9);
    }
}

} // namespace face_regions

namespace face_regions {

// Borders that are off each other by less than the tolerance are one.
TEST(FaceRegions, WithinTheTolerance) {
    for_each_case(7740000, 3, [](Random &random, uint64_t seed) {
        SCOPED_TRACE(seed);
        for (const FlatCase &own : flat_cases()) {
            SCOPED_TRACE(own.name);
            Plane off;
            off.origin = {random.between(-0.2, 0.2) * tolerance, random.between(-0.2, 0.2) * tolerance, 0};
            const Patch patch = random_patch(random);
            const Face a = face_in({}, patch, own.a), b = face_in(off, patch_beside(random, patch), own.b);
            for (const bool exchanged : {false, true}) {
                const Overlap overlap = exchanged ? regions_of(b.get(), a.get(), tolerance)
                                                  : regions_of(a.get(), b.get(), tolerance);
                EXPECT_TRUE(overlap.crossing.found.complete);
                EXPECT_EQ(overlap.regions.size(), own.regions);
                check_loops(overlap);
                EXPECT_NEAR(area_in(overlap, {}), own.area, 10 * tolerance);
                EXPECT_NEAR(length_of(overlap, NURBS_BRANCH_EDGE), own.edges, 10 * tolerance);
            }
        }
    });
}

namespace {

// All of a parallelogram; sides of them may run along each other, where it takes what is beyond to tell that there is no more.
Face patch_in(const Plane &plane, const Patch &patch) {
    return face_in(plane, patch, {rectangle_of(patch)});
}

} // namespace

TEST(FaceRegions, WholePatches) {
    struct Pair {
        const char *name;
        Patch a, b;
        size_t regions;
        double area, edges;
    };
    const Patch unit{{0, 0}, {1, 0}, {0, 1}};
    const std::vector<Pair> pairs{
        {"identical", unit, unit, 1, 1, 0},
        {"turned", unit, {{1, 1}, {0, -1}, {-1, 0}}, 1, 1, 0},
        {"a quarter", unit, {{0.5, 0.5}, {1, 0}, {0, 1}}, 1, 0.25, 0},
        {"side by side", unit, {{1, 0}, {1, 0}, {0, 1}}, 0, 0, 1},
        {"half a side", unit, {{1, 0.5}, {0.5, 0}, {0, 2}}, 0, 0, 0.5},
        {"oblique", unit, {{1, -1}, {0, 1.5}, {1, 1}}, 0, 0, 0.5},
        {"at a corner", unit, {{1, 1}, {1, 0}, {0, 1}}, 0, 0, 0},
        {"apart, with common boxes", {{0, 0}, {1, 1}, {-1, 1}}, {{1.1, -1.1}, {1, 1}, {-1, 1}}, 0, 0, 0},
        {"a strip along a side", unit, {{0.875, 0}, {1, 0}, {0, 1}}, 1, 0.125, 0},
    };
    for (const Pair &own : pairs) {
        SCOPED_TRACE(own.name);
        const Face a = patch_in({}, own.a), b = patch_in({}, own.b);
        const Overlap overlap = expect_regions(a.get(), b.get(), own.regions),
                      exchanged = expect_regions(b.get(), a.get(), own.regions);
        for (const Overlap *found : {&overlap, &exchanged}) {
            EXPECT_NEAR(area_in(*found, {}), own.area, 1e-9);
            EXPECT_NEAR(length_of(*found, NURBS_BRANCH_EDGE), own.edges, 1e-9);
        }
    }
}

namespace {

constexpr double pi = std::numbers::pi;

// Turned around the z axis, and moved along it.
Handle turned(const nurbs *g, double angle, double up) {
    const double c = std::cos(angle), s = std::sin(angle);
    const double matrix[] = {c, -s, 0, s, c, 0, 0, 0, 1}, move[] = {0, 0, up};
    return made([&](nurbs **out) { return nurbs_transform(g, 3, matrix, move, out); });
}

// The part of a surface between values of both parameters, as shares of the domain; those of axes that close may go beyond it.
Face window(const Handle &surface, const Place &u, const Place &v) {
    double domain[2][2];
    require_ok(nurbs_domain(surface.get(), 0, domain[0]));
    require_ok(nurbs_domain(surface.get(), 1, domain[1]));
    const auto at = [&](double s, double t) {
        return Place{domain[0][0] + s * (domain[0][1] - domain[0][0]),
                     domain[1][0] + t * (domain[1][1] - domain[1][0])};
    };
    const Handle border = faces::polygon({at(u[0], v[0]), at(u[1], v[0]), at(u[1], v[1]), at(u[0], v[1])});
    return Face(faces::face_of(surface.get(), {{border.get()}}).release());
}
Face all_of(const Handle &surface) {
    return Face(faces::face_of(surface.get(), {}).release());
}

struct RoundCase {
    const char *name;
    Face a, b;
    size_t regions;
    double area;
};

void expect_round(const RoundCase &own) {
    SCOPED_TRACE(own.name);
    for (const bool exchanged : {false, true}) {
        const nurbs_face *a = (exchanged ? own.b : own.a).get(), *b = (exchanged ? own.a : own.b).get();
        const Handle on_a = surface_of(a), on_b = surface_of(b);
        const Overlap overlap = regions_of(a, b, tolerance);
        EXPECT_TRUE(overlap.crossing.found.complete);
        EXPECT_EQ(overlap.regions.size(), own.regions);
        check_loops(overlap);
        EXPECT_NEAR(area_on(on_a.get(), overlap), own.area, 1e-6);
        for (const Branch &branch : overlap.crossing.found.branches) {
            EXPECT_LE(branch.deviation, 2 * tolerance);
        }
    }
}

} // namespace

TEST(FaceRegions, OnACylinder) {
    const Handle lower = std::move(faces::cylinder(1, 2).surface), upper = turned(lower.get(), 0.7, 1);
    // Quarters of the domain are quarters of the circle.
    expect_round({"all of both", all_of(lower), all_of(upper), 1, 2 * pi});
    expect_round({"a window in a band", window(lower, {0.25, 0.5}, {0.25, 0.75}), all_of(upper), 1, pi / 4});
    expect_round({"windows", window(lower, {0.25, 0.75}, {0.25, 0.75}),
                  window(turned(lower.get(), pi / 2, 0.5), {0.25, 0.75}, {0.25, 0.75}), 1, pi / 4});
    expect_round({"over the seam", window(lower, {-0.25, 0.25}, {0.25, 0.75}), all_of(upper), 1, pi / 2});
    expect_round({"two regions", window(lower, {0.125, 0.875}, {0.25, 0.75}),
                  window(turned(lower.get(), pi, 0), {0.125, 0.875}, {0, 1}), 2, pi});
    expect_round({"one window", window(lower, {0.25, 0.5}, {0.25, 0.75}),
                  window(lower, {0.25, 0.5}, {0.25, 0.75}), 1, pi / 2});
}

namespace {

// Of a globe, what is above a share of the second axis, or below.
Face cap(const Handle &ball, double share, bool above) {
    double u[2], v[2];
    require_ok(nurbs_domain(ball.get(), 0, u));
    require_ok(nurbs_domain(ball.get(), 1, v));
    const double at = v[0] + share * (v[1] - v[0]);
    const Handle parallel = above ? segment({u[0], at}, {u[1], at}) : segment({u[1], at}, {u[0], at});
    return Face(faces::face_of(ball.get(), {{parallel.get()}}, 1e-9, NURBS_AS_ORIENTED).release());
}

} // namespace

TEST(FaceRegions, OnASphere) {
    const Handle ball = std::move(faces::sphere(1).surface), other = turned(ball.get(), 0.7, 0);
    // From the pole on heights are -1 to 1; the second axis has two quarters.
    expect_round(
        {"a window", window(ball, {0.25, 0.5}, {0.25, 0.5}), all_of(other), 1, std::sqrt(0.5) * pi / 2});
    expect_round({"one window", window(ball, {0.25, 0.5}, {0.25, 0.5}),
                  window(ball, {0.25, 0.5}, {0.25, 0.5}), 1, std::sqrt(0.5) * pi / 2});
    const double of_cap = 2 * pi * (1 - std::sqrt(0.5));
    expect_round({"a cap", cap(ball, 0.75, true), cap(other, 0.5, true), 1, of_cap});
    expect_round({"one cap", cap(ball, 0.75, true), cap(other, 0.75, true), 1, of_cap});
    expect_round({"caps apart", cap(ball, 0.75, true), cap(other, 0.25, false), 0, 0});
    expect_round({"a zone", cap(ball, 0.25, true), cap(other, 0.75, false), 1, 4 * pi - 2 * of_cap});
}

TEST(FaceRegions, OnATorus) {
    const Handle ring = std::move(faces::torus(3, 1).surface), other = turned(ring.get(), 0.4, 0);
    expect_round({"all of both", all_of(ring), all_of(other), 1, 12 * pi * pi});
    expect_round(
        {"a window", window(ring, {0.25, 0.5}, {-0.25, 0.25}), all_of(other), 1, (6 * pi + 4) * pi / 4});
}

namespace {

SplineData bumps(bool rational, int n) {
    return net_of({n, n}, {3, 3}, rational, [](double u, double v) {
        return std::array<double, 4>{4 * u, 4 * v, 0.4 * std::sin(5 * u) * std::cos(4 * v),
                                     1 + 0.2 * std::cos(3 * u + v)};
    });
}

struct Disc {
    Corner centre;
    double radius;
};
Face disc_on(const Handle &surface, const Disc &disc, bool exchanged = false) {
    const Corner centre = exchanged ? Corner{disc.centre[1], disc.centre[0]} : disc.centre;
    const Handle circle = made([&](nurbs **out) {
        return nurbs_curve_circle(2, centre.data(), nullptr, nullptr, disc.radius, NURBS_ARC_QUARTERS, out);
    });
    return Face(faces::face_of(surface.get(), {{circle.get()}}).release());
}
// Of what two discs have in common.
double common_area(const Disc &a, const Disc &b) {
    const double d = std::hypot(a.centre[0] - b.centre[0], a.centre[1] - b.centre[1]);
    if (d >= a.radius + b.radius) {
        return 0;
    }
    if (d <= std::abs(a.radius - b.radius)) {
        return pi * std::pow(std::min(a.radius, b.radius), 2);
    }
    const auto segment = [d](double r, double other) {
        const double x = (d * d + r * r - other * other) / (2 * d);
        return r * r * std::acos(x / r) - x * std::sqrt(r * r - x * x);
    };
    return segment(a.radius, b.radius) + segment(b.radius, a.radius);
}

} // namespace

// Of one surface, whatever its form: the region is what both discs have in common in the domain.
TEST(FaceRegions, DiscsOnASurface) {
    for_each_case(7720000, 6, [](Random &random, uint64_t seed) {
        SCOPED_TRACE(seed);
        const Handle surface = create(bumps(random.chance(50), random.whole(4, 6)));
        Handle other(nullptr);
        const bool exchanged = random.chance(30);
        if (exchanged) {
            const int32_t order[] = {1, 0};
            other = made([&](nurbs **out) { return nurbs_transpose(surface.get(), order, out); });
        } else {
            other = made(
                [&](nurbs **out) { return nurbs_refine_uniform(surface.get(), random.whole(0, 1), 2, out); });
        }
        if (random.chance(30)) {
            const Handle before = std::move(other);
            other = made([&](nurbs **out) { return nurbs_elevate(before.get(), 0, 1, out); });
        }
        const auto disc = [&] {
            return Disc{{random.between(0.4, 0.6), random.between(0.4, 0.6)}, random.between(0.1, 0.3)};
        };
        const Disc first = disc(), second = random.chance(20) ? first : disc();
        const Face a = disc_on(surface, first), b = disc_on(other, second, exchanged);
        const double area = common_area(first, second);
        const Overlap overlap = expect_regions(a.get(), b.get(), area > 0 ? 1 : 0, 6),
                      back = expect_regions(b.get(), a.get(), area > 0 ? 1 : 0, 6);
        EXPECT_NEAR(surface_overlaps::area_of(overlap), area, 1e-6);
        EXPECT_NEAR(surface_overlaps::area_of(back), area, 1e-6);
    });
}

// Nothing wrong is told that a limit of work leaves open, and sizes do not matter.
TEST(FaceRegions, ScalesAndLimits) {
    const Polygon first = rectangle(0, 0, 1, 1), second = rectangle(0.5, 0.25, 1.5, 0.75);
    for (const double size : {0x1p-40, 1e-6, 1e6, 0x1p60}) {
        const Plane plane{{size, 2 * size, -size}, {size, 0, 0.25 * size}, {0, size, 0}};
        const Face a = face_in(plane, {}, {first}, size),
                   b = face_in(plane, {{-3, -2}, {0, 8}, {7, 1}}, {second}, size);
        const Overlap overlap = regions_of(a.get(), b.get(), tolerance * size);
        EXPECT_TRUE(overlap.crossing.found.complete);
        ASSERT_EQ(overlap.regions.size(), 1U);
        EXPECT_NEAR(area_in(overlap, plane), 0.25, 1e-9);
    }
    const Face a = face_in({}, {}, {first}), b = face_in({}, {{-3, -2}, {0, 8}, {7, 1}}, {second});
    nurbs_call_options call;
    require_ok(nurbs_call_options_init(&call, sizeof call));
    bool complete = false;
    for (call.work = 1; call.work < 2000000000; call.work *= 10) {
        SCOPED_TRACE(call.work);
        const Overlap overlap = regions_of(a.get(), b.get(), tolerance, &call);
        complete = overlap.crossing.found.complete;
        EXPECT_EQ(overlap.regions.size(), complete ? 1U : 0U);
        EXPECT_TRUE(!complete || std::abs(area_in(overlap, {}) - 0.25) < 1e-9);
    }
    EXPECT_TRUE(complete);
}

} // namespace face_regions
