// SPDX-License-Identifier: MIT
// Loops over records of few numbers.
#pragma once

#include <cstdint>
#include <type_traits>

namespace nrb::inline base {

// Calls work(width) with a width up to 4, that of most points, as a constant of the compiler: loops over so many numbers are
// then no loops.
template <class Work>
decltype(auto) with_width(int64_t width, Work &&work) {
    switch (width) {
    case 1:
        return work(std::integral_constant<int64_t, 1>());
    case 2:
        return work(std::integral_constant<int64_t, 2>());
    case 3:
        return work(std::integral_constant<int64_t, 3>());
    case 4:
        return work(std::integral_constant<int64_t, 4>());
    default:
        return work(width);
    }
}

} // namespace nrb::inline base
