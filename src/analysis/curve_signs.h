// SPDX-License-Identifier: MIT
// Signs along a whole curve, piece by piece.
#pragma once

#include "analysis/curve_pieces.h"
#include "bernstein/sign_runs.h"

#include <functional>

namespace nrb::analysis {

// An interval of parameters with a certain sign (1 or -1), or one in which it is 0 or hidden (0).
struct CurveRun {
    double from;
    double to;
    int sign;
    bool estimated = false; // a hidden run in which the computed values change their sign at `zero`
    double zero = 0;
};

struct CurveSigns {
    std::vector<CurveRun> runs;
    bool complete = true; // no zero is hidden by rounding
};

// Scalar polynomials on the pieces of a curve, up to positive factors.
using Numerator = std::function<RoundedPolynomial(const pieces::HomogeneousPiece &)>;

// Whether all values are 0 without any rounding.
bool exactly_zero(const RoundedPolynomial &f) noexcept;

// The runs of one piece in its parameters. Pieces whose weight has no certain sign have none.
void append_runs(const pieces::HomogeneousPiece &piece, const SignRuns &signs, CurveSigns &out);
CurveSigns curve_signs(CurvePieces &pieces, const Numerator &numerator);

// Where a sign changes into the other one: between the end of one run and the start of the next.
struct SignChange {
    double from;
    double to;
    int before;
    int after;
    double at; // the best estimate between them
};

// With the change at the seam, given as the start, if the axis is periodic.
std::vector<SignChange> sign_changes(const std::vector<CurveRun> &runs, bool periodic);

} // namespace nrb::analysis
