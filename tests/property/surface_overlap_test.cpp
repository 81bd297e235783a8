// Laws of the regions in which two surfaces are one.
#include "made_shapes.h"
#include "overlap_regions.h"
#include "polygons.h"
#include "support/cases.h"
#include "support/generators.h"
#include "support/scale.h"
#include "surface_meets.h"

#include <numbers>

namespace surface_overlaps {

namespace {

constexpr double pi = std::numbers::pi, tolerance = 1e-6;

// All that holds of complete meets of surfaces of which nothing closes.
Overlap expect_regions(const nurbs *a, const nurbs *b, size_t count, int samples = 12) {
    Overlap overlap = overlap_of(a, b, tolerance);
    EXPECT_TRUE(overlap.crossing.found.complete);
    EXPECT_EQ(overlap.regions.size(), count);
    check_loops(overlap);
    check_curves(overlap.crossing, Ground(a, {false, false}), Ground(b, {false, false}));
    check_nodes(overlap.crossing, 1e-9);
    for (const Branch &branch : overlap.crossing.found.branches) {
        EXPECT_LE(branch.deviation, tolerance);
    }
    check_inside(overlap, a, b, tolerance, samples);
    return overlap;
}

using polygons::common_part;
using polygons::Corner;

using Quad = std::array<Corner, 4>; // at (0, 0), (1, 0), (1, 1), (0, 1)
// In the plane z = a x + b y.
SplineData bilinear(const Quad &quad, double slope_x, double slope_y) {
    SplineData data{{1, 1}, {2, 2}, {{0, 0, 1, 1}, {0, 0, 1, 1}}, 3, {}, {}, 0};
    for (const size_t i : std::array<size_t, 4>{0, 3, 1, 2}) {
        const auto &[x, y] = quad[i];
        data.points.insert(data.points.end(), {x, y, slope_x * x + slope_y * y});
    }
    return data;
}
// [-half, half]^2 in the plane z = 0.
SplineData bilinear_flat(double half) {
    return bilinear({{{-half, -half}, {half, -half}, {half, half}, {-half, half}}}, 0, 0);
}
Quad parallelogram_of(const Corner &at, const Corner &u, const Corner &v) {
    return {at,
            {at[0] + u[0], at[1] + u[1]},
            {at[0] + u[0] + v[0], at[1] + u[1] + v[1]},
            {at[0] + v[0], at[1] + v[1]}};
}

Handle elevated(const nurbs *g, int32_t axis, int32_t times) {
    return made([&](nurbs **out) { return nurbs_elevate(g, axis, times, out); });
}
Handle refined(const nurbs *g, int32_t axis, int64_t parts) {
    return made([&](nurbs **out) { return nurbs_refine_uniform(g, axis, parts, out); });
}
Handle part_of(const nurbs *g, const Place &u, const Place &v) {
    const double lower[] = {u[0], v[0]}, upper[] = {u[1], v[1]};
    return made([&](nurbs **out) { return nurbs_extract(g, lower, upper, out); });
}
Handle reversed(const nurbs *g, int32_t axis) {
    return made([&](nurbs **out) { return nurbs_reverse(g, axis, 0, out); });
}
Handle transposed(const nurbs *g) {
    const int32_t order[] = {1, 0};
    return made([&](nurbs **out) { return nurbs_transpose(g, order, out); });
}

// A parallelogram and a convex quadrilateral in one plane: the region is what is in both.
TEST(SurfaceOverlap, PlanePatches) {
    Random random(31);
    int regions = 0;
    for (int64_t i = 0; i < scaled(60); ++i) {
        SCOPED_TRACE(i);
        const Corner u{random.between(0.8, 2), random.between(-0.5, 0.5)},
            v{random.between(-0.5, 0.5), random.between(0.8, 2)};
        const Quad p = parallelogram_of({random.between(-1, 0), random.between(-1, 0)}, u, v);
        Quad q;
        const double turn = random.between(0, 2 * pi), x = random.between(-0.7, 0.7),
                     y = random.between(-0.7, 0.7);
        for (size_t k = 0; k < 4; ++k) {
            const double angle = turn + pi / 2 * (static_cast<double>(k) + random.between(-0.3, 0.3)),
                         r = random.between(0.9, 1.2);
            q[k] = {x + r * std::cos(angle), y + r * std::sin(angle)};
        }
        const double area = polygons::area_of(common_part({q.begin(), q.end()}, {p.begin(), p.end()})),
                     whole = polygons::area_of({p.begin(), p.end()});
        if (area < 1e-3) {
            continue;
        }
        SplineData other = bilinear(q, 0.3, -0.2);
        if (random.chance(40)) {
            for (int k = 0; k < 4; ++k) {
                other.weights.push_back(random.between(0.7, 1.4));
            }
        }
        const Handle a = create(bilinear(p, 0.3, -0.2));
        Handle b = create(other);
        if (random.chance(30)) {
            b = elevated(b.get(), 0, 2);
        }
        if (random.chance(30)) {
            b = refined(b.get(), 1, 3);
        }
        if (random.chance(30)) {
            b = reversed(b.get(), 1);
        }
        const Overlap overlap = expect_regions(a.get(), b.get(), 1);
        EXPECT_NEAR(surface_overlaps::area_of(overlap), area / whole, 1e-9);
        const Overlap exchanged = expect_regions(b.get(), a.get(), 1);
        EXPECT_NEAR(std::abs(surface_overlaps::area_of(exchanged, true)), area / whole, 1e-9);
        EXPECT_EQ(exchanged.crossing.found.branches.size(), overlap.crossing.found.branches.size());
        ++regions;
    }
    EXPECT_GT(regions, 0);
}

// A patch in the plane z = 0, of weights that differ by a factor of 10.
SplineData planar(Random &random, int degree, const Corner &middle, double size) {
    const double turn = random.between(0, 2 * pi);
    SplineData data = net_of({degree + 1, degree + 1}, {degree, degree}, true, [&](double u, double v) {
        const double x = size * (u - 0.5 + random.between(-0.1, 0.1)),
                     y = size * (v - 0.5 + random.between(-0.1, 0.1));
        return std::array<double, 4>{middle[0] + x * std::cos(turn) - y * std::sin(turn),
                                     middle[1] + x * std::sin(turn) + y * std::cos(turn), 0,
                                     random.between(0.3, 3)};
    });
    return data;
}

// What is proven along one of them only is proven, whichever comes first.
TEST(SurfaceOverlap, PlanarRationalPatchesInBothOrders) {
    Random random(33);
    for (int64_t i = 0; i < scaled(24); ++i) {
        SCOPED_TRACE(i);
        const Handle a = create(planar(random, random.whole(1, 3), {0, 0}, 1)),
                     b = create(planar(random, random.whole(1, 3), {0.3, 0.2}, 0.9));
        const Overlap overlap = expect_regions(a.get(), b.get(), 1),
                      exchanged = expect_regions(b.get(), a.get(), 1);
        EXPECT_EQ(exchanged.crossing.found.branches.size(), overlap.crossing.found.branches.size());
        EXPECT_NEAR(std::abs(surface_overlaps::area_of(exchanged, true)),
                    std::abs(surface_overlaps::area_of(overlap)), 1e-9);
    }
}

SplineData bumps(bool rational, int n) {
    return net_of({n, n}, {3, 3}, rational, [](double u, double v) {
        return std::array<double, 4>{4 * u, 4 * v, 0.4 * std::sin(5 * u) * std::cos(4 * v),
                                     1 + 0.2 * std::cos(3 * u + v)};
    });
}

// Two parts of one surface, whatever its form: the region is the common part of their parameters.
TEST(SurfaceOverlap, PartsOfOneSurface) {
    Random random(32);
    for (int64_t i = 0; i < scaled(20); ++i) {
        SCOPED_TRACE(i);
        const Handle whole = create(bumps(random.chance(50), random.whole(4, 8)));
        std::array<std::array<Place, 2>, 2> parts{};
        for (auto &part : parts) {
            for (Place &range : part) {
                const double from = random.chance(30) ? 0 : random.between(0, 0.45);
                range = {from, random.chance(30) ? 1 : random.between(0.55, 1)};
            }
        }
        double area = 1;
        for (size_t k = 0; k < 2; ++k) {
            area *= std::min(parts[0][k][1], parts[1][k][1]) - std::max(parts[0][k][0], parts[1][k][0]);
        }
        const Handle a = part_of(whole.get(), parts[0][0], parts[0][1]);
        Handle b = part_of(whole.get(), parts[1][0], parts[1][1]);
        if (random.chance(40)) {
            b = elevated(b.get(), random.whole(0, 1), 1);
        }
        if (random.chance(40)) {
            b = refined(b.get(), random.whole(0, 1), 2);
        }
        if (random.chance(40)) {
            b = reversed(b.get(), random.whole(0, 1));
        }
        if (random.chance(40)) {
            b = transposed(b.get());
        }
        const Overlap overlap = expect_regions(a.get(), b.get(), 1, 8);
        EXPECT_NEAR(surface_overlaps::area_of(overlap), area, 1e-7);
        const Overlap exchanged = expect_regions(b.get(), a.get(), 1, 4);
        EXPECT_NEAR(std::abs(surface_overlaps::area_of(exchanged, true)), area, 1e-7);
    }
}

SplineData tube(double r, double low, double high, double start, double sweep) {
    return revolved(segment(r, low, r, high), start, sweep);
}
SplineData ball(double r, double start) {
    return revolved(ellipse_arc(0, 0, r, r, -pi / 2, pi), start, 2 * pi);
}
SplineData ring(double big, double small, double start) {
    return revolved(ellipse_arc(big, 0, small, small, 0, 2 * pi), start, 2 * pi);
}

// Quadrics and tori that close: -v du along the boundary is the area, as axes close along u only.
struct Closed {
    SplineData a, b;
    double area; // in the domain of a
    size_t loops;
    const char *name;
};
std::vector<Closed> closed_shapes() {
    return {{tube(1, -3, 3, 0, 2 * pi), tube(1, -1, 2, 0.5, 2 * pi), 0.5, 2, "cylinders with other seams"},
            {tube(1, -3, 3, 0, 2 * pi), tube(1, -3, 3, 0, 2 * pi), 1, 2, "one cylinder"},
            {tube(1, -3, 3, 0, 2 * pi), tube(1, -1, 4, 1.2, 2 * pi), 2.0 / 3, 2,
             "cylinders one behind the other"},
            {tube(1, -2, 2, 0, pi / 2), tube(1, -1, 1, 0, 2 * pi), 0.5, 1, "a part of a cylinder"},
            {tube(1, -2, 2, 0, 2 * pi), tube(1, -1, 1, -pi / 4, pi / 2), 0.5 / 4, 1, "a patch over the seam"},
            {revolved(segment(2, 0, 1, 2), 0, 2 * pi), revolved(segment(1.75, 0.5, 0.5, 3), 1, 2 * pi), 0.75,
             2, "cones"},
            {revolved(segment(1, 0, 0.5, 0), 0.3, 2 * pi), bilinear_flat(2), 1, 2, "a ring in a plane"},
            {ring(3, 1, 0), ring(3, 1, 0.4), 0, 0, "a torus"},
            {ball(1, 0), ball(1, 0), 0, 0, "one sphere"},
            {ball(1, 0), ball(1, 1), 0, 0, "spheres with other seams"}};
}
TEST(SurfaceOverlap, ClosedShapes) {
    for (const Closed &shape : closed_shapes()) {
        SCOPED_TRACE(shape.name);
        const Handle a = create(shape.a), b = create(shape.b);
        const Overlap overlap = overlap_of(a.get(), b.get(), tolerance);
        EXPECT_TRUE(overlap.crossing.found.complete);
        ASSERT_EQ(overlap.regions.size(), 1U);
        EXPECT_EQ(overlap.regions[0].loops.size(), shape.loops);
        check_loops(overlap);
        check_curves(overlap.crossing, Ground(a.get(), shape.a), Ground(b.get(), shape.b));
        check_nodes(overlap.crossing, 1e-9);
        EXPECT_NEAR(surface_overlaps::area_of(overlap), shape.area, 1e-5);
        EXPECT_LE(distance(points_of(a.get(), {overlap.regions[0].inside_a})[0],
                           points_of(b.get(), {overlap.regions[0].inside_b})[0]),
                  tolerance);
    }
}

// Around a hole the region is on the left, too; circles touch lines along which parts are halved, if they begin at 0.
TEST(SurfaceOverlap, Holes) {
    for (const double start : {0.0, 0.2}) {
        for (const double hole : {0.5, 0.0}) {
            const SplineData data_a = bilinear_flat(2),
                             data_b = revolved(segment(1, 0, hole, 0), start, 2 * pi);
            const Handle a = create(data_a), b = create(data_b);
            const Overlap overlap = overlap_of(a.get(), b.get(), tolerance);
            EXPECT_TRUE(overlap.crossing.found.complete);
            ASSERT_EQ(overlap.regions.size(), 1U);
            EXPECT_EQ(overlap.regions[0].loops.size(), hole > 0 ? 2U : 1U);
            check_loops(overlap);
            check_curves(overlap.crossing, Ground(a.get(), data_a), Ground(b.get(), data_b));
            check_inside(overlap, a.get(), b.get(), tolerance, 12);
            EXPECT_NEAR(surface_overlaps::area_of(overlap), (1 - hole * hole) * pi / 16, 1e-5);
        }
    }
}

TEST(SurfaceOverlap, SeveralRegions) {
    // A strip in the plane z = 0 that bends round in it as a horseshoe, and a strip across both legs.
    const SplineData data_a = revolved(segment(2, 0, 1, 0), 0, pi);
    const SplineData data_b = bilinear({{{-3, 0.2}, {3, 0.2}, {3, 0.6}, {-3, 0.6}}}, 0, 0);
    const Handle a = create(data_a), b = create(data_b);
    const Overlap overlap = expect_regions(a.get(), b.get(), 2, 24);
    const Overlap exchanged = expect_regions(b.get(), a.get(), 2, 24);
    // Of the strip between y = 0.2 and y = 0.6, the parts between both circles.
    const auto below = [](double r, double y) {
        return (y * std::sqrt(r * r - y * y) + r * r * std::asin(y / r)) / 2;
    };
    const double area = 2 * (below(2, 0.6) - below(2, 0.2) - below(1, 0.6) + below(1, 0.2));
    EXPECT_NEAR(surface_overlaps::area_of(exchanged), area / (6 * 0.4), 1e-6);
    EXPECT_EQ(overlap.crossing.found.branches.size(), exchanged.crossing.found.branches.size());
}

// A loop of a curve, extruded, and a part of it: one region, and the curve in which the part crosses the other strand.
TEST(SurfaceOverlap, BesideACrossing) {
    const std::vector<Point3> legs{{0, 0, 0}, {3, 2, 0}, {-2, 2, 0}, {1, 0, 0}};
    SplineData loop{{3, 1}, {4, 2}, {{0, 0, 0, 0, 1, 1, 1, 1}, {0, 0, 1, 1}}, 3, {}, {}, 0};
    for (const Point3 &x : legs) {
        loop.points.insert(loop.points.end(), {x[0], x[1], 0, x[0], x[1], 1});
    }
    const Handle a = create(loop), b = part_of(a.get(), {0.05, 0.45}, {0.2, 0.9});
    const Overlap overlap = overlap_of(a.get(), b.get(), tolerance);
    EXPECT_TRUE(overlap.crossing.found.complete);
    ASSERT_EQ(overlap.regions.size(), 1U);
    EXPECT_NEAR(surface_overlaps::area_of(overlap), 0.4 * 0.7, 1e-9);
    EXPECT_EQ(std::ranges::count(overlap.crossing.kinds, NURBS_BRANCH_CROSSING), 1);
    check_loops(overlap);
    check_curves(overlap.crossing, Ground(a.get(), loop), Ground(b.get(), {false, false}));
}

// A strip that lies on a square, goes round, and comes back to touch it in a crease, or to end on it in one more overlap that is left
// open: what is no region is told beside it, or left open.
TEST(SurfaceOverlap, BesideWhatIsNone) {
    const std::vector<std::vector<Corner>> profiles{
        {{0, 0}, {1, 0}, {2, 1}, {1, 1}, {0.5, 0}, {0.2, 1}},
        {{0, 0}, {1, 0}, {2, 1}, {1, 1}, {0.7, 0}, {0.3, 0}, {0.2, 1}}};
    for (const std::vector<Corner> &profile : profiles) {
        SplineData strip{{1, 1}, {std::ssize(profile), 2}, {{0}, {0, 0, 1, 1}}, 3, {}, {}, 0};
        for (size_t i = 0; i < profile.size(); ++i) {
            strip.knots[0].push_back(static_cast<double>(i));
            strip.points.insert(strip.points.end(),
                                {profile[i][0], 0, profile[i][1], profile[i][0], 1, profile[i][1]});
        }
        strip.knots[0].push_back(static_cast<double>(profile.size() - 1));
        const Handle a = create(strip), b = create(bilinear({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}, 0, 0));
        const Overlap overlap = overlap_of(a.get(), b.get(), tolerance);
        ASSERT_LE(overlap.regions.size(), 1U);
        if (overlap.regions.size() == 1) {
            EXPECT_NEAR(surface_overlaps::area_of(overlap), 1, 1e-9);
        }
        const bool crosses = std::ranges::count(overlap.crossing.kinds, NURBS_BRANCH_CROSSING) > 0;
        EXPECT_TRUE(!overlap.crossing.found.complete || (crosses && profile.size() == 6));
    }
}

// What shares an edge or a corner only has no region, nor has what double precision tells apart.
TEST(SurfaceOverlap, NoRegions) {
    struct Pair {
        SplineData a, b;
        const char *name;
    };
    const SplineData unit = bilinear({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}, 0, 0);
    const std::vector<Pair> pairs{
        {unit, support::moved(unit, {1, 0, 0}), "side by side"},
        {unit, support::moved(unit, {1, 1, 0}), "a common corner"},
        {unit, support::moved(unit, {1, 0.4, 0}), "a part of a side"},
        {unit, support::moved(unit, {0.3, 0.4, 3e-6}), "parallel, beyond the tolerance"},
        {unit, support::moved(unit, {0.3, 0.4, 5e-7}), "parallel, within the tolerance"},
        {unit, turned(unit), "at right angles"},
        {tube(1, 0, 2, 0, 2 * pi), support::moved(bilinear_flat(3), {0, 0, 1}), "a plane across a cylinder"},
        {tube(1, -1, 1, 0, pi), support::moved(turned(unit), {1, -0.5, -0.5}),
         "a plane that touches a cylinder"}};
    for (const Pair &pair : pairs) {
        SCOPED_TRACE(pair.name);
        const Handle a = create(pair.a), b = create(pair.b);
        const Overlap overlap = overlap_of(a.get(), b.get(), tolerance);
        EXPECT_EQ(overlap.regions.size(), 0U);
        EXPECT_EQ(std::ranges::count(overlap.crossing.kinds, NURBS_BRANCH_OVERLAP), 0);
    }
}

// Where surfaces part inside of their borders there is no region, but it is said that something is left open.
TEST(SurfaceOverlap, PartingInsideIsLeftOpen) {
    SplineData folded{{1, 1}, {3, 2}, {{0, 0, 1, 2, 2}, {0, 0, 1, 1}}, 3, {}, {}, 0};
    for (const Point3 &x : std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0.5}}) {
        folded.points.insert(folded.points.end(), {x[0], 0, x[2], x[0], 1, x[2]});
    }
    SplineData bent = bumps(false, 8);
    bent.points[3 * (4 * 8 + 4) + 2] += 1e-3;
    const std::vector<std::pair<SplineData, SplineData>> pairs{{bilinear_flat(3), folded},
                                                               {bumps(false, 8), bent}};
    for (const auto &[first, second] : pairs) {
        const Handle a = create(first), b = create(second);
        const Overlap overlap = overlap_of(a.get(), b.get(), tolerance);
        EXPECT_EQ(overlap.regions.size(), 0U);
        EXPECT_FALSE(overlap.crossing.found.complete);
    }
}

// From y = 0 to 1 in the plane z = 0, by the control points along x of pieces that are joined end to end; one
// of these is higher up in the middle.
SplineData strip_with_bump(int degree, const std::vector<double> &x, size_t bump, double height) {
    SplineData data{{degree, 4}, {std::ssize(x), 5}, {{0}, {0, 0, 0, 0, 0, 1, 1, 1, 1, 1}}, 3, {}, {}, 0};
    for (size_t i = 0; i < x.size(); ++i) {
        data.knots[0].push_back(static_cast<double>(i / static_cast<size_t>(degree)));
        for (size_t j = 0; j < 5; ++j) {
            data.points.insert(data.points.end(),
                               {x[i], static_cast<double>(j) / 4, i == bump && j == 2 ? height : 0});
        }
    }
    data.knots[0].insert(data.knots[0].end(), static_cast<size_t>(degree), data.knots[0].back());
    return data;
}
SplineData strip_of_plane(const std::vector<double> &x) {
    SplineData data{
        {static_cast<int32_t>(x.size()) - 1, 1}, {std::ssize(x), 2}, {{}, {0, 0, 1, 1}}, 3, {}, {}, 0};
    data.knots[0].assign(x.size(), 0);
    data.knots[0].insert(data.knots[0].end(), x.size(), 1);
    for (const double at : x) {
        data.points.insert(data.points.end(), {at, 0, 0, at, 1, 0});
    }
    return data;
}

// A bump in a short piece is no overlap, although the plane runs along the pieces beside.
TEST(SurfaceOverlap, BumpsInShortPieces) {
    struct Pair {
        SplineData plane, strip;
        double tolerance;
        const char *name;
    };
    const double slow = 1.9947; // in the middle of its piece
    const std::vector<Pair> pairs{
        {strip_of_plane({0, 0.05, 1}),
         strip_with_bump(2, {-2, -0.825, 0.35, 0.55, 0.75, 0.85, 0.95, 1.475, 2}, 5, 1e-3), 1e-6,
         "the next piece but one, after a short one"},
        {strip_of_plane({0.9, 1.01}),
         strip_with_bump(3, {-1, slow - 1, 1 - slow, 1, 1.002, 1.004, 1.006, 1.3, 1.6, 2}, 4, 0.03), 1e-3,
         "a piece after one that is far slower in the middle than at its ends"}};
    for (const Pair &pair : pairs) {
        SCOPED_TRACE(pair.name);
        const Handle a = create(pair.plane), b = create(pair.strip);
        for (const auto &[first, second] : {std::pair(a.get(), b.get()), std::pair(b.get(), a.get())}) {
            const Overlap overlap = overlap_of(first, second, pair.tolerance);
            EXPECT_EQ(overlap.regions.size(), 0U);
            EXPECT_FALSE(overlap.crossing.found.complete);
        }
    }
}

// Copies of which one control point is moved: a region only if all of it is within the tolerance.
TEST(SurfaceOverlap, MovedCopies) {
    for (const double by : {1e-13, 1e-9, 1e-7, 3e-7, 3e-6, 1e-5, 1e-4}) {
        SCOPED_TRACE(by);
        SplineData moved = bumps(true, 7);
        moved.points[3 * (3 * 7 + 3) + 2] += by;
        const Handle a = create(bumps(true, 7)), b = create(moved);
        const Overlap overlap = overlap_of(a.get(), b.get(), tolerance);
        if (by <= 1e-7) {
            EXPECT_EQ(overlap.regions.size(), 1U);
        }
        if (by >= 1e-5) {
            EXPECT_EQ(overlap.regions.size(), 0U);
        }
        if (overlap.regions.size() == 1) {
            EXPECT_NEAR(surface_overlaps::area_of(overlap), 1, 1e-9);
            check_inside(overlap, a.get(), b.get(), tolerance / 2, 6);
        }
    }
}

// Nothing depends on units, and nothing is told that a limit of work leaves open.
TEST(SurfaceOverlap, ScalesAndLimits) {
    const Handle whole = create(bumps(true, 6)), other = part_of(whole.get(), {0.2, 0.9}, {0.1, 0.6});
    for (const double size : {0x1p-40, 1e-6, 1e6, 0x1p60}) {
        const SplineData data = scaled(bumps(true, 6), size, 1);
        const Handle a = create(data), b = part_of(a.get(), {0.2, 0.9}, {0.1, 0.6});
        const Overlap overlap = overlap_of(a.get(), b.get(), tolerance * size);
        EXPECT_TRUE(overlap.crossing.found.complete);
        ASSERT_EQ(overlap.regions.size(), 1U);
        EXPECT_NEAR(surface_overlaps::area_of(overlap), 0.35, 1e-7);
    }
    nurbs_call_options call;
    require_ok(nurbs_call_options_init(&call, sizeof call));
    bool complete = false;
    for (call.work = 1; call.work < 2000000000; call.work *= 4) {
        SCOPED_TRACE(call.work);
        const Overlap overlap = overlap_of(whole.get(), other.get(), tolerance, &call);
        complete = overlap.crossing.found.complete;
        if (!overlap.regions.empty()) {
            EXPECT_EQ(overlap.regions.size(), 1U);
            EXPECT_NEAR(surface_overlaps::area_of(overlap), 0.35, 1e-7);
        }
        EXPECT_TRUE(complete || overlap.crossing.found.count(NURBS_NODE_UNDECIDED) > 0);
    }
    EXPECT_TRUE(complete);
}

} // namespace

} // namespace surface_overlaps
