// Sides of the solids of files, against their closed forms; of real files, against the numbers of faces that rays pass.
#include "property/models.h"
#include "support/cases.h"
#include "support/step_solids.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <gtest/gtest.h>

namespace solid_sides_test {

using namespace support;
using namespace support::models;
using namespace step_test;

namespace {

using Vec = std::vector<double>;
using Point = std::array<double, 3>;

struct Solid {
    const char *name;
    std::string text;
    std::function<double(const Point &)> depth; // > 0 inside
};

double in_cube(const Point &x, double low, double high) {
    double depth = HUGE_VAL;
    for (const double c : x) {
        depth = std::min({depth, c - low, high - c});
    }
    return depth;
}

std::vector<Solid> solids() {
    const auto ball = [](const Point &x) { return 3 - std::hypot(x[0], x[1], x[2]); };
    const auto cylinder = [](const Point &x) {
        return std::min({2 - std::hypot(x[0], x[1]), x[2], 5 - x[2]});
    };
    const auto cone = [](const Point &x) { return std::min(x[2], 3 - 0.75 * x[2] - std::hypot(x[0], x[1])); };
    return {{"cube", step_cube(), [](const Point &x) { return in_cube(x, 0, 2); }},
            {"cube with voids", step_hollow_cube(),
             [](const Point &x) {
                 return std::min({in_cube(x, 0, 4), -in_cube(x, 1, 2), -in_cube(x, 2.5, 3)});
             }},
            {"cylinder", step_cylinder(false), cylinder},
            {"cylinder with a seam curve", step_cylinder(true), cylinder},
            {"cone", step_cone(), cone},
            {"cone beyond its apex", step_cone(true), cone},
            {"sphere in a vertex loop", step_sphere(true), ball},
            {"sphere with its seam", step_sphere(false), ball},
            {"half a torus", step_half_torus(), [](const Point &x) {
                 return std::min(x[2], 2 - std::hypot(std::hypot(x[0], x[1]) - 5, x[2]));
             }}};
}

std::vector<int32_t> sides_of(const nurbs_model *model, const Vec &points, double tolerance) {
    std::vector<int32_t> sides(points.size() / 3);
    require_ok(nurbs_model_classify(model, std::ssize(sides), points.data(), 0, 0, tolerance, sides.data()));
    return sides;
}

struct Hits {
    int64_t count = 0;
    int32_t complete = 0;
};
Hits hits_of(const nurbs_model *model, const double *from, const Point &along) {
    Hits hits;
    require_ok(nurbs_model_ray_hits(model, from, along.data(), nullptr, 0, nullptr, nullptr, nullptr, nullptr,
                                    &hits.count, &hits.complete));
    return hits;
}

Point direction(Random &random) {
    return {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
}

} // namespace

TEST(SolidSides, are_those_of_the_closed_forms) {
    for (const Solid &solid : solids()) {
        SCOPED_TRACE(solid.name);
        const Model model = read_model(solid.text);
        int64_t undecided = 0, inside = 0, count = 0;
        for_each_case(2980000, 20, [&](Random &random, uint64_t) {
            Vec points;
            for (int i = 0; i < 60; ++i) { // some on lines that meet edges and poles
                points.push_back(random.chance(10) ? random.whole(-2, 6) : random.between(-7.5, 7.5));
            }
            const std::vector<int32_t> sides = sides_of(model.get(), points, 0);
            for (size_t i = 0; i < sides.size(); ++i) {
                const double depth = solid.depth({points[3 * i], points[3 * i + 1], points[3 * i + 2]});
                ++count;
                undecided += sides[i] == NURBS_SIDE_UNDECIDED && std::abs(depth) > 1e-6 ? 1 : 0;
                inside += sides[i] == NURBS_SIDE_INSIDE ? 1 : 0;
                ASSERT_TRUE(sides[i] != NURBS_SIDE_INSIDE || depth > -1e-6) << depth;
                ASSERT_TRUE(sides[i] != NURBS_SIDE_OUTSIDE || depth < 1e-6) << depth;
                ASSERT_NE(sides[i], NURBS_SIDE_ON);
            }
        });
        EXPECT_EQ(undecided, 0);
        EXPECT_GE(inside, of_whole_run(1));
    }
}

// Whatever the direction, a complete ray from a point inside meets an odd number of faces.
TEST(SolidSides, of_real_files_agree_with_all_rays) {
    const char *const folder = std::getenv("NURBS_TEST_DATA");
    if (folder == nullptr) {
        GTEST_SKIP() << "NURBS_TEST_DATA is not set";
    }
    for (const char *name : {"boxed_sphere.step", "countersunk_screw.step", "satellite_mainbody.stp"}) {
        SCOPED_TRACE(name);
        nurbs_model *made = nullptr;
        require_ok(nurbs_read_model_file((std::filesystem::path(folder) / name).c_str(), nullptr, &made));
        const Model model(made);
        double lower[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, upper[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
        for (int64_t i = 0; i < counts_of(made).faces; ++i) {
            double low[3], high[3];
            require_ok(nurbs_face_box(face_of(made, i).get(), 0.01, low, high, nullptr));
            for (int k = 0; k < 3; ++k) {
                lower[k] = std::min(lower[k], low[k]);
                upper[k] = std::max(upper[k], high[k]);
            }
        }
        int64_t undecided = 0, complete = 0, count = 0;
        for_each_case(2990000, 10, [&](Random &random, uint64_t seed) {
            Vec points;
            for (int i = 0; i < 60; ++i) {
                points.push_back(random.between(lower[i % 3], upper[i % 3]));
            }
            const std::vector<int32_t> sides = sides_of(made, points, 0);
            for (size_t i = 0; i < sides.size(); ++i) {
                ++count;
                const Hits hits = hits_of(made, points.data() + 3 * i, direction(random));
                undecided += sides[i] == NURBS_SIDE_UNDECIDED ? 1 : 0;
                if (sides[i] != NURBS_SIDE_UNDECIDED && hits.complete == 1) {
                    ++complete;
                    ASSERT_EQ(hits.count % 2, sides[i] == NURBS_SIDE_INSIDE ? 1 : 0) << seed;
                }
            }
        });
        EXPECT_LE(undecided, count / 10); // boxed_sphere.step has a tolerance of half a face
        EXPECT_GE(complete, of_whole_run(count / 4));
    }
}

} // namespace solid_sides_test
