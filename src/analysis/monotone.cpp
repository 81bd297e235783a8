// SPDX-License-Identifier: MIT
#include "analysis/monotone.h"

#include "analysis/curve_pieces.h"
#include "analysis/curve_signs.h"

#include <algorithm>
#include <cmath>

namespace nrb::analysis {

namespace {

// The direction scaled by a power of two, so that its largest component is near 1.
std::vector<double> scaled_direction(const double *direction, int dim) {
    std::vector<double> d(direction, direction + dim);
    double largest = 0;
    for (const double x : d) {
        largest = std::max(largest, std::abs(x));
    }
    const int exponent = std::ilogb(largest);
    std::for_each(d.begin(), d.end(), [exponent](double &x) { x = std::ldexp(x, -exponent); });
    return d;
}

RoundedPolynomial component_along(const RoundedPolynomial &d, const std::vector<double> &direction) {
    RoundedPolynomial result = scaled(component(d, 0), direction[0]);
    for (size_t c = 1; c < direction.size(); ++c) {
        result = sum(result, direction[c], component(d, static_cast<int>(c)));
    }
    return result;
}

} // namespace

MonotonePieces monotone_pieces(const Spline &curve, const double *direction) {
    CurvePieces pieces(curve);
    const std::vector<double> unit = scaled_direction(direction, curve.dim());
    MonotonePieces result;
    for (size_t e = 0; e < pieces.count(); ++e) {
        const pieces::HomogeneousPiece &piece = pieces.piece(e);
        const SignRuns signs = sign_runs(component_along(pieces::tangent_numerator(piece, 0), unit));
        result.complete = result.complete && !signs.doubtful;
        bool fresh = e == 0 || pieces.jump(e) > 0;
        double from = piece.parameter(0, 0);
        const bool single = signs.runs.size() == 1; // a single hidden run is constant to rounding
        for (const SignRun &run : signs.runs) {
            result.complete = result.complete && (run.sign != 0 || run.simple || signs.nothing);
            if (run.sign == 0 && !single) { // neighbours meet at the zero or in the middle
                const double place = run.zero >= 0 ? run.zero : run.from / 2 + run.to / 2;
                from = fresh ? from : piece.parameter(0, place);
                continue;
            }
            if (fresh || result.pieces.back().sign != run.sign) {
                result.pieces.push_back({from, run.sign});
            }
            fresh = false;
            from = piece.parameter(0, run.to);
        }
    }
    return result;
}

} // namespace nrb::analysis
