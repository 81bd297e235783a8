// SPDX-License-Identifier: MIT
// The order in which points become vertices.
#include "mesh/delaunay/insertion_order.h"

#include <algorithm>
#include <cstdlib>
#include <gtest/gtest.h>
#include <random>
#include <vector>

namespace insertion_order_test {

namespace {

using namespace nrb::mesh;

// A Hilbert curve goes from each cell to one beside it.
TEST(InsertionOrder, each_point_of_a_lattice_is_next_to_the_one_before) {
    for (const int levels : {1, 3, 6}) {
        const int32_t cells = 1 << levels, width = grid_end >> levels;
        std::vector<GridPoint> points;
        for (int32_t i = 0; i < cells * cells; ++i) {
            points.push_back({i / cells * width, i % cells * width});
        }
        std::shuffle(points.begin(), points.end(), std::mt19937_64(20261129));
        const DistinctPoints distinct = distinct_points(points);
        ASSERT_EQ(distinct.points.size(), points.size());
        for (size_t i = 1; i < points.size(); ++i) {
            const GridPoint &a = distinct.points[i - 1], &b = distinct.points[i];
            EXPECT_EQ(std::abs(a.u - b.u) + std::abs(a.v - b.v), width);
        }
    }
}

TEST(InsertionOrder, equal_points_have_one_place) {
    const std::vector<GridPoint> points = {
        {3, 4}, {grid_end, grid_end}, {3, 4}, {0, grid_end}, {grid_end, grid_end}};
    const DistinctPoints distinct = distinct_points(points);
    EXPECT_EQ(distinct.points.size(), 3U);
    for (size_t i = 0; i < points.size(); ++i) {
        EXPECT_EQ(distinct.points[static_cast<size_t>(distinct.place[i])], points[i]);
    }
}

// All numbers, and each beginning of the order lies evenly.
TEST(InsertionOrder, rounds_are_evenly_spread) {
    for (const int32_t count : {0, 1, 2, 4, 5, 16, 17, 1000}) {
        std::vector<int32_t> order = order_in_rounds(count);
        for (size_t first = 1; first < order.size(); first *= 4) {
            std::vector<int32_t> some(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(first));
            std::sort(some.begin(), some.end());
            for (size_t i = 1; i < some.size(); ++i) {
                EXPECT_LE(some[i] - some[i - 1], 16 * count / static_cast<int32_t>(first));
            }
        }
        std::sort(order.begin(), order.end());
        ASSERT_EQ(order.size(), static_cast<size_t>(count));
        for (int32_t i = 0; i < count; ++i) {
            EXPECT_EQ(order[static_cast<size_t>(i)], i);
        }
    }
}

} // namespace

} // namespace insertion_order_test
