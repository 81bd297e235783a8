// SPDX-License-Identifier: MIT
// What control points contribute to a point of a spline.
#pragma once

#include "eval/parameters.h"

#include <span>
#include <vector>

namespace nrb::modify {

// A point S of a spline as a mean of what some control points contribute to it and what the others do. With
// the homogeneous control points (w_j P_j, w_j), the weights divided by a power of two,
//
//     S = Q + offset / (weight + rest),   B = Q + offset / rest,
//     offset = sum over the others of N_j w_j (P_j - Q),
//
// where B is the point that the others make alone. Nothing is subtracted that is not a difference of control
// points, so that the offset is accurate to a few eps of the sum of the magnitudes of its terms.
struct Contribution {
    double function = 0;        // sum of N_i over those chosen
    double weight = 0;          // sum of N_i w_i over them
    double rest = 0;            // over the others
    double unit = 1;            // what a weight of 1 is
    std::vector<double> centre; // Q
    std::vector<double> offset;

    // R, which is not 0 if they act.
    [[nodiscard]] double influence() const noexcept { return weight / (weight + rest); }
    // |Q S|.
    [[nodiscard]] double reach() const noexcept;
};

// For control points whose copies on periodic axes count with them; `originals` are the first of these. The
// centre is their mean sum N_i w_i P_i / sum N_i w_i; throws Status::influence, naming the points that act,
// if there is none.
Contribution contribution_of(const Spline &spline, std::span<const int64_t> originals, const double *param);

// For one control point, which is the centre whether it acts or not. Throws Status::point_not_finite if it is
// at infinity.
Contribution contribution_about(const Spline &spline, int64_t original, const double *param);

// Throws Status::influence for a control point (-1: the given ones) that does not act at a parameter.
[[noreturn]] void fail_influence(const Spline &spline, int64_t point, const double *param);

// The control point with the largest |R_i| at each parameter, all copies taken together, the first one if
// there are several; both outputs [params.count] or null. May throw only std::bad_alloc, before anything is
// written. Precondition: the parameters have been checked.
void most_influential(const Spline &spline, ConstRecords params, int64_t *indices, double *influences);

} // namespace nrb::modify
