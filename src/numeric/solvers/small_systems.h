// SPDX-License-Identifier: MIT
// Systems of as many unknowns as a shape has parameters, solved by Eigen.
#pragma once

#include "base/limits.h"

#include <array>
#include <optional>

namespace nrb::inline numeric {

// Of the first n <= max_axes rows and columns; what is after them is 0.
using AxisVector = std::array<double, max_axes>;
using AxisMatrix = std::array<AxisVector, max_axes>;

// The eigenvalues of a symmetric matrix, rising.
AxisVector symmetric_eigenvalues(int n, const AxisMatrix &a);
// (1 + A+)^-1, where A+ is a symmetric matrix A with eigenvalues below 0 replaced by 0.
AxisMatrix inverse_of_positive_part(int n, const AxisMatrix &a);
// None where a pivot of Gauss' elimination with full pivoting counts as 0 to rounding.
std::optional<AxisMatrix> inverse(int n, const AxisMatrix &a);
// The shortest vector of those for which A x is closest to right, directions that A shrinks to rounding left
// out.
AxisVector shortest_solution(int n, const AxisMatrix &a, const AxisVector &right);

} // namespace nrb::inline numeric
