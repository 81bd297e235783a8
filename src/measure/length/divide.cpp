// SPDX-License-Identifier: MIT
#include "measure/length/divide.h"

#include "base/error.h"
#include "base/numbers.h"
#include "base/watch.h"
#include "eval/evaluate.h"
#include "measure/length/chord_path.h"
#include "measure/length/length_table.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>

namespace nrb::measure {

namespace {

constexpr int most_bisections = 200, most_walks = 100000;
constexpr double parts_of_chord = 1024; // steps are at least 1 / parts_of_chord of a chord

// A range of a curve, parametrized by arc length in units of the length table.
class Arc {
public:
    Arc(const Spline &curve, Interval range, int64_t parts, double relative_tolerance)
        : curve_(curve), table_(LengthTable::of(curve)), range_(range), work_(table_.work_size()),
          point_(static_cast<size_t>(curve.dim())) {
        const Interval domain = curve.axis(0).domain();
        start_ = range.lower == domain.lower ? 0 : table_.length_at(range.lower, work_.data());
        end_ = range.upper == domain.upper ? table_.total() : table_.length_at(range.upper, work_.data());
        table_.check(relative_tolerance, (end_ - start_) / static_cast<double>(parts));
        if (!(end_ > start_)) {
            fail(Status::length, "the curve has no length between %s and %s", Number(range.lower).text,
                 Number(range.upper).text);
        }
    }

    [[nodiscard]] double length() const noexcept { return end_ - start_; }
    [[nodiscard]] double to_model(double length) const noexcept {
        return std::ldexp(length, table_.exponent());
    }
    [[nodiscard]] double from_model(double length) const noexcept {
        return std::ldexp(length, -table_.exponent());
    }
    [[nodiscard]] double param(double s) {
        count_work(4 * table_.work_of_a_place());
        const double t = table_.param_at(std::clamp(start_ + s, start_, end_), work_.data());
        return std::clamp(t, range_.lower, range_.upper);
    }
    // The distance between two points in units of the table.
    [[nodiscard]] double distance_from(const std::vector<double> &from, double t, bool left) {
        place(t, left, point_);
        return std::ldexp(distance(from.data(), point_.data(), curve_.dim()), -table_.exponent());
    }
    void place(double t, bool left, std::vector<double> &point) const {
        eval::AxisRules rules{};
        rules[0].left = left;
        eval::evaluate_points(curve_, rules, 0, {&t, 1}, {point.data(), 1, curve_.dim(), curve_.dim()});
    }

private:
    const Spline &curve_;
    const LengthTable &table_;
    Interval range_;
    std::vector<double> work_;
    std::vector<double> point_;
    double start_ = 0, end_ = 0;
};

// Walks along an arc in steps of equal chords.
class ChordWalk {
public:
    ChordWalk(const Spline &curve, Arc &arc, Interval range, int64_t parts, std::vector<double> &params)
        : arc_(arc), range_(range), parts_(parts), params_(params), from_(static_cast<size_t>(curve.dim())) {}

    // The amount by which the last chord is longer than the others; negative if the walk reaches the end too
    // early, or the limit of work.
    double excess(double chord) {
        params_.assign(1, range_.lower);
        arc_.place(range_.lower, false, from_);
        double s = 0;
        for (int64_t i = 1; i < parts_; ++i) {
            s = next(s, chord);
            if (!(s < arc_.length()) || work_ended()) {
                return -chord;
            }
            params_.push_back(std::max(params_.back(), arc_.param(s)));
            arc_.place(params_.back(), false, from_);
        }
        params_.push_back(range_.upper);
        return arc_.distance_from(from_, range_.upper, true) - chord;
    }

private:
    double beyond(double s, double chord) { return arc_.distance_from(from_, arc_.param(s), false) - chord; }

    // The first place found at distance `chord` from the current point. The distance grows no faster than the
    // arc length, so that a step of the missing distance is always safe (as in sphere tracing); a step may be
    // up to eight times that if the slope of the last one suggests it.
    double next(double start, double chord) {
        double s = start, rest = -chord;
        for (int step = 0; step < most_walks && s < arc_.length() && !work_ended(); ++step) {
            const double before = s, missing = rest;
            s += std::max(std::clamp(step_, -rest, -8 * rest), chord / parts_of_chord);
            rest = beyond(std::min(s, arc_.length()), chord);
            if (rest >= 0) {
                return between(before, missing, s, rest, chord);
            }
            if (rest >= -4 * eps * chord) {
                return s;
            }
            const double slope = (rest - missing) / (s - before);
            step_ = slope > 0 ? -rest / slope : 0;
        }
        return arc_.length();
    }

    // Regula falsi with the Illinois modification (M. Dowell, P. Jarratt, BIT 11 (1971)).
    double between(double lower, double below, double upper, double above, double chord) {
        for (int step = 0; step < most_bisections && above > 4 * eps * chord; ++step) {
            const double falsi = (lower * above - upper * below) / (above - below);
            const double middle = falsi > lower && falsi < upper ? falsi : lower / 2 + upper / 2;
            if (!(middle > lower && middle < upper)) {
                break;
            }
            const double rest = beyond(middle, chord);
            if (rest < 0) {
                lower = middle;
                below = rest;
                above /= 2;
                if (rest >= -4 * eps * chord) {
                    return middle;
                }
            } else {
                upper = middle;
                above = rest;
                below /= 2;
            }
        }
        return upper;
    }

    double step_ = 0;
    Arc &arc_;
    Interval range_;
    int64_t parts_;
    std::vector<double> &params_;
    std::vector<double> from_;
};

} // namespace

double divide_by_length(const Spline &curve, Interval range, int64_t parts, double relative_tolerance,
                        std::vector<double> &params) {
    Arc arc(curve, range, parts, relative_tolerance);
    const double part = arc.length() / static_cast<double>(parts);
    params.assign(1, range.lower);
    for (int64_t i = 1; i < parts; ++i) {
        params.push_back(std::max(params.back(), arc.param(static_cast<double>(i) * part)));
    }
    params.push_back(range.upper);
    return arc.to_model(part);
}

namespace {

// Finds the chord at which the excess is 0.
class ChordSearch {
public:
    ChordSearch(ChordWalk &walk, double allowed) : walk_(walk), allowed_(allowed) {}

    // Searches between a chord with a positive excess and a longer one with a negative excess: regula falsi
    // with the Illinois modification and, since the excess may jump, a bisection at every third step. False
    // if it only jumps, or at the limit of work.
    bool between(double lower, double below, double upper, double above) {
        for (int step = 0; step < most_bisections && !work_ended(); ++step) {
            const double falsi = (lower * above - upper * below) / (above - below);
            chord_ = step % 3 < 2 && falsi > lower && falsi < upper ? falsi : lower / 2 + upper / 2;
            if (!(chord_ > lower && chord_ < upper)) {
                break;
            }
            rest_ = walk_.excess(chord_);
            if (std::abs(rest_) <= allowed_ / 8 * chord_) {
                return true;
            }
            if (rest_ > 0) {
                lower = chord_;
                below = rest_;
                above /= 2;
            } else {
                upper = chord_;
                above = rest_;
                below /= 2;
            }
        }
        return !work_ended() && std::abs(rest_) <= allowed_ * chord_;
    }

    // The chord is at most `longest`, the length of a part, as chords are no longer than their arcs.
    // `length`: the excess of a chord of length 0.
    bool run(double longest, double length) {
        const double above = walk_.excess(longest);
        if (std::abs(above) <= allowed_ / 8 * longest) {
            chord_ = longest;
            return true;
        }
        return between(0, length, longest, above);
    }

    [[nodiscard]] double chord() const noexcept { return chord_; }
    [[nodiscard]] double rest() const noexcept { return rest_; }

private:
    ChordWalk &walk_;
    double allowed_;
    double chord_ = 0, rest_ = 0;
};

// The largest difference between a distance of neighbours and the chord, in units of the table.
double largest_miss(const Spline &curve, Arc &arc, const std::vector<double> &params, double chord) {
    std::vector<double> from(static_cast<size_t>(curve.dim()));
    double most = 0;
    for (size_t i = 1; i < params.size(); ++i) {
        arc.place(params[i - 1], false, from);
        most = std::max(most, std::abs(arc.distance_from(from, params[i], i + 1 == params.size()) - chord));
    }
    return most;
}

// For curves on which walks do not succeed: follows the path of all chains, starting from a short one.
// Returns the chord in units of the table, or 0.
double follow_chains(const Spline &curve, Arc &arc, Interval range, int64_t parts, double allowed,
                     std::vector<double> &params) {
    constexpr double first = 0x1p-12; // relative to the mean part: the curve is nearly straight there
    const double start = first * arc.length() / static_cast<double>(parts);
    std::vector<double> chain;
    ChordWalk(curve, arc, range, parts + 1, chain).excess(start);
    chain.resize(static_cast<size_t>(parts) + 1);
    for (const double step :
         {0x1p-3, 0x1p-6}) { // a step onto another branch leads back to the start: then shorter steps
        ChordPath path(curve, range, chain, arc.to_model(start), step);
        if (path.run(allowed)) {
            const double chord = arc.from_model(path.chord());
            params = path.params();
            return largest_miss(curve, arc, params, chord) <= allowed * chord ? chord : 0;
        }
    }
    return 0;
}

// Walks that take long usually do not succeed at all: the search runs within a part of the usual limit of
// work, so that the path can be followed instead.
template <class Search>
bool ends_in_time(const Spline &curve, int64_t parts, Search &&run) {
    const UsualLimit usual(usual_work(curve.point_count() + parts, 100000) / 2);
    const LimitedSearch search;
    return run();
}

} // namespace

double divide_by_chord(const Spline &curve, Interval range, int64_t parts, double relative_tolerance,
                       std::vector<double> &params) {
    Arc arc(curve, range, parts, relative_tolerance);
    ChordWalk walk(curve, arc, range, parts, params);
    if (parts == 1) {
        return arc.to_model(walk.excess(0));
    }
    // Below 1, so that a walk that ends too early, whose excess is -chord, is never accepted.
    const double allowed = std::min(std::max(relative_tolerance, 64 * eps * static_cast<double>(parts)), 0.5);
    ChordSearch search(walk, allowed);
    if (ends_in_time(curve, parts,
                     [&] { return search.run(arc.length() / static_cast<double>(parts), arc.length()); })) {
        return arc.to_model(search.chord());
    }
    const double chord = follow_chains(curve, arc, range, parts, allowed, params);
    if (!(chord > 0)) {
        fail(Status::not_converged,
             "no division into %lld equal chords was found: the last one differs by %s",
             static_cast<long long>(parts), Number(arc.to_model(search.rest())).text);
    }
    return arc.to_model(chord);
}

} // namespace nrb::measure
