// SPDX-License-Identifier: MIT
// Chains of points on a curve at equal distances, followed as their distance changes.
#pragma once

#include "spline/spline.h"

#include <vector>

namespace nrb::measure {

// The chains t_0 < t_1 < ... < t_n with |C(t_i) - C(t_(i-1))| = d for all i and t_0 given are n equations in
// n + 1 unknowns: a curve. It begins at d = 0 and goes on until t_n reaches the end of the range, since
// distances of neighbours cannot vanish on the way but where a curve meets itself; that a division exists is
// K. Urbanik, "Sur un probleme de J. F. Pal sur les courbes continues", Bull. Acad. Polon. Sci. 2 (1954). On
// this curve d rises and falls, so that walks with a given d find parts of it only. Followed by its tangent
// and Newton's method (E. Allgower, K. Georg, Introduction to Numerical Continuation Methods, 1990), the
// unknowns being the lengths that points move by. Cost: n evaluations and a bidiagonal system a correction.
class ChordPath {
public:
    // params: [n + 1], a chain of chords of this length, t_0 the lower end of the range. longest_step: no
    // point moves by more in one step, as a part of a chord. Precondition: n > 1.
    ChordPath(const Spline &curve, Interval range, std::vector<double> params, double chord,
              double longest_step);

    // False if the path is lost, which may lead back to the start, or too long.
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
    size_t count_; // n
    std::vector<double> params_;
    double chord_;
    double start_;
    double longest_step_;
    double rounding_ = 0; // of distances
    double length_ = 0;   // of the next step
    int64_t work_ = 0;
    std::vector<double> values_;       // [n + 1][2][dim]
    std::vector<double> speeds_;       // [n + 1]
    std::vector<double> ahead_, back_; // of each chord: its cosines with the tangents at both ends
    std::vector<double> misses_;
    std::vector<double> tangent_, change_; // [n + 1]: d, then each point but the first
    std::vector<double> diagonal_, upper_, border_, right_;
};

} // namespace nrb::measure
