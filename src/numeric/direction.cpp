// SPDX-License-Identifier: MIT
#include "numeric/direction.h"

#include "base/finite.h"
#include "numeric/norm.h"

#include <cmath>

namespace nrb::inline numeric {

// The direction is first scaled by a power of two, so that its length neither over- nor underflows.
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
