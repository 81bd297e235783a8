// SPDX-License-Identifier: MIT
// The directions in which points spread.
#pragma once

#include <vector>

namespace nrb::inline numeric {

// Unit vectors, row by row, orthonormal to rounding: the eigenvectors of the covariance of the points that
// are finite, that of the largest eigenvalue first; in dimension 3 right-handed. Cost: linear in the number
// of points, cubic in the dimension.
std::vector<double> principal_axes(const std::vector<double> &points, int dim);

} // namespace nrb::inline numeric
