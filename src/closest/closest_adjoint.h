// SPDX-License-Identifier: MIT
// Gradients through closest points, by the implicit function theorem.
#pragma once

#include "closest/foot.h"
#include "eval/parameters.h"

namespace nrb::closest {

// Feet of query points, and dL by their parameters, points and distances; views without data are 0.
struct FootCotangents {
    ConstRecords queries;   // [count][dim]
    ConstRecords feet;      // [count][axes]
    ConstRecords params;    // [count][axes]
    ConstRecords points;    // [count][dim]
    ConstRecords distances; // [count]
};

// Views without data are not wanted.
struct FootGradients {
    Records points;  // [control points][dim]
    Records weights; // [control points]
    Records queries; // [count][dim]
    int32_t *status; // [count] or null: closest_ bits
};

// May throw only std::bad_alloc, before anything is written. Preconditions: the parameters of feet were
// checked.
void closest_adjoint(const Spline &spline, const eval::AxisRules &rules, const FootCotangents &in,
                     const FootGradients &out);

} // namespace nrb::closest
