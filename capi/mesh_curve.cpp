// SPDX-License-Identifier: MIT
// Approximates curves by polylines.
#include "checks.h"
#include "guard.h"
#include "outputs.h"

#include "mesh/polyline/polyline.h"
#include "spline/kind.h"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace nrb;
using namespace nrb::capi;

namespace {

// An angle or a length of 0 is no limit; without either, `chord` must be finite.
void check_rule(const mesh::PolylineRule &rule) {
    const bool limited = rule.angle > 0 || rule.longest > 0;
    if (!(rule.chord > 0) || (std::isinf(rule.chord) && !limited)) {
        fail(Status::tolerance, "chord = %s, expected > 0, and finite without an angle or a length",
             Number(rule.chord).text);
    }
    if (!(rule.angle >= 0 && rule.angle <= std::numbers::pi)) {
        fail(Status::angle, "angle = %s, expected 0, or an angle of at most pi", Number(rule.angle).text);
    }
    if (!(rule.longest >= 0) || std::isinf(rule.longest)) {
        fail(Status::length, "longest = %s, expected 0, or a length", Number(rule.longest).text);
    }
}

// The caller's arrays for a polyline, any of which may be null.
struct PolylineArrays {
    double *params, *points, *bound;
    int32_t *reached;
    int64_t *count;
};

void put_polyline(const mesh::Polyline &line, int64_t dim, int64_t cap, const PolylineArrays &out) {
    const int64_t needed = std::ssize(line.params), filled = checked_cap(cap, needed);
    check_apart({memory("params", out.params, filled), memory("points", out.points, filled * dim),
                 memory("bound", out.bound, 1), memory("reached", out.reached, 1),
                 memory("count", out.count, 1)},
                {});
    if (filled > 0) {
        put_all(out.params, line.params);
        put_all(out.points, line.points);
    }
    put(out.bound, *std::ranges::max_element(line.bounds));
    put(out.reached, int32_t{line.reached});
    put(out.count, needed);
}

} // namespace

nurbs_status nurbs_mesh_curve(const nurbs *g, double chord, double angle, double longest, int64_t cap,
                              double *params, double *points, double *bound, int32_t *reached,
                              int64_t *count) {
    return guard([&] {
        const Spline &curve = curve_of(g);
        const mesh::PolylineRule rule{chord, angle, longest};
        check_rule(rule);
        check_length(cap, "cap");
        put_polyline(mesh::polyline_of(curve, rule), curve.dim(), cap,
                     {params, points, bound, reached, count});
    });
}
