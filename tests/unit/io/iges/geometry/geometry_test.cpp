// Shapes of IGES files: what they are, where they lie, and what their parameters mean.
#include "io/iges/geometry/geometry.h"
#include "io/iges/global.h"
#include "model/shapes/surface_spline.h"
#include "support/iges_reading.h"
#include "support/spline_checks.h"

#include <cmath>
#include <numbers>

namespace iges_geometry_test {

namespace {

using namespace iges_test;
using namespace spline_checks;
using namespace nrb::io::iges;
using nrb::Status;
using nrb::Vector3;
using nrb::model::CurveKind;
using nrb::model::SurfaceKind;

constexpr double pi = std::numbers::pi;

// All that reading a file needs.
class File {
public:
    explicit File(const IgesBuilder &builder, double factor = 1)
        : text_(builder.text()), sections_(split_sections(text_)), directory_(sections_.directory),
          data_(sections_.parameter, read_global(sections_.global).delimiters),
          transforms_(directory_, data_), names_(directory_, data_),
          entities_(text_.size(), directory_, data_, transforms_, names_),
          geometry(entities_, {factor, factor * read_global(sections_.global).resolution}) {}

private:
    std::string text_;
    Sections sections_;
    Directory directory_;
    ParameterData data_;
    Transforms transforms_;
    Names names_;
    Entities entities_;

public:
    Geometry geometry;
};

Failure failure_of_curve(const IgesBuilder &builder, int64_t pointer) {
    try {
        (void)File(builder).geometry.curve(pointer);
        return {};
    } catch (const nrb::Error &error) {
        return {error.status(), error.what()};
    }
}

// The file's (u, v) in the parameters of the shape, through a line from there to the origin.
Vector3 mapped(const ParameterMap &map, double u, double v) {
    IgesBuilder builder;
    const std::string point = std::string(nrb::Number(u).text) + "," + nrb::Number(v).text;
    builder.add(110, point + ",0.,0.,0.,0.");
    File file(builder, 1000);
    return point_of(*spline_of(file.geometry.parameter_curve(1, map)), 0);
}

Vector3 at(const Surface &surface, double u, double v) {
    const Vector3 p = mapped(surface.map, u, v);
    const nrb::SplinePtr spline =
        nrb::model::surface_spline(*surface.shape, {{p.x, p.x + 1}, {p.y, p.y + 0.5}});
    return point_of(*spline, p.x, p.y);
}

TEST(IgesGeometry, kinds_of_curves_are_kept) {
    IgesBuilder builder;
    builder.add(100, "0.,0.,0.,2.,0.,0.,2.");
    builder.add(104, "1.,0.,4.,0.,0.,-4.,0.,2.,0.,0.,1.");
    builder.add(104, "1.,0.,0.,0.,-4.,0.,0.,-2.,1.,4.,4.", {.form = 3});
    builder.add(110, "0.,0.,0.,3.,4.,0.", {.form = 1});
    File file(builder, 10);
    const auto circle = file.geometry.curve(1), ellipse = file.geometry.curve(3),
               parabola = file.geometry.curve(5), ray = file.geometry.curve(7);
    EXPECT_EQ(circle.curve->kind, CurveKind::circle);
    EXPECT_EQ(circle.curve->sizes[0], 20);
    EXPECT_EQ(ellipse.curve->kind, CurveKind::ellipse);
    EXPECT_EQ(ellipse.curve->sizes[0], 20);
    EXPECT_EQ(ellipse.curve->sizes[1], 10);
    EXPECT_EQ(parabola.curve->kind, CurveKind::parabola);
    EXPECT_EQ(parabola.curve->sizes[0], 10);
    EXPECT_FALSE(parabola.forward);
    EXPECT_EQ(ray.curve->kind, CurveKind::line);
    EXPECT_EQ(ray.range.lower, 0);
    EXPECT_FALSE(std::isfinite(ray.range.upper));
    expect_near(nrb::model::point_at(*ray.curve, 1), {30, 40, 0});
}

TEST(IgesGeometry, curves_are_read_once) {
    IgesBuilder builder;
    builder.add(100, "0.,0.,0.,2.,0.,0.,2.", {.label = "ARC"});
    File file(builder);
    EXPECT_EQ(file.geometry.name(1), "");
    const auto first = file.geometry.curve(1);
    EXPECT_EQ(file.geometry.curve(1).curve, first.curve);
    EXPECT_EQ(file.geometry.name(1), "ARC");
    const Transform moved{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {5, 0, 0}};
    expect_near(nrb::model::point_at(*file.geometry.curve(1, &moved).curve, 0), {7, 0, 0});
    EXPECT_EQ(file.geometry.parameter_curve(1).curve->place.dim, 2);
    EXPECT_EQ(file.geometry.curve(1).curve, first.curve);
}

TEST(IgesGeometry, composites_come_apart) {
    IgesBuilder builder;
    builder.add(110, "0.,0.,0.,1.,0.,0.");
    builder.add(110, "1.,0.,0.,1.,1.,0.");
    builder.add(102, "1,3");
    builder.add(102, "2,1,5");
    File file(builder);
    const auto pieces = file.geometry.curve_pieces(7);
    ASSERT_EQ(pieces.size(), 2U);
    expect_near(point_of(*spline_of(pieces[1]), 1), {1, 1, 0}, 0);
    EXPECT_EQ(file.geometry.curve_pieces(1).size(), 1U);
    EXPECT_TRUE(file.geometry.is_part(1));
    EXPECT_TRUE(file.geometry.is_part(5));
    EXPECT_FALSE(file.geometry.is_part(7));
    ParameterMap map;
    map.swapped = true;
    expect_near(point_of(*spline_of(file.geometry.parameter_pieces(7, map)[0]), 1), {0, 1, 0}, 0);
}

TEST(IgesGeometry, parameters_of_a_surface_of_revolution) {
    IgesBuilder builder;
    builder.add(110, "0.,0.,0.,0.,0.,1.");
    builder.add(100, "0.,5.,0.,7.,0.,5.,2.", {.transform = 7});
    builder.add(120, "1,3,0.,3.");
    builder.add(124, "1.,0.,0.,0.,0.,0.,-1.,0.,0.,1.,0.,0."); // the arc stands in the plane of x and z
    File file(builder);
    const Surface surface = file.geometry.surface(5);
    EXPECT_TRUE(surface.parametrized);
    const double t = pi / 4, theta = 0.5;
    const double r = 5 + 2 * std::cos(t);
    // at t = 0 and at the middle of the arc, where parameter and angle agree
    expect_near(at(surface, 0, theta), {7 * std::cos(theta), 7 * std::sin(theta), 0});
    expect_near(at(surface, t, theta), {r * std::cos(theta), r * std::sin(theta), 2 * std::sin(t)});
}

TEST(IgesGeometry, parameters_of_a_tabulated_cylinder) {
    IgesBuilder builder;
    builder.add(106, "1,3,0.,0.,0.,1.,0.,1.,1.", {.form = 11});
    builder.add(122, "1,0.,0.,4.");
    File file(builder, 10);
    const Surface surface = file.geometry.surface(3);
    EXPECT_EQ(surface.shape->kind, SurfaceKind::trimmed);
    EXPECT_EQ(surface.shape->basis->kind, SurfaceKind::extrusion);
    const Vector3 p = mapped(surface.map, 0.75, 0.25);
    const nrb::SplinePtr spline =
        nrb::model::surface_spline(*surface.shape, nrb::model::natural_range(*surface.shape));
    expect_near(point_of(*spline, p.x, p.y), {10, 5, 10});
}

// Angles in degrees, lengths in the unit of the file.
TEST(IgesGeometry, parameters_of_elementary_surfaces) {
    IgesBuilder builder;
    builder.add(116, "1.,0.,0.,0");
    builder.add(123, "0.,0.,1.");
    builder.add(123, "1.,0.,0.");
    builder.add(190, "1,3,5", {.form = 1});
    builder.add(192, "1,3,2.,5", {.form = 1});
    builder.add(194, "1,3,2.,45.,5", {.form = 1});
    builder.add(196, "1,2.,3,5", {.form = 1});
    builder.add(198, "1,3,5.,2.,5", {.form = 1});
    builder.add(192, "1,3,2.");
    builder.add(192, "1,3,2.,5", {.transform = builder.next() + 2, .form = 1});
    builder.add(124, "1.,0.,0.,0.,0.,1.,0.,0.,0.,0.,-1.,0.");
    File file(builder, 10);
    const auto surface = [&](int64_t pointer) { return file.geometry.surface(pointer); };
    EXPECT_EQ(surface(7).shape->kind, SurfaceKind::plane);
    expect_near(at(surface(7), 0.25, 0.5), {12.5, 5, 0});
    EXPECT_EQ(surface(9).shape->kind, SurfaceKind::cylinder);
    expect_near(at(surface(9), 90, 0.5), {10, 20, 5});
    EXPECT_EQ(surface(11).shape->kind, SurfaceKind::cone);
    expect_near(at(surface(11), 90, 0.5), {10, 25, 5}, 2e-14);
    EXPECT_EQ(surface(13).shape->kind, SurfaceKind::sphere);
    expect_near(at(surface(13), 90, 45), {10, 20 * std::sqrt(0.5), 20 * std::sqrt(0.5)});
    EXPECT_EQ(surface(15).shape->kind, SurfaceKind::torus);
    EXPECT_EQ(surface(15).shape->sizes[0], 50);
    EXPECT_FALSE(surface(15).parametrized);
    EXPECT_FALSE(surface(17).parametrized);
    EXPECT_TRUE(surface(9).parametrized);
    EXPECT_FALSE(surface(19).parametrized);
    EXPECT_EQ(surface(19).shape->sizes[0], 20);
}

TEST(IgesGeometry, planes_and_their_boundaries) {
    IgesBuilder builder;
    builder.add(108, "0.,3.,4.,10.,0,0.,0.,0.,0.");
    builder.add(108, "1.,0.,0.,1.,7,0.,0.,0.,0.", {.form = 1});
    builder.add(108, "1.,0.,0.,1.,7,0.,0.,0.,0.", {.form = -1});
    File file(builder, 10);
    const Surface plane = file.geometry.surface(1);
    EXPECT_EQ(plane.boundary, 0);
    EXPECT_FALSE(plane.parametrized);
    expect_near(plane.shape->place.z, {0, 0.6, 0.8}, 2e-16);
    EXPECT_NEAR(nrb::dot(plane.shape->place.origin, plane.shape->place.z), 20, 4e-15);
    EXPECT_EQ(file.geometry.surface(3).boundary, 7);
    EXPECT_FALSE(file.geometry.surface(3).hole);
    EXPECT_TRUE(file.geometry.surface(5).hole);
}

// On the side of the indicator, whatever the direction of the normal.
TEST(IgesGeometry, offset_surfaces) {
    IgesBuilder builder;
    builder.add(110, "0.,0.,0.,1.,0.,0.");
    builder.add(122, "1,0.,1.,0."); // its normal is (0, 0, 1)
    builder.add(140, "0.,0.,1.,0.5,3");
    builder.add(140, "0.,0.,-1.,0.5,3");
    builder.add(140, "0.,0.,-1.,0.25,5");
    File file(builder, 10);
    EXPECT_EQ(file.geometry.surface(5).shape->kind, SurfaceKind::offset);
    EXPECT_EQ(file.geometry.surface(5).shape->distance, 5);
    EXPECT_EQ(file.geometry.surface(7).shape->distance, -5);
    EXPECT_EQ(file.geometry.surface(9).shape->distance, -2.5);
    EXPECT_EQ(file.geometry.surface(9).shape->basis, file.geometry.surface(5).shape);
}

TEST(IgesGeometry, circles_of_curves_end) {
    IgesBuilder builder;
    builder.add(102, "1,3");
    builder.add(102, "1,1");
    EXPECT_EQ(failure_of_curve(builder, 1).status, Status::syntax);
    EXPECT_EQ(failure_of_curve(builder, 1).text, "composite curve (102) at directory line 1: directory line "
                                                 "1: names itself by way of directory line 3");
    IgesBuilder self;
    self.add(102, "1,1");
    EXPECT_EQ(failure_of_curve(self, 1).status, Status::syntax);
    EXPECT_THROW((void)File(self).geometry.curve_pieces(1), nrb::Error);
}

TEST(IgesGeometry, chains_are_not_followed_without_end) {
    IgesBuilder builder;
    for (int i = 0; i < 1000; ++i) {
        builder.add(102, "1," + std::to_string(builder.next() + 2));
    }
    builder.add(110, "0.,0.,0.,1.,0.,0.");
    EXPECT_NE(failure_of_curve(builder, 1).text.find("lies more than 24 entities deep"), std::string::npos)
        << failure_of_curve(builder, 1).text;
    EXPECT_EQ(failure_of_curve(builder, 1999).status, Status::ok);
}

// Each composite names the next one ten times: 10^9 lines.
TEST(IgesGeometry, what_is_made_of_a_file_is_limited) {
    for (const bool apart : {false, true}) {
        IgesBuilder builder;
        for (int i = 0; i < 9; ++i) {
            std::string data = "10";
            for (int k = 0; k < 10; ++k) {
                data += "," + std::to_string(builder.next() + 2);
            }
            builder.add(102, data);
        }
        builder.add(110, "0.,0.,0.,0.,0.,0.");
        try {
            File file(builder);
            if (apart) {
                (void)file.geometry.curve_pieces(1);
            } else {
                (void)file.geometry.curve(1);
            }
            ADD_FAILURE() << "nothing was thrown";
        } catch (const nrb::Error &error) {
            EXPECT_EQ(error.status(), Status::too_large) << error.what();
        }
    }
}

TEST(IgesGeometry, errors_name_the_entity_in_which_they_happen) {
    IgesBuilder builder;
    builder.add(110, "0.,0.,0.,1.,x,0.");
    builder.add(102, "1,1");
    builder.add(102, "1,3");
    const Failure failure = failure_of_curve(builder, 5);
    EXPECT_EQ(failure.text.rfind("line (110) at directory line 1: P2[1] (parameter 6) is 'x'", 0), 0U)
        << failure.text;
    EXPECT_EQ(failure_of_curve(builder, 4).status, Status::syntax);
    EXPECT_EQ(failure_of_curve(builder, -1).status, Status::syntax);
    EXPECT_EQ(failure_of_curve(builder, 7).status, Status::syntax);
}

} // namespace

} // namespace iges_geometry_test
