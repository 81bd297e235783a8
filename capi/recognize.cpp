// Conics by their equation and their weights, and the recognition of shapes.
#include "checks.h"
#include "guard.h"

#include "query/conic_axes.h"
#include "query/shape_factor.h"

#include <algorithm>

using namespace nrb;
using namespace nrb::capi;

nurbs_status nurbs_conic_axes(const double *coefficients, int32_t *type, double *origin, double *x,
                              double *sizes) {
    return guard([&] {
        require(coefficients, "coefficients");
        require(type, "type");
        require(origin, "origin");
        require(x, "x");
        require(sizes, "sizes");
        check_apart({memory("type", type, 1), memory("origin", origin, 2), memory("x", x, 2),
                     memory("sizes", sizes, 2)},
                    {memory("coefficients", coefficients, 6)});
        const ConicAxes axes = conic_axes(coefficients);
        *type = axes.type;
        std::copy_n(axes.origin, 2, origin);
        std::copy_n(axes.x, 2, x);
        std::copy_n(axes.sizes, 2, sizes);
    });
}

nurbs_status nurbs_curve_shape_factor(const nurbs *g, double *factor, int32_t *type) {
    return guard([&] {
        const Spline &curve = spline_of(g);
        require(factor, "factor");
        require(type, "type");
        check_apart({memory("factor", factor, 1), memory("type", type, 1)}, {});
        const ShapeFactor found = shape_factor(curve);
        *factor = found.factor;
        *type = found.type;
    });
}
