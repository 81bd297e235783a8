// SPDX-License-Identifier: MIT
#include "closest/patch/patch_query.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>

namespace nrb::closest {

PatchQuery::PatchQuery(const PieceGrid &pieces, const Query &query)
    : pieces_(pieces), query_(query), items_(pieces, query.point, memory_), descent_(pieces.shape(), memory_),
      sign_(query.farthest ? -1.0 : 1.0) {
    const double reach = norm(items_.x(), pieces.shape().dim) + pieces.radius();
    tolerance_ = std::min(pieces.scaled(query.tolerance), 4 * reach); // a larger tolerance changes nothing
    noise_ = scaled_noise(pieces, query.point);
    floor_ = 8 * eps * (pieces.size() + pieces.magnitude(query.point));
}

PatchBox PatchQuery::box(int64_t piece) const noexcept {
    return box_in_range(pieces_, piece, query_.range);
}

bool PatchQuery::same_params(const FootCandidate &a, const FootCandidate &b) const noexcept {
    return near_params(pieces_, foot_at(pieces_, a.piece, a.at, query_.range),
                       foot_at(pieces_, b.piece, b.at, query_.range));
}

// Points on a sphere about x that are at most least_apart() apart are the same to rounding.
bool PatchQuery::same_point(const FootCandidate &a, const FootCandidate &b) {
    if (query_.sheets && !same_params(a, b)) {
        return false;
    }
    count_work(4 * pieces_.shape().values());
    const PatchMemory::Hold hold(memory_);
    const int dim = pieces_.shape().dim;
    double *p = memory_.take(dim), *q = memory_.take(dim);
    descent_.point(items_.values(a.piece), a.at, p);
    descent_.point(items_.values(b.piece), b.at, q);
    return distance(p, q, dim) <= least_apart(a.value);
}

std::vector<double> PatchQuery::point_of(const FootCandidate &place) {
    count_work(4 * pieces_.shape().values());
    const PatchMemory::Hold hold(memory_);
    std::vector<double> point(static_cast<size_t>(pieces_.shape().dim));
    descent_.point(items_.values(place.piece), place.at, point.data());
    return point;
}

double PatchQuery::moved(int64_t piece, const AxisValues &at) const {
    if (pieces_.positive()) {
        return items_.moved();
    }
    const PatchValues found = descent_.values(items_.values(piece), at);
    const double weight = std::abs(found.weight),
                 reach = found.length / weight + norm(items_.x(), pieces_.shape().dim);
    return std::min(items_.moved() + pieces_.moved_by_weights(reach, weight), 0x1p100);
}

// For a place on the boundary of its piece, tries the pieces that share this boundary; moves to the first one
// in which a descent leads to a smaller value.
bool PatchQuery::walk_on(FootCandidate &place) {
    const PatchShape &shape = pieces_.shape();
    const PieceGrid::Index index = pieces_.index(place.piece);
    const auto subsets = 1U << static_cast<unsigned>(shape.axes);
    for (unsigned subset = 1; subset < subsets; ++subset) {
        PieceGrid::Index next = index;
        AxisValues at = place.at;
        bool exists = true;
        for (int k = 0; k < shape.axes; ++k) {
            const auto i = static_cast<size_t>(k);
            if ((subset >> i & 1U) == 0) {
                continue;
            }
            const auto axis = static_cast<size_t>(pieces_.spline_axis(k));
            const bool up = at[i] == 1;
            exists = exists && (up || at[i] == 0);
            next[axis] = exists ? pieces_.neighbour(pieces_.spline_axis(k), index[axis], up) : -1;
            exists = exists && next[axis] >= 0;
            at[i] = up ? 0 : 1;
        }
        if (!exists) {
            continue;
        }
        const PatchMemory::Hold hold(memory_);
        const int64_t piece = pieces_.piece(next);
        const PatchBox part = box(piece);
        for (size_t k = 0; k < static_cast<size_t>(shape.axes); ++k) {
            exists = exists && part.lower[k] < part.upper[k];
            at[k] = std::clamp(at[k], part.lower[k], part.upper[k]);
        }
        if (!exists) {
            continue;
        }
        const double value = sign_ * descent_.descend(items_.values(piece), part, sign_, floor_, at).distance;
        if (value < place.value - 1e-2 * noise_) {
            place = {piece, at, value, moved(piece, at)};
            return true;
        }
    }
    return false;
}

bool PatchQuery::walk(FootCandidate &place) {
    for (int i = 0; i < 100; ++i) {
        if (!walk_on(place)) {
            return true;
        }
    }
    return false;
}

// The distance at the rounded parameters of a foot.
double PatchQuery::distance_at(int64_t piece, const Foot &foot) const {
    const PieceGrid::Index index = pieces_.index(piece);
    AxisValues at{};
    for (int k = 0; k < pieces_.shape().axes; ++k) {
        const int axis = pieces_.spline_axis(k);
        const auto i = static_cast<size_t>(axis);
        const double first = pieces_.break_at(axis, index[i]), last = pieces_.break_at(axis, index[i] + 1);
        at[static_cast<size_t>(k)] = std::clamp((foot.params[i] - first) / (last - first), 0.0, 1.0);
    }
    return descent_.distance(items_.values(piece), at);
}

// Where rounding the parameters moves the point by more than is allowed: takes the best of the neighbouring
// floating-point parameters.
void PatchQuery::polish(int64_t piece, Foot &foot) const {
    const Foot centre = foot;
    const PieceGrid::Index index = pieces_.index(piece);
    for (int i = 0; i < 27; ++i) {
        Foot other = centre;
        for (int k = 0, rest = i; k < pieces_.spline_axes(); ++k, rest /= 3) {
            const auto at = static_cast<size_t>(k);
            const double low = pieces_.break_at(k, index[at]), high = pieces_.break_at(k, index[at] + 1);
            const double t = centre.params[at];
            const double moved = rest % 3 == 0 ? t : std::nextafter(t, rest % 3 == 1 ? low : high);
            const bool inside =
                query_.range == nullptr || (moved >= query_.range[k].lower && moved <= query_.range[k].upper);
            other.params[at] = inside && (centre.left >> k & 1U) == 0 && moved < high ? moved : t;
        }
        other.distance = pieces_.unscaled(distance_at(piece, other));
        if (sign_ * other.distance < sign_ * foot.distance) {
            foot = other;
        }
    }
}

// The foot of a candidate; its distance is the one at the rounded parameters.
Foot PatchQuery::foot(const FootCandidate &place) {
    const PatchMemory::Hold hold(memory_);
    Foot result = foot_at(pieces_, place.piece, place.at, query_.range);
    result.distance = pieces_.unscaled(distance_at(place.piece, result));
    if (!(sign_ * pieces_.scaled(result.distance) - place.value <= noise_ / 8)) {
        polish(place.piece, result);
    }
    result.status = boundary_bit(pieces_, result, query_.range);
    return result;
}

Foot PatchQuery::any_point() {
    PieceGrid::Index index{};
    for (int axis = 0; axis < pieces_.spline_axes(); ++axis) {
        const Interval whole{pieces_.break_at(axis, 0), pieces_.break_at(axis, pieces_.count(axis))};
        const Interval range = query_.range != nullptr ? query_.range[axis] : whole;
        index[static_cast<size_t>(axis)] = pieces_.find(axis, range.lower / 2 + range.upper / 2);
    }
    Foot result = foot_at(pieces_, pieces_.piece(index), {0.5, 0.5, 0.5}, query_.range);
    result.distance = pieces_.unscaled(norm(items_.x(), pieces_.shape().dim));
    result.status |= closest_certified;
    return result;
}

Foot PatchQuery::local(const double *guess) {
    const PatchMemory::Hold hold(memory_);
    PieceGrid::Index index{};
    for (int axis = 0; axis < pieces_.spline_axes(); ++axis) {
        index[static_cast<size_t>(axis)] = pieces_.find(axis, guess[axis]);
    }
    FootCandidate place;
    place.piece = pieces_.piece(index);
    for (int k = 0; k < pieces_.shape().axes; ++k) {
        const int axis = pieces_.spline_axis(k);
        const int64_t i = index[static_cast<size_t>(axis)];
        const double first = pieces_.break_at(axis, i), last = pieces_.break_at(axis, i + 1);
        place.at[static_cast<size_t>(k)] = std::clamp((guess[axis] - first) / (last - first), 0.0, 1.0);
    }
    const auto found = descent_.descend(items_.values(place.piece), {}, sign_, floor_, place.at, 100);
    place.value = sign_ * found.distance;
    const bool done = found.converged && walk(place);
    Foot result = foot(place);
    result.status |= done ? 0 : closest_budget;
    return result;
}

} // namespace nrb::closest
