// SPDX-License-Identifier: MIT
// Loops over records of few numbers.
#pragma once

#include <cstdint>
#include <type_traits>

namespace nrb::inline base {

// Calls work(width). Widths up to 4, those of most points, are passed as compile-time constants, so that the
// compiler unrolls the loops over the components.
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
