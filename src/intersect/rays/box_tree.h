// SPDX-License-Identifier: MIT
// A bounding volume hierarchy: a binary tree of axis-aligned boxes, whatever is in them.
#pragma once

#include "intersect/rays/ray.h"

#include <array>
#include <cstdint>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace nrb::intersect {

struct Box3 {
    std::array<double, 3> lower{infinity, infinity, infinity}, upper{-infinity, -infinity, -infinity};

    void add(const Box3 &other) noexcept;
    void grow(double by) noexcept;
    // The largest magnitude of a coordinate; 0 if that is not finite.
    [[nodiscard]] double magnitude() const noexcept;
    // The longest side.
    [[nodiscard]] double size() const noexcept;
    // The distance of a point from the box; 0 inside.
    [[nodiscard]] double distance(const Vector3 &x) const noexcept;
    [[nodiscard]] bool meets(const Box3 &other) const noexcept;
};

// Boxes are divided at the median of their centres, along the axis on which the centres spread farthest. The
// children of node i are i + 1 and right(i).
class BoxTree {
public:
    BoxTree() = default;
    explicit BoxTree(const std::vector<Box3> &boxes);

    [[nodiscard]] Box3 box() const noexcept { return nodes_.empty() ? Box3{} : nodes_.front().box; }
    // Calls visit(number, where) for the boxes that a ray meets in its range, at the t in `where`; of two
    // children the nearer one comes first. limit() is the largest t that still counts, and may fall. Returns
    // the number of nodes visited.
    template <class Limit, class Visit>
    int64_t walk(const RayQuery &query, Limit &&limit, Visit &&visit) const;
    // Calls visit(number) for the boxes no farther from a point than a distance, in any order.
    template <class Visit>
    void walk_near(const Vector3 &x, double distance, Visit &&visit) const;
    // The same by ascending distance from a point, up to limit(), which may fall. Returns the number of nodes
    // visited.
    template <class Limit, class Visit>
    int64_t walk_from(const Vector3 &x, Limit &&limit, Visit &&visit) const;
    // The same for the boxes that intersect a box, in any order.
    template <class Visit>
    void walk_box(const Box3 &box, Visit &&visit) const;

private:
    struct Node {
        Box3 box;
        int32_t right; // of a leaf: -1 - number
    };
    int32_t build(const std::vector<Box3> &boxes, std::vector<int32_t> &order, size_t first, size_t last);
    template <class Keep, class Visit>
    void walk_kept(Keep &&keep, Visit &&visit) const;

    std::vector<Node> nodes_;
};

template <class Limit, class Visit>
int64_t BoxTree::walk(const RayQuery &query, Limit &&limit, Visit &&visit) const {
    struct Found {
        int32_t node;
        Interval where;
    };
    const Ray ray(query.origin, query.direction);
    const double far = 2 * (largest(query.origin) + box().magnitude());
    const double room = query.off + (query.turned + 8 * eps) * far;
    std::vector<Found> stack;
    const auto look = [&](int32_t node) -> Found {
        const Box3 &box = nodes_[static_cast<size_t>(node)].box;
        return {node, slab(box.lower.data(), box.upper.data(), ray, room)};
    };
    const auto push = [&](const Found &found) {
        const auto [lower, upper] = found.where;
        if (lower <= upper && upper >= query.range.lower && lower <= query.range.upper) {
            stack.push_back(found);
        }
    };
    if (!nodes_.empty()) {
        push(look(0));
    }
    int64_t visits = 0;
    for (; !stack.empty(); ++visits) {
        const Found found = stack.back();
        stack.pop_back();
        if (found.where.lower > limit()) {
            continue;
        }
        const int32_t right = nodes_[static_cast<size_t>(found.node)].right;
        if (right < 0) {
            visit(-1 - right, found.where);
            continue;
        }
        Found near = look(found.node + 1), other = look(right);
        if (other.where.lower < near.where.lower) {
            std::swap(near, other);
        }
        push(other);
        push(near);
    }
    return visits;
}

template <class Keep, class Visit>
void BoxTree::walk_kept(Keep &&keep, Visit &&visit) const {
    std::vector<int32_t> stack;
    if (!nodes_.empty()) {
        stack.push_back(0);
    }
    while (!stack.empty()) {
        const int32_t node = stack.back();
        stack.pop_back();
        const Node &own = nodes_[static_cast<size_t>(node)];
        if (!keep(own.box)) {
            continue;
        }
        if (own.right < 0) {
            visit(-1 - own.right);
            continue;
        }
        stack.push_back(own.right);
        stack.push_back(node + 1);
    }
}

template <class Visit>
void BoxTree::walk_near(const Vector3 &x, double distance, Visit &&visit) const {
    walk_kept([&](const Box3 &box) { return !(box.distance(x) > distance); }, visit);
}

template <class Limit, class Visit>
int64_t BoxTree::walk_from(const Vector3 &x, Limit &&limit, Visit &&visit) const {
    using Found = std::pair<double, int32_t>; // distance and node
    std::priority_queue<Found, std::vector<Found>, std::greater<>> waiting;
    const auto push = [&](int32_t node) {
        waiting.emplace(nodes_[static_cast<size_t>(node)].box.distance(x), node);
    };
    if (!nodes_.empty()) {
        push(0);
    }
    int64_t visits = 0;
    for (; !waiting.empty() && waiting.top().first <= limit(); ++visits) {
        const int32_t node = waiting.top().second, right = nodes_[static_cast<size_t>(node)].right;
        waiting.pop();
        if (right < 0) {
            visit(-1 - right);
            continue;
        }
        push(node + 1);
        push(right);
    }
    return visits;
}

template <class Visit>
void BoxTree::walk_box(const Box3 &box, Visit &&visit) const {
    walk_kept([&](const Box3 &own) { return own.meets(box); }, visit);
}

} // namespace nrb::intersect
