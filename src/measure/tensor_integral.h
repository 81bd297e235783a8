// SPDX-License-Identifier: MIT
// Integrals over splines of 1 to 3 axes of functions of the place and the first derivatives.
#pragma once

#include "measure/elements.h"

#include <vector>

namespace nrb::measure {

// What is integrated, several values at once. The first one says how much an element matters, and its
// integral is what the tolerance of the others is relative to, coordinates being at most about 1; the last
// `independent` ones are relative to themselves.
class Integrand {
public:
    virtual ~Integrand() = default;
    [[nodiscard]] virtual int values() const noexcept = 0;
    [[nodiscard]] virtual int independent() const noexcept { return 0; }
    // Whether all values change their sign where the first one is negative, so that its magnitude counts.
    [[nodiscard]] virtual bool absolute() const noexcept { return false; }
    // Whether values have dips and peaks where the spline turns sharply, as those of lengths and areas.
    [[nodiscard]] virtual bool metric() const noexcept { return false; }
    // The degree, before signs are changed, along an axis along which the places have this degree, if it is a
    // polynomial, else -1.
    [[nodiscard]] virtual int degree(int places) const noexcept = 0;
    // `place` [dim] in the frame of the model, `derivatives` [axes][dim] with respect to coordinates in [0,
    // 1] of the element.
    virtual void operator()(const double *place, const double *derivatives, double *out) const noexcept = 0;
};

struct Integrals {
    std::vector<double> values;
    std::vector<double> errors; // estimates, rounding included
    double size = 0;            // integral of the magnitude of the first one
    double rounding = 0;        // of each, at most
    bool converged = true;
};

// Over all elements of all splines: tensor products of nested rules, halved along the axis on which three
// rules disagree most. A tolerance below rounding asks for the best that the limit of work allows.
Integrals integrate(const std::vector<Elements> &splines, const Integrand &integrand,
                    double relative_tolerance);

} // namespace nrb::measure
