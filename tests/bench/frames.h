// Points, first derivatives and unit normals of this library: records of four vectors.
#pragma once

#include <cstdint>
#include <nurbs/nurbs.h>

namespace bench {

nurbs_status frames(const nurbs *g, int64_t n, const double *params, double *out);
nurbs_status grid_frames(const nurbs *g, const int64_t *counts, const double *params, double *out);

} // namespace bench
