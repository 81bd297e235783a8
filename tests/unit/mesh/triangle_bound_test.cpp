// SPDX-License-Identifier: MIT
// What is proven of triangles over random pieces of surfaces, against samples: both ways, and by parts over several pieces.
#include "mesh/cells/piece_bound.h"

#include "eval/evaluate.h"
#include "mesh/proof/distance.h"
#include "mesh/proof/mesh_bound.h"
#include "mesh/proof/pairs.h"
#include "mesh/proof/star_bound.h"
#include "support/generators.h"
#include "unit/shapes.h"

#include <gtest/gtest.h>
#include <numbers>
#include <numeric>

namespace triangle_bound_test {

using namespace nrb;
using namespace nrb::mesh;

namespace {

using Param = std::array<double, 2>;

// A net over a square whose points and weights are moved at random.
SplinePtr surface(support::Random &random, int degree, int spans, bool rational, double height) {
    const int count = degree + spans;
    std::vector<double> knots(static_cast<size_t>(degree) + 1, 0.0), points, weights;
    for (int i = 1; i < spans; ++i) {
        knots.push_back(i + random.between(-0.3, 0.3));
    }
    knots.insert(knots.end(), static_cast<size_t>(degree) + 1, spans);
    for (int i = 0; i < count; ++i) {
        for (int j = 0; j < count; ++j) {
            points.insert(points.end(), {i + random.between(-0.3, 0.3), j + random.between(-0.3, 0.3),
                                         random.between(-height, height)});
            weights.push_back(random.between(0.6, 1.8));
        }
    }
    const KnotVectorPtr axis = make_knot_vector(degree, knots);
    return make_spline({axis, axis}, 3, rational ? Form::rational : Form::polynomial, std::move(points),
                       rational ? std::move(weights) : std::vector<double>{});
}

class Measured {
public:
    explicit Measured(SplinePtr surface)
        : surface_(std::move(surface)), grid_(pieces::piece_grid_of(*surface_)), nets_(grid_) {}

    // In the units of the grid.
    [[nodiscard]] Vector3 point(Param x) const {
        for (size_t k = 0; k < 2; ++k) {
            const Interval domain = surface_->axis(static_cast<int>(k)).domain();
            x[k] = std::clamp(x[k], domain.lower, domain.upper);
        }
        std::array<double, 3> at{};
        std::array<double, 4> placed{};
        eval::evaluate_points(*surface_, {}, 0, {x.data(), 1, 2, 2, 1}, {at.data(), 1, 3, 3, 1});
        grid_.place(at.data(), placed.data());
        return {placed[0], placed[1], placed[2]};
    }
    [[nodiscard]] std::array<TriangleCorner, 3> corners(const std::array<Param, 3> &params) const {
        return {
            {{params[0], point(params[0])}, {params[1], point(params[1])}, {params[2], point(params[2])}}};
    }
    // Of a triangle in one piece.
    TriangleBound bound(const std::array<Param, 3> &params) {
        Rectangle part{params[0], params[0]};
        for (const Param &x : params) {
            for (size_t k = 0; k < 2; ++k) {
                part.lower[k] = std::min(part.lower[k], x[k]);
                part.upper[k] = std::max(part.upper[k], x[k]);
            }
        }
        const HessianBox box = nets_.box(part, nets_.pieces_in(part));
        const CellPart here{&box, part};
        return triangle_bound(corners(params), {&here, 1});
    }
    HessianBox box(const Rectangle &part) { return nets_.box(part, nets_.pieces_in(part)); }
    // By parts.
    TriangleBound bound_by_pieces(const std::array<Param, 3> &params, double enough = 0) {
        const Interval u = surface_->axis(0).domain(), v = surface_->axis(1).domain();
        const Rectangle all{{u.lower, v.lower}, {u.upper, v.upper}};
        return PieceBound(*surface_, nets_).bound(corners(params), nets_.pieces_in(all), all, enough);
    }
    // The largest distance of samples of the surface over a triangle of the domain from that in space, and of samples of this from
    // those of the surface, which are no farther than `step` from any of its points.
    struct Distances {
        double from_shape = 0, from_mesh = 0, step = 0;
    };
    [[nodiscard]] Distances sampled(const std::array<Param, 3> &params, int n) const {
        const auto whole = corners(params);
        const std::array<Vector3, 3> triangle{whole[0].point, whole[1].point, whole[2].point};
        std::vector<Vector3> samples, flat;
        for (int i = 0; i <= n; ++i) {
            for (int j = 0; i + j <= n; ++j) {
                const double a = static_cast<double>(i) / n, b = static_cast<double>(j) / n, c = 1 - a - b;
                const Param x{a * params[0][0] + b * params[1][0] + c * params[2][0],
                              a * params[0][1] + b * params[1][1] + c * params[2][1]};
                samples.push_back(point(x));
                flat.push_back(a * triangle[0] + b * triangle[1] + c * triangle[2]);
            }
        }
        Distances result;
        for (const Vector3 &x : samples) {
            result.from_shape = std::max(result.from_shape, distance_from_triangle(x, triangle));
        }
        for (const Vector3 &p : flat) {
            double nearest = infinity;
            for (const Vector3 &x : samples) {
                nearest = std::min(nearest, length(x - p));
            }
            result.from_mesh = std::max(result.from_mesh, nearest);
        }
        for (size_t k = 0; k < 3; ++k) {
            result.step = std::max(result.step, 2 * length(triangle[(k + 1) % 3] - triangle[k]) / n);
        }
        return result;
    }

private:
    SplinePtr surface_;
    const pieces::PieceGrid &grid_;
    CellNets nets_;
};

std::array<Param, 3> random_triangle(support::Random &random, const Param &low, const Param &high,
                                     double size) {
    Param centre{};
    for (size_t k = 0; k < 2; ++k) {
        centre[k] = random.between(low[k] + 0.1, high[k] - 0.1);
    }
    std::array<Param, 3> result;
    for (Param &x : result) {
        for (size_t k = 0; k < 2; ++k) {
            x[k] = std::clamp(centre[k] + random.between(-size, size), low[k], high[k]);
        }
    }
    if (std::max({result[0][0], result[1][0], result[2][0]}) ==
        std::min({result[0][0], result[1][0], result[2][0]})) {
        result[0][0] = centre[0]; // no width
    }
    if (std::max({result[0][1], result[1][1], result[2][1]}) ==
        std::min({result[0][1], result[1][1], result[2][1]})) {
        result[0][1] = centre[1];
    }
    return result;
}

} // namespace

TEST(TriangleBound, holds_for_samples) {
    support::Random random(20261129);
    for (int i = 0; i < 400; ++i) {
        Measured measured(surface(random, random.whole(1, 5), 1, random.chance(60), random.between(0, 1)));
        const auto params = random_triangle(random, {0, 0}, {1, 1}, random.magnitude(0.01, 0.5));
        const auto sampled = measured.sampled(params, 16);
        const TriangleBound bound = measured.bound(params);
        EXPECT_LE(sampled.from_shape, bound.from_shape() + 1e-12) << i;
        EXPECT_LE(sampled.from_mesh, bound.from_mesh() + sampled.step + 1e-12) << i;
    }
}

// The two triangles of cells, whose corners are those of the cell: there the surface is the polynomial that it is compared with.
TEST(TriangleBound, holds_for_samples_of_cells) {
    support::Random random(20261130);
    for (int i = 0; i < 400; ++i) {
        Measured measured(surface(random, random.whole(1, 6), 1, random.chance(60), random.between(0, 1)));
        const double w = random.magnitude(0.01, 1), h = random.magnitude(0.01, 1),
                     u = random.between(0, 1 - w), v = random.between(0, 1 - h);
        const std::array<Param, 4> cell{{{u, v}, {u + w, v}, {u + w, v + h}, {u, v + h}}};
        const auto k = static_cast<size_t>(random.whole(0, 3));
        const std::array<Param, 3> params{cell[k], cell[(k + 1) % 4], cell[(k + 2) % 4]};
        const auto sampled = measured.sampled(params, 16);
        const TriangleBound bound = measured.bound(params);
        EXPECT_LE(sampled.from_shape, bound.from_shape() + 1e-12) << i;
        EXPECT_LE(sampled.from_mesh, bound.from_mesh() + sampled.step + 1e-12) << i;
    }
}

// As seen along any direction near the normal, what comes out over a side is no higher than it is told.
TEST(TriangleBound, heights_beyond_sides_hold_for_samples) {
    support::Random random(30);
    int beyond = 0;
    for (int i = 0; i < 300; ++i) {
        Measured measured(surface(random, random.whole(2, 5), 1, random.chance(60), random.between(0, 1)));
        const auto params = random_triangle(random, {0, 0}, {1, 1}, random.magnitude(0.05, 0.5));
        const TriangleBound bound = measured.bound(params);
        if (!bound.has_plane()) {
            continue;
        }
        const auto corners = measured.corners(params);
        const Vector3 tilt =
            unit(bound.normal + random.between(0, 0.5) * unit(corners[1].point - corners[0].point) +
                 random.between(0, 0.2) * unit(corners[2].point - corners[0].point));
        const Vector3 view = dot(tilt, bound.normal) > std::cos(std::numbers::pi / 6) ? tilt : bound.normal;
        constexpr int n = 24;
        for (int a = 0; a <= n; ++a) {
            for (int b = 0; a + b <= n; ++b) {
                const std::array<double, 3> l{a / double{n}, b / double{n}, (n - a - b) / double{n}};
                Param at{};
                for (size_t k = 0; k < 3; ++k) {
                    at = {at[0] + l[k] * params[k][0], at[1] + l[k] * params[k][1]};
                }
                const Vector3 x = measured.point(at);
                for (size_t k = 0; k < 3; ++k) {
                    const Vector3 &from = corners[(k + 1) % 3].point,
                                  side = corners[(k + 2) % 3].point - from;
                    if (dot(cross(side, view), x - from) > 1e-12) {
                        ++beyond;
                        EXPECT_LE(std::abs(dot(bound.normal, x - from)), bound.height_over(k) + 1e-12) << i;
                    }
                }
            }
        }
    }
    EXPECT_GE(beyond, 1000);
}

// A cubic over a triangle, divided by a linear weight.
TEST(Bend, bounds_hold_for_samples) {
    support::Random random(5);
    double most = 0;
    for (int i = 0; i < 500; ++i) {
        std::array<double, 7> c{}; // of a, b, c, and of the third derivatives
        for (double &x : c) {
            x = random.between(-1, 1) * (random.chance(70) ? 1 : 0.01);
        }
        const auto value = [&](double x, double y) {
            return c[0] * x * x + c[1] * x * y + c[2] * y * y + c[3] * x * x * x + c[4] * x * x * y +
                   c[5] * x * y * y + c[6] * y * y * y;
        };
        const std::array<Param, 3> at{{{0, 0}, {1, 0}, {0, 1}}};
        std::array<Four, 3> q;
        for (size_t m = 0; m < 3; ++m) {
            const auto [x, y] = at[m];
            const double uu = 2 * c[0] + 6 * c[3] * x + 2 * c[4] * y, uv = c[1] + 2 * c[4] * x + 2 * c[5] * y,
                         vv = 2 * c[2] + 2 * c[5] * x + 6 * c[6] * y;
            q[m] = Four(uu - 2 * uv + vv, vv, uu, 0); // along the sides opposite the corners
        }
        const Bend bend(q, Four(), infinity);
        const std::array<double, 3> w{random.between(0.3, 2), random.between(0.3, 2), random.between(0.3, 2)};
        const auto root = [&](size_t a, size_t b) { return 1 / std::sqrt(w[a] * w[b]); };
        const InverseWeights inverse{{root(1, 2), root(2, 0), root(0, 1)}, 1 / std::min({w[0], w[1], w[2]})};
        constexpr int n = 20;
        double largest = 0;
        for (int a = 0; a <= n; ++a) {
            for (int b = 0; a + b <= n; ++b) {
                const std::array<double, 3> l{a / double{n}, b / double{n}, (n - a - b) / double{n}};
                const double plain = l[0] * value(0, 0) + l[1] * value(1, 0) + l[2] * value(0, 1) -
                                     value(l[1], l[2]),
                             weight = l[0] * w[0] + l[1] * w[1] + l[2] * w[2], found = plain / weight;
                largest = std::max(largest, std::abs(found));
                EXPECT_LE(std::abs(plain), bend.both() + 1e-14) << i;
                EXPECT_LE(-plain, bend.above() + 1e-14) << i;
                EXPECT_LE(std::abs(found), bend.both(inverse) + 1e-14) << i;
                for (size_t k = 0; k < 3; ++k) {
                    EXPECT_LE(std::abs(found), bend.near_side(k, l[k], inverse) + 1e-14) << i;
                    if (l[k] == 0) {
                        EXPECT_LE(std::abs(found), bend.on_side(k, inverse) + 1e-14) << i;
                    }
                }
            }
        }
        most = std::max(most, largest / bend.both(inverse));
    }
    EXPECT_GE(most, 0.9);
}

// The polynomial with the affine parts as second derivatives agrees with each coordinate at the corners, and is as near to it
// elsewhere as it is told.
TEST(HessianBox, rests_are_those_beside_a_cubic) {
    support::Random random(8);
    double most = 0;
    for (int i = 0; i < 200; ++i) {
        Measured measured(surface(random, random.whole(1, 6), 1, false, 1));
        const double size = random.magnitude(0.05, 1);
        const Param low{random.between(0, 1 - size), random.between(0, 1 - size)};
        const HessianBox box = measured.box({low, {low[0] + size, low[1] + size}});
        for (size_t coordinate = 0; coordinate < 3; ++coordinate) {
            const Hessian &h = box.of(coordinate);
            const auto value = [&](double x, double y) {
                return dot(box.axes()[coordinate],
                           measured.point({low[0] + size * x, low[1] + size * y}) - box.origin());
            };
            const auto curved = [&](double x, double y) {
                return h.uu.middle * x * x / 2 + h.uv.middle * x * y + h.vv.middle * y * y / 2 +
                       h.uu.u * (x * x * x / 6 - x * x / 4) +
                       h.uu.v * (x * x * y / 2 - x * x / 4 - x * y / 2) +
                       h.vv.u * (x * y * y / 2 - y * y / 4 - x * y / 2) +
                       h.vv.v * (y * y * y / 6 - y * y / 4);
            };
            const double a = value(0, 0), b = value(1, 0) - a - curved(1, 0),
                         c = value(0, 1) - a - curved(0, 1);
            const auto apart = [&](double x, double y) {
                return std::abs(a + b * x + c * y + curved(x, y) - value(x, y));
            };
            EXPECT_NEAR(h.uu.v, h.uv.u, 1e-13) << i;
            EXPECT_NEAR(h.vv.u, h.uv.v, 1e-13) << i;
            EXPECT_LE(apart(1, 1), 1e-13) << i;
            for (int k = 0; k < 50; ++k) {
                const double found = apart(random.unit(), random.unit());
                EXPECT_LE(found, h.rest + 1e-14) << i;
                most = std::max(most, found / h.rest);
            }
        }
    }
    EXPECT_GE(most, 0.5);
}

// Of a cell, in one piece and in several.
TEST(HessianBox, no_step_moves_farther) {
    support::Random random(12);
    double most = 0;
    for (int i = 0; i < 400; ++i) {
        const int spans = random.whole(1, 3);
        const int degree = random.whole(spans > 1 ? 2 : 1, 5); // kinks are where blocks end
        Measured measured(surface(random, degree, spans, random.chance(60), random.between(0, 1)));
        const double size = random.magnitude(0.001, 0.5) * spans;
        const Param low{random.between(0, spans - size), random.between(0, spans - size)};
        const HessianBox box = measured.box({low, {low[0] + size, low[1] + size}});
        for (int k = 0; k < 20; ++k) {
            const Param from{random.between(0, 1), random.between(0, 1)},
                to{random.between(0, 1), random.between(0, 1)};
            const auto at = [&](const Param &x) {
                return measured.point({low[0] + size * x[0], low[1] + size * x[1]});
            };
            const double moved = length(at(to) - at(from)), told = box.move(to[0] - from[0], to[1] - from[1]);
            EXPECT_LE(moved, told + 1e-14) << i;
            most = std::max(most, moved / told);
        }
    }
    EXPECT_GE(most, 0.99); // of small cells it is nearly all
}

// Whatever ranges are added, with slopes or without.
TEST(HessianBox, joined_ranges_contain_both) {
    support::Random random(4);
    const auto range = [&] {
        const auto number = [&] { return random.between(-1, 1); };
        return Range{number(), random.chance(70) ? number() : 0, random.chance(70) ? number() : 0,
                     std::abs(number())};
    };
    for (int i = 0; i < 200; ++i) {
        const Hessian a{range(), range(), range()}, b{range(), range(), range()};
        Hessian both = a;
        both.add(b);
        for (const Range Hessian::*part : {&Hessian::uu, &Hessian::uv, &Hessian::vv}) {
            for (const Hessian &own : {a, b}) {
                EXPECT_LE((own.*part).middle + (own.*part).width(),
                          (both.*part).middle + (both.*part).radius);
                EXPECT_GE((own.*part).middle - (own.*part).width(),
                          (both.*part).middle - (both.*part).radius);
            }
        }
    }
}

// Of a part that reaches past a break by less than rounding tells.
TEST(HessianBox, holds_where_a_part_ends_just_behind_a_break) {
    support::Random random(6);
    for (int i = 0; i < 100; ++i) {
        std::vector<double> points;
        for (int k = 0; k < 5 * 2; ++k) {
            points.insert(points.end(), {k / 2 - 2.0, k % 2 - 0.5, random.between(-1, 1)});
        }
        const SplinePtr given =
            make_spline({make_knot_vector(3, {-1, -1, -1, -1, 0, 1, 1, 1, 1}), shapes::bezier_axis(1)}, 3,
                        Form::polynomial, std::move(points));
        Measured measured(given);
        const Rectangle part{{-1, 0}, {random.chance(50) ? 1e-17 : 0.0, 1}};
        const HessianBox box = measured.box(part);
        const auto second = [&](double u, double v) { // of the height, by differences of a cubic
            const double h = 0.05;
            return (1 / (h * h)) *
                   (measured.point({u - h, v}) - 2 * measured.point({u, v}) + measured.point({u + h, v}));
        };
        for (int k = 0; k < 20; ++k) {
            const double u = random.between(-0.95, -0.05), v = random.unit();
            const Vector3 exact = second(u, v);
            for (size_t c = 0; c < 3; ++c) {
                const Range &range = box.of(c).uu;
                const double told = range.at(u + 0.5, v - 0.5), found = dot(box.axes()[c], exact);
                EXPECT_NEAR(found, told, range.radius + 1e-9) << i;
            }
        }
    }
}

// Small triangles of a smooth surface are told from it by little more than they are: else meshes have too many triangles.
TEST(TriangleBound, is_sharp_for_small_triangles) {
    support::Random random(7);
    double told = 0, found = 0;
    for (int i = 0; i < 200; ++i) {
        Measured measured(surface(random, 3, 1, false, 1));
        const double u = random.between(0.1, 0.8), v = random.between(0.1, 0.8), h = 0.05;
        const std::array<Param, 3> params{{{u, v}, {u + h, v}, {u, v + h}}};
        told += measured.bound(params).from_shape();
        found += measured.sampled(params, 24).from_shape;
    }
    EXPECT_LE(told, 1.25 * found);
}

TEST(TriangleBound, of_a_plane_is_rounding) {
    support::Random random(3);
    Measured measured(surface(random, 1, 1, false, 0));
    const double bound = measured.bound({{{0.1, 0.2}, {0.7, 0.3}, {0.4, 0.9}}}).height;
    EXPECT_LE(bound, 1e-13);
}

TEST(TriangleBound, by_parts_holds_for_samples) {
    support::Random random(11);
    for (int i = 0; i < 100; ++i) {
        const int spans = random.whole(2, 6);
        Measured measured(
            surface(random, random.whole(2, 4), spans, random.chance(50), random.between(0, 1)));
        const double end = spans;
        const auto params = random_triangle(random, {0, 0}, {end, end}, random.magnitude(0.1, 2));
        const TriangleBound best = measured.bound_by_pieces(params);
        const auto sampled = measured.sampled(params, 20);
        for (const double enough : {0.0, 0.8, 1.5, infinity}) { // whatever is enough, it holds
            const double told = enough * best.height;
            const TriangleBound bound = measured.bound_by_pieces(params, told);
            EXPECT_LE(sampled.from_shape, bound.from_shape() + 1e-12) << i;
            EXPECT_LE(sampled.from_mesh, bound.from_mesh() + sampled.step + 1e-12) << i;
            EXPECT_LE(bound.height, std::max(best.height, told)) << i;
        }
    }
}

// What lies beyond a jump does not count, at either end of a block.
TEST(TriangleBound, by_parts_is_of_the_block_alone) {
    support::Random random(13);
    for (int i = 0; i < 20; ++i) {
        std::vector<double> own, all;
        for (int u = 0; u < 5; ++u) {
            for (int v = 0; v < 6; ++v) {
                const std::array<double, 3> x{u + random.between(-0.3, 0.3), v + (v / 2) * 3.0,
                                              random.between(-0.5, 0.5)};
                all.insert(all.end(), x.begin(), x.end());
                if (v / 2 == 1) {
                    own.insert(own.end(), x.begin(), x.end());
                }
            }
        }
        const KnotVectorPtr axis = make_knot_vector(2, {0, 0, 0, 1, 2, 3, 3, 3});
        const SplinePtr alone =
            make_spline({axis, make_knot_vector(1, {1, 1, 2, 2})}, 3, Form::polynomial, std::move(own));
        const SplinePtr among = make_spline({axis, make_knot_vector(1, {0, 0, 1, 1, 2, 2, 3, 3})}, 3,
                                            Form::polynomial, std::move(all));
        const std::array<Param, 3> params{{{0.2, 1}, {2.7, 1}, {1.5, 2}}};
        const Rectangle block{{0, 1}, {3, 2}};
        std::vector<double> heights;
        for (const SplinePtr &surface : {alone, among}) {
            const pieces::PieceGrid &grid = pieces::piece_grid_of(*surface);
            CellNets nets(grid);
            std::array<TriangleCorner, 3> corners;
            for (size_t k = 0; k < 3; ++k) {
                const eval::AxisRules rules{{{}, {.left = params[k][1] == 2}}};
                std::array<double, 3> at{};
                std::array<double, 4> placed{};
                eval::evaluate_points(*surface, rules, 0, {params[k].data(), 1, 2, 2, 1},
                                      {at.data(), 1, 3, 3, 1});
                grid.place(at.data(), placed.data());
                corners[k] = {params[k], {placed[0], placed[1], placed[2]}};
            }
            PieceRange pieces = nets.pieces_in(block);
            const TriangleBound bound = PieceBound(*surface, nets).bound(corners, pieces, block, 0);
            heights.push_back(bound.height / grid.scaled(1));
        }
        EXPECT_NEAR(heights[0], heights[1], 1e-9);
    }
}

// A grid of triangles over a surface whose parameters run very unevenly.
struct GridMesh {
    std::vector<std::array<Param, 3>> params;
    std::vector<MeshTriangle> triangles;
    std::vector<TriangleBound> bounds;
};
GridMesh grid_mesh(support::Random &random, Measured &measured, int n) {
    GridMesh mesh;
    std::vector<double> lines{0};
    for (int i = 1; i < n; ++i) {
        lines.push_back((i + random.between(-0.25, 0.25)) / n);
    }
    lines.push_back(1);
    const auto at = [&](int i, int j) {
        return Param{lines[static_cast<size_t>(i)], lines[static_cast<size_t>(j)]};
    };
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            const std::array<std::array<int, 2>, 4> corners{{{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}};
            const size_t first = random.chance(50) ? 0 : 1; // of the diagonal
            for (const size_t k : {first, first + 2}) {
                MeshTriangle triangle;
                std::array<Param, 3> params;
                for (size_t c = 0; c < 3; ++c) {
                    const auto [a, b] = corners[(k + c) % 4];
                    params[c] = at(a, b);
                    triangle.points[c] = a * (n + 1) + b;
                }
                for (size_t c = 0; c < 3; ++c) { // at an end of the domain
                    const Param &a = params[(c + 1) % 3], &b = params[(c + 2) % 3];
                    triangle.border[c] = (a[0] == b[0] && (a[0] == 0 || a[0] == 1)) ||
                                         (a[1] == b[1] && (a[1] == 0 || a[1] == 1));
                }
                mesh.params.push_back(params);
                mesh.triangles.push_back(triangle);
                mesh.bounds.push_back(measured.bound(params));
            }
        }
    }
    return mesh;
}

// By steps that are halved, from the best of some places on.
double distance_from_surface(const Measured &measured, const Vector3 &p) {
    Param best{};
    double least = infinity;
    const auto look_at = [&](const Param &x) {
        const double distance =
            length(measured.point({std::clamp(x[0], 0.0, 1.0), std::clamp(x[1], 0.0, 1.0)}) - p);
        const bool better = distance < least;
        least = better ? distance : least;
        best = better ? x : best;
        return better;
    };
    for (int i = 0; i <= 32; ++i) {
        for (int j = 0; j <= 32; ++j) {
            look_at({i / 32.0, j / 32.0});
        }
    }
    for (double step = 1.0 / 32; step > 1e-7; step /= 2) {
        for (bool any = true; any;) {
            const auto [u, v] = best;
            any = false;
            for (int k = 0; k < 8; ++k) {
                const double angle = k * std::numbers::pi / 4;
                any = look_at({u + step * std::cos(angle), v + step * std::sin(angle)}) || any;
            }
        }
    }
    return least;
}

TEST(StarBound, holds_for_samples) {
    support::Random random(17);
    int proven = 0;
    for (int i = 0; i < 12; ++i) {
        Measured measured(surface(random, 3, 1, random.chance(60), random.between(0.2, 1)));
        constexpr int n = 5;
        const GridMesh mesh = grid_mesh(random, measured, n);
        std::vector<int32_t> all(mesh.triangles.size());
        std::iota(all.begin(), all.end(), 0);
        const Neighbours neighbours((n + 1) * (n + 1), mesh.triangles, all);
        for (size_t t = 0; t < all.size(); ++t) {
            const bool inside = std::ranges::all_of(mesh.params[t], [](const Param &x) {
                return std::min(x[0], x[1]) > 0 && std::max(x[0], x[1]) < 1;
            });
            const Distances told =
                inside ? star_bound(neighbours, mesh.bounds, t, 0) : Distances{infinity, infinity};
            if (told.most() == infinity) {
                continue;
            }
            ++proven;
            const auto corners = measured.corners(mesh.params[t]);
            for (int k = 0; k < 12; ++k) {
                const double a = random.unit(), b = random.between(0, 1 - a), c = 1 - a - b;
                const Vector3 p = a * corners[0].point + b * corners[1].point + c * corners[2].point;
                EXPECT_LE(distance_from_surface(measured, p), told.from_mesh + 1e-7) << i;
                Param x{};
                for (size_t axis = 0; axis < 2; ++axis) {
                    x[axis] = a * mesh.params[t][0][axis] + b * mesh.params[t][1][axis] +
                              c * mesh.params[t][2][axis];
                }
                double nearest = infinity;
                for (const auto &other : mesh.params) {
                    const auto own = measured.corners(other);
                    nearest =
                        std::min(nearest, distance_from_triangle(measured.point(x),
                                                                 {own[0].point, own[1].point, own[2].point}));
                }
                EXPECT_LE(nearest, told.from_shape + 1e-12) << i;
            }
        }
    }
    EXPECT_GE(proven, 60);
}

// Around the first corner of a level triangle there are others on a steep cone, as seen once or twice around. Although their angles
// in space add up to less than 3 pi, stars that look twice around prove nothing.
TEST(MeshBound, stars_that_look_twice_around_do_not_count) {
    constexpr int count = 24;
    constexpr double tilt = 0.85, own_angle = 0.25;
    for (const int turns : {1, 2}) {
        const double seen = 2 * std::numbers::pi * turns - own_angle;
        std::vector<MeshTriangle> triangles;
        std::vector<TriangleBound> bounds;
        double angles = 0;
        for (int32_t i = 0; i <= count; ++i) {
            const double at = i == 0 ? 0 : own_angle / 2 + (i - 0.5) * seen / count;
            TriangleBound bound;
            bound.normal = i == 0 ? Vector3{0, 0, 1}
                                  : Vector3{std::sin(tilt) * std::cos(at), std::sin(tilt) * std::sin(at),
                                            std::cos(tilt)};
            bound.angles = {i == 0 ? own_angle : seen * std::cos(tilt) / count, 1, 1};
            bound.altitudes.fill(1);
            bound.height = 1e-3;
            bound.out = 1e-4;
            bound.beside = 0.1;
            angles += bound.angles[0];
            bounds.push_back(bound);
            triangles.push_back({{0, 1 + i, 1 + (i + 1) % (count + 1)}});
        }
        EXPECT_LT(angles, 3 * std::numbers::pi);
        const std::array<int32_t, 1> wanted{0};
        const MeshBound bound(count + 2, triangles, bounds, wanted);
        EXPECT_EQ(bound.distances(0, 0, 0).from_mesh < 0.1, turns == 1);
    }
}

// What is cut makes up the whole, and sides stay those of the triangle.
TEST(CutTriangle, parts_make_up_the_triangle) {
    support::Random random(5);
    for (int i = 0; i < 1000; ++i) {
        const auto params = random_triangle(random, {0, 0}, {4, 4}, 3);
        const auto area = [](const std::vector<Param> &places) {
            double sum = 0;
            for (size_t k = 1; k + 1 < places.size(); ++k) {
                sum += (places[k][0] - places[0][0]) * (places[k + 1][1] - places[0][1]) -
                       (places[k][1] - places[0][1]) * (places[k + 1][0] - places[0][0]);
            }
            return sum;
        };
        double sum = 0;
        for (int u = 0; u < 4; ++u) {
            for (int v = 0; v < 4; ++v) {
                const double a = u, b = v;
                std::vector<Param> places;
                const CutPolygon polygon = cut_triangle(params, {{a, b}, {a + 1, b + 1}});
                for (const CutPlace &place : polygon.places()) {
                    places.push_back(place.at);
                }
                sum += area(places);
            }
        }
        EXPECT_NEAR(sum, area({params.begin(), params.end()}), 1e-12);
    }
}

} // namespace triangle_bound_test
