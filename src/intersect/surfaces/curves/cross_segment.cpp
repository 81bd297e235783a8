// SPDX-License-Identifier: MIT
#include "intersect/surfaces/curves/cross_segment.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "intersect/surfaces/curves/division.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace nrb::intersect {

namespace {

constexpr int most_depth = 20, most_depth_without_proof = 6, most_segments = 4096;

std::array<double, 3> coordinates(const Vector3 &a) noexcept {
    return {a.x, a.y, a.z};
}

int degree_of_differences(const std::array<int, 2> &a, const std::array<int, 2> &b) noexcept {
    return 3 * (std::max(a[0] + a[1], b[0] + b[1]) + 1);
}

} // namespace

CubicSamples CrossFitter::samples_for(const std::array<int, 2> &degrees_a,
                                      const std::array<int, 2> &degrees_b) {
    return CubicSamples(2 * degree_of_differences(degrees_a, degrees_b));
}

std::vector<double> CrossFitter::sampling_for(const std::array<int, 2> &degrees_a,
                                              const std::array<int, 2> &degrees_b) {
    const int most = std::max({degrees_a[0], degrees_a[1], degrees_b[0], degrees_b[1]});
    return std::vector<double>(16 * (static_cast<size_t>(most) + 1));
}

CrossFitter::CrossFitter(const std::array<int, 2> &degrees_a, const std::array<int, 2> &degrees_b,
                         double tolerance)
    : tolerance_(tolerance), samples_(samples_for(degrees_a, degrees_b)),
      sampling_(sampling_for(degrees_a, degrees_b)) {}

void CrossFitter::set_arc(const CrossArc &arc) {
    arc_ = &arc;
    left_ = most_segments;
    rounding_ = 0;
    for (size_t i = 0; i < 4; ++i) {
        const CrossCell &cell = arc.box.cell(i);
        const size_t k = i % 2;
        slopes_[i] = cell.largest_slope(k);
        const Interval &range = cell.piece().range[k];
        const double digits =
            2 * eps * std::max(std::abs(range.lower), std::abs(range.upper)) / (range.upper - range.lower);
        rounding_ += slopes_[i] / cell.length(k) * digits;
    }
}

// The common point is taken midway between the points of both surfaces.
CrossFitter::Node CrossFitter::node(const CrossPlace &at) const noexcept {
    const CrossBox::Value value = arc_->box.at(at);
    Node node{at,
              common_direction({value.a.slope[0], value.a.slope[1]}, {value.b.slope[0], value.b.slope[1]}),
              coordinates(0.5 * (value.a.at + value.b.at)),
              {}};
    const Vector3 along = node.tangent_on[0] * value.a.slope[0] + node.tangent_on[1] * value.a.slope[1];
    const double speed = length(along);
    if (speed > 0) {
        for (double &x : node.tangent_on) {
            x /= speed;
        }
        node.tangent = coordinates((1 / speed) * along);
    } else { // the tangent vanishes, or rounding hides it
        node.tangent_on = {};
    }
    return node;
}

void CrossFitter::fit(const CrossArc &arc, std::vector<CrossSegment> &segments) {
    set_arc(arc);
    fit_between(node(arc.ends[0].at), node(arc.ends[1].at), 0, segments);
}

// The length is about that of a circular arc with this chord and these tangents. Where the curve is hardly
// longer than the errors of its ends, tangents are unreliable: legs of the control polygon are no longer than
// half the way, and coordinate k stays between its ends.
CrossSegment CrossFitter::hermite(const Node &a, const Node &b) const noexcept {
    const double chord = distance(a.point.data(), b.point.data(), 3),
                 cosine = dot(a.tangent.data(), b.tangent.data(), 3);
    CrossSegment segment;
    segment.length = chord * (1 + (1 - cosine) / 12);
    CrossPlace way{};
    std::ranges::transform(a.at, b.at, way.begin(), std::minus<>());
    const auto leg = [&](const Node &node) {
        const double full = segment.length / 3 * largest(node.tangent_on), half = largest(way) / 2;
        return full > half ? segment.length / 3 * (half / full) : segment.length / 3;
    };
    const double first = leg(a), last = leg(b);
    const size_t axis = arc_->box.chart.axis();
    const auto [lower, upper] = std::minmax({a.at[axis], b.at[axis]});
    for (size_t i = 0; i < 4; ++i) {
        auto &on = segment.on[i / 2];
        const size_t k = i % 2;
        const double second = a.at[i] + first * a.tangent_on[i], third = b.at[i] - last * b.tangent_on[i];
        on[0][k] = a.at[i];
        on[1][k] = i == axis ? std::clamp(second, lower, upper) : second;
        on[2][k] = i == axis ? std::clamp(third, lower, upper) : third;
        on[3][k] = b.at[i];
    }
    stay_in_pieces(segment);
    for (size_t c = 0; c < 3; ++c) {
        segment.space[0][c] = a.point[c];
        segment.space[1][c] = a.point[c] + first * a.tangent[c];
        segment.space[2][c] = b.point[c] - last * b.tangent[c];
        segment.space[3][c] = b.point[c];
    }
    return segment;
}

// Moves places beyond the border of a piece onto it, where the polynomials of the piece are those of the
// surface. They are beyond by no more than sides are shifted, or than arcs along the border are.
void CrossFitter::stay_in_pieces(CrossSegment &segment) const noexcept {
    for (size_t i = 0; i < 4; ++i) {
        const CrossCell &cell = arc_->box.cell(i);
        const size_t k = i % 2;
        const Interval range{cell.is_border(k, 0) ? 0 : -infinity, cell.is_border(k, 1) ? 1 : infinity};
        for (std::array<double, 2> &place : segment.on[i / 2]) {
            place[k] = std::clamp(place[k], range.lower, range.upper);
        }
    }
}

double CrossFitter::moved_by(const CrossPlace &off, size_t surface) const noexcept {
    return slopes_[2 * surface] * off[2 * surface] + slopes_[2 * surface + 1] * off[2 * surface + 1];
}

double CrossFitter::largest_gap(const CrossSegment &segment, size_t surface) {
    static constexpr std::array<double, 4> no_form{};
    const CrossCell &cell = surface == 0 ? *arc_->box.a : *arc_->box.b;
    std::array<std::array<double, 2>, 4> on;
    for (size_t i = 0; i < 4; ++i) {
        on[i] = cell.in_piece(segment.on[surface][i].data());
    }
    const SampledPiece piece{{cell.piece().degrees, cell.piece().piece.record(0)}, no_form.data(), {}};
    count_work(static_cast<int64_t>(samples_.count()) * 4 * cell.piece().piece.coefficients());
    return 1.01 * std::numbers::sqrt2 *
           largest_differences(piece, samples_, on, segment.space, sampling_.data()).gap /
           cell.least_weight();
}

// Limits `off`, the distance of places from the arc, by the box. For each value of coordinate k between those
// of its ends, the arc has a zero in the box, or beyond a border that it runs along by no more than the room
// there; so no place is farther from that zero than from the farther of these sides. False: places may be
// outside that range of k, or outside the wide parts.
bool CrossFitter::limit_to_box(const CrossSegment &segment, CrossPlace &off) const noexcept {
    const CrossBox &box = arc_->box;
    const size_t axis = box.chart.axis();
    const auto [first, last] = std::minmax({arc_->ends[0].at[axis], arc_->ends[1].at[axis]});
    for (size_t i = 0; i < 4; ++i) {
        const size_t k = i % 2;
        const CrossCell &cell = box.cell(i);
        const double room = 64 * shift_of_sides / cell.length(k);
        const Interval sides{box.side(i, 0) - (arc_->along ? cell.room(k, 0) : 0),
                             box.side(i, 1) + (arc_->along ? cell.room(k, 1) : 0)};
        const Interval range =
            i == axis ? Interval{first - room, last + room} : Interval{-widening, 1 + widening};
        double farthest = 0;
        for (const std::array<double, 2> &place : segment.on[i / 2]) {
            if (!(place[k] >= range.lower && place[k] <= range.upper)) {
                return false;
            }
            farthest = std::max({farthest, place[k] - sides.lower, sides.upper - place[k]});
        }
        off[i] = std::min(off[i], farthest);
    }
    return true;
}

void CrossFitter::set_deviation(CrossSegment &segment) {
    const std::array<double, 2> gaps{largest_gap(segment, 0), largest_gap(segment, 1)};
    CrossPlace off = arc_->box.chart.off_at(gaps[0] + gaps[1] + arc_->box.chart.near());
    if (!limit_to_box(segment, off)) {
        segment.deviation = infinity;
        return;
    }
    const double on_a = moved_by(off, 0), on_b = moved_by(off, 1),
                 in_space = std::min(gaps[0] + on_a, gaps[1] + on_b);
    segment.deviation = std::max({on_a, on_b, in_space}) + rounding_ + arc_->box.chart.near();
}

void CrossFitter::fit_between(const Node &a, const Node &b, int depth, std::vector<CrossSegment> &segments) {
    CrossSegment segment = hermite(a, b);
    set_deviation(segment);
    const CrossPlace least_off = arc_->box.chart.off_at(arc_->box.chart.near());
    const double least = rounding_ + std::max(moved_by(least_off, 0), moved_by(least_off, 1));
    const bool done = segment.deviation <= std::max(tolerance_, 2 * least) || left_ <= 0 || work_ended() ||
                      depth >= (std::isfinite(segment.deviation) ? most_depth : most_depth_without_proof);
    if (!done) {
        divide(a, b, segment.deviation, depth, segments);
        return;
    }
    to_parameters(segment);
    segment.slopes = slopes_;
    for (size_t i = 0; i < 4; ++i) {
        const CrossCell &cell = arc_->box.cell(i);
        const Interval &range = cell.piece().range[i % 2];
        segment.slopes[i] /= cell.length(i % 2) * (range.upper - range.lower);
    }
    segments.push_back(segment);
    --left_;
}

void CrossFitter::divide(const Node &a, const Node &b, double deviation, int depth,
                         std::vector<CrossSegment> &segments) {
    const Division division = division_for(deviation, tolerance_);
    const auto between = [&](double share) {
        const auto at = zero_between<4>(arc_->box, a.at, b.at, share);
        return at ? std::optional(node(*at)) : std::nullopt;
    };
    for_each_part(a, b, division.parts, between, [&](const Node &from, const Node &to) {
        fit_between(from, to, depth + division.depth, segments);
    });
}

void CrossFitter::to_parameters(CrossSegment &segment) const noexcept {
    for (size_t s = 0; s < 2; ++s) {
        const CrossCell &cell = s == 0 ? *arc_->box.a : *arc_->box.b;
        for (std::array<double, 2> &place : segment.on[s]) {
            place = cell.in_piece(place.data());
            for (size_t k = 0; k < 2; ++k) {
                const Interval &range = cell.piece().range[k];
                place[k] =
                    place[k] == 1 ? range.upper : range.lower * (1 - place[k]) + range.upper * place[k];
            }
        }
    }
}

void reverse(std::vector<CrossSegment> &segments) noexcept {
    std::ranges::reverse(segments);
    for (CrossSegment &segment : segments) {
        std::ranges::reverse(segment.space);
        std::ranges::reverse(segment.on[0]);
        std::ranges::reverse(segment.on[1]);
    }
}

} // namespace nrb::intersect
