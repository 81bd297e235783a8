// SPDX-License-Identifier: MIT
// The frame of a surface at one parameter, as most programs ask for frames.
#pragma once

#include "eval/kernels/single_kernel.h"

namespace nrb::eval {

struct SingleFrameTables {
    const SingleTables *points;
    const SingleTables *derivs; // of the moved surface that derivatives come from, or `points`
    double error_u;             // as DerivativeErrors
    double error_v;
};

using SingleFrame = std::array<double, 12>; // S, S_u, S_v and the unit normal

// The tables of a surface in space that was evaluated often enough to have all of them; null before.
const SingleFrameTables *single_frame_tables(const Spline &surface) noexcept;
// Makes them if that is so; called after an evaluation.
void keep_single_frame_tables(const Spline &surface);

// The same frame as in a batch. False where it takes more than this: at knots, and where the normal may not be
// regular.
bool evaluate_single_frame(const SingleFrameTables &tables, const double *params,
                           SingleFrame &frame) noexcept;

} // namespace nrb::eval
