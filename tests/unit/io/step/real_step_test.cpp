// Real STEP files: what is in them must match the table that comes with them, and every face contains its edges.
#include "closest/closest.h"
#include "io/step/boundary.h"
#include "io/step/structure/exchange.h"
#include "model/shapes/curve_spline.h"
#include "support/step_reading.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

namespace real_step_test {

namespace {

using namespace step_test;

const char *folder() {
    return std::getenv("NURBS_TEST_DATA");
}

std::string bytes_of(const std::string &name) {
    std::ifstream file(std::filesystem::path(folder()) / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

struct Content {
    std::map<std::string, int> curves; // by degree, with r if rational
    std::map<std::string, int> surfaces;
    double metres = 0;
    bool operator==(const Content &) const = default;
};

Content content_of(const nrb::model::Model &document) {
    Content content;
    content.metres = document.metres_per_unit;
    for (const nrb::model::NamedSpline &named : document.splines) {
        const nrb::Spline &spline = *named.spline;
        const std::string mark = spline.rational() ? "r" : "";
        if (spline.axes() == 1) {
            ++content.curves[std::to_string(spline.axis(0).degree()) + mark];
        } else {
            ++content.surfaces[std::to_string(spline.axis(0).degree()) + "x" +
                               std::to_string(spline.axis(1).degree()) + mark];
        }
    }
    return content;
}

// The B-splines of the table of the folder, and the lines, conics and elementary surfaces that the files name besides.
const std::map<std::string, Content> &expected_contents() {
    static const std::map<std::string, Content> table = {
        {"boxed_sphere.step",
         {{{"1", 240}, {"2r", 146}, {"3r", 96}},
          {{"1x1", 30}, {"2x1r", 120}, {"2x2r", 10}, {"2x3r", 12}, {"3x2r", 12}, {"3x3", 8}},
          0.01}},
        {"countersunk_screw.step",
         {{{"1", 23}, {"13", 2}, {"2r", 16}, {"4", 1}, {"5", 2}, {"6", 9}, {"7", 3}, {"8", 16}},
          {{"1x1", 8}, {"13x1", 3}, {"2x1r", 12}, {"2x2r", 2}, {"6x1", 3}},
          0.001}},
        {"nacelle.stp", {{{"5", 14}}, {{"5x5", 6}}, 0.001}},
        {"satellite_mainbody.stp",
         {{{"1", 16}, {"2r", 17}, {"5", 25}, {"6", 4}},
          {{"1x1", 9}, {"2x1r", 16}, {"5x5", 2}, {"5x6", 4}},
          0.0254}},
        {"stellarator_magnets.step", {{{"1", 16}, {"3", 16}}, {{"3x1", 16}}, 0.001}},
    };
    return table;
}

std::string describe(const Content &content) {
    std::string text;
    for (const auto *counts : {&content.curves, &content.surfaces}) {
        for (const auto &[degree, count] : *counts) {
            text += degree + " (" + std::to_string(count) + ") ";
        }
    }
    return text + std::to_string(content.metres);
}

TEST(RealStep, contents_match_the_table) {
    if (folder() == nullptr) {
        GTEST_SKIP() << "NURBS_TEST_DATA is not set: no real files to read";
    }
    for (const auto &[name, expected] : expected_contents()) {
        SCOPED_TRACE(name);
        const nrb::model::Model document = read(bytes_of(name));
        for (const nrb::model::Note &note : document.notes) {
            ADD_FAILURE() << note.text;
        }
        const Content found = content_of(document);
        EXPECT_TRUE(found == expected)
            << "found    " << describe(found) << "\nexpected " << describe(expected);
    }
}

// How far the ends of a curve and a few places between them are from a surface.
double distance(const nrb::Spline &surface, const nrb::Spline &curve) {
    const nrb::Interval domain = curve.axis(0).domain();
    std::vector<double> points;
    for (int i = 0; i <= 4; ++i) {
        const nrb::Vector3 p =
            point_of(curve, i == 4 ? domain.upper : domain.lower + (domain.upper - domain.lower) * i / 4);
        points.insert(points.end(), {p.x, p.y, p.z});
    }
    std::vector<double> distances(5);
    const nrb::closest::Query query{nullptr, nullptr, 1e-9, nrb::closest::usual_budget(surface)};
    nrb::closest::closest_points(surface, {points.data(), 5, 3, 3, 1}, query,
                                 {{}, {}, {distances.data(), 5, 1, 1, 1}, nullptr});
    return *std::ranges::max_element(distances);
}

// Each edge is on the surfaces of both its faces, to the uncertainty that the file states (look at the exceptions):
// planes, cylinders and the like are cut wide enough, and placed right.
TEST(RealStep, surfaces_contain_the_edges_of_their_faces) {
    if (folder() == nullptr) {
        GTEST_SKIP() << "NURBS_TEST_DATA is not set: no real files to read";
    }
    const std::map<std::string, double> tolerances = {{"boxed_sphere.step", 0.01},
                                                      {"countersunk_screw.step", 2e-5},
                                                      {"nacelle.stp", 1e-2},
                                                      {"satellite_mainbody.stp", 0.000196850393701},
                                                      {"stellarator_magnets.step", 1e-5}};
    for (const auto &[name, tolerance] : tolerances) {
        SCOPED_TRACE(name);
        const std::string bytes = bytes_of(name);
        const nrb::model::Model document = read(bytes);
        const nrb::io::step::Exchange file = nrb::io::step::read_exchange(bytes);
        const auto &instances = file.instances;
        size_t next_face = 0, next_edge = 0;
        std::vector<std::pair<int64_t, nrb::SplinePtr>> faces;
        std::map<int64_t, nrb::SplinePtr> curves;
        for (const auto &instance : instances.all()) {
            if (instance.kind() == nrb::io::step::Kind::face) {
                faces.emplace_back(instance.number(), document.splines.at(next_face++).spline);
            }
        }
        for (const auto &instance : instances.all()) {
            if (instance.kind() == nrb::io::step::Kind::edge_curve) {
                curves[instance.number()] = document.splines.at(next_face + next_edge++).spline;
            }
        }
        double worst = 0;
        for (const auto &face : faces) {
            std::vector<int64_t> waiting = {face.first};
            while (!waiting.empty()) {
                const auto &instance = instances[instances.find(waiting.back())];
                waiting.pop_back();
                nrb::io::step::for_each_reference(bytes, instance, [&](int64_t named) {
                    const auto kind = instances[instances.find(named)].kind();
                    if (kind == nrb::io::step::Kind::edge_curve) {
                        worst = std::max(worst, distance(*face.second, *curves.at(named)));
                    } else if (kind > nrb::io::step::Kind::edge_curve && kind < nrb::io::step::Kind::face) {
                        waiting.push_back(named);
                    }
                });
            }
        }
        EXPECT_LE(worst, tolerance);
    }
}

} // namespace

} // namespace real_step_test
