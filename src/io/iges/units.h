// SPDX-License-Identifier: MIT
// The units of length that IGES has flags for.
#pragma once

#include <cstdint>
#include <string_view>

namespace nrb::io::iges {

struct Unit {
    int64_t flag;
    std::string_view name;
    double metres;
};

// IGES 5.3, table 2. With flag 3 the name determines the unit.
inline constexpr Unit units[] = {{1, "INCH", 0.0254}, {1, "IN", 0.0254},   {2, "MM", 0.001},
                                 {4, "FT", 0.3048},   {5, "MI", 1609.344}, {6, "M", 1},
                                 {7, "KM", 1000},     {8, "MIL", 2.54e-5}, {9, "UM", 1e-6},
                                 {10, "CM", 0.01},    {11, "UIN", 2.54e-8}};
inline constexpr int64_t inch_flag = 1, flag_by_name = 3, metre_flag = 6;

// The first unit with a flag, or null.
constexpr const Unit *unit_of_flag(int64_t flag) noexcept {
    for (const Unit &unit : units) {
        if (unit.flag == flag) {
            return &unit;
        }
    }
    return nullptr;
}

} // namespace nrb::io::iges
