// Sewing: what was split is whole again, whatever the order, the directions and the size of the patches; edges that are common are
// proven to be so, and what is farther apart than the tolerance stays open; meshes of closed shells are closed.
#include "property/faces.h"
#include "property/solids.h"
#include "support/cases.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <numeric>
#include <set>

namespace sewing_test {

using namespace support;
using namespace support::models;
using faces::pi;

namespace {

using Vec = std::vector<double>;
using Patches = std::vector<Handle>;
using Faces = std::vector<Face>;
using Point = std::array<double, 3>;

Face whole(const Handle &surface, double tolerance = 0) {
    nurbs_face *face = nullptr;
    require_ok(nurbs_face_create(surface.get(), 0, nullptr, nullptr, nullptr, nullptr, tolerance, 0, nullptr,
                                 &face));
    return Face(face);
}

Faces faces_of(const Patches &patches) {
    Faces faces;
    for (const Handle &patch : patches) {
        faces.push_back(whole(patch));
    }
    return faces;
}

Model sewn(const Faces &faces, double tolerance) {
    std::vector<const nurbs_face *> given;
    for (const Face &face : faces) {
        given.push_back(face.get());
    }
    nurbs_model *model = nullptr;
    require_ok(nurbs_model_sew(std::ssize(given), given.data(), tolerance, 1, &model));
    return Model(model);
}

struct Gaps {
    std::vector<int64_t> uses;
    Vec gaps;
    std::vector<int32_t> proven;

    [[nodiscard]] int64_t with(int64_t wanted) const { return std::ranges::count(uses, wanted); }
    [[nodiscard]] double largest() const { return gaps.empty() ? 0 : *std::ranges::max_element(gaps); }
};

Gaps gaps_of(const nurbs_model *model) {
    int64_t n = -1;
    require_ok(nurbs_model_edge_gaps(model, 0, nullptr, nullptr, nullptr, &n));
    const auto size = static_cast<size_t>(n);
    Gaps found{std::vector<int64_t>(size), Vec(size), std::vector<int32_t>(size)};
    require_ok(
        nurbs_model_edge_gaps(model, n, found.uses.data(), found.gaps.data(), found.proven.data(), nullptr));
    return found;
}

// Of the mesh of a model.
struct Closedness {
    int64_t free_sides = 0, crowded_sides = 0, euler = 0;
    double bound = 0;
};

Closedness mesh_of(const nurbs_model *model, double chord) {
    nurbs_mesh_options options;
    require_ok(nurbs_mesh_options_init(&options, sizeof options));
    options.chord = chord;
    options.relative_chord = 0;
    nurbs_mesh *mesh = nullptr;
    require_ok(nurbs_mesh_model(model, &options, &mesh));
    const std::unique_ptr<nurbs_mesh, void (*)(nurbs_mesh *)> own(mesh, nurbs_mesh_destroy);
    int64_t n = 0;
    require_ok(nurbs_mesh_counts(mesh, nullptr, nullptr, &n, nullptr, nullptr, nullptr));
    std::vector<std::array<int64_t, 3>> triangles(static_cast<size_t>(n));
    require_ok(nurbs_mesh_triangles(mesh, NURBS_MESH_WELDED, n,
                                    triangles.empty() ? nullptr : triangles[0].data(), nullptr));
    std::map<std::array<int64_t, 2>, int> sides;
    std::set<int64_t> points;
    for (const auto &corners : triangles) {
        for (size_t k = 0; k < 3; ++k) {
            std::array<int64_t, 2> side{corners[k], corners[(k + 1) % 3]};
            std::ranges::sort(side);
            ++sides[side];
            points.insert(corners[k]);
        }
    }
    Closedness found;
    for (const auto &[side, uses] : sides) {
        found.free_sides += uses == 1 ? 1 : 0;
        found.crowded_sides += uses > 2 ? 1 : 0;
    }
    found.euler = std::ssize(points) - std::ssize(sides) + n;
    double back = 0;
    require_ok(nurbs_mesh_bound(mesh, &found.bound, &back, nullptr));
    found.bound = std::max(found.bound, back);
    return found;
}

// A similarity: a rotation by a random axis, a size and a place.
struct Placing {
    Vec matrix, move;
    double size;
};

Placing any_placing(Random &random) {
    Vec q(4);
    double norm = 0;
    for (double &x : q) {
        x = random.between(-1, 1);
        norm += x * x;
    }
    for (double &x : q) {
        x /= std::sqrt(norm);
    }
    const double size = random.magnitude(1e-6, 1e6);
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    Placing placing{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y), 2 * (x * y + w * z),
                     1 - 2 * (x * x + z * z), 2 * (y * z - w * x), 2 * (x * z - w * y), 2 * (y * z + w * x),
                     1 - 2 * (x * x + y * y)},
                    {},
                    size};
    for (double &value : placing.matrix) {
        value *= size;
    }
    for (int k = 0; k < 3; ++k) {
        placing.move.push_back(size * random.between(-2, 2));
    }
    return placing;
}

Patches placed(const Patches &patches, const Placing &placing) {
    Patches result;
    for (const Handle &patch : patches) {
        result.push_back(made([&](nurbs **out) {
            return nurbs_transform(patch.get(), 3, placing.matrix.data(), placing.move.data(), out);
        }));
    }
    return result;
}

// The same patches in another order, with axes that are exchanged, turned round and of higher degree.
Patches shuffled(Random &random, const Patches &patches) {
    std::vector<size_t> order(patches.size());
    std::iota(order.begin(), order.end(), size_t{0});
    for (size_t i = order.size(); i > 1; --i) {
        std::swap(order[i - 1], order[static_cast<size_t>(random.whole(0, static_cast<int>(i) - 1))]);
    }
    Patches result;
    for (const size_t i : order) {
        Handle patch = made([&](nurbs **out) { return nurbs_clone(patches[i].get(), out); });
        const int32_t exchanged[] = {1, 0};
        if (random.chance(50)) {
            patch = made([&](nurbs **out) { return nurbs_transpose(patch.get(), exchanged, out); });
        }
        for (const int axis : {0, 1}) {
            if (random.chance(50)) {
                patch = made([&](nurbs **out) { return nurbs_reverse(patch.get(), axis, 0, out); });
            }
            if (random.chance(30)) {
                patch = elevate(patch.get(), axis, random.whole(1, 2));
            }
        }
        result.push_back(std::move(patch));
    }
    return result;
}

Patches cube() {
    Patches sides;
    for (size_t axis = 0; axis < 3; ++axis) {
        for (const double side : {0.0, 1.0}) {
            Point corner{}, u{}, v{};
            corner[axis] = side;
            u[(axis + 1) % 3] = 1;
            v[(axis + 2) % 3] = 1;
            sides.push_back(solids::plane(corner, u, v));
        }
    }
    return sides;
}

// Eight patches of a sphere, each with a pole.
Patches octants() {
    Patches patches;
    for (int i = 0; i < 4; ++i) {
        for (const double south : {-pi / 2, 0.0}) {
            patches.push_back(made([&](nurbs **out) {
                return nurbs_surface_spherical_patch(nullptr, nullptr, nullptr, 1, i * pi / 2, pi / 2, south,
                                                     south + pi / 2, NURBS_ARC_QUARTERS, out);
            }));
        }
    }
    return patches;
}

Patches with_move(Patches patches, size_t index, const Point &move) {
    const Vec unit{1, 0, 0, 0, 1, 0, 0, 0, 1};
    patches[index] = made(
        [&](nurbs **out) { return nurbs_transform(patches[index].get(), 3, unit.data(), move.data(), out); });
    return patches;
}

struct Expected {
    int64_t faces, edges, vertices, common, open;
};

void expect_counts(const nurbs_model *model, const Expected &wanted) {
    const ModelCounts n = counts_of(model);
    const Gaps gaps = gaps_of(model);
    EXPECT_EQ(n.faces, wanted.faces);
    EXPECT_EQ(n.edges, wanted.edges);
    EXPECT_EQ(n.vertices, wanted.vertices);
    EXPECT_EQ(gaps.with(2), wanted.common);
    EXPECT_EQ(gaps.with(1), wanted.open);
}

void expect_closed(const nurbs_model *model, double chord, int64_t euler) {
    const Closedness mesh = mesh_of(model, chord);
    EXPECT_EQ(mesh.free_sides, 0);
    EXPECT_EQ(mesh.crowded_sides, 0);
    EXPECT_EQ(mesh.euler, euler);
}

// Halves patches at random places: some conform, others leave one side to two.
Patches pieces(Random &random, Handle whole, int cuts) {
    Patches patches;
    patches.push_back(std::move(whole));
    for (int i = 0; i < cuts; ++i) {
        const auto at = static_cast<size_t>(random.whole(0, static_cast<int>(patches.size()) - 1));
        const int32_t axis = random.whole(0, 1);
        double domain[2];
        require_ok(nurbs_domain(patches[at].get(), axis, domain));
        const double place = domain[0] + random.between(0.3, 0.7) * (domain[1] - domain[0]);
        nurbs *lower = nullptr, *upper = nullptr;
        require_ok(nurbs_split(patches[at].get(), axis, place, &lower, &upper));
        patches[at].reset(lower);
        patches.emplace_back(upper);
    }
    return patches;
}

double length_of(const nurbs_model *model, int64_t uses) {
    const Gaps gaps = gaps_of(model);
    double sum = 0;
    for (size_t i = 0; i < gaps.uses.size(); ++i) {
        double length = 0;
        if (gaps.uses[i] == uses) {
            require_ok(nurbs_curve_length(edge_of(model, static_cast<int64_t>(i)).get(), nullptr, 1e-9,
                                          &length, nullptr));
        }
        sum += length;
    }
    return sum;
}

} // namespace

TEST(Sewing, SixSidesOfACubeAreAClosedShell) {
    for_each_case(1, 12, [](Random &random, uint64_t seed) {
        const Placing placing = any_placing(random);
        const Model model = sewn(faces_of(placed(shuffled(random, cube()), placing)), 1e-9 * placing.size);
        expect_counts(model.get(), {6, 12, 8, 12, 0});
        const Gaps gaps = gaps_of(model.get());
        EXPECT_LE(gaps.largest(), 1e-12 * placing.size) << seed;
        EXPECT_EQ(std::ranges::count(gaps.proven, 1), 12);
        expect_closed(model.get(), 1e-3 * placing.size, 2);
        double volume = 0;
        require_ok(nurbs_model_volume(model.get(), 0, &volume, nullptr, nullptr, nullptr, nullptr));
        EXPECT_NEAR(volume / std::pow(placing.size, 3), 1, 1e-9) << seed;
    });
}

TEST(Sewing, EightPatchesOfASphereMeetAtPoles) {
    for_each_case(1, 4, [](Random &random, uint64_t) {
        const Placing placing = any_placing(random);
        const Model model = sewn(faces_of(placed(shuffled(random, octants()), placing)), 1e-9 * placing.size);
        expect_counts(model.get(), {8, 12, 6, 12, 0});
        expect_closed(model.get(), 2e-2 * placing.size, 2);
    });
}

// What is within the tolerance is one, with its distance; what is not stays open.
TEST(Sewing, TheToleranceDecides) {
    for_each_case(1, 12, [](Random &random, uint64_t seed) {
        const double tolerance = random.magnitude(1e-6, 1e-2);
        const auto moved = static_cast<size_t>(random.whole(0, 5));
        const size_t axis = moved / 2;
        Point inward{}, sideways{};
        inward[axis] = moved % 2 == 0 ? -1 : 1;
        sideways[(axis + 1) % 3] = 0.9 * tolerance;
        Point near = inward, far = inward;
        near[axis] *= 0.98 * tolerance;
        far[axis] *= 1.02 * tolerance;
        const Model within = sewn(faces_of(shuffled(random, with_move(cube(), moved, near))), tolerance);
        expect_counts(within.get(), {6, 12, 8, 12, 0});
        EXPECT_NEAR(gaps_of(within.get()).largest(), 0.98 * tolerance, 1e-3 * tolerance) << seed;
        expect_closed(within.get(), 1e-1, 2);
        const Model beyond = sewn(faces_of(shuffled(random, with_move(cube(), moved, far))), tolerance);
        expect_counts(beyond.get(), {6, 16, 12, 8, 8});
        EXPECT_LE(gaps_of(beyond.get()).largest(), 1e-12) << seed;
        const Model aside = sewn(faces_of(shuffled(random, with_move(cube(), moved, sideways))), tolerance);
        expect_counts(aside.get(), {6, 12, 8, 12, 0});
        expect_closed(aside.get(), 1e-1, 2);
    });
}

// A long side meets the sides of several patches, in all directions.
TEST(Sewing, PiecesOfASurfaceAreWholeAgain) {
    for_each_case(1, 12, [](Random &random, uint64_t seed) {
        const faces::Ground ground = faces::wavy(random);
        const int cuts = random.whole(1, 12);
        Handle given = made([&](nurbs **out) { return nurbs_clone(ground.surface.get(), out); });
        for (const int axis : {0, 1}) {
            if (random.chance(30)) {
                given = made([&](nurbs **out) {
                    return nurbs_unclamp(given.get(), axis, NURBS_FORM_CLAMPED_START | NURBS_FORM_CLAMPED_END,
                                         out);
                });
            }
        }
        const Patches patches = shuffled(random, pieces(random, std::move(given), cuts));
        const Model model = sewn(faces_of(patches), 1e-9),
                    again = sewn(faces_of(shuffled(random, patches)), 1e-9);
        const Gaps gaps = gaps_of(model.get());
        EXPECT_EQ(gaps.with(1) + gaps.with(2), std::ssize(gaps.uses)) << seed;
        EXPECT_LE(gaps.largest(), 1e-9) << seed;
        EXPECT_EQ(counts_of(model.get()).euler(), 1) << seed;
        EXPECT_EQ(counts_of(model.get()), counts_of(again.get())) << seed;
        EXPECT_EQ(gaps.with(1), gaps_of(again.get()).with(1)) << seed;
        double area = 0, border = 0;
        require_ok(nurbs_surface_area(ground.surface.get(), nullptr, 1e-9, &area, nullptr));
        EXPECT_NEAR(area_of(model.get(), 1e-9), area, 1e-7) << seed;
        // All that is open is the border of the whole.
        for (const int axis : {0, 1}) {
            for (const double end : {0.0, 1.0}) {
                double length = 0;
                require_ok(nurbs_curve_length(iso(ground.surface.get(), axis, end).get(), nullptr, 1e-9,
                                              &length, nullptr));
                border += length;
            }
        }
        EXPECT_NEAR(length_of(model.get(), 1), border, 1e-6) << seed;
        const Closedness mesh = mesh_of(model.get(), 1e-2);
        EXPECT_EQ(mesh.crowded_sides, 0) << seed;
        EXPECT_EQ(mesh.euler, 1) << seed;
    });
}

// A closed surface in pieces: the seams of what is still closed are no edges.
TEST(Sewing, PiecesOfClosedSurfacesAreClosed) {
    for_each_case(1, 8, [](Random &random, uint64_t seed) {
        const Placing placing = any_placing(random);
        const bool ball = random.chance(50);
        faces::Ground ground = ball ? faces::sphere(1) : faces::torus(2, 0.5);
        const Patches patches =
            placed(shuffled(random, pieces(random, std::move(ground.surface), random.whole(1, 6))), placing);
        const Model model = sewn(faces_of(patches), 1e-9 * placing.size);
        const Gaps gaps = gaps_of(model.get());
        EXPECT_EQ(gaps.with(2), std::ssize(gaps.uses)) << seed;
        const Closedness mesh = mesh_of(model.get(), 5e-2 * placing.size);
        EXPECT_EQ(mesh.free_sides, 0) << seed;
        if (!ball) { // at a pole two places of a domain are one point, and so may be two sides of triangles
            EXPECT_EQ(mesh.crowded_sides, 0) << seed;
            EXPECT_EQ(mesh.euler, 0) << seed;
        }
        double volume = 0;
        require_ok(nurbs_model_volume(model.get(), 1e-6, &volume, nullptr, nullptr, nullptr, nullptr));
        EXPECT_NEAR(volume / std::pow(placing.size, 3), ball ? 4 * pi / 3 : pi * pi, 1e-4) << seed;
    });
}

// In some of them, neighbouring cells were cut at one place that was two numbers, or both faces at an edge had a side from a pole to one
// of its vertices.
TEST(Sewing, MeshesOfPiecesOfASphereAreClosed) {
    const auto expect_sphere = [](Random &random, uint64_t) {
        const Placing placing = any_placing(random);
        const double chord = random.magnitude(0.003, 0.2);
        const Patches patches =
            shuffled(random, pieces(random, faces::sphere(1).surface, random.whole(1, 6)));
        const Model model = sewn(faces_of(placed(patches, placing)), 1e-9 * placing.size);
        expect_closed(model.get(), chord * placing.size, 2);
    };
    for (const uint64_t seed : {1285U, 4585U, 4670U, 5788U, 7634U}) {
        for_each_case(seed, 1, expect_sphere);
    }
}

// Two half spheres whose common circle leads through both poles, or through one.
TEST(Sewing, ShellsCutThroughPolesAreClosed) {
    for_each_case(4, 20, [](Random &random, uint64_t seed) {
        const faces::Ground ball = faces::sphere(1);
        const bool great = random.chance(50);
        const double angle = random.between(0, 2 * pi), tilt = great ? 0 : random.between(0.3, 1.2);
        const Point axis{std::cos(angle) * std::cos(tilt), std::sin(angle) * std::cos(tilt), std::sin(tilt)};
        const Point centre{axis[2] * axis[0], axis[2] * axis[1], axis[2] * axis[2]};
        const Handle circle = made([&](nurbs **out) {
            return nurbs_curve_circle(3, centre.data(), axis.data(), nullptr, std::cos(tilt),
                                      NURBS_ARC_QUARTERS, out);
        });
        const Handle back = made([&](nurbs **out) { return nurbs_reverse(circle.get(), 0, 0, out); });
        Faces halves;
        for (const nurbs *edge : {circle.get(), back.get()}) {
            const int64_t one = 1;
            nurbs_face *face = nullptr;
            require_ok(nurbs_face_create(ball.surface.get(), 1, &one, nullptr, &edge, nullptr, 1e-7,
                                         NURBS_AS_ORIENTED, nullptr, &face));
            halves.emplace_back(face);
        }
        SCOPED_TRACE(seed);
        const double chord = random.magnitude(0.02, 0.2);
        const Model model = sewn(halves, 1e-6);
        expect_closed(model.get(), chord, 2);
        EXPECT_LE(mesh_of(model.get(), chord).bound, chord);
    });
}

namespace {

// A circle on the unit sphere: in the plane at a height along a unit normal, from the direction x on.
struct Circle {
    Point normal, x;
    double height;

    [[nodiscard]] double angle_of(const Point &p) const {
        const Point y{normal[1] * x[2] - normal[2] * x[1], normal[2] * x[0] - normal[0] * x[2],
                      normal[0] * x[1] - normal[1] * x[0]};
        return std::atan2(std::inner_product(y.begin(), y.end(), p.begin(), 0.0),
                          std::inner_product(x.begin(), x.end(), p.begin(), 0.0));
    }
    // Counterclockwise.
    [[nodiscard]] Handle arc(const Point &from, const Point &to) const {
        const double start = angle_of(from), turn = angle_of(to) - start;
        const Point centre{height * normal[0], height * normal[1], height * normal[2]};
        return made([&](nurbs **out) {
            return nurbs_curve_arc(3, centre.data(), normal.data(), x.data(), std::sqrt(1 - height * height),
                                   start, turn <= 0 ? turn + 2 * pi : turn, NURBS_ARC_QUARTERS, out);
        });
    }
};

Face between(const Handle &ball, const Handle &one, const Handle &other) {
    const nurbs *edges[] = {one.get(), other.get()};
    const int64_t two = 2;
    nurbs_face *face = nullptr;
    require_ok(nurbs_face_create(ball.get(), 1, &two, nullptr, edges, nullptr, 1e-7, NURBS_AS_ORIENTED,
                                 nullptr, &face));
    return Face(face);
}

} // namespace

// A great circle and a parallel. In one of the pieces a seam has a cell inside on its one side only, and is not divided on the other.
TEST(Sewing, FourPiecesOfASphereAreClosed) {
    const faces::Ground ball = faces::sphere(1);
    const Circle great{{0.076993634047056059, 0.92891967827554567, -0.36218808874490144},
                       {0.77160677534825772, -0.28557277137283166, -0.56839350496562124},
                       0},
        parallel{{0, 0, 1}, {0.93351177476588165, -0.35854674224353761, 0}, -0.19389865765169123};
    const double h = parallel.height, nx = great.normal[0], ny = great.normal[1], nz = great.normal[2];
    const double across = std::hypot(nx, ny), near = -h * nz / across,
                 far = std::sqrt(1 - h * h - near * near);
    const Point p{(near * nx - far * ny) / across, (near * ny + far * nx) / across, h},
        q{(near * nx + far * ny) / across, (near * ny - far * nx) / across, h};
    const auto back = [](const Handle &g) {
        return made([&](nurbs **out) { return nurbs_reverse(g.get(), 0, 0, out); });
    };
    const Handle upper = great.arc(p, q), lower = great.arc(q, p), front = parallel.arc(p, q),
                 rear = parallel.arc(q, p);
    Faces pieces;
    pieces.push_back(between(ball.surface, back(lower), back(front)));
    pieces.push_back(between(ball.surface, back(upper), front));
    pieces.push_back(between(ball.surface, lower, back(rear)));
    pieces.push_back(between(ball.surface, upper, rear));
    const Model model = sewn(pieces, 1e-6);
    expect_closed(model.get(), 0.046957077342767564, 2);
}

// The loop of the side goes along its seam and back; the discs are trimmed, and begin elsewhere.
TEST(Sewing, AClosedCylinder) {
    for (const double turn : {0.0, 0.4, 2.5}) {
        Faces faces = solids::closed_cylinder(1.5, 4);
        if (turn != 0) {
            const double x[] = {std::cos(turn), std::sin(turn), 0};
            faces[0] = whole(made([&](nurbs **out) {
                return nurbs_surface_cylinder(nullptr, nullptr, x, 1.5, 4, 0, 2 * pi, NURBS_ARC_QUARTERS,
                                              out);
            }));
        }
        const Model model = sewn(faces, 1e-7);
        // With its seam, or with the places where the one and the other begin.
        expect_counts(model.get(), turn == 0 ? Expected{3, 3, 2, 3, 0} : Expected{3, 4, 4, 4, 0});
        expect_closed(model.get(), 1e-2, 2);
        double volume = 0;
        require_ok(nurbs_model_volume(model.get(), 1e-9, &volume, nullptr, nullptr, nullptr, nullptr));
        EXPECT_NEAR(volume, pi * 1.5 * 1.5 * 4, 1e-6);
    }
}

// A corner of one side is cut off by less than the tolerance: the small curve is left out.
TEST(Sewing, WhatIsSmallerThanTheToleranceIsLeftOut) {
    constexpr double small = 1e-5;
    Faces faces = faces_of(cube());
    const Handle ground = solids::plane({0, 0, 0}, {0, 1, 0}, {0, 0, 1});
    const std::array<std::array<double, 2>, 5> corners{{{0, 0}, {1 - small, 0}, {1, small}, {1, 1}, {0, 1}}};
    Patches curves;
    std::vector<const nurbs *> given;
    for (size_t i = 0; i < 5; ++i) {
        curves.push_back(solids::segment(corners[i], corners[(i + 1) % 5]));
        given.push_back(curves.back().get());
    }
    const int64_t five = 5;
    nurbs_face *face = nullptr;
    require_ok(
        nurbs_face_create(ground.get(), 1, &five, given.data(), nullptr, nullptr, 0, 0, nullptr, &face));
    faces[0] = Face(face);
    const Model model = sewn(faces, 1e-3);
    expect_counts(model.get(), {6, 12, 8, 12, 0});
    expect_closed(model.get(), 1e-1, 2);
    EXPECT_NEAR(gaps_of(model.get()).largest(), small, 1e-3 * small);
    const Model finer = sewn(faces, 1e-6); // to which nothing is small
    expect_counts(finer.get(), {6, 15, 10, 12, 3});
}

// A surface that is thinner than the tolerance does not make one of what is on both of its sides.
TEST(Sewing, SliversAreFaces) {
    Patches patches;
    patches.push_back(solids::plane({0, 0, 0}, {1, 0, 0}, {0, 1e-6, 0}));
    patches.push_back(solids::plane({0, 0, 0}, {1, 0, 0}, {0, -1, 0}));
    const Model sliver = sewn(faces_of(patches), 1e-3);
    EXPECT_EQ(counts_of(sliver.get()).faces, 2);
    EXPECT_EQ(uses_of(sliver.get()), (std::vector<int64_t>{0, 3, 0, 1}));
    const Model exact = sewn(faces_of(patches), 1e-9);
    EXPECT_EQ(uses_of(exact.get()), (std::vector<int64_t>{0, 6, 1}));
}

// A periodic side, in the plane of whose ends lie planes with their circles.
TEST(Sewing, PeriodicSidesMeetTrimmedPlanes) {
    const Handle bent =
        create({{3, 1},
                {9, 2},
                {{-3, -2, -1, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9}, {0, 0, 1, 1}},
                3,
                [] {
                    Vec points;
                    for (int i = 0; i < 9; ++i) {
                        const double angle = (i % 6) * pi / 3;
                        for (const double z : {0.0, 2.0}) {
                            points.insert(points.end(), {std::cos(angle), std::sin(angle), z});
                        }
                    }
                    return points;
                }(),
                {},
                NURBS_PERIODIC});
    Faces faces;
    faces.push_back(whole(bent));
    for (const double z : {0.0, 2.0}) {
        const Handle rim = iso(bent.get(), 1, z / 2);
        const Vec in_plane{0.25, 0, 0, 0, 0.25, 0}, middle{0.5, 0.5};
        const Handle loop = made(
            [&](nurbs **out) { return nurbs_transform(rim.get(), 2, in_plane.data(), middle.data(), out); });
        const nurbs *given[] = {loop.get()};
        const int64_t one = 1;
        nurbs_face *face = nullptr;
        require_ok(nurbs_face_create(solids::plane({-2, -2, z}, {4, 0, 0}, {0, 4, 0}).get(), 1, &one, given,
                                     nullptr, nullptr, 1e-9, 0, nullptr, &face));
        faces.emplace_back(face);
    }
    const Model model = sewn(faces, 1e-9);
    expect_counts(model.get(), {3, 2, 2, 2, 0});
    expect_closed(model.get(), 1e-2, 2);
}

// Three half planes at one line.
TEST(Sewing, AnEdgeMayHaveManyFaces) {
    Patches patches;
    for (const double angle : {0.0, 2.0, 4.0}) {
        patches.push_back(solids::plane({0, 0, 0}, {std::cos(angle), std::sin(angle), 0}, {0, 0, 1}));
    }
    const Model model = sewn(faces_of(patches), 1e-9);
    EXPECT_EQ(uses_of(model.get()), (std::vector<int64_t>{0, 9, 0, 1}));
}

// Each of five parallel sides is near its neighbours only. One edge less is made where the second of them gathers its neighbours
// than where the third one does.
TEST(Sewing, TheOrderOfAChainDoesNotMatter) {
    constexpr double tolerance = 1e-3;
    std::vector<size_t> order{0, 1, 2, 3, 4};
    std::set<std::vector<int64_t>> found;
    do {
        Patches patches;
        for (const size_t i : order) {
            const auto k = static_cast<double>(i);
            patches.push_back(
                solids::plane({0, 0.8 * tolerance * k, 0}, {1, 0, 0}, {0, std::cos(k), std::sin(k)}));
        }
        found.insert(uses_of(sewn(faces_of(patches), tolerance).get()));
    } while (std::ranges::next_permutation(order).found);
    EXPECT_EQ(found, (std::set<std::vector<int64_t>>{{0, 15, 1, 1}}));
}

// On a surface of a degree so high that the image of a loop can only be fitted, which no number of places does well enough.
TEST(Sewing, ErrorsOfImagesNameTheFace) {
    const Handle octant = std::move(octants().front()),
                 high = elevate(elevate(octant.get(), 0, 7).get(), 1, 7);
    double u[2], v[2];
    require_ok(nurbs_domain(high.get(), 0, u));
    require_ok(nurbs_domain(high.get(), 1, v));
    const double middle[] = {(u[0] + u[1]) / 2, (v[0] + v[1]) / 2};
    const Handle circle = made([&](nurbs **out) {
        return nurbs_curve_circle(2, middle, nullptr, nullptr, (u[1] - u[0]) / 4, NURBS_ARC_QUARTERS, out);
    });
    const nurbs *loop[] = {circle.get()};
    const int64_t one = 1;
    nurbs_face *trimmed = nullptr;
    require_ok(nurbs_face_create(high.get(), 1, &one, loop, nullptr, nullptr, 1e-9, 0, nullptr, &trimmed));
    const Face second(trimmed), first = whole(octant);
    const nurbs_face *given[] = {first.get(), second.get()};
    nurbs_model *model = nullptr;
    EXPECT_EQ(nurbs_model_sew(2, given, 1e-17, 1, &model), NURBS_ERROR_NOT_CONVERGED);
    char text[256];
    nurbs_last_error(text, sizeof text);
    EXPECT_EQ(std::string(text).substr(0, 10), "faces[1]: ") << text;
}

// Curves along one another at different speeds.
TEST(Sewing, ParametersNeedNotAgree) {
    const Handle fast = create({{2, 1},
                                {3, 2},
                                {{0, 0, 0, 1, 1, 1}, {0, 0, 1, 1}},
                                3,
                                {0, 0, 0, 0, 1, 0, 0.9, 0, 0, 0.9, 1, 0, 1, 0, 0, 1, 1, 0},
                                {},
                                0});
    Patches patches;
    patches.push_back(made([&](nurbs **out) { return nurbs_clone(fast.get(), out); }));
    patches.push_back(solids::plane({0, 0, 0}, {1, 0, 0}, {0, 0, 1}));
    const Model model = sewn(faces_of(patches), 1e-6);
    EXPECT_EQ(uses_of(model.get()), (std::vector<int64_t>{0, 6, 1}));
    EXPECT_LE(gaps_of(model.get()).largest(), 1e-6);
    EXPECT_EQ(mesh_of(model.get(), 1e-2).euler, 1);
}

} // namespace sewing_test
