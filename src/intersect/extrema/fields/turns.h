// SPDX-License-Identifier: MIT
// What a scalar spline of several axes does across a stratum.
#pragma once

#include "intersect/extrema/extremum.h"
#include "intersect/extrema/fields/field_box.h"
#include "intersect/extrema/fields/walls.h"

namespace nrb::intersect {

// Along the axes that are fixed.
struct TurnsAcross {
    uint32_t kinds = 0; // minimum and maximum: f turns up or down along some axis
    bool regular =
        false;         // along one axis f goes on as it came, or ends turn both up and down: there is nothing
    bool known = true; // of all axes

    // What a critical place of the stratum is that has these kinds there, 0 on strata that are points; 0: nothing.
    [[nodiscard]] uint32_t together_with(uint32_t on_stratum) const noexcept;
};

TurnsAcross turns_across(const GradientField &field, const Walls &walls, const Stratum &stratum,
                         const PieceIndex &home, const Part &box);

} // namespace nrb::intersect
