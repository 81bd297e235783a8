// Compositions: curves over the domain of the inner curve, of the product of the degrees.
#include "fuzz/harness.h"

using fuzz::Input;

namespace {

// A curve of few points in the parameter space of g: inside its domain, or a little outside.
fuzz::Handle any_inner(Input &in, const nurbs *g, const fuzz::Spline &s) {
    fuzz::Spline f;
    const fuzz::Axis axis = fuzz::any_axis(in, 4);
    f.degrees = {axis.degree};
    f.counts = {axis.count};
    f.knots = axis.knots;
    f.dim = in.rarely() ? 1 : s.axes32();
    f.total = axis.count;
    const int32_t choice = in.below(4);
    const bool rising = (choice & 1) != 0, weighted = (choice & 2) != 0, outside = in.rarely();
    for (int64_t i = 0; i < f.total; ++i) {
        for (int32_t k = 0; k < f.dim; ++k) {
            double domain[2];
            FUZZ_REQUIRE(nurbs_domain(g, k, domain) == NURBS_OK);
            const double part =
                rising ? (static_cast<double>(i) + 0.9 * in.unit()) / static_cast<double>(f.total)
                       : in.unit();
            const double reach = outside ? 1.5 : 1;
            f.points.push_back(domain[0] + (domain[1] - domain[0]) * part * reach);
        }
    }
    for (int64_t i = 0; i < f.total && weighted; ++i) {
        f.weights.push_back(in.rarely() ? in.anything() : 0.1 + in.unit());
    }
    return fuzz::Handle(fuzz::create(f));
}

bool small(const fuzz::Spline &s) {
    int64_t total = 0;
    for (const int32_t p : s.degrees) {
        total += p;
    }
    return s.total <= 400 && total <= 12;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Input in(data, size);
    const fuzz::Spline s = fuzz::any_spline(in);
    const fuzz::Handle g(fuzz::create(s));
    if (!g || !small(s)) {
        return 0;
    }
    const fuzz::Handle f = any_inner(in, g.get(), s);
    if (!f) {
        return 0;
    }
    nurbs *out = fuzz::poison();
    const nurbs_status status = nurbs_compose(g.get(), f.get(), &out);
    const fuzz::Handle h(FUZZ_MADE(status, out));
    if (h) {
        double before[2], after[2];
        int32_t dim = 0;
        FUZZ_REQUIRE(nurbs_domain(f.get(), 0, before) == NURBS_OK &&
                     nurbs_domain(h.get(), 0, after) == NURBS_OK &&
                     nurbs_dimension(h.get(), &dim) == NURBS_OK);
        FUZZ_REQUIRE(fuzz::same_bits(before, after, 2) && dim == s.dim);
    }
    return 0;
}
