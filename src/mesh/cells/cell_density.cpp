// SPDX-License-Identifier: MIT
#include "mesh/cells/cell_density.h"

#include "mesh/cells/cell_shape.h"

#include <algorithm>
#include <cmath>

namespace nrb::mesh {

namespace {

// Along both axes, for steps in space, by the absolute value of the matrix S of second derivatives,
// (S^2 + |det S|) / (tr S^2 + 2 |det S|)^(1/2): what is twisted bends along both axes, though it has straight lines.
std::array<double, 2> curvatures(const CellBend &bend) noexcept {
    const double u = bend.speeds[0], v = bend.speeds[1];
    const double uu = bend.heights.uu.middle / (u * u), uv = bend.heights.uv.middle / (u * v),
                 vv = bend.heights.vv.middle / (v * v), both = std::abs(uu * vv - uv * uv);
    const double all = std::sqrt(uu * uu + 2 * uv * uv + vv * vv + 2 * both);
    const auto along = [&](double own) {
        return all > 0 && all < infinity ? (own * own + uv * uv + both) / all : 0;
    };
    return {along(uu), along(vv)};
}

// The mean over the cells that the border cuts: near poles steps are short, and count for little.
std::array<double, 2> mean_curvatures(const CellTree &tree) {
    std::array<double, 2> sums{}, squares{};
    for (int32_t i = 0; i < std::ssize(tree.cells()); ++i) {
        const Cell &cell = tree.cells()[static_cast<size_t>(i)];
        if (cell.side != Side::border) {
            continue;
        }
        const CellBend bend = bend_of(tree.box(i));
        const std::array<double, 2> sides = tree.rectangle(cell).sides(), own = curvatures(bend);
        for (size_t k = 0; k < 2; ++k) {
            const double square = bend.speeds[k] * bend.speeds[k] * sides[1 - k] / sides[k];
            squares[k] += square;
            sums[k] += own[k] * square;
        }
    }
    const auto mean = [&](size_t k) {
        const double result = sums[k] / squares[k];
        return result < infinity ? result : 0; // of nothing, too
    };
    return {mean(0), mean(1)};
}

} // namespace

// There is one cell at least along all of the domain. A chord of l on a curvature k is k l^2 / 8 away.
std::array<double, 2> cell_density(const CellTree &tree, double chord, double longest) {
    double size = 0;
    for (size_t k = 0; k < 2; ++k) {
        size = std::max(size, tree.speed(k) * (tree.block_ends(k).back() - tree.block_ends(k).front()));
    }
    const double least = 1 / (size * size) + (longest > 0 ? 1 / (longest * longest) : 0);
    const std::array<double, 2> bends = mean_curvatures(tree);
    std::array<double, 2> result{};
    for (size_t k = 0; k < 2; ++k) {
        const double bent = bends[k] / (8 * chord);
        result[k] = tree.speed(k) * std::sqrt((bent < infinity ? bent : 0) + least);
    }
    return result;
}

} // namespace nrb::mesh
