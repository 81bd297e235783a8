// SPDX-License-Identifier: MIT
#include "intersect/surfaces/contact/contact_trace.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "intersect/surfaces/curves/cubic.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace nrb::intersect {

namespace {

constexpr double shortest = 0x1p-24, longest = 0x1p-2, first_length = 0x1p-5; // of steps, in the frame
constexpr size_t places_of_a_curve = 20000;
// In lengths of pieces: a coordinate that is no farther from a side of a piece is on it.
constexpr double on_side = 0x1p-26;

std::array<double, 3> coordinates(const Vector3 &x) noexcept {
    return {x.x, x.y, x.z};
}

} // namespace

ContactTracer::ContactTracer(const ContactSolver &solver, const std::array<int, 2> &degrees_a,
                             const std::array<int, 2> &degrees_b, double tolerance)
    : solver_(solver), tolerance_(tolerance), samples_(CrossFitter::samples_for(degrees_a, degrees_b)),
      sampling_(CrossFitter::sampling_for(degrees_a, degrees_b)) {}

std::optional<ContactPoint> ContactTracer::next(const ContactPoint &from, double length) const {
    CrossPlace at = from.at;
    for (size_t i = 0; i < 4; ++i) {
        at[i] += length * from.along_on[i];
    }
    std::optional<ContactPoint> to = solver_.ridge(at);
    if (to && dot(to->along, from.along) < 0) {
        to->along = -1 * to->along;
        for (double &x : to->along_on) {
            x = -x;
        }
    }
    const bool good = to && std::abs(to->height) <= zero_height(solver_.error()) &&
                      dot(to->along, from.along) >= 0.8 && std::abs(to->least) <= 0x1p-4 * std::abs(to->most);
    return good ? to : std::nullopt;
}

double ContactTracer::break_between(size_t i, double from, double to) const noexcept {
    const CrossGround &ground = solver_.ground(i / 2);
    const pieces::PieceGrid &grid = ground.grid;
    const int axis = static_cast<int>(i % 2);
    const double period = ground.borders.period(i % 2), start = grid.break_at(axis, 0);
    const double turns = ground.borders.wraps(i % 2) ? std::floor((std::min(from, to) - start) / period) : 0;
    const double room = on_side * period / static_cast<double>(grid.count(axis));
    double first = std::numeric_limits<double>::quiet_NaN();
    for (const double shift : {turns * period, (turns + 1) * period}) {
        for (int64_t k = 0; k <= grid.count(axis); ++k) {
            const double at = grid.break_at(axis, k) + shift;
            if (at > std::min(from, to) + room && at < std::max(from, to) - room &&
                !(std::abs(at - from) >= std::abs(first - from))) {
                first = at;
            }
        }
        if (!ground.borders.wraps(i % 2)) {
            break;
        }
    }
    return first;
}

bool ContactTracer::is_border(size_t i, double at) const noexcept {
    const CrossGround &ground = solver_.ground(i / 2);
    const pieces::PieceGrid &grid = ground.grid;
    const int axis = static_cast<int>(i % 2);
    if (ground.borders.wraps(i % 2)) {
        return false;
    }
    const int64_t k = grid.find(axis, at);
    return (at <= grid.break_at(axis, k) && !ground.borders.goes_on(i % 2, k, false)) ||
           (at >= grid.break_at(axis, k + 1) && !ground.borders.goes_on(i % 2, k, true));
}

ContactTracer::Break ContactTracer::first_break(const CrossPlace &from, const CrossPlace &to) const noexcept {
    Break first;
    for (size_t i = 0; i < 4; ++i) {
        const double at = break_between(i, from[i], to[i]), share = (at - from[i]) / (to[i] - from[i]);
        if (share < first.share) {
            first = {i, share, at};
        }
    }
    return first;
}

// Shortens a step so that it ends where the first coordinate reaches a side of its piece.
bool ContactTracer::stop_at_break(const ContactPoint &from, double way, Step &result) const {
    constexpr int most_tries = 8;
    const Break first = first_break(from.at, result.to.at);
    if (first.coordinate == 4) {
        return true;
    }
    double length = first.share * way;
    for (int i = 0; i < most_tries; ++i) {
        const std::optional<ContactPoint> to = next(from, length);
        if (!to) {
            return false;
        }
        result.to = *to;
        const double off = first.at - to->at[first.coordinate], by = off / to->along_on[first.coordinate];
        if (!std::isfinite(by) || std::abs(by) <= 0x1p-48) {
            break;
        }
        length += by;
    }
    result.to.at[first.coordinate] = first.at;
    result.border = is_border(first.coordinate, first.at);
    return std::abs(length) <= 1.5 * std::abs(way) && length * way > 0;
}

// A bound of the distance of a segment from a surface. Moves its parameters into the range of the piece that
// the middle is in; infinite if they do not fit.
double ContactTracer::largest_gap(size_t surface, CrossSegment &segment, const CrossPlace &middle) const {
    static constexpr std::array<double, 4> no_form{};
    const CrossPiece *const piece = solver_.piece_at(surface, middle.data() + 2 * surface);
    if (piece == nullptr) {
        return infinity;
    }
    std::array<std::array<double, 2>, 4> places;
    for (size_t j = 0; j < 4; ++j) {
        places[j] = solver_.place_in(surface, *piece, segment.on[surface][j].data());
        for (size_t k = 0; k < 2; ++k) {
            const double inside = std::clamp(places[j][k], 0.0, 1.0);
            if (std::abs(inside - places[j][k]) > 0x1p-8) {
                return infinity;
            }
            places[j][k] = inside;
            const Interval &range = piece->range[k];
            segment.on[surface][j][k] =
                inside == 1 ? range.upper : range.lower * (1 - inside) + range.upper * inside;
        }
    }
    double least_weight = infinity;
    for (int64_t i = 0; i < piece->piece.coefficients(); ++i) {
        least_weight = std::min(least_weight, piece->piece.weight(i));
    }
    const SampledPiece sampled{{piece->degrees, piece->piece.record(0)}, no_form.data(), {}};
    count_work(static_cast<int64_t>(samples_.count()) * 4 * piece->piece.coefficients());
    return 1.01 * std::numbers::sqrt2 *
               largest_differences(sampled, samples_, places, segment.space, sampling_.data()).gap /
               least_weight +
           8 * piece->error;
}

bool ContactTracer::fit(const ContactPoint &from, const ContactPoint &to, double way,
                        CrossSegment &segment) const {
    const double sign = way < 0 ? -1 : 1;
    const Vector3 start = 0.5 * (from.a + from.b), end = 0.5 * (to.a + to.b), chord = end - start;
    segment.length = length(chord) * (1 + (1 - dot(from.along, to.along)) / 12);
    const double leg = segment.length / 3 * sign;
    segment.space = {coordinates(start), coordinates(start + leg * from.along),
                     coordinates(end - leg * to.along), coordinates(end)};
    CrossPlace middle{};
    for (size_t i = 0; i < 4; ++i) {
        auto &on = segment.on[i / 2];
        on[0][i % 2] = from.at[i];
        on[1][i % 2] = from.at[i] + leg * from.along_on[i];
        on[2][i % 2] = to.at[i] - leg * to.along_on[i];
        on[3][i % 2] = to.at[i];
        middle[i] = from.at[i] / 2 + to.at[i] / 2;
        segment.slopes[i] = 2 / std::max(std::abs(from.along_on[i]), std::abs(from.across_on[i]));
    }
    segment.deviation = std::max(largest_gap(0, segment, middle), largest_gap(1, segment, middle));
    return segment.deviation <= tolerance_;
}

// False: the curve is not found there, or the deviation of the segment is too large.
bool ContactTracer::step(const ContactPoint &from, double way, Step &result) const {
    const std::optional<ContactPoint> to = next(from, way);
    if (!to) {
        return false;
    }
    result.to = *to;
    result.border = false;
    return stop_at_break(from, way, result) && fit(from, result.to, way, result.segment);
}

ContactTracer::End ContactTracer::follow(const ContactPoint &start, double way,
                                         std::vector<ContactPoint> &places,
                                         std::vector<CrossSegment> &segments) {
    ContactPoint from = start;
    double step_length = first_length;
    while (places.size() < places_of_a_curve && !work_ended()) {
        count_work(1000);
        const Vector3 back = start.a - from.a;
        Step result;
        if (places.size() >= 3 && length(back) <= 1.5 * step_length && way * dot(back, from.along) > 0 &&
            dot(from.along, start.along) > 0.8) {
            result.to = start;
            for (size_t i = 0; i < 4; ++i) {
                const double period = solver_.ground(i / 2).borders.period(i % 2);
                result.to.at[i] += period * std::round((from.at[i] - start.at[i]) / period);
            }
            if (fit(from, result.to, way, result.segment)) {
                segments.push_back(result.segment);
                return End::closed;
            }
        }
        if (!step(from, way * step_length, result)) {
            step_length /= 2;
            if (step_length < shortest) {
                return End::lost;
            }
            continue;
        }
        places.push_back(result.to);
        segments.push_back(result.segment);
        if (result.border) {
            return End::border;
        }
        from = result.to;
        if (result.segment.deviation < tolerance_ / 32) {
            step_length = std::min(1.5 * step_length, longest);
        }
    }
    return End::lost;
}

ContactCurve ContactTracer::trace(const ContactPoint &start) {
    ContactCurve curve;
    curve.places.push_back(start);
    const End forward = follow(start, 1, curve.places, curve.segments);
    curve.closed = forward == End::closed;
    if (curve.closed) {
        return curve;
    }
    std::vector<ContactPoint> places;
    std::vector<CrossSegment> segments;
    const End backward = follow(start, -1, places, segments);
    curve.ends = forward == End::border && backward == End::border;
    std::ranges::reverse(places);
    reverse(segments);
    curve.places.insert(curve.places.begin(), places.begin(), places.end());
    curve.segments.insert(curve.segments.begin(), segments.begin(), segments.end());
    return curve;
}

bool ContactTracer::is_contact(const ContactCurve &curve, double change) const {
    const double step = std::sqrt(4 * tolerance_ / change);
    const double error = zero_height(solver_.error());
    for (size_t i = 0; i + 1 < curve.places.size() || (curve.closed && i < curve.places.size()); ++i) {
        const ContactPoint &from = curve.places[i];
        const double way = curve.segments[i].length;
        if (!(way / step >= 0)) {
            return false; // infinite or not numbers
        }
        const int parts = static_cast<int>(std::min(std::ceil(way / step), 1e6));
        const double sign =
            dot((i + 1 < curve.places.size() ? curve.places[i + 1] : curve.places[0]).a - from.a,
                from.along) < 0
                ? -1
                : 1;
        ContactPoint at = from;
        for (int k = 1; k < parts; ++k) {
            const std::optional<ContactPoint> to = next(at, sign * way / parts);
            if (work_ended() || !to || std::abs(to->height) > error) {
                return false;
            }
            at = *to;
        }
    }
    return true;
}

// Compares points in space, and all parameters to within a fraction of their periods, since a surface may
// pass through one point twice.
bool ContactTracer::passes(const ContactCurve &curve, const ContactPoint &place) const noexcept {
    constexpr int parts = 32;
    for (const CrossSegment &segment : curve.segments) {
        if (length(Cubic(segment.space).at(0) - place.a) > 2 * segment.length + tolerance_) {
            continue;
        }
        const double bow = (segment.length / parts) * (segment.length / parts);
        Vector3 from = Cubic(segment.space).at(0);
        for (int i = 1; i <= parts; ++i) {
            const Vector3 to = Cubic(segment.space).at(static_cast<double>(i) / parts), way = to - from;
            const double share =
                std::clamp(dot(place.a - from, way) / std::max(dot(way, way), 1e-300), 0.0, 1.0);
            if (length(place.a - from - share * way) <= tolerance_ + bow &&
                are_near(segment, (i - 1 + share) / parts, place)) {
                return true;
            }
            from = to;
        }
    }
    return false;
}

bool ContactTracer::are_near(const CrossSegment &segment, double t,
                             const ContactPoint &place) const noexcept {
    constexpr double near = 0x1p-4;
    bool all = true;
    for (size_t i = 0; i < 4; ++i) {
        const double period = solver_.ground(i / 2).borders.period(i % 2);
        const double turns = (Cubic(segment.on[i / 2]).coordinate(i % 2, t) - place.at[i]) / period;
        all = all && std::abs(turns - std::round(turns)) <= near;
    }
    return all;
}

} // namespace nrb::intersect
