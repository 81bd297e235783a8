// SPDX-License-Identifier: MIT
// Axis-wise linear maps between the parameters of two splines that may trace the same points.
#pragma once

#include "pieces/bezier_piece.h"

namespace nrb::closest {

// A map from the parameters of one spline, the origin, to those of another one, the image. Each axis of the
// image is a linear function of one axis of the origin, increasing or decreasing, or it is constant.
class ParameterMap {
public:
    // How an axis of the image depends on the origin.
    struct Follower {
        int axis = -1;        // of the origin; -1: constant
        Interval image{0, 0}; // of that axis; reversed if lower > upper
    };
    ParameterMap(const Spline &from, const Spline &to, const std::array<Follower, max_axes> &followers)
        : from_(from), to_(to), followers_(followers) {}

    [[nodiscard]] pieces::LocalParam operator()(const pieces::LocalParam &params) const noexcept;
    // The breaks of the image that fall into the interior of the domain of axis k of the origin, mapped back
    // there.
    [[nodiscard]] std::vector<double> breaks(int k) const;

private:
    const Spline &from_, &to_;
    std::array<Follower, max_axes> followers_;
};

// The map that takes each axis of the domain to the axis of the same number. Precondition: both splines have
// the same number of axes.
ParameterMap straight_map(const Spline &from, const Spline &to);

// The best of a few candidate maps: the one that takes a small sample of points nearest to their images,
// provided that these distances are at most `rounding` + `tolerance`, where `rounding` is the largest
// distance between coincident points. The candidates are the identity of parameters; all maps from domain to
// domain, with the axes in any order and direction; and a map onto the part of `to` that the nearest points
// of a few points of `from` span. `budget`: most pieces examined for such a nearest point. Cost: some
// evaluations and, unless the samples coincide, one nearest point, and as many more as `from` has axes if the
// first one is near.
std::optional<ParameterMap> matching_map(const Spline &from, const Spline &to, double rounding,
                                         double tolerance, int64_t budget);

} // namespace nrb::closest
