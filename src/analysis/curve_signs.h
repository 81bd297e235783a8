// SPDX-License-Identifier: MIT
// The signs of a piecewise function along a whole curve.
#pragma once

#include "analysis/curve_pieces.h"
#include "bernstein/sign_runs.h"

#include <functional>

namespace nrb::analysis {

// An interval of parameters on which the sign is certain (1 or -1), or on which it is 0 or hidden by rounding
// (0).
struct CurveRun {
    double from;
    double to;
    int sign;
    bool estimated = false; // in a hidden run, the computed values change their sign at `zero`
    double zero = 0;
};

struct CurveSigns {
    std::vector<CurveRun> runs;
    bool complete = true; // no zero is hidden by rounding
};

// A scalar polynomial for each piece of a curve, up to a positive factor.
using Numerator = std::function<RoundedPolynomial(const pieces::HomogeneousPiece &)>;

// Whether all coefficients are 0 with no rounding error.
bool exactly_zero(const RoundedPolynomial &f) noexcept;

// Appends the runs of one piece, converted to parameters of the curve. curve_signs() reports a piece whose
// weight has no certain sign as one hidden run.
void append_runs(const pieces::HomogeneousPiece &piece, const SignRuns &signs, CurveSigns &out);
CurveSigns curve_signs(CurvePieces &pieces, const Numerator &numerator);

// A change from one certain sign to the other, between the end of one run and the start of the next.
struct SignChange {
    double from;
    double to;
    int before;
    int after;
    double at; // the best estimate of its place
};

// If the axis is periodic, the list includes a change at the seam, reported at the start.
std::vector<SignChange> sign_changes(const std::vector<CurveRun> &runs, bool periodic);

} // namespace nrb::analysis
