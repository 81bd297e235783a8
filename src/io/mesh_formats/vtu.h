// SPDX-License-Identifier: MIT
// Unstructured grids as VTK's XML files have them (VTU): points, and cells of any types over them.
#pragma once

#include "io/mesh_formats/blocks.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace nrb::io::vtu {

enum class NumberType { uint8, int32, int64, float32, float64 };

// Rows of numbers, one after the other. `write` puts them all to blocks as bytes, the same ones every time.
struct Array {
    std::string name;
    NumberType type;
    int64_t components, rows;
    std::function<void(Blocks &)> write;
    // What the section names as its own: "Normals", "RationalWeights", "HigherOrderDegrees". Empty: nothing.
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

// Of numbers that stay where they are until the grid is written.
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

// The arrays of points and cells.
struct Grid {
    Array points;       // three components
    Array connectivity; // int64: the points of all cells
    Array offsets;      // int64: of each cell, where its points end
    Array types;        // uint8: VTK's numbers of kinds of cells
    std::vector<Array> point_data{}, cell_data{};
    // Cells of higher order are numbered as VTK 9 does it, which file version 2.2 says; all others are of version 1.0, which
    // older readers know.
    bool higher_order = false;
};

// VTK's numbers of kinds of cells.
inline constexpr uint8_t triangle = 5, hexahedron = 12, bezier_hexahedron = 79;

// Cells of one type with as many points each: their offsets and types.
Array even_offsets(int64_t cells, int64_t points_each);
Array even_types(int64_t cells, uint8_t type);

// The file: arrays follow the XML as raw bytes.
void write(const Grid &grid, Blocks &out);

} // namespace nrb::io::vtu
