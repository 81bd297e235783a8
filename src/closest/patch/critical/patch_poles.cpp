// SPDX-License-Identifier: MIT
#include "closest/patch/critical/patch_poles.h"

#include "closest/patch/critical/pole_ring.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>

namespace nrb::closest {

namespace {

constexpr int samples = 8; // per piece, around a pole

// The axis at one of whose ends a side of a surface lies.
int end_axis(const PatchFace &face) noexcept {
    return face.side[0] >= 0 ? 0 : 1;
}

} // namespace

void PatchPoles::find() {
    const PieceGrid &pieces = query_.pieces();
    if (query_.shape().axes != 2 || pieces.spline_axes() != 2) {
        return;
    }
    for (const int code : {1, 2, 3, 6}) { // codes of the four sides
        const PatchFace face = face_of(query_.shape(), code);
        if (is_boundary(pieces, query_.query(), face)) {
            const PatchMemory::Hold hold(query_.memory());
            find(face);
        }
    }
}

// Whether all control points on a side of a piece coincide with each other and with `point`, the common one
// of the pieces tested before.
bool PatchPoles::collapses(const PatchFace &face, const PatchItem &whole, std::vector<double> &point) const {
    const PatchShape &shape = query_.shape();
    const auto dim = static_cast<size_t>(shape.dim);
    const int axis = end_axis(face);
    const int n = shape.degree(axis), other = shape.degree(1 - axis);
    const int side = face.side[static_cast<size_t>(axis)];
    for (int i = 0; i <= other; ++i) {
        const int64_t at = axis == 0 ? side * n * (other + 1) + i : i * (n + 1) + side * n;
        const double *q = whole.values + at * shape.lanes;
        std::vector<double> control(q, q + dim);
        for (double &x : control) {
            x /= q[dim];
        }
        point = point.empty() ? control : point;
        if (!(q[dim] > 0) || !(query_.apart(control, point) <= 16 * query_.noise())) {
            return false;
        }
    }
    return true;
}

void PatchPoles::find(const PatchFace &face) {
    const std::vector<int64_t> pieces = pieces_at(query_.pieces(), query_.query(), face);
    const int axis = end_axis(face);
    Pole pole{{}, 0, 1, axis, -1, {}, 0};
    for (const int64_t piece : pieces) {
        const PatchMemory::Hold hold(query_.memory());
        if (!collapses(face, query_.piece_in_range(piece), pole.point)) {
            return;
        }
    }
    if (pieces.empty()) {
        return;
    }
    // Within this radius, points cannot be told apart: at its end, the second-order change of the distance is
    // many times the noise.
    const double length = norm(pole.point.data(), query_.shape().dim), noise = query_.noise();
    pole.radius = std::max(query_.near(), 16 * std::sqrt(noise * (length + noise)));
    pole.piece = pieces.front();
    pole.at[static_cast<size_t>(axis)] = face.side[static_cast<size_t>(axis)];
    if (set_kind(face, pieces, pole)) {
        add(std::move(pole), pieces);
    }
}

void PatchPoles::add(Pole pole, const std::vector<int64_t> &pieces) {
    const bool wanted = pole.kind == critical_minimum || (pole.kind != 0 && !minima_);
    if (wanted) {
        gaps_.doubtful = gaps_.doubtful || !proven(pieces, pole);
        add_point(pole);
    }
    poles_.push_back(std::move(pole));
}

void PatchPoles::add_point(const Pole &pole) {
    points_.add(query_.piece_in_range(pole.piece), pole.at, pole.kind);
}

// A point beside the pole, at parameter `along` of the edge and at most the pole's radius away from it, as
// far as that is found by halving. Reduces the height of the strip accordingly.
std::vector<double> PatchPoles::point_near(const PatchFace &face, const PatchItem &whole, double along,
                                           Pole &pole) const {
    const auto axis = static_cast<size_t>(end_axis(face));
    AxisValues at{};
    at[1 - axis] = along;
    std::vector<double> point;
    const auto distance_at = [&](double h) {
        at[axis] = face.side[axis] == 0 ? h : 1 - h;
        point = query_.point(whole, at);
        return query_.apart(point, pole.point);
    };
    double h = 1, apart = distance_at(h);
    while (apart > pole.radius && h > 0x1p-60) {
        h /= 2;
        apart = distance_at(h);
    }
    if (h < 1 && distance_at(std::min(2 * h, 0.9 * h * pole.radius / apart)) > pole.radius) {
        distance_at(h);
    }
    pole.height = std::min(pole.height, h);
    return point;
}

// Determines the kind of the pole from a ring of points around it; false if rounding hides the signs.
bool PatchPoles::set_kind(const PatchFace &face, const std::vector<int64_t> &pieces, Pole &pole) const {
    const int dim = query_.shape().dim;
    const double length = norm(pole.point.data(), dim), noise = query_.noise();
    PoleRing ring;
    std::vector<double> first, last;
    for (const int64_t piece : pieces) {
        const PatchMemory::Hold hold(query_.memory());
        const PatchItem whole = query_.piece_in_range(piece);
        for (int i = 0; i <= samples; ++i) {
            last = point_near(face, whole, static_cast<double>(i) / samples, pole);
            const double more = norm(last.data(), dim) - length;
            ring.add(more > 4 * noise ? 1 : more < -4 * noise ? -1 : 0);
            first = first.empty() ? last : first;
        }
    }
    pole.kind = ring.kind(query_.apart(first, last) <= 64 * noise);
    return ring.decides();
}

// Whether, beyond rounding, no point of the strip is nearer than a pole that is a minimum, or farther than
// one that is a maximum. For a saddle, samples prove nothing.
bool PatchPoles::proven(const std::vector<int64_t> &pieces, const Pole &pole) const {
    const PatchShape &shape = query_.shape();
    const pieces::PatchSquares squares(shape);
    const double length = norm(pole.point.data(), shape.dim), noise = query_.noise();
    const bool upper = pole.at[static_cast<size_t>(pole.axis)] > 0;
    return pole.kind != critical_saddle && std::all_of(pieces.begin(), pieces.end(), [&](int64_t piece) {
               const PatchMemory::Hold hold(query_.memory());
               const PatchItem strip =
                   query_.items().part(query_.piece_in_range(piece), pole.axis, upper ? 1 - pole.height : 0,
                                       upper ? 1 : pole.height);
               const PatchSlopes slopes(shape, squares, strip.values, strip.moved, query_.memory());
               return slopes.sound() && (pole.kind == critical_minimum ? slopes.least() >= length - 8 * noise
                                                                       : slopes.most() <= length + 8 * noise);
           });
}

// The edge and its ends are the pole itself, so that nothing else is to be found on them.
bool PatchPoles::holds(const PatchFace &face) const noexcept {
    return std::any_of(poles_.begin(), poles_.end(), [&](const Pole &pole) {
        const auto axis = static_cast<size_t>(pole.axis);
        return face.side[axis] >= 0 && face.side[axis] == static_cast<int>(pole.at[axis]);
    });
}

bool PatchPoles::absorb(double apart) {
    gaps_.connected = gaps_.connected || (apart > query_.near() && !minima_);
    return true;
}

bool PatchPoles::is_beside(const Pole &pole, int64_t piece) const noexcept {
    const auto axis = static_cast<size_t>(pole.axis);
    const int64_t last = query_.pieces().count(pole.axis) - 1;
    return !query_.query().sheets || query_.pieces().index(piece)[axis] == (pole.at[axis] > 0 ? last : 0);
}

bool PatchPoles::absorbs(const PatchSlopes &slopes, bool flat, int64_t piece) {
    for (const Pole &pole : poles_) {
        const double extent = slopes.extent(pole.point.data());
        if (pole.kind != 0 && is_beside(pole, piece) && extent <= (flat ? pole.radius : query_.near())) {
            return absorb(extent);
        }
    }
    return false;
}

bool PatchPoles::absorbs(const std::vector<double> &point, int64_t piece) {
    for (const Pole &pole : poles_) {
        if (pole.kind != 0 && at(pole, point, piece)) {
            return absorb(query_.apart(point, pole.point));
        }
    }
    return false;
}

bool PatchPoles::critical_at(const std::vector<double> &point, int64_t piece) const noexcept {
    return std::ranges::any_of(poles_,
                               [&](const Pole &pole) { return pole.kind != 0 && at(pole, point, piece); });
}

bool PatchPoles::any_at(const std::vector<double> &point, int64_t piece) const noexcept {
    return std::ranges::any_of(poles_, [&](const Pole &pole) { return at(pole, point, piece); });
}

void PatchPoles::leave_open(const std::vector<double> &point, int64_t piece) {
    for (Pole &pole : poles_) {
        if (pole.kind == 0 && at(pole, point, piece)) {
            gaps_.connected = true;
            pole.kind = critical_undecided;
            add_point(pole);
        }
    }
}

} // namespace nrb::closest
