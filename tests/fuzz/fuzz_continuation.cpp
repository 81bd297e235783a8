// Extension, unclamping, periodic forms and projections: domains are what was asked for, forms are what they
// are called.
#include "fuzz/harness.h"

using fuzz::Input;

namespace {

int32_t any_axis(Input &in, const fuzz::Spline &s) {
    return in.rarely() ? in.bad_int() : in.below(s.axes());
}

void extend(Input &in, const nurbs *g, const fuzz::Spline &s) {
    const int32_t axis = any_axis(in, s), end = in.rarely() ? in.bad_int() : in.below(2);
    const double amount = in.rarely() ? in.anything() : in.unit() * std::ldexp(1.0, in.below(8) - 4);
    nurbs *out = fuzz::poison();
    const nurbs_status status =
        nurbs_extend(g, axis, end, amount, in.rarely() ? in.bad_int() : in.below(5), &out);
    const fuzz::Handle h(FUZZ_MADE(status, out));
    double before[2], after[2];
    if (h) {
        FUZZ_REQUIRE(nurbs_domain(g, axis, before) == NURBS_OK &&
                     nurbs_domain(h.get(), axis, after) == NURBS_OK);
        FUZZ_REQUIRE(end == NURBS_END ? after[0] == before[0] && after[1] == before[1] + amount
                                      : after[1] == before[1] && after[0] == before[0] - amount);
    }
}

void unclamp(Input &in, const nurbs *g, const fuzz::Spline &s) {
    const int32_t axis = any_axis(in, s);
    const auto choice = static_cast<uint32_t>(in.below(10));
    const uint32_t flags = choice % 5, homogeneous = choice < 5 ? 0 : NURBS_HOMOGENEOUS;
    nurbs *out = fuzz::poison();
    const nurbs_status status = nurbs_unclamp(g, axis, flags | homogeneous, &out);
    const fuzz::Handle h(FUZZ_MADE(status, out));
    if (h) {
        int32_t form = 0, degree = 0, rational = 0, records = 0;
        FUZZ_REQUIRE(nurbs_is_rational(h.get(), &rational) == NURBS_OK);
        FUZZ_REQUIRE(nurbs_is_homogeneous(h.get(), &records) == NURBS_OK);
        FUZZ_REQUIRE(homogeneous == 0 || records == rational);
        FUZZ_REQUIRE(nurbs_knot_form(h.get(), axis, &form) == NURBS_OK);
        FUZZ_REQUIRE(nurbs_degree(h.get(), axis, &degree) == NURBS_OK);
        FUZZ_REQUIRE(degree == 0 || (form & NURBS_FORM_PERIODIC) != 0 ||
                     (static_cast<uint32_t>(form) & flags) == 0);
    }
}

void periodic(Input &in, const nurbs *g, const fuzz::Spline &s) {
    const int32_t axis = any_axis(in, s);
    double deviation = -7;
    int32_t order = -7, found = -7;
    nurbs *out = fuzz::poison();
    const double tolerance = in.rarely() ? in.anything() : in.coin() ? HUGE_VAL : in.unit();
    const nurbs_status status = nurbs_make_periodic(g, axis, tolerance, &deviation, &order, &out);
    const fuzz::Handle h(FUZZ_MADE(status, out));
    FUZZ_REQUIRE(h ? deviation <= tolerance && order >= -1 : deviation == -7 && order == -7);
    if (FUZZ_OK(nurbs_detect_periodic(h ? h.get() : g, axis, &found))) {
        FUZZ_REQUIRE(h ? found == 1 : found == 0 || found == 1);
    }
}

std::vector<double> any_vector(Input &in, int32_t dim) {
    std::vector<double> x;
    for (int32_t c = 0; c < dim; ++c) {
        x.push_back(in.rarely() ? in.anything() : in.number());
    }
    return x;
}

void project(Input &in, const nurbs *g, const fuzz::Spline &s) {
    const auto point = any_vector(in, s.dim), normal = any_vector(in, s.dim), other = any_vector(in, s.dim);
    nurbs *a = fuzz::poison(), *b = fuzz::poison(), *c = fuzz::poison();
    const nurbs_status mirrored = nurbs_mirror(g, point.data(), normal.data(), &a);
    const nurbs_status flat =
        nurbs_project_to_plane(g, point.data(), normal.data(), in.coin() ? other.data() : nullptr, &b);
    const nurbs_status seen = nurbs_project_from(g, other.data(), point.data(), normal.data(), &c);
    const fuzz::Handle x(FUZZ_MADE(mirrored, a)), y(FUZZ_MADE(flat, b)), z(FUZZ_MADE(seen, c));
}

void segments(Input &in) {
    const int32_t dim = 1 + in.below(3);
    const auto n = static_cast<int64_t>(in.below(6));
    const std::vector<double> values = any_vector(in, static_cast<int32_t>(n) * dim);
    std::vector<double> params;
    for (int64_t i = 0; i < n; ++i) {
        params.push_back(in.rarely() ? in.anything() : static_cast<double>(i) + in.unit());
    }
    nurbs *out = fuzz::poison();
    const nurbs_status status =
        nurbs_create_hermite(n, params.data(), dim, values.data(), 0, 0, values.data(), 0, 0, &out);
    const fuzz::Handle h(FUZZ_MADE(status, out));
    const int32_t degree = in.rarely() ? in.bad_int() : in.below(24);
    std::vector<double> matrix(24 * 24);
    if (FUZZ_OK(nurbs_basis_matrix(in.below(5), in.below(5), degree,
                                   (int64_t{degree} + 1) * (int64_t{degree} + 1), matrix.data()))) {
        FUZZ_REQUIRE(std::isfinite(matrix[0]));
    }
}

// Pieces out, and in again: the same breaks, and the same numbers of points as the coefficients have.
void power(Input &in, const nurbs *g, const fuzz::Spline &s) {
    int64_t pieces[3] = {-7, -7, -7}, count = -7, total = 0;
    const bool ok = FUZZ_OK(nurbs_to_power(g, 0, nullptr, nullptr, pieces, &count));
    FUZZ_REQUIRE(ok && count > 0);
    if (count > 4000) {
        return;
    }
    for (int k = 0; k < s.axes(); ++k) {
        total += pieces[k] + 1;
    }
    std::vector<double> coefficients(static_cast<size_t>(count)), breaks(static_cast<size_t>(total));
    if (!FUZZ_OK(nurbs_to_power(g, count, coefficients.data(), breaks.data(), nullptr, nullptr))) {
        return;
    }
    int32_t rational = 0;
    FUZZ_REQUIRE(nurbs_is_rational(g, &rational) == NURBS_OK);
    if (in.rarely()) {
        breaks[static_cast<size_t>(in.below(static_cast<int>(std::min<int64_t>(total, 255))))] =
            in.anything();
    }
    nurbs *out = fuzz::poison();
    const nurbs_status status =
        nurbs_create_power(s.axes32(), s.degrees.data(), pieces, breaks.data(), total, s.dim,
                           coefficients.data(), 0, 0, rational != 0 ? NURBS_HOMOGENEOUS : 0, &out);
    const fuzz::Handle h(FUZZ_MADE(status, out));
}

void hermite(const nurbs *g, const fuzz::Spline &s) {
    int64_t n = -7;
    if (!FUZZ_OK(nurbs_to_hermite(g, 0, nullptr, nullptr, nullptr, &n))) {
        FUZZ_REQUIRE(n == -7);
        return;
    }
    std::vector<double> params(static_cast<size_t>(n)), points(params.size() * static_cast<size_t>(s.dim));
    std::vector<double> tangents(points.size());
    if (FUZZ_OK(nurbs_to_hermite(g, n, params.data(), points.data(), tangents.data(), nullptr))) {
        nurbs *out = fuzz::poison();
        const nurbs_status status =
            nurbs_create_hermite(n, params.data(), s.dim, points.data(), 0, 0, tangents.data(), 0, 0, &out);
        const fuzz::Handle h(FUZZ_MADE(status, out));
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Input in(data, size);
    segments(in);
    const fuzz::Spline s = fuzz::any_spline(in);
    const fuzz::Handle g(fuzz::create(s));
    if (g && s.total <= 400) {
        extend(in, g.get(), s);
        unclamp(in, g.get(), s);
        periodic(in, g.get(), s);
        project(in, g.get(), s);
        power(in, g.get(), s);
        hermite(g.get(), s);
    }
    return 0;
}
