// SPDX-License-Identifier: MIT
#include "intersect/surfaces/overlap/overlap_trace.h"

#include "base/numbers.h"
#include "base/watch.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

constexpr double shortest_step = 0x1p-24; // in lengths of an edge, by its free parameter
constexpr size_t most_segments_of_an_edge = 20000;

} // namespace

std::optional<ContactPoint> OverlapTracer::contact(const OverlapSide &side, const OverlapSide *along,
                                                   const CrossPlace &place) const {
    CrossPlace at = place;
    if (along != nullptr) {
        at[along->fixed()] = along->at;
    }
    const std::array<std::optional<OverlapGround::Point>, 2> points{ground_.point(0, at.data()),
                                                                    ground_.point(1, at.data() + 2)};
    if (!points[0] || !points[1]) {
        return std::nullopt;
    }
    ContactPoint point;
    point.at = at;
    point.a = points[0]->at;
    point.b = points[1]->at;
    const Vector3 normal = cross(points[1]->slope[0], points[1]->slope[1]),
                  tangent = points[side.surface]->slope[1 - side.axis];
    const double size = length(normal), speed = length(tangent);
    if (!(size > 0 && speed > 0)) {
        return std::nullopt;
    }
    point.normal = (1 / size) * normal;
    point.along = (1 / speed) * tangent;
    point.across = cross(point.normal, point.along);
    for (size_t s = 0; s < 2; ++s) {
        const auto way = parameters_along(points[s]->slope, point.along),
                   other_way = parameters_along(points[s]->slope, point.across);
        for (size_t k = 0; k < 2; ++k) {
            point.along_on[2 * s + k] = way[k];
            point.across_on[2 * s + k] = other_way[k];
        }
    }
    point.along_on[side.fixed()] = 0;
    point.along_on[side.free()] = 1 / speed;
    if (along != nullptr) {
        point.along_on[along->fixed()] = 0;
    }
    return point;
}

std::optional<std::vector<CrossSegment>> OverlapTracer::trace(const OverlapSide &side,
                                                              const OverlapSide *along,
                                                              const CrossPlace &start,
                                                              const CrossPlace &end) const {
    const size_t free = side.free();
    const double whole = end[free] - start[free];
    std::vector<CrossSegment> segments;
    std::optional<ContactPoint> from = contact(side, along, start);
    double length = whole / 4;
    while (from && from->at[free] < end[free]) {
        count_work(1000);
        const std::optional<CrossPlace> to = step(side, from->at, end, length);
        const std::optional<ContactPoint> there = to ? contact(side, along, *to) : std::nullopt;
        CrossSegment segment;
        if (there && tracer_.fit(*from, *there, 1, segment)) {
            segments.push_back(segment);
            from = there;
            length *= segment.deviation < near_ / 32 ? 1.5 : 1;
            continue;
        }
        length = std::min(length, end[free] - from->at[free]) / 2;
        if (length < shortest_step * whole || segments.size() > most_segments_of_an_edge || work_ended()) {
            return std::nullopt;
        }
    }
    if (!from || segments.empty()) {
        return std::nullopt;
    }
    set_end(start, segments.front(), 0);
    set_end(end, segments.back(), 3);
    return segments;
}

// Makes the coordinates of an end equal to those of the node, bit for bit, where they are in the same period.
void OverlapTracer::set_end(const CrossPlace &at, CrossSegment &segment, size_t place) const noexcept {
    for (size_t i = 0; i < 4; ++i) {
        double &x = segment.on[i / 2][place][i % 2];
        if (std::abs(x - at[i]) <= 0x1p-40 * ground_.borders(i / 2).period(i % 2)) {
            x = at[i];
        }
    }
}

// The place after a step of this length of the free parameter, or the end if that is little farther, or the
// first break on the way there.
std::optional<CrossPlace> OverlapTracer::step(const OverlapSide &side, const CrossPlace &from,
                                              const CrossPlace &end, double length) const {
    const size_t free = side.free();
    std::optional<CrossPlace> to = end;
    if (length < 0.8 * (end[free] - from[free])) {
        to = follower_.next(side, from, from[free] + length);
    }
    return to && stop_at_break(side, from, *to) && (*to)[free] > from[free] ? to : std::nullopt;
}

// Shortens a step so that it ends at the first break on its way; false: that is not found.
bool OverlapTracer::stop_at_break(const OverlapSide &side, const CrossPlace &from, CrossPlace &to) const {
    const auto [coordinate, share, at] = tracer_.first_break(from, to);
    if (coordinate == 4) {
        return true;
    }
    if (coordinate == side.free()) {
        const std::optional<CrossPlace> next = follower_.next(side, from, at);
        to = next.value_or(from);
        return next.has_value();
    }
    return stop_at_line(side, from, coordinate, at, to);
}

// Newton's method, kept in a bracket by bisection, for the place of the side at which a coordinate of the
// other surface reaches a line.
bool OverlapTracer::stop_at_line(const OverlapSide &side, const CrossPlace &from, size_t coordinate,
                                 double line, CrossPlace &to) const {
    constexpr int steps = 12;
    const size_t free = side.free();
    const bool rises = to[coordinate] > from[coordinate];
    double lower = from[free], upper = to[free],
           t = lower + (line - from[coordinate]) / (to[coordinate] - from[coordinate]) * (upper - lower);
    for (int i = 0; i < steps; ++i) {
        const std::optional<CrossPlace> next = follower_.next(side, from, t);
        const std::optional<ContactPoint> point = next ? contact(side, nullptr, *next) : std::nullopt;
        if (!point) {
            return false;
        }
        to = *next;
        const double off = line - to[coordinate];
        ((off > 0) == rises ? lower : upper) = t;
        const double by = off / point->along_on[coordinate] * point->along_on[free];
        t = t + by > lower && t + by < upper ? t + by : lower / 2 + upper / 2;
        if (std::abs(by) <= 0x1p-50 * (upper - from[free])) {
            break;
        }
    }
    to[coordinate] = line;
    return true;
}

} // namespace nrb::intersect
