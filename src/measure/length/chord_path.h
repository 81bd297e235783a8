// SPDX-License-Identifier: MIT
// Division of a curve into equal chords by numerical continuation: follows the chains of equidistant points
// on the curve as their distance changes.
#pragma once

#include "spline/spline.h"

#include <vector>

namespace nrb::measure {

// The chains t_0 < t_1 < ... < t_n with t_0 given and |C(t_i) - C(t_(i-1))| = d for all i satisfy n equations
// in the n + 1 unknowns t_1, ..., t_n and d; they form a curve, the path. It begins at d = 0 and goes on
// until t_n reaches the end of the range, since the distance of neighbours cannot vanish on the way except
// where the curve meets itself. That a division into equal chords exists was shown by K. Urbanik, "Sur un
// probleme de J. F. Pal sur les courbes continues", Bull. Acad. Polon. Sci. 2 (1954). On the path, d rises
// and falls, so that walks with a given d find parts of it only. The path is therefore followed by predictor
// steps along its tangent and corrections by Newton's method (E. Allgower, K. Georg, Introduction to
// Numerical Continuation Methods, 1990); the unknowns are the arc lengths by which the points move. Cost:
// each correction takes n + 1 evaluations and the solution of a bidiagonal system with a border.
class ChordPath {
public:
    // params: [n + 1], a chain of chords of length `chord` whose t_0 is the lower end of the range.
    // longest_step: the most that a point moves in one step, relative to the chord. Precondition: n > 1.
    ChordPath(const Spline &curve, Interval range, std::vector<double> params, double chord,
              double longest_step);

    // False if the path is lost, in which case it may lead back to the start, or if it is too long.
    bool run(double relative_tolerance);

    [[nodiscard]] const std::vector<double> &params() const noexcept { return params_; }
    [[nodiscard]] double chord() const noexcept { return chord_; }

private:
    struct State {
        std::vector<double> params;
        double chord;
        std::vector<double> tangent;
    };
    bool evaluate();
    bool solve(const std::vector<double> &last, double rhs, bool residuals, std::vector<double> &out);
    bool correct(const std::vector<double> &last, double tolerance, double farthest);
    bool move(const std::vector<double> &along, double by);
    bool turn();
    bool finish(double tolerance);
    bool step();

    const Spline &curve_;
    Interval range_;
    size_t count_; // number of chords, n
    std::vector<double> params_;
    double chord_;
    double start_;
    double longest_step_;
    double rounding_ = 0; // bound on the rounding of distances
    double length_ = 0;   // of the next step
    int64_t work_ = 0;
    std::vector<double> values_;       // [n + 1][2][dim]
    std::vector<double> speeds_;       // [n + 1]
    std::vector<double> ahead_, back_; // cosine of each chord with the tangent at its end, start
    std::vector<double> misses_;
    std::vector<double> tangent_, change_; // [n + 1]: component of d, then those of all points but the first
    std::vector<double> diagonal_, upper_, border_, right_;
};

} // namespace nrb::measure
