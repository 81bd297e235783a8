#include "closest/patch/patch_critical.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>

namespace nrb::closest {

namespace {

constexpr int samples = 8; // of a piece, around a pole

// What the distance does around a pole: signs of how much it is larger than there, in cyclic order.
class Ring {
public:
    void add(int sign) {
        ++(sign > 0 ? above_ : sign < 0 ? below_ : equal_);
        if (sign == 0) {
            return;
        }
        changes_ += last_ != 0 && last_ != sign ? 1 : 0;
        first_ = first_ == 0 ? sign : first_;
        last_ = sign;
    }
    // Whether the ring tells what the pole is.
    [[nodiscard]] bool decides() const noexcept {
        return (above_ > 0 && below_ > 0) || (equal_ == 0 && above_ + below_ > 0);
    }
    // A critical_ constant; 0 if the pole is not critical. Of an open ring extrema count only, as at
    // corners.
    [[nodiscard]] int32_t kind(bool closed) const noexcept {
        if (above_ > 0 && below_ > 0) {
            return closed && changes_ + (first_ != last_ ? 1 : 0) > 2 ? critical_saddle : 0;
        }
        return above_ > 0 ? critical_minimum : critical_maximum;
    }

private:
    int above_ = 0, below_ = 0, equal_ = 0, changes_ = 0;
    int first_ = 0, last_ = 0;
};

} // namespace

// Edges of surfaces that are points.
void PatchCritical::find_poles() {
    for (const int code : {1, 2, 3, 6}) {
        Face face;
        if (pieces_.shape().axes == 2 && pieces_.spline_axes() == 2 && make_face(code, face)) {
            const PatchMemory::Hold hold(memory_);
            find_pole(face);
        }
    }
}

void PatchCritical::find_pole(const Face &face) {
    const PatchShape &shape = pieces_.shape();
    const int axis = face.side[0] >= 0 ? 0 : 1;
    const int side = face.side[static_cast<size_t>(axis)];
    const auto dim = static_cast<size_t>(shape.dim);
    std::vector<int64_t> pieces;
    Pole pole{{}, 0, 1, axis, -1, {}, 0};
    for (int64_t piece = 0; piece < pieces_.count(); ++piece) {
        if (!touches(face, piece)) {
            continue;
        }
        const PatchMemory::Hold hold(memory_);
        const PatchItem whole = piece_in_range(piece);
        const int n = shape.degree(axis), other = shape.degree(1 - axis);
        for (int i = 0; i <= other; ++i) {
            const int64_t at = axis == 0 ? side * n * (other + 1) + i : i * (n + 1) + side * n;
            const double *q = whole.values + at * shape.lanes;
            std::vector<double> point(q, q + dim);
            for (double &x : point) {
                x /= q[dim];
            }
            if (pole.point.empty()) {
                pole.point = point;
            }
            if (!(q[dim] > 0) || !(distance(point.data(), pole.point.data(), shape.dim) <= 16 * noise_)) {
                return;
            }
        }
        pieces.push_back(piece);
    }
    if (pieces.empty()) {
        return;
    }
    // Where a difference of distances, of the second order in this, is many times the noise.
    const double length = norm(pole.point.data(), shape.dim);
    pole.radius = std::max(near_, 16 * std::sqrt(noise_ * (length + noise_)));
    pole.piece = pieces.front();
    pole.at[static_cast<size_t>(axis)] = side;
    if (set_kind(face, pieces, pole)) {
        const bool claim = pole.kind == critical_minimum || (pole.kind != 0 && !minima_);
        doubtful_ = doubtful_ || (claim && !proven(pieces, pole));
        if (pole.kind != 0 && (!minima_ || pole.kind == critical_minimum)) {
            add_point(piece_in_range(pole.piece), pole.at, pole.kind);
        }
        poles_.push_back(std::move(pole));
    }
}

// By places around it that are as far from it as its radius, or nearer; false if rounding hides what they
// tell.
bool PatchCritical::set_kind(const Face &face, const std::vector<int64_t> &pieces, Pole &pole) const {
    const int dim = pieces_.shape().dim;
    const size_t axis = face.side[0] >= 0 ? 0 : 1;
    const double length = norm(pole.point.data(), dim);
    Ring ring;
    std::vector<double> point(pole.point), first;
    for (const int64_t piece : pieces) {
        const PatchMemory::Hold hold(memory_);
        const PatchItem whole = piece_in_range(piece);
        AxisValues at{};
        const auto distance_from_pole = [&](double h) {
            at[axis] = face.side[axis] == 0 ? h : 1 - h;
            descent_.point(whole.values, at, point.data());
            return distance(point.data(), pole.point.data(), dim);
        };
        for (int i = 0; i <= samples; ++i) {
            at[1 - axis] = static_cast<double>(i) / samples;
            double h = 1, apart = distance_from_pole(h);
            while (apart > pole.radius && h > 0x1p-60) {
                h /= 2;
                apart = distance_from_pole(h);
            }
            if (h < 1 && distance_from_pole(std::min(2 * h, 0.9 * h * pole.radius / apart)) > pole.radius) {
                distance_from_pole(h);
            }
            pole.height = std::min(pole.height, h);
            const double more = norm(point.data(), dim) - length;
            ring.add(more > 4 * noise_ ? 1 : more < -4 * noise_ ? -1 : 0);
            first = first.empty() ? point : first;
        }
    }
    pole.kind = ring.kind(distance(first.data(), point.data(), dim) <= 64 * noise_);
    return ring.decides();
}

// Whether no point of the strip is nearer than a pole that is a minimum, or farther than a maximum, by more
// than rounding. What samples say of a saddle is not proven.
bool PatchCritical::proven(const std::vector<int64_t> &pieces, const Pole &pole) {
    const PatchShape &shape = pieces_.shape();
    const PatchSquares squares(shape);
    const double length = norm(pole.point.data(), shape.dim);
    const bool upper = pole.at[static_cast<size_t>(pole.axis)] > 0;
    return pole.kind != critical_saddle && std::all_of(pieces.begin(), pieces.end(), [&](int64_t piece) {
               const PatchMemory::Hold hold(memory_);
               const PatchItem strip = items_.part(piece_in_range(piece), pole.axis,
                                                   upper ? 1 - pole.height : 0, upper ? 1 : pole.height);
               const PatchSlopes slopes(shape, squares, strip.values, strip.moved, memory_);
               return slopes.sound() && (pole.kind == critical_minimum
                                             ? slopes.least() >= length - 8 * noise_
                                             : slopes.least() + slopes.spread() <= length + 8 * noise_);
           });
}

// Along the edge, or at its ends, there is nothing else.
bool PatchCritical::is_pole(const Face &face) const noexcept {
    return std::any_of(poles_.begin(), poles_.end(), [&](const Pole &pole) {
        const auto axis = static_cast<size_t>(pole.axis);
        return face.side[axis] >= 0 && face.side[axis] == static_cast<int>(pole.at[axis]);
    });
}

// Whether a part belongs to a critical pole: as near as the tolerance, or as rounding leaves open.
bool PatchCritical::at_pole(const PatchSlopes &slopes, bool flat) {
    for (const Pole &pole : poles_) {
        const double extent = slopes.extent(pole.point.data());
        if (pole.kind != 0 && extent <= (flat ? pole.radius : near_)) {
            connected_ = connected_ || (extent > near_ && !minima_);
            return true;
        }
    }
    return false;
}

bool PatchCritical::at_pole(const std::vector<double> &point) {
    for (const Pole &pole : poles_) {
        const double apart = distance(point.data(), pole.point.data(), pieces_.shape().dim);
        if (pole.kind != 0 && apart <= pole.radius) {
            connected_ = connected_ || (apart > near_ && !minima_);
            return true;
        }
    }
    return false;
}

bool PatchCritical::is_at_pole(const PatchItem &whole, const AxisValues &at, bool any) const {
    std::vector<double> point(static_cast<size_t>(pieces_.shape().dim));
    descent_.point(whole.values, at, point.data());
    return std::any_of(poles_.begin(), poles_.end(), [&](const Pole &pole) {
        return (any || pole.kind != 0) &&
               distance(point.data(), pole.point.data(), pieces_.shape().dim) <= pole.radius;
    });
}

// A part near a pole that is not critical, which rounding has left open, makes it an undecided one.
void PatchCritical::open_pole(const double *point) {
    for (Pole &pole : poles_) {
        if (pole.kind == 0 && distance(point, pole.point.data(), pieces_.shape().dim) <= pole.radius) {
            connected_ = true;
            pole.kind = critical_undecided;
            add_point(piece_in_range(pole.piece), pole.at, pole.kind);
        }
    }
}

} // namespace nrb::closest
