// SPDX-License-Identifier: MIT
// The only guard of the border: no exception leaves the library; each becomes a status and a message. A thread that
// ends in a callback passes through, and what it holds is freed on the way.
#pragma once

#include <nurbs/nurbs.h>

namespace nrb::capi {

// Translates the exception being handled, and stores its message for nurbs_last_error(). Call only inside a
// catch block.
nurbs_status translate_exception();

template <class Body>
nurbs_status guard(Body &&body) {
    try {
        body();
        return NURBS_OK;
    } catch (...) {
        return translate_exception();
    }
}

} // namespace nrb::capi
