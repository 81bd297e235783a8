// SPDX-License-Identifier: MIT
// The factors along one axis of a blended (Coons) spline: functions of one parameter over common knots and
// one denominator.
//
// A blended spline is a sum of products f(u) g(v) of blending functions and boundaries. Once the factors
// along each axis have a common denominator D, one degree and one knot vector, the control net of the spline
// is the same sum of products of their control points, and its weights are the products of the weights of the
// Ds.
#pragma once

#include "spline/spline.h"

#include <span>
#include <vector>

namespace nrb::build {

// Whether two polynomial splines have the same control points, bit for bit, once they are brought to common
// knots. Precondition: neither is null.
bool same_function(const SplinePtr &a, const SplinePtr &b);

// A function of one parameter: numerators / denominator, both polynomial splines with clamped ends.
struct Quotient {
    SplinePtr numerators;  // of any dimension
    SplinePtr denominator; // of dimension 1, its first control point is 1; null: the function is polynomial
};

// A curve as a quotient, its weights divided by the first one; equal weights give no denominator.
// Preconditions: the curve is clamped, the weights at its ends are not 0.
Quotient as_quotient(const SplinePtr &curve);

// The data of a function f over [a, b] that blending functions belong to, in this order: f(a), f(b), f'(a),
// f'(b).
inline constexpr size_t max_blends = 4;

struct BlendAxis {
    KnotVectorPtr axis;
    // Control points of the common denominator; empty if it is 1.
    std::vector<double> weights;
    // Control points of the functions, n records each, and of the blending functions, where n is count().
    // They are Cartesian: the numerators over D, divided by the weight of D with the same index if that is
    // not 0.
    std::vector<std::vector<double>> functions;
    std::vector<std::vector<double>> blends;

    [[nodiscard]] int64_t count() const noexcept { return axis->count(); }
    [[nodiscard]] double weight(size_t i) const noexcept { return weights.empty() ? 1 : weights[i]; }
    // What the numerators with an index are divided by.
    [[nodiscard]] double divisor(size_t i) const noexcept { return weight(i) == 0 ? 1 : weight(i); }
    // The number of layers at an end that determine the values and derivatives blended there.
    [[nodiscard]] size_t margin() const noexcept { return blends.size() / 2; }
    [[nodiscard]] bool in_margin(size_t i) const noexcept {
        return i < margin() || i + margin() >= static_cast<size_t>(count());
    }
};

// The functions, and the blending functions of degree 1 (1 - t, t) or 3 (the Hermite functions F0, F1, G0,
// G1, the last two times the length of the domain), where t is the parameter mapped to [0, 1]. D is the
// product of the distinct denominators, which are compared bit for bit over common knots. The control points
// of the blending functions in the margins are set to exactly the values that the ends require, without the
// rounding of products. Every control point of a function is accurate to 2 eps times the hull of the
// function, its largest coordinate, apart from the products with other denominators. Throws Status::degree
// and what product() throws. Precondition: all functions have the same domain.
BlendAxis make_blend_axis(std::span<const Quotient> functions, int degree);

} // namespace nrb::build
