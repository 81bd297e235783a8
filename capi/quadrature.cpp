// SPDX-License-Identifier: MIT
// Gauss quadrature over splines and faces: nodes and weights for integrands of the caller.
#include "checks.h"
#include "guard.h"
#include "outputs.h"
#include "watched.h"

#include "face/integrals/face_quadrature.h"
#include "measure/span_quadrature.h"
#include "numeric/gauss_rule.h"

#include <algorithm>
#include <vector>

using namespace nrb;
using namespace nrb::capi;

namespace {

void check_nodes(int32_t nodes) {
    if (nodes < 0 || nodes > most_gauss_nodes) {
        fail(Status::count, "nodes = %d, expected 0 to %d", nodes, most_gauss_nodes);
    }
}

} // namespace

nurbs_status nurbs_quadrature(const nurbs *g, int32_t nodes, int64_t cap, double *params, double *weights,
                              double *measures, int64_t *count) {
    return guard([&] {
        const Spline &spline = spline_of(g);
        check_nodes(nodes);
        const measure::SpanQuadrature rule(spline, nodes);
        const int64_t filled = checked_cap(cap, rule.size());
        check_apart({memory("params", params, filled * spline.axes()), memory("weights", weights, filled),
                     memory("measures", measures, filled), memory("count", count, 1)},
                    {});
        if (filled > 0) {
            using Values = std::vector<double>;
            const Values at = params != nullptr ? rule.params() : Values(),
                         of_params = weights != nullptr ? rule.weights() : Values(),
                         of_shape = measures != nullptr ? rule.measures() : Values();
            put_all(params, at);
            put_all(weights, of_params);
            put_all(measures, of_shape);
        }
        put(count, rule.size());
    });
}

nurbs_status nurbs_face_quadrature(const nurbs_face *face, int32_t nodes, int64_t cap, double *params,
                                   double *weights, double *measures, int64_t *count) {
    return guard([&] {
        const face::Face &own = face_of(face);
        check_nodes(nodes);
        const Spline &surface = *own.surface();
        const int most = std::max(surface.axis(0).degree(), surface.axis(1).degree()) + 1;
        const face::FaceQuadrature rule = face::face_quadrature(own, nodes == 0 ? most : nodes);
        const int64_t filled = checked_cap(cap, rule.size());
        check_apart({memory("params", params, 2 * filled), memory("weights", weights, filled),
                     memory("measures", measures, filled), memory("count", count, 1)},
                    {});
        if (filled > 0) {
            const std::vector<double> areas =
                measures != nullptr ? face::measures_of(own, rule) : std::vector<double>();
            put_all(params, rule.params);
            put_all(weights, rule.weights);
            put_all(measures, areas);
        }
        put(count, rule.size());
    });
}

nurbs_status nurbs_face_quadrature_with(const nurbs_face *face, int32_t nodes, int64_t cap, double *params,
                                        double *weights, double *measures, int64_t *count,
                                        const nurbs_call_options *call) {
    return watched(call,
                   [&] { return nurbs_face_quadrature(face, nodes, cap, params, weights, measures, count); });
}
