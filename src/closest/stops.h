// SPDX-License-Identifier: MIT
// Places at which a foot can stay fixed although the shape or the query point moves.
#pragma once

#include "basis/knot_vector.h"

namespace nrb::closest {

// Whether a parameter is an end of an axis that is not periodic.
inline bool is_end(const KnotVector &axis, double param) noexcept {
    const Interval domain = axis.domain();
    return !axis.periodic() && (param == domain.lower || param == domain.upper);
}

// Whether the derivative of the distance along an axis need not vanish at a foot with this parameter: at an
// end, at a knot where the tangent may jump, and everywhere on an axis of degree 0, which has no tangent.
inline bool may_hold_foot(const KnotVector &axis, double param) noexcept {
    return is_end(axis, param) || multiplicity(axis.knots(), param) >= axis.degree();
}

} // namespace nrb::closest
