// SPDX-License-Identifier: MIT
// Certified signs of a polynomial of one variable: root isolation in the Bernstein basis.
#pragma once

#include "bernstein/rounded_polynomial.h"

#include <vector>

namespace nrb::inline bernstein {

// A subinterval of [0, 1]. Sign 1 or -1: the polynomial certainly has that sign in its interior. Sign 0:
// either a certain zero, proven simple (`simple`, with from == to), or an interval in which rounding hides
// the sign.
struct SignRun {
    double from;
    double to;
    int sign;
    bool simple = false;
    double zero = -1; // where the computed values of a hidden run change their sign; -1: they do not
};

// Consecutive runs of alternating kinds. Coefficients that vanish up to rounding at an end of [0, 1] count as
// 0 and are divided out, so that zeros within rounding of an end count as lying at it, with the
// multiplicities below. For a zero of multiplicity m that distance is at most 2^(-32 / m); otherwise the
// result is `doubtful`.
struct SignRuns {
    std::vector<SignRun> runs;
    int zeros_at_start = 0;
    int zeros_at_end = 0;
    bool nothing = false;  // the polynomial vanishes up to rounding; there is one run, of sign 0
    bool doubtful = false; // rounding may move the zeros at an end farther than that
};

// By the variation diminishing property (Descartes' rule of signs): no certain sign change among the
// coefficients means no zero, one means exactly one zero. Other parts are subdivided, at places away from
// zeros, until rounding hides everything. Precondition: a scalar polynomial, of degree 0 on all axes but the
// last. Cost: quadratic in the degree for each subdivision.
SignRuns sign_runs(RoundedPolynomial f);

// A place where all components of a vector polynomial vanish up to rounding. If it is not `certain`, it is an
// interval in which rounding hides whether, and how often, they do.
struct ZeroPlace {
    double from;
    double to;
    bool certain;
};

// The places, in increasing order. A component without zeros proves that the vector has none; a component
// with a single zero leaves that place, where the other components are compared with their rounding errors.
// Ends are treated as in sign_runs().
std::vector<ZeroPlace> zero_places(RoundedPolynomial v);

} // namespace nrb::inline bernstein
