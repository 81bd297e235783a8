// SPDX-License-Identifier: MIT
// Polynomials of a piece that its normals and the directions to other places make.
#pragma once

#include "pieces/derivative_pieces.h"

#include <array>
#include <span>

namespace nrb::intersect {

// A constant.
RoundedPolynomial row_of(const std::array<double, 3> &d);
// w (S - place) in as many dimensions as the place has, in the unit of the piece.
RoundedPolynomial seen_from(const pieces::HomogeneousPiece &piece, std::span<const double> place);

// A bound of the degree of pieces::normal_numerator() on an axis of degree p.
int degree_of_normal(bool weighted, int p) noexcept;

} // namespace nrb::intersect
