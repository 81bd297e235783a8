// SPDX-License-Identifier: MIT
#include "spline/same_numbers.h"

#include <algorithm>

namespace nrb::inline spline {

bool same_numbers(const Spline &a, const Spline &b) noexcept {
    if (&a == &b) {
        return true;
    }
    bool same = a.axes() == b.axes() && a.dim() == b.dim() && a.form() == b.form();
    for (int k = 0; same && k < a.axes(); ++k) {
        same = a.axis(k).degree() == b.axis(k).degree() &&
               std::ranges::equal(a.axis(k).knots(), b.axis(k).knots());
    }
    return same && std::ranges::equal(a.points(), b.points()) && std::ranges::equal(a.weights(), b.weights());
}

} // namespace nrb::inline spline
