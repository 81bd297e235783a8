// SPDX-License-Identifier: MIT
#include "mesh/volume/vtk_order.h"

namespace nrb::mesh {

namespace {

// A part of the border of a cell. For each axis: 0 or 1 for the lower or upper end, or `inner` for all places
// between them.
constexpr int inner = 2;
using Facet = std::array<int, max_axes>;

// Corners go around the lower end of the last axis, then around its upper end. Edges along the first two axes
// follow the corners; those along the last axis are in the order of the corners below them. Sides come in
// pairs, axis by axis.
constexpr std::array<Facet, 2> curve_ends{{{0, 0, 0}, {1, 0, 0}}};
constexpr std::array<Facet, 8> square_border{
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {inner, 0, 0}, {1, inner, 0}, {inner, 1, 0}, {0, inner, 0}}};
constexpr std::array<Facet, 26> cube_border{
    {{0, 0, 0},         {1, 0, 0},         {1, 1, 0},         {0, 1, 0},         {0, 0, 1},
     {1, 0, 1},         {1, 1, 1},         {0, 1, 1},         {inner, 0, 0},     {1, inner, 0},
     {inner, 1, 0},     {0, inner, 0},     {inner, 0, 1},     {1, inner, 1},     {inner, 1, 1},
     {0, inner, 1},     {0, 0, inner},     {1, 0, inner},     {1, 1, inner},     {0, 1, inner},
     {0, inner, inner}, {1, inner, inner}, {inner, 0, inner}, {inner, 1, inner}, {inner, inner, 0},
     {inner, inner, 1}}};

std::span<const Facet> border_of(size_t axes) noexcept {
    switch (axes) {
    case 1:
        return curve_ends;
    case 2:
        return square_border;
    default:
        return cube_border;
    }
}

void add_facet(const Facet &facet, std::span<const int> degrees, std::vector<CellPlace> &places) {
    CellPlace first{}, last{};
    for (size_t k = 0; k < degrees.size(); ++k) {
        first[k] = facet[k] == inner ? 1 : facet[k] * degrees[k];
        last[k] = facet[k] == inner ? degrees[k] - 1 : first[k];
    }
    for (int w = first[2]; w <= last[2]; ++w) {
        for (int v = first[1]; v <= last[1]; ++v) {
            for (int u = first[0]; u <= last[0]; ++u) {
                places.push_back({u, v, w});
            }
        }
    }
}

} // namespace

std::vector<CellPlace> vtk_places(std::span<const int> degrees) {
    std::vector<CellPlace> places;
    for (const Facet &facet : border_of(degrees.size())) {
        add_facet(facet, degrees, places);
    }
    add_facet({inner, inner, inner}, degrees, places);
    return places;
}

} // namespace nrb::mesh
