// SPDX-License-Identifier: MIT
// Merges the ends of sides that are near each other into vertices.
#pragma once

#include "base/disjoint_sets.h"
#include "model/sewing/sides.h"
#include "numeric/vector3.h"

#include <array>
#include <vector>

namespace nrb::model {

class Corners {
public:
    // Two ends no farther apart than the tolerance are one vertex, and so are ends that chains of such pairs
    // connect.
    Corners(const std::vector<Side> &sides, double tolerance);

    // The vertex at an end of a side. A vertex is named by the least number among its ends.
    [[nodiscard]] size_t at(size_t side, bool upper) noexcept {
        return classes_.find(2 * side + (upper ? 1 : 0));
    }
    [[nodiscard]] size_t now(size_t vertex) noexcept { return classes_.find(vertex); }
    void join(size_t a, size_t b) noexcept { classes_.join(a, b); }
    // All vertices, each with the mean of its ends.
    struct Middle {
        size_t vertex;
        Vector3 point;
    };
    [[nodiscard]] std::vector<Middle> middles();

private:
    std::vector<Vector3> ends_; // start and end of each side
    DisjointSets classes_;
};

} // namespace nrb::model
