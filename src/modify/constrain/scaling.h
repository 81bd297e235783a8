// SPDX-License-Identifier: MIT
// Scaled unknowns x = sqrt(cost) e, and the reported sizes of a change.
#pragma once

#include "modify/constrain/equations.h"

namespace nrb::modify {

// The length below which what is left of an equation of length 1 counts as 0: it is rounding of the basis
// functions, which are within 3 p eps of themselves.
double pivot_threshold(const Spline &spline, size_t equations, int64_t unknowns) noexcept;

// Turns scaled unknowns, `width` for each cost, into moves or changes.
void divide_by_root(std::vector<double> &x, const std::vector<double> &costs, size_t width) noexcept;

double length_of(const std::vector<double> &x) noexcept;

// The longest of moves[..][dim].
double largest_move(const std::vector<double> &moves, int dim) noexcept;

// The lengths of the residuals, by conditions.
std::vector<double> lengths(const std::vector<LocalEquations> &all);

} // namespace nrb::modify
