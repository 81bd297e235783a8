// SPDX-License-Identifier: MIT
// The order in which VTK stores the points of cells of any degree.
#pragma once

#include "base/limits.h"

#include <array>
#include <span>
#include <vector>

namespace nrb::mesh {

// The indices of a point of a cell along its axes; 0 for missing axes.
using CellPlace = std::array<int, max_axes>;

// For a cell with 1 to 3 axes of degrees >= 1, with degree + 1 points along each: first the corners, then the
// points inside of edges, of sides, and of the cell. Within each of these the first axis is fastest. This is
// the order of Lagrange and Bezier cells since VTK 9 (files of version 2.1 and later); for degree 1 it is
// that of lines, quadrilaterals and hexahedra.
std::vector<CellPlace> vtk_places(std::span<const int> degrees);

// The VTK numbers of cell types.
enum VtkCell : int {
    vtk_hexahedron = 12,
    vtk_bezier_curve = 75,
    vtk_bezier_quadrilateral = 77,
    vtk_bezier_hexahedron = 79
};

// The type of a Bezier cell with so many axes.
constexpr int vtk_bezier_cell(int axes) noexcept {
    constexpr std::array<int, max_axes> cells{vtk_bezier_curve, vtk_bezier_quadrilateral,
                                              vtk_bezier_hexahedron};
    return cells[static_cast<size_t>(axes - 1)];
}

} // namespace nrb::mesh
