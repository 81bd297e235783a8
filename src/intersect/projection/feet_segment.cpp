// SPDX-License-Identifier: MIT
#include "intersect/projection/feet_segment.h"

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
// |h'| is no larger than the speed of the points, except where the normal flips, so that h jumps to -h. With
// a margin.
constexpr double most_rise = 2;
// The value of F at a foot.
constexpr std::array<double, 2> no_value{};

// The larger of the degrees of F along a cubic, and of h^2 - |S - C|^2 times the squares of both weights.
int degree_of_samples(const std::array<int, 2> &surface, int curve) noexcept {
    const int both = surface[0] + surface[1];
    return 3 * std::max(3 * both + curve, 2 * (both + curve + 1));
}

std::array<double, 3> coordinates(const Vector3 &a) noexcept {
    return {a.x, a.y, a.z};
}

double least_weight_of(const pieces::BezierPiece &piece) noexcept {
    double least = infinity;
    for (int64_t i = 0; i < piece.coefficients(); ++i) {
        least = std::min(least, piece.weight(i));
    }
    return least;
}

} // namespace

FeetFitter::FeetFitter(const std::array<int, 2> &surface, int curve, const pieces::Frame &frame,
                       double tolerance)
    : frame_(frame), tolerance_(tolerance), samples_(2 * degree_of_samples(surface, curve)),
      sampling_(16 * static_cast<size_t>(3 * std::max({surface[0], surface[1], curve}) + 1)) {}

void FeetFitter::set_arc(const FeetArc &arc) {
    arc_ = &arc;
    left_ = most_segments;
    const FeetNet &net = arc.box.patch->net(), &curve = arc.box.span->net();
    const pieces::BezierPiece &piece = net.piece->piece;
    least_weight_ = least_weight_of(piece);
    least_of_curve_ = infinity;
    for (size_t i = 0; i < curve.values.size(); i += 4) {
        least_of_curve_ = std::min(least_of_curve_, curve.values[i]);
    }
    rounding_ = net.piece->error + curve.piece->error;
    for (size_t i = 0; i < 3; ++i) {
        const FeetCell &cell = arc.box.cell(i);
        const double speed = cell.net().speeds[i % 2];
        const Interval &range = cell.piece().range[i % 2];
        speeds_[i] = speed * cell.length(i % 2);
        rounding_ += speed * 2 * eps * std::max(std::abs(range.lower), std::abs(range.upper)) /
                     (range.upper - range.lower);
    }
}

FeetFitter::Node FeetFitter::node(const FeetPlace &at) const noexcept {
    const FeetBox &box = arc_->box;
    const FeetBox::Contact contact = box.contact_at(at);
    Node node{at, box.tangent_at(at), coordinates(contact.surface), {}, {}, contact.distance, 0};
    const Vector3 along = node.tangent_on[0] * contact.slopes[0] + node.tangent_on[1] * contact.slopes[1],
                  of_curve = node.tangent_on[2] * contact.slope;
    const double speed = std::hypot(length(along), length(of_curve));
    if (speed > 0) {
        for (double &x : node.tangent_on) {
            x /= speed;
        }
        node.tangent = coordinates((1 / speed) * along);
        node.tangent_of_curve = coordinates((1 / speed) * of_curve);
        node.slope = -dot((1 / speed) * of_curve, contact.normal);
    } else {
        node.tangent_on = {};
    }
    return node;
}

double FeetFitter::distance_at(const FeetArc &arc, const FeetPlace &at) const noexcept {
    return frame_.unscaled(arc.box.contact_at(at).distance);
}

void FeetFitter::fit(const FeetArc &arc, std::vector<CrossSegment> &segments) {
    set_arc(arc);
    fit_between(node(arc.ends[0].at), node(arc.ends[1].at), 0, segments);
}

// See CrossFitter::hermite(). Where the foot stands still in space, tangents are no measure of the legs:
// these are at most half of the way in places.
CrossSegment FeetFitter::hermite(const Node &a, const Node &b) const noexcept {
    const FeetBox &box = arc_->box;
    const Vector3 gone = box.contact_at(b.at).curve - box.contact_at(a.at).curve;
    const double chord = std::hypot(distance(a.point.data(), b.point.data(), 3), length(gone)),
                 cosine = dot(a.tangent.data(), b.tangent.data(), 3) +
                          dot(a.tangent_of_curve.data(), b.tangent_of_curve.data(), 3);
    CrossSegment segment;
    segment.length = chord * (1 + (1 - cosine) / 12);
    FeetPlace way{};
    std::ranges::transform(a.at, b.at, way.begin(), std::minus<>());
    const auto leg = [&](const Node &node) {
        const double full = segment.length / 3 * largest(node.tangent_on), half = largest(way) / 2;
        return full > half ? segment.length / 3 * (half / full) : segment.length / 3;
    };
    const double first = leg(a), last = leg(b);
    const size_t axis = box.chart.axis();
    const auto [lower, upper] = std::minmax({a.at[axis], b.at[axis]});
    for (size_t i = 0; i < 3; ++i) {
        auto &on = segment.on[i / 2];
        const size_t k = i % 2;
        const double second = a.at[i] + first * a.tangent_on[i], third = b.at[i] - last * b.tangent_on[i];
        on[0][k] = a.at[i];
        on[1][k] = i == axis ? std::clamp(second, lower, upper) : second;
        on[2][k] = i == axis ? std::clamp(third, lower, upper) : third;
        on[3][k] = b.at[i];
    }
    const std::array<double, 4> h{a.distance, a.distance + first * a.slope, b.distance - last * b.slope,
                                  b.distance};
    for (size_t i = 0; i < 4; ++i) {
        segment.on[1][i][1] = h[i];
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

void FeetFitter::stay_in_pieces(CrossSegment &segment) const noexcept {
    for (size_t i = 0; i < 3; ++i) {
        const FeetCell &cell = arc_->box.cell(i);
        const size_t k = i % 2;
        const Interval range{cell.is_border(k, 0) ? 0 : -infinity, cell.is_border(k, 1) ? 1 : infinity};
        for (std::array<double, 2> &place : segment.on[i / 2]) {
            place[k] = std::clamp(place[k], range.lower, range.upper);
        }
    }
}

FeetPlace FeetFitter::off_at(const std::array<double, 2> &value) const noexcept {
    const FeetChart &chart = arc_->box.chart;
    FeetPlace off = chart.largest_step(value);
    for (size_t i = 0; i < 3; ++i) {
        off[i] += chart.noise(i);
    }
    return chart.off_at(off);
}

LargestOfFeet FeetFitter::largest_on(const CrossSegment &segment) {
    const FeetBox &box = arc_->box;
    const FeetNet &net = box.patch->net(), &curve = box.span->net();
    auto on = segment.on;
    for (size_t i = 0; i < 4; ++i) {
        on[0][i] = box.patch->in_piece(on[0][i]);
        on[1][i][0] = box.span->in_piece({on[1][i][0], 0})[0];
    }
    count_work(static_cast<int64_t>(samples_.count() * (net.values.size() + 200)));
    return largest_of_feet({{net.degrees, net.values.data()},
                            {curve.degrees, curve.values.data()},
                            {net.piece->degrees, net.piece->piece.record(0)}},
                           samples_, on, segment.space, sampling_.data());
}

// See CrossFitter::limit_to_box().
bool FeetFitter::limit_to_box(const CrossSegment &segment, FeetPlace &off) const noexcept {
    const FeetBox &box = arc_->box;
    const size_t axis = box.chart.axis();
    const auto [first, last] = std::minmax({arc_->ends[0].at[axis], arc_->ends[1].at[axis]});
    for (size_t i = 0; i < 3; ++i) {
        const double room = 64 * shift_of_sides / box.length(i);
        const Interval range =
            i == axis ? Interval{first - room, last + room} : Interval{-widening, 1 + widening};
        double farthest = 0;
        for (const std::array<double, 2> &place : segment.on[i / 2]) {
            const double x = place[i % 2];
            if (!(x >= range.lower && x <= range.upper)) {
                return false;
            }
            farthest = std::max({farthest, x - box.side(i, 0), box.side(i, 1) - x});
        }
        off[i] = std::min(off[i], farthest);
    }
    return true;
}

void FeetFitter::set_deviation(CrossSegment &segment) {
    constexpr double between_samples = 1.01 * std::numbers::sqrt2;
    LargestOfFeet most = largest_on(segment);
    for (double &value : most.value) {
        value *= between_samples;
    }
    FeetPlace off = off_at(most.value);
    if (!limit_to_box(segment, off)) {
        segment.deviation = infinity;
        return;
    }
    const double gap = between_samples * std::sqrt(most.gap) / least_weight_,
                 on_surface = speeds_[0] * off[0] + speeds_[1] * off[1], on_curve = speeds_[2] * off[2],
                 weights = least_weight_ * least_of_curve_,
                 squares = between_samples * most.distance / (weights * weights);
    double least = infinity;
    for (const std::array<double, 2> &place : segment.on[1]) {
        const double h = place[1], side = segment.on[1][0][1];
        least = std::min(least, h * side > 0 ? std::abs(h) : 0);
    }
    // Let d = |S - C| and e the difference of d and |h|. As |d^2 - h^2| = e (d + |h|) is at most `squares`, e
    // is at most sqrt(squares) and at most squares / |h|. Where h jumps there is no such bound: segments are
    // divided until they are no longer than the tolerance.
    const double rise = std::abs(segment.on[1][3][1] - segment.on[1][0][1]);
    const double of_distance = rise <= most_rise * segment.length
                                   ? std::min(std::sqrt(squares), least > 0 ? squares / least : infinity)
                               : segment.length > tolerance_ ? rise
                                                             : 0;
    segment.deviation = std::max({gap + on_surface, on_surface + on_curve + of_distance}) + rounding_;
}

double FeetFitter::least_deviation() const noexcept {
    const FeetPlace off = off_at(no_value);
    return rounding_ + speeds_[0] * off[0] + speeds_[1] * off[1] + speeds_[2] * off[2];
}

void FeetFitter::fit_between(const Node &a, const Node &b, int depth, std::vector<CrossSegment> &segments) {
    CrossSegment segment = hermite(a, b);
    set_deviation(segment);
    const bool done = segment.deviation <= std::max(tolerance_, 2 * least_deviation()) || left_ <= 0 ||
                      work_ended() ||
                      depth >= (std::isfinite(segment.deviation) ? most_depth : most_depth_without_proof);
    if (!done) {
        divide(a, b, segment.deviation, depth, segments);
        return;
    }
    to_parameters(segment);
    segments.push_back(segment);
    --left_;
}

void FeetFitter::divide(const Node &a, const Node &b, double deviation, int depth,
                        std::vector<CrossSegment> &segments) {
    const Division division = division_for(deviation, tolerance_);
    const auto between = [&](double share) {
        const auto at = zero_between<3>(arc_->box, a.at, b.at, share);
        return at ? std::optional(node(*at)) : std::nullopt;
    };
    for_each_part(a, b, division.parts, between, [&](const Node &from, const Node &to) {
        fit_between(from, to, depth + division.depth, segments);
    });
}

void FeetFitter::to_parameters(CrossSegment &segment) const noexcept {
    for (size_t i = 0; i < 3; ++i) {
        const FeetCell &cell = arc_->box.cell(i);
        const size_t k = i % 2;
        const Interval &range = cell.piece().range[k];
        for (std::array<double, 2> &place : segment.on[i / 2]) {
            const double at = cell.lower(k) + cell.length(k) * place[k];
            place[k] = at == 1 ? range.upper : range.lower * (1 - at) + range.upper * at;
        }
        segment.slopes[i] = cell.net().speeds[k] / (range.upper - range.lower);
    }
    for (std::array<double, 2> &place : segment.on[1]) {
        place[1] = frame_.unscaled(place[1]);
    }
    segment.slopes[3] = frame_.scaled(1);
}

} // namespace nrb::intersect
