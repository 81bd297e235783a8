// A full circle as a rational quadratic of nine points (Piegl & Tiller 7.5) stays on the circle.
#include "support/cases.h"
#include "support/handle.h"

#include <cmath>
#include <gtest/gtest.h>

namespace circle_test {

using namespace support;

namespace {

SplineData circle(double r) {
    const double h = std::sqrt(0.5);
    return {{2},
            {9},
            {{0, 0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1, 1}},
            2,
            {r, 0, r, r, 0, r, -r, r, -r, 0, -r, -r, 0, -r, r, -r, r, 0},
            {1, h, 1, h, 1, h, 1, h, 1},
            0};
}

// Relative distance from the circle in units of eps; long double carries the squares of doubles to half an
// ulp of its 64 bits.
long double off_circle(double x, double y, double r) {
    const long double radius = std::hypot(static_cast<long double>(x), static_cast<long double>(y));
    return std::fabs(radius - r) / r / 0x1p-52L;
}

TEST(Circle, stays_within_four_eps_of_its_radius) {
    long double worst = 0;
    for (const double r : {1.0, 1e-6, 0.1, 3.7, 1e6, 12345.678}) {
        const auto g = create(circle(r));
        Random random(30000);
        std::vector<double> params;
        for (int i = 0; i < 100000; ++i) {
            params.push_back(random.unit());
        }
        const auto points = eval(g.get(), params);
        for (size_t i = 0; i < params.size(); ++i) {
            const long double off = off_circle(points[2 * i], points[2 * i + 1], r);
            worst = std::max(worst, off);
            ASSERT_LE(off, 4) << "radius " << r << " at " << hex(params[i]);
        }
    }
    std::printf("circle: largest distance %.3Lf eps * radius\n", worst);
}

TEST(Circle, every_knot_is_a_stored_point) {
    const auto g = create(circle(3));
    EXPECT_TRUE(same_bits(eval(g.get(), {0, 0.25, 0.5, 0.75, 1}), {3, 0, 0, 3, -3, 0, 0, -3, 3, 0}));
}

} // namespace

} // namespace circle_test
