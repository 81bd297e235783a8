// SPDX-License-Identifier: MIT
// The equations of conditions and their Jacobian at a state of the control points and weights.
#pragma once

#include "modify/constrain/net_state.h"

namespace nrb::modify {

// The equations of one condition.
struct LocalEquations {
    std::vector<int64_t> points;                // active control points
    std::vector<std::vector<double>> functions; // R^(a) for each derivative
    std::vector<std::vector<double>> slopes;    // by weights, if these may change; else empty
    std::vector<double> residual;
    std::vector<double> jacobian; // [equations][derivatives][dim]
    double limit = 0;             // the largest residual allowed

    [[nodiscard]] double length() const noexcept; // of the residual
};

// With a tolerance of 0, the limit of the residual is 64 eps times the size of its terms. Otherwise it is the
// residual that results if control points are off by the tolerance.
LocalEquations local_equations(const NetState &state, const Condition &condition, double tolerance);
std::vector<LocalEquations> all_equations(const NetState &state, const std::vector<Condition> &conditions,
                                          double tolerance);

// Throws Status::influence for a condition on which no control point that may move acts, and no weight that
// may change.
void check_influence(const NetState &state, const std::vector<LocalEquations> &all);

// Throws Status::not_representable for a condition that overflows or has no value, such as the curvature
// where a curve's derivative is 0.
void check_finite(const std::vector<LocalEquations> &all);

// The index of the condition that is missed by the largest multiple of its limit; -1 if all are met.
int64_t worst_missed(const std::vector<LocalEquations> &all) noexcept;

// Throws `status` with a message that names the condition of worst_missed() and its residual;
// Status::not_representable if the residual is not finite. Precondition: a condition is missed.
[[noreturn]] void fail_missed(Status status, const std::vector<LocalEquations> &all);

} // namespace nrb::modify
