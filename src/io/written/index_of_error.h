// SPDX-License-Identifier: MIT
// Adds to errors which element of an array they are about.
#pragma once

#include "base/error.h"

#include <cstddef>

namespace nrb::io {

// Returns what run() returns. Errors that it throws get "array[index]: " before their messages.
template <class Run>
auto named(const char *array, size_t index, const Run &run) {
    try {
        return run();
    } catch (const Error &error) {
        fail(error.status(), "%s[%zu]: %s", array, index, error.what());
    }
}

} // namespace nrb::io
