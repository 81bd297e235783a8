// SPDX-License-Identifier: MIT
// Faces on surfaces that close up without clamped knots, as periodic ones are written.
#include "face/integrals/face_moments.h"
#include "support/step_reading.h"

#include <cmath>

namespace step_unclamped_faces_test {
namespace {

using namespace step_test;
using nrb::model::Model;

// A tube of height 1 over the uniform closed quadratic spline of a square of side 2, whose first points are repeated at its end.
struct Tube : StepBuilder {
    std::string ring(const std::string &height) {
        std::string points;
        for (const char *corner : {"1.,1.,", "-1.,1.,", "-1.,-1.,", "1.,-1.,", "1.,1.,", "-1.,1.,"}) {
            points += (points.empty() ? "" : ",") + point(corner + height);
        }
        return points;
    }
    std::string curve(const std::string &height) {
        const std::string points = ring(height);
        return add("B_SPLINE_CURVE_WITH_KNOTS('',2,(" + points + "),.UNSPECIFIED.,.T.,.F.," + knots +
                   ",.UNSPECIFIED.)");
    }
    std::string surface() {
        std::string rows;
        for (const char *corner : {"1.,1.,", "-1.,1.,", "-1.,-1.,", "1.,-1.,", "1.,1.,", "-1.,1.,"}) {
            const std::string low = point(std::string(corner) + "0."),
                              high = point(std::string(corner) + "1.");
            rows += (rows.empty() ? "(" : ",(") + low + "," + high + ")";
        }
        return add("B_SPLINE_SURFACE_WITH_KNOTS('',2,1,(" + rows + "),.UNSPECIFIED.,.T.,.F.,.F.," +
                   "(1,1,1,1,1,1,1,1,1),(2,2),(-2.,-1.,0.,1.,2.,3.,4.,5.,6.),(0.,1.),.UNSPECIFIED.)");
    }
    const std::string knots = "(1,1,1,1,1,1,1,1,1),(-2.,-1.,0.,1.,2.,3.,4.,5.,6.)";
};

// Of a quarter of the ring: the integral of 2 |(t, 1 - t)| over [0, 1].
const double quarter = 1 + std::asinh(1) / std::sqrt(2);

void expect_area(const StepBuilder &file, double area) {
    const Model found = nrb::io::read_model(file.text(), {});
    for (const nrb::model::Note &note : found.notes) {
        ADD_FAILURE() << note.text;
    }
    ASSERT_EQ(found.faces.size(), 1U);
    const nrb::measure::MomentOrder content = nrb::measure::MomentOrder::content;
    EXPECT_NEAR(nrb::face::moments(*found.faces[0].face, content, 1e-10).content, area, 1e-9);
}

TEST(StepUnclampedFaces, HaveRingsForBounds) {
    Tube file;
    const std::string low = file.edge("0.,1.,0.", "0.,1.,0.", file.curve("0.")),
                      high = file.edge("0.,1.,1.", "0.,1.,1.", file.curve("1.")),
                      seam = file.straight_edge("0.,1.,0.", "0.,1.,1.", "0.,0.,1.");
    const auto way = [&](const std::string &edge, const char *sense) {
        return file.add("ORIENTED_EDGE('',*,*," + edge + "," + sense + ")");
    };
    const std::string around =
        way(low, ".T.") + "," + way(seam, ".T.") + "," + way(high, ".F.") + "," + way(seam, ".F.");
    const std::string bound =
        file.add("FACE_OUTER_BOUND(''," + file.add("EDGE_LOOP('',(" + around + "))") + ",.T.)");
    file.add("ADVANCED_FACE('',(" + bound + ")," + file.surface() + ",.T.)");
    expect_area(file, 4 * quarter);
}

TEST(StepUnclampedFaces, MayCrossTheEndOfTheDomain) {
    Tube file;
    const std::string low = file.edge("0.75,0.75,0.", "-0.75,0.75,0.", file.curve("0.")),
                      left = file.straight_edge("-0.75,0.75,0.", "-0.75,0.75,1.", "0.,0.,1."),
                      high = file.edge("-0.75,0.75,1.", "0.75,0.75,1.", file.curve("1."), ".F."),
                      right = file.straight_edge("0.75,0.75,1.", "0.75,0.75,0.", "0.,0.,-1.");
    const std::string surface = file.surface();
    file.face(surface, {low, left, high, right});
    expect_area(file, quarter);
}

} // namespace
} // namespace step_unclamped_faces_test
