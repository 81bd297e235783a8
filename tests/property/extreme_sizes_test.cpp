// Distances of shapes whose coordinates come near the limits of double precision: those of the same shape
// near 1, times a power of two, and never a certificate of what is no number.
#include "support/cases.h"
#include "support/generators.h"
#include "support/handle.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace extreme_sizes_test {

using namespace support;

namespace {

SplineData bezier(std::vector<int32_t> degrees, int dim) {
    SplineData data;
    data.degrees = std::move(degrees);
    data.dim = dim;
    for (const int32_t p : data.degrees) {
        data.counts.push_back(p + 1);
        data.knots.emplace_back(static_cast<size_t>(p) + 1, 0.0);
        data.knots.back().insert(data.knots.back().end(), static_cast<size_t>(p) + 1, 1.0);
    }
    return data;
}

// Half a turn about the origin.
SplineData corner() {
    SplineData data = bezier({2}, 2);
    data.points = {1, -1, 1, 1, -1, 1};
    return data;
}

SplineData random_bezier(Random &random, std::vector<int32_t> degrees, int dim, bool rational) {
    SplineData data = bezier(std::move(degrees), dim);
    for (int64_t i = 0; i < data.point_count(); ++i) {
        for (int c = 0; c < dim; ++c) {
            data.points.push_back(random.between(-1, 1));
        }
        if (rational) {
            data.weights.push_back(random.between(0.7, 1.4));
        }
    }
    return data;
}

struct Nearest {
    std::vector<double> params;
    double distance = -1;
    int32_t status = -1;
};

using Search = decltype(nurbs_closest_points);

Nearest nearest(Search *search, const nurbs *g, int axes, const std::vector<double> &point) {
    Nearest found{std::vector<double>(static_cast<size_t>(axes)), -1, -1};
    require_ok(search(g, 1, point.data(), 0, 0, nullptr, 0, 0, found.params.data(), 0, 0, nullptr, 0, 0,
                      &found.distance, 0, &found.status, 0));
    return found;
}

bool certified(int32_t status) {
    return (status & NURBS_CLOSEST_CERTIFIED) != 0;
}

TEST(ExtremeSizes, points_between_huge_control_points_are_evaluated) {
    for (const double size : {8e307, 0x1.fp1022}) {
        const std::vector<double> found = eval(create(scaled(corner(), size)).get(), {0.25, 0.5, 0.75});
        const double expected[] = {0.875, -0.125, 0.5, 0.5, -0.125, 0.875};
        for (size_t i = 0; i < found.size(); ++i) {
            EXPECT_NEAR(found[i] / size, expected[i], 1e-15);
        }
    }
}

TEST(ExtremeSizes, a_corner_of_any_size) {
    const double origin[] = {0, 0};
    for (const double size : {8e307, 1e300, 1.0, 1e-300, 0x1p-1040}) {
        const Handle g = create(scaled(corner(), size));
        const double near = std::sqrt(0.5) * size, far = std::sqrt(2.0) * size;
        const double allowed = 1e-14 * size + 4 * std::numeric_limits<double>::denorm_min();
        EXPECT_NEAR(nearest(nurbs_closest_points, g.get(), 1, {0, 0}).distance, near, allowed);
        EXPECT_TRUE(certified(nearest(nurbs_closest_points, g.get(), 1, {0, 0}).status)) << size;
        EXPECT_NEAR(nearest(nurbs_farthest_points, g.get(), 1, {0, 0}).distance, far, allowed);
        EXPECT_TRUE(certified(nearest(nurbs_farthest_points, g.get(), 1, {0, 0}).status)) << size;
        const double guess = 0.3;
        double distance = -1, distances[3], params[3];
        int32_t status = -1;
        require_ok(nurbs_closest_local(g.get(), 1, origin, 0, 0, &guess, 0, 0, nullptr, 0, 0, nullptr, 0, 0,
                                       &distance, 0, nullptr, 0));
        EXPECT_NEAR(distance, near, allowed);
        require_ok(nurbs_curve_signed_distances(g.get(), 1, origin, 0, 0, 0, 0, &distance, 0, nullptr, 0,
                                                &status, 0));
        EXPECT_NEAR(distance, near, allowed);
        EXPECT_TRUE(certified(status)) << size;
        int64_t count = -1;
        require_ok(nurbs_closest_all(g.get(), origin, nullptr, 0, 0, 3, params, distances, &count, &status));
        ASSERT_EQ(count, 1) << size;
        EXPECT_NEAR(distances[0], near, allowed);
        EXPECT_TRUE(certified(status)) << size;
        require_ok(nurbs_critical_points(g.get(), origin, nullptr, 0, 0, 3, params, distances, nullptr,
                                         &count, &status));
        ASSERT_EQ(count, 3) << size;
        EXPECT_NEAR(distances[0], far, allowed);
        EXPECT_NEAR(distances[1], near, allowed);
        EXPECT_NEAR(distances[2], far, allowed);
    }
}

void check_scaled(uint64_t base, const std::vector<int32_t> &degrees, int dim) {
    for_each_case(base, 10, [&](Random &random, uint64_t seed) {
        const SplineData data = random_bezier(random, degrees, dim, random.chance(50));
        std::vector<double> point;
        for (int c = 0; c < dim; ++c) {
            point.push_back(random.between(-2, 2));
        }
        for (Search *search : {nurbs_closest_points, nurbs_farthest_points}) {
            const Nearest one = nearest(search, create(data).get(), data.axes(), point);
            for (const int exponent : {-1000, -600, 600, 1000, 1020}) {
                std::vector<double> there = point;
                std::for_each(there.begin(), there.end(),
                              [exponent](double &x) { x = std::ldexp(x, exponent); });
                const SplineData large = scaled(data, std::ldexp(1.0, exponent));
                const Nearest found = nearest(search, create(large).get(), data.axes(), there);
                EXPECT_NEAR(std::ldexp(found.distance, -exponent), one.distance, 1e-13)
                    << exponent << where(seed, data);
                EXPECT_EQ(certified(found.status), certified(one.status)) << exponent << where(seed, data);
            }
        }
    });
}

TEST(ExtremeSizes, nearest_points_of_curves_scale) {
    check_scaled(92000, {3}, 3);
}
TEST(ExtremeSizes, nearest_points_of_surfaces_scale) {
    check_scaled(92100, {2, 2}, 3);
}
TEST(ExtremeSizes, nearest_points_of_volumes_scale) {
    check_scaled(92200, {1, 2, 1}, 3);
}

// Of two arcs, whose distance is known to the last bits near 1.
TEST(ExtremeSizes, distances_of_curves_scale) {
    const SplineData arc = corner();
    SplineData line = bezier({1}, 2);
    line.points = {-2, -1, 1, -3};
    const auto between = [&](double size, double &at_least, double &at_most) {
        int32_t status = -1;
        require_ok(nurbs_distance(create(scaled(arc, size)).get(), create(scaled(line, size)).get(), 0, 0,
                                  &at_least, &at_most, nullptr, nullptr, &status));
        EXPECT_TRUE(certified(status)) << size;
    };
    double least = -1, most = -1;
    between(1, least, most);
    EXPECT_LE(most - least, 1e-12);
    for (const int exponent : {-1060, -1030, -1000, -600, 600, 1000, 1021}) {
        double at_least = -1, at_most = -1;
        between(std::ldexp(1.0, exponent), at_least, at_most);
        const double allowed = 1e-12 + std::ldexp(1.0, -1066 - exponent); // underflow
        EXPECT_NEAR(std::ldexp(at_least, -exponent), least, allowed) << exponent;
        EXPECT_NEAR(std::ldexp(at_most, -exponent), most, allowed) << exponent;
    }
}

// A square whose corners are numbers, though their distances from its middle are none: all points are on it.
TEST(ExtremeSizes, patches_whose_lengths_overflow) {
    constexpr double m = 1.7e308;
    SplineData data = bezier({1, 1}, 2);
    data.points = {-m, -m, -m, m, m, -m, m, m};
    const Handle g = create(data);
    for (const double x : {-m, -m / 3, 0.0, m / 2, m}) {
        const Nearest found = nearest(nurbs_closest_points, g.get(), 2, {x, 0.3 * m});
        EXPECT_TRUE(!certified(found.status) || found.distance <= 1e-12 * m) << x << " " << found.distance;
    }
}

// Both ends of the range of double precision are in the box of the shape and the point: distances overflow,
// or nearly.
TEST(ExtremeSizes, nothing_is_certified_that_is_no_number) {
    for_each_case(92300, 40, [&](Random &random, uint64_t seed) {
        const int axes = random.whole(1, 3), dim = random.whole(axes == 1 ? 1 : 2, 3);
        const std::vector<int32_t> degrees(static_cast<size_t>(axes), random.whole(1, 3));
        SplineData data = scaled(random_bezier(random, degrees, dim, random.chance(50)),
                                 random.chance(50) ? 0x1.fp1023 : 0x1p-1060);
        for (double &w : data.weights) { // products with points must not overflow
            w = std::min(w, 1.0);
        }
        std::vector<double> point;
        for (int c = 0; c < dim; ++c) {
            point.push_back(random.between(-1, 1) * (random.chance(50) ? 0x1.fp1023 : 1.0));
        }
        const Handle g = create(data);
        for (Search *search : {nurbs_closest_points, nurbs_farthest_points}) {
            const Nearest found = nearest(search, g.get(), axes, point);
            EXPECT_TRUE(std::isfinite(found.distance) || !certified(found.status)) << where(seed, data);
        }
        std::vector<double> params(64 * static_cast<size_t>(axes)), distances(64);
        int64_t count = 0;
        int32_t status = -1;
        const auto check = [&](nurbs_status done) {
            for (int64_t i = 0; done == NURBS_OK && i < std::min<int64_t>(count, 64); ++i) {
                EXPECT_TRUE(std::isfinite(distances[static_cast<size_t>(i)]) || !certified(status))
                    << where(seed, data);
            }
        };
        check(nurbs_closest_all(g.get(), point.data(), nullptr, 0, 1000, 64, params.data(), distances.data(),
                                &count, &status));
        check(nurbs_critical_points(g.get(), point.data(), nullptr, 0, 1000, 64, params.data(),
                                    distances.data(), nullptr, &count, &status));
        const Handle other = create(scaled(random_bezier(random, {2}, dim, false), 0x1.fp1023));
        double bounds[2] = {0, 0};
        const nurbs_status done =
            nurbs_distance(g.get(), other.get(), 0, 1000, bounds, bounds + 1, nullptr, nullptr, &status);
        EXPECT_TRUE(done != NURBS_OK || !certified(status) ||
                    (std::isfinite(bounds[0]) && std::isfinite(bounds[1])))
            << where(seed, data);
    });
}

} // namespace

} // namespace extreme_sizes_test
