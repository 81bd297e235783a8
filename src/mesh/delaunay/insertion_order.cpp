// SPDX-License-Identifier: MIT
#include "mesh/delaunay/insertion_order.h"

#include "base/error.h"
#include "base/watch.h"
#include "mesh/delaunay/triangle_net.h"

#include <algorithm>
#include <numeric>

namespace nrb::mesh {

namespace {

constexpr int64_t work_of_a_key = 100; // including its share of the sorting

struct Keyed {
    uint64_t key;
    int32_t point;
};

// The position along the Hilbert curve through 2^31 times 2^31 points: two bits for each level, from the
// coarsest quarters to the finest ones, each turned so that the curve enters it where it left the one before.
uint64_t hilbert_key(const GridPoint &point) noexcept {
    auto u = static_cast<uint32_t>(point.u), v = static_cast<uint32_t>(point.v);
    uint64_t key = 0;
    for (int level = 30; level >= 0; --level) {
        const uint32_t right = u >> level & 1, upper = v >> level & 1;
        key = key << 2 | ((3 * right) ^ upper);
        // The lower quarters are mirrored at a diagonal; without branches, which would be unpredictable.
        const uint32_t mirrored = upper - 1, opposite = mirrored & (0 - right);
        const uint32_t swapped = (u ^ v) & mirrored;
        u ^= swapped ^ opposite;
        v ^= swapped ^ opposite;
    }
    return key;
}

std::vector<Keyed> sorted_keys(std::span<const GridPoint> points) {
    std::vector<Keyed> keys;
    keys.reserve(points.size());
    for (const GridPoint &point : points) {
        keys.push_back({hilbert_key(point), static_cast<int32_t>(keys.size())});
        count_work(work_of_a_key);
    }
    std::sort(keys.begin(), keys.end(), [](const Keyed &a, const Keyed &b) { return a.key < b.key; });
    return keys;
}

} // namespace

DistinctPoints distinct_points(std::span<const GridPoint> points) {
    if (points.size() > size_t{TriangleNet::most_vertices}) {
        fail(Status::overflow, "%zu points exceed the %d vertices of a triangulation", points.size(),
             TriangleNet::most_vertices);
    }
    DistinctPoints distinct;
    distinct.points.reserve(points.size());
    distinct.place.resize(points.size());
    for (const Keyed &next : sorted_keys(points)) {
        const GridPoint &point = points[static_cast<size_t>(next.point)];
        if (distinct.points.empty() || distinct.points.back() != point) {
            distinct.points.push_back(point);
        }
        distinct.place[static_cast<size_t>(next.point)] = static_cast<int32_t>(distinct.points.size()) - 1;
    }
    return distinct;
}

std::vector<int32_t> order_in_rounds(int32_t count) {
    std::vector<int32_t> order;
    order.reserve(static_cast<size_t>(count));
    int64_t stride = 1;
    while (stride < count) {
        stride *= 4;
    }
    for (int64_t coarser = 4 * stride; stride > 0; coarser = stride, stride /= 4) {
        for (int64_t i = 0; i < count; i += stride) {
            if (i % coarser != 0 || (i == 0 && order.empty())) {
                order.push_back(static_cast<int32_t>(i));
            }
        }
    }
    return order;
}

} // namespace nrb::mesh
