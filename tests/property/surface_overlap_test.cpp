// Laws of the regions in which two surfaces are one.
#include "made_shapes.h"
#include "overlap_regions.h"
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

using Corner = std::array<double, 2>;

// The part of a convex polygon in another one, both anticlockwise (Sutherland & Hodgman 1974).
std::vector<Corner> common_part(std::vector<Corner> part, const std::vector<Corner> &of) {
    for (size_t i = 0; i < of.size(); ++i) {
        const Corner &p = of[i], &q = of[(i + 1) % of.size()];
        const auto side = [&](const Corner &x) {
            return (q[0] - p[0]) * (x[1] - p[1]) - (q[1] - p[1]) * (x[0] - p[0]);
        };
        std::vector<Corner> left;
        for (size_t k = 0; k < part.size(); ++k) {
            const Corner &x = part[k], &y = part[(k + 1) % part.size()];
            const double at_x = side(x), at_y = side(y);
            if (at_x >= 0) {
                left.push_back(x);
            }
            if ((at_x > 0 && at_y < 0) || (at_x < 0 && at_y > 0)) {
                const double t = at_x / (at_x - at_y);
                left.push_back({x[0] + t * (y[0] - x[0]), x[1] + t * (y[1] - x[1])});
            }
        }
        part = left;
    }
    return part;
}
double area_of(const std::vector<Corner> &polygon) {
    double area = 0;
    for (size_t i = 0; i < polygon.size(); ++i) {
        const Corner &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        area += (p[0] * q[1] - q[0] * p[1]) / 2;
    }
    return area;
}

// In the plane z = 0.3 x - 0.2 y.
Point3 lifted(const Corner &x) {
    return {x[0], x[1], 0.3 * x[0] - 0.2 * x[1]};
}
using Quad = std::array<Corner, 4>; // at (0, 0), (1, 0), (1, 1), (0, 1)
SplineData bilinear(const Quad &quad) {
    SplineData data{{1, 1}, {2, 2}, {{0, 0, 1, 1}, {0, 0, 1, 1}}, 3, {}, {}, 0};
    for (const size_t i : {0, 3, 1, 2}) {
        const Point3 x = lifted(quad[i]);
        data.points.insert(data.points.end(), x.begin(), x.end());
    }
    return data;
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
        const double area = area_of(common_part({q.begin(), q.end()}, {p.begin(), p.end()})),
                     whole = area_of({p.begin(), p.end()});
        if (area < 1e-3) {
            continue;
        }
        SplineData other = bilinear(q);
        if (random.chance(40)) {
            for (int k = 0; k < 4; ++k) {
                other.weights.push_back(random.between(0.7, 1.4));
            }
        }
        const Handle a = create(bilinear(p));
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

} // namespace

} // namespace surface_overlaps
