// Coordinates that go round an axis, against exact arithmetic on every instruction set.
#include "unit/targets.h"

#include "build/surfaces/points_in_rotation.h"
#include "reference/number.h"
#include "support/generators.h"

#include <cmath>

namespace points_in_rotation_test {

using nrb::DoubleDouble;
using nrb::Form;
using nrb::build::PointsInRotation;
using reference::exact;
using reference::Rational;
using support::Random;

namespace {

using RotatingPoints = targets::Targets;

Rational value_of(const DoubleDouble &x) {
    return exact(x.high) + exact(x.low);
}

DoubleDouble random_wide(Random &random) {
    const double high = random.between(-1, 1) * random.magnitude(1e-6, 1e6);
    return DoubleDouble::sum(high, high * 0x1p-54 * random.unit());
}

// Half a unit of rounding of the value, and 2^-100 of what was added.
void expect_rounded_once(double value, const Rational &want, const Rational &size) {
    const Rational error = abs(Rational(exact(value) - want));
    EXPECT_LE(error, Rational(abs(want) * exact(0x1p-53) + size * exact(0x1p-100)));
}

TEST_P(RotatingPoints, values_are_rounded_once) {
    Random random(751000);
    for (int64_t size : {1, 2, 3, 7, 8, 9, 15, 30}) {
        PointsInRotation rotating(size);
        std::vector<DoubleDouble> foot, d, e;
        for (int64_t i = 0; i < size; ++i) {
            foot.push_back(random_wide(random));
            d.push_back(random_wide(random));
            e.push_back(random_wide(random));
            rotating.set(i, foot.back(), d.back(), e.back());
        }
        const double x = random.between(-1, 1), y = random.between(-1, 1);
        std::vector<double> values(static_cast<size_t>(size) + 1, 77);
        rotating.values(x, y, values.data());
        for (size_t i = 0; i < foot.size(); ++i) {
            const Rational f = value_of(foot[i]), u = exact(x) * value_of(d[i]),
                           v = exact(y) * value_of(e[i]);
            expect_rounded_once(values[i], f + u + v, abs(f) + abs(u) + abs(v));
        }
        EXPECT_EQ(values.back(), 77);
    }
}

// A third of a turn about the main diagonal moves the coordinates on by one; so do the directions of
// homogeneous records without weight, and weights stay.
TEST_P(RotatingPoints, records_turn_about_a_line) {
    const DoubleDouble third = DoubleDouble(1) / square_root(DoubleDouble(3)),
                       half_root = square_root(DoubleDouble(3)) / DoubleDouble(2);
    const nrb::build::AxisLine diagonal{{10, 10, 10}, {third, third, third}};
    const auto axis = nrb::make_knot_vector(1, {0, 0, 0.25, 0.5, 1, 1});
    const std::vector<double> points = {11, 12, 13, 10, 10, 10, 13, 11, 12, 7, 8, 9};
    const auto plain = nrb::make_spline({axis}, 3, Form::polynomial, points);
    std::vector<double> values(12);
    PointsInRotation(*plain, diagonal).values(-0.5, half_root.value(), values.data());
    for (size_t i = 0; i < 12; ++i) {
        EXPECT_NEAR(values[i], points[i / 3 * 3 + (i + 2) % 3], 4e-15);
    }
    const auto records =
        nrb::make_spline({axis}, 3, Form::homogeneous, {22, 24, 26, 2, 1, 2, 3, 0, 0, 0, 0, 1, 5, 6, 7, 0.5});
    std::vector<double> turned(16);
    PointsInRotation(*records, diagonal).values(-0.5, half_root.value(), turned.data());
    const double expected[] = {26, 22, 24, 2, 3, 1, 2, 0, 0, 0, 0, 1, 7, 5, 6, 0.5};
    for (size_t i = 0; i < 16; ++i) {
        EXPECT_NEAR(turned[i], expected[i], 8e-15);
        EXPECT_TRUE(i % 4 != 3 || turned[i] == expected[i]);
    }
}

INSTANTIATE_TEST_SUITE_P(All, RotatingPoints, targets::every_target(), targets::target_name);

} // namespace

} // namespace points_in_rotation_test
