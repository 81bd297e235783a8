// SPDX-License-Identifier: MIT
// Whether the loops of a face cross themselves or each other.
#pragma once

#include "base/status.h"
#include "face/checks/loop_hits.h"
#include "face/trims/trim_map.h"

#include <span>
#include <vector>

namespace nrb::face {

// Loops have the inside to their left and the outside to their right; if none cross, all places have the
// value 1 or 0 (TrimMap). Around a crossing there are three consecutive values. Hence loops cross if and only
// if there are places with another value. Along a curve the values at its sides do not change from one hit to
// the next. So between hits the values beside the curve are checked, at distances above the tolerance: what
// is thinner than twice the tolerance is not a crossing.
class Crossings {
public:
    // Throws Status::crossing for curves that run along each other, except for those of a loop that goes
    // there and back, and those of two loops that run around a closed axis in opposite directions.
    Crossings(const Spline &surface, const Covering &covering, std::span<const ClosedLoop> loops,
              double tolerance);

    // Throws Status::crossing for curves that cross, orientation for loops that contain each other as those
    // of no face do, not_converged where it is undecided whether curves cross.
    void check(const TrimMap &trims) const;

    // For loops for which there is no TrimMap: throws Status::crossing if curves cross between their ends.
    void check_hits() const;

private:
    void check_doubled() const;
    [[nodiscard]] bool goes_through(const LoopHit &hit) const;
    [[nodiscard]] double foot(const LoopHit &hit, double t) const;
    [[nodiscard]] Point2 place_beside(const LoopHit &hit, double t) const;
    [[nodiscard]] bool runs_along(const LoopHit &hit) const;
    [[nodiscard]] bool runs_against(const LoopHit &hit) const;
    [[nodiscard]] bool is_allowed(const LoopHit &hit) const;
    [[nodiscard]] bool is_inner_crossing(const LoopHit &hit) const;
    [[nodiscard]] bool is_succession(const LoopHit &hit) const;
    [[nodiscard]] bool is_end(size_t curve, double at, bool upper) const;
    [[nodiscard]] double gap(size_t a, double at_a, size_t b, double at_b) const;
    [[nodiscard]] double extent(size_t curve, Interval range) const;
    [[nodiscard]] bool runs_beside(const LoopHit &hit) const;
    [[nodiscard]] const LoopHit *nearest(int loop, const Point2 &x) const;
    [[noreturn]] void fail_at(const LoopHit &hit, Status status, const char *verb, bool range = false) const;

    const Spline &surface_;
    const Covering &covering_;
    double near_; // a distance in space, with rounding added
    LoopHits hits_;
    std::vector<bool> doubled_; // for each curve: whether it runs along another one, as is allowed
};

} // namespace nrb::face
