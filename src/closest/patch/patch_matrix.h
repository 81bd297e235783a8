// Matrices and vectors of as many rows as a shape has axes, without memory of their own.
#pragma once

#include "spline/spline.h"

#include <Eigen/Dense>

namespace nrb::closest {

using SmallMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, max_axes, max_axes>;
using SmallVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, max_axes, 1>;

} // namespace nrb::closest
