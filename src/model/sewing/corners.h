// SPDX-License-Identifier: MIT
// The ends of sides, of which those that are near each other are one vertex.
#pragma once

#include "base/disjoint_sets.h"
#include "model/sewing/sides.h"
#include "numeric/vector3.h"

#include <array>
#include <vector>

namespace nrb::model {

class Corners {
public:
    // Ends no farther from each other than the tolerance are one.
    Corners(const std::vector<Side> &sides, double tolerance);

    // The vertex at an end of a side, by the least number of its ends.
    [[nodiscard]] size_t at(size_t side, bool upper) noexcept {
        return classes_.find(2 * side + (upper ? 1 : 0));
    }
    [[nodiscard]] size_t now(size_t vertex) noexcept { return classes_.find(vertex); }
    void join(size_t a, size_t b) noexcept { classes_.join(a, b); }
    // The vertices, and the middle of the ends of each.
    struct Middle {
        size_t vertex;
        Vector3 point;
    };
    [[nodiscard]] std::vector<Middle> middles();

private:
    std::vector<Vector3> ends_; // of each side its start and its end
    DisjointSets classes_;
};

} // namespace nrb::model
