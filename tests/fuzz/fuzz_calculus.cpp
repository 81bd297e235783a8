// Calculus and weights: results are splines over the same domain, of the degrees they should have.
#include "fuzz/harness.h"

using fuzz::Input;

namespace {

int32_t any_axis(Input &in, const fuzz::Spline &s) {
    return in.rarely() ? in.bad_int() : in.below(s.axes());
}

int32_t degree_of(const nurbs *g, int32_t axis) {
    int32_t degree = -1;
    FUZZ_REQUIRE(nurbs_degree(g, axis, &degree) == NURBS_OK);
    return degree;
}

void check_domains(const nurbs *g, const nurbs *h, const fuzz::Spline &s) {
    for (int32_t k = 0; k < s.axes32(); ++k) {
        double before[2], after[2];
        FUZZ_REQUIRE(nurbs_domain(g, k, before) == NURBS_OK && nurbs_domain(h, k, after) == NURBS_OK);
        FUZZ_REQUIRE(fuzz::same_bits(before, after, 2));
    }
}

void blossom(Input &in, const nurbs *g, const fuzz::Spline &s) {
    int64_t count = 0;
    for (const int32_t p : s.degrees) {
        count += p;
    }
    const std::vector<double> params = fuzz::any_params(in, g, s.axes(), 1, in.coin());
    std::vector<double> args(static_cast<size_t>(count));
    std::generate(args.begin(), args.end(), [&] { return in.rarely() ? in.anything() : in.number(); });
    std::vector<double> values(static_cast<size_t>(s.dim) + (s.weights.empty() ? 0 : 1), -7);
    const bool done = FUZZ_OK(nurbs_blossom(g, params.data(), in.rarely() ? in.bad_size() : count,
                                            args.data(), values.data(), fuzz::any_flags(in, s.axes())));
    FUZZ_REQUIRE(done || values[0] == -7);
}

void differentiate(Input &in, const nurbs *g, const fuzz::Spline &s) {
    const int32_t axis = any_axis(in, s), order = in.rarely() ? in.bad_int() : in.below(4);
    nurbs *out = fuzz::poison();
    nurbs_status status = nurbs_derivative(g, axis, order, &out);
    const fuzz::Handle h(FUZZ_MADE(status, out));
    if (h) {
        check_domains(g, h.get(), s);
        const int32_t p = degree_of(g, axis);
        FUZZ_REQUIRE(degree_of(h.get(), axis) ==
                     (s.weights.empty() ? std::max(p - order, 0) : (order + 1) * p));
    }
    out = fuzz::poison();
    status = nurbs_antiderivative(g, axis, &out);
    const fuzz::Handle integral(FUZZ_MADE(status, out));
    if (integral) {
        check_domains(g, integral.get(), s);
        out = fuzz::poison();
        status = nurbs_derivative(integral.get(), axis, 1, &out);
        const fuzz::Handle back(FUZZ_MADE(status, out));
        FUZZ_REQUIRE(back || status == NURBS_ERROR_NOT_REPRESENTABLE);
    }
}

// A spline with its own derivative or integral, which have the same domain and other knots; the first with a
// product of itself.
void combine(Input &in, const nurbs *g, const fuzz::Spline &s) {
    const int32_t axis = in.below(s.axes());
    nurbs *out = fuzz::poison();
    nurbs_status status =
        in.coin() ? nurbs_derivative(g, axis, 1, &out) : nurbs_antiderivative(g, axis, &out);
    const fuzz::Handle other(FUZZ_MADE(status, out));
    const nurbs *b = other && in.coin() ? other.get() : g;
    static constexpr uint32_t kinds[] = {0, NURBS_PRODUCT_DOT, NURBS_PRODUCT_CROSS, 1};
    out = fuzz::poison();
    status = nurbs_product(g, b, kinds[in.below(4)], &out);
    const fuzz::Handle product(FUZZ_MADE(status, out));
    if (product) {
        check_domains(g, product.get(), s);
        for (int32_t k = 0; k < s.axes32(); ++k) {
            FUZZ_REQUIRE(degree_of(product.get(), k) == degree_of(g, k) + degree_of(b, k));
        }
    }
    out = fuzz::poison();
    status = nurbs_sum(g, in.rarely() ? in.anything() : in.number(), b, in.number(), &out);
    const fuzz::Handle sum(FUZZ_MADE(status, out));
    if (sum) {
        check_domains(g, sum.get(), s);
    }
}

void reweigh(Input &in, const nurbs *g, const fuzz::Spline &s) {
    nurbs *out = fuzz::poison();
    nurbs_status status = nurbs_normalize_weights(g, &out);
    const fuzz::Handle normal(FUZZ_MADE(status, out));
    FUZZ_REQUIRE(normal);
    const int32_t axis = any_axis(in, s);
    out = fuzz::poison();
    const double ratio = in.rarely() ? in.anything() : std::ldexp(0.5 + in.unit(), in.below(9) - 4);
    status = nurbs_reparametrize_moebius(g, axis, ratio, &out);
    const fuzz::Handle moved(FUZZ_MADE(status, out));
    if (moved) {
        check_domains(g, moved.get(), s);
    }
    out = fuzz::poison();
    status = nurbs_equalize_end_weights(g, axis, &out);
    const fuzz::Handle equal(FUZZ_MADE(status, out));
    if (equal) {
        check_domains(g, equal.get(), s);
    }
}

// High degrees on several axes make results of millions of points.
bool small(const fuzz::Spline &s) {
    int64_t size = s.total;
    for (const int32_t p : s.degrees) {
        size *= p + 1;
    }
    return s.total <= 400 && size <= 2000;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Input in(data, size);
    const fuzz::Spline s = fuzz::any_spline(in);
    const fuzz::Handle g(fuzz::create(s));
    if (g && small(s)) {
        blossom(in, g.get(), s);
        differentiate(in, g.get(), s);
        combine(in, g.get(), s);
        reweigh(in, g.get(), s);
    }
    return 0;
}
