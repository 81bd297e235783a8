// Offset curves of IGES files (entity 130): C + D1 V x T / |V x T|.
#include "support/iges_reading.h"
#include "support/spline_checks.h"

#include <cmath>
#include <numbers>

namespace iges_offset_curves_test {

namespace {

using namespace iges_test;
using nrb::Status;
using nrb::Vector3;
using spline_checks::expect_domain;
using spline_checks::expect_near;
using spline_checks::point_of;

constexpr double pi = std::numbers::pi;

// Half a circle of radius 2 about (1, 0) at z = 3.
constexpr const char *half = "3.,1.,0.,3.,0.,-1.,0.";
// (2 t, t (1 - t)) over [0, 1].
constexpr const char *arch =
    "2,2,1,0,1,0,0.,0.,0.,1.,1.,1.,1.,1.,1.,0.,0.,0.,1.,.5,0.,2.,0.,0.,0.,1.,0.,0.,1.";

// An offset curve by D1 with the normal.
std::string by(int64_t curve, const std::string &distance, const std::string &normal,
               const std::string &range = "0.,0.") {
    return std::to_string(curve) + ",1,0,0,0," + distance + ",0.,0.,0.," + normal + "," + range;
}

nrb::SplinePtr last_spline(const nrb::model::Model &document) {
    for (const nrb::model::Note &note : document.notes) {
        EXPECT_EQ(note.reason, Status::tolerance) << note.text;
    }
    return document.splines.empty() ? nullptr : document.splines.back().spline;
}

TEST(IgesOffsetCurves, of_arcs_are_arcs) {
    for (const bool inwards : {true, false}) {
        IgesBuilder builder;
        builder.add(100, half);
        builder.add(130, by(1, ".5", inwards ? "0.,0.,1." : "0.,0.,-1."));
        const nrb::SplinePtr arc = only_spline(read(builder));
        EXPECT_TRUE(read(builder).notes.empty());
        const double radius = inwards ? 1.5 : 2.5;
        expect_domain(*arc, 0, 0, pi);
        for (const double angle : {0.0, pi / 4, pi / 2, pi}) {
            expect_near(point_of(*arc, angle), {1 + radius * std::cos(angle), radius * std::sin(angle), 3});
        }
    }
}

TEST(IgesOffsetCurves, have_a_range_of_their_own) {
    IgesBuilder builder;
    builder.add(100, half);
    builder.add(130, by(1, ".5", "0.,0.,1.", "0.,1.5707963267948966"));
    const nrb::SplinePtr arc = only_spline(read(builder));
    expect_domain(*arc, 0, 0, pi / 2);
    expect_near(point_of(*arc, pi / 2), {1, 1.5, 3});
    for (const char *range : {"1.,.5", "-1.,1.", "0.,4."}) {
        IgesBuilder other;
        other.add(100, half);
        other.add(130, by(1, ".5", "0.,0.,1.", range));
        EXPECT_TRUE(read(other).splines.size() < 2) << range;
        EXPECT_FALSE(read(other).notes.empty()) << range;
    }
}

TEST(IgesOffsetCurves, of_lines_are_lines) {
    IgesBuilder builder;
    builder.add(110, "0.,0.,0.,4.,0.,0.");
    builder.add(130, by(1, ".5", "0.,0.,1.", ".25,.75"));
    const nrb::SplinePtr line = only_spline(read(builder));
    expect_near(point_of(*line, 0.25), {1, 0.5, 0});
    expect_near(point_of(*line, 0.75), {3, 0.5, 0});
}

TEST(IgesOffsetCurves, of_splines_tell_how_near_they_are) {
    IgesBuilder builder;
    builder.add(126, arch);
    builder.add(130, by(1, ".125", "0.,0.,1.", "0.,1."));
    const nrb::model::Model document = read(builder, {.tolerance = 1e-6});
    ASSERT_EQ(document.splines.size(), 2U);
    ASSERT_EQ(document.notes.size(), 1U);
    EXPECT_NE(document.notes[0].text.find("its offset curve is approximated within "), std::string::npos);
    const nrb::SplinePtr offset = last_spline(document);
    for (int i = 0; i <= 40; ++i) {
        const double t = i / 40.0, rise = 1 - 2 * t, size = std::hypot(2, rise);
        expect_near(point_of(*offset, t), {2 * t - 0.125 * rise / size, t * (1 - t) + 0.125 * 2 / size, 0},
                    0.25e-6);
    }
}

// The image of the offset, whatever the matrix does to V x T, and in the unit that is wanted.
TEST(IgesOffsetCurves, lie_where_the_matrix_puts_them) {
    for (const char *matrix : {"0.,-1.,0.,5.,1.,0.,0.,6.,0.,0.,1.,7.", "-1.,0.,0.,5.,0.,1.,0.,6.,0.,0.,1.,7.",
                               "1.,0.,0.,5.,0.,1.,0.,6.,0.,0.,-1.,7."}) {
        IgesBuilder builder;
        const int64_t map = builder.add(124, matrix);
        const int64_t arc = builder.add(100, half), curve = builder.add(126, arch);
        Fields fields;
        fields.transform = map;
        builder.add(130, by(arc, ".5", "0.,0.,1."), fields);
        builder.add(130, by(curve, ".125", "0.,0.,1."), fields);
        const nrb::model::Model document = read(builder, {.unit = 1e-4, .tolerance = 1e-6});
        double m[12];
        ASSERT_EQ(std::sscanf(matrix, "%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf", m, m + 1, m + 2,
                              m + 3, m + 4, m + 5, m + 6, m + 7, m + 8, m + 9, m + 10, m + 11),
                  12);
        const double unit = 10;
        const auto image = [&](double x, double y, double z) {
            return unit * Vector3{m[0] * x + m[1] * y + m[2] * z + m[3],
                                  m[4] * x + m[5] * y + m[6] * z + m[7],
                                  m[8] * x + m[9] * y + m[10] * z + m[11]};
        };
        ASSERT_EQ(document.splines.size(), 3U); // the spline, and both offsets
        const double rise = 0.5, size = std::hypot(2, rise);
        expect_near(point_of(*document.splines[2].spline, 0.25),
                    image(0.5 - 0.125 * rise / size, 0.1875 + 0.25 / size, 0), 0.25e-6);
        const nrb::Interval domain = document.splines[1].spline->axis(0).domain();
        const Vector3 start = point_of(*document.splines[1].spline, domain.lower),
                      end = point_of(*document.splines[1].spline, domain.upper);
        expect_near(start, image(2.5, 0, 3), 1e-11);
        expect_near(end, image(-0.5, 0, 3), 1e-11);
    }
}

TEST(IgesOffsetCurves, are_pieces_of_composite_curves) {
    IgesBuilder builder;
    builder.add(100, half);
    builder.add(130, by(1, ".5", "0.,0.,1."));
    builder.add(110, "-.5,0.,3.,-.5,-2.,3.");
    builder.add(102, "2,3,5");
    const nrb::SplinePtr all = only_spline(read(builder));
    expect_near(point_of(*all, 0), {2.5, 0, 3});
    expect_near(point_of(*all, pi + 1), {-0.5, -2, 3});
}

TEST(IgesOffsetCurves, that_are_not_read_are_noted) {
    const auto note_on = [](const std::string &data) {
        IgesBuilder builder;
        builder.add(126, arch);
        builder.add(130, data);
        const nrb::model::Model document = read(builder);
        EXPECT_EQ(document.splines.size(), 1U);
        EXPECT_EQ(document.notes.size(), 1U);
        return document.notes.empty() ? nrb::model::Note{} : document.notes.back();
    };
    EXPECT_NE(note_on("1,2,0,0,2,.1,0.,.2,1.,0.,0.,1.,0.,1.").text.find("FLAG = 2: a distance that changes"),
              std::string::npos);
    EXPECT_NE(
        note_on("1,3,1,2,2,0.,0.,0.,0.,0.,0.,1.,0.,1.").text.find("FLAG = 3: a distance that is a function"),
        std::string::npos);
    EXPECT_EQ(note_on("1,4,0,0,0,.1,0.,0.,0.,0.,0.,1.,0.,1.").reason, Status::syntax);
    EXPECT_EQ(note_on(by(1, ".1", "0.,0.,0.")).reason, Status::direction);
    EXPECT_EQ(note_on(by(3, ".1", "0.,0.,1.")).reason, Status::syntax); // of itself
    EXPECT_EQ(note_on(by(99, ".1", "0.,0.,1.")).reason, Status::syntax);
    EXPECT_EQ(note_on(by(1, ".1", "2.,1.,0.", "0.,.1")).reason,
              Status::unsupported); // along the tangent at 0
}

} // namespace

} // namespace iges_offset_curves_test
