// SPDX-License-Identifier: MIT
// Places where the system, or the caller's code, may end the thread.
#pragma once

#include <pthread.h>

namespace nrb::inline base {

// A cancelled thread unwinds by an exception that must not be caught, but the border catches everything. So
// cancellation waits: the thread ends after the call.
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
