// SPDX-License-Identifier: MIT
#include "io/iges/model/colours.h"

#include "io/iges/types.h"

#include <algorithm>

namespace nrb::io::iges {
namespace {

// Black, red, green, blue, yellow, magenta, cyan, white.
constexpr std::array<std::array<double, 3>, 8> numbered = {
    {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}}};

} // namespace

// Reads a definition, whose values are percentages.
Colours::Colour Colours::read(int64_t pointer) {
    try {
        const Entry &entry = entities_.at(pointer, "colour");
        if (entry.type != colour_type) {
            return std::nullopt;
        }
        Record record = entities_.record(entry);
        std::array<double, 3> colour{};
        for (double &part : colour) {
            part = std::clamp(record.real("red, green, blue") / 100, 0.0, 1.0);
        }
        return colour;
    } catch (const Error &) {
        return std::nullopt;
    }
}

Colours::Colour Colours::of(const Entry &entry) {
    if (entry.colour > 0) {
        return entry.colour <= std::ssize(numbered) ? Colour(numbered[static_cast<size_t>(entry.colour - 1)])
                                                    : std::nullopt;
    }
    if (entry.colour == 0) {
        return std::nullopt;
    }
    const auto known = definitions_.find(-entry.colour);
    return known != definitions_.end() ? known->second : definitions_[-entry.colour] = read(-entry.colour);
}

} // namespace nrb::io::iges
