// SPDX-License-Identifier: MIT
// Chooses grid lines along the axes of a volume so that the hexahedra between them approximate it.
#pragma once

#include "mesh/mesh.h"
#include "mesh/volume/piece_bend.h"
#include "spline/part.h"

namespace nrb::mesh {

struct VolumeGrid {
    // Ascending, from end to end of the domain, with all knots among them.
    std::array<std::vector<double>, max_axes> lines;
    double bound = 0;    // on the distance of the volume from its hexahedra at equal parameters
    bool reached = true; // whether all that was asked for is proven

    // The part of the domain of a cell.
    [[nodiscard]] Part cell(const std::array<size_t, max_axes> &at) const noexcept {
        Part ends{};
        for (size_t k = 0; k < ends.size(); ++k) {
            ends[k] = {lines[k][at[k]], lines[k][at[k] + 1]};
        }
        return ends;
    }
};

// If `most` cells do not suffice, lines are farther apart; but no knot is left out.
VolumeGrid volume_grid(const Spline &volume, const MeshRule &rule, int64_t most);

} // namespace nrb::mesh
