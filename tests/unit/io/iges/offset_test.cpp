// SPDX-License-Identifier: MIT
// Offset surfaces (entity 140): elementary ones are so again, others come with a note on how near they are.
#include "face/covering.h"
#include "numeric/norm.h"
#include "support/iges_reading.h"

#include <cmath>

namespace iges_offset_test {

namespace {

using namespace iges_test;

TEST(IgesOffset, of_a_sphere_is_a_sphere) {
    IgesBuilder builder;
    builder.add(116, "1.,2.,3.,0");
    builder.add(196, "1,2.");
    builder.add(140, "0.,0.,1.,.5,3");
    const nrb::model::Model document = read(builder.text());
    ASSERT_EQ(document.splines.size(), 1U); // the one from which it is offset is a part of it
    EXPECT_TRUE(document.notes.empty());
    const nrb::Spline &offset = *document.splines[0].spline;
    const double centre[3] = {1, 2, 3};
    for (const double u : {0.1, 0.7}) {
        const nrb::Interval a = offset.axis(0).domain(), b = offset.axis(1).domain();
        const std::vector<double> x = nrb::face::point_at(
            offset, {a.lower + u * (a.upper - a.lower), b.lower + u * (b.upper - b.lower)});
        EXPECT_NEAR(std::abs(nrb::distance(x.data(), centre, 3) - 2), 0.5, 1e-14);
    }
}

TEST(IgesOffset, of_a_spline_tells_how_near_it_is) {
    IgesBuilder builder;
    builder.add(128, "2,1,2,1,0,0,1,0,0,0.,0.,0.,1.,1.,1.,0.,0.,1.,1.,1.,1.,1.,1.,1.,1.,"
                     "0.,0.,0.,1.,0.,.5,2.,0.,0.,0.,1.,0.,1.,1.,.5,2.,1.,0.,0.,1.,0.,1.");
    builder.add(140, "0.,0.,1.,.5,1");
    const nrb::model::Model document = read(builder.text(), {.tolerance = 1e-2});
    ASSERT_EQ(document.splines.size(), 2U);
    ASSERT_EQ(document.notes.size(), 1U);
    EXPECT_EQ(document.notes[0].reason, nrb::Status::tolerance);
    EXPECT_NE(document.notes[0].text.find("approximated within"), std::string::npos);
    const nrb::Spline &basis = *document.splines[0].spline, &offset = *document.splines[1].spline;
    for (int i = 0; i <= 20; ++i) {
        // The parabola (2 t, t (1 - t)) along u, moved along its normal in the plane x, z.
        const double t = i / 20.0, rise = 1 - 2 * t, size = std::hypot(2, rise);
        const std::vector<double> at = nrb::face::point_at(basis, {t, 0.5}),
                                  got = nrb::face::point_at(offset, {t, 0.5});
        const double wanted[3] = {at[0] - 0.5 * rise / size, at[1], at[2] + 0.5 * 2 / size};
        EXPECT_LE(nrb::distance(got.data(), wanted, 3), 0.25e-2);
    }
}

} // namespace

} // namespace iges_offset_test
