// Offset surfaces of STEP files: of splines within what the file allows, and of offsets again.
#include "numeric/vector3.h"
#include "support/step_reading.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace step_offset_surfaces_test {

namespace {

using namespace step_test;
using nrb::Status;
using nrb::Vector3;

std::string number(double x) {
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", x);
    std::string made = text;
    return made.find_first_of(".e") == std::string::npos ? made + "." : made;
}

// n x n control points over the unit square, of degree 3 with knots that are equally far apart.
template <class Height>
std::string sheet(StepBuilder &builder, int n, Height &&height) {
    std::string rows;
    for (int i = 0; i < n; ++i) {
        std::string row;
        for (int j = 0; j < n; ++j) {
            const double x = i / (n - 1.0), y = j / (n - 1.0);
            row += (row.empty() ? "" : ",") +
                   builder.point(number(x) + "," + number(y) + "," + number(height(x, y)));
        }
        rows += (rows.empty() ? "(" : ",(") + row + ")";
    }
    return builder.add("QUASI_UNIFORM_SURFACE('',3,3,(" + rows + "),.U.,.F.,.F.,.F.)");
}

std::string offset_of(StepBuilder &builder, const std::string &basis, const std::string &distance) {
    return builder.add("OFFSET_SURFACE(''," + basis + "," + distance + ",.F.)");
}

double wave(double x, double y) {
    return 0.3 * std::sin(3 * x) * std::cos(2 * y);
}
double bumps(double x, double y) {
    return 0.03 * std::sin(12 * x + 9 * y);
}
double channel(double x, double) {
    return x * x; // not the control points of it, but much like it
}

// S + d N at a place of the basis.
Vector3 defined(const nrb::Spline &basis, double u, double v, double distance) {
    const double h = 1e-5;
    const auto at = [&](double s, double t) { return point_of(basis, s, t); };
    const Vector3 su = at(u + h, v) - at(u - h, v), sv = at(u, v + h) - at(u, v - h);
    return at(u, v) + distance * unit(cross(su, sv));
}

void expect_offset(const nrb::Spline &found, const nrb::Spline &basis, double distance, double tolerance) {
    const nrb::Interval u = basis.axis(0).domain(), v = basis.axis(1).domain();
    for (int i = 1; i < 20; ++i) {
        for (int j = 1; j < 20; ++j) {
            const double s = std::lerp(u.lower, u.upper, i / 20.3), t = std::lerp(v.lower, v.upper, j / 20.7);
            // A difference over 2e-5 of a unit has the direction of a derivative to about 1e-9.
            EXPECT_LE(length(point_of(found, s, t) - defined(basis, s, t, distance)), tolerance + 2e-9);
        }
    }
}

nrb::SplinePtr basis_of(double (*height)(double, double), int n) {
    StepBuilder builder;
    sheet(builder, n, height);
    return only_spline(builder);
}

// At uncertainties that files do state.
TEST(StepOffsetSurfaces, of_ordinary_splines_are_as_near_as_the_file_says) {
    for (const double tolerance : {1e-4, 1e-6, 1e-7}) {
        StepBuilder builder;
        offset_of(builder, sheet(builder, 10, wave), "0.1");
        const nrb::model::Model document = read(builder, {.tolerance = tolerance});
        ASSERT_EQ(document.splines.size(), 1U);
        EXPECT_EQ(only_note(document).reason, Status::tolerance);
        EXPECT_EQ(only_note(document).text.find("more than"), std::string::npos) << only_note(document).text;
        expect_offset(*document.splines[0].spline, *basis_of(wave, 10), 0.1, tolerance / 4);
    }
}

// The nearest that the size of the file allows, and that it is not near enough.
TEST(StepOffsetSurfaces, of_others_are_as_near_as_can_be) {
    StepBuilder builder;
    const std::string offset = offset_of(builder, sheet(builder, 12, bumps), "0.02");
    const nrb::model::Model document = read(builder, {.tolerance = 1e-10});
    ASSERT_EQ(document.splines.size(), 1U);
    const std::string text = only_note(document).text,
                      start = offset + " OFFSET_SURFACE: its offset surface is approximated within ";
    ASSERT_TRUE(text.starts_with(start)) << text;
    EXPECT_TRUE(text.ends_with(", which is more than the tolerance of the file, 1e-10")) << text;
    const double bound = std::stod(text.substr(start.size()));
    EXPECT_LE(bound, 1e-5);
    expect_offset(*document.splines[0].spline, *basis_of(bumps, 12), 0.02, bound);
}

// Faces on one surface, each in a context with an uncertainty of its own.
TEST(StepOffsetSurfaces, of_faces_are_as_near_as_the_context_of_each_says) {
    StepBuilder builder;
    const std::string offset = offset_of(builder, sheet(builder, 10, wave), "0.1");
    const std::string length = builder.millimetre(), angle = builder.radian();
    const double uncertainties[] = {1e-3, 1e-6};
    for (const double uncertainty : uncertainties) {
        const std::string least = builder.add("UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(" +
                                              number(uncertainty) + ")," + length + ",'','')");
        const std::string context = builder.add(
            "(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((" + least +
            "))GLOBAL_UNIT_ASSIGNED_CONTEXT((" + length + "," + angle + "))REPRESENTATION_CONTEXT('',''))");
        builder.shape(builder.add("OPEN_SHELL('',(" + builder.face(offset, {}) + "))"), context);
    }
    const nrb::model::Model document = read(builder);
    ASSERT_EQ(document.splines.size(), 2U);
    for (size_t i = 0; i < 2; ++i) {
        expect_offset(*document.splines[i].spline, *basis_of(wave, 10), 0.1, uncertainties[i] / 4);
    }
}

// Many of them share what there is.
TEST(StepOffsetSurfaces, that_are_many_are_all_read_or_told) {
    StepBuilder builder;
    const std::string basis = sheet(builder, 10, bumps);
    for (int i = 1; i <= 40; ++i) {
        offset_of(builder, basis, number(0.001 * i));
    }
    const nrb::model::Model document = read(builder, {.tolerance = 1e-9});
    EXPECT_EQ(document.notes.size(), 40U);
    EXPECT_GE(document.splines.size(), 20U);
    for (const nrb::model::Note &note : document.notes) {
        EXPECT_TRUE(note.reason == Status::tolerance || note.reason == Status::not_converged ||
                    note.reason == Status::too_large)
            << note.text;
        EXPECT_NE(note.text.find(" OFFSET_SURFACE: "), std::string::npos) << note.text;
    }
}

TEST(StepOffsetSurfaces, by_next_to_nothing_are_the_basis) {
    for (const char *distance : {"1E-300", "-1E-300", "0.", "-0.", "4.9E-324"}) {
        StepBuilder builder;
        const std::string offset = offset_of(builder, sheet(builder, 4, wave), distance);
        const nrb::model::Model document = read(builder, {.tolerance = 1e-6});
        ASSERT_EQ(document.splines.size(), 1U);
        EXPECT_TRUE(std::ranges::equal(document.splines[0].spline->points(), basis_of(wave, 4)->points()));
        if (std::strtod(distance, nullptr) != 0) {
            const std::string text = only_note(document).text;
            EXPECT_TRUE(
                text.starts_with(offset + " OFFSET_SURFACE: its offset surface is approximated within "));
            EXPECT_LE(std::strtod(text.substr(text.rfind(' ')).c_str(), nullptr), 1e-300) << text;
        } else {
            EXPECT_TRUE(document.notes.empty());
        }
    }
}

// Radius -1/2, and 1 along the normal of that: the one of radius 1 has been turned around.
TEST(StepOffsetSurfaces, of_cylinders_turned_inside_out) {
    StepBuilder builder;
    const std::string rod = builder.add("CYLINDRICAL_SURFACE(''," + builder.some_placement() + ",1.)");
    const std::string part = builder.add("RECTANGULAR_TRIMMED_SURFACE(''," + rod + ",0.,1.5,0.,1.,.T.,.T.)");
    offset_of(builder, offset_of(builder, part, "-1.5"), "1.");
    const nrb::SplinePtr found = only_spline(builder);
    for (const double u : {0.1, 0.7, 1.4}) {
        const Vector3 x = point_of(*found, u, 0.5);
        EXPECT_NEAR(std::hypot(x.y - 2, x.z - 3), 1.5, 1e-14); // around (1, 0, 0) through (1, 2, 3)
        EXPECT_LE(x.y, 2);                                     // on the other side
    }
}

TEST(StepOffsetSurfaces, of_offsets_of_splines) {
    const nrb::SplinePtr basis = basis_of(channel, 6);
    for (const auto &[first, second, whole] : {std::array{"0.05", "0.05", "0.1"},
                                               {"0.05", "-0.15", "-0.1"},
                                               {"20.", "0.5", "19.5"}}) { // beyond the centres of curvature
        StepBuilder builder;
        offset_of(builder, offset_of(builder, sheet(builder, 6, channel), first), second);
        const nrb::model::Model document = read(builder, {.tolerance = 1e-6});
        ASSERT_EQ(document.splines.size(), 1U) << only_note(document).text;
        EXPECT_NE(only_note(document).text.find("approximated within"), std::string::npos);
        expect_offset(*document.splines[0].spline, *basis, std::stod(whole), 1e-6);
    }
    StepBuilder builder;
    const std::string ridge = offset_of(builder, sheet(builder, 6, channel), "1.");
    const std::string twice = offset_of(builder, ridge, "0.5");
    EXPECT_EQ(only_note(builder).reason, Status::unsupported);
    EXPECT_EQ(only_note(builder).text,
              twice + " OFFSET_SURFACE: the normal of the surface at the distance 1, from "
                      "which it is offset, is not known to be on one side");
}

} // namespace

} // namespace step_offset_surfaces_test
