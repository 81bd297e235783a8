// SPDX-License-Identifier: MIT
#include "mesh/cells/cell_nets.h"

#include "bernstein/de_casteljau.h"
#include "mesh/cells/cell_shape.h"
#include "mesh/proof/four.h"

#include <algorithm>

namespace nrb::mesh {

CellNets::CellNets(const pieces::PieceGrid &grid)
    : grid_(grid), patch_(static_cast<size_t>(grid.shape().values())), work_(patch_.size()) {
    for (int k = 0; k < grid.shape().axes; ++k) {
        degrees_[static_cast<size_t>(grid.spline_axis(k))] = grid.shape().degree(k);
    }
    values_ = static_cast<size_t>((degrees_[0] + 1) * (degrees_[1] + 1)) * HessianBox::coordinates;
}

// Along an axis of degree 0 there is one layer, which is used for both layers of degree 1.
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

Interval CellNets::part_of(const Rectangle &part, size_t k, int64_t piece) const noexcept {
    const auto axis = static_cast<int>(k);
    return {std::max(part.lower[k], grid_.break_at(axis, piece)),
            std::min(part.upper[k], grid_.break_at(axis, piece + 1))};
}

namespace {

// Restricts all coefficients [outer][degree + 1][inner] to a part of [0, 1], as restrict_to() does.
// Precondition: `inner` is a multiple of 4.
void restrict_layers(const AxisLayers &layers, double lower, double upper, double *values) noexcept {
    const int p = layers.degree;
    const auto mix = [&](double *to, double a, const double *x, double b, const double *y) {
        for (int64_t i = 0; i < layers.inner; i += 4) {
            (Four(x + i) * a + Four(y + i) * b).store(to + i);
        }
    };
    const double t = lower / upper, rest = (upper - lower) / upper;
    for (int64_t o = 0; o < layers.outer; ++o) {
        const auto layer = [&](int d) { return values + layers.at(o, d, 0); };
        for (int r = 1; upper < 1 && r <= p; ++r) {
            for (int i = p; i >= r; --i) {
                mix(layer(i), 1 - upper, layer(i - 1), upper, layer(i));
            }
        }
        for (int r = 1; lower > 0 && r <= p; ++r) {
            for (int i = 0; i <= p - r; ++i) {
                mix(layer(i), rest, layer(i), t, layer(i + 1));
            }
        }
    }
}

} // namespace

void CellNets::extract(int64_t u, int64_t v, const Rectangle &part, double *net) {
    if (last_ != std::array<int64_t, 2>{u, v}) {
        whole_.resize(values_);
        extract(u, v, whole_.data());
        last_ = {u, v};
    }
    std::ranges::copy(whole_, net);
    const int64_t row = int64_t{degrees_[1] + 1} * 4;
    for (size_t k = 0; k < 2; ++k) {
        const auto axis = static_cast<int>(k);
        const int64_t piece = k == 0 ? u : v;
        const double from = grid_.break_at(axis, piece), size = grid_.break_at(axis, piece + 1) - from;
        const Interval own = part_of(part, k, piece);
        const double low = (own.lower - from) / size, high = (own.upper - from) / size;
        if (low > 0 || high < 1) {
            restrict_layers(k == 0 ? AxisLayers{1, degrees_[0], row}
                                   : AxisLayers{degrees_[0] + 1, degrees_[1], 4},
                            low, high, net);
        }
    }
}

PieceRange CellNets::pieces_in(const Rectangle &part) const noexcept {
    PieceRange result;
    for (size_t k = 0; k < 2; ++k) {
        const auto axis = static_cast<int>(k);
        result.lower[k] = grid_.find(axis, part.lower[k]);
        result.upper[k] = grid_.find(axis, part.upper[k]) + 1;
        if (result.upper[k] > result.lower[k] + 1 &&
            grid_.break_at(axis, result.upper[k] - 1) == part.upper[k]) {
            --result.upper[k];
        }
    }
    return result;
}

// The overlap of a piece and a part, widened where it is so small that rounding errors would be large
// relative to it.
Rectangle CellNets::wide_part(const Rectangle &part, const std::array<int64_t, 2> &piece) const noexcept {
    Rectangle result;
    for (size_t k = 0; k < 2; ++k) {
        const auto axis = static_cast<int>(k);
        const Interval own = part_of(part, k, piece[k]);
        const double low = grid_.break_at(axis, piece[k]), high = grid_.break_at(axis, piece[k] + 1);
        const double wanted = std::min(high - low, part.side(k)) / 8,
                     lacking = std::max(0.0, wanted - (own.upper - own.lower));
        result.lower[k] = std::max(low, own.lower - lacking);
        result.upper[k] = std::min(high, own.upper + lacking);
    }
    return result;
}

HessianBox CellNets::box(const Rectangle &part, const PieceRange &pieces, bool steps) {
    const bool one = pieces.count() == 1;
    net_.resize(5 * values_);
    CellCorners corners;
    for (size_t c = 0; c < 4; ++c) {
        const bool right = c == 1 || c == 2, top = c >= 2;
        double *net = net_.data() + (one ? 0 : c * values_);
        if (c == 0 || !one) {
            extract(right ? pieces.upper[0] - 1 : pieces.lower[0],
                    top ? pieces.upper[1] - 1 : pieces.lower[1], part, net);
        }
        corners[c] = corners_of(*this, net)[c];
    }
    HessianBox result = box_about(corners);
    double *net = net_.data() + (one ? 0 : 4 * values_);
    for (int64_t u = pieces.lower[0]; u < pieces.upper[0]; ++u) {
        for (int64_t v = pieces.lower[1]; v < pieces.upper[1]; ++v) {
            const Rectangle own = one ? part : wide_part(part, {u, v});
            if (!one) {
                extract(u, v, own, net);
            }
            result.add(degrees_[0], degrees_[1], net,
                       {part.side(0) / own.side(0), part.side(1) / own.side(1)}, noise(4), steps);
        }
    }
    return result;
}

// Each division takes a few roundings for each degree, each relative to the radius.
double CellNets::noise(int divisions) const noexcept {
    return eps * (16 + 4.0 * divisions * (degrees_[0] + degrees_[1])) * grid_.radius();
}

std::array<const double *, 4> corners_of(const CellNets &nets, const double *net) noexcept {
    const auto row = static_cast<size_t>(nets.degree(1)) * HessianBox::coordinates;
    const double *last = net + static_cast<size_t>(nets.degree(0)) * (row + HessianBox::coordinates);
    return {net, last, last + row, net + row};
}

} // namespace nrb::mesh
