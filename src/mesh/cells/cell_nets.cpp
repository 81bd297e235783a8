// SPDX-License-Identifier: MIT
#include "mesh/cells/cell_nets.h"

#include <algorithm>

namespace nrb::mesh {

CellNets::CellNets(const pieces::PieceGrid &grid)
    : grid_(grid), patch_(static_cast<size_t>(grid.shape().values())), work_(patch_.size()) {
    for (int k = 0; k < grid.shape().axes; ++k) {
        degrees_[static_cast<size_t>(grid.spline_axis(k))] = grid.shape().degree(k);
    }
    values_ = static_cast<size_t>((degrees_[0] + 1) * (degrees_[1] + 1)) * HessianBox::coordinates;
}

// An axis of degree 0 has one layer, which is both of those of degree 1.
void CellNets::extract(int64_t u, int64_t v, double *net) {
    grid_.patch(grid_.piece({u, v, 0}), work_.data(), patch_.data());
    const pieces::PatchShape &shape = grid_.shape();
    std::array<int64_t, 2> steps{0, 0}; // between layers of the patch
    int64_t step = 1;
    for (int k = shape.axes; k-- > 0; step *= shape.degree(k) + 1) {
        steps[static_cast<size_t>(grid_.spline_axis(k))] = step;
    }
    const auto dim = static_cast<size_t>(shape.dim);
    for (int64_t i = 0; i <= degrees_[0]; ++i) {
        for (int64_t j = 0; j <= degrees_[1]; ++j, net += HessianBox::coordinates) {
            const double *record = patch_.data() + (i * steps[0] + j * steps[1]) * shape.lanes;
            net[2] = 0;
            std::copy_n(record, dim, net);
            net[3] = record[dim];
        }
    }
}

// Each division takes a few roundings for each degree, each of the radius.
double CellNets::noise(int divisions) const noexcept {
    return eps * (16 + 4.0 * divisions * (degrees_[0] + degrees_[1])) * grid_.radius();
}

double CellNets::moved() const noexcept {
    return grid_.moved();
}

std::array<const double *, 4> corners_of(const CellNets &nets, const double *net) noexcept {
    const auto row = static_cast<size_t>(nets.degree(1)) * HessianBox::coordinates;
    const double *last = net + static_cast<size_t>(nets.degree(0)) * (row + HessianBox::coordinates);
    return {net, last, last + row, net + row};
}

} // namespace nrb::mesh
