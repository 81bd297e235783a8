// SPDX-License-Identifier: MIT
#include "closest/pair/pair_regions.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "closest/stops.h"

#include <algorithm>
#include <cmath>

namespace nrb::closest {

namespace {

constexpr int64_t work_of_a_side = 200;
constexpr double room = 64 * eps; // relative to coordinates in the frame, which are at most about 1

// The range of coordinate c of x - y for points of two cells, with their rounding included.
Interval difference(const PairCell &x, const PairCell &y, int dim, int c) noexcept {
    const double moved = x.moved + y.moved + room;
    return {x.box[c] - y.box[dim + c] - moved, x.box[dim + c] - y.box[c] + moved};
}

// The sign of (X - Y) . X_k over all points of two cells, which is that of the derivative of their distance
// along axis k of x; 0 if it is not known.
int sign_of_slope(const pieces::Slopes &slopes, const PairCell &x, const PairCell &y) {
    const int dim = x.piece->dim();
    Interval all{infinity, -infinity};
    double size = 0;
    for (int c = 0; c < dim; ++c) {
        const Interval d = difference(x, y, dim, c);
        size += std::max(std::abs(d.lower), std::abs(d.upper));
    }
    for (size_t i = 0; i < slopes.count(); ++i) {
        Interval sum{0, 0};
        for (int c = 0; c < dim; ++c) {
            const Interval d = difference(x, y, dim, c);
            const double v = slopes.vector(i)[c];
            sum.lower += std::min(v * d.lower, v * d.upper);
            sum.upper += std::max(v * d.lower, v * d.upper);
        }
        all = {std::min(all.lower, sum.lower), std::max(all.upper, sum.upper)};
    }
    const double error = size * (slopes.error() + room * dim * slopes.largest());
    return all.lower > error ? 1 : all.upper < -error ? -1 : 0;
}

} // namespace

bool PairRegions::hold(const pieces::LocalParam &a, const pieces::LocalParam &b) const {
    return (regions_[0] == nullptr || regions_[0]->side(a) >= 0) &&
           (regions_[1] == nullptr || regions_[1]->side(b) >= 0);
}

int PairRegions::side(size_t which, const pieces::BezierPiece &piece) const {
    const Region *const region = regions_[which];
    if (region == nullptr) {
        return 1;
    }
    count_work(work_of_a_side);
    return region->side(piece.parameter({0, 0, 0}), piece.parameter({1, 1, 1}));
}

PairRegions::Known &PairRegions::known(size_t which, PairCell &cell) {
    if (cell.mark == 0) {
        known_.push_back({side(which, *cell.piece)});
        cell.mark = known_.size();
    }
    return known_[cell.mark - 1];
}

bool PairRegions::exclude(PairCell &a, PairCell &b) {
    if (none() || !a.piece || !b.piece) {
        return false;
    }
    const int side_a = known(0, a).side, side_b = known(1, b).side;
    if (side_a < 0 || side_b < 0) {
        return true;
    }
    const bool inside = side_a > 0 && side_b > 0;
    return !inside && !boundaries_ && a.piece->positive() && b.piece->positive() &&
           (falls_away(0, a, b) || falls_away(1, b, a));
}

// Whether the distance decreases towards an end of the cell that is neither an end of the spline nor a knot
// at which it may have a crease.
bool PairRegions::falls_away(size_t which, PairCell &cell, const PairCell &other) {
    Known &own = known(which, cell);
    const pieces::BezierPiece &piece = *cell.piece;
    for (int k = 0; k < piece.axes(); ++k) {
        if (piece.degree(k) == 0) {
            continue;
        }
        auto &slopes = own.along[static_cast<size_t>(k)];
        if (!slopes) {
            slopes.emplace(piece, k);
        }
        const int sign = sign_of_slope(*slopes, cell, other);
        const double end = sign > 0 ? 0 : 1;
        const double t = piece.parameter({end, end, end})[static_cast<size_t>(k)];
        if (sign != 0 && !may_hold_foot(splines_[which]->axis(k), t)) {
            return true;
        }
    }
    return false;
}

} // namespace nrb::closest
