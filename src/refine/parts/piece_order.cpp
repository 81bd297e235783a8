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

template <class Body>
void PieceOrder::for_each_row(Body &&body) const noexcept {
    for (int64_t a = 0; a < pieces_[0]; ++a) {
        for (int64_t b = 0; b < pieces_[1]; ++b) {
            for (int64_t c = 0; c < pieces_[2]; ++c) {
                for (int64_t i = 0; i < layers_[0]; ++i) {
                    const int64_t block = (a * layers_[0] + i) * pieces_[1] + b;
                    for (int64_t j = 0; j < layers_[1]; ++j) {
                        body((block * layers_[1] + j) * pieces_[2] + c);
                    }
                }
            }
        }
    }
}

void PieceOrder::take_apart(int width, const double *net, double *pieces) const noexcept {
    const int64_t size = layers_[2] * width;
    if (same()) {
        std::copy_n(net, pieces_[2] * size, pieces);
        return;
    }
    for_each_row([&](int64_t place) { pieces = std::copy_n(net + place * size, size, pieces); });
}

void PieceOrder::put_together(int width, const double *pieces, double *net) const noexcept {
    const int64_t size = layers_[2] * width;
    if (same()) {
        std::copy_n(pieces, pieces_[2] * size, net);
        return;
    }
    for_each_row([&](int64_t place) {
        std::copy_n(pieces, size, net + place * size);
        pieces += size;
    });
}

} // namespace nrb::refine
