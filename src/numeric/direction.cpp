// SPDX-License-Identifier: MIT
#include "numeric/direction.h"

#include "base/finite.h"
#include "numeric/norm.h"

#include <cmath>

namespace nrb::inline numeric {

// Scaled by a power of two first, so that no length over- or underflows.
std::vector<double> unit_vector(const double *direction, int dim) {
    std::vector<double> unit(direction, direction + dim);
    const int exponent = -std::ilogb(largest_magnitude(unit));
    for (double &x : unit) {
        x = std::ldexp(x, exponent);
    }
    const double length = norm(unit.data(), dim);
    for (double &x : unit) {
        x /= length;
    }
    return unit;
}

} // namespace nrb::inline numeric
