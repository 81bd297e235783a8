// SPDX-License-Identifier: MIT
// How much memory the pieces of a surface and the tree over them take, compared with the control points.
// Small surfaces are left out: some kilobytes do not depend on the size.
#include "closest/patch/patch_locator.h"

#include "unit/shapes.h"

#include <cmath>

#include <gtest/gtest.h>
#include <malloc.h>

namespace tree_memory_test {

using namespace nrb;

namespace {

// Bytes that are allocated at present; 0 where the allocator is not the C library's own.
size_t allocated() {
    const struct mallinfo2 info = mallinfo2();
    return info.uordblks + info.hblkhd;
}

KnotVectorPtr even_axis(int degree, int64_t count) {
    std::vector<double> knots(static_cast<size_t>(degree) + 1, 0);
    const auto spans = static_cast<double>(count - degree);
    for (int64_t i = 1; i < count - degree; ++i) {
        knots.push_back(static_cast<double>(i) / spans);
    }
    knots.insert(knots.end(), static_cast<size_t>(degree) + 1, 1);
    return make_knot_vector(degree, std::move(knots));
}

SplinePtr wavy(int p, int q, int64_t count, bool rational) {
    std::vector<double> points, weights;
    for (int64_t i = 0; i < count; ++i) {
        for (int64_t j = 0; j < count; ++j) {
            const double x = static_cast<double>(i), y = static_cast<double>(j);
            points.insert(points.end(), {x, y, std::sin(x) * std::cos(y)});
            weights.push_back(1 + 0.25 * std::sin(x + y));
        }
    }
    if (!rational) {
        weights.clear();
    }
    return make_spline({even_axis(p, count), even_axis(q, count)}, 3,
                       rational ? Form::rational : Form::polynomial, std::move(points), std::move(weights));
}

// Of the tree that searches look at, relative to the points and weights.
double memory_ratio(const Spline &spline) {
    const size_t before = allocated();
    const closest::PatchTree tree(pieces::piece_tree_of(spline));
    const size_t data = (spline.points().size() + spline.weights().size()) * sizeof(double);
    return static_cast<double>(allocated() - before) / static_cast<double>(data);
}

class TreeMemory : public testing::Test {
protected:
    void SetUp() override {
        if (allocated() == 0) {
            GTEST_SKIP() << "the allocator does not say what it has given out";
        }
    }
};

TEST_F(TreeMemory, of_a_bicubic_surface_is_at_most_12_times_its_data) {
    for (const int64_t count : {20, 30, 50, 60, 66, 80, 100, 200}) {
        EXPECT_LE(memory_ratio(*wavy(3, 3, count, false)), 12) << count;
        EXPECT_LE(memory_ratio(*wavy(3, 3, count, true)), 12) << count;
    }
}

TEST_F(TreeMemory, is_at_most_one_and_a_half_times_all_pieces) {
    for (int p = 1; p <= 7; ++p) {
        for (int q = 1; q <= p; ++q) {
            for (const int64_t count : {20, 30, 80}) {
                const double pieces = (p + 1) * (q + 1);
                EXPECT_LE(memory_ratio(*wavy(p, q, count, false)), 1.5 * pieces)
                    << p << ' ' << q << ' ' << count;
            }
        }
    }
}

} // namespace

TEST_F(TreeMemory, is_not_needed_by_descents) {
    const SplinePtr spline = wavy(3, 3, 50, false);
    const double point[] = {0.3, 0.4, 1}, guess[] = {0.5, 0.5};
    const size_t before = allocated();
    const closest::Locator &locator = closest::locator_of(*spline);
    (void)locator.local(point, guess);
    const size_t descent = allocated() - before;
    (void)locator.nearest({point, nullptr, 0, 0});
    EXPECT_LT(3 * descent, allocated() - before);
}

} // namespace tree_memory_test
