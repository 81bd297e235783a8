// Entities 126 and 128: order of the values, polynomial and rational, periodic axes, parameter ranges.
#include "eval/evaluate.h"
#include "support/iges_reading.h"

#include <cmath>
#include <tuple>

namespace spline_test {

namespace {

using namespace iges_test;
using nrb::Form;

// A number list "1.,2.,...," without its last comma.
std::string list(const std::vector<double> &values) {
    std::string text;
    for (const double value : values) {
        text += (text.empty() ? "" : ",") + std::string(nrb::Number(value).text);
    }
    return text;
}

// Cubic over [0, 3] with two interior knots and chosen weights.
std::string cubic(const std::vector<double> &weights, const std::string &prop3,
                  const std::string &range = "0,3", const std::string &prop4 = "0") {
    return "5,3,0,0," + prop3 + "," + prop4 + "," + list({0, 0, 0, 0, 1, 2, 3, 3, 3, 3}) + "," +
           list(weights) + "," + list({0, 0, 0, 1, 2, 0, 2, 3, 1, 4, 1, 2, 5, -1, 3, 7, 0, 1}) + "," + range +
           ",0,0,1";
}

const std::vector<double> ones(6, 1.0);

TEST(IgesCurve, keeps_every_value) {
    const nrb::SplinePtr spline = read_one(126, cubic({1, 0.5, 0.25, 0.75, 1, 2}, "0"));
    ASSERT_NE(spline, nullptr);
    EXPECT_EQ(spline->axes(), 1);
    EXPECT_EQ(spline->dim(), 3);
    EXPECT_EQ(spline->axis(0).degree(), 3);
    EXPECT_EQ(spline->form(), Form::rational);
    EXPECT_EQ(knots_of(*spline), (std::vector<double>{0, 0, 0, 0, 1, 2, 3, 3, 3, 3}));
    EXPECT_EQ(std::vector<double>(spline->weights().begin(), spline->weights().end()),
              (std::vector<double>{1, 0.5, 0.25, 0.75, 1, 2}));
    EXPECT_EQ(points_of(*spline),
              (std::vector<double>{0, 0, 0, 1, 2, 0, 2, 3, 1, 4, 1, 2, 5, -1, 3, 7, 0, 1}));
}

// Flags are advisory: dropping weights that differ would change the shape.
TEST(IgesCurve, only_equal_weights_make_it_polynomial) {
    EXPECT_EQ(read_one(126, cubic(ones, "0"))->form(), Form::polynomial);
    EXPECT_EQ(read_one(126, cubic(std::vector<double>(6, 0.7), "0"))->form(), Form::polynomial);
    EXPECT_EQ(read_one(126, cubic({1, 1, 1, 1, 1, 2}, "1"))->form(), Form::rational);
    EXPECT_EQ(read_one(126, cubic({1, 1, 1, 1, 1, 2}, "0"))->form(), Form::rational);
    EXPECT_EQ(read_one(126, cubic({1, 1, 1, 1, 1, 2}, ""))->form(), Form::rational);
}

TEST(IgesCurve, blank_coordinates_are_zero_and_the_tail_may_be_missing) {
    const nrb::SplinePtr spline = read_one(126, "1,1,,,1,,0,0,1,1,1,1,,2,,4,,");
    EXPECT_EQ(points_of(*spline), (std::vector<double>{0, 2, 0, 4, 0, 0}));
}

TEST(IgesCurve, degree_zero) {
    const nrb::SplinePtr spline =
        read_one(126, "1,0,0,0,1,0,0.,1.,2.,1.,1.,1.,2.,3.,4.,5.,6.,0.,2.,0.,0.,1.");
    EXPECT_EQ(spline->axis(0).degree(), 0);
    EXPECT_EQ(spline->count(0), 2);
}

TEST(IgesCurve, ranges_that_cover_the_domain_leave_it_alone) {
    for (const char *range : {"0,3", "-1,4", ",", "0,9", "-5,3"}) {
        EXPECT_EQ(knots_of(*read_one(126, cubic(ones, "0", range))),
                  (std::vector<double>{0, 0, 0, 0, 1, 2, 3, 3, 3, 3}))
            << range;
    }
}

TEST(IgesCurve, ranges_inside_the_domain_cut) {
    EXPECT_EQ(knots_of(*read_one(126, cubic(ones, "0", "0.5,2.5"))),
              (std::vector<double>{0.5, 0.5, 0.5, 0.5, 1, 2, 2.5, 2.5, 2.5, 2.5}));
    EXPECT_EQ(knots_of(*read_one(126, cubic(ones, "0", "1,3"))),
              (std::vector<double>{1, 1, 1, 1, 2, 3, 3, 3, 3}));
    EXPECT_EQ(knots_of(*read_one(126, cubic(ones, "0", "-7,2"))),
              (std::vector<double>{0, 0, 0, 0, 1, 2, 2, 2, 2}));
}

// A straight line cut in the middle: the ends of the part are known exactly.
TEST(IgesCurve, cuts_the_right_part) {
    const nrb::SplinePtr spline =
        read_one(126, "1,1,0,0,1,0,0.,0.,1.,1.,1.,1.,1.,2.,3.,5.,6.,8.,0.25,0.5,0.,0.,1.");
    EXPECT_EQ(knots_of(*spline), (std::vector<double>{0.25, 0.25, 0.5, 0.5}));
    EXPECT_EQ(points_of(*spline), (std::vector<double>{2, 3, 4.25, 3, 4, 5.5}));
}

TEST(IgesCurve, ranges_without_parameters) {
    EXPECT_EQ(note_of(126, cubic(ones, "0", "2,1")).reason, nrb::Status::empty_domain);
    EXPECT_EQ(note_of(126, cubic(ones, "0", "3,4")).reason, nrb::Status::outside_domain);
    EXPECT_EQ(note_of(126, cubic(ones, "0", "-2,0")).reason, nrb::Status::outside_domain);
}

TEST(IgesCurve, integers_may_be_written_as_reals) {
    const nrb::SplinePtr spline =
        read_one(126, "1.,1.0D0,0,0,1,0,0.,0.,1.,1.,1.,1.,1.,2.,3.,5.,6.,8.,0.,1.,0.,0.,1.");
    EXPECT_EQ(points_of(*spline), (std::vector<double>{1, 2, 3, 5, 6, 8}));
    EXPECT_EQ(note_of(126, "1.5,1,0,0,1,0,0.,0.,1.,1.,1.,1.,1.,2.,3.,5.,6.,8.,0.,1.,0.,0.,1.").reason,
              nrb::Status::syntax);
}

// An end that is not given is the domain's, and equal ones nobody filled in.
TEST(IgesCurve, ranges_that_are_not_filled_in) {
    const std::vector<double> whole{0, 0, 0, 0, 1, 2, 3, 3, 3, 3};
    EXPECT_EQ(knots_of(*read_one(126, cubic(ones, "0", ","))), whole);
    EXPECT_EQ(knots_of(*read_one(126, cubic(ones, "0", "0,0"))), whole);
    EXPECT_EQ(knots_of(*read_one(126, cubic(ones, "0", "0,"))), whole);
    EXPECT_EQ(knots_of(*read_one(126, cubic(ones, "0", ",2"))),
              (std::vector<double>{0, 0, 0, 0, 1, 2, 2, 2, 2}));
    EXPECT_EQ(knots_of(*read_one(126, cubic(ones, "0", "1,"))),
              (std::vector<double>{1, 1, 1, 1, 2, 3, 3, 3, 3}));
}

// Closed cubic over [3, 7] with uniform knots; the last three points repeat the first three.
std::string loop(const std::string &prop4, double last_x = 1, const std::string &range = "3,7",
                 double last_knot = 10, double before_it = 9) {
    return "6,3,0,1,1," + prop4 + "," + list({0, 1, 2, 3, 4, 5, 6, 7, 8, before_it, last_knot}) + "," +
           list(std::vector<double>(7, 1)) + "," +
           list({0, 0, 0, 4, 0, 0, 1, 1, 0, 0, 4, 1, 0, 0, 0, 4, 0, 0, last_x, 1, 0}) + "," + range +
           ",0,0,1";
}

TEST(IgesCurve, periodic_where_flag_and_values_agree) {
    const nrb::SplinePtr spline = read_one(126, loop("1"));
    EXPECT_TRUE(spline->axis(0).periodic());
    EXPECT_EQ(spline->axis(0).domain().lower, 3.0);
    EXPECT_EQ(spline->count(0), 7);
}

TEST(IgesCurve, the_periodic_flag_is_only_advice) {
    EXPECT_FALSE(read_one(126, loop("0"))->axis(0).periodic());
    EXPECT_FALSE(read_one(126, loop("1", std::nextafter(1.0, 2.0)))->axis(0).periodic());
    EXPECT_FALSE(read_one(126, loop("1", 1, "3,7", 10, 9.5))->axis(0).periodic());
    EXPECT_FALSE(read_one(126, cubic(ones, "0", "0,3", "1"))->axis(0).periodic());
}

// The outermost knots have no influence, and are often wrong in files.
TEST(IgesCurve, the_outermost_knot_does_not_count) {
    const nrb::SplinePtr spline = read_one(126, loop("1", 1, "3,7", 10.5));
    EXPECT_TRUE(spline->axis(0).periodic());
    EXPECT_EQ(knots_of(*spline), (std::vector<double>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10}));
}

// A closed curve, as an entity with given knots, points (x, y, 0) and weights.
std::string closed(int degree, const std::vector<double> &knots, const std::vector<double> &plane,
                   const std::vector<double> &weights, const std::string &prop4) {
    const size_t count = plane.size() / 2;
    std::vector<double> points;
    for (size_t i = 0; i < count; ++i) {
        points.insert(points.end(), {plane[2 * i], plane[2 * i + 1], 0});
    }
    const auto degree_at = static_cast<size_t>(degree);
    return std::to_string(count - 1) + "," + std::to_string(degree) + ",1,1,0," + prop4 + "," + list(knots) +
           "," + list(weights) + "," + list(points) + "," + list({knots[degree_at], knots[count]}) + ",0,0,1";
}

std::vector<double> places(const nrb::Spline &spline) {
    std::vector<double> found;
    const nrb::Interval domain = spline.axis(0).domain();
    for (int i = 0; i <= 64; ++i) {
        const double t = std::lerp(domain.lower, domain.upper, i / 64.0);
        double point[3];
        nrb::eval::evaluate_points(spline, {}, 0, {&t, 1, 1, 1, 1}, {point, 1, 3, 3, 1});
        found.insert(found.end(), point, point + 3);
    }
    return found;
}

// Whether the file's word makes the curve periodic; its points and its domain never change.
bool becomes_periodic(int degree, const std::vector<double> &knots, const std::vector<double> &plane,
                      const std::vector<double> &weights) {
    const nrb::SplinePtr made = read_one(126, closed(degree, knots, plane, weights, "1"));
    const nrb::SplinePtr plain = read_one(126, closed(degree, knots, plane, weights, "0"));
    EXPECT_FALSE(plain->axis(0).periodic());
    EXPECT_EQ(places(*made), places(*plain));
    return made->axis(0).periodic();
}

const std::vector<double> quarters{0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4};
const std::vector<double> octagon{1, 0, 1, 1, 0, 1, -1, 1, -1, 0, -1, -1, 0, -1, 1, -1, 1, 0};
const double half_root = std::sqrt(0.5);
const std::vector<double> of_circle{1, half_root, 1, half_root, 1, half_root, 1, half_root, 1};

TEST(IgesCurve, closed_curves_become_periodic_where_the_file_says_so) {
    const std::vector<double> even(9, 1);
    EXPECT_TRUE(becomes_periodic(2, quarters, octagon, of_circle));
    EXPECT_TRUE(becomes_periodic(2, {0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 7, 7}, octagon, even));
    EXPECT_TRUE(becomes_periodic(1, {0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 8}, octagon, even));
    EXPECT_TRUE(
        becomes_periodic(2, {-9, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 7}, octagon, of_circle)); // of no influence
    EXPECT_TRUE(becomes_periodic(8, {0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1}, octagon, even));
}

TEST(IgesCurve, closed_curves_are_wrapped_with_the_seam_as_a_knot) {
    const nrb::SplinePtr spline = read_one(126, closed(2, quarters, octagon, of_circle, "1"));
    EXPECT_EQ(spline->count(0), 10);
    EXPECT_EQ(knots_of(*spline), (std::vector<double>{-1, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5}));
    EXPECT_EQ(spline->weights()[9], half_root);
    EXPECT_EQ(spline->axis(0).distinct_layers(), 8);
}

TEST(IgesCurve, curves_that_are_not_closed_bit_for_bit_do_not) {
    std::vector<double> open = octagon, heavy = of_circle;
    open.back() = 0x1p-60;
    heavy.back() = 1.5;
    EXPECT_FALSE(becomes_periodic(2, quarters, open, of_circle));
    EXPECT_FALSE(becomes_periodic(2, quarters, octagon, heavy));
    EXPECT_FALSE(becomes_periodic(2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 5, 6}, octagon, of_circle));
}

// A seam of multiplicity 2 in degree 3: two layers wrap, and knots beyond the domain repeat, or do not.
TEST(IgesCurve, partly_wrapped_curves) {
    const std::vector<double> plane{0, 0, 2, 1, 3, 4, 0, 5, -2, 2, 0, 0, 2, 1}, even(7, 1);
    EXPECT_TRUE(becomes_periodic(3, {-1, -0.5, 0, 0, 1, 2, 3.5, 4, 4, 5, 6}, plane, even));
    EXPECT_FALSE(becomes_periodic(3, {-1, -0.25, 0, 0, 1, 2, 3.5, 4, 4, 5, 6}, plane, even));
    EXPECT_FALSE(becomes_periodic(3, {-1, -0.5, 0, 0, 1, 2, 3.5, 4, 4, 5.5, 6}, plane, even));
}

// Knots whose copies a period away overflow, so that they cannot be wrapped.
TEST(IgesCurve, closed_curves_that_cannot_be_wrapped) {
    EXPECT_FALSE(becomes_periodic(1, {-8e307, -8e307, 0, 8e307, 8e307}, {0, 0, 1, 1, 0, 0}, {1, 2, 1}));
}

TEST(IgesCurve, a_cut_curve_is_not_periodic) {
    const nrb::SplinePtr spline = read_one(126, loop("1", 1, "3.5,7"));
    EXPECT_FALSE(spline->axis(0).periodic());
    EXPECT_EQ(spline->axis(0).domain().lower, 3.5);
    EXPECT_EQ(spline->axis(0).domain().upper, 7.0);
}

// Counts (3, 2), degrees (2, 1). In the file the first index runs fastest; point (i, j) is (i, j, 10 i + j),
// its weight 1 + i + j / 2.
std::string patch(const std::string &properties = "0,0,0,0,0", const std::string &ranges = "0,1,0,2",
                  bool rational = true) {
    std::vector<double> weights;
    std::vector<double> points;
    for (int j = 0; j < 2; ++j) {
        for (int i = 0; i < 3; ++i) {
            weights.push_back(rational ? 1 + i + 0.5 * j : 1);
            points.insert(points.end(), {1.0 * i, 1.0 * j, 10.0 * i + j});
        }
    }
    return "2,1,2,1," + properties + "," + list({0, 0, 0, 1, 1, 1}) + "," + list({0, 0, 2, 2}) + "," +
           list(weights) + "," + list(points) + "," + ranges;
}

TEST(IgesSurface, the_last_axis_runs_fastest) {
    const nrb::SplinePtr spline = read_one(128, patch());
    ASSERT_NE(spline, nullptr);
    EXPECT_EQ(spline->axes(), 2);
    EXPECT_EQ(spline->axis(0).degree(), 2);
    EXPECT_EQ(spline->axis(1).degree(), 1);
    EXPECT_EQ(knots_of(*spline, 0), (std::vector<double>{0, 0, 0, 1, 1, 1}));
    EXPECT_EQ(knots_of(*spline, 1), (std::vector<double>{0, 0, 2, 2}));
    EXPECT_EQ(points_of(*spline),
              (std::vector<double>{0, 0, 0, 0, 1, 1, 1, 0, 10, 1, 1, 11, 2, 0, 20, 2, 1, 21}));
    EXPECT_EQ(std::vector<double>(spline->weights().begin(), spline->weights().end()),
              (std::vector<double>{1, 1.5, 2, 2.5, 3, 3.5}));
}

TEST(IgesSurface, ranges_cut_their_own_axis) {
    const nrb::SplinePtr spline = read_one(128, patch("0,0,1,0,0", "0,1,0.5,1", false));
    EXPECT_EQ(knots_of(*spline, 0), (std::vector<double>{0, 0, 0, 1, 1, 1}));
    EXPECT_EQ(knots_of(*spline, 1), (std::vector<double>{0.5, 0.5, 1, 1}));
    EXPECT_EQ(points_of(*spline), (std::vector<double>{0, 0.25, 0.25, 0, 0.5, 0.5, 1, 0.25, 10.25, 1, 0.5,
                                                       10.5, 2, 0.25, 20.25, 2, 0.5, 20.5}));
    EXPECT_EQ(knots_of(*read_one(128, patch("0,0,1,0,0", "0.5,1,0,2")), 0),
              (std::vector<double>{0.5, 0.5, 0.5, 1, 1, 1}));
}

// A tube of degrees (1, 2), periodic along v: four distinct points around, two rings.
std::string tube(const std::string &properties, double copied_weight = 1) {
    const double ring[][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 0}, {0, 1}};
    std::vector<double> weights;
    std::vector<double> points;
    for (int j = 0; j < 6; ++j) {
        for (int i = 0; i < 2; ++i) {
            const bool copied = j == 5 && i == 1;
            weights.push_back(copied ? copied_weight : (j % 4 == 0 ? 2 : 1));
            points.insert(points.end(), {ring[j][0], ring[j][1], 1.0 * i});
        }
    }
    return "1,5,1,2," + properties + "," + list({0, 0, 1, 1}) + "," + list({0, 1, 2, 3, 4, 5, 6, 7, 8}) +
           "," + list(weights) + "," + list(points) + ",0,1,2,6";
}

TEST(IgesSurface, periodic_by_axis) {
    const nrb::SplinePtr spline = read_one(128, tube("0,1,0,0,1"));
    EXPECT_FALSE(spline->axis(0).periodic());
    EXPECT_TRUE(spline->axis(1).periodic());
    EXPECT_FALSE(read_one(128, tube("0,1,0,1,0"))->axis(1).periodic());
    EXPECT_FALSE(read_one(128, tube("0,1,0,0,1", 1.5))->axis(1).periodic());
    EXPECT_FALSE(read_one(128, tube("0,1,0,1,1"))->axis(0).periodic());
}

// A square tube of degrees (1, 1), clamped and closed along v, and along u if its rings are equal.
std::string box(double height, const std::string &properties) {
    const double ring[][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 0}};
    std::vector<double> points;
    for (const auto &corner : ring) {
        for (const double z : {0.0, height, 0.0}) {
            points.insert(points.end(), {corner[0], corner[1], z});
        }
    }
    return "2,4,1,1," + properties + "," + list({0, 0, 1, 2, 2}) + "," + list({0, 0, 1, 2, 3, 4, 4}) + "," +
           list(std::vector<double>(15, 1)) + "," + list(points) + ",0,2,0,4";
}

TEST(IgesSurface, closed_axes_become_periodic_one_by_one) {
    for (const auto &[flags, u, v] :
         {std::tuple("1,1,0,1,1", true, true), std::tuple("1,1,0,1,0", true, false),
          std::tuple("1,1,0,0,1", false, true)}) {
        const nrb::SplinePtr spline = read_one(128, box(3, flags));
        EXPECT_EQ(spline->axis(0).periodic(), u) << flags;
        EXPECT_EQ(spline->axis(1).periodic(), v) << flags;
        EXPECT_EQ(points_of(*spline), points_of(*read_one(128, box(3, "1,1,0,0,0")))) << flags;
        EXPECT_EQ(knots_of(*spline, 0),
                  u ? (std::vector<double>{-1, 0, 1, 2, 3}) : (std::vector<double>{0, 0, 1, 2, 2}));
    }
}

struct Bad {
    const char *data;
    nrb::Status reason;
    const char *words;
};

TEST(IgesCurve, each_defect_has_its_status) {
    const Bad cases[] = {
        {"1,1,0,0,1,0,0.,0.,1.,1.,1.,1.,1.,2.,3.,4.,6.", nrb::Status::syntax, "need 12 parameters"},
        {"1000000000000,1,0,0,1,0,0.,0.,1.,1.", nrb::Status::count, "1000000000000"},
        {"9223372036854775807,1,0,0,1,0,0.,0.,1.,1.", nrb::Status::count, "9223372036854775807"},
        {"-1,1,0,0,1,0,0.,0.,1.,1.", nrb::Status::count, "-1"},
        {"1,32,0,0,1,0,0.,0.,1.,1.", nrb::Status::degree, "32"},
        {"1,-1,0,0,1,0,0.,0.,1.,1.", nrb::Status::degree, "-1"},
        {"1,2,0,0,1,0,0.,0.,1.,1.", nrb::Status::too_few_points, "2"},
        {"1,1,0,0,1,0,0.,1.,0.5,1.,1.,1.,1.,2.,3.,4.,6.,8.,0.,1.,0.,0.,1.", nrb::Status::knots_decreasing,
         "knots[2] = 0.5"},
        {"1,1,0,0,1,0,0.,0.,0.,0.,1.,1.,1.,2.,3.,4.,6.,8.,0.,1.,0.,0.,1.", nrb::Status::empty_domain,
         "knots[1]"},
        {"3,1,0,0,1,0,0.,0.,0.,1.,1.,1.,1.,1.,1.,1.,0.,0.,0.,0.,0.,0.,0.,0.,0.,0.,0.,0.,0.,1.,0.,0.,1.",
         nrb::Status::end_multiplicity, "knots[2]"},
        {"1,1,0,0,0,0,0.,0.,1.,1.,1.,-1.,1.,2.,3.,4.,6.,8.,0.,1.,0.,0.,1.", nrb::Status::weight_negative,
         "weights[1]"},
        {"1,1,0,0,0,0,0.,0.,1.,1.,0.,0.,1.,2.,3.,4.,6.,8.,0.,1.,0.,0.,1.", nrb::Status::weights_vanish,
         "weights"},
        {"1,1,0,0,0,0,0.,0.,1.,1.,1.,0.,1.,2.,3.,4.,6.,8.,0.,1.,0.,0.,1.", nrb::Status::weights_vanish,
         "weights"},
        {"1,1,0,0,1,0,0.,0.,1.,1.,1.,1.,1.,abc,3.,4.,6.,8.,0.,1.,0.,0.,1.", nrb::Status::syntax,
         "points[0] (parameter 15) is 'abc'"},
        {"1,1,0,0,1,0,0.,0.,nan,1.,1.,1.,1.,2.,3.,4.,6.,8.,0.,1.,0.,0.,1.", nrb::Status::syntax,
         "knots[2] (parameter 10) is 'nan'"},
        {"1,1,0,0,1,0,0.,0.,1.,1.,1.,1.E999,1.,2.,3.,4.,6.,8.,0.,1.,0.,0.,1.", nrb::Status::syntax,
         "weights[1]"},
        {"1,1,0,0,1,0,0.,0.,1.,1.,1.,1.,1.,2.,3.,4.,6.,8.,0.,x,0.,0.,1.", nrb::Status::syntax, "V[1]"},
        {"1,1,0,0,1,0,0.,0.,1.,1.,1.,999H1.,1.,2.", nrb::Status::syntax, "a string of 999 characters"},
        {"one,1,0,0,1,0,0.,0.,1.,1.", nrb::Status::syntax, "K (parameter 2) is 'one'"},
    };
    for (const Bad &bad : cases) {
        const nrb::model::Note note = note_of(126, bad.data);
        EXPECT_EQ(note.reason, bad.reason) << bad.data << "\n" << note.text;
        EXPECT_NE(note.text.find(bad.words), std::string::npos) << note.text;
        EXPECT_NE(note.text.find("(126) at directory line 1: "), std::string::npos) << note.text;
        EXPECT_EQ(note.entity_type, 126);
        EXPECT_EQ(note.line, 1);
    }
}

TEST(IgesSurface, each_defect_has_its_status) {
    const Bad cases[] = {
        {"1,1,1,1,0,0,1,0,0,0.,0.,1.,1.,0.,0.,1.,1.,1.,1.,1.,1.,0.,0.", nrb::Status::syntax,
         "need 24 parameters"},
        {"8,8,1,1,0,0,1,0,0,0.,0.,1.,1.,0.,0.,1.,1.,1.,1.,1.,1.,0.,0.", nrb::Status::syntax,
         "need 346 parameters"},
        {"4000000000,4000000000,1,1,0,0,1,0,0", nrb::Status::count, "4000000000"},
        {"1,1,1,40,0,0,1,0,0,0.,0.,1.,1.,0.,0.,1.,1.,1.,1.,1.,1.,0.,0.", nrb::Status::degree, "40"},
        {"1,1,1,2,0,0,1,0,0,0.,0.,1.,1.,0.,0.,1.,1.,1.,1.,1.,1.,0.,0.", nrb::Status::too_few_points, "2"},
        {"1,1,1,1,0,0,1,0,0,0.,0.,1.,1.,0.,0.,-1.,1.,1.,1.,1.,1.,0.,0.,0.,0.,0.,0.,0.,0.,0.,0.,0.,0.,0.,1.,0."
         ",1.",
         nrb::Status::knots_decreasing, "axis 1"},
    };
    for (const Bad &bad : cases) {
        const nrb::model::Note note = note_of(128, bad.data);
        EXPECT_EQ(note.reason, bad.reason) << bad.data << "\n" << note.text;
        EXPECT_NE(note.text.find(bad.words), std::string::npos) << note.text;
        EXPECT_NE(note.text.find("(128) at directory line 1: "), std::string::npos) << note.text;
    }
}

// Coordinates that overflow only when they are converted.
TEST(IgesCurve, conversion_that_overflows) {
    IgesBuilder builder;
    builder.global(14, "7").add(126, "1,1,0,0,1,0,0.,0.,1.,1.,1.,1.,1.,2.,3.,4.E307,6.,8.,0.,1.,0.,0.,1.");
    const nrb::model::Model document = read(builder, {.unit = 0.001});
    ASSERT_EQ(document.notes.size(), 1U);
    EXPECT_EQ(document.notes.front().reason, nrb::Status::point_not_finite);
}

} // namespace

} // namespace spline_test
