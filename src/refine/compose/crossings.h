// SPDX-License-Identifier: MIT
// Where a coordinate of a curve passes given values, and whether it rises or falls, from the signs of
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

// A curve over one of its non-empty spans, coordinate by coordinate in Bernstein form. Weights are positive;
// they are known up to one power of two, which keeps products of them in range. Without weights they are 1.
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
    // The weights of the coefficients; none of a polynomial curve.
    [[nodiscard]] std::span<const double> weights() const noexcept { return weights_; }
    // The coefficients over another interval; the first degree + 1 are used.
    [[nodiscard]] Coefficients coefficients_between(int k, double from, double to) const noexcept;
    [[nodiscard]] Coefficients weights_between(double from, double to) const noexcept;
    // How accurately a control point of coordinate k is known. With the active control points F_i that is the
    // 4 (q + 1) eps max |F_i| of a polar form, or the 8 (q + 2) eps max |F_i| of the quotient of two with
    // positive weights, each of which is within as much of its own terms. A value is known to within the
    // same, plus what a rounding of the parameter moves it by, eps max |t| max |F'|.
    [[nodiscard]] double rounding(int k) const noexcept { return known_[static_cast<size_t>(k)].rounding; }
    [[nodiscard]] double uncertainty(int k) const noexcept {
        return known_[static_cast<size_t>(k)].uncertainty;
    }
    // How accurately the value at t in the piece is known: at an end it may be a control point.
    [[nodiscard]] double uncertainty_at(int k, double t) const noexcept;
    // Coordinate k of the polar form at degree arguments, divided by its weight; the second form takes one
    // argument t that often.
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
    // Coordinate k, or the weight, of the sum of control points times coefficients; with weights the coordinate is
    // divided by its own.
    [[nodiscard]] double value_of(const BlossomRow &row, int k) const noexcept;
    [[nodiscard]] double weight_of(const BlossomRow &row) const noexcept;
    [[nodiscard]] double quotient(const BlossomRow &row, int k) const noexcept;

    const Spline *curve_;
    int64_t span_;
    std::vector<double> weights_;      // [degree + 1], none of a polynomial curve
    std::vector<double> coefficients_; // [coordinate][degree + 1]
    std::vector<Known> known_;
};

// What is known of the sign of a coordinate minus a value c inside a piece. Halves until coefficients change
// their sign at most once on each part (Lane & Riesenfeld, "Bounds on a polynomial", BIT 21 (1981)), then
// goes to neighbouring doubles by secants. Where the coordinate touches c without crossing it, only the side
// is reported. Cost: q^2 for each halving, at most some 50 q of them, and some 10 evaluations for a crossing.
SignProfile sign_profile(const CurvePiece &piece, int k, double c);

// Whether the coordinate is above c on a part of the piece between crossings. Where its values differ from c
// by no more than their uncertainty, the signs of coefficients beyond their rounding decide. If there are
// none, the coordinate runs along c, which counts as above.
bool lies_above(const CurvePiece &piece, int k, double c, Interval part);

// Whether the curve of dimension 1 could be shown to increase, or to decrease, strictly on its whole domain.
// An interval on which it is constant to rounding makes this false, a point does not.
bool strictly_monotone(const SplinePtr &curve);

} // namespace nrb::refine
