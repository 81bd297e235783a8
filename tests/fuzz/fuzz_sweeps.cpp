// Shapes from one or two splines: extruded, revolved, ruled, tensor and swung ones.
#include "fuzz/harness.h"

using fuzz::Input;

namespace {

double any_value(Input &in) {
    return in.rarely() ? in.anything() : in.number();
}

std::vector<double> any_vector(Input &in, int n) {
    std::vector<double> v(static_cast<size_t>(n));
    std::generate(v.begin(), v.end(), [&] { return any_value(in); });
    return v;
}

// A curve or surface of few points, mostly of the dimension wanted.
fuzz::Spline any_part(Input &in, int axes, int32_t dim) {
    static constexpr int64_t room[] = {8, 3};
    fuzz::Spline s;
    for (int k = 0; k < axes; ++k) {
        const fuzz::Axis axis = fuzz::any_axis(in, room[axes - 1]);
        s.degrees.push_back(axis.degree);
        s.counts.push_back(axis.count);
        s.knots.insert(s.knots.end(), axis.knots.begin(), axis.knots.end());
        s.flags |= axis.periodic ? NURBS_ON_AXIS(k, NURBS_PERIODIC) : 0;
        s.total *= axis.count;
    }
    s.dim = in.rarely() ? 1 + in.below(4) : dim;
    if (s.total <= 400) {
        fuzz::fill_values(in, s, in.coin());
    }
    return s;
}

// Its points are homogeneous records at times.
nurbs *create(Input &in, const fuzz::Spline &s) {
    nurbs *g = s.total > 400 ? nullptr : fuzz::create(s);
    if (g == nullptr || !in.rarely()) {
        return g;
    }
    const fuzz::Handle given(g);
    nurbs *out = fuzz::poison();
    nurbs_status status = nurbs_to_homogeneous(g, &out);
    const fuzz::Handle records(FUZZ_MADE(status, out));
    out = fuzz::poison();
    status = nurbs_from_homogeneous(records.get(), &out);
    return FUZZ_MADE(status, out);
}

int32_t axes_of(const nurbs *g) {
    int32_t axes = 0;
    FUZZ_REQUIRE(nurbs_axes(g, &axes) == NURBS_OK);
    return axes;
}

void check_made(nurbs *made, int32_t axes) {
    const fuzz::Handle h(made);
    FUZZ_REQUIRE(!h || axes_of(h.get()) == axes);
}

void one_spline(Input &in, const nurbs *g, int32_t dim) {
    nurbs *out = fuzz::poison();
    const std::vector<double> vector = any_vector(in, dim);
    nurbs_status status = nurbs_extrude(g, vector.data(), &out);
    check_made(FUZZ_MADE(status, out), axes_of(g) + 1);
    const std::vector<double> point = any_vector(in, 3), axis = any_vector(in, 3);
    const double sweep = in.coin() ? (in.below(49) - 24) * std::acos(-1.0) / 12 : 2 * any_value(in);
    const int32_t form = in.rarely() ? in.bad_int() : in.below(3);
    out = fuzz::poison();
    status = nurbs_revolve(g, in.coin() ? point.data() : nullptr, in.coin() ? axis.data() : nullptr, sweep,
                           form, &out);
    check_made(FUZZ_MADE(status, out), axes_of(g) + 1);
}

void two_splines(Input &in, const nurbs *a, const nurbs *b, bool small) {
    nurbs *out = fuzz::poison();
    nurbs_status status = nurbs_tensor_sum(a, any_value(in), b, any_value(in), &out);
    check_made(FUZZ_MADE(status, out), axes_of(a) + axes_of(b));
    out = fuzz::poison();
    status = nurbs_tensor_product(a, b, &out);
    check_made(FUZZ_MADE(status, out), axes_of(a) + axes_of(b));
    out = fuzz::poison();
    status = nurbs_surface_swung(a, b, any_value(in), &out);
    check_made(FUZZ_MADE(status, out), 2);
    if (small) {
        out = fuzz::poison();
        const uint32_t flags = in.rarely() ? 1U << in.below(32) : in.coin() ? NURBS_RULED_CARTESIAN : 0;
        status = nurbs_ruled(a, b, flags, &out);
        check_made(FUZZ_MADE(status, out), axes_of(a) + 1);
    }
}

int degree_total(const fuzz::Spline &s) {
    int total = 0;
    for (const int32_t p : s.degrees) {
        total += p;
    }
    return total;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Input in(data, size);
    const int32_t dim = 2 + in.below(2);
    const fuzz::Spline s = any_part(in, 1 + in.below(2), dim);
    const fuzz::Handle a(create(in, s));
    if (!a) {
        return 0;
    }
    one_spline(in, a.get(), s.dim);
    const fuzz::Spline t = any_part(in, in.rarely() ? 1 + in.below(2) : s.axes(), dim);
    const fuzz::Handle b(create(in, t));
    if (b) {
        two_splines(in, a.get(), b.get(), degree_total(s) + degree_total(t) <= 16);
    }
    return 0;
}
