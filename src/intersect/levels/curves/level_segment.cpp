// SPDX-License-Identifier: MIT
#include "intersect/levels/curves/level_segment.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "basis/bspline.h"
#include "bernstein/de_casteljau.h"
#include "intersect/levels/trace/level_trace.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nrb::intersect {

namespace {

constexpr int most_depth = 24, most_depth_without_proof = 6;
// Of an arc: more than errors of the fourth order take to come from 1 to rounding.
constexpr int most_segments = 4096;
// How far around its box an arc may be approximated, in parts of the box.
constexpr double around = 1.0 / 16;

template <size_t N>
std::array<double, N> moved(const std::array<double, N> &from, double by,
                            const std::array<double, N> &along) noexcept {
    std::array<double, N> to = from;
    for (size_t c = 0; c < N; ++c) {
        to[c] += by * along[c];
    }
    return to;
}

} // namespace

ArcFitter::ArcFitter(LevelField &field, double tolerance)
    : field_(field), grid_(field.grid()), tolerance_(tolerance) {
    for (int k = 0; k < grid_.shape().axes; ++k) {
        degrees_[static_cast<size_t>(grid_.spline_axis(k))] = grid_.shape().degree(k);
    }
    const std::array<int, 2> of_field = field.degrees();
    const int n = 3 * std::max(degrees_[0] + degrees_[1] + 1, of_field[0] + of_field[1]);
    factor_ = 1.01 * (1 + 2 / std::numbers::pi * std::log(n + 1.0));
    samples_ = CubicSamples(n);
    const int most = std::max({degrees_[0], degrees_[1], of_field[0], of_field[1]});
    sampling_.resize(16 * (static_cast<size_t>(most) + 1));
    const auto values = static_cast<size_t>(grid_.shape().values());
    patch_.resize(values);
    work_.resize(std::max(values, static_cast<size_t>(pieces::evaluation_work(grid_.shape()))));
    record_.resize(3 * static_cast<size_t>(grid_.shape().lanes));
}

void ArcFitter::set_piece(int64_t piece) {
    if (piece == piece_) {
        return;
    }
    piece_ = piece;
    domain_ = domain_of(grid_, piece);
    net_ = field_.net(piece);
    form_ = field_.form();
    grid_.patch(piece, work_.data(), patch_.data());
    bounds_.set(net_, degrees_, patch_);
}

// Somewhat more than the box, so that tangents at its border need not be bent, where f changes strictly there too.
ArcFitter::Room ArcFitter::room_of(const LevelArc &arc) const {
    const size_t other = 1 - axis_;
    Room room;
    for (size_t k = 0; k < 2; ++k) {
        room.box[k] = {arc.part.lower[k], arc.part.lower[k] + arc.part.length[k]};
    }
    Room wide = room;
    wide.box[other] = {std::max(room.box[other].lower - around * arc.part.length[other], 0.0),
                       std::min(room.box[other].upper + around * arc.part.length[other], 1.0)};
    wide.bounds = bounds_.over(wide.box, other);
    if (wide.bounds.least_slope > 0 && wide.bounds.least_weight > net_.least_weight) {
        return wide;
    }
    room.bounds = bounds_.over(room.box, other);
    return room;
}

// aside: where the curve and the level are along the other axis.
ArcFitter::Room ArcFitter::part_of(const Room &room, const Node &a, const Node &b,
                                   const Interval &aside) const {
    const size_t other = 1 - axis_;
    Room part = room;
    part.box[axis_] = {std::min(a.place[axis_], b.place[axis_]), std::max(a.place[axis_], b.place[axis_])};
    part.box[other] = {std::max(room.box[other].lower, aside.lower),
                       std::min(room.box[other].upper, aside.upper)};
    part.own = true;
    part.bounds = bounds_.over(part.box, other);
    part.bounds.least_slope = std::max(part.bounds.least_slope, room.bounds.least_slope);
    return part;
}

void ArcFitter::evaluate(const std::array<double, 2> &place, int order) {
    pieces::AxisValues at{};
    for (int k = 0; k < grid_.shape().axes; ++k) {
        at[static_cast<size_t>(k)] = place[static_cast<size_t>(grid_.spline_axis(k))];
    }
    pieces::evaluate_patch(grid_.shape(), patch_.data(), at, order, work_.data(), record_.data());
}

// Where the surface stands still along the level, the tangent has length 1 in the parameter domain.
ArcFitter::Node ArcFitter::node(const std::array<double, 2> &place) {
    const std::array<double, 2> slope = net_.at(place).slope;
    evaluate(place, 1);
    const auto lanes = static_cast<size_t>(grid_.shape().lanes);
    Node node{place, {slope[1], -slope[0]}, {}, {}};
    const double w = record_[3];
    for (size_t c = 0; c < 3; ++c) {
        node.point[c] = record_[c] / w;
    }
    double largest = 0;
    for (int k = 0; k < grid_.shape().axes; ++k) {
        const double *by = record_.data() + (static_cast<size_t>(k) + 1) * lanes;
        const double along = node.tangent_on[static_cast<size_t>(grid_.spline_axis(k))];
        for (size_t c = 0; c < 3; ++c) {
            const double term = along * (by[c] - node.point[c] * by[3]) / w;
            node.tangent[c] += term;
            largest = std::max(largest, std::abs(term));
        }
    }
    const double speed = norm(node.tangent.data(), 3);
    if (speed > 1e-9 * largest && speed > 0) {
        for (double &x : node.tangent) {
            x /= speed;
        }
        node.tangent_on = {node.tangent_on[0] / speed, node.tangent_on[1] / speed};
    } else {
        const double length = std::hypot(slope[0], slope[1]);
        node.tangent = {};
        node.tangent_on = {node.tangent_on[0] / length, node.tangent_on[1] / length};
    }
    return node;
}

// On the level, by Newton's method in an interval that closes in.
ArcFitter::Node ArcFitter::node_between(const Room &room, const Node &a, const Node &b, double share) {
    const size_t other = 1 - axis_;
    std::array<double, 2> place = moved(moved({}, 1 - share, a.place), share, b.place);
    Interval range = room.box[other];
    for (int i = 0; i < 60 && range.upper - range.lower > 2 * eps; ++i) {
        const LevelNet::Point point = net_.at(place);
        const double slope = point.slope[other];
        ((point.value > 0) == (slope > 0) ? range.upper : range.lower) = place[other];
        const double next = place[other] - point.value / slope;
        const double last = place[other];
        place[other] = next >= range.lower && next <= range.upper ? next : range.lower / 2 + range.upper / 2;
        if (std::abs(place[other] - last) <= 4 * eps) {
            break;
        }
    }
    return node(place);
}

void ArcFitter::fit(const LevelArc &arc, std::vector<LevelSegment> &segments) {
    if (arc.is_point()) {
        return;
    }
    set_piece(arc.part.piece);
    axis_ = arc.axis;
    left_ = most_segments;
    fit_between(node(arc.first), node(arc.last), room_of(arc), nullptr, segments);
}

// Rounding is what more segments do not mend.
bool ArcFitter::is_good(const Room &room, const LevelSegment &segment) const noexcept {
    if (segment.deviation <= tolerance_ || room.depth >= most_depth || left_ <= 0 || work_ended()) {
        return true;
    }
    const double least = rounding(room.bounds) + room.bounds.moves[1 - axis_] * away_at(room, 0);
    return std::isfinite(segment.deviation) ? room.own && segment.deviation <= 2 * least
                                            : room.depth >= most_depth_without_proof;
}

// sampled: the same one in another room, if it was looked at there.
void ArcFitter::fit_between(const Node &a, const Node &b, const Room &room, const LevelSegment *sampled,
                            std::vector<LevelSegment> &segments) {
    LevelSegment segment = hermite(a, b, room);
    if (sampled != nullptr && sampled->on == segment.on) {
        segment.largest_value = sampled->largest_value;
        segment.largest_gap = sampled->largest_gap;
    }
    const double away = set_deviation(room, segment);
    count_work(static_cast<int64_t>(samples_.count()) * 16 * std::ssize(net_.values));
    if (is_good(room, segment)) {
        for (std::array<double, 2> &place : segment.on) {
            place = {domain_.parameter(0, place[0]), domain_.parameter(1, place[1])};
        }
        segments.push_back(segment);
        --left_;
        return;
    }
    if (room.own || room.depth == 0) {
        divide(a, b, room, segment, segments);
        return;
    }
    Interval aside{infinity, -infinity};
    for (const std::array<double, 2> &place : segment.on) {
        aside = {std::min(aside.lower, place[1 - axis_] - away),
                 std::max(aside.upper, place[1 - axis_] + away)};
    }
    count_work(40 * std::ssize(net_.values));
    const LevelSegment same = segment;
    fit_between(a, b, part_of(room, a, b, aside), &same, segments);
}

// Errors fall with the fourth power of the length.
void ArcFitter::divide(const Node &a, const Node &b, const Room &room, const LevelSegment &segment,
                       std::vector<LevelSegment> &segments) {
    const double wanted = std::ceil(1.05 * std::sqrt(std::sqrt(segment.deviation / tolerance_)));
    const int parts = wanted < 16 ? std::max(static_cast<int>(wanted), 2) : std::isfinite(wanted) ? 16 : 2;
    Room next = room;
    next.depth += parts > 8 ? 4 : parts > 4 ? 3 : parts > 2 ? 2 : 1;
    next.own = false;
    Node from = a;
    for (int i = 1; i <= parts; ++i) {
        const Node to = i == parts ? b : node_between(room, a, b, static_cast<double>(i) / parts);
        fit_between(from, to, next, nullptr, segments);
        from = to;
    }
}

// As long as an arc of a circle with that chord and these tangents.
LevelSegment ArcFitter::hermite(const Node &a, const Node &b, const Room &room) const noexcept {
    const double chord = distance(a.point.data(), b.point.data(), 3),
                 cosine = dot(a.tangent.data(), b.tangent.data(), 3);
    const bool still = norm(a.tangent.data(), 3) == 0 || norm(b.tangent.data(), 3) == 0;
    LevelSegment segment;
    segment.length = still ? std::hypot(a.place[0] - b.place[0], a.place[1] - b.place[1])
                           : chord * (1 + (1 - cosine) / 12);
    // Where the surface all but stands still tangents are no measure: legs are no longer than the chord.
    const double step = std::hypot(a.place[0] - b.place[0], a.place[1] - b.place[1]);
    const auto leg = [&](const Node &node) {
        const double full = segment.length / 3 * std::hypot(node.tangent_on[0], node.tangent_on[1]);
        return full > step ? segment.length / 3 * (step / full) : segment.length / 3;
    };
    const double first = leg(a), last = leg(b);
    segment.on = {a.place, moved(a.place, first, a.tangent_on), moved(b.place, -last, b.tangent_on), b.place};
    segment.space = {a.point, moved(a.point, first, a.tangent), moved(b.point, -last, b.tangent), b.point};
    std::array<Interval, 2> box = room.box;
    box[axis_] = {std::min(a.place[axis_], b.place[axis_]), std::max(a.place[axis_], b.place[axis_])};
    for (size_t i = 1; i < 3; ++i) {
        for (size_t k = 0; k < 2; ++k) {
            segment.on[i][k] = std::clamp(segment.on[i][k], box[k].lower, box[k].upper);
        }
    }
    return segment;
}

// Of points, and of parameters, which have no more digits than those of the domain.
double ArcFitter::rounding(const PartBounds &bounds) const noexcept {
    double sum =
        grid_.moved_by_weights(grid_.radius(), bounds.least_weight) + grid_.moved() + 4 * eps * grid_.size();
    for (size_t k = 0; k < 2; ++k) {
        const double lower = domain_.lower[k], upper = domain_.upper[k];
        sum += bounds.moves[k] * 2 * eps * std::max(std::abs(lower), std::abs(upper)) / (upper - lower);
    }
    return sum;
}

// The arc and the segment are in one box: near places where branches meet, and f has no slope, that says more than f does.
double ArcFitter::away_at(const Room &room, double value) const noexcept {
    const size_t other = 1 - axis_;
    return std::min((value + net_.noise.of(room.bounds.largest_weight)) / room.bounds.least_slope,
                    room.box[other].upper - room.box[other].lower);
}

void ArcFitter::sample(LevelSegment &segment) noexcept {
    if (segment.largest_value < 0) {
        const SampledPiece piece{
            {degrees_, patch_.data()}, form_ ? form_->data() : nullptr, {net_.degrees, net_.values.data()}};
        const auto [value, gap] =
            largest_differences(piece, samples_, segment.on, segment.space, sampling_.data());
        segment.largest_value = value;
        segment.largest_gap = gap;
    }
}

double ArcFitter::set_deviation(const Room &room, LevelSegment &segment) {
    const PartBounds &bounds = room.bounds;
    segment.deviation = infinity;
    if (!(bounds.least_slope > 0) || !(bounds.least_weight > net_.least_weight)) {
        return infinity;
    }
    sample(segment);
    const double away = away_at(room, factor_ * segment.largest_value);
    segment.deviation = factor_ * segment.largest_gap / bounds.least_weight + bounds.moves[1 - axis_] * away +
                        rounding(bounds);
    return away;
}

} // namespace nrb::intersect
