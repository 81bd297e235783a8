// The CAD file of the examples: what is in it, and that its shapes are the ones they claim to be.
#include "eval/evaluate.h"
#include "support/iges_reading.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

namespace models_file_test {

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

const nrb::model::Model &models() {
    static const nrb::model::Model document = [] {
        const auto folder = std::filesystem::path(NURBS_SOURCE_DIR) / "capi/examples/models";
        std::ifstream file(folder / "models.igs", std::ios::binary);
        return iges_test::read(
            std::string(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()));
    }();
    return document;
}

const nrb::Spline &model(const std::string &name) {
    for (const nrb::model::NamedSpline &named : models().splines) {
        if (named.name == name) {
            return *named.spline;
        }
    }
    throw std::runtime_error("no model " + name);
}

std::vector<double> evaluate(const nrb::Spline &spline, const std::vector<double> &params) {
    const auto axes = static_cast<int64_t>(spline.axes());
    const auto count = static_cast<int64_t>(params.size()) / axes;
    std::vector<double> points(static_cast<size_t>(count * spline.dim()));
    nrb::eval::evaluate_points(spline, {}, 0, {params.data(), count, axes, axes, 1},
                               {points.data(), count, spline.dim(), spline.dim(), 1});
    return points;
}

// A grid of parameters over the whole domain, ends included, that meets no symmetry of the knots.
std::vector<double> sample(const nrb::Spline &spline, int per_axis) {
    std::vector<double> params;
    const int rows = spline.axes() == 2 ? per_axis : 1;
    for (int i = 0; i < rows; ++i) {
        for (int j = 0; j < per_axis; ++j) {
            const int steps[] = {spline.axes() == 2 ? i : j, j};
            for (int k = 0; k < spline.axes(); ++k) {
                const auto [lower, upper] = spline.axis(k).domain();
                params.push_back(lower + (upper - lower) * steps[k] / (per_axis - 1));
            }
        }
    }
    return params;
}

struct Expected {
    const char *name;
    int degree_u;
    int degree_v; // -1: a curve
    int64_t count_u;
    int64_t count_v;
    bool rational;
};

TEST(ModelsFile, holds_what_it_should) {
    const Expected others[] = {
        {"hull", 3, 3, 8, 7, false},           {"circle", 2, -1, 9, 0, true},
        {"conic arc", 2, -1, 3, 0, true},      {"torus", 2, 2, 9, 9, true},
        {"cylinder", 2, 1, 9, 2, true},        {"planar cubic", 3, -1, 7, 0, false},
        {"space quintic", 5, -1, 7, 0, false}, {"closed loop", 3, -1, 8, 0, false},
        {"polyline", 1, -1, 5, 0, false},      {"transformed curve", 3, -1, 4, 0, false},
    };
    std::vector<Expected> expected;
    std::vector<std::string> patches;
    for (int i = 1; i <= 28; ++i) {
        patches.push_back("teapot " + std::to_string(i));
    }
    for (const std::string &name : patches) {
        expected.push_back({name.c_str(), 3, 3, 4, 4, false});
    }
    expected.insert(expected.end(), std::begin(others), std::end(others));
    ASSERT_EQ(models().splines.size(), expected.size());
    for (size_t i = 0; i < expected.size(); ++i) {
        const nrb::Spline &spline = *models().splines[i].spline;
        EXPECT_EQ(models().splines[i].name, expected[i].name);
        EXPECT_EQ(spline.dim(), 3) << expected[i].name;
        ASSERT_EQ(spline.axes(), expected[i].degree_v < 0 ? 1 : 2) << expected[i].name;
        EXPECT_EQ(spline.axis(0).degree(), expected[i].degree_u) << expected[i].name;
        EXPECT_EQ(spline.count(0), expected[i].count_u) << expected[i].name;
        EXPECT_EQ(spline.rational(), expected[i].rational) << expected[i].name;
        if (spline.axes() == 2) {
            EXPECT_EQ(spline.axis(1).degree(), expected[i].degree_v) << expected[i].name;
            EXPECT_EQ(spline.count(1), expected[i].count_v) << expected[i].name;
        }
    }
}

// The names and the matrix have all gone into splines.
TEST(ModelsFile, leaves_nothing_to_note) {
    EXPECT_TRUE(models().notes.empty());
}

TEST(ModelsFile, is_in_millimetres) {
    EXPECT_EQ(models().metres_per_unit, 0.001);
}

TEST(ModelsFile, only_the_loop_is_periodic) {
    for (const nrb::model::NamedSpline &named : models().splines) {
        for (int k = 0; k < named.spline->axes(); ++k) {
            EXPECT_EQ(named.spline->axis(k).periodic(), named.name == "closed loop") << named.name;
        }
    }
}

TEST(ModelsFile, the_circle_is_round) {
    const std::vector<double> points = evaluate(model("circle"), sample(model("circle"), 10007));
    for (size_t i = 0; i < points.size(); i += 3) {
        const long double radius =
            std::hypot(static_cast<long double>(points[i]), static_cast<long double>(points[i + 1]));
        ASSERT_LE(std::abs(static_cast<double>(radius - 80)), 4 * eps * 80) << "point " << i / 3;
        ASSERT_LE(std::abs(points[i + 2] + 10), 4 * eps * 80);
    }
}

// The bound is c(2) + c(2) times eps times the largest coordinate, 220.
TEST(ModelsFile, the_torus_is_a_torus) {
    const std::vector<double> points = evaluate(model("torus"), sample(model("torus"), 211));
    for (size_t i = 0; i < points.size(); i += 3) {
        const long double around =
            std::hypot(static_cast<long double>(points[i]), static_cast<long double>(points[i + 1]));
        const long double tube = std::hypot(around - 60, static_cast<long double>(points[i + 2]) + 200);
        ASSERT_LE(std::abs(static_cast<double>(tube - 20)), 8 * eps * 220) << "point " << i / 3;
    }
}

TEST(ModelsFile, the_cylinder_is_round_and_straight) {
    const std::vector<double> points = evaluate(model("cylinder"), sample(model("cylinder"), 101));
    for (size_t i = 0; i < points.size(); i += 3) {
        const long double radius =
            std::hypot(static_cast<long double>(points[i]), static_cast<long double>(points[i + 1]));
        ASSERT_LE(std::abs(static_cast<double>(radius - 30)), 7 * eps * 350);
        ASSERT_GE(points[i + 2], -350.0 - 7 * eps * 350);
        ASSERT_LE(points[i + 2], -270.0 + 7 * eps * 350);
    }
}

// With barycentric coordinates (a, b, c) in the control triangle and middle weight w: b^2 = 4 w^2 a c.
TEST(ModelsFile, the_conic_arc_satisfies_its_equation) {
    const std::vector<double> points = evaluate(model("conic arc"), sample(model("conic arc"), 1001));
    for (size_t i = 0; i < points.size(); i += 3) {
        const double b = (points[i + 1] + 40) / 100;
        const double c_minus_a = (points[i] - 200) / 50;
        const double a = (1 - b - c_minus_a) / 2;
        const double c = (1 - b + c_minus_a) / 2;
        ASSERT_NEAR(b * b, 16 * a * c, 1e-14) << "point " << i / 3;
    }
}

TEST(ModelsFile, the_hull_has_a_chine) {
    const nrb::Spline &hull = model("hull");
    EXPECT_EQ(nrb::multiplicity(hull.axis(1).knots(), 0.45), 3);
    const std::vector<double> points = iges_test::points_of(hull);
    for (size_t station = 0; station + 1 < 8; ++station) {
        const double *below = points.data() + 3 * (7 * station + 2);
        const double *chine = below + 3;
        const double *above = chine + 3;
        const double cross =
            (chine[1] - below[1]) * (above[2] - chine[2]) - (chine[2] - below[2]) * (above[1] - chine[1]);
        EXPECT_GT(std::abs(cross), 1.0) << "station " << station;
    }
}

TEST(ModelsFile, the_transform_is_applied) {
    EXPECT_EQ(iges_test::points_of(model("transformed curve")),
              (std::vector<double>{-200, 0, 50, -240, 20, 50, -240, 60, 50, -200, 80, 50}));
}

// Neighbouring patches of the teapot's body share their edges: the last row of patch 1 around is the first of
// patch 2.
TEST(ModelsFile, the_teapot_closes) {
    for (int ring = 0; ring < 2; ++ring) {
        for (int quarter = 0; quarter < 4; ++quarter) {
            const auto name = [&](int q) { return "teapot " + std::to_string(4 * ring + q % 4 + 1); };
            const std::vector<double> a = iges_test::points_of(model(name(quarter)));
            const std::vector<double> b = iges_test::points_of(model(name(quarter + 1)));
            for (size_t i = 0; i < 4; ++i) {
                for (size_t c = 0; c < 3; ++c) {
                    EXPECT_EQ(a[3 * (4 * i + 3) + c], b[3 * 4 * i + c]) << name(quarter) << " row " << i;
                }
            }
        }
    }
}

} // namespace

} // namespace models_file_test
