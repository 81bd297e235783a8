// SPDX-License-Identifier: MIT
#include "mesh/cells/cell_density.h"

#include <algorithm>
#include <cmath>

namespace nrb::mesh {

namespace {

// The means of the squared lengths of the sides of the cells that the border cuts, weighted by their areas in
// the domain: near poles, sides along one axis are short, and such cells should count for little.
std::array<double, 2> mean_squares(const CellTree &tree) {
    std::array<double, 2> sums{};
    double areas = 0;
    for (int32_t i = 0; i < std::ssize(tree.cells()); ++i) {
        const Cell &cell = tree.cells()[static_cast<size_t>(i)];
        if (cell.side != Side::border) {
            continue;
        }
        const Rectangle part = tree.rectangle(cell);
        const HessianBox &box = tree.box(i);
        const double area = part.side(0) * part.side(1);
        areas += area;
        for (size_t k = 0; k < 2; ++k) {
            sums[k] += area * box.speed(k) * box.speed(k);
        }
    }
    return {sums[0] / areas, sums[1] / areas};
}

} // namespace

std::array<double, 2> cell_density(const CellTree &tree) {
    std::array<double, 2> lengths{};
    for (size_t k = 0; k < 2; ++k) {
        lengths[k] = tree.speed(k) * (tree.block_ends(k).back() - tree.block_ends(k).front());
    }
    const double width = std::min(lengths[0], lengths[1]);
    const std::array<double, 2> squares = mean_squares(tree);
    std::array<double, 2> result{};
    for (size_t k = 0; k < 2; ++k) {
        result[k] = tree.speed(k) * std::sqrt(1 / squares[k] + 1 / (width * width));
    }
    return result;
}

} // namespace nrb::mesh
