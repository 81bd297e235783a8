// SPDX-License-Identifier: MIT
// Principal axes of conics from their implicit equation, shape factors of conics from their weights, and the
// recognition of elementary curves and surfaces.
#include "checks.h"
#include "guard.h"
#include "outputs.h"

#include "base/tolerance.h"
#include "recognize/conic_axes.h"
#include "recognize/recognize.h"
#include "recognize/shape_factor.h"

#include <algorithm>
#include <span>

using namespace nrb;
using namespace nrb::capi;

namespace {

// Adding 0 turns -0 into 0.
void copy(const Vector3 &v, double *out) noexcept {
    out[0] = v.x + 0.0;
    out[1] = v.y + 0.0;
    out[2] = v.z + 0.0;
}

// Numbers that have no meaning for the kind of shape are 0.
void copy_placement(const recognize::Shape &shape, double *out) noexcept {
    const bool axis = shape.kind > NURBS_SHAPE_POINT && shape.kind != NURBS_SHAPE_SPHERE;
    copy(shape.origin, out);
    copy(axis ? shape.z : Vector3{}, out + 3);
    copy(axis && shape.kind != NURBS_SHAPE_LINE ? shape.x : Vector3{}, out + 6);
}

} // namespace

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
        const recognize::ConicAxes axes = recognize::conic_axes(coefficients);
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
        const recognize::ShapeFactor found = recognize::shape_factor(curve);
        *factor = found.factor;
        *type = found.type;
    });
}

nurbs_status nurbs_recognize(const nurbs *g, double tolerance, int32_t *shape, double *placement,
                             double *sizes, double *deviation) {
    return guard([&] {
        const Spline &spline = spline_of(g);
        check_positive_tolerance(tolerance);
        require(shape, "shape");
        check_apart({memory("shape", shape, 1), memory("placement", placement, 9), memory("sizes", sizes, 3),
                     memory("deviation", deviation, 1)},
                    {});
        const recognize::Recognition found = recognize::recognize(spline, tolerance);
        *shape = found.shape.kind;
        if (placement != nullptr) {
            copy_placement(found.shape, placement);
        }
        put_all(sizes, std::span(found.shape.sizes));
        put(deviation, found.deviation);
    });
}
