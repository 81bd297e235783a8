// Models of faces: edges with a common key are one, ends that are equal are one vertex, and nothing else changes.
#include "property/models.h"
#include "support/generators.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace model_test {

using namespace support;
using std::numbers::pi;

namespace {

constexpr double full_turn = 2 * pi;

Handle segment(std::array<double, 2> from, std::array<double, 2> to) {
    return create({{1}, {2}, {{0, 0, 1, 1}}, 2, {from[0], from[1], to[0], to[1]}, {}});
}

// Around the domain: along u at the lower end of v, up, back, and down. Keys are negative against the loop.
Face around_domain(const Handle &surface, const std::array<int64_t, 4> &keys) {
    double u[2], v[2];
    require_ok(nurbs_domain(surface.get(), 0, u));
    require_ok(nurbs_domain(surface.get(), 1, v));
    const std::array<double, 2> corners[] = {{u[0], v[0]}, {u[1], v[0]}, {u[1], v[1]}, {u[0], v[1]}};
    std::vector<Handle> curves;
    std::vector<const nurbs *> given;
    for (size_t i = 0; i < 4; ++i) {
        curves.push_back(segment(corners[i], corners[(i + 1) % 4]));
        given.push_back(curves.back().get());
    }
    const int64_t four = 4;
    nurbs_face *face = nullptr;
    require_ok(nurbs_face_create(surface.get(), 1, &four, given.data(), nullptr, keys.data(), 1e-9, 0,
                                 nullptr, &face));
    return Face(face);
}

Handle plane(const std::array<double, 3> &origin, const std::array<double, 3> &u,
             const std::array<double, 3> &v) {
    return made([&](nurbs **out) { return nurbs_surface_plane(3, origin.data(), u.data(), v.data(), out); });
}

// The sides of a box of random size, somewhere. Keys are the same for edges that are one.
std::vector<Face> box(Random &random, std::array<double, 3> &size) {
    std::array<double, 3> origin{};
    for (size_t k = 0; k < 3; ++k) {
        origin[k] = std::ldexp(random.whole(-8, 8), -2); // so that sums are exact
        size[k] = std::ldexp(random.whole(1, 16), -2);
    }
    std::vector<Face> faces;
    for (size_t axis = 0; axis < 3; ++axis) {
        const size_t a = (axis + 1) % 3, b = (axis + 2) % 3;
        for (const int64_t side : {0, 1}) {
            std::array<double, 3> corner = origin, u{}, v{};
            corner[axis] += side == 0 ? 0 : size[axis];
            u[a] = size[a];
            v[b] = size[b];
            // The edge along an axis that lies at these ends of the two that follow.
            const auto key = [](size_t along, int64_t first, int64_t second) {
                return 1 + 4 * static_cast<int64_t>(along) + first + 2 * second;
            };
            faces.push_back(around_domain(
                plane(corner, u, v), {key(a, 0, side), key(b, side, 1), -key(a, 1, side), -key(b, side, 0)}));
        }
    }
    return faces;
}

std::vector<const nurbs_face *> given(const std::vector<Face> &faces) {
    std::vector<const nurbs_face *> all;
    for (const Face &face : faces) {
        all.push_back(face.get());
    }
    return all;
}

TEST(Models, the_faces_of_a_box_share_edges_and_vertices) {
    Random random(1);
    for (int trial = 0; trial < 20; ++trial) {
        std::array<double, 3> size{};
        const std::vector<Face> faces = box(random, size);
        const Model model = model_of(given(faces));
        EXPECT_EQ(counts_of(model.get()), (ModelCounts{1, 1, 6, 12, 8}));
        EXPECT_EQ(counts_of(model.get()).euler(), 2);
        EXPECT_EQ(uses_of(model.get()), (std::vector<int64_t>{0, 0, 12}));
        const double area = 2 * (size[0] * size[1] + size[1] * size[2] + size[2] * size[0]);
        EXPECT_NEAR(area_of(model.get(), 1e-12), area, 2e-12 * area);
    }
}

std::vector<double> numbers_of(const nurbs_face *face) {
    nurbs *made = nullptr;
    require_ok(nurbs_face_surface(face, &made));
    std::vector<double> numbers = homogeneous_points(Handle(made).get());
    int64_t loops = 0;
    require_ok(nurbs_face_loops(face, 0, nullptr, &loops));
    std::vector<int64_t> sizes(static_cast<size_t>(loops));
    require_ok(nurbs_face_loops(face, loops, sizes.data(), nullptr));
    for (int64_t loop = 0; loop < loops; ++loop) {
        for (int64_t i = 0; i < sizes[static_cast<size_t>(loop)]; ++i) {
            int64_t key = 0;
            nurbs *edge = nullptr;
            require_ok(nurbs_face_curve(face, loop, i, &made));
            require_ok(nurbs_face_edge(face, loop, i, &key, &edge));
            for (const Handle &curve : {Handle(made), Handle(edge)}) {
                const std::vector<double> points = homogeneous_points(curve.get());
                numbers.insert(numbers.end(), points.begin(), points.end());
            }
            numbers.push_back(static_cast<double>(key));
        }
    }
    return numbers;
}

TEST(Models, faces_are_given_back_bit_for_bit) {
    Random random(2);
    std::array<double, 3> size{};
    const std::vector<Face> faces = box(random, size);
    const Model model = model_of(given(faces));
    for (size_t i = 0; i < faces.size(); ++i) {
        EXPECT_TRUE(same_bits(numbers_of(faces[i].get()),
                              numbers_of(face_of(model.get(), static_cast<int64_t>(i)).get())));
    }
}

// The first point of the curve of an edge is its first vertex, the last point its second one.
TEST(Models, edges_run_between_their_vertices) {
    Random random(3);
    std::array<double, 3> size{};
    const Model model = model_of(given(box(random, size)));
    for (int64_t i = 0; i < counts_of(model.get()).edges; ++i) {
        int64_t ends[2] = {-1, -1};
        nurbs *made = nullptr;
        require_ok(nurbs_model_edge(model.get(), i, nullptr, ends, nullptr, &made));
        const Handle edge(made);
        double domain[2];
        require_ok(nurbs_domain(made, 0, domain));
        std::vector<double> vertices(6);
        require_ok(nurbs_model_vertex(model.get(), ends[0], vertices.data()));
        require_ok(nurbs_model_vertex(model.get(), ends[1], vertices.data() + 3));
        EXPECT_EQ(eval(made, {domain[0], domain[1]}), vertices);
    }
}

// The bottom is the edge 1, the seam 3: it is used twice by one face.
TEST(Models, a_cylinder_meets_itself_at_its_seam) {
    const Handle side = made([](nurbs **out) {
        return nurbs_surface_cylinder(nullptr, nullptr, nullptr, 2, 5, 0, full_turn, 0, out);
    });
    const Face face = around_domain(side, {1, 3, 2, -3});
    const Model model = model_of({face.get()});
    EXPECT_EQ(counts_of(model.get()), (ModelCounts{1, 1, 1, 3, 2}));
    EXPECT_EQ(uses_of(model.get()), (std::vector<int64_t>{0, 2, 1}));
    EXPECT_NEAR(area_of(model.get(), 1e-12), 20 * pi, 2e-12 * 20 * pi);
    EXPECT_EQ(counts_of(model.get()).euler(), 0); // a tube
}

// Without loops it has no edges at all.
TEST(Models, a_sphere_needs_no_edges) {
    const Handle ball =
        made([](nurbs **out) { return nurbs_surface_sphere(nullptr, nullptr, nullptr, 3, 0, out); });
    nurbs_face *whole = nullptr;
    require_ok(
        nurbs_face_create(ball.get(), 0, nullptr, nullptr, nullptr, nullptr, 1e-9, 0, nullptr, &whole));
    const Face face(whole);
    const Model model = model_of({whole, whole});
    const ModelCounts n = counts_of(model.get());
    EXPECT_EQ(n.faces, 2);
    EXPECT_NEAR(area_of(model.get(), 1e-12), 72 * pi, 2e-12 * 72 * pi);
}

} // namespace

} // namespace model_test
