// The equations of conditions at a state of the control points and weights.
#pragma once

#include "modify/constrain/net_state.h"

namespace nrb::modify {

// Those of one condition.
struct LocalEquations {
    std::vector<int64_t> points;                // active
    std::vector<std::vector<double>> functions; // R^(a) for each derivative
    std::vector<std::vector<double>> slopes;    // by weights, where these change; else empty
    std::vector<double> residual;
    std::vector<double> jacobian; // [equations][derivatives][dim]
    double limit = 0;             // what a residual may be

    [[nodiscard]] double length() const noexcept; // of the residual
};

// A tolerance of 0 means 64 eps times the size of the terms; otherwise a residual may be what the tolerance
// makes of it when control points are off by it.
LocalEquations local_equations(const NetState &state, const Condition &condition, double tolerance);
std::vector<LocalEquations> all_equations(const NetState &state, const std::vector<Condition> &conditions,
                                          double tolerance);

// Throws Status::influence for a condition on which no control point that may move acts, no weight
// either.
void check_influence(const NetState &state, const std::vector<LocalEquations> &all);

// Throws Status::not_representable for a condition that overflows or has no value, as the curvature where
// a curve's derivative is 0.
void check_finite(const std::vector<LocalEquations> &all);

// The condition that is missed by most of its limit; -1 if all are met.
int64_t worst_missed(const std::vector<LocalEquations> &all) noexcept;

// Throws the status naming that condition and by how much it is missed, Status::not_representable if that
// overflows.
[[noreturn]] void fail_missed(Status status, const std::vector<LocalEquations> &all);

} // namespace nrb::modify
