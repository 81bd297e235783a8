// Points and weights on faces: where they are, what they are exact for, and what they converge to.
#include "property/faces.h"
#include "property/models.h"
#include "support/step_solids.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>

namespace face_quadrature_test {

using namespace support;
using namespace support::faces;

namespace {

struct Rule {
    Vec params, weights, measures;
};

Rule rule_of(const nurbs_face *face, int32_t nodes) {
    int64_t count = -1;
    require_ok(nurbs_face_quadrature(face, nodes, 0, nullptr, nullptr, nullptr, &count));
    const auto n = static_cast<size_t>(count);
    Rule rule{Vec(2 * n), Vec(n), Vec(n)};
    require_ok(nurbs_face_quadrature(face, nodes, count, rule.params.data(), rule.weights.data(),
                                     rule.measures.data(), nullptr));
    return rule;
}

double sum_of(const Vec &values) {
    double sum = 0;
    for (const double x : values) {
        sum += x;
    }
    return sum;
}

// The flux of x through a face, three times what it adds to a volume.
double flux(const nurbs_face *face, int32_t nodes) {
    nurbs *made = nullptr;
    require_ok(nurbs_face_surface(face, &made));
    const Handle surface(made);
    const Rule rule = rule_of(face, nodes);
    const Vec jets = eval_derivs(made, 1, rule.params);
    double sum = 0;
    for (size_t i = 0; i < rule.weights.size(); ++i) {
        const double *x = jets.data() + 9 * i, *u = x + 3, *v = x + 6;
        sum += rule.weights[i] * (x[0] * (u[1] * v[2] - u[2] * v[1]) + x[1] * (u[2] * v[0] - u[0] * v[2]) +
                                  x[2] * (u[0] * v[1] - u[1] * v[0]));
    }
    return sum;
}

double volume_by_flux(const nurbs_model *model, int32_t nodes) {
    double sum = 0;
    for (int64_t i = 0; i < models::counts_of(model).faces; ++i) {
        int32_t against = 0;
        nurbs_face *face = nullptr;
        require_ok(nurbs_model_face(model, i, nullptr, nullptr, &against, nullptr, &face));
        const Face kept(face);
        sum += (against != 0 ? -1 : 1) * flux(face, nodes) / 3;
    }
    return sum;
}

double volume_of(const nurbs_model *model, double *openness) {
    double volume = 0;
    require_ok(nurbs_model_volume(model, 1e-10, &volume, nullptr, nullptr, openness, nullptr));
    return volume;
}

} // namespace

TEST(FaceQuadrature, points_are_inside_and_weights_add_up) {
    for_each_case(4310000, 12, [](Random &random, uint64_t seed) {
        for (const Ground &ground : grounds(random)) {
            const Handle curve = create(any_star(random, ground));
            const Face face = face_of(ground.surface.get(), {{curve.get()}});
            const double area = area_of(face.get(), 1e-11);
            const Rule coarse = rule_of(face.get(), 3), fine = rule_of(face.get(), 24),
                       finest = rule_of(face.get(), 64);
            for (const int32_t side : sides(face.get(), coarse.params)) {
                ASSERT_EQ(side, 1) << seed;
            }
            ASSERT_GE(*std::ranges::min_element(fine.weights), 0) << seed;
            ASSERT_GE(*std::ranges::min_element(fine.measures), 0) << seed;
            // Slowly where a bound is nearly upright, but not at its end.
            ASSERT_NEAR(sum_of(fine.measures), area, 1e-3 * area) << seed;
            ASSERT_NEAR(sum_of(finest.measures), area, 1e-4 * area) << seed;
            ASSERT_NEAR(sum_of(coarse.measures), area, 0.1 * area) << seed;
        }
    });
}

// Polygons on a plane: with two nodes the rule is exact for polynomials of degree 2 in all, with four for degree 6.
TEST(FaceQuadrature, is_exact_between_straight_bounds) {
    Random random(8);
    const double origin[] = {1, 2, 0}, u[] = {4, 0, 0}, v[] = {0, 3, 0};
    const Handle ground = made([&](nurbs **out) { return nurbs_surface_plane(3, origin, u, v, out); });
    for (int trial = 0; trial < 30; ++trial) {
        std::vector<Handle> curves;
        std::vector<const nurbs *> loop;
        std::vector<Place> corners;
        const int n = random.whole(3, 9);
        for (int i = 0; i < n; ++i) {
            const double angle = 2 * pi * (i + random.between(0.1, 0.9)) / n, r = random.between(0.1, 0.45);
            corners.push_back({0.5 + r * std::cos(angle), 0.5 + r * std::sin(angle)});
        }
        for (size_t i = 0; i < corners.size(); ++i) {
            curves.push_back(segment(corners[i], corners[(i + 1) % corners.size()]));
            loop.push_back(curves.back().get());
        }
        const Face face = face_of(ground.get(), {loop});
        for (const int32_t nodes : {2, 4}) {
            const Rule rule = rule_of(face.get(), nodes), more = rule_of(face.get(), 9);
            for (int a = 0; a <= 2 * nodes - 2; ++a) {
                const int b = 2 * nodes - 2 - a;
                const auto integral = [&](const Rule &of) {
                    double sum = 0;
                    for (size_t i = 0; i < of.weights.size(); ++i) {
                        sum +=
                            of.weights[i] * std::pow(of.params[2 * i], a) * std::pow(of.params[2 * i + 1], b);
                    }
                    return sum;
                };
                ASSERT_NEAR(integral(rule), integral(more), 1e-14) << trial << ' ' << a << ' ' << b;
            }
            ASSERT_NEAR(sum_of(rule.measures), 12 * sum_of(rule.weights), 1e-13) << trial;
        }
    }
}

// Where bounds stand upright at their ends it converges as it does elsewhere.
TEST(FaceQuadrature, converges_fast_in_a_circle) {
    const double origin[] = {0, 0, 0}, u[] = {1, 0, 0}, v[] = {0, 1, 0}, centre[] = {0.5, 0.5};
    const Handle ground = made([&](nurbs **out) { return nurbs_surface_plane(3, origin, u, v, out); });
    const Handle circle = made([&](nurbs **out) {
        return nurbs_curve_circle(2, centre, nullptr, nullptr, 0.4, NURBS_ARC_QUARTERS, out);
    });
    const Face face = face_of(ground.get(), {{circle.get()}});
    EXPECT_NEAR(sum_of(rule_of(face.get(), 6).measures), 0.16 * pi, 1e-4);
    EXPECT_NEAR(sum_of(rule_of(face.get(), 12).measures), 0.16 * pi, 1e-8);
    EXPECT_NEAR(sum_of(rule_of(face.get(), 24).measures), 0.16 * pi, 1e-13);
}

// By the divergence theorem, with none of the code that nurbs_model_volume() sums by.
TEST(FaceQuadrature, volumes_of_solids_by_the_flux_through_their_faces) {
    for (const std::string &text :
         {step_test::step_cube(), step_test::step_hollow_cube(), step_test::step_cylinder(false),
          step_test::step_cone(), step_test::step_half_torus()}) {
        const models::Model model = models::read_model(text);
        const double volume = volume_of(model.get(), nullptr);
        EXPECT_NEAR(volume_by_flux(model.get(), 24), volume, 1e-9 * volume);
    }
    const char *const folder = std::getenv("NURBS_TEST_DATA");
    if (folder == nullptr) {
        GTEST_SKIP() << "NURBS_TEST_DATA is not set";
    }
    for (const char *name : {"boxed_sphere.step", "countersunk_screw.step", "satellite_mainbody.stp",
                             "stellarator_magnets.step"}) {
        nurbs_model *read = nullptr;
        require_ok(nurbs_read_model_file((std::filesystem::path(folder) / name).c_str(), nullptr, &read));
        const models::Model model(read);
        double openness = 0; // times how far the origin is from the middle
        const double volume = volume_of(read, &openness), reach = 10 * std::cbrt(volume);
        EXPECT_NEAR(volume_by_flux(read, 16), volume, 1e-6 * volume + openness * reach) << name;
    }
}

} // namespace face_quadrature_test
