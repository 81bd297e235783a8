// SPDX-License-Identifier: MIT
// Where the parameters (t, u, v) of a curve and a surface continue, jump or end.
#pragma once

#include "intersect/curve_surface/meet_cell.h"
#include "intersect/pairs/strands.h"
#include "spline/spline.h"

#include <optional>

namespace nrb::intersect {

// A surface continues across a border of its domain that coincides with the opposite one, and at a pole,
// which is a border that is one point and around which the surface closes. A curve continues where it is
// periodic. Kept while the answer for one call is made.
class Seams {
public:
    Seams(const Spline &curve, const Spline &surface);

    [[nodiscard]] Interval domain(size_t k) const noexcept { return axis(k).domain(); }
    // The period by which parameters continue across a seam, for a surface also on an axis that only closes;
    // 0: there is none.
    [[nodiscard]] double period(size_t k) const;
    [[nodiscard]] bool periodic(size_t k) const noexcept { return axis(k).periodic(); }
    // The segments between jumps in which a place lies, by index.
    [[nodiscard]] std::array<int64_t, 3> segments(const MeetPlace &at) const;
    // Whether a box reaches an end of the curve, or a border of the surface at which it does not continue.
    [[nodiscard]] bool reach_end(const MeetBox &box) const;
    // Whether the border of the surface at an end of axis k > 0 is a pole.
    [[nodiscard]] bool is_pole(size_t k, bool upper) const;
    // The knots in the domain, and for a periodic axis those of the next period.
    [[nodiscard]] const Breaks &breaks(size_t k) const noexcept { return breaks_[k]; }

    // Moved by periods into the domain, or clamped.
    [[nodiscard]] double in_domain(size_t k, double t) const;
    // Moved to begin in the domain, and no longer than a period.
    [[nodiscard]] Interval range(size_t k, Interval part) const;

private:
    [[nodiscard]] const KnotVector &axis(size_t k) const noexcept {
        return k == 0 ? curve_.axis(0) : surface_.axis(static_cast<int>(k) - 1);
    }
    using Rows = std::vector<std::array<double, 3>>;
    // Points of the surface along an isoparametric line, as many as determine it.
    [[nodiscard]] Rows line(int axis, double t, bool left) const;
    [[nodiscard]] bool are_one_line(const Rows &x, const Rows &y) const;
    [[nodiscard]] bool ends_at(size_t k, bool upper) const;
    void set_jumps(int axis);

    const Spline &curve_, &surface_;
    std::array<Breaks, 3> breaks_;
    std::array<std::vector<double>, 3> jumps_;
    mutable std::array<std::optional<bool>, 3> closes_;
    mutable std::array<std::optional<bool>, 6> poles_;
};

} // namespace nrb::intersect
