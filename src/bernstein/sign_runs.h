// SPDX-License-Identifier: MIT
// Where a polynomial has which sign, with proof.
#pragma once

#include "bernstein/rounded_polynomial.h"

#include <vector>

namespace nrb::inline bernstein {

// An interval between places 0 and 1. Sign 1 or -1: certain, but for the ends. Sign 0: a zero that is known
// to be one and simple (`simple`, from and to being one place), or rounding hides the sign.
struct SignRun {
    double from;
    double to;
    int sign;
    bool simple = false;
    double zero = -1; // where the computed values of a hidden run change their sign, if they do
};

// Runs one after the other, of alternating kinds. Coefficients that vanish to rounding at an end of [0, 1]
// count as 0: they are divided out, so that zeros within rounding of the ends count as being at them, with
// these multiplicities. With a zero of multiplicity m that is a distance of 2^(-32 / m) at most, or it is
// `doubtful`.
struct SignRuns {
    std::vector<SignRun> runs;
    int zeros_at_start = 0;
    int zeros_at_end = 0;
    bool nothing = false;  // the polynomial vanishes to rounding; there is one run, of sign 0
    bool doubtful = false; // rounding moves the zeros at an end by more than it has to
};

// Variation diminishing: no certain change of sign among the coefficients, no zero; one, exactly one
// (Descartes). Everything else is halved, away from zeros of which the middle would be one, until rounding
// hides all. Precondition: a scalar polynomial, of degree 0 on all axes but the last. Cost: quadratic in the
// degree for each halving.
SignRuns sign_runs(RoundedPolynomial f);

// Where all components of a vector vanish to rounding, as places that rise. One that is not `certain` is an
// interval in which rounding hides whether, and how often, they do.
struct ZeroPlace {
    double from;
    double to;
    bool certain;
};

// A component without zero proves that there is none; one with a single zero leaves that place, where the
// others are compared with their rounding. Ends count as in sign_runs().
std::vector<ZeroPlace> zero_places(RoundedPolynomial v);

} // namespace nrb::inline bernstein
