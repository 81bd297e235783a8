// SPDX-License-Identifier: MIT
// Traces the zeros of N - 1 equations in N unknowns in a box in which they are a graph over one coordinate.
#pragma once

#include "base/numbers.h"
#include "intersect/contraction.h"
#include "intersect/wide_part.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace nrb::intersect {

// A zero on the boundary of a box.
template <size_t N>
struct GraphEnd {
    Place<N> at{};         // local parameters in the parts
    size_t coordinate = 0; // the coordinate of the side on which it is
    size_t side = 0;       // 0: the lower one; 1: the upper one
    bool open = false;     // the shape of which the box is a part ends there
};

enum class GraphVerdict {
    nothing, // certainly nothing that counts
    arc,     // exactly one arc
    open,    // the box is too large to decide
};

// The zero with coordinate k at a share of the way from one zero to another; none if it is not found.
template <size_t N, class Box>
std::optional<Place<N>> zero_between(const Box &box, const Place<N> &from, const Place<N> &to, double share) {
    Place<N> at{};
    for (size_t i = 0; i < N; ++i) {
        at[i] = (1 - share) * from[i] + share * to[i];
    }
    return box.solve(box.chart.axis(), at) ? std::optional(at) : std::nullopt;
}

// The zeros are a graph over coordinate k, and differences of zeros have known signs. So all that has to be
// found is one zero in the box, and the two places where the curve through it leaves the box. Box provides
// - chart: axis() (k), direction(), shift(i), rise(i), holds_at(z), drift(...) as in CrossChart; noise(i),
//   noise(): error bounds of M F;
// - side(i, end): where the box ends, as a local parameter; length(i): that of the part, as a share of its
//   piece;
// - start(): a place where the chart holds; step_at(z): M F; tangent_at(z): a tangent of the graph, of any
//   length;
// - solve(i, z): Newton's method for F = 0 in the wide part with coordinate i held fixed; false if none is
//   found.
template <class Box, size_t N>
class GraphArc {
public:
    using At = Place<N>;
    using End = GraphEnd<N>;
    using Sides = std::array<std::array<double, 2>, N>;

    // parts: the number of sections into which the zeros that are looked for divide the way between both
    // ends. little: arcs no longer than this, as a share of a piece, count as nothing, because the arcs of
    // the neighbours continue each other there. probes: the number of places at which a zero is looked for.
    GraphVerdict look(const Box &box, const Sides &sides, int parts, double little, int probes) {
        box_ = &box;
        sides_ = sides;
        has_ends_ = false;
        if (const std::optional<GraphVerdict> known = find_inside(little, probes)) {
            return *known;
        }
        const double forward = box.chart.direction();
        has_ends_ = find_end(-forward, ends_[0]) && find_end(forward, ends_[1]);
        return look_between_ends(parts);
    }
    // Repeats the last step of look(), where that left the box open, with another number of zeros.
    GraphVerdict look_between_ends(int parts) {
        if (!has_ends_) {
            return GraphVerdict::open;
        }
        set_zeros(parts);
        for (size_t i = 0; i < N; ++i) {
            const bool ends = ends_[0].coordinate == i || ends_[1].coordinate == i;
            if (changes(i) && !is_inside(i) && (ends || !stays(i))) {
                return GraphVerdict::open;
            }
        }
        return GraphVerdict::arc;
    }
    [[nodiscard]] const std::array<End, 2> &ends() const noexcept { return ends_; }
    // Zeros of the arc, by ascending coordinate k.
    [[nodiscard]] const std::vector<At> &zeros() const noexcept { return zeros_; }
    // The last zero found in or beside the box, if there is one.
    [[nodiscard]] const std::optional<At> &near() const noexcept { return near_; }
    void forget() noexcept { near_.reset(); }
    // Whether the whole arc lies beyond a value of a coordinate by more than rounding: above it for side 1,
    // below it for side 0.
    [[nodiscard]] bool lies_beyond(size_t coordinate, size_t side, double place) const {
        int zeros_left =
            128; // more than it takes to get from a side to the nearest zero distinguishable from it
        for (size_t i = 0; i + 1 < zeros_.size(); ++i) {
            if (!lies_beyond(coordinate, side, place, zeros_[i], zeros_[i + 1], zeros_left)) {
                return false;
            }
        }
        return zeros_.size() > 1;
    }
    // Whether a coordinate may both rise and fall along the graph.
    [[nodiscard]] static bool changes(const Box &box, size_t coordinate) noexcept {
        const Interval &rise = box.chart.rise(coordinate);
        return rise.lower <= 0 && rise.upper >= 0;
    }

private:
    static constexpr int most_sides = 6;
    static constexpr double most_place = 1 + widening;

    // Cuts the range to the x with a + b (x - x0) >= 0.
    static void keep_where_positive(double a, double b, double x0, Interval &range) noexcept {
        if (b == 0) {
            range = a >= 0 ? range : Interval{1, 0};
            return;
        }
        const double zero = x0 - a / b, room = 1e-14 * (1 + std::abs(zero));
        if (b > 0) {
            range.lower = std::max(range.lower, zero - room);
        } else {
            range.upper = std::min(range.upper, zero + room);
        }
    }
    static bool is_empty(const Interval &range) noexcept { return !(range.lower <= range.upper); }
    [[nodiscard]] bool changes(size_t coordinate) const noexcept { return changes(*box_, coordinate); }
    [[nodiscard]] bool is_between_sides(const At &z) const noexcept {
        for (size_t i = 0; i < N; ++i) {
            if (!(z[i] >= sides_[i][0] && z[i] <= sides_[i][1])) {
                return false;
            }
        }
        return true;
    }

    // What remains of a range of coordinate k, below and above z0, for zeros in the box. z0: any place; step:
    // M F there, with an error of up to `off` times its noise.
    std::array<Interval, 2> clipped(const At &z0, const At &step, double off, const Interval &range) const {
        const auto &chart = box_->chart;
        const size_t k = chart.axis();
        At farthest{};
        for (size_t i = 0; i < N; ++i) {
            farthest[i] = i == k ? 0 : std::max(sides_[i][1] - z0[i], z0[i] - sides_[i][0]);
        }
        const double far = std::max(std::abs(range.lower - z0[k]), std::abs(range.upper - z0[k]));
        const At drift = chart.drift(step, off, far, farthest);
        std::array<Interval, 2> halves{Interval{range.lower, std::min(range.upper, z0[k])},
                                       Interval{std::max(range.lower, z0[k]), range.upper}};
        for (size_t h = 0; h < 2; ++h) {
            for (size_t i = 0; i < N; ++i) {
                if (i == k) {
                    continue;
                }
                const double room = drift[i] + off * chart.noise(i) + 8 * eps;
                const double at = z0[i] - step[i];
                const double low = -chart.shift(i).upper, high = -chart.shift(i).lower;
                keep_where_positive(at + room - sides_[i][0], h == 1 ? high : low, z0[k], halves[h]);
                keep_where_positive(sides_[i][1] - at + room, h == 1 ? -low : -high, z0[k], halves[h]);
            }
        }
        return halves;
    }

    // Sets inside_ to a zero in the box, or returns what is known instead. What lies in a corner and is no
    // longer than the shift of the sides counts as nothing, because the arcs of the neighbours continue each
    // other there. The same holds if a zero is known beside the box and only rounding would allow its curve
    // to enter the box: bounds of rounding are far larger than its effect on places, and boxes near
    // tangential contacts have many sides within these bounds.
    std::optional<GraphVerdict> find_inside(double little, int probes) {
        const auto &chart = box_->chart;
        const size_t k = chart.axis();
        const double least = little / box_->length(k);
        At z = box_->start(), step = box_->step_at(z);
        ranges_.clear();
        add_ranges(clipped(z, step, 1, {sides_[k][0], sides_[k][1]}), true, 0);
        for (int probe = 0; probe < probes && !ranges_.empty(); ++probe) {
            const Interval range = ranges_.back();
            ranges_.pop_back();
            const double next = range.lower / 2 + range.upper / 2;
            for (size_t i = 0; i < N; ++i) {
                const double along = -(chart.shift(i).lower / 2 + chart.shift(i).upper / 2) * (next - z[k]);
                z[i] = i == k ? z[k] : std::clamp(z[i] - step[i] + along, -widening, most_place);
            }
            z[k] = next;
            const At guess = z;
            bool found = box_->solve(k, z);
            if (!chart.holds_at(z)) { // a zero outside of one of the parts, or no zero
                found = false;
                z = guess;
                if (!chart.holds_at(z)) {
                    return GraphVerdict::open;
                }
            }
            step = box_->step_at(z);
            if (found) {
                near_ = z;
            }
            if (found && is_between_sides(z)) {
                inside_ = z;
                return std::nullopt;
            }
            add_ranges(clipped(z, step, found ? 0 : 1, range), !found, least);
        }
        return ranges_.empty() ? GraphVerdict::nothing : GraphVerdict::open;
    }
    // joined: zeros between the two halves are not excluded. Ranges no longer than `least` are dropped.
    void add_ranges(const std::array<Interval, 2> &halves, bool joined, double least) {
        if (joined && !is_empty(halves[0]) && !is_empty(halves[1])) {
            ranges_.push_back({halves[0].lower, halves[1].upper});
            return;
        }
        for (const Interval &half : halves) {
            if (!is_empty(half) && half.upper - half.lower > least) {
                ranges_.push_back(half);
            }
        }
    }

    // Where the tangent at inside_ leaves the box; sets the coordinate and side of `end`. way: 1 or -1, in
    // coordinate k.
    At leave(double way, End &end) const {
        const At along = box_->tangent_at(inside_);
        const double unit = way / along[box_->chart.axis()];
        double first = infinity;
        for (size_t i = 0; i < N; ++i) {
            const double speed = unit * along[i];
            const size_t side = speed > 0 ? 1 : 0;
            const double time = (sides_[i][side] - inside_[i]) / speed;
            if (speed != 0 && time < first) {
                first = time;
                end.coordinate = i;
                end.side = side;
            }
        }
        At place{};
        for (size_t i = 0; i < N; ++i) {
            place[i] = std::clamp(inside_[i] + first * unit * along[i], -widening, most_place);
        }
        return place;
    }

    // Moves an end to the other side beyond which it lies farthest, if it lies beyond any by more than
    // rounding: sides meet in corners.
    bool is_beyond(End &end) const {
        double beyond = box_->chart.noise() + 8 * eps;
        const size_t own = end.coordinate;
        bool any = false;
        for (size_t i = 0; i < N; ++i) {
            for (size_t side = 0; side < 2; ++side) {
                const double by = (side == 1 ? 1 : -1) * (end.at[i] - sides_[i][side]);
                if (i != own && by > beyond) {
                    beyond = by;
                    end.coordinate = i;
                    end.side = side;
                    any = true;
                }
            }
        }
        return any;
    }

    // Follows the tangent to the first side it meets and solves for the curve on that side, then on any other
    // side beyond which the result lies.
    bool find_end(double way, End &end) const {
        const size_t k = box_->chart.axis();
        end = {};
        end.at = leave(way, end);
        for (int tries = 0; tries < most_sides; ++tries) {
            end.at[end.coordinate] = sides_[end.coordinate][end.side];
            if (!box_->solve(end.coordinate, end.at)) {
                return false;
            }
            if (!is_beyond(end)) {
                return way * (end.at[k] - inside_[k]) >= 0;
            }
        }
        return false;
    }

    // The range of a coordinate between two zeros, the first of which has the smaller k, by the slope bounds
    // D.
    [[nodiscard]] Interval between(const At &first, const At &last, size_t coordinate) const {
        const Interval &rise = box_->chart.rise(coordinate);
        const size_t k = box_->chart.axis();
        const double from = first[coordinate], to = last[coordinate], far = last[k] - first[k],
                     wide = rise.upper - rise.lower;
        const double up = std::max((to - from - rise.lower * far) / wide, 0.0),
                     down = std::max((rise.upper * far - (to - from)) / wide, 0.0);
        return {from + std::min(rise.lower, 0.0) * down, from + std::max(rise.upper, 0.0) * up};
    }
    [[nodiscard]] bool is_inside(size_t coordinate) const noexcept {
        const Interval range = box_->chart.range(coordinate);
        return range.lower > sides_[coordinate][0] && range.upper < sides_[coordinate][1];
    }
    [[nodiscard]] bool stays(size_t coordinate) const {
        for (size_t i = 0; i + 1 < zeros_.size(); ++i) {
            const Interval range = between(zeros_[i], zeros_[i + 1], coordinate);
            if (!(range.upper <= sides_[coordinate][1]) || !(range.lower >= sides_[coordinate][0])) {
                return false;
            }
        }
        return true;
    }
    // Adds zeros where the bounds between two of them are too wide.
    [[nodiscard]] bool lies_beyond(size_t coordinate, size_t side, double place, const At &first,
                                   const At &last, int &zeros_left) const {
        const double room = 2 * box_->chart.noise() + 16 * eps;
        const auto beyond = [&](double x) { return (side == 1 ? x - place : place - x) > room; };
        const Interval range = between(first, last, coordinate);
        if (beyond(side == 1 ? range.lower : range.upper)) {
            return true;
        }
        const bool goes_on = --zeros_left >= 0 && beyond(first[coordinate]) && beyond(last[coordinate]);
        const auto middle = goes_on ? zero_between<N>(*box_, first, last, 0.5) : std::nullopt;
        return middle && lies_beyond(coordinate, side, place, first, *middle, zeros_left) &&
               lies_beyond(coordinate, side, place, *middle, last, zeros_left);
    }

    // Sets zeros_ to both ends and, between them, inside_ or the zeros that divide the way.
    void set_zeros(int parts) {
        const size_t k = box_->chart.axis();
        zeros_ = {ends_[0].at, ends_[1].at};
        if (zeros_[0][k] > zeros_[1][k]) {
            std::swap(zeros_[0], zeros_[1]);
        }
        const At first = zeros_[0], last = zeros_[1];
        zeros_.pop_back();
        for (int i = 1; i < parts; ++i) {
            if (const auto z = zero_between<N>(*box_, first, last, static_cast<double>(i) / parts)) {
                zeros_.push_back(*z);
            }
        }
        if (parts <= 1) {
            zeros_.push_back(inside_);
        }
        zeros_.push_back(last);
    }

    const Box *box_ = nullptr;
    Sides sides_{}; // of the box, or wider for arcs along borders
    At inside_{};   // a zero in the box
    std::optional<At> near_;
    bool has_ends_ = false;
    std::array<End, 2> ends_{};
    std::vector<Interval> ranges_; // of coordinate k, in which there may be zeros
    std::vector<At> zeros_;
};

// How far the places of one end may differ if they are found in different boxes: by the actual effect of
// rounding, which is a small part of its bound. On a side of another coordinate, coordinate k is off by that
// effect over the slope.
template <size_t N, class Chart>
Place<N> noise_of_end(const Chart &chart, const GraphEnd<N> &end) noexcept {
    constexpr double part = 0.25, most_noise = 0x1p-8;
    const size_t k = chart.axis();
    Place<N> noise{};
    for (size_t i = 0; i < N; ++i) {
        noise[i] = i == k ? 0 : part * chart.noise(i);
    }
    if (end.coordinate != k) {
        const Interval &rise = chart.rise(end.coordinate);
        noise[k] = std::min(noise[end.coordinate] / std::abs(rise.lower / 2 + rise.upper / 2), most_noise);
        for (size_t i = 0; i < N; ++i) {
            noise[i] +=
                i == k ? 0
                       : std::max(std::abs(chart.rise(i).lower), std::abs(chart.rise(i).upper)) * noise[k];
        }
    }
    return noise;
}

// Newton's method for N - 1 equations with one coordinate held fixed. step_at(z, out): the step at z; false
// if there is none. noise: of steps. After a step the error is about its square, or what rounding leaves.
template <size_t N, class Step>
bool newton_on_side(size_t fixed, double noise, Place<N> &z, Step &&step_at) {
    constexpr int most_steps = 16;
    double last = infinity;
    int clamped = 0;
    for (int i = 0; i < most_steps; ++i) {
        Place<N> step{};
        if (!step_at(z, step)) {
            return false;
        }
        const double size = largest(step);
        bool is_clamped = false;
        for (size_t k = 0; k < N; ++k) {
            const double next = z[k] - step[k], inside = std::clamp(next, -widening, 1 + widening);
            is_clamped = is_clamped || inside != next;
            z[k] = k == fixed ? z[k] : inside;
        }
        if (!is_clamped && (size <= 0x1p-27 || (size >= last / 2 && size <= noise / 4))) {
            return true;
        }
        clamped += is_clamped ? 1 : 0;
        if (clamped == 3 || (size >= last && i > 1)) {
            return false;
        }
        last = size;
    }
    return false;
}

} // namespace nrb::intersect
