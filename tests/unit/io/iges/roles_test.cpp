// Curves in the parameter plane of a surface have two coordinates and no unit.
#include "support/iges_reading.h"

#include <map>

namespace roles_test {

namespace {

using namespace iges_test;

const std::vector<double> in_plane = {1, 2, 4, 6};
const std::vector<double> in_space = {1000, 2000, 3000, 4000, 6000, 8000};

// The file in metres, read in millimetres; points by name, which is 126#line here.
std::map<std::string, std::vector<double>> points_by_name(IgesBuilder builder) {
    builder.global(14, "6").global(15, "1HM");
    std::map<std::string, std::vector<double>> result;
    for (const nrb::model::NamedSpline &named : read(builder, {.unit = 0.001}).splines) {
        EXPECT_EQ(named.spline->points().size(), static_cast<size_t>(2 * named.spline->dim()));
        result[named.name] = points_of(*named.spline);
    }
    return result;
}

TEST(IgesRoles, by_the_status_digits) {
    IgesBuilder builder;
    builder.add(126, line_126, {.status = "00000500"});
    builder.add(126, line_126, {.status = "00010500"});
    builder.add(126, line_126, {.status = "     500"});
    builder.add(126, line_126, {.status = "00010000"});
    builder.add(126, line_126, {.status = "05050005"});
    builder.add(126, line_126, {.status = "        "});
    const auto points = points_by_name(builder);
    EXPECT_EQ(points.at("126#1"), in_plane);
    EXPECT_EQ(points.at("126#3"), in_plane);
    EXPECT_EQ(points.at("126#5"), in_plane);
    EXPECT_EQ(points.at("126#7"), in_space);
    EXPECT_EQ(points.at("126#9"), in_space);
    EXPECT_EQ(points.at("126#11"), in_space);
}

TEST(IgesRoles, by_a_curve_on_a_surface) {
    IgesBuilder builder;
    builder.add(126, line_126);
    builder.add(126, line_126);
    builder.add(142, "0,99,1,3,2", {.status = "00010500"});
    const auto points = points_by_name(builder);
    EXPECT_EQ(points.at("126#1"), in_plane);
    EXPECT_EQ(points.at("126#3"), in_space);
}

TEST(IgesRoles, through_composite_curves) {
    IgesBuilder builder;
    builder.add(142, "0,99,3,9,2");
    builder.add(102, "2,5,11"); // parameter plane
    builder.add(102, "1,7");
    builder.add(126, line_126);
    builder.add(102, "1,13"); // space
    builder.add(126, line_126);
    builder.add(126, line_126);
    const auto points = points_by_name(builder);
    EXPECT_EQ(points.at("126#7"), in_plane);
    EXPECT_EQ(points.at("126#11"), in_plane);
    EXPECT_EQ(points.at("126#13"), in_space);
}

TEST(IgesRoles, by_a_boundary) {
    IgesBuilder builder;
    for (int i = 0; i < 5; ++i) {
        builder.add(126, line_126);
    }
    // Two curves in space, 1 and 5; their parameter curves are 3, and 7 with 9.
    builder.add(141, "1,3,99,2,1,1,1,3,5,1,2,7,9");
    const auto points = points_by_name(builder);
    EXPECT_EQ(points.at("126#1"), in_space);
    EXPECT_EQ(points.at("126#3"), in_plane);
    EXPECT_EQ(points.at("126#5"), in_space);
    EXPECT_EQ(points.at("126#7"), in_plane);
    EXPECT_EQ(points.at("126#9"), in_plane);
}

TEST(IgesRoles, transformed_in_the_plane) {
    IgesBuilder builder;
    const int64_t matrix = builder.add(124, "1.,0.,0.,100.,0.,1.,0.,0.,0.,0.,1.,0.");
    builder.add(126, line_126, {.transform = matrix, .status = "00000500"});
    EXPECT_EQ(points_by_name(builder).at("126#3"), (std::vector<double>{101, 2, 104, 6}));
}

TEST(IgesRoles, surfaces_stay_in_space) {
    IgesBuilder builder;
    builder.add(128, "1,1,1,1,0,0,1,0,0,0,0,1,1,0,0,1,1,1,1,1,1,0,0,0,1,0,0,0,1,0,1,1,0,0,1,0,1",
                {.status = "00000500"});
    EXPECT_EQ(only_spline(read(builder))->dim(), 3);
}

// Circles, pointers to nowhere and unreadable data mark nothing and end.
TEST(IgesRoles, broken_references) {
    IgesBuilder builder;
    builder.add(142, "0,99,3,0,2");
    builder.add(102, "3,3,5,9");
    builder.add(102, "2,3,5");
    builder.add(142, "0,99,9999999,0,2");
    builder.add(126, line_126);
    builder.add(142, "0,99,abc,0,2");
    builder.add(141, "1,3,99,9223372036854775807,1,1,9223372036854775807,-3");
    builder.add(102, "9223372036854775807,1", {.status = "00000500"});
    const auto points = points_by_name(builder);
    EXPECT_EQ(points.at("126#9"), in_plane);
}

} // namespace

} // namespace roles_test
