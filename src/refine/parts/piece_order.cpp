// SPDX-License-Identifier: MIT
#include "refine/parts/piece_order.h"

#include <algorithm>

namespace nrb::refine {

PieceOrder::PieceOrder(std::span<const Axis> axes) {
    const size_t missing = max_axes - axes.size();
    for (size_t k = 0; k < axes.size(); ++k) {
        layers_[missing + k] = axes[k].layers;
        pieces_[missing + k] = axes[k].pieces;
    }
}

int64_t PieceOrder::place_in_net(int64_t row) const noexcept {
    const int64_t j = row % layers_[1], i = row / layers_[1] % layers_[0];
    int64_t piece = row / (layers_[0] * layers_[1]);
    const int64_t last = piece % pieces_[2];
    piece /= pieces_[2];
    const int64_t layer = piece / pieces_[1] * layers_[0] + i;
    return ((layer * pieces_[1] + piece % pieces_[1]) * layers_[1] + j) * pieces_[2] + last;
}

void PieceOrder::take_apart(int width, const double *net, double *pieces) const noexcept {
    const int64_t size = row_length() * width;
    for (int64_t row = 0; row < rows(); ++row) {
        std::copy_n(net + place_in_net(row) * size, size, pieces + row * size);
    }
}

void PieceOrder::put_together(int width, const double *pieces, double *net) const noexcept {
    const int64_t size = row_length() * width;
    for (int64_t row = 0; row < rows(); ++row) {
        std::copy_n(pieces + row * size, size, net + place_in_net(row) * size);
    }
}

} // namespace nrb::refine
