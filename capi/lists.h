// SPDX-License-Identifier: MIT
// Lists of splines as arguments and as results.
#pragma once

#include "checks.h"

#include <vector>

namespace nrb::capi {

// A list of splines named by their places.
void give_list(std::vector<SplinePtr> splines, nurbs_list **out);

void give_list(NamedSplines splines, nurbs_list **out);

// The splines of an array of at least one handle; `name` is the name of the array.
std::vector<SplinePtr> splines_of(int64_t count, const nurbs *const *handles, const char *name);

// All of a list, which is made in `room` where it is not kept so.
const model::Model &contents_of(const nurbs_list *list, model::Model &room);

} // namespace nrb::capi
