// SPDX-License-Identifier: MIT
// Lines along the axes of a volume so dense that hexahedra between them are near it.
#pragma once

#include "mesh/mesh.h"
#include "mesh/volume/piece_bend.h"
#include "spline/part.h"

namespace nrb::mesh {

struct VolumeGrid {
    std::array<std::vector<double>, max_axes>
        lines;        // rising, from end to end of the domain, all knots among them
    double bound = 0; // no point of the volume is farther from that of its hexahedron at the same parameters
    bool reached = true; // all that was asked for is proven

    [[nodiscard]] Part cell(const std::array<size_t, max_axes> &at) const noexcept {
        Part ends{};
        for (size_t k = 0; k < ends.size(); ++k) {
            ends[k] = {lines[k][at[k]], lines[k][at[k] + 1]};
        }
        return ends;
    }
};

// Where fewer than `most` cells would not do, lines are farther apart; but no knot is left out.
VolumeGrid volume_grid(const Spline &volume, const MeshRule &rule, int64_t most);

} // namespace nrb::mesh
