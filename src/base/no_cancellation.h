// SPDX-License-Identifier: MIT
// Guards code where the system, or a callback of the caller, may cancel the thread.
#pragma once

#include <pthread.h>

namespace nrb::inline base {

// A cancelled thread unwinds by an exception that must not be swallowed, but the C interface catches every
// exception. So cancellation is deferred: the thread ends after the call.
class NoCancellation {
public:
    NoCancellation() noexcept { pthread_setcancelstate(PTHREAD_CANCEL_DISABLE, &before_); }
    ~NoCancellation() { pthread_setcancelstate(before_, nullptr); }
    NoCancellation(const NoCancellation &) = delete;
    NoCancellation &operator=(const NoCancellation &) = delete;

private:
    int before_ = 0;
};

} // namespace nrb::inline base
