// SPDX-License-Identifier: MIT
// Bernstein coefficients of a homogeneous surface piece, and bounds on its second derivatives from them.
#pragma once

#include "mesh/proof/four.h"
#include "mesh/proof/hessian_box.h"

namespace nrb::mesh {

// Bernstein coefficients [u][v] of a function or one of its derivatives, four numbers each.
struct CoefficientNet {
    int u, v;
    double *rows;

    [[nodiscard]] double *row(int i, int j) const noexcept {
        return rows + static_cast<size_t>(i * v + j) * 4;
    }
    // The distance from a coefficient to the next one along an axis, in doubles.
    [[nodiscard]] int step(int axis) const noexcept { return axis == 0 ? 4 * v : 4; }
    [[nodiscard]] Four at(int i, int j) const noexcept { return Four(row(i, j)); }
    void set(int i, int j, const Four &x) const noexcept { x.store(row(i, j)); }
};

// Differences of neighbouring coefficients along an axis. Precondition: out.rows has room for them.
void differences(const CoefficientNet &net, int axis, CoefficientNet &out) noexcept;

// Ranges of the differences of a net along an axis, times `factor`, for each of the four coordinates. `error`
// bounds the error of a difference before it is multiplied, in every coordinate. `planes`: whether the ranges
// are affine, with the mean of the function as middle and the means of its derivatives as slopes, and not
// constants. An affine function has its values at the Greville abscissae as Bernstein coefficients (linear
// precision), so by the convex hull property the deviations of the coefficients from it bound those of the
// function.
std::array<Range, 4> ranges_of_differences(const CoefficientNet &net, int axis, double factor, double error,
                                           bool planes) noexcept;

// For each coordinate, bounds its distance over the cell from the polynomial of degree 3 that has the affine
// parts of `hessians` as second derivatives and agrees with it at the corners. Precondition: these are the
// planes of ranges_of_differences() for all second differences of the net. Then they do belong to one
// polynomial: both uu.v and uv.u are the mean of a third derivative, and so are vv.u and uv.v; and the mean of
// the mixed derivative is what the corners say.
Four distances_from_cubics(const CoefficientNet &net, const std::array<Hessian, 4> &hessians) noexcept;

// The numbers of a range as lanes.
inline Four four_of(const Range &range) noexcept {
    return {range.middle, range.u, range.v, range.radius};
}

inline Range range_of(const Four &x) noexcept {
    return {x[0], x[1], x[2], x[3]};
}

} // namespace nrb::mesh
