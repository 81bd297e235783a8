// SPDX-License-Identifier: MIT
#include "intersect/surfaces/arc_places.h"

#include "base/numbers.h"
#include "base/watch.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

// In lengths of the box: how far a spot that was found with the polynomials of a neighbouring piece may be
// from the zero that Newton's method in this box finds for it.
constexpr double one_zero = 0x1p-10;

} // namespace

std::vector<size_t> ArcPlaces::near(const std::array<int64_t, 4> &index,
                                    const NumbersOfPieces &numbers) const {
    std::array<std::vector<int64_t>, 4> along;
    for (size_t i = 0; i < 4; ++i) {
        const int64_t n = count(i);
        for (const int64_t step : {-1, 0, 1}) {
            const int64_t at = wraps(i) ? (index[i] + step + n) % n : index[i] + step;
            if (at >= 0 && at < n && std::ranges::count(along[i], at) == 0) {
                along[i].push_back(at);
            }
        }
    }
    std::vector<size_t> all;
    for (const int64_t u : along[0]) {
        for (const int64_t v : along[1]) {
            for (const int64_t s : along[2]) {
                for (const int64_t t : along[3]) {
                    count_work(20);
                    const auto known = numbers.find({u, v, s, t});
                    if (known != numbers.end()) {
                        all.insert(all.end(), known->second.begin(), known->second.end());
                    }
                }
            }
        }
    }
    std::ranges::sort(all);
    return all;
}

double ArcPlaces::length(size_t i, int64_t index) const noexcept {
    const pieces::PieceGrid &grid = surfaces_[i / 2]->grid;
    const int axis = static_cast<int>(i % 2);
    return grid.break_at(axis, index + 1) - grid.break_at(axis, index);
}

bool ArcPlaces::is_zero_of(const CrossArc &arc, const CrossSpot &spot, CrossPlace &z) const {
    for (size_t i = 0; i < 4; ++i) {
        z[i] = place_in(arc.box, spot, i);
        if (!(z[i] >= -widening && z[i] <= 1 + widening)) {
            return false;
        }
    }
    CrossPlace zero = z;
    if (!arc.box.solve(arc.box.chart.axis(), zero)) {
        return false;
    }
    for (size_t i = 0; i < 4; ++i) {
        zero[i] -= z[i];
    }
    return largest(zero) <= one_zero;
}

// Coordinate i of a spot as a place in the part of a box. The piece of the spot has to be that of the part or
// a neighbour of it; otherwise the result is infinite. Where an axis closes and has few pieces, the piece may
// be so in several ways: then the place that is nearest to the middle of the part counts.
double ArcPlaces::place_in(const CrossBox &box, const CrossSpot &spot, size_t i) const noexcept {
    const CrossCell &cell = box.cell(i);
    const CrossPiece &piece = cell.piece();
    const size_t k = i % 2;
    const int64_t n = count(i), own = piece.index[k];
    double nearest = infinity;
    for (const int64_t step : {0, 1, -1}) {
        int64_t at = own + step;
        if ((at < 0 || at >= n) && !wraps(i)) {
            continue;
        }
        at = (at + n) % n;
        if (at != spot.index[i]) {
            continue;
        }
        const double stretch = length(i, at) / length(i, own), x = step == 0 ? spot.place[i]
                                                                   : step == 1
                                                                       ? 1 + stretch * spot.place[i]
                                                                       : -stretch * (1 - spot.place[i]);
        const Interval &within = piece.within[k];
        const double z = cell.in_part(k, (x - within.lower) / (within.upper - within.lower));
        nearest = std::abs(z - 0.5) < std::abs(nearest - 0.5) ? z : nearest;
    }
    return nearest;
}

} // namespace nrb::intersect
