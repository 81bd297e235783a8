// SPDX-License-Identifier: MIT
#include "intersect/rays/box_tree.h"

#include <algorithm>
#include <numeric>

namespace nrb::intersect {

void Box3::add(const Box3 &other) noexcept {
    for (size_t c = 0; c < 3; ++c) {
        lower[c] = std::min(lower[c], other.lower[c]);
        upper[c] = std::max(upper[c], other.upper[c]);
    }
}

void Box3::grow(double by) noexcept {
    for (size_t c = 0; c < 3; ++c) {
        lower[c] -= by;
        upper[c] += by;
    }
}

double Box3::magnitude() const noexcept {
    double most = 0;
    for (size_t c = 0; c < 3; ++c) {
        most = std::max({most, -lower[c], upper[c], lower[c], -upper[c]});
    }
    return std::isfinite(most) ? most : 0;
}

double Box3::size() const noexcept {
    double most = 0;
    for (size_t c = 0; c < 3; ++c) {
        most = std::max(most, upper[c] - lower[c]);
    }
    return most;
}

double Box3::distance(const Vector3 &x) const noexcept {
    const double at[] = {x.x, x.y, x.z};
    double away[3];
    for (size_t c = 0; c < 3; ++c) {
        away[c] = std::max({lower[c] - at[c], at[c] - upper[c], 0.0});
    }
    return length(Vector3{away[0], away[1], away[2]});
}

bool Box3::meets(const Box3 &other) const noexcept {
    bool apart = false;
    for (size_t c = 0; c < 3; ++c) {
        apart = apart || lower[c] > other.upper[c] || upper[c] < other.lower[c];
    }
    return !apart;
}

BoxTree::BoxTree(const std::vector<Box3> &boxes) {
    std::vector<int32_t> order(boxes.size());
    std::iota(order.begin(), order.end(), 0);
    nodes_.reserve(2 * boxes.size());
    if (!boxes.empty()) {
        build(boxes, order, 0, order.size());
    }
}

int32_t BoxTree::build(const std::vector<Box3> &boxes, std::vector<int32_t> &order, size_t first,
                       size_t last) {
    const auto place = static_cast<int32_t>(nodes_.size());
    Node node{{}, -1 - order[first]};
    const auto middle = [&](int32_t i, size_t c) {
        const Box3 &box = boxes[static_cast<size_t>(i)];
        return box.lower[c] / 2 + box.upper[c] / 2;
    };
    std::array<Interval, 3> middles{};
    middles.fill({infinity, -infinity});
    for (size_t i = first; i < last; ++i) {
        node.box.add(boxes[static_cast<size_t>(order[i])]);
        for (size_t c = 0; c < 3; ++c) {
            const double x = middle(order[i], c);
            middles[c] = {std::min(middles[c].lower, x), std::max(middles[c].upper, x)};
        }
    }
    nodes_.push_back(node);
    if (last - first == 1) {
        return place;
    }
    const auto width = [](Interval x) { return x.upper - x.lower; };
    const auto axis = static_cast<size_t>(std::ranges::max_element(middles, {}, width) - middles.begin());
    const size_t half = (first + last) / 2;
    const auto at = [&](size_t i) { return order.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(first), at(half), at(last), [&](int32_t a, int32_t b) {
        return std::pair(middle(a, axis), a) < std::pair(middle(b, axis), b);
    });
    build(boxes, order, first, half);
    const int32_t right = build(boxes, order, half, last);
    nodes_[static_cast<size_t>(place)].right = right;
    return place;
}

} // namespace nrb::intersect
