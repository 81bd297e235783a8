// Real files from CAD programs: what is in them must match the table that comes with them. Their folder is
// named by the environment variable NURBS_TEST_DATA.
#include "support/iges_reading.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <utility>

namespace real_files_test {

namespace {

using Degrees = std::map<std::pair<int, int>, int>; // (degree, degree of the second axis or 0): how many
struct Content {
    int curves = 0;
    int plane_curves = 0;
    int surfaces = 0;
    int rational = 0;
    Degrees curve_degrees;
    Degrees surface_degrees;

    bool operator==(const Content &) const = default;
};

// The B-splines of the README of the folder, and lines, arcs, composite curves and surfaces of revolution besides. Curves
// of the plane count in curve_degrees with the others.
const std::map<std::string, Content> &expected_contents() {
    static const std::map<std::string, Content> table = {
        {"dtmb5415_bow.iges",
         {8, 0, 1, 0, {{{1, 0}, 1}, {{2, 0}, 2}, {{3, 0}, 3}, {{5, 0}, 1}, {{8, 0}, 1}}, {{{3, 3}, 1}}}},
        {"goteborg_hull.iges",
         {22,
          0,
          3,
          0,
          {{{1, 0}, 10}, {{3, 0}, 8}, {{5, 0}, 2}, {{8, 0}, 1}, {{11, 0}, 1}},
          {{{3, 3}, 2}, {{3, 5}, 1}}}},
        {"iea15mw_blade.igs",
         {32, 8, 3, 0, {{{1, 0}, 8}, {{3, 0}, 9}, {{8, 0}, 23}}, {{{3, 3}, 1}, {{3, 8}, 2}}}},
        {"pipe_hollow_deformed.iges", {8, 0, 6, 8, {{{2, 0}, 4}, {{11, 0}, 4}}, {{{1, 1}, 2}, {{2, 1}, 4}}}},
        {"propeller_blade_upper.iges", {5, 1, 1, 0, {{{1, 0}, 1}, {{2, 0}, 2}, {{3, 0}, 3}}, {{{3, 2}, 1}}}},
        {"propeller_shaft.iges",
         {28,
          23,
          7,
          25,
          {{{1, 0}, 9}, {{2, 0}, 21}, {{3, 0}, 4}, {{5, 0}, 7}, {{6, 0}, 7}, {{10, 0}, 3}},
          {{{1, 1}, 1}, {{1, 2}, 2}, {{2, 1}, 1}, {{2, 2}, 2}, {{2, 3}, 1}}}},
        {"wigley_hull.iges", {8, 0, 1, 0, {{{1, 0}, 4}, {{3, 0}, 2}, {{4, 0}, 2}}, {{{3, 4}, 1}}}},
        {"wing.iges", {16, 16, 4, 0, {{{1, 0}, 4}, {{2, 0}, 10}, {{3, 0}, 18}}, {{{1, 1}, 2}, {{3, 1}, 2}}}},
    };
    return table;
}

Content content_of(const nrb::model::Model &document) {
    Content content;
    for (const nrb::model::NamedSpline &named : document.splines) {
        const nrb::Spline &spline = *named.spline;
        content.rational += spline.rational() ? 1 : 0;
        if (spline.axes() == 2) {
            ++content.surfaces;
            ++content.surface_degrees[{spline.axis(0).degree(), spline.axis(1).degree()}];
        } else {
            ++(spline.dim() == 2 ? content.plane_curves : content.curves);
            ++content.curve_degrees[{spline.axis(0).degree(), 0}];
        }
    }
    return content;
}

std::string describe(const Content &content) {
    std::string text = std::to_string(content.curves) + " curves, " + std::to_string(content.plane_curves) +
                       " 2D curves, " + std::to_string(content.surfaces) + " surfaces, " +
                       std::to_string(content.rational) + " rational;";
    for (const Degrees *degrees : {&content.curve_degrees, &content.surface_degrees}) {
        for (const auto &[degree, count] : *degrees) {
            text += " " + std::to_string(degree.first) + "x" + std::to_string(degree.second) + " (" +
                    std::to_string(count) + ")";
        }
    }
    return text;
}

std::string bytes_of(const std::filesystem::path &path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

TEST(RealFiles, contents_match_the_table) {
    const char *folder = std::getenv("NURBS_TEST_DATA");
    if (folder == nullptr) {
        GTEST_SKIP() << "NURBS_TEST_DATA is not set: no real files to read";
    }
    size_t known = 0;
    for (const auto &entry : std::filesystem::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (entry.path().extension() != ".iges" && entry.path().extension() != ".igs") {
            continue;
        }
        SCOPED_TRACE(name);
        const nrb::model::Model document = iges_test::read(bytes_of(entry.path()));
        for (const nrb::model::Note &note : document.notes) {
            // parameter curves that go on at the other side of a seam have a gap there
            EXPECT_TRUE(note.reason == nrb::Status::unsupported ||
                        (note.entity_type == 102 && note.reason == nrb::Status::gap))
                << note.text;
        }
        const auto expected = expected_contents().find(name);
        if (expected != expected_contents().end()) {
            ++known;
            const Content content = content_of(document);
            EXPECT_TRUE(content == expected->second)
                << "found    " << describe(content) << "\nexpected " << describe(expected->second);
        }
    }
    EXPECT_EQ(known, expected_contents().size()) << "files of the table are missing from " << folder;
}

TEST(RealFiles, unit_and_names_of_the_blade) {
    const char *folder = std::getenv("NURBS_TEST_DATA");
    if (folder == nullptr) {
        GTEST_SKIP() << "NURBS_TEST_DATA is not set: no real files to read";
    }
    const nrb::model::Model document =
        iges_test::read(bytes_of(std::filesystem::path(folder) / "iea15mw_blade.igs"));
    EXPECT_EQ(document.metres_per_unit, 1.0);
    std::map<std::string, int> surfaces;
    for (const nrb::model::NamedSpline &named : document.splines) {
        surfaces[named.name] += named.spline->axes() == 2 ? 1 : 0;
    }
    EXPECT_EQ(surfaces["shell_1"], 1);
    EXPECT_EQ(surfaces["shell_2"], 1);
    EXPECT_EQ(surfaces["shell_3"], 1);
}

} // namespace

} // namespace real_files_test
