// SPDX-License-Identifier: MIT
// Polynomials of a piece that its normals and the directions to other places make.
#pragma once

#include "intersect/levels/level_meet.h"
#include "intersect/levels/piece_field.h"

#include <array>
#include <cstddef>
#include <functional>
#include <span>

namespace nrb::intersect {

// A constant.
RoundedPolynomial row_of(const std::array<double, 3> &d);
// w (S - place) in as many dimensions as the place has, in the unit of the piece.
RoundedPolynomial seen_from(const pieces::HomogeneousPiece &piece, std::span<const double> place);

// A bound of the degree of pieces::normal_numerator() on an axis of degree p.
int degree_of_normal(bool weighted, int p) noexcept;

// Where functions of a spline's pieces vanish on a surface with the same pieces, one after the other. Each has the usual limit of
// work.
struct LevelFunction {
    PieceField::Function function, sign;
};
Meet levels_of_functions(const Spline &surface, const Spline &spline, size_t count,
                         const std::function<LevelFunction(size_t i)> &function, double tolerance);

} // namespace nrb::intersect
