// SPDX-License-Identifier: MIT
#include "intersect/surfaces/cross_spot.h"

#include "base/numbers.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

CrossSpot spot_of(const CrossArc &arc, const CrossEnd &end) noexcept {
    CrossSpot spot;
    const CrossPlace noise = noise_of_end(arc.box.chart, end);
    for (size_t i = 0; i < 4; ++i) {
        const CrossCell &cell = arc.box.cell(i);
        const CrossPiece &piece = cell.piece();
        const size_t k = i % 2;
        const double x = cell.lower(k) + cell.length(k) * end.at[i];
        const double part = piece.within[k].upper - piece.within[k].lower;
        spot.index[i] = piece.index[k];
        spot.place[i] = piece.within[k].lower + part * x;
        spot.noise[i] = part * cell.length(k) * noise[i];
        spot.parameter[i] = piece.range[k].lower * (1 - x) + piece.range[k].upper * x;
    }
    return spot;
}

double length_of(const CrossSpot &a, const CrossSpot &b, double room) noexcept {
    double most = 0;
    for (size_t i = 0; i < 4; ++i) {
        most = std::max(most, std::abs(a.place[i] - b.place[i]) / (room + a.noise[i] + b.noise[i]));
    }
    return most;
}

double length_of(const CrossSpot &a, const CrossSpot &b) noexcept {
    double most = 0;
    for (size_t i = 0; i < 4; ++i) {
        most = std::max(most, std::abs(a.place[i] - b.place[i]));
    }
    return most;
}

double CrossDistances::apart(const CrossSpot &a, const CrossSpot &b, double room) const noexcept {
    constexpr double far = 64;
    double most = 0;
    for (size_t i = 0; i < 4 && most < far; ++i) {
        most = std::max(most, along(a, b, i) / (room + a.noise[i] + b.noise[i]));
    }
    return most;
}

double CrossDistances::length(size_t i, int64_t index) const noexcept {
    const pieces::PieceGrid &grid = surfaces_[i / 2]->grid;
    const int axis = static_cast<int>(i % 2);
    return grid.break_at(axis, index + 1) - grid.break_at(axis, index);
}

double CrossDistances::along(const CrossSpot &a, const CrossSpot &b, size_t i) const noexcept {
    const auto &[grid, borders] = *surfaces_[i / 2];
    const int64_t n = grid.count(static_cast<int>(i % 2));
    const bool wraps = borders.wraps(i % 2);
    double least = a.index[i] == b.index[i] ? std::abs(a.place[i] - b.place[i]) : infinity;
    for (const bool first : {true, false}) {
        const CrossSpot &lower = first ? a : b, &upper = first ? b : a;
        const int64_t next = lower.index[i] + 1;
        if (upper.index[i] == next || (next == n && upper.index[i] == 0 && wraps)) {
            const double below = length(i, lower.index[i]), above = length(i, upper.index[i]);
            least = std::min(least, std::abs((1 - lower.place[i]) * below + upper.place[i] * above) /
                                        std::min(below, above));
        }
    }
    return least;
}

} // namespace nrb::intersect
