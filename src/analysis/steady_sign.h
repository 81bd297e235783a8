// SPDX-License-Identifier: MIT
// A cheap sufficient test for the sign of a Jacobian determinant where the derivatives vary little.
#pragma once

#include "pieces/derivative_pieces.h"

#include <array>

namespace nrb::analysis {

// 1 or -1 if the determinant of a plane surface or a volume, or that of S_u, S_v and `direction` for a
// surface in space, has this sign on the whole piece; 0 if the test does not decide. The columns D_k of the
// determinant are the derivatives or their numerators. Let B be the inverse of the matrix of their mean
// coefficients, so that B D is near the identity. If for each k all coefficients of B D_k are less than 1
// away from unit vector k in the sum of magnitudes, so are all values of B D_k, by the convex hull property.
// B D then is strictly diagonally dominant, with a positive diagonal, and its determinant is positive. Cost:
// linear in the number of coefficients. Precondition: the weight is positive.
int steady_sign(const pieces::HomogeneousPiece &piece, int axes, const std::array<double, 3> &direction);

} // namespace nrb::analysis
