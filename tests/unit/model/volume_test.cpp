// Areas and volumes of parts that are placed in parts, against those of the ellipsoids that balls become.
#include "build/surfaces/quadrics.h"
#include "measure/moments.h"
#include "model/integrals/model_moments.h"
#include "placed_balls.h"
#include "refine/forms/transform.h"

#include <gtest/gtest.h>

namespace model_volume_unit_test {

namespace {

using namespace placed_balls;
using measure::MomentOrder;

constexpr double pi = 3.14159265358979323846;

// First b, then a.
Rows after(const Rows &a, const Rows &b) {
    Rows c{};
    for (size_t i = 0; i < 3; ++i) {
        for (size_t j = 0; j < 4; ++j) {
            c[4 * i + j] = j == 3 ? a[4 * i + 3] : 0;
            for (size_t k = 0; k < 3; ++k) {
                c[4 * i + j] += a[4 * i + k] * b[4 * k + j];
            }
        }
    }
    return c;
}

Rows placement_of(const std::array<Rows, 5> &uses, const std::vector<size_t> &way) {
    Rows all = uses[way[0]];
    for (size_t i = 1; i < way.size(); ++i) {
        all = after(all, uses[way[i]]);
    }
    return all;
}

double determinant_of(const Rows &m) {
    return m[0] * (m[5] * m[10] - m[6] * m[9]) - m[1] * (m[4] * m[10] - m[6] * m[8]) +
           m[2] * (m[4] * m[9] - m[5] * m[8]);
}

// Of the balls under their placements: the integral of x x^T is V (c c^T + r^2 M M^T / 5).
struct Exact {
    double volume = 0;
    std::array<double, 3> first{};
    std::array<std::array<double, 3>, 3> second{};
    void add(const Rows &m) {
        const double own = std::abs(determinant_of(m)) * 4 * pi / 3 * std::pow(radius, 3);
        volume += own;
        for (size_t i = 0; i < 3; ++i) {
            first[i] += own * m[4 * i + 3];
            for (size_t j = 0; j < 3; ++j) {
                double square = 0;
                for (size_t k = 0; k < 3; ++k) {
                    square += m[4 * i + k] * m[4 * j + k];
                }
                second[i][j] += own * (m[4 * i + 3] * m[4 * j + 3] + radius * radius / 5 * square);
            }
        }
    }
    [[nodiscard]] double inertia(size_t i, size_t j) const {
        const auto central = [&](size_t a, size_t b) { return second[a][b] - first[a] * first[b] / volume; };
        return (i == j ? central(0, 0) + central(1, 1) + central(2, 2) : 0) - central(i, j);
    }
};

} // namespace

TEST(PlacedVolume, of_balls_is_that_of_their_images) {
    Numbers random(8);
    for (int trial = 0; trial < 40; ++trial) {
        const std::array<Rows, 5> uses = placements(random, trial % 2 == 0);
        Exact exact;
        for (const std::vector<size_t> &way : ways()) {
            exact.add(placement_of(uses, way));
        }
        const measure::Moments found = volume(balls(uses), MomentOrder::inertia, 1e-12);
        EXPECT_NEAR(found.content, exact.volume, 1e-11 * exact.volume);
        EXPECT_LE(found.openness, 1e-11 * exact.volume);
        for (size_t i = 0; i < 3; ++i) {
            EXPECT_NEAR(found.centroid[i], exact.first[i] / exact.volume, 1e-10);
            for (size_t j = 0; j < 3; ++j) {
                EXPECT_NEAR(found.inertia[3 * i + j], exact.inertia(i, j), 1e-10 * exact.inertia(i, i));
            }
        }
    }
}

// Areas of balls grow by squares; those of ellipsoids are those of the surfaces that were moved.
TEST(PlacedArea, of_balls_is_that_of_their_images) {
    Numbers random(9);
    const SplinePtr ball =
        build::sphere(build::make_placement(3, nullptr, nullptr, nullptr, "centre"), radius, 0);
    for (int trial = 0; trial < 10; ++trial) {
        const bool similar = trial % 2 == 0;
        const std::array<Rows, 5> uses = placements(random, similar);
        double exact = 0;
        for (const std::vector<size_t> &way : ways()) {
            const Rows m = placement_of(uses, way);
            const double matrix[] = {m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]},
                         origin[] = {0, 0, 0};
            const SplinePtr image = refine::transform(*ball, {3, 3, matrix}, origin);
            exact +=
                similar ? 4 * pi * radius * radius * std::pow(std::cbrt(determinant_of(m)), 2)
                        : measure::moments(*image, whole_domain(*image), MomentOrder::content, 1e-12).content;
        }
        const measure::Moments found = area(balls(uses), 1e-12);
        EXPECT_NEAR(found.content, exact, 1e-11 * exact);
        EXPECT_GE(found.error, 0);
        EXPECT_LE(found.error, 1e-10 * exact);
    }
}

// A flat placement leaves no volume, and no way to measure areas by.
TEST(PlacedVolume, of_flat_placements_is_nothing) {
    std::array<Rows, 5> uses{};
    uses.fill({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0});
    EXPECT_EQ(volume(balls(uses), MomentOrder::content, 1e-9).content, 0);
    for (const auto &call : {+[](const Model &m) { return volume(m, MomentOrder::centroid, 1e-9); },
                             +[](const Model &m) { return area(m, 1e-9); }}) {
        try {
            call(balls(uses));
            ADD_FAILURE();
        } catch (const Error &error) {
            EXPECT_TRUE(error.status() == Status::length || error.status() == Status::matrix);
        }
    }
}

} // namespace model_volume_unit_test
