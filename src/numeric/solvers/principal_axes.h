// SPDX-License-Identifier: MIT
// Principal component analysis of a set of points.
#pragma once

#include <vector>

namespace nrb::inline numeric {

// Unit vectors, row by row, orthonormal up to rounding: the eigenvectors of the covariance matrix of the
// finite points, in the order of decreasing eigenvalues; right-handed in dimension 3. Cost: linear in the
// number of points, cubic in the dimension.
std::vector<double> principal_axes(const std::vector<double> &points, int dim);

} // namespace nrb::inline numeric
