// A part of the domain, and a direction, as arguments.
#pragma once

#include "checks.h"

#include "bounds/spline_pieces.h"

#include <cmath>

namespace nrb::capi {

// range is [axes][2], or NULL for the whole domain.
inline Part checked_part(const Spline &spline, const double *range) {
    Part part = whole_domain(spline);
    for (int k = 0; range != nullptr && k < spline.axes(); ++k) {
        const double lower = range[2 * k], upper = range[2 * k + 1];
        check_place(lower, spline.axis(k).domain(), "range", k);
        check_place(upper, spline.axis(k).domain(), "range", k);
        if (!(lower < upper)) {
            fail(NURBS_ERROR_EMPTY_DOMAIN, "range of axis %d is [%s, %s], expected an interval", k,
                 Number(lower).text, Number(upper).text);
        }
        part[static_cast<size_t>(k)] = {lower, upper};
    }
    return part;
}

// Finite and not zero, else NURBS_ERROR_DIRECTION.
inline void check_direction(const double *direction, int dim, const char *name) {
    bool zero = true;
    for (int c = 0; c < dim; ++c) {
        zero = zero && direction[c] == 0;
        if (!std::isfinite(direction[c])) {
            fail(NURBS_ERROR_DIRECTION, "%s[%d] = %s is not finite", name, c, Number(direction[c]).text);
        }
    }
    if (zero) {
        fail(NURBS_ERROR_DIRECTION, "%s is zero", name);
    }
}

} // namespace nrb::capi
