// Lists of splines as arguments and as results.
#pragma once

#include "checks.h"

#include <memory>
#include <string>
#include <vector>

namespace nrb::capi {

// "2" for a curve, "2,0" for a surface.
std::string place_name(int64_t index, const std::vector<int64_t> &counts);

// A list of pieces that are numbered along axes, last axis fastest.
void give_list(const std::vector<SplinePtr> &pieces, const std::vector<int64_t> &counts, nurbs_list **out);

// The splines behind an array of at least one handle; `name` is the array's.
std::vector<SplinePtr> splines_of(int64_t count, const nurbs *const *handles, const char *name);

} // namespace nrb::capi
