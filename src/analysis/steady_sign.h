// SPDX-License-Identifier: MIT
// The sign of a determinant of first derivatives where these turn little.
#pragma once

#include "pieces/derivative_pieces.h"

#include <array>

namespace nrb::analysis {

// 1 or -1: the determinant of a plane surface or a volume, or of S_u, S_v and a direction of a surface in space, has
// that sign on the whole piece; 0: this cannot be seen so simply. With the inverse B of the means of the columns D_k,
// the derivatives or their numerators, B D is near the identity. Where every coefficient of each of its columns is less
// than 1 away, in the sum of magnitudes, all columns lie in that range, B D is strictly diagonally dominant, and its
// determinant positive. Cost: linear in the number of coefficients. Precondition: the weight is positive.
int steady_sign(const pieces::HomogeneousPiece &piece, int axes, const std::array<double, 3> &direction);

} // namespace nrb::analysis
