// SPDX-License-Identifier: MIT
// Bernstein coefficients of a homogeneous surface piece, and what they say of its second derivatives.
#pragma once

#include "mesh/proof/four.h"
#include "mesh/proof/hessian_box.h"

namespace nrb::mesh {

// Bernstein coefficients [u][v], of a function or of a derivative.
struct CoefficientNet {
    int u, v;
    double *rows;

    [[nodiscard]] double *row(int i, int j) const noexcept {
        return rows + static_cast<size_t>(i * v + j) * 4;
    }
    // From a row to the next one along an axis.
    [[nodiscard]] int step(int axis) const noexcept { return axis == 0 ? 4 * v : 4; }
    [[nodiscard]] Four at(int i, int j) const noexcept { return Four(row(i, j)); }
    void set(int i, int j, const Four &x) const noexcept { x.store(row(i, j)); }
};

// Of second order, along two axes, which may be one. Precondition: out.rows has room.
void second_differences(const CoefficientNet &net, int first, int second, CoefficientNet &out) noexcept;

// Times a factor, with an error of each coefficient before. The plane is that through the means of the corners; a plane has the
// coefficients of its values at the places of control points, so that what coefficients differ from it bounds what the function does.
CoordinateRanges ranges_of(const CoefficientNet &net, double factor, double error, bool planes) noexcept;

// As of a Range, of all coordinates.
inline Four most(const CoordinateRanges &ranges) noexcept {
    return abs(Four(ranges.middle)) + (abs(Four(ranges.u)) + abs(Four(ranges.v))) * 0.5 + Four(ranges.radius);
}

} // namespace nrb::mesh
