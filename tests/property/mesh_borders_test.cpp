// Meshes of faces with borders that other meshers fail at: each is whole, has the Euler characteristic and the area of the face,
// and keeps to the bounds that it tells.
#include "property/mesh_samples.h"
#include "support/cases.h"

#include <gtest/gtest.h>

namespace mesh_borders_test {

using namespace support;
using namespace support::meshes;
using faces::Face;
using faces::Ground;
using faces::pi;
using faces::Place;
using faces::polygon;
using faces::segment;
using meshes::Point;

namespace {

constexpr int64_t samples = 2000;

Mesh expect_reached(const nurbs *ground, const nurbs_face *face, double chord, int64_t characteristic,
                    uint64_t seed = 1) {
    const Mesh mesh = mesh_of(face, chord);
    Random random(seed);
    EXPECT_EQ(mesh.reached, 1);
    EXPECT_LE(std::max(mesh.from_shape, mesh.from_mesh), chord);
    EXPECT_EQ(euler(mesh, sides_of(mesh)), characteristic);
    expect_whole(mesh);
    expect_shape_near(ground, face, mesh, random, scaled(samples));
    expect_mesh_near(ground, mesh, random, scaled(samples));
    return mesh;
}

// On a surface of size one, what is missing is as wide as the chord along borders of a length of a few.
Mesh expect_face(const nurbs *ground, const nurbs_face *face, double chord, int64_t characteristic) {
    Mesh mesh = expect_reached(ground, face, chord, characteristic);
    const double area = faces::area_of(face, 1e-6);
    EXPECT_NEAR(area_of(mesh), area, 20 * chord + 1e-6 * area);
    return mesh;
}

Handle circle(const Place &centre, double radius) {
    return made([&](nurbs **out) {
        return nurbs_curve_circle(2, centre.data(), nullptr, nullptr, radius, NURBS_ARC_QUARTERS, out);
    });
}

std::vector<Place> square(const Place &centre, double half) {
    return {{centre[0] - half, centre[1] - half},
            {centre[0] + half, centre[1] - half},
            {centre[0] + half, centre[1] + half},
            {centre[0] - half, centre[1] + half}};
}

// From a place around the domain and back, at a height that goes up and down: n segments, in one direction or the other.
std::vector<Handle> around(const Ground &ground, double from, double height, double swing, int n, bool back) {
    std::vector<Handle> curves;
    for (int i = 0; i < n; ++i) {
        const auto at = [&](int k) {
            const double share = static_cast<double>(back ? n - k : k) / n;
            return ground.at(from + share, height + (k % n == 0 ? 0 : swing * std::sin(2 * pi * share)));
        };
        curves.push_back(segment(at(i), at(i + 1)));
    }
    return curves;
}
std::vector<const nurbs *> given(const std::vector<Handle> &curves) {
    std::vector<const nurbs *> all;
    for (const Handle &curve : curves) {
        all.push_back(curve.get());
    }
    return all;
}

// A ground without the part of squares within squares, the outer one first or not.
struct Squares {
    std::vector<Handle> loops;
    faces::Curves curves;

    explicit Squares(const std::vector<double> &halves) {
        for (const double half : halves) {
            loops.push_back(polygon(square({0.5, 0.5}, half)));
            curves.push_back({loops.back().get()});
        }
    }
};

} // namespace

TEST(MeshBorders, holes_within_holes_alternate) {
    Random random(1);
    const Ground ground = faces::wavy(random);
    const Squares squares({0.45, 0.4, 0.3, 0.2, 0.1});
    const Face face = faces::face_of(ground.surface.get(), squares.curves);
    expect_face(ground.surface.get(), face.get(), 3e-3, 1); // two rings and a disk
}

// conway#711: the first loop taken for the outer one, holes lost without a word.
TEST(MeshBorders, outer_loop_is_not_first) {
    Random random(2);
    const Ground ground = faces::wavy(random);
    for (const std::vector<double> &halves : {std::vector{0.1, 0.4}, {0.2, 0.1, 0.4}, {0.1, 0.2, 0.3, 0.4}}) {
        const Squares squares(halves);
        const Face face = faces::face_of(ground.surface.get(), squares.curves);
        expect_face(ground.surface.get(), face.get(), 3e-3, halves.size() % 2);
    }
}

TEST(MeshBorders, loops_given_backwards_are_turned) {
    Random random(3);
    const Ground ground = faces::wavy(random);
    std::vector<Place> outer = square({0.5, 0.5}, 0.4), inner = square({0.5, 0.5}, 0.2);
    double areas[2];
    for (const bool back : {false, true}) {
        const Handle first = polygon(outer), second = polygon(inner);
        const Face face = faces::face_of(ground.surface.get(), {{first.get()}, {second.get()}});
        areas[back] = area_of(expect_face(ground.surface.get(), face.get(), 3e-3, 0));
        std::ranges::reverse(outer);
        std::ranges::reverse(inner);
    }
    EXPECT_NEAR(areas[0], areas[1], 1e-3 * areas[0]);
}

// The middle of a triangle between a coarse polygon and its circle is inside of the circle and outside of the polygon.
TEST(MeshBorders, coarse_polygons_bound_what_their_curves_bound) {
    const Vec knots{0, 0, 0.5, 1, 1};
    SplineData data{{1, 1}, {3, 3}, {knots, knots}, 3, {}, {}, 0};
    for (int i = 0; i < 9; ++i) {
        data.points.insert(data.points.end(), {i / 3 / 2.0, i % 3 / 2.0, 0});
    }
    const Handle plate = create(data);
    const Handle disc = circle({0.5, 0.5}, 0.46), hole = circle({0.5, 0.5}, 0.083);
    for (const double chord : {0.02, 0.05, 0.1, 0.15, 0.19, 0.24, 0.33, 0.5}) {
        const Face whole = faces::face_of(plate.get(), {{disc.get()}});
        EXPECT_GT(area_of(expect_face(plate.get(), whole.get(), chord, 1)), 0.3);
        const Face washer = faces::face_of(plate.get(), {{disc.get()}, {hole.get()}});
        EXPECT_GT(area_of(expect_face(plate.get(), washer.get(), chord, 0)), 0.25);
    }
}

TEST(MeshBorders, loops_around_a_cylinder_bound_a_band) {
    const Ground ground = faces::cylinder(2, 3);
    for (const double from : {0.0, 0.3}) {
        for (const double swing : {0.0, 0.15}) {
            const auto low = around(ground, from, 0.25, swing, 24, false),
                       high = around(ground, from, 0.75, -swing, 24, true);
            const Face face = faces::face_of(ground.surface.get(), {given(high), given(low)});
            expect_face(ground.surface.get(), face.get(), 0.02, 0);
        }
    }
}

TEST(MeshBorders, loops_over_a_pole_bound_a_cap) {
    const Ground ground = faces::sphere(1.5);
    for (const double from : {0.0, 0.37}) {
        for (const bool back : {false, true}) { // past the line in the middle, at which there may be a kink
            const auto loop = around(ground, from, 0.6, 0.1, 24, back);
            const Face face = faces::face_of(ground.surface.get(), {given(loop)});
            expect_face(ground.surface.get(), face.get(), 0.01, 1);
        }
    }
}

// Up one meridian to the pole and down another one.
TEST(MeshBorders, loops_through_a_pole_bound_a_wedge) {
    const Ground ground = faces::sphere(1.5);
    for (const double from : {0.0, 0.1, 0.9}) {
        const Place a = ground.at(from, 0.5), b = ground.at(from + 0.3, 0.5), c = ground.at(from + 0.3, 1),
                    d = ground.at(from, 1);
        const Handle low = segment(a, b), up = segment(b, c), down = segment(d, a);
        const Face face = faces::face_of(ground.surface.get(), {{low.get(), up.get(), down.get()}});
        for (const double chord :
             {0.03, 0.01}) { // at the coarse one, triangles at the pole could lie on each other
            expect_face(ground.surface.get(), face.get(), chord, 1);
        }
    }
}

TEST(MeshBorders, loops_through_a_pole_anywhere) {
    for_each_case(51, 40, [](Random &random, uint64_t seed) {
        const Ground ground = faces::sphere(1);
        const double from = random.unit(), width = random.between(0.02, 0.45),
                     low = random.between(0.05, 0.9);
        const Place a = ground.at(from, low), b = ground.at(from + width, low);
        const Handle bottom = segment(a, b), up = segment(b, ground.at(from + width, 1)),
                     down = segment(ground.at(from, 1), a);
        const Face face = faces::face_of(ground.surface.get(), {{bottom.get(), up.get(), down.get()}});
        SCOPED_TRACE(seed);
        expect_reached(ground.surface.get(), face.get(), random.magnitude(3e-3, 0.1), 1, seed);
    });
}

// From pole to pole and back: both ends of the seam on one side.
TEST(MeshBorders, loops_from_pole_to_pole_bound_a_slice) {
    const Ground ground = faces::sphere(1.5);
    for (const double from : {0.0, 0.4, 0.9}) {
        const Handle up = segment(ground.at(from + 0.25, 0), ground.at(from + 0.25, 1)),
                     down = segment(ground.at(from, 1), ground.at(from, 0));
        const Face face = faces::face_of(ground.surface.get(), {{up.get(), down.get()}});
        expect_face(ground.surface.get(), face.get(), 0.01, 1);
    }
}

TEST(MeshBorders, loops_along_the_seam) {
    for (const Ground &ground : {faces::cylinder(2, 3), faces::torus(3, 1)}) {
        for (const double from : {0.0, 0.6, 1.0}) {
            const Handle loop = polygon({ground.at(from, 0.25), ground.at(from + 0.4, 0.25),
                                         ground.at(from + 0.4, 0.75), ground.at(from, 0.75)});
            const Face face = faces::face_of(ground.surface.get(), {{loop.get()}});
            expect_face(ground.surface.get(), face.get(), 0.01, 1);
        }
    }
}

// OCCT#1337: wires that cross the seam. Wherever the seam is, there are about as many triangles.
TEST(MeshBorders, holes_across_the_seam_cost_no_more_than_others) {
    for (const Ground &ground : {faces::cylinder(2, 3), faces::torus(3, 1)}) {
        std::vector<size_t> counts;
        for (const double at : {0.5, 0.0, 1.0}) {
            const Handle outer = polygon({ground.at(at - 0.4, 0.1), ground.at(at + 0.4, 0.1),
                                          ground.at(at + 0.4, 0.9), ground.at(at - 0.4, 0.9)}),
                         hole =
                             circle(ground.at(at, 0.5), 0.2 * std::min(ground.period[0], ground.period[1]));
            const Face face = faces::face_of(ground.surface.get(), {{hole.get()}, {outer.get()}});
            counts.push_back(expect_face(ground.surface.get(), face.get(), 0.01, 0).triangles.size());
        }
        const auto [least, most] = std::ranges::minmax(counts);
        EXPECT_LE(most, 1.3 * static_cast<double>(least));
    }
}

// Segments that close gaps are borders as curves are, wherever the seam is, and whichever parameters the curves have.
TEST(MeshBorders, gaps_across_the_seam) {
    for (const Ground &ground : {faces::cylinder(2, 3), faces::torus(3, 1)}) {
        for (const double at : {0.5, 0.0, 1.0, 0.07, 0.96}) {
            for (const bool back : {false, true}) {
                for (const double end : {1.0, 0.7, 1e3 / 7}) {
                    const auto place = [&](double u, double v) { return ground.at(at + u, v); };
                    std::vector<Place> corners{place(-0.1, 0.2), place(-0.15, 0.8), place(0.2, 0.7),
                                               place(0.1, 0.3)};
                    if (back) {
                        std::ranges::reverse(corners);
                    }
                    SplineData data{{1}, {4}, {{0, 0, end / 3, end / 2, end, end}}, 2, {}, {}, 0};
                    for (const Place &x : corners) {
                        data.points.insert(data.points.end(), x.begin(), x.end());
                    }
                    const Handle open = create(data);
                    const Face face =
                        faces::face_of(ground.surface.get(), {{open.get()}}, 1e-9, NURBS_KEEP_GAPS);
                    for (const double chord : {0.1, 1e-3}) {
                        expect_face(ground.surface.get(), face.get(), chord, 1);
                    }
                }
            }
        }
    }
}

// In a corner of each, in the middle of a side, and of two holes.
TEST(MeshBorders, loops_that_touch_in_a_point) {
    Random random(5);
    const Ground ground = faces::wavy(random);
    const Handle outer = polygon({{0.1, 0.1}, {0.5, 0.1}, {0.9, 0.1}, {0.9, 0.9}, {0.1, 0.9}}),
                 at_corner = polygon({{0.1, 0.1}, {0.4, 0.2}, {0.2, 0.4}}),
                 at_vertex = polygon({{0.5, 0.1}, {0.6, 0.3}, {0.4, 0.3}}),
                 at_side = polygon({{0.9, 0.375}, {0.7, 0.6}, {0.7, 0.4}}),
                 first = polygon({{0.3, 0.5}, {0.4, 0.6}, {0.3, 0.7}, {0.2, 0.6}}),
                 second = polygon({{0.4, 0.6}, {0.5, 0.5}, {0.6, 0.6}, {0.5, 0.7}});
    const std::vector<std::vector<const nurbs *>> holes[] = {
        {{at_corner.get()}}, {{at_vertex.get()}}, {{at_side.get()}}, {{first.get()}, {second.get()}}};
    for (const auto &some : holes) {
        faces::Curves loops{{outer.get()}};
        loops.insert(loops.end(), some.begin(), some.end());
        const Face face = faces::face_of(ground.surface.get(), loops);
        const Mesh mesh = mesh_of(face.get(), 3e-3);
        EXPECT_EQ(mesh.reached, 1);
        EXPECT_LE(std::max(mesh.from_shape, mesh.from_mesh), 3e-3);
        EXPECT_NEAR(area_of(mesh), faces::area_of(face.get(), 1e-6), 0.05);
        expect_whole(mesh);
        expect_shape_near(ground.surface.get(), face.get(), mesh, random, scaled(samples));
    }
}

// conway#608: on thin strips the deflection was missed 38 to 298 times.
TEST(MeshBorders, strips_of_aspect_100000) {
    Random random(6);
    const Ground wavy = faces::wavy(random), cylinder = faces::cylinder(2, 3);
    for (const Ground *ground : {&wavy, &cylinder}) {
        for (const double chord : {1e-2, 1e-4}) {
            const Handle strip = polygon({ground->at(0.1, 0.3), ground->at(0.9, 0.3),
                                          ground->at(0.9, 0.300008), ground->at(0.1, 0.300008)});
            const Face face = faces::face_of(ground->surface.get(), {{strip.get()}});
            const Mesh mesh = mesh_of(face.get(), chord);
            EXPECT_EQ(mesh.reached, 1);
            EXPECT_EQ(euler(mesh, sides_of(mesh)), 1);
            expect_whole(mesh);
            EXPECT_LE(mesh.triangles.size(), 40 / std::sqrt(chord));
            for (int i = 0; i < 1000; ++i) { // samples of the domain would miss it
                const Place at = ground->at(random.between(0.1, 0.9), random.between(0.3, 0.300008));
                EXPECT_LE(distance(mesh, point_of(ground->surface.get(), at)), mesh.from_shape * (1 + 1e-12));
            }
        }
    }
}

TEST(MeshBorders, holes_smaller_than_the_tolerance_stay) {
    Random random(8);
    const Ground ground = faces::wavy(random);
    for (const double radius : {1e-3, 1e-5, 1e-7}) {
        const Handle outer = polygon(square({0.5, 0.5}, 0.4)), hole = circle({0.4, 0.6}, radius);
        const Face face = faces::face_of(ground.surface.get(), {{outer.get()}, {hole.get()}});
        expect_face(ground.surface.get(), face.get(), 1e-2, 0);
    }
}

// All of a face: smaller than the tolerance.
TEST(MeshBorders, faces_smaller_than_the_tolerance_stay) {
    Random random(9);
    const Ground ground = faces::wavy(random);
    for (const double radius : {1e-3, 1e-5, 1e-7}) {
        const Handle outer = circle({0.4, 0.6}, radius);
        const Face face = faces::face_of(ground.surface.get(), {{outer.get()}});
        const Mesh mesh = mesh_of(face.get(), 1e-2);
        EXPECT_EQ(mesh.reached, 1);
        EXPECT_EQ(euler(mesh, sides_of(mesh)), 1);
        expect_whole(mesh);
    }
}

namespace {

// A square of the plane whose edges in space stand beside it.
Face beside(const Ground &ground, double off, std::vector<Handle> &keep) {
    const std::vector<Place> corners = square({0.5, 0.5}, 0.4);
    std::vector<const nurbs *> curves, edges;
    for (size_t i = 0; i < 4; ++i) {
        const Place &a = corners[i], &b = corners[(i + 1) % 4];
        keep.push_back(segment(a, b));
        curves.push_back(keep.back().get());
        keep.push_back(create({{1}, {2}, {{0, 0, 1, 1}}, 3, {a[0], a[1], off, b[0], b[1], off}, {}, 0}));
        edges.push_back(keep.back().get());
    }
    const int64_t four = 4;
    nurbs_face *face = nullptr;
    require_ok(nurbs_face_create(ground.surface.get(), 1, &four, curves.data(), edges.data(), nullptr, 2e-3,
                                 0, nullptr, &face));
    return Face(face);
}

} // namespace

// Polygons of two borders that are nearer to each other than the chord cross, until they have enough sides.
TEST(MeshBorders, rings_much_thinner_than_the_chord) {
    const Ground ground = faces::plane();
    for (const double gap : {1e-3, 1e-4, 1e-6}) {
        const Handle outer = circle({0.5, 0.5}, 0.4), inner = circle({0.5, 0.5}, 0.4 - gap);
        const Face face = faces::face_of(ground.surface.get(), {{outer.get()}, {inner.get()}});
        const Mesh mesh = mesh_of(face.get(), 1e-2);
        EXPECT_EQ(mesh.reached, 1) << gap;
        EXPECT_LE(std::max(mesh.from_shape, mesh.from_mesh), 1e-2) << gap;
        EXPECT_EQ(euler(mesh, sides_of(mesh)), 0) << gap;
        expect_whole(mesh);
        EXPECT_LT(mesh.triangles.size(), 10 / std::sqrt(gap)) << gap;
    }
}

// Points are on the edges, and the distance of these from the curves is told.
TEST(MeshBorders, curves_off_their_edges) {
    const Ground ground = faces::plane();
    std::vector<Handle> keep;
    const Face face = beside(ground, 1e-3, keep);
    const Mesh coarse = mesh_of(face.get(), 1e-2), fine = mesh_of(face.get(), 1e-4);
    EXPECT_EQ(coarse.reached, 1);
    EXPECT_EQ(fine.reached, 0);             // nothing else can be proven
    EXPECT_LT(fine.triangles.size(), 100U); // parts would be as far from the surface
    for (const Mesh *mesh : {&coarse, &fine}) {
        EXPECT_GE(mesh->from_shape, 1e-3 * (1 - 1e-9));
        EXPECT_LE(mesh->from_shape, 4e-3);
        EXPECT_EQ(euler(*mesh, sides_of(*mesh)), 1);
        expect_whole(*mesh);
        Random random(1);
        expect_shape_near(ground.surface.get(), face.get(), *mesh, random, scaled(samples));
        expect_mesh_near(ground.surface.get(), *mesh, random, scaled(samples));
    }
}

namespace {

// A patch of which one side is a point, and of which two are.
Ground collapsed(Random &random, bool both) {
    const Vec knots{0, 0, 0, 0.5, 1, 1, 1};
    SplineData data{{2, 2}, {4, 4}, {knots, knots}, 3, {}, {}, 0};
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) {
            const double width = j == 0 ? 0 : j == 3 && both ? 0 : 1;
            data.points.insert(data.points.end(),
                               {width * (i - 1.5) / 3, j / 3.0, width * random.between(-0.2, 0.2)});
        }
    }
    return faces::ground_of(create(data), false, false);
}

} // namespace

TEST(MeshBorders, sides_that_are_points) {
    const auto expect_collapsed = [](Random &random, uint64_t seed) {
        SCOPED_TRACE(seed);
        const Ground ground = collapsed(random, seed % 2 == 0);
        const Mesh whole = mesh_of(ground.surface.get(), 3e-3);
        EXPECT_EQ(whole.reached, 1);
        EXPECT_EQ(euler(whole, sides_of(whole)), 1);
        expect_shape_near(ground.surface.get(), nullptr, whole, random, scaled(samples));
        const Handle hole = circle({0.5, 0.5}, 0.2);
        const double v[] = {0, 0.4}; // with the point, and a hole that comes near it
        const Handle outer = polygon({{0, v[0]}, {1, v[0]}, {1, 1}, {0, 1}});
        const Face face = faces::face_of(ground.surface.get(), {{outer.get()}, {hole.get()}});
        expect_face(ground.surface.get(), face.get(), 3e-3, 0);
    };
    for_each_case(11, 6, expect_collapsed);
    Random random(21); // triangles that are narrow at the point, and leave the surface along their long sides
    expect_collapsed(random, 21);
}

namespace {

// Anywhere, so that borders come near seams, lines of kinks and their crossings.
void expect_star(Random &random, uint64_t seed) {
    const std::vector<Ground> grounds = faces::grounds(random);
    const auto which = static_cast<size_t>(random.whole(1, 4));
    const Ground &ground = grounds[which];
    faces::Star outer{random.whole(1, 6), random.chance(50), false, 0};
    outer.periodic = outer.degree > 1 && random.chance(50);
    const double v = ground.closed[1]                  ? random.unit()
                     : which == 3 && random.chance(50) ? random.between(0.42, 0.58)
                                                       : 0.5;
    const double u = ground.closed[0] ? random.unit() : 0.5;
    outer.radius = random.between(0.05, 0.4);
    const Handle star = create(faces::star(random, ground, ground.at(u, v), outer));
    faces::Star inner{3, outer.rational, false, outer.radius * random.between(0.02, 0.15)};
    inner.degree = random.whole(1, 5);
    const Handle hole = create(faces::star(random, ground, ground.at(u, v), inner));
    const bool with_hole = random.chance(60);
    const double chord = random.magnitude(1e-3, 0.2);
    faces::Curves loops{{star.get()}};
    if (with_hole) {
        loops.push_back({hole.get()});
    }
    const Face face = faces::face_of(ground.surface.get(), loops);
    SCOPED_TRACE(seed);
    expect_reached(ground.surface.get(), face.get(), chord, with_hole ? 0 : 1, seed);
}

} // namespace

// In some of them, cuts of cells were beside each other by a rounding, or only a seam was left to be divided.
TEST(MeshBorders, stars_with_holes_anywhere) {
    for_each_case(87, 8, expect_star);
    for_each_case(167, 2, expect_star);
    for_each_case(545, 8, expect_star);
}

TEST(MeshBorders, degrees_13_and_1) {
    for_each_case(31, 4, [](Random &random, uint64_t seed) {
        SplineData data{{13, 1}, {14, 2}, {{}, {0, 0, 1, 1}}, 3, {}, {}, 0};
        data.knots[0].assign(14, 0);
        data.knots[0].resize(28, 1);
        for (int i = 0; i < 14; ++i) {
            for (int j = 0; j < 2; ++j) {
                data.points.insert(data.points.end(),
                                   {i / 13.0, static_cast<double>(j), random.between(-1, 1)});
            }
        }
        const Handle g = create(data);
        const Mesh whole = mesh_of(g.get(), 1e-2);
        EXPECT_EQ(whole.reached, 1) << seed;
        EXPECT_EQ(euler(whole, sides_of(whole)), 1) << seed;
        expect_shape_near(g.get(), nullptr, whole, random, scaled(samples));
        expect_mesh_near(g.get(), whole, random, scaled(samples));
        const Handle outer = circle({0.5, 0.5}, 0.4), hole = circle({0.5, 0.5}, 0.1);
        const Face face = faces::face_of(g.get(), {{outer.get()}, {hole.get()}});
        expect_face(g.get(), face.get(), 1e-2, 0);
    });
}

// Loops that cross are refused by name where that is asked for, or where there are places inside twice. Else what is inside of a loop
// that crosses itself has no meaning where it does, and nothing is proven.
TEST(MeshBorders, loops_that_cross_are_told) {
    Random random(13);
    const Ground ground = faces::wavy(random);
    const Handle bow = polygon({{0.1, 0.1}, {0.9, 0.85}, {0.9, 0.1}, {0.1, 0.9}}),
                 outer = polygon(square({0.5, 0.5}, 0.3)), across = polygon(square({0.8, 0.8}, 0.15));
    const faces::Curves two{{outer.get()}, {across.get()}};
    EXPECT_EQ(faces::checked(ground.surface.get(), {{bow.get()}}, 1e-9), NURBS_ERROR_CROSSING);
    EXPECT_EQ(faces::checked(ground.surface.get(), two, 1e-9), NURBS_ERROR_CROSSING);
    EXPECT_THROW(faces::face_of(ground.surface.get(), two), std::runtime_error);
    const Mesh mesh = mesh_of(faces::face_of(ground.surface.get(), {{bow.get()}}).get(), 3e-3);
    EXPECT_EQ(mesh.reached, 0);
    EXPECT_EQ(mesh.from_shape, INFINITY);
}

} // namespace mesh_borders_test
