// SPDX-License-Identifier: MIT
// Adaptive integration over splines of 1 to 3 axes of functions of the point and its first derivatives.
#pragma once

#include "measure/elements.h"

#include <vector>

namespace nrb::measure {

// An integrand with several values at once. The first value is the measure of how much an element matters:
// the tolerances of all values are relative to its integral, coordinates being at most about 1. The last
// `independent` values have tolerances relative to their own size, the integral of the first value's
// magnitude.
class Integrand {
public:
    virtual ~Integrand() = default;
    [[nodiscard]] virtual int64_t values() const noexcept = 0;
    [[nodiscard]] virtual int independent() const noexcept { return 0; }
    // Whether all values change their sign where the first one is negative, so that its magnitude is
    // integrated.
    [[nodiscard]] virtual bool absolute() const noexcept { return false; }
    // Whether values have dips and peaks where the spline turns sharply, as the densities of length and area
    // do.
    [[nodiscard]] virtual bool metric() const noexcept { return false; }
    // The degree of the values as polynomials along an axis on which the points have degree `places`, before
    // signs are changed; -1 if they are no polynomials.
    [[nodiscard]] virtual int degree(int places) const noexcept = 0;
    // `place` [dim]: the point in the frame of the model. `derivatives` [axes][dim]: with respect to
    // coordinates in [0, 1] of the element.
    virtual void operator()(const double *place, const double *derivatives, double *out) const noexcept = 0;
};

struct Integrals {
    std::vector<double> values;
    std::vector<double> errors; // estimates, with rounding
    double size = 0;            // integral of the magnitude of the first value
    double rounding = 0;        // bound on the rounding of each value
    bool converged = true;
};

// Integrates over all elements of all splines: tensor products of nested rules on elements that are halved
// along the axis with the largest estimated error. A tolerance below rounding requests the best that the
// limit of work allows.
Integrals integrate(const std::vector<Elements> &splines, const Integrand &integrand,
                    double relative_tolerance);

} // namespace nrb::measure
