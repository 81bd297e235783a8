// SPDX-License-Identifier: MIT
// Control nets of the Bezier pieces of a surface over parts of its domain, and bounds of second derivatives
// from them.
#pragma once

#include "mesh/proof/triangle_bound.h"
#include "pieces/tree/piece_grid.h"

#include <cstdint>
#include <vector>

namespace nrb::mesh {

// The pieces [lower, upper) along each axis.
struct PieceRange {
    std::array<int64_t, 2> lower{}, upper{};

    [[nodiscard]] int64_t count(size_t k) const noexcept { return upper[k] - lower[k]; }
    [[nodiscard]] int64_t count() const noexcept { return count(0) * count(1); }
};

// Control nets [u][v] of homogeneous points (x, y, z, w), in the frame of the grid, of pieces or of the parts
// of them that make up a cell. Axes of degree 0 are treated as of degree 1.
class CellNets {
public:
    explicit CellNets(const pieces::PieceGrid &grid);

    [[nodiscard]] const pieces::PieceGrid &grid() const noexcept { return grid_; }

    [[nodiscard]] int degree(size_t k) const noexcept { return degrees_[k]; }
    [[nodiscard]] size_t values() const noexcept { return values_; } // number of doubles of a net
    // The net of a whole piece: [values()].
    void extract(int64_t u, int64_t v, double *net);
    // The net of a piece restricted to a part of the domain.
    void extract(int64_t u, int64_t v, const Rectangle &part, double *net);
    // The interval along axis k that a part and a piece have in common.
    [[nodiscard]] Interval part_of(const Rectangle &part, size_t k, int64_t piece) const noexcept;
    // The pieces that overlap a part.
    [[nodiscard]] PieceRange pieces_in(const Rectangle &part) const noexcept;
    // The bound of second derivatives over a part of the domain, in axes of which the last one is normal to a
    // plane through it. `steps`: as for HessianBox::add().
    [[nodiscard]] HessianBox box(const Rectangle &part, const PieceRange &pieces, bool steps = true);
    // A bound of the rounding error of coefficients after so many divisions, relative to the largest weight.
    [[nodiscard]] double noise(int divisions) const noexcept;

private:
    [[nodiscard]] Rectangle wide_part(const Rectangle &part,
                                      const std::array<int64_t, 2> &piece) const noexcept;

    const pieces::PieceGrid &grid_;
    std::array<int, 2> degrees_{1, 1};
    size_t values_ = 0;
    std::vector<double> patch_, work_, net_;
    std::vector<double> whole_; // the net of the piece that was extracted last
    std::array<int64_t, 2> last_{-1, -1};
};

// The four corners (x, y, z, w) of a net: at (0, 0), (1, 0), (1, 1) and (0, 1).
std::array<const double *, 4> corners_of(const CellNets &nets, const double *net) noexcept;

} // namespace nrb::mesh
