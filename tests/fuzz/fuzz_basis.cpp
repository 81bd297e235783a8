// Span search and bases: sums are 1, derivatives add up to 0, spans hold their parameters, whatever the
// knots.
#include "fuzz/harness.h"

using fuzz::Input;

namespace {

// Derivatives of order k sum to 0, to within a few roundings of each term for each degree and order.
void check_sums(const double *values, int32_t degree, int32_t order, bool inside, int line) {
    for (int32_t k = 0; k <= order; ++k) {
        double sum = 0, size = 0;
        for (int32_t j = 0; j <= degree; ++j) {
            const double value = values[k * (degree + 1) + j];
            sum += value;
            size += std::fabs(value);
            if (!std::isfinite(value) || (k == 0 && inside && value < 0)) {
                fuzz::violated("a basis function is negative or not finite", line);
            }
        }
        const double bound = 8 * (degree + k + 1) * fuzz::eps * std::max(size, 1.0);
        if (!(std::fabs(sum - (k == 0 ? 1 : 0)) <= bound)) {
            fuzz::violated("the basis functions do not add up", line);
        }
    }
}

void bernstein(Input &in) {
    const int32_t degree = in.rarely() ? in.bad_int() : in.below(32);
    const int32_t order = in.rarely() ? in.bad_int() : in.below(6);
    const int64_t n = in.rarely() ? in.bad_size() : in.below(5);
    const bool sane = degree >= 0 && degree < 32 && order >= 0 && order < 6 && n >= 0 && n < 5;
    std::vector<double> params(sane ? static_cast<size_t>(n) : 1);
    const int64_t width = sane ? int64_t{degree + 1} * (order + 1) : 1;
    const bool inside = !in.rarely();
    for (double &t : params) {
        t = inside ? in.unit() : in.anything();
    }
    std::vector<double> values(params.size() * static_cast<size_t>(width), -7);
    const bool ok = FUZZ_OK(nurbs_bernstein(degree, order, n, params.data(), 0, values.data(), 0, 0));
    FUZZ_REQUIRE(!ok || sane);
    FUZZ_REQUIRE(ok || !sane || !inside);
    for (size_t i = 0; ok && inside && i < params.size(); ++i) {
        check_sums(values.data() + i * static_cast<size_t>(width), degree, order, true, __LINE__);
    }
}

// A span is never empty, lies in the domain, and holds the parameter on the side asked for.
void check_span(const fuzz::Axis &axis, double t, int64_t span, bool left) {
    const auto s = static_cast<size_t>(span);
    FUZZ_REQUIRE(span >= axis.degree && span < axis.count);
    const double a = axis.knots[s], b = axis.knots[s + 1];
    const double lower = axis.knots[static_cast<size_t>(axis.degree)];
    const double upper = axis.knots[static_cast<size_t>(axis.count)];
    FUZZ_REQUIRE(a < b);
    FUZZ_REQUIRE(left ? (a < t || t == lower) && t <= b : a <= t && (t < b || t == upper));
}

std::vector<double> params_of(Input &in, const fuzz::Axis &axis, int64_t n, bool inside) {
    std::vector<double> params(static_cast<size_t>(n));
    const double lower = axis.knots[static_cast<size_t>(axis.degree)];
    const double upper = axis.knots[static_cast<size_t>(axis.count)];
    for (double &t : params) {
        const int kind = in.below(4);
        const int64_t knot = axis.degree + in.below(static_cast<int>(axis.count - axis.degree + 1));
        t = kind == 0 ? axis.knots[static_cast<size_t>(knot)]
                      : std::clamp(lower + in.unit() * (upper - lower), lower, upper);
        t = !inside && kind == 1 ? in.anything() : t;
    }
    return params;
}

// Values add up to 1 whatever the knots; derivatives may overflow beside a tiny span, and are left to the
// exact tests.
void bspline(Input &in) {
    const fuzz::Axis axis = fuzz::any_axis(in, 12);
    const int64_t n = in.below(6);
    const int32_t order = in.below(4);
    const bool inside = in.coin();
    const bool left = in.coin();
    const uint32_t flags = inside ? (left ? NURBS_LEFT : 0) : fuzz::any_flags(in, 1);
    const auto length = static_cast<int64_t>(axis.knots.size());
    const std::vector<double> params = params_of(in, axis, n, inside);
    std::vector<int64_t> spans(params.size(), -7), again(spans);
    std::vector<double> values(params.size() * static_cast<size_t>((order + 1) * (axis.degree + 1)), -7);
    const bool found = FUZZ_OK(nurbs_find_spans(axis.degree, axis.count, axis.knots.data(), length, n,
                                                params.data(), 0, spans.data(), flags));
    const bool ok = FUZZ_OK(nurbs_basis(axis.degree, axis.count, axis.knots.data(), length, order, n,
                                        params.data(), 0, again.data(), values.data(), 0, 0, flags));
    FUZZ_REQUIRE(found == ok && spans == again);
    for (size_t i = 0; ok && inside && i < params.size(); ++i) {
        check_span(axis, params[i], spans[i], left);
        check_sums(values.data() + i * static_cast<size_t>((order + 1) * (axis.degree + 1)), axis.degree, 0,
                   true, __LINE__);
    }
    FUZZ_REQUIRE(ok || std::all_of(values.begin(), values.end(), [](double v) { return v == -7; }));
}

// Knots that break a rule are refused alike by both functions.
void broken_knots(Input &in) {
    fuzz::Axis axis = fuzz::any_axis(in, 6);
    axis.knots[static_cast<size_t>(in.bits() % axis.knots.size())] = in.anything();
    const auto length = static_cast<int64_t>(axis.knots.size());
    const double param = in.anything();
    int64_t span = -7;
    std::vector<double> values(static_cast<size_t>(axis.degree + 1));
    const nurbs_status one =
        nurbs_find_spans(axis.degree, axis.count, axis.knots.data(), length, 1, &param, 0, &span, NURBS_NAN);
    const nurbs_status two = nurbs_basis(axis.degree, axis.count, axis.knots.data(), length, 0, 1, &param, 0,
                                         nullptr, values.data(), 0, 0, NURBS_NAN);
    FUZZ_REQUIRE(one == two);
    FUZZ_REQUIRE(FUZZ_OK(one) || span == -7);
}

// R_i >= 0 sum to 1: one rounding for each factor, term and quotient.
void rational(Input &in) {
    const fuzz::Spline s = fuzz::any_spline(in);
    const fuzz::Handle g(fuzz::create(s));
    if (!g) {
        return;
    }
    int64_t width = 1;
    int32_t degrees = 0;
    for (const int32_t p : s.degrees) {
        width *= p + 1;
        degrees += p;
    }
    const int64_t n = in.below(4);
    const bool inside = in.coin();
    const std::vector<double> params = fuzz::any_params(in, g.get(), s.axes(), n, inside);
    std::vector<double> values(static_cast<size_t>(n * width), -7);
    std::vector<int64_t> spans(params.size(), -7);
    const uint32_t flags = inside ? 0 : fuzz::any_flags(in, s.axes());
    const bool ok = FUZZ_OK(
        nurbs_rational_basis(g.get(), n, params.data(), 0, 0, spans.data(), values.data(), 0, 0, flags));
    FUZZ_REQUIRE(ok || !inside);
    for (int64_t i = 0; ok && inside && i < n; ++i) {
        double sum = 0;
        for (int64_t j = 0; j < width; ++j) {
            const double r = values[static_cast<size_t>(i * width + j)];
            FUZZ_REQUIRE(r >= 0);
            sum += r;
        }
        FUZZ_REQUIRE(std::fabs(sum - 1) <= (8 * degrees + 2 * static_cast<double>(width) + 8) * fuzz::eps);
    }
}

// Vectors are numbers, or none of a parameter is.
void gradients(Input &in) {
    const fuzz::Spline s = fuzz::any_spline(in);
    const fuzz::Handle g(fuzz::create(s));
    if (!g) {
        return;
    }
    int64_t width = s.dim;
    for (const int32_t p : s.degrees) {
        width *= p + 1;
    }
    const int64_t n = in.below(3);
    const bool inside = in.coin();
    const std::vector<double> params = fuzz::any_params(in, g.get(), s.axes(), n, inside);
    std::vector<double> values(static_cast<size_t>(n * width), -7);
    std::vector<int64_t> spans(params.size(), -7);
    const uint32_t flags = inside ? 0 : fuzz::any_flags(in, s.axes());
    const bool ok = FUZZ_OK(
        nurbs_basis_gradients(g.get(), n, params.data(), 0, 0, spans.data(), values.data(), 0, 0, flags));
    FUZZ_REQUIRE(ok || !inside || s.axes() > s.dim);
    FUZZ_REQUIRE(ok || std::all_of(values.begin(), values.end(), [](double v) { return v == -7; }));
    for (int64_t i = 0; ok && i < n; ++i) {
        const auto first = values.begin() + i * width;
        FUZZ_REQUIRE(!std::isnan(*first) ||
                     std::all_of(first, first + width, [](double v) { return std::isnan(v); }));
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Input in(data, size);
    bernstein(in);
    bspline(in);
    broken_knots(in);
    rational(in);
    gradients(in);
    return 0;
}
