// SPDX-License-Identifier: MIT
// Changes of basis for one polynomial segment over [0, 1], exact except for one final rounding.
#pragma once

#include <cstdint>

namespace nrb::inline basis {

enum class SegmentBasis { power, bernstein, hermite, bspline };

// The largest degree at which all numerators fit into 128 bits.
inline constexpr int max_matrix_degree = 21;

// matrix[i][j], [degree + 1][degree + 1]: coefficient i in the basis `to` is the sum over j of matrix[i][j]
// times coefficient j in the basis `from`. Every entry is a quotient of two integers, rounded once. Hermite
// data are f(0), f'(0), ..., f(1), f'(1), ...; the B-spline segment has the knots -degree, ..., degree + 1.
// Preconditions: 0 <= degree <= max_matrix_degree, odd where hermite occurs. Cost: O(degree^3).
void basis_matrix(SegmentBasis from, SegmentBasis to, int degree, double *matrix) noexcept;

} // namespace nrb::inline basis
