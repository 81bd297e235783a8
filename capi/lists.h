// SPDX-License-Identifier: MIT
// Lists of splines as arguments and as results.
#pragma once

#include "checks.h"

#include <string>
#include <vector>

namespace nrb::capi {

// A list of splines, named by their indices.
void give_list(std::vector<SplinePtr> splines, nurbs_list **out);

void give_list(NamedSplines splines, nurbs_list **out);

// The splines of an array of at least one handle; `name` is the name of the array in messages.
std::vector<SplinePtr> splines_of(int64_t count, const nurbs *const *handles, const char *name);

// A buffer for a text, which may be NULL only if its size is 0.
void check_buffer(const char *buf, int64_t cap);
// Copies as much of a text as fits, with a terminating zero if cap > 0, and stores its full length.
void copy_text(const std::string &text, char *buf, int64_t cap, int64_t *length) noexcept;
// The whole contents of a list as a model. `room` stores them if the list does not hold a model.
const model::Model &contents_of(const nurbs_list *list, model::Model &room);

} // namespace nrb::capi
