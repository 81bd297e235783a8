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

// Along an axis. Precondition: out.rows has room.
void differences(const CoefficientNet &net, int axis, CoefficientNet &out) noexcept;

// Differences of a net along an axis, times a factor, with an error of each of them before, of every coordinate. The plane is that through
// the means of the corners; a plane has the coefficients of its values at the places of control points, so that what coefficients differ
// from it bounds what the function does.
std::array<Range, 4> ranges_of_differences(const CoefficientNet &net, int axis, double factor, double error,
                                           bool planes) noexcept;

// The four numbers side by side.
inline Four four_of(const Range &range) noexcept {
    return {range.middle, range.u, range.v, range.radius};
}

inline Range range_of(const Four &x) noexcept {
    return {x[0], x[1], x[2], x[3]};
}

} // namespace nrb::mesh
