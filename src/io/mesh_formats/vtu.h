// SPDX-License-Identifier: MIT
// Unstructured grids in the XML format of VTK (VTU): points, and cells of any types over them.
#pragma once

#include "io/mesh_formats/blocks.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace nrb::io::vtu {

enum class NumberType { uint8, int32, int64, float32, float64 };

// Rows of numbers, one after the other. `write` writes all of them as bytes, the same ones at every call.
struct Array {
    std::string name;
    NumberType type;
    int64_t components, rows;
    std::function<void(Blocks &)> write;
    // The attribute of its section that names this array: "Normals", "RationalWeights", "HigherOrderDegrees".
    // Empty: none.
    std::string role{};
};

template <class Number>
constexpr NumberType type_of() {
    if constexpr (sizeof(Number) == 1) {
        return NumberType::uint8;
    } else if constexpr (sizeof(Number) == 4) {
        return static_cast<Number>(0.5) > 0 ? NumberType::float32 : NumberType::int32;
    } else {
        return static_cast<Number>(0.5) > 0 ? NumberType::float64 : NumberType::int64;
    }
}

// An array of numbers that must not move or change before the grid is written.
template <class Number>
Array array_of(std::string name, int64_t components, std::span<const Number> values, std::string role = {}) {
    const auto write = [values](Blocks &out) {
        for (const Number value : values) {
            out.bytes(value);
        }
    };
    return {std::move(name), type_of<Number>(), components, std::ssize(values) / components,
            write,           std::move(role)};
}

// A grid: the arrays of its points and cells.
struct Grid {
    Array points;       // three components
    Array connectivity; // int64: the points of all cells
    Array offsets;      // int64: for each cell, where its points end
    Array types;        // uint8: VTK's numbers for the types of cells
    std::vector<Array> point_data{}, cell_data{};
    // The points of cells of higher order are numbered as in VTK 9, which version 2.2 of the file format
    // says. All other grids are written in version 1.0, which older readers know.
    bool higher_order = false;
};

// VTK's numbers for the types of cells.
inline constexpr uint8_t triangle = 5, hexahedron = 12, bezier_hexahedron = 79;

// The offsets and the types of cells of one type with equally many points.
Array even_offsets(int64_t cells, int64_t points_each);
Array even_types(int64_t cells, uint8_t type);

// Writes the file, in which the arrays follow the XML as raw bytes.
void write(const Grid &grid, Blocks &out);

} // namespace nrb::io::vtu
