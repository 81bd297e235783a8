// Sections of models: closed ways with the areas and lengths of closed forms, on the side of the material, whatever the plane; what
// touches or lies in a plane is told, and never closed the wrong way.
#include "property/model_sections.h"
#include "property/solids.h"
#include "support/cases.h"
#include "support/step_solids.h"

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <numbers>

namespace model_sections_test {

using namespace support;
using namespace support::solids;
using namespace model_sections;

namespace {

constexpr double pi = std::numbers::pi;

Point3 random_direction(Random &random) {
    for (;;) {
        const Point3 d{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
        const double length = std::sqrt(dot(d, d));
        if (length > 0.1 && length < 1) {
            return {d[0] / length, d[1] / length, d[2] / length};
        }
    }
}

double dot_of(const Plane &plane, const Point3 &x) {
    return dot(plane.normal, x) - plane.offset;
}

// Where a plane cuts a box: the corners of a polygon, around its middle.
std::vector<Point3> polygon(const Point3 &lower, const Point3 &size, const Plane &plane) {
    std::vector<Point3> found;
    for (size_t axis = 0; axis < 3; ++axis) {
        for (int ends = 0; ends < 4; ++ends) {
            Point3 a = lower;
            a[(axis + 1) % 3] += (ends & 1) != 0 ? size[(axis + 1) % 3] : 0;
            a[(axis + 2) % 3] += (ends & 2) != 0 ? size[(axis + 2) % 3] : 0;
            Point3 b = a;
            b[axis] += size[axis];
            const double from = dot_of(plane, a), to = dot_of(plane, b);
            if ((from > 0) != (to > 0)) {
                a[axis] += size[axis] * from / (from - to);
                found.push_back(a);
            }
        }
    }
    if (found.empty()) {
        return found;
    }
    Point3 middle{0, 0, 0};
    for (const Point3 &x : found) {
        for (size_t c = 0; c < 3; ++c) {
            middle[c] += x[c] / static_cast<double>(found.size());
        }
    }
    const Point3 u = minus(found[0], middle), v = cross(plane.normal, u);
    std::ranges::sort(found, {}, [&](const Point3 &x) {
        return std::atan2(dot(v, minus(x, middle)) / std::sqrt(dot(plane.normal, plane.normal)),
                          dot(u, minus(x, middle)));
    });
    return found;
}

struct Polygon {
    double area = 0, length = 0;
};
Polygon measures(const std::vector<Point3> &corners, const Point3 &normal) {
    Polygon found;
    for (size_t i = 0; i < corners.size(); ++i) {
        const Point3 &a = corners[i], &b = corners[(i + 1) % corners.size()];
        found.area += dot(normal, cross(minus(a, corners[0]), minus(b, corners[0]))) / 2;
        found.length += surface_sections::distance(a, b);
    }
    return found;
}

Face whole_ball(double radius) {
    return whole(made([&](nurbs **out) {
        return nurbs_surface_sphere(nullptr, nullptr, nullptr, radius, NURBS_ARC_QUARTERS, out);
    }));
}
Face whole_torus(double major, double minor) {
    return whole(made([&](nurbs **out) {
        return nurbs_surface_torus(nullptr, nullptr, nullptr, major, minor, 0, 2 * pi, 0, 2 * pi,
                                   NURBS_ARC_QUARTERS, out);
    }));
}

struct Solid {
    const char *name;
    Model model;
    std::function<double(const Point3 &)> depth; // > 0 inside
    double size, volume;
};

double in_cube(const Point3 &x, double low, double high) {
    double depth = HUGE_VAL;
    for (const double c : x) {
        depth = std::min({depth, c - low, high - c});
    }
    return depth;
}

std::vector<Solid> files() {
    using namespace step_test;
    const auto ball = [](const Point3 &x) { return 3 - std::hypot(x[0], x[1], x[2]); };
    const auto cylinder = [](const Point3 &x) {
        return std::min({2 - std::hypot(x[0], x[1]), x[2], 5 - x[2]});
    };
    std::vector<Solid> found;
    found.push_back(
        {"cube", read_model(step_cube()), [](const Point3 &x) { return in_cube(x, 0, 2); }, 2, 8});
    found.push_back({"cube with voids", read_model(step_hollow_cube()),
                     [](const Point3 &x) {
                         return std::min({in_cube(x, 0, 4), -in_cube(x, 1, 2), -in_cube(x, 2.5, 3)});
                     },
                     4, 64 - 1 - 0.125});
    found.push_back({"cylinder", read_model(step_cylinder(false)), cylinder, 5, 20 * pi});
    found.push_back({"cylinder with a seam curve", read_model(step_cylinder(true)), cylinder, 5, 20 * pi});
    found.push_back({"cone", read_model(step_cone()),
                     [](const Point3 &x) { return std::min(x[2], 3 - 0.75 * x[2] - std::hypot(x[0], x[1])); },
                     4, 12 * pi});
    found.push_back({"sphere in a vertex loop", read_model(step_sphere(true)), ball, 3, 36 * pi});
    found.push_back({"sphere with its seam", read_model(step_sphere(false)), ball, 3, 36 * pi});
    found.push_back(
        {"half a torus", read_model(step_half_torus()),
         [](const Point3 &x) { return std::min(x[2], 2 - std::hypot(std::hypot(x[0], x[1]) - 5, x[2])); }, 7,
         20 * pi * pi});
    std::vector<Face> torus;
    torus.push_back(whole_torus(3, 1));
    found.push_back({"torus", model_of(given(torus)),
                     [](const Point3 &x) { return 1 - std::hypot(std::hypot(x[0], x[1]) - 3, x[2]); }, 4,
                     6 * pi * pi});
    const std::vector<Face> parts = closed_cylinder(2, 5);
    found.push_back({"cylinder of faces", model_of(given(parts)), cylinder, 5, 20 * pi});
    return found;
}

} // namespace

// The first face of these boxes has its normal inwards, so that all run the other way.
TEST(ModelSections, of_boxes_are_polygons) {
    int64_t cut = 0;
    for_each_case(3710000, 200, [&](Random &random, uint64_t seed) {
        Point3 size{}, origin{};
        const std::vector<Face> faces = box(random, size, origin);
        const Model model = model_of(given(faces));
        std::vector<Plane> planes;
        for (int i = 0; i < 8; ++i) {
            const Point3 normal = random_direction(random);
            Point3 through{};
            for (size_t c = 0; c < 3; ++c) {
                through[c] = origin[c] + size[c] * random.between(-0.2, 1.2);
            }
            planes.push_back({normal, dot(normal, through)});
        }
        const Section section = section_of(model.get(), planes, 1e-9);
        ASSERT_TRUE(section.found.complete) << seed;
        ASSERT_EQ(section.open(), 0) << seed;
        check_section(model.get(), section, planes, 1e-9);
        for (size_t i = 0; i < planes.size(); ++i) {
            const auto level = static_cast<int64_t>(i);
            const std::vector<Point3> corners = polygon(origin, size, planes[i]);
            const Polygon expected = measures(corners, planes[i].normal);
            const auto ways = std::ranges::count(section.ways, level, &Way::level);
            ASSERT_EQ(ways, corners.empty() ? 0 : 1) << seed;
            cut += ways;
            for (const Way &way : section.ways) {
                if (way.level == level) {
                    ASSERT_EQ(way.branches.size(), corners.size()) << seed;
                    ASSERT_NEAR(area_of(section, way, planes[i].normal), -expected.area, 1e-7) << seed;
                    ASSERT_NEAR(length_of(section, way), expected.length, 1e-7) << seed;
                    ASSERT_LE(way.gap, 1e-8) << seed;
                }
            }
        }
    });
    EXPECT_GE(cut, of_whole_run(600));
}

TEST(ModelSections, of_a_cylinder_are_discs_ellipses_and_rectangles) {
    const std::vector<Face> faces = closed_cylinder(2, 5);
    const Model model = model_of(given(faces));
    const double tilt = 0.3;
    const std::vector<Plane> planes{
        {{0, 0, 1}, 2.5}, {{std::sin(tilt), 0, std::cos(tilt)}, 2.5}, {{1, 0, 0}, 1.2}};
    const Section section = section_of(model.get(), planes, 1e-8);
    check_section(model.get(), section, planes, 1e-8);
    ASSERT_TRUE(section.found.complete);
    ASSERT_EQ(section.ways.size(), 3U);
    EXPECT_EQ(section.open(), 0);
    EXPECT_NEAR(area_of(section, 0, planes[0].normal), 4 * pi, 1e-6);
    EXPECT_NEAR(length_of(section, section.ways[0]), 4 * pi, 1e-6);
    EXPECT_NEAR(area_of(section, 1, planes[1].normal), 4 * pi / std::cos(tilt), 1e-6);
    EXPECT_NEAR(area_of(section, 2, planes[2].normal), 2 * 1.6 * 5, 1e-6);
    EXPECT_NEAR(length_of(section, section.ways[2]), 2 * (2 * 1.6 + 5), 1e-6);
}

// Through the poles they may end there in touches.
TEST(ModelSections, of_spheres_are_discs) {
    std::vector<Face> faces;
    faces.push_back(whole_ball(2));
    const Model own = model_of(given(faces));
    const Model loop = read_model(step_test::step_sphere(true)),
                seam = read_model(step_test::step_sphere(false));
    for (const nurbs_model *model : {own.get(), loop.get(), seam.get()}) {
        const double radius = model == own.get() ? 2 : 3;
        for_each_case(3720000, 20, [&](Random &random, uint64_t seed) {
            Point3 normal = random_direction(random);
            const bool through_poles = random.chance(40);
            normal[2] = through_poles ? 0 : normal[2];
            const double length = std::sqrt(dot(normal, normal));
            const double distance = through_poles ? 0 : random.between(-0.95, 0.95) * radius;
            const std::vector<Plane> planes{{normal, distance * length}};
            const Section section = section_of(model, planes, 1e-8);
            ASSERT_TRUE(section.found.complete) << seed;
            if (!through_poles) {
                ASSERT_EQ(section.open(), 0) << seed;
            }
            if (section.open() == 0) {
                ASSERT_EQ(section.ways.size(), 1U) << seed;
                ASSERT_NEAR(area_of(section, 0, normal), pi * (radius * radius - distance * distance), 1e-6)
                    << seed;
                return;
            }
            for (const Branch &branch : section.found.branches) { // from pole to pole
                for (const int64_t node : branch.nodes) {
                    ASSERT_EQ(section.found.nodes[static_cast<size_t>(node)].kind, NURBS_NODE_TOUCH) << seed;
                }
            }
        });
    }
}

// The hole of a torus counts against it.
TEST(ModelSections, of_a_torus_have_signed_areas) {
    std::vector<Face> faces;
    faces.push_back(whole_torus(3, 1));
    const Model model = model_of(given(faces));
    const std::vector<Plane> planes{{{0, 0, 1}, 0.6}, {{1, 0, 0}, 0}, {{0, 0, -2}, -1.2}};
    const Section section = section_of(model.get(), planes, 1e-8);
    check_section(model.get(), section, planes, 1e-8);
    ASSERT_TRUE(section.found.complete);
    ASSERT_EQ(section.ways.size(), 6U);
    EXPECT_EQ(section.open(), 0);
    const double flat = pi * (3.8 * 3.8 - 2.2 * 2.2);
    EXPECT_NEAR(area_of(section, 0, planes[0].normal), flat, 1e-6);
    EXPECT_NEAR(area_of(section, 1, planes[1].normal), 2 * pi, 1e-6);
    EXPECT_NEAR(area_of(section, 2, planes[2].normal), flat, 1e-6);
}

// Around places inside of the material the ways of a plane run once, around others not at all; and areas add up to the volume.
TEST(ModelSections, enclose_the_material) {
    for (const Solid &solid : files()) {
        SCOPED_TRACE(solid.name);
        int64_t inside = 0, outside = 0;
        for_each_case(3730000, 12, [&](Random &random, uint64_t seed) {
            std::vector<Plane> planes;
            for (int i = 0; i < 4; ++i) {
                const Point3 normal = random_direction(random);
                const Point3 through{random.between(-1, 1) * solid.size, random.between(-1, 1) * solid.size,
                                     random.between(0, 1) * solid.size};
                planes.push_back({normal, dot(normal, through)});
            }
            const Section section = section_of(solid.model.get(), planes, 1e-7);
            ASSERT_TRUE(section.found.complete) << seed;
            ASSERT_EQ(section.open(), 0) << seed;
            check_section(solid.model.get(), section, planes, 1e-7);
            for (int i = 0; i < 40; ++i) {
                const auto level = random.whole(0, 3);
                const Plane &plane = planes[static_cast<size_t>(level)];
                Point3 x{random.between(-1, 1) * solid.size, random.between(-1, 1) * solid.size,
                         random.between(-1, 1) * solid.size};
                const double off = dot_of(plane, x);
                for (size_t c = 0; c < 3; ++c) {
                    x[c] -= off * plane.normal[c];
                }
                const Winding winding = winding_of(section, level, plane.normal, x);
                const double depth = solid.depth(x);
                if (winding.nearest > 0.1 && std::abs(depth) > 0.1) {
                    ASSERT_NEAR(winding.turns, depth > 0 ? 1 : 0, 1e-6) << seed << ' ' << depth;
                    (depth > 0 ? inside : outside) += 1;
                }
            }
        });
        EXPECT_GE(inside, of_whole_run(20));
        EXPECT_GE(outside, of_whole_run(100));
    }
}

TEST(ModelSections, add_up_to_volumes) {
    constexpr int steps = 200;
    for (const Solid &solid : files()) {
        SCOPED_TRACE(solid.name);
        const Point3 normal{0.36, 0.48, 0.8};
        const double reach = 2 * solid.size, width = 2 * reach / steps;
        std::vector<Plane> planes;
        for (int i = 0; i < steps; ++i) {
            planes.push_back({normal, -reach + (i + 0.5) * width});
        }
        const Section section = section_of(solid.model.get(), planes, 1e-5);
        EXPECT_TRUE(section.found.complete);
        EXPECT_EQ(section.open(), 0);
        double volume = 0;
        for (const Way &way : section.ways) {
            volume += width * area_of(section, way, normal);
        }
        EXPECT_NEAR(volume / solid.volume, 1, 2e-3);
    }
}

// Planes through corners and edges of a cube, and in its faces: what is closed encloses what is just below the plane.
TEST(ModelSections, through_corners_and_edges_are_as_just_below) {
    for (const bool of_file : {false, true}) {
        Random random(7);
        Point3 size{2, 2, 2}, origin{0, 0, 0};
        std::vector<Face> faces;
        Model model = read_model(step_test::step_cube());
        if (!of_file) {
            faces = box(random, size, origin);
            model = model_of(given(faces));
        }
        int64_t closed = 0, count = 0;
        for (int a = 0; a < 27; ++a) {
            for (int b = 0; b < 27; ++b) {
                const auto place = [&](int number) {
                    Point3 x{};
                    for (size_t c = 0; c < 3; ++c, number /= 3) {
                        x[c] = origin[c] + size[c] * (number % 3) / 2;
                    }
                    return x;
                };
                const Point3 normal = minus(place(a), place(b));
                if (dot(normal, normal) == 0) {
                    continue;
                }
                const std::vector<Plane> planes{{normal, dot(normal, place(a))},
                                                {normal, dot(normal, place(13))}};
                const Section section = section_of(model.get(), planes, 1e-9);
                const double length = std::sqrt(dot(normal, normal));
                for (size_t i = 0; i < 2; ++i) {
                    const Plane below{{normal[0] / length, normal[1] / length, normal[2] / length},
                                      planes[i].offset / length - 1e-7};
                    const double expected = measures(polygon(origin, size, below), below.normal).area;
                    double area = 0;
                    bool open = false;
                    for (const Way &way : section.ways) {
                        if (way.level == static_cast<int64_t>(i)) {
                            open = open || !way.closed;
                            area += area_of(section, way, normal);
                        }
                    }
                    ++count;
                    closed += open ? 0 : 1;
                    if (!open) {
                        ASSERT_NEAR(of_file ? area : -area, expected, 1e-5 * (1 + expected))
                            << of_file << ' ' << a << ' ' << b << ' ' << i;
                    }
                }
            }
        }
        EXPECT_EQ(closed, count);
    }
}

// Each plane is for itself, whatever the others, and from its other side all is the same, run the other way.
TEST(ModelSections, do_not_depend_on_other_planes) {
    for (const Solid &solid : files()) {
        SCOPED_TRACE(solid.name);
        Random random(11);
        std::vector<Plane> planes;
        const Point3 shared = random_direction(random);
        for (int i = 0; i < 6; ++i) {
            const Point3 normal = i % 2 == 0 ? shared : random_direction(random);
            planes.push_back({normal, random.between(-0.5, 0.9) * solid.size});
        }
        const Section all = section_of(solid.model.get(), planes, 1e-7);
        for (size_t i = 0; i < planes.size(); ++i) {
            const Plane &plane = planes[i];
            const Section one = section_of(solid.model.get(), {plane}, 1e-7);
            const auto level = static_cast<int64_t>(i);
            EXPECT_EQ(area_of(all, level, plane.normal), area_of(one, 0, plane.normal));
            EXPECT_EQ(std::ranges::count(all.ways, level, &Way::level), std::ssize(one.ways));
            const Plane turned{{-plane.normal[0], -plane.normal[1], -plane.normal[2]}, -plane.offset};
            const Section other = section_of(solid.model.get(), {turned}, 1e-7);
            EXPECT_EQ(other.ways.size(), one.ways.size());
            EXPECT_NEAR(area_of(other, 0, turned.normal), area_of(one, 0, plane.normal), 1e-5);
        }
    }
}

// Faces that bound no solid may be turned either way.
TEST(ModelSections, join_faces_however_they_are_turned) {
    const Handle one = plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), other = plane({1, 0, 0}, {0, 1, 0}, {1, 0, 1});
    std::vector<Face> faces;
    faces.push_back(around_domain(one, {1, 2, 3, 4}));
    faces.push_back(around_domain(other, {2, 5, 6, 7})); // along the common edge both run one way
    const Model model = model_of(given(faces));
    const std::vector<Plane> planes{{{0, 1, 0}, 0.25}};
    const Section section = section_of(model.get(), planes, 1e-9);
    ASSERT_EQ(section.ways.size(), 1U);
    EXPECT_EQ(section.ways[0].branches.size(), 2U);
    EXPECT_FALSE(section.ways[0].closed);
    EXPECT_TRUE(section.found.complete);
    EXPECT_EQ(section.found.count(NURBS_NODE_BORDER), 2);
    EXPECT_NEAR(length_of(section, section.ways[0]), 1 + std::sqrt(2), 1e-9);
}

// An edge of three faces is where ways end; without a common edge nothing is joined, however near.
TEST(ModelSections, join_over_edges_of_two_faces_alone) {
    const Handle one = plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), other = plane({1, 0, 0}, {1, 0, 1}, {0, 1, 0}),
                 third = plane({1, 0, 0}, {1, 0, -1}, {0, 1, 0});
    const std::vector<Plane> planes{{{0, 1, 0}, 0.25}};
    for (const bool shared : {false, true}) {
        std::vector<Face> faces;
        faces.push_back(around_domain(one, {1, 2, 3, 4}));
        faces.push_back(around_domain(other, {11, 12, 13, shared ? -2 : -14}));
        if (shared) {
            faces.push_back(around_domain(third, {21, 22, 23, -2}));
        }
        const Model model = model_of(given(faces));
        const Section section = section_of(model.get(), planes, 1e-9);
        EXPECT_EQ(section.ways.size(), faces.size());
        EXPECT_EQ(section.open(), std::ssize(section.ways));
        EXPECT_TRUE(section.found.complete);
    }
}

// With less work less is told, and nothing closed that is not.
TEST(ModelSections, with_small_budgets_claim_nothing_false) {
    for (const Solid &solid : files()) {
        SCOPED_TRACE(solid.name);
        const std::vector<Plane> planes{{{0.6, 0, 0.8}, 0.3 * solid.size}, {{0, 0.6, 0.8}, 0.4 * solid.size}};
        const Section whole = section_of(solid.model.get(), planes, 1e-6);
        ASSERT_TRUE(whole.found.complete);
        nurbs_call_options call;
        require_ok(nurbs_call_options_init(&call, sizeof call));
        for (call.work = 1; call.work < 100000000; call.work *= 4) {
            const Section part = section_of(solid.model.get(), planes, 1e-6, &call);
            if (part.found.complete && part.open() == 0) {
                double room = 1e-3;
                for (const Branch &branch : part.found.branches) {
                    room += 50 * branch.deviation;
                }
                for (const int64_t level : {0, 1}) {
                    const Point3 &normal = planes[static_cast<size_t>(level)].normal;
                    EXPECT_NEAR(area_of(part, level, normal), area_of(whole, level, normal), room);
                }
            }
            EXPECT_TRUE(call.work > 1 || !part.found.complete);
        }
    }
}

// Whatever the unit of length, and the lengths of normals.
TEST(ModelSections, do_not_depend_on_units) {
    for (const double scale : {1e-150, 1e-6, 1.0, 1e6, 1e150}) {
        const Handle ball = made([&](nurbs **out) {
            return nurbs_surface_sphere(nullptr, nullptr, nullptr, scale, NURBS_ARC_QUARTERS, out);
        });
        nurbs_face *made_face = nullptr;
        require_ok(nurbs_face_create(ball.get(), 0, nullptr, nullptr, nullptr, nullptr, 1e-9 * scale, 0,
                                     nullptr, &made_face));
        const Face face(made_face);
        const Model model = model_of({made_face});
        for (const double length : {1e-100, 1.0, 1e100}) {
            const double normal[] = {0.6 * length, 0, 0.8 * length}, offset = 0.5 * scale * length;
            nurbs_meet *meet = nullptr;
            require_ok(nurbs_model_sections(model.get(), 1, normal, &offset, 1e-6 * scale, &meet));
            const Section section = section_in(MeetHandle(meet).get());
            ASSERT_EQ(section.ways.size(), 1U) << scale << ' ' << length;
            ASSERT_TRUE(section.ways[0].closed && section.found.complete) << scale << ' ' << length;
        }
    }
}

// Sections of real solids close, and enclose what nurbs_model_classify() has inside.
TEST(ModelSections, of_real_files_close) {
    const char *const folder = std::getenv("NURBS_TEST_DATA");
    if (folder == nullptr) {
        GTEST_SKIP() << "NURBS_TEST_DATA is not set";
    }
    int64_t inside = 0;
    for (const char *name : {"boxed_sphere.step", "countersunk_screw.step", "satellite_mainbody.stp"}) {
        SCOPED_TRACE(name);
        nurbs_model *read = nullptr;
        require_ok(nurbs_read_model_file((std::filesystem::path(folder) / name).c_str(), nullptr, &read));
        const Model model(read);
        Point3 lower{HUGE_VAL, HUGE_VAL, HUGE_VAL}, upper{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
        for (int64_t i = 0; i < counts_of(read).faces; ++i) {
            Point3 low{}, high{};
            require_ok(nurbs_face_box(face_of(read, i).get(), 0.01, low.data(), high.data(), nullptr));
            for (size_t k = 0; k < 3; ++k) {
                lower[k] = std::min(lower[k], low[k]);
                upper[k] = std::max(upper[k], high[k]);
            }
        }
        const double size = surface_sections::distance(lower, upper), tolerance = 1e-6 * size;
        int64_t ways = 0, compared = 0;
        for_each_case(3740000, 6, [&](Random &random, uint64_t seed) {
            std::vector<Plane> planes;
            for (int i = 0; i < 6; ++i) {
                Point3 normal = random_direction(random);
                if (i < 3) {
                    normal = {0, 0, 0};
                    normal[static_cast<size_t>(i)] = 1;
                }
                Point3 through{};
                for (size_t k = 0; k < 3; ++k) {
                    through[k] = random.between(lower[k], upper[k]);
                }
                planes.push_back({normal, dot(normal, through)});
            }
            const Section section = section_of(read, planes, tolerance);
            ASSERT_TRUE(section.found.complete) << seed;
            ASSERT_EQ(section.open(), 0) << seed;
            ways += std::ssize(section.ways);
            for (int i = 0; i < 30; ++i) {
                const auto level = random.whole(0, 5);
                const Plane &plane = planes[static_cast<size_t>(level)];
                Point3 x{};
                for (size_t k = 0; k < 3; ++k) {
                    x[k] = random.between(lower[k], upper[k]);
                }
                const double off = dot_of(plane, x);
                for (size_t k = 0; k < 3; ++k) {
                    x[k] -= off * plane.normal[k];
                }
                const Winding winding = winding_of(section, level, plane.normal, x);
                int32_t side = NURBS_SIDE_UNDECIDED;
                require_ok(nurbs_model_classify(read, 1, x.data(), 0, 0, 0, &side));
                if (winding.nearest > 0.01 * size && side != NURBS_SIDE_UNDECIDED) {
                    ASSERT_NEAR(winding.turns, side == NURBS_SIDE_INSIDE ? 1 : 0, 1e-6) << seed;
                    ++compared;
                    inside += side == NURBS_SIDE_INSIDE ? 1 : 0;
                }
            }
        });
        EXPECT_GE(ways, of_whole_run(40));
        EXPECT_GE(compared, of_whole_run(80));
    }
    EXPECT_GE(inside, of_whole_run(40));
}

} // namespace model_sections_test
