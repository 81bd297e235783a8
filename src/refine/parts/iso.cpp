// SPDX-License-Identifier: MIT
#include "refine/parts/iso.h"

#include "eval/functions/axis_basis.h"
#include "spline/layer_table.h"

namespace nrb::refine {

SplinePtr iso(const Spline &spline, int axis, double t, const eval::AxisRule &rule) {
    if (spline.axes() == 1) {
        fail(Status::axes, "g has 1 axis: an iso-curve needs a surface or a volume");
    }
    if (rule.nan) {
        fail(Status::flags, "flags: NURBS_NAN has no meaning for an iso-curve");
    }
    const KnotVector &fixed = spline.axis(axis);
    eval::check_parameter(t, rule, fixed.domain(), "param");
    double values[max_basis] = {};
    eval::AxisBasis basis{.values = values};
    eval::AxisEvaluator(fixed, rule, 0)(t, basis);
    LayerTable table;
    table.add_row(basis.first, values, fixed.degree() + 1);
    Net net = apply_along(spline, axis, table);
    Spline::Axes axes = spline.knot_vectors();
    axes.erase(axes.begin() + axis);
    return make_result(std::move(axes), spline.dim(), spline.form(), std::move(net.points),
                       std::move(net.weights));
}

} // namespace nrb::refine
