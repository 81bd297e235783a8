// SPDX-License-Identifier: MIT
// Maps between the parameters of two splines under which their points may be the same.
#pragma once

#include "pieces/bezier_piece.h"

namespace nrb::closest {

// From the parameters of one spline to those of another, linear along each axis: an axis of the image follows
// one axis of the origin, in either direction, or stands still.
class ParameterMap {
public:
    // An axis of the image.
    struct Follower {
        int axis = -1;        // of the origin; -1: none
        Interval image{0, 0}; // of its domain, turned round if the lower end is above the upper one
    };
    ParameterMap(const Spline &from, const Spline &to, const std::array<Follower, max_axes> &followers)
        : from_(from), to_(to), followers_(followers) {}

    [[nodiscard]] pieces::LocalParam operator()(const pieces::LocalParam &params) const noexcept;
    // The breaks of the image that are inside the domain of axis k of the origin, moved there.
    [[nodiscard]] std::vector<double> breaks(int k) const;

private:
    const Spline &from_, &to_;
    std::array<Follower, max_axes> followers_;
};

// Domain to domain, axis to axis. Precondition: the numbers of axes agree.
ParameterMap straight_map(const Spline &from, const Spline &to);

// The map under which the points of a small sample are nearest to each other, if it brings them to within
// `tolerance` and `rounding`, which is what distances of coincident points may amount to: the parameters
// themselves, from domain to domain with the axes in any order and direction, or onto the part of `to` that
// the nearest points of a few points of `from` span. `budget`: most pieces looked at for such a point. Cost:
// some evaluations; unless the samples coincide, one nearest point, and as many more as `from` has axes if it
// is near.
std::optional<ParameterMap> matching_map(const Spline &from, const Spline &to, double rounding,
                                         double tolerance, int64_t budget);

} // namespace nrb::closest
