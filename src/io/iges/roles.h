// SPDX-License-Identifier: MIT
// Finds the curves that lie in the parameter plane of a surface.
#pragma once

#include "io/iges/directory.h"

#include <vector>

namespace nrb::io::iges {

// One flag for each directory entry. It is set by the status digits of the entry itself, or because a curve
// on a surface (142), a boundary (141) or a composite curve (102) in a parameter plane refers to it. An
// entity that cannot be read marks nothing.
std::vector<bool> find_parameter_plane_curves(const Directory &directory, ParameterData &data);

} // namespace nrb::io::iges
