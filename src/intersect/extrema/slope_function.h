// SPDX-License-Identifier: MIT
// The derivative of a scalar curve up to a positive factor, for its signs.
#pragma once

#include "intersect/curve_function.h"

namespace nrb::intersect {

class SlopeFunction final : public CurveFunction {
public:
    SlopeFunction(const Spline &curve, Interval part, bool closed);

    [[nodiscard]] int far(int64_t e, double tolerance) const override;
    [[nodiscard]] FunctionPiece piece(int64_t e) const override;
    // Whether the curve is constant on a piece, as its control points show.
    [[nodiscard]] bool is_constant(int64_t e) const;
    // The value of the curve itself at a parameter in the domain; at the ends the limit from inside.
    [[nodiscard]] double value(double parameter) const;

private:
    [[nodiscard]] int64_t span(int64_t e) const noexcept {
        return curve().axis(0).find_span(part(e).lower, false);
    }
};

} // namespace nrb::intersect
