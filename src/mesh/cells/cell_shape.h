// SPDX-License-Identifier: MIT
// How far the two triangles of a cell are about to be from the surface, and into how many parts the cell is best divided.
#pragma once

#include "mesh/proof/hessian_box.h"

#include <optional>

namespace nrb::mesh {

// An estimate, for deciding. Second derivatives along the axes of the cell, divided by its weight: across its plane, and in the plane across
// the sides.
struct CellBend {
    Hessian heights;
    std::array<double, 2> beside{};
    std::array<double, 2> speeds{}; // lengths of the sides, about
    std::array<double, 4>
        slopes{}; // of slopes along both sides what they change by along the first one, and along the second one
    bool alone = false; // where other triangles are not to be counted on

    // The distance of a cell of a grid of so many along the axes.
    [[nodiscard]] double in_parts(double u_parts, double v_parts) const noexcept;
    [[nodiscard]] double with_out(double height, double u, double v) const noexcept;
    [[nodiscard]] double slope(double u, double v) const noexcept;
};

// corners: (x, y, z, w) at (0, 0), (1, 0), (1, 1) and (0, 1).
using CellCorners = std::array<const double *, 4>;

// About the first corner, with the last axis across the plane of the corners.
HessianBox box_about(const CellCorners &corners) noexcept;
CellBend bend_of(const HessianBox &box) noexcept;

// An axis to cut, and where: a share of the side; and the axis along which both halves are to be cut, where that is known already.
struct Cut {
    size_t axis;
    double share;
    std::optional<size_t> next{};
};
Cut best_cut(const CellBend &bend, double chord) noexcept;

// By how much the normal is about to turn over a cell: along each of its axes, and from any place to any other. An axis along which nothing
// moves by more than `least` counts for nothing.
struct CellTurn {
    std::array<double, 2> along{};
    double both = 0;
};
CellTurn turn_of(const HessianBox &box, double least) noexcept;
Cut cut_for_angle(const HessianBox &box, const CellTurn &turn, double angle) noexcept;

} // namespace nrb::mesh
