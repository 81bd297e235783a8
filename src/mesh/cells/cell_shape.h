// SPDX-License-Identifier: MIT
// Estimates of how far the two triangles of a cell are from the surface, and how a cell is best cut.
#pragma once

#include "mesh/proof/hessian_box.h"

#include <optional>

namespace nrb::mesh {

// How the surface bends over a cell, as an estimate for decisions, not for proofs. Parameters are measured by
// the sides of the cell; second derivatives are those of homogeneous coordinates, divided by the least
// weight.
struct CellBend {
    Hessian heights; // second derivatives of the heights over the plane of the cell
    // How far, in the plane, images of the sides along each axis are beside them.
    std::array<double, 2> beside{};
    std::array<double, 2> speeds{}; // approximate lengths of the sides
    // By how much the slopes along both sides change along the first side, and then along the second one.
    std::array<double, 4> slopes{};
    bool alone = false; // whether the help of neighbouring triangles is not to be counted on

    // The deviation if the cell is divided into a grid of so many parts along the axes.
    [[nodiscard]] double in_parts(double u_parts, double v_parts) const noexcept;
    [[nodiscard]] double with_out(double height, double u, double v) const noexcept;
    [[nodiscard]] double slope(double u, double v) const noexcept;
};

// The homogeneous points (x, y, z, w) at (0, 0), (1, 0), (1, 1) and (0, 1).
using CellCorners = std::array<const double *, 4>;

// An empty box about the first corner, the last axis of which is normal to the plane of the corners.
HessianBox box_about(const CellCorners &corners) noexcept;
CellBend bend_of(const HessianBox &box) noexcept;

// How a cell is cut.
struct Cut {
    size_t axis;
    double share;                 // where, as a share of the side
    std::optional<size_t> next{}; // the axis along which both halves are to be cut, if it is known already
};
// The cut of a cell that is not flat enough.
Cut best_cut(const CellBend &bend, double chord) noexcept;

// An estimate of the angle by which the normal turns over a cell. Slopes along an axis on which the surface
// moves by no more than `least` do not count.
struct CellTurn {
    std::array<double, 2> along{}; // on a way along each axis
    double both = 0;               // from any place to any other
};
CellTurn turn_of(const HessianBox &box, double least) noexcept;
// The cut of a cell over which the normal turns by more than the angle.
Cut cut_for_angle(const HessianBox &box, const CellTurn &turn, double angle) noexcept;

} // namespace nrb::mesh
