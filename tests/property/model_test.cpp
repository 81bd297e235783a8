// Models of faces: edges with a common key are one, ends that are equal are one vertex, and nothing else changes.
#include "property/solids.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace model_test {

using namespace support;
using namespace support::solids;
using std::numbers::pi;

namespace {

constexpr double full_turn = 2 * pi;

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
