// SPDX-License-Identifier: MIT
// Systems with as many unknowns as a spline has parameters, solved by Eigen.
#pragma once

#include "base/limits.h"

#include <array>
#include <optional>

namespace nrb::inline numeric {

// All functions use the leading n <= max_axes rows and columns; the others are 0 in the results.
using AxisVector = std::array<double, max_axes>;
using AxisMatrix = std::array<AxisVector, max_axes>;

// The eigenvalues of a symmetric matrix, in increasing order.
AxisVector symmetric_eigenvalues(int n, const AxisMatrix &a);
// (1 + A+)^-1, where A+ is the symmetric matrix A with its negative eigenvalues replaced by 0.
AxisMatrix inverse_of_positive_part(int n, const AxisMatrix &a);
// Empty if a pivot of Gaussian elimination with full pivoting is 0 up to rounding.
std::optional<AxisMatrix> inverse(int n, const AxisMatrix &a);
// The shortest x that minimises |A x - right|; directions that A shrinks to the level of rounding are left
// out.
AxisVector shortest_solution(int n, const AxisMatrix &a, const AxisVector &right);

} // namespace nrb::inline numeric
