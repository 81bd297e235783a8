// SPDX-License-Identifier: MIT
// Functions of one parameter over common knots and one denominator: the components of a blended spline along
// each of its axes.
//
// A blended spline is a sum of products f(u) g(v) of blending functions and of boundaries. With the factors
// along an axis over one denominator D, of one degree and over one knot vector, its control net is the same
// sum of products of their control points; the net of the denominators is the product of their weights.
#pragma once

#include "spline/spline.h"

#include <span>
#include <vector>

namespace nrb::build {

// Whether two polynomial splines have the same control points over common knots, bit for bit. Precondition:
// neither is null.
bool same_function(const SplinePtr &a, const SplinePtr &b);

// A function of one parameter, numerators / denominator, both polynomial splines with clamped ends.
struct Quotient {
    SplinePtr numerators;  // of any dimension
    SplinePtr denominator; // of dimension 1, its first control point is 1; null: the function is polynomial
};

// A curve, its weights divided by the first one; equal weights are no denominator. Preconditions: clamped,
// the weights at its ends are not 0.
Quotient as_quotient(const SplinePtr &curve);

// The ends of a function f over [a, b] to which blending functions belong, in this order: f(a), f(b), f'(a),
// f'(b).
inline constexpr size_t max_blends = 4;

struct BlendAxis {
    KnotVectorPtr axis;
    // Control points of the common denominator; empty if it is 1.
    std::vector<double> weights;
    // Control points of the functions, n records each, and of the blending functions. They are Cartesian:
    // numerators over D, divided by the weight of D at their place, if that is not 0.
    std::vector<std::vector<double>> functions;
    std::vector<std::vector<double>> blends;

    [[nodiscard]] int64_t count() const noexcept { return axis->count(); }
    [[nodiscard]] double weight(size_t i) const noexcept { return weights.empty() ? 1 : weights[i]; }
    // The divisor of control points of numerators.
    [[nodiscard]] double divisor(size_t i) const noexcept { return weight(i) == 0 ? 1 : weight(i); }
    // How many layers at an end belong to the values and derivatives that are blended there.
    [[nodiscard]] size_t margin() const noexcept { return blends.size() / 2; }
    [[nodiscard]] bool in_margin(size_t i) const noexcept {
        return i < margin() || i + margin() >= static_cast<size_t>(count());
    }
};

// The functions, and the blending functions of degree 1 (1 - t, t) or 3 (Hermite's F0, F1, G0, G1, the last
// two times the length of the domain), t being the parameter mapped to [0, 1]. D is the product of the
// denominators that differ; they are compared bit for bit over common knots. The control points of the
// blending functions at the ends, on which the values and derivatives there depend, are set to exactly these,
// without the rounding of products. Every control point of a function is within 2 eps of its hull, barring
// products with other denominators. Throws Status::degree and what product() throws. Precondition: all have
// the same domain.
BlendAxis make_blend_axis(std::span<const Quotient> functions, int degree);

} // namespace nrb::build
