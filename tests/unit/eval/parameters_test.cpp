#include "eval/parameters.h"
#include "evaluation_flags.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <nurbs/nurbs.h>

namespace parameters_test {

namespace {

using nrb::eval::AxisRule;
using nrb::eval::Outside;
using nrb::eval::place;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

TEST(Place, leaves_parameters_inside_alone) {
    for (const Outside outside : {Outside::refuse, Outside::clamp, Outside::extrapolate, Outside::wrap}) {
        EXPECT_EQ(place(0.3, {false, false, outside}, {0, 1}), 0.3);
    }
}

TEST(Place, wraps_onto_the_half_open_domain_of_its_side) {
    const AxisRule right{false, false, Outside::wrap};
    const AxisRule left{true, false, Outside::wrap};
    EXPECT_EQ(place(5.0, right, {2, 5}), 2.0);
    EXPECT_EQ(place(2.0, right, {2, 5}), 2.0);
    EXPECT_EQ(place(5.0, left, {2, 5}), 5.0);
    EXPECT_EQ(place(2.0, left, {2, 5}), 5.0);
    EXPECT_EQ(place(8.5, right, {2, 5}), 2.5);
    EXPECT_EQ(place(-0.5, right, {2, 5}), 2.5);
    EXPECT_EQ(place(3e300, right, {0, 3e-300}), std::fmod(3e300, 3e-300));
}

TEST(Place, wraps_distances_that_overflow) {
    const double t = nrb::eval::place(1.7e308, {false, false, Outside::wrap}, {-1.2e308, -1.1e308});
    EXPECT_GE(t, -1.2e308);
    EXPECT_LT(t, -1.1e308);
}

TEST(Place, gives_na_n_only_where_the_rule_says_so) {
    EXPECT_TRUE(std::isnan(place(2.0, {false, true, Outside::refuse}, {0, 1})));
    EXPECT_TRUE(std::isnan(place(nan_value, {false, true, Outside::clamp}, {0, 1})));
    EXPECT_TRUE(std::isnan(place(infinity, {false, true, Outside::wrap}, {0, 1})));
    EXPECT_EQ(place(infinity, {false, false, Outside::clamp}, {0, 1}), 1.0);
    EXPECT_EQ(place(-7.0, {false, false, Outside::extrapolate}, {0, 1}), -7.0);
}

TEST(DecodeRules, refuses_bits_of_missing_axes_and_contradictions) {
    const auto status = [](uint32_t flags, int axes) {
        try {
            nrb::capi::decode_rules(flags, axes);
        } catch (const nrb::Error &error) {
            return error.status();
        }
        return nrb::Status::ok;
    };
    EXPECT_EQ(status(NURBS_ON_AXIS(1, NURBS_LEFT), 2), nrb::Status::ok);
    EXPECT_EQ(status(NURBS_ON_AXIS(1, NURBS_LEFT), 1), nrb::Status::flags);
    EXPECT_EQ(status(0x20, 1), nrb::Status::flags);
    EXPECT_EQ(status(0x80000000u, 3), nrb::Status::flags);
    EXPECT_EQ(status(NURBS_CLAMP | NURBS_WRAP, 1), nrb::Status::flags);
    EXPECT_EQ(status(NURBS_CLAMP | NURBS_NAN | NURBS_LEFT, 1), nrb::Status::ok);
}

} // namespace

} // namespace parameters_test
