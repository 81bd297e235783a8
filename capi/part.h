// SPDX-License-Identifier: MIT
// A part of the domain (a box of parameters) as an argument.
#pragma once

#include "checks.h"

#include "spline/part.h"

namespace nrb::capi {

// range: [axes][2], intervals of positive length in the domain; or NULL for the whole domain.
inline Part checked_part(const Spline &spline, const double *range) {
    Part part = whole_domain(spline);
    for (int k = 0; range != nullptr && k < spline.axes(); ++k) {
        const Interval asked{range[2 * k], range[2 * k + 1]};
        check_place(asked.lower, spline.axis(k).domain(), "range", k);
        check_place(asked.upper, spline.axis(k).domain(), "range", k);
        if (!(asked.lower < asked.upper)) {
            fail(Status::empty_domain, "range[%d] = [%s, %s], expected an interval of axis %d", k,
                 Number(asked.lower).text, Number(asked.upper).text, k);
        }
        part[static_cast<size_t>(k)] = asked;
    }
    return part;
}

} // namespace nrb::capi
