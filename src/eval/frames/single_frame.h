// SPDX-License-Identifier: MIT
// The frame of a surface at a single parameter, the most frequent call of many programs.
#pragma once

#include "eval/kernels/single_kernel.h"

namespace nrb::eval {

// The tables that a frame is computed from.
struct SingleFrameTables {
    const SingleTables *points;
    const SingleTables *derivs; // of the moved surface that derivatives come from; may be `points`
    double error_u;             // as DerivativeErrors
    double error_v;
};

using SingleFrame = std::array<double, 12>; // S, S_u, S_v and the unit normal

// The tables of a surface in space, or null as long as it has not been evaluated often enough to have all of
// them.
const SingleFrameTables *single_frame_tables(const Spline &surface) noexcept;
// Makes these tables if all that they point to exists or has been paid for. Called after an evaluation.
void keep_single_frame_tables(const Spline &surface);

// The same frame as in a batch, bit for bit. Returns false where more than the tables is needed: at knots,
// outside the domain, and where the normal may not be regular. `frame` is then meaningless.
bool evaluate_single_frame(const SingleFrameTables &tables, const double *params,
                           SingleFrame &frame) noexcept;

} // namespace nrb::eval
