// Which curves live in the parameter plane of a surface.
#pragma once

#include "io/iges/directory.h"

#include <vector>

namespace nrb::io::iges {

// One flag per directory entry: set by its own status digits, or because a curve on a surface (142), a
// boundary (141) or a composite curve (102) that lies there names it. What cannot be read there marks
// nothing.
std::vector<bool> find_parameter_plane_curves(const Directory &directory, ParameterData &data);

} // namespace nrb::io::iges
