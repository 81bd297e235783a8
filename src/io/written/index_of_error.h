// SPDX-License-Identifier: MIT
// Errors that name what they are about.
#pragma once

#include "base/error.h"

#include <cstddef>

namespace nrb::io {

// What run() returns; "array[index]: " before the messages of what it throws.
template <class Run>
auto named(const char *array, size_t index, const Run &run) {
    try {
        return run();
    } catch (const Error &error) {
        fail(error.status(), "%s[%zu]: %s", array, index, error.what());
    }
}

} // namespace nrb::io
