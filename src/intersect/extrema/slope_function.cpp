// SPDX-License-Identifier: MIT
#include "intersect/extrema/slope_function.h"

#include "intersect/extrema/constant_layers.h"
#include "intersect/extrema/piece_value.h"

#include <algorithm>

namespace nrb::intersect {

SlopeFunction::SlopeFunction(const Spline &curve, Interval part, bool closed)
    : CurveFunction(curve, part, closed) {}

// The control points of the derivative are positive multiples of the differences of control points.
int SlopeFunction::far(int64_t e, double) const {
    if (curve().rational()) {
        return 0;
    }
    const auto degree = static_cast<size_t>(curve().axis(0).degree());
    const auto window = curve().points().subspan(static_cast<size_t>(span(e)) - degree, degree + 1);
    const auto pairs = [&](auto &&is) { return std::ranges::adjacent_find(window, is) == window.end(); };
    const bool rises = pairs([](double a, double b) { return !(a < b); }),
               falls = pairs([](double a, double b) { return !(a > b); });
    return degree == 0 ? 0 : rises ? 1 : falls ? -1 : 0;
}

FunctionPiece SlopeFunction::piece(int64_t e) const {
    const pieces::HomogeneousPiece piece = maker().piece(e);
    FunctionPiece result{pieces::tangent_numerator(piece, 0), constant(1), piece.positive};
    for (double &error : result.value.errors) {
        error += curve().rational() ? underflow : 0;
    }
    const ConstantLayers constants = constant_layers(curve(), {span(e)});
    for (const bool upper : {false, true}) {
        set_zero(result.value, last_axis, upper, constants.layers[0][upper ? 1 : 0] - 1);
    }
    return result;
}

bool SlopeFunction::is_constant(int64_t e) const {
    return constant_layers(curve(), {span(e)}).all;
}

double SlopeFunction::value(double parameter) const {
    const int64_t e = first_to(parameter);
    const Interval range = part(e);
    const double place = std::clamp((parameter - range.lower) / (range.upper - range.lower), 0.0, 1.0);
    return value_of(maker().piece(e), {place});
}

} // namespace nrb::intersect
