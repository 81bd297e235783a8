// SPDX-License-Identifier: MIT
#include "build/conics/implicit_conic.h"

#include "build/conics/conic_curves.h"
#include "recognize/conic_axes.h"

namespace nrb::build {

SplinePtr implicit_conic(const double *coefficients, double start, double end, int32_t form) {
    check_arc_form(form);
    const recognize::ConicAxes conic = recognize::conic_axes(coefficients);
    const Placement place = make_placement(2, conic.origin, nullptr, conic.x, "origin");
    switch (conic.type) {
    case recognize::conic_ellipse:
        return ellipse(place, conic.sizes[0], conic.sizes[1],
                       make_turn(start, end - start, "start", "end - start"), form);
    case recognize::conic_parabola:
        return parabola(place, conic.sizes[0], start, end);
    default:
        return hyperbola(place, conic.sizes[0], conic.sizes[1], start, end);
    }
}

} // namespace nrb::build
