// SPDX-License-Identifier: MIT
// The exception barrier of the C interface: no exception leaves the library; each becomes a status and a
// message. Only the forced unwinding of a thread that ends in a callback passes through, and frees what the
// call holds.
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
