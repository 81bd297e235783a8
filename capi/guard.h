// SPDX-License-Identifier: MIT
// The only guard of the border: nothing thrown inside leaves the library; everything becomes a status and a
// message.
#pragma once

#include <nurbs/nurbs.h>

namespace nrb::capi {

// Translates the exception being handled, and stores its message for nurbs_last_error(). Call only inside a
// catch block.
nurbs_status translate_exception() noexcept;

template <class Body>
nurbs_status guard(Body &&body) noexcept {
    try {
        body();
        return NURBS_OK;
    } catch (...) {
        return translate_exception();
    }
}

} // namespace nrb::capi
