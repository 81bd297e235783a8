// Degree, form and transformations: results are splines that nurbs_create() accepts, of the shape they should
// have.
#include "fuzz/harness.h"

using fuzz::Input;

namespace {

int32_t form(const nurbs *g, int32_t axis) {
    int32_t result = -1;
    FUZZ_REQUIRE(nurbs_knot_form(g, axis, &result) == NURBS_OK);
    return result;
}

std::vector<double> eval(const nurbs *g, const fuzz::Spline &s, const std::vector<double> &params,
                         uint32_t flags) {
    std::vector<double> points(params.size() / s.degrees.size() * static_cast<size_t>(s.dim));
    const auto n = static_cast<int64_t>(params.size() / s.degrees.size());
    FUZZ_REQUIRE(nurbs_eval(g, n, params.data(), 0, 0, points.data(), 0, 0, flags) == NURBS_OK);
    return points;
}

std::vector<double> stored(const nurbs *g) {
    int64_t count = 0;
    int32_t dim = 0;
    FUZZ_REQUIRE(nurbs_point_count(g, &count) == NURBS_OK && nurbs_dimension(g, &dim) == NURBS_OK);
    std::vector<double> points(static_cast<size_t>(count * (dim + 1)));
    FUZZ_REQUIRE(nurbs_homogeneous_points(g, count, points.data(), 0, 0) == NURBS_OK);
    return points;
}

// Each step is within 2 eps hull in homogeneous space, each evaluation within c eps hull; a ratio of weights
// carries the homogeneous error to the Cartesian point.
void elevate(Input &in, const nurbs *g, const fuzz::Spline &s) {
    const int32_t axis = in.rarely() ? in.bad_int() : in.below(s.axes());
    const int32_t times = in.rarely() ? in.bad_int() : in.below(5);
    nurbs *out = fuzz::poison();
    const nurbs_status status = nurbs_elevate(g, axis, times, &out);
    const fuzz::Handle h(FUZZ_MADE(status, out));
    const bool sane = axis >= 0 && axis < s.axes() && times >= 0;
    FUZZ_REQUIRE(sane || !h);
    FUZZ_REQUIRE(h || !sane || status == NURBS_ERROR_DEGREE || status == NURBS_ERROR_PERIODIC_KNOTS);
    if (!h) {
        return;
    }
    FUZZ_REQUIRE((form(g, axis) & NURBS_FORM_PERIODIC) == (form(h.get(), axis) & NURBS_FORM_PERIODIC));
    std::vector<int32_t> degrees = s.degrees;
    degrees[static_cast<size_t>(axis)] += times;
    const double ratio = s.weight_ratio();
    const double bound =
        (4 * times + fuzz::accuracy(s.degrees) + fuzz::accuracy(degrees) + 8) * fuzz::eps * ratio * s.size();
    const std::vector<double> params = fuzz::any_params(in, g, s.axes(), 8, true);
    const std::vector<double> before = eval(g, s, params, 0);
    const std::vector<double> after = eval(h.get(), s, params, 0);
    for (size_t c = 0; ratio > 0 && c < before.size(); ++c) {
        FUZZ_REQUIRE(std::fabs(after[c] - before[c]) <= bound);
    }
}

void reverse(Input &in, const nurbs *g, const fuzz::Spline &s) {
    const int32_t axis = in.rarely() ? in.bad_int() : in.below(s.axes());
    const uint32_t flags = in.rarely() ? 1u << in.below(32) : in.coin() ? NURBS_KEEP_DOMAIN : 0;
    nurbs *out = fuzz::poison();
    const nurbs_status status = nurbs_reverse(g, axis, flags, &out);
    const fuzz::Handle h(FUZZ_MADE(status, out));
    if (!h || flags != 0) {
        return;
    }
    out = fuzz::poison();
    const nurbs_status again = nurbs_reverse(h.get(), axis, 0, &out);
    const fuzz::Handle back(FUZZ_MADE(again, out));
    FUZZ_REQUIRE(back);
    const std::vector<double> before = stored(g), after = stored(back.get());
    FUZZ_REQUIRE(fuzz::same_bits(before.data(), after.data(), before.size()));
}

void reparametrize(Input &in, const nurbs *g, const fuzz::Spline &s) {
    const int32_t axis = in.rarely() ? in.bad_int() : in.below(s.axes());
    const double lower = in.rarely() ? in.anything() : in.number();
    const double upper = in.rarely() ? in.anything() : lower + in.unit();
    nurbs *out = fuzz::poison();
    const nurbs_status status = nurbs_reparametrize(g, axis, lower, upper, &out);
    const fuzz::Handle h(FUZZ_MADE(status, out));
    if (h) {
        double domain[2] = {0, 0};
        FUZZ_REQUIRE(nurbs_domain(h.get(), axis, domain) == NURBS_OK);
        FUZZ_REQUIRE(domain[0] == lower && domain[1] == upper);
        const std::vector<double> before = stored(g), after = stored(h.get());
        FUZZ_REQUIRE(fuzz::same_bits(before.data(), after.data(), before.size()));
    }
}

void transpose(Input &in, const nurbs *g, const fuzz::Spline &s) {
    std::vector<int32_t> permutation;
    for (int k = 0; k < s.axes(); ++k) {
        permutation.push_back(in.rarely() ? in.bad_int() : in.below(s.axes()));
    }
    nurbs *out = fuzz::poison();
    const nurbs_status status = nurbs_transpose(g, permutation.data(), &out);
    const fuzz::Handle h(FUZZ_MADE(status, out));
    FUZZ_REQUIRE(h || status == NURBS_ERROR_AXIS);
}

void homogeneous(const nurbs *g, const fuzz::Spline &s) {
    nurbs *out = fuzz::poison();
    nurbs_status status = nurbs_make_rational(g, &out);
    const fuzz::Handle rational(FUZZ_MADE(status, out));
    FUZZ_REQUIRE(rational);
    out = fuzz::poison();
    status = nurbs_to_homogeneous(rational.get(), &out);
    const fuzz::Handle flat(FUZZ_MADE(status, out));
    FUZZ_REQUIRE(flat);
    out = fuzz::poison();
    status = nurbs_from_homogeneous(flat.get(), &out);
    const fuzz::Handle back(FUZZ_MADE(status, out));
    FUZZ_REQUIRE(back);
    const std::vector<double> before = stored(g), after = stored(back.get());
    FUZZ_REQUIRE(fuzz::same_bits(before.data(), after.data(), before.size()));
    out = fuzz::poison();
    status = nurbs_from_homogeneous(g, &out);
    const fuzz::Handle taken(FUZZ_MADE(status, out));
    FUZZ_REQUIRE(!taken || s.weights.empty());
}

void transform(Input &in, const nurbs *g, const fuzz::Spline &s) {
    const int32_t out_dim = 1 + in.below(4);
    std::vector<double> matrix(static_cast<size_t>((out_dim + 1) * (s.dim + 1)));
    std::generate(matrix.begin(), matrix.end(), [&] { return in.rarely() ? in.anything() : in.number(); });
    const double *translation = in.coin() ? matrix.data() : nullptr;
    nurbs *out = fuzz::poison();
    nurbs_status status =
        nurbs_transform(g, in.rarely() ? in.below(2) - 1 : out_dim, matrix.data(), translation, &out);
    const fuzz::Handle affine(FUZZ_MADE(status, out));
    out = fuzz::poison();
    status = nurbs_transform_projective(g, out_dim, matrix.data(), &out);
    const fuzz::Handle projective(FUZZ_MADE(status, out));
    if (projective) {
        const std::vector<double> params = fuzz::any_params(in, g, s.axes(), 2, true);
        std::vector<double> points(static_cast<size_t>(2 * out_dim));
        FUZZ_REQUIRE(nurbs_eval(projective.get(), 2, params.data(), 0, 0, points.data(), 0, 0, 0) ==
                     NURBS_OK);
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Input in(data, size);
    const fuzz::Spline s = fuzz::any_spline(in);
    const fuzz::Handle g(fuzz::create(s));
    if (g) {
        const std::vector<double> before = stored(g.get());
        elevate(in, g.get(), s);
        reverse(in, g.get(), s);
        reparametrize(in, g.get(), s);
        transpose(in, g.get(), s);
        homogeneous(g.get(), s);
        transform(in, g.get(), s);
        const std::vector<double> after = stored(g.get());
        FUZZ_REQUIRE(fuzz::same_bits(before.data(), after.data(), before.size()));
    }
    return 0;
}
