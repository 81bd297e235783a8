// SPDX-License-Identifier: MIT
// What control points contribute to a point of a spline.
#pragma once

#include "eval/parameters.h"

#include <span>
#include <vector>

namespace nrb::modify {

// A point S of a spline as a mean of what some chosen control points contribute to it and what the others do.
// With the homogeneous control points (w_j P_j, w_j), the weights divided by a power of two,
//
//     S = Q + offset / (weight + rest),   B = Q + offset / rest,
//     offset = sum over the others of N_j w_j (P_j - Q),
//
// where Q is the centre of the chosen control points, and B the point that the others make alone. The only
// differences computed are those of control points, so the offset is accurate to a few eps of the sum of the
// magnitudes of its terms.
struct Contribution {
    double function = 0;        // sum of N_i over the chosen control points
    double weight = 0;          // sum of N_i w_i over these
    double rest = 0;            // sum of N_j w_j over the others
    double unit = 1;            // a weight of 1, divided by that power
    std::vector<double> centre; // Q
    std::vector<double> offset;

    // R, the sum of the rational basis functions of the chosen; not 0 if these act.
    [[nodiscard]] double influence() const noexcept { return weight / (weight + rest); }
    // |Q S|.
    [[nodiscard]] double reach() const noexcept;
};

// The contribution of control points and of their copies on periodic axes; `originals` are the first of the
// copies. The centre is their mean sum N_i w_i P_i / sum N_i w_i. Throws Status::influence, naming the
// control points that act, if that sum of weights is 0.
Contribution contribution_of(const Spline &spline, std::span<const int64_t> originals, const double *param);

// The contribution of one control point, which is the centre whether it acts or not. Throws
// Status::point_not_finite if it is at infinity.
Contribution contribution_about(const Spline &spline, int64_t original, const double *param);

// Throws Status::influence for a control point (-1: for the given ones) that does not act at a parameter,
// naming those that do.
[[noreturn]] void fail_influence(const Spline &spline, int64_t point, const double *param);

// The control point with the largest |R_i| at each parameter, the first one if there are several; copies are
// added to their originals. Both outputs are [params.count] or null. May throw only std::bad_alloc, before
// anything is written. Precondition: the parameters have been checked.
void most_influential(const Spline &spline, ConstRecords params, int64_t *indices, double *influences);

} // namespace nrb::modify
