// SPDX-License-Identifier: MIT
#include "intersect/rays/ray_tree.h"

#include "base/numbers.h"
#include "base/watch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nrb::intersect {

namespace {

constexpr float unbounded = std::numeric_limits<float>::infinity();

// Rounded outwards to the next float.
float below(double x) noexcept {
    return std::nextafter(static_cast<float>(x), -unbounded);
}
float above(double x) noexcept {
    return std::nextafter(static_cast<float>(x), unbounded);
}

} // namespace

RayTree::RayTree(const pieces::PieceGrid &grid) : grid_(grid) {
    const auto values = static_cast<size_t>(grid.shape().values());
    work_.resize(values);
    values_.resize(values);
    nodes_.reserve(static_cast<size_t>(2 * grid.count()));
    build({0, 0}, {grid.count(0), grid.spline_axes() > 1 ? grid.count(1) : 1});
    work_ = values_ = {};
}

int32_t RayTree::build(std::array<int64_t, 2> lower, std::array<int64_t, 2> upper) {
    const auto place = static_cast<int32_t>(nodes_.size());
    nodes_.emplace_back();
    const size_t axis = upper[0] - lower[0] >= upper[1] - lower[1] ? 0 : 1;
    if (upper[axis] - lower[axis] == 1) {
        set_box(nodes_.back(), grid_.piece({lower[0], lower[1], 0}));
        return place;
    }
    std::array<int64_t, 2> upper_of_first = upper, lower_of_second = lower;
    upper_of_first[axis] = lower_of_second[axis] = (lower[axis] + upper[axis]) / 2;
    build(lower, upper_of_first);
    const int32_t second = build(lower_of_second, upper);
    Node &node = nodes_[static_cast<size_t>(place)];
    const Node &a = at(place + 1), &b = at(second);
    node.right = second;
    for (size_t c = 0; c < 3; ++c) {
        node.lower[c] = std::min(a.lower[c], b.lower[c]);
        node.upper[c] = std::max(a.upper[c], b.upper[c]);
    }
    return place;
}

// The box of the control points; unbounded where weights have no certain sign.
void RayTree::set_box(Node &node, int64_t piece) {
    node.right = static_cast<int32_t>(-1 - piece);
    node.lower.fill(unbounded);
    node.upper.fill(-unbounded);
    const pieces::PatchShape &shape = grid_.shape();
    grid_.patch(piece, work_.data(), values_.data());
    count_work(4 * shape.values());
    const double room = 2 * grid_.moved() + 4 * eps * grid_.radius();
    for (int64_t i = 0; i < shape.coefficients(); ++i) {
        const double *record = values_.data() + i * shape.lanes;
        const double w = record[shape.dim];
        if (grid_.positive() && w == 0) {
            continue; // no control point
        }
        for (size_t c = 0; c < 3; ++c) {
            const double x = record[c] / w;
            const bool certain = grid_.positive() && std::isfinite(x);
            node.lower[c] = std::min(node.lower[c], certain ? below(x - room) : -unbounded);
            node.upper[c] = std::max(node.upper[c], certain ? above(x + room) : unbounded);
        }
    }
}

Interval RayTree::meets(int32_t node, const Ray &ray, double room) const noexcept {
    const Node &box = at(node);
    return slab(box.lower.data(), box.upper.data(), ray, room);
}

const RayTree &ray_tree_of(const Spline &spline) {
    return spline.kept<RayTree>(
        Spline::Cache::rays, [&] { return std::make_shared<const RayTree>(pieces::piece_grid_of(spline)); });
}

} // namespace nrb::intersect
