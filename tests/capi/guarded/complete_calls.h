/* SPDX-License-Identifier: MIT */
#ifndef NURBS_TESTS_CAPI_GUARDED_COMPLETE_CALLS_H
#define NURBS_TESTS_CAPI_GUARDED_COMPLETE_CALLS_H

#include "calls/calls.h"

namespace calls {

// Calls that want every output and leave no input out, of the functions whose other calls do not.
std::vector<std::span<const Call>> complete_calls();

} // namespace calls

#endif
