// SPDX-License-Identifier: MIT
// Scalar functions along curves, piece by piece, as quotients of polynomials.
#pragma once

#include "intersect/implicit_form.h"

#include <memory>

namespace nrb::intersect {

// f = value / weight over one piece of the parameter range. `known`: the weight is certainly positive.
struct FunctionPiece {
    RoundedPolynomial value;
    RoundedPolynomial weight;
    bool known = true;
};

// A piecewise rational function of the parameter of a curve.
class CurveFunction {
public:
    explicit CurveFunction(const Spline &curve);
    // On a part of the curve. `closed`: the part is a whole period, at whose end the function continues at
    // the start.
    CurveFunction(const Spline &curve, Interval part, bool closed);
    CurveFunction(const CurveFunction &) = delete;
    CurveFunction &operator=(const CurveFunction &) = delete;
    virtual ~CurveFunction() = default;

    [[nodiscard]] int64_t count() const noexcept { return std::ssize(maker_.breaks(0)) - 1; }
    [[nodiscard]] Interval part(int64_t e) const noexcept {
        const std::vector<double> &breaks = maker_.breaks(0);
        return {breaks[static_cast<size_t>(e)], breaks[static_cast<size_t>(e) + 1]};
    }
    // The index of the first piece that ends at or beyond a parameter; count() if there is none.
    [[nodiscard]] int64_t first_to(double parameter) const noexcept;
    [[nodiscard]] Interval domain() const noexcept { return {part(0).lower, part(count() - 1).upper}; }
    [[nodiscard]] double period() const noexcept { return domain().upper - domain().lower; }
    [[nodiscard]] bool periodic() const noexcept { return periodic_; }
    [[nodiscard]] double parameter(int64_t e, double place) const noexcept;

    // 1 or -1: f or -f exceeds the tolerance on the whole piece, as the control values show; else 0.
    [[nodiscard]] virtual int far(int64_t e, double tolerance) const = 0;
    [[nodiscard]] virtual FunctionPiece piece(int64_t e) const = 0;

protected:
    [[nodiscard]] const Spline &curve() const noexcept { return curve_; }
    [[nodiscard]] const pieces::PieceMaker &maker() const noexcept { return maker_; }

private:
    const Spline &curve_;
    pieces::PieceMaker maker_;
    bool periodic_;
};

// An implicit form along a curve, which must outlive the function. Along Cartesian points a form of degree 1
// is a spline with the knots and weights of the curve, and its control values are the values of the form at
// the control points.
std::unique_ptr<CurveFunction> function_along(const Spline &curve, const ImplicitForm &form);

} // namespace nrb::intersect
