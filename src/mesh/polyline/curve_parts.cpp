// SPDX-License-Identifier: MIT
#include "mesh/polyline/curve_parts.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "eval/curve_point.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace nrb::mesh {

namespace {

// Parts smaller than this, in the frame, are not divided for the sake of an angle: they contain a cusp.
constexpr double least_turn = 0x1p-20;
constexpr int64_t work_of_a_point = 300;

// The tangent direction at an end of a piece with positive weights, and a bound on its error.
struct Direction {
    std::vector<double> unit;
    double error = infinity;
};

Direction direction_at(const pieces::BezierPiece &piece, bool upper) {
    const int dim = piece.dim();
    const int64_t n = piece.coefficients() - 1;
    const double *end = piece.point(upper ? n : 0);
    for (int64_t i = 1; i <= n; ++i) {
        const int64_t at = upper ? n - i : i;
        const double leg = piece.has_point(at) ? distance(piece.point(at), end, dim) : 0;
        if (leg > 8 * piece.moved()) {
            Direction found{std::vector<double>(end, end + dim), 2 * piece.moved() / leg + (dim + 8) * eps};
            for (size_t c = 0; c < found.unit.size(); ++c) {
                found.unit[c] = (piece.point(at)[c] - end[c]) / (upper ? -leg : leg);
            }
            return found;
        }
    }
    return {};
}

// Whether nothing can be proven about parts of a piece either, because overflow or rounding may account for
// all of it.
bool hidden(const pieces::BezierPiece &piece) noexcept {
    const pieces::Rounding &rounding = piece.rounding();
    bool small = true;
    for (int64_t i = 0; i < piece.coefficients(); ++i) {
        small = small && std::abs(piece.weight(i)) <= 128 * rounding.weight;
    }
    return small || !std::isfinite(rounding.apart + rounding.record + rounding.weight);
}

// Rounded up, so that the bound also holds where the caller's unit is so large that digits are lost.
double rounded_up(double bound) noexcept {
    return bound == 0 ? 0 : std::nextafter(bound, infinity);
}

} // namespace

CurveParts::CurveParts(const Spline &curve, const PolylineRule &rule)
    : curve_(curve), rule_(rule), frame_(pieces::frame_of(curve)),
      pieces_(pieces::bezier_pieces(curve, frame_)), chord_(frame_.scaled(rule.chord)),
      longest_(rule.longest > 0 ? frame_.scaled(rule.longest) : infinity), segment_(curve.dim()) {
    starts_.reserve(pieces_.size());
    for (const pieces::BezierPiece &piece : pieces_) {
        starts_.push_back(piece.parameter({})[0]);
    }
}

// Whether the directions on both sides of the start of piece e > 0 agree up to rounding.
bool CurveParts::smooth(size_t e) const {
    if (!pieces_[e - 1].sound() || !pieces_[e].sound()) {
        return false;
    }
    const Direction before = direction_at(pieces_[e - 1], true), after = direction_at(pieces_[e], false);
    return std::isfinite(before.error) && std::isfinite(after.error) &&
           distance(before.unit.data(), after.unit.data(), curve_.dim()) <= 4 * (before.error + after.error);
}

bool CurveParts::meet(const Vertex &before, const Vertex &after) const {
    const int dim = curve_.dim();
    const double gap = distance(before.in_frame.data(), after.in_frame.data(), dim);
    const double size = norm(before.in_frame.data(), dim) + norm(after.in_frame.data(), dim);
    const double noise = pieces_[piece_before(before.t)].moved() + pieces_[piece_at(after.t)].moved();
    return std::isfinite(noise) && gap <= 4 * (noise + eps * size);
}

// There is none at breaks where the curve is proven to be continuous and its direction changes by no more
// than rounding. Where the multiplicity exceeds the degree, each limit is a control point, which is evaluated
// bit for bit: equal limits prove continuity.
std::optional<Corner> CurveParts::corner(size_t e) const {
    const double t = starts_[e];
    const int order = curve_.axis(0).degree() - multiplicity(curve_.axis(0).knots(), t);
    if (order > 0) {
        return std::nullopt;
    }
    count_work(work_of_a_point);
    if (order < 0) {
        const Vertex left = vertex(t, true), right = vertex(t, false);
        if (left.point != right.point) {
            return Corner{t, !meet(left, right)};
        }
    }
    return smooth(e) ? std::nullopt : std::optional(Corner{t, false});
}

std::vector<Corner> CurveParts::corners() const {
    std::vector<Corner> found;
    for (size_t e = 1; e < pieces_.size(); ++e) {
        if (const std::optional<Corner> here = corner(e)) {
            found.push_back(*here);
        }
    }
    return found;
}

bool CurveParts::closed() const {
    const KnotVector &axis = curve_.axis(0);
    const auto [lower, upper] = axis.domain();
    const bool joined = axis.periodic() && multiplicity(axis.knots(), upper) <= axis.degree();
    return joined || meet(vertex(upper, true), vertex(lower, false));
}

Vertex CurveParts::vertex(double t, bool left) const {
    count_work(work_of_a_point);
    Vertex made{t, eval::curve_point(curve_, t, left), {}};
    made.in_frame.resize(made.point.size());
    for (size_t c = 0; c < made.point.size(); ++c) {
        made.in_frame[c] = frame_.coordinate(c, made.point[c]);
    }
    return made;
}

size_t CurveParts::piece_at(double t) const noexcept {
    const auto next = std::upper_bound(starts_.begin() + 1, starts_.end(), t);
    return static_cast<size_t>(next - starts_.begin()) - 1;
}

size_t CurveParts::piece_before(double t) const noexcept {
    const auto next = std::lower_bound(starts_.begin() + 1, starts_.end(), t);
    return static_cast<size_t>(next - starts_.begin()) - 1;
}

void CurveParts::add(const pieces::BezierPiece &piece, Sizes &sizes) {
    sizes.bound = std::max(sizes.bound, segment_.distance(piece));
    sizes.floor = std::max(sizes.floor, segment_.noise(piece));
    sizes.extent += piece.size();
    sizes.hidden = sizes.hidden && !piece.sound() && hidden(piece);
    if (rule_.angle > 0 && sizes.turning < std::numbers::pi) {
        sizes.turning = std::min(std::numbers::pi, std::max(sizes.turning, 2 * segment_.turn(piece)));
    }
}

// The Hausdorff distance is bounded in both directions. The curve is continuous between the vertices, so the
// foot points of its points cover the segment except for gaps at its ends. So the distance of the segment
// from the curve is no larger than that of the curve from the segment, or than the gaps. These come from
// rounding alone: no division makes them smaller.
CurveParts::Sizes CurveParts::sizes(const Vertex &from, const Vertex &to) {
    segment_.set(from.in_frame.data(), to.in_frame.data());
    Sizes all;
    for (size_t e = piece_at(from.t); e < pieces_.size() && starts_[e] < to.t; ++e) {
        const double end = e + 1 < starts_.size() ? starts_[e + 1] : to.t;
        const bool first = starts_[e] <= from.t, last = end >= to.t;
        const bool whole = starts_[e] >= from.t && pieces_[e].parameter({1, 1, 1})[0] <= to.t;
        const Interval range{std::max(starts_[e], from.t), std::min(end, to.t)};
        const pieces::BezierPiece cut = whole ? pieces::BezierPiece() : pieces_[e].between(range);
        const pieces::BezierPiece &piece = whole ? pieces_[e] : cut;
        add(piece, all);
        all.floor =
            std::max({all.floor, first ? segment_.start_gap(piece) : 0, last ? segment_.end_gap(piece) : 0});
    }
    all.bound = std::max(all.bound, all.floor);
    return all;
}

// The bound is proportional to the square of the length of a segment, as far as rounding allows, and the
// turning of the tangent to the length.
Segment CurveParts::segment(const Vertex &from, const Vertex &to) {
    const Sizes all = sizes(from, to);
    const double reachable = std::max(chord_ * (1 - 0x1p-30), 4 * all.floor);
    const double by_chord = all.bound == 0 || std::isinf(reachable) ? 0 : std::sqrt(all.bound / reachable);
    const double by_angle = rule_.angle > 0 ? all.turning / rule_.angle : 0;
    const double by_length = segment_.length() / longest_;
    Segment result;
    result.bound = rounded_up(frame_.unscaled(all.bound));
    const double need = std::max({by_chord, by_angle, by_length});
    const bool known = std::isfinite(all.bound) && std::isfinite(segment_.length());
    result.need = known ? need : infinity;
    result.proven = known && result.bound <= rule_.chord && by_angle <= 1 && by_length <= 1;
    const bool tiny = known && by_chord <= 1 && by_length <= 1 && all.extent <= least_turn;
    result.hopeless = !result.fits() && (all.hidden || tiny);
    return result;
}

} // namespace nrb::mesh
