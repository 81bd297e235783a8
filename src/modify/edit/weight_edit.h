// SPDX-License-Identifier: MIT
// Weights changed so that a point of the shape moves to a wanted place (Piegl & Tiller 11.3).
#pragma once

#include "spline/spline.h"

#include <span>

namespace nrb::modify {

// Preconditions of all functions: parameters have been checked, and control points are originals
// (net_editor.h).

struct WeightEdit {
    double value; // the new weight, or the factor of all weights
    SplinePtr spline;
};

// Multiplies the weights of all given control points by one factor f. In the terms of influence.h, with W for
// `weight`, the point becomes Q + offset / (f W + rest). It moves by d towards Q for
//     f = (|Q S| + (rest / W) d) / (|Q S| - d) = 1 + d / (R (|Q S| - d)).
// Throws Status::influence, length, weight_sign, not_representable. The value is the factor.
WeightEdit pull_weights(const Spline &spline, std::span<const int64_t> originals, const double *param,
                        double distance);
// The same for one control point; the value is its weight.
WeightEdit pull_weight(const Spline &spline, int64_t original, const double *param, double distance);

// Throws Status::point_not_finite if the spline has a control point at infinity or one of the originals has
// no place (NetEditor::set_weight()), and what make_result() throws. Precondition: the weights are finite and
// >= 0.
SplinePtr set_weights(const Spline &spline, std::span<const int64_t> originals, const double *weights);

// The points at the parameter for the weights 0, 1 and the present one of a control point; each output is
// null or of the dimension of the spline. Throws Status::point_not_finite, not_representable, before anything
// is written.
void weight_points(const Spline &spline, int64_t original, const double *param, double *at_zero,
                   double *at_one, double *at_weight);

// See nurbs_weight_cross_ratio(). Throws Status::collinear. Precondition: all coordinates are finite.
double weight_cross_ratio(int dim, const double *control_point, const double *at_zero, const double *at_one,
                          const double *at_weight);

// Sets the weight with which the point at the parameter becomes the target: for the target P + alpha offset,
// the weight is (1 / alpha - rest) / N, N being the sum of the basis functions of the copies. Throws
// Status::influence, gap, weight_sign, not_representable, point_not_finite.
WeightEdit weight_through(const Spline &spline, int64_t original, const double *param, const double *target,
                          double tolerance);

} // namespace nrb::modify
