// Knots of products and raised splines, and the choices among them.
#include "base/numbers.h"
#include "refine/algebra/common_knots.h"
#include "refine/knots/blossom.h"
#include "unit/shapes.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>
#include <random>

namespace common_knots_test {

using namespace nrb;
using namespace shapes;

namespace {

TEST(CommonKnots, counts_copies_by_continuity) {
    const KnotVector quadratic(2, {0, 0, 0, 1, 2, 2, 2}), linear(1, {0, 0, 1.5, 2, 2});
    const refine::CommonKnots joint(3, {&quadratic, &linear}, 0);
    EXPECT_EQ(vector_of(joint.axis()->knots()),
              (std::vector<double>{0, 0, 0, 0, 1, 1, 1.5, 1.5, 1.5, 2, 2, 2, 2}));
}

TEST(CommonKnots, choices_are_all_subsets) {
    refine::CommonKnots::Window window{};
    window.size = 3;
    window.copies = {2, 1, 3};
    double ways = 0;
    int choices = 0;
    refine::for_each_choice(window, 3, [&](const int *chosen, double times) {
        EXPECT_EQ(chosen[0] + chosen[1] + chosen[2], 3);
        ways += times;
        ++choices;
    });
    EXPECT_EQ(ways, binomial(6, 3));
    EXPECT_EQ(choices, 6); // 003 012 102 111 201 210
}

// Clamped knots over [0, 1], inner ones simple.
std::vector<double> clamped_knots(int degree, int spans) {
    std::vector<double> knots(static_cast<size_t>(degree) + 1, 0.0);
    for (int i = 1; i < spans; ++i) {
        knots.push_back(std::pow(i / static_cast<double>(spans), 1.5));
    }
    knots.insert(knots.end(), static_cast<size_t>(degree) + 1, 1.0);
    return knots;
}

// Raising takes means: rows are >= 0 and add up to 1.
TEST(CommonKnots, raising_is_convex) {
    const KnotVector cubic(3, {-1, -0.5, -0.5, 0, 0.1, 0.1, 0.7, 1, 1, 1.5, 2});
    const refine::CommonKnots joint(5, {&cubic}, 0);
    const LayerTable table = joint.raising(0);
    ASSERT_EQ(table.rows(), joint.axis()->count());
    for (int64_t r = 0; r < table.rows(); ++r) {
        const LayerTable::Row &row = table.row(r);
        const double *c = table.coefficients(row);
        EXPECT_TRUE(std::all_of(c, c + row.size, [](double x) { return x >= 0 && x <= 1; }));
        EXPECT_NEAR(row.size == 0 ? 1 : std::accumulate(c, c + row.size, 0.0), 1, 8 * eps);
    }
}

// Knots of a degree that rise by 1 to 3, up to `most` times each; in one period, or not clamped.
KnotVectorPtr random_axis(std::mt19937_64 &random, int degree, int most, bool periodic) {
    std::vector<double> period;
    for (int knot = 0; knot < 24; knot += 1 + static_cast<int>(random() % 3)) {
        period.insert(period.end(), knot == 0 ? 1 : 1 + random() % static_cast<unsigned>(most), knot);
    }
    const auto stored = static_cast<int>(period.size()) + 2 * degree + 1;
    std::vector<double> knots;
    for (int i = -degree; i < stored - degree; ++i) {
        const int count = static_cast<int>(period.size()),
                  turn = i >= 0 ? i / count : -((count - 1 - i) / count);
        knots.push_back(period[static_cast<size_t>(i - turn * count)] + 24 * turn);
    }
    return make_knot_vector(degree, std::move(knots), periodic);
}

TEST(CommonKnots, means_knot_by_knot_are_those_of_all_choices) {
    std::mt19937_64 random(8);
    int windows = 0;
    for (int round = 0; round < 400; ++round) {
        const int p = static_cast<int>(random() % 6), r = p + static_cast<int>(random() % 5);
        const bool periodic = random() % 2 == 0;
        const KnotVectorPtr low = random_axis(random, p, p + 1, periodic);
        const KnotVectorPtr high =
            random_axis(random, r, 1 + static_cast<int>(random() % 3) % (r + 1), periodic);
        const refine::CommonKnots joint(r, {low.get(), high.get()}, 0);
        for (int64_t layer = 0; layer < joint.axis()->count(); ++layer) {
            const auto window = joint.window(layer);
            if (window.size < 2) {
                continue;
            }
            std::vector<double> one, other;
            const int64_t first = joint.mean_of_choices(0, window, one);
            ASSERT_EQ(joint.mean_by_knots(0, window, other), first);
            other.resize(std::max(one.size(), other.size()));
            one.resize(other.size());
            for (size_t i = 0; i < one.size(); ++i) {
                ASSERT_NEAR(one[i], other[i], 3 * (r + 1) * eps * one[i]) << p << " to " << r << ' ' << layer;
            }
            ++windows;
        }
    }
    EXPECT_GT(windows, 10000);
}

// As many choices as there are would take years.
TEST(CommonKnots, raising_takes_choices_together) {
    const KnotVector low(15, clamped_knots(15, 4)), high(31, clamped_knots(31, 40));
    const refine::CommonKnots joint(31, {&low, &high}, 0);
    const LayerTable table = joint.raising(0);
    for (int64_t r = 0; r < table.rows(); ++r) {
        const LayerTable::Row &row = table.row(r);
        const double *c = table.coefficients(row);
        EXPECT_TRUE(std::all_of(c, c + row.size, [](double x) { return x >= 0 && x <= 1; }));
        EXPECT_NEAR(row.size == 0 ? 1 : std::accumulate(c, c + row.size, 0.0), 1, 8 * eps);
    }
}

TEST(BlossomRow, of_knots_is_a_control_point) {
    const KnotVector axis(3, {0, 1, 2, 3, 4, 5, 6, 7});
    const double arguments[] = {3, 5, 4};
    const refine::BlossomRow row = refine::blossom_row(axis, 3, arguments);
    EXPECT_EQ(row.size, 1);
    EXPECT_EQ(row.first, 2);
    EXPECT_EQ(row.coefficients[0], 1);
}

TEST(BlossomRow, is_symmetric_and_affine) {
    const KnotVector axis(2, {0, 0, 0, 1, 3, 3, 3});
    const double ab[] = {1.25, 2}, ba[] = {2, 1.25}, low[] = {1.25, 1}, high[] = {1.25, 3};
    const refine::BlossomRow row = refine::blossom_row(axis, 3, ab),
                             turned = refine::blossom_row(axis, 3, ba);
    const refine::BlossomRow at_low = refine::blossom_row(axis, 3, low),
                             at_high = refine::blossom_row(axis, 3, high);
    const auto coefficient = [](const refine::BlossomRow &r, int64_t layer) {
        return layer < r.first || layer >= r.first + r.size ? 0 : r.coefficients[layer - r.first];
    };
    for (int64_t layer = 1; layer <= 3; ++layer) {
        EXPECT_NEAR(coefficient(row, layer), coefficient(turned, layer), 2 * eps);
        EXPECT_NEAR(coefficient(row, layer), (coefficient(at_low, layer) + coefficient(at_high, layer)) / 2,
                    2 * eps);
    }
}

} // namespace

} // namespace common_knots_test
