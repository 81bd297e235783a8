// SPDX-License-Identifier: MIT
// The nearest of many triangles: a tree of boxes.
#pragma once

#include "bench/meshes/mesh.h"

#include <algorithm>
#include <numeric>

namespace bench::meshes {

// Over the triangle the height, elsewhere the distance of the nearest side.
inline double distance(const Point &x, const std::array<Point, 3> &corners) {
    const Point normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
    double least = INFINITY;
    bool over = dot(normal, normal) > 0;
    for (size_t k = 0; k < 3; ++k) {
        const Point side = corners[(k + 1) % 3] - corners[k], off = x - corners[k];
        over = over && dot(cross(normal, side), off) >= 0;
        const double square = dot(side, side);
        const double share = square > 0 ? std::clamp(dot(off, side) / square, 0.0, 1.0) : 0;
        least = std::min(least, length(off - share * side));
    }
    return over ? std::min(least, std::fabs(dot(normal, x - corners[0])) / length(normal)) : least;
}

class Triangles {
public:
    explicit Triangles(const Mesh &mesh) : mesh_(mesh), order_(mesh.triangles.size()) {
        std::iota(order_.begin(), order_.end(), size_t{0});
        if (!order_.empty()) {
            divide(0, order_.size());
        }
    }
    // The distance of the nearest one, or that of any that is not farther than `enough`.
    [[nodiscard]] double distance(const Point &x, double enough) const {
        double least = INFINITY;
        search(0, x, enough, least);
        return least;
    }

private:
    struct Node {
        Point lower, upper;
        size_t first, last; // of order_
        size_t second;      // child; the first one is next to the node; 0: a leaf
    };

    [[nodiscard]] std::array<Point, 3> corners(size_t triangle) const {
        return {mesh_.point(triangle, {1, 0, 0}), mesh_.point(triangle, {0, 1, 0}),
                mesh_.point(triangle, {0, 0, 1})};
    }
    [[nodiscard]] Node box(size_t first, size_t last) const {
        Node node{{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}, first, last, 0};
        for (size_t i = first; i < last; ++i) {
            for (const Point &x : corners(order_[i])) {
                for (size_t c = 0; c < 3; ++c) {
                    node.lower[c] = std::min(node.lower[c], x[c]);
                    node.upper[c] = std::max(node.upper[c], x[c]);
                }
            }
        }
        return node;
    }
    void divide(size_t first, size_t last) {
        const size_t own = nodes_.size(), middle = first + (last - first) / 2;
        const Node node = nodes_.emplace_back(box(first, last));
        if (last - first <= 4) {
            return;
        }
        const Point sides = node.upper - node.lower;
        const auto axis = static_cast<size_t>(std::max_element(sides.begin(), sides.end()) - sides.begin());
        const auto place = [&](size_t i) { return mesh_.point(i, {1, 1, 1})[axis]; };
        const auto from = order_.begin();
        std::nth_element(from + static_cast<std::ptrdiff_t>(first),
                         from + static_cast<std::ptrdiff_t>(middle), from + static_cast<std::ptrdiff_t>(last),
                         [&](size_t i, size_t j) { return place(i) < place(j); });
        divide(first, middle);
        nodes_[own].second = nodes_.size();
        divide(middle, last);
    }
    [[nodiscard]] double from_box(size_t node, const Point &x) const {
        double square = 0;
        for (size_t c = 0; c < 3; ++c) {
            const double off = std::max({nodes_[node].lower[c] - x[c], x[c] - nodes_[node].upper[c], 0.0});
            square += off * off;
        }
        return std::sqrt(square);
    }
    void search(size_t at, const Point &x, double enough, double &least) const {
        const Node &node = nodes_[at];
        if (node.second == 0) {
            for (size_t i = node.first; i < node.last && least > enough; ++i) {
                least = std::min(least, meshes::distance(x, corners(order_[i])));
            }
            return;
        }
        std::array<std::pair<double, size_t>, 2> children{std::pair{from_box(at + 1, x), at + 1},
                                                          std::pair{from_box(node.second, x), node.second}};
        std::sort(children.begin(), children.end());
        for (const auto &[off, child] : children) {
            if (least > enough && off < least) {
                search(child, x, enough, least);
            }
        }
    }

    const Mesh &mesh_;
    std::vector<size_t> order_;
    std::vector<Node> nodes_;
};

} // namespace bench::meshes
