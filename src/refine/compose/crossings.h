// SPDX-License-Identifier: MIT
// Where a coordinate of a curve takes given values, and whether it increases or decreases, from the signs of
// Bernstein coefficients.
#pragma once

#include "basis/bspline.h"
#include "bernstein/sign_profile.h"
#include "refine/algebra/common_knots.h"
#include "spline/spline.h"

#include <array>
#include <span>
#include <vector>

namespace nrb::refine {

using Coefficients = std::array<double, max_basis>;

// A curve over one of its non-empty spans, with each coordinate in Bernstein form. Weights are positive. They
// are scaled by one power of two, which keeps their products in range. A polynomial curve has weights of 1.
class CurvePiece {
public:
    // The curve must outlive this. Throws Status::not_representable if an uncertainty overflows.
    CurvePiece(const Spline &curve, int64_t span);

    [[nodiscard]] int64_t span() const noexcept { return span_; }
    [[nodiscard]] double lower() const noexcept { return curve_->axis(0)[span_]; }
    [[nodiscard]] double upper() const noexcept { return curve_->axis(0)[span_ + 1]; }
    [[nodiscard]] int degree() const noexcept { return curve_->axis(0).degree(); }
    [[nodiscard]] std::span<const double> coefficients(int k) const noexcept {
        const auto size = static_cast<size_t>(degree()) + 1;
        return std::span(coefficients_).subspan(static_cast<size_t>(k) * size, size);
    }
    // The weights of the coefficients; empty for a polynomial curve.
    [[nodiscard]] std::span<const double> weights() const noexcept { return weights_; }
    // The Bernstein coefficients over another interval. Only the first degree + 1 elements are used.
    [[nodiscard]] Coefficients coefficients_between(int k, double from, double to) const noexcept;
    [[nodiscard]] Coefficients weights_between(double from, double to) const noexcept;
    // rounding(k) bounds the error of a Bernstein coefficient of coordinate k: with F_i the active control
    // points, 4 (q + 1) eps max |F_i| for a polar form, or 8 (q + 2) eps max |F_i| for a quotient of two
    // polar forms with positive weights, each of which is that accurate relative to its own terms.
    // uncertainty(k) bounds the error of a value. It adds the change caused by a rounding of the parameter,
    // eps max |t| max |F'|.
    [[nodiscard]] double rounding(int k) const noexcept { return known_[static_cast<size_t>(k)].rounding; }
    [[nodiscard]] double uncertainty(int k) const noexcept {
        return known_[static_cast<size_t>(k)].uncertainty;
    }
    // The error bound of the value at t. At an end of the piece, where the value may be a control point, it
    // is the smaller one.
    [[nodiscard]] double uncertainty_at(int k, double t) const noexcept;
    // The weight, and coordinate k, of the polar form at `degree` arguments; the coordinate is divided by the
    // weight. value() is the polar value whose arguments are all t.
    [[nodiscard]] double polar_weight(std::span<const double> arguments) const noexcept;
    [[nodiscard]] double polar_value(int k, std::span<const double> arguments) const noexcept;
    [[nodiscard]] double value(int k, double t) const noexcept;

private:
    struct Known {
        double rounding;
        double uncertainty;
    };
    [[nodiscard]] Known known_of(int k) const;
    [[nodiscard]] Interval eps_times_range(int k) const noexcept;
    [[nodiscard]] double eps_times_slope(int k, double even) const noexcept;
    [[nodiscard]] double weight(int64_t i) const noexcept;
    // Coordinate k, or the weight, of the linear combination of control points given by a row. With weights,
    // the coordinate is divided by the weight.
    [[nodiscard]] double value_of(const BlossomRow &row, int k) const noexcept;
    [[nodiscard]] double weight_of(const BlossomRow &row) const noexcept;
    [[nodiscard]] double quotient(const BlossomRow &row, int k) const noexcept;

    const Spline *curve_;
    int64_t span_;
    std::vector<double> weights_;      // [degree + 1]; empty for a polynomial curve
    std::vector<double> coefficients_; // [coordinate][degree + 1]
    std::vector<Known> known_;
};

// What can be said about the sign of a coordinate minus c inside a piece. Subdivides until the coefficients
// of each part change their sign at most once (Lane & Riesenfeld, "Bounds on a polynomial", BIT 21 (1981)),
// then finds each crossing to neighbouring doubles by the secant method. Where the coordinate touches c
// without crossing it, only the side is reported. Cost: q^2 for each subdivision, of which there are at most
// some 50 q, and some 10 evaluations for each crossing.
SignProfile sign_profile(const CurvePiece &piece, int k, double c);

// Whether the coordinate is above c on a part of the piece that contains no crossing. If its value in the
// middle differs from c by no more than the uncertainty, the coefficients over the part decide: those beyond
// the uncertainty, or else those beyond rounding. If there are none, the coordinate coincides with c, which
// counts as above.
bool lies_above(const CurvePiece &piece, int k, double c, Interval part);

// Whether a one-dimensional curve is shown to be strictly increasing, or strictly decreasing, on its whole
// domain. The answer is false if the curve is constant to within rounding on an interval. A single point of
// slope 0 does no harm.
bool strictly_monotone(const SplinePtr &curve);

} // namespace nrb::refine
