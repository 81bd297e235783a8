// SPDX-License-Identifier: MIT
// How much of their random cases the tests run.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace support {

// NURBS_TEST_SCALE (environment, default 1).
inline double scale() {
    const char *text = std::getenv("NURBS_TEST_SCALE");
    return text == nullptr ? 1 : std::strtod(text, nullptr);
}

// That part of `count`, at least 1.
inline int64_t scaled(int64_t count) {
    return std::max<int64_t>(1, static_cast<int64_t>(static_cast<double>(count) * scale()));
}

} // namespace support
