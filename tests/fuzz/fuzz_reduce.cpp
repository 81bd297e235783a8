// Removal, reduction and simplification: results are within their bounds, and bounds within tolerances.
#include "fuzz/harness.h"

using fuzz::Input;

namespace {

int32_t any_axis(Input &in, const fuzz::Spline &s) {
    return in.rarely() ? in.bad_int() : in.below(s.axes());
}

double any_tolerance(Input &in) {
    return in.rarely() ? in.anything() : in.below(3) * in.unit();
}

// The certificate holds against one made anew; unclamped ends may have been clamped in between.
void check_bound(const nurbs *g, const nurbs *made, double bound) {
    double lower = -7, upper = -7;
    if (FUZZ_OK(nurbs_deviation(g, made, &lower, &upper))) {
        FUZZ_REQUIRE(lower <= upper && lower >= 0 && lower <= bound);
    }
}

void check_reduced(nurbs_status status, const nurbs *g, nurbs *out, double bound, double tolerance) {
    const fuzz::Handle h(FUZZ_MADE(status, out));
    FUZZ_REQUIRE(h ? bound <= tolerance : bound == -7);
    if (h) {
        check_bound(g, h.get(), bound);
    }
}

void remove_one(Input &in, const nurbs *g, const fuzz::Spline &s) {
    const int32_t axis = any_axis(in, s);
    const double knot =
        in.rarely() ? in.anything() : fuzz::any_param(in, g, axis >= 0 && axis < s.axes() ? axis : 0, true);
    const int32_t times = in.rarely() ? in.bad_int() : in.below(4);
    const double tolerance = any_tolerance(in);
    int32_t removed = -7;
    double bound = -7;
    nurbs *out = fuzz::poison();
    const nurbs_status status = nurbs_remove_knot(g, axis, knot, times, tolerance, &removed, &bound, &out);
    FUZZ_REQUIRE(status == NURBS_OK ? removed >= 0 && removed <= times : removed == -7);
    check_reduced(status, g, out, bound, tolerance);
}

void reduce(Input &in, const nurbs *g, const fuzz::Spline &s) {
    const double tolerance = any_tolerance(in);
    double bound = -7;
    nurbs *out = fuzz::poison();
    const int32_t axis = in.coin() ? -1 : any_axis(in, s);
    const nurbs_status thinned = nurbs_reduce_knots(g, axis, tolerance, &bound, &out);
    check_reduced(thinned, g, out, bound, tolerance);
    bound = -7;
    out = fuzz::poison();
    const int32_t times = in.rarely() ? in.bad_int() : in.below(3);
    const nurbs_status lowered = nurbs_reduce_degree(g, any_axis(in, s), times, &bound, &out);
    check_reduced(lowered, g, out, bound, std::numeric_limits<double>::infinity());
    bound = -7;
    out = fuzz::poison();
    const nurbs_status simple = nurbs_simplify(g, tolerance, &bound, &out);
    check_reduced(simple, g, out, bound, tolerance);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Input in(data, size);
    const fuzz::Spline s = fuzz::any_spline(in);
    const fuzz::Handle g(fuzz::create(s));
    if (g && s.total <= 60) {
        remove_one(in, g.get(), s);
        reduce(in, g.get(), s);
    }
    return 0;
}
