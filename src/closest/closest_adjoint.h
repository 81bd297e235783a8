// SPDX-License-Identifier: MIT
// Reverse-mode gradients (adjoints) of closest points, by the implicit function theorem.
#pragma once

#include "closest/foot.h"
#include "eval/parameters.h"

namespace nrb::closest {

// The feet of the query points, and the derivatives of a scalar L with respect to their parameters, points
// and distances. A view without data stands for zeros.
struct FootCotangents {
    ConstRecords queries;   // [count][dim]
    ConstRecords feet;      // [count][axes]
    ConstRecords params;    // [count][axes]
    ConstRecords points;    // [count][dim]
    ConstRecords distances; // [count]
};

// The derivatives of L that are wanted. Views without data are not computed.
struct FootGradients {
    Records points;  // [control points][dim]
    Records weights; // [control points]
    Records queries; // [count][dim]
    int32_t *status; // [count] or null: closest_ bits
};

// Throws at most std::bad_alloc, and only before anything is written. Precondition: the caller has checked
// the parameters of the feet.
void closest_adjoint(const Spline &spline, const eval::AxisRules &rules, const FootCotangents &in,
                     const FootGradients &out);

} // namespace nrb::closest
