// Lines, arcs, conics and helices from any numbers: a curve that can be evaluated, or a refusal.
#include "fuzz/harness.h"

using fuzz::Input;

namespace {

double any_number(Input &in) {
    return in.rarely() ? in.anything() : in.number();
}

std::vector<double> vector_of(Input &in, int64_t n) {
    std::vector<double> v(static_cast<size_t>(n));
    std::generate(v.begin(), v.end(), [&] { return any_number(in); });
    return v;
}

// A placement, parts of which may be left to the library.
struct Place {
    int32_t dim;
    std::vector<double> origin, axis, x;
    bool has_origin, has_axis, has_x;

    explicit Place(Input &in)
        : dim(in.rarely() ? in.bad_int() : 2 + in.below(2)), origin(vector_of(in, 3)), axis(vector_of(in, 3)),
          x(vector_of(in, 3)), has_origin(in.coin()), has_axis(dim == 2 ? in.rarely() : in.coin()),
          has_x(in.coin()) {}
    [[nodiscard]] const double *o() const { return has_origin ? origin.data() : nullptr; }
    [[nodiscard]] const double *a() const { return has_axis ? axis.data() : nullptr; }
    [[nodiscard]] const double *d() const { return has_x ? x.data() : nullptr; }
};

int32_t any_form(Input &in) {
    return in.rarely() ? in.bad_int() : in.below(3);
}

double length_of(Input &in) {
    const double value = any_number(in);
    return in.rarely() ? value : std::fabs(value);
}

nurbs_status placed(Input &in, nurbs **out) {
    const Place p(in);
    const double r = length_of(in), s = length_of(in), from = any_number(in), to = any_number(in);
    double error = 0;
    switch (in.below(8)) {
    case 0:
        return nurbs_curve_polygon(p.dim, p.o(), p.a(), p.d(), r, in.rarely() ? -1 : in.byte(), out);
    case 1:
        return nurbs_curve_rounded_rectangle(p.dim, p.o(), p.a(), p.d(), r, s, from, out);
    case 2:
        return nurbs_curve_circle(p.dim, p.o(), p.a(), p.d(), r, any_form(in), out);
    case 3:
        return nurbs_curve_arc(p.dim, p.o(), p.a(), p.d(), r, from, to, any_form(in), out);
    case 4:
        return nurbs_curve_ellipse(p.dim, p.o(), p.a(), p.d(), r, s, from, to, any_form(in), out);
    case 5:
        return nurbs_curve_parabola(p.dim, p.o(), p.a(), p.d(), r, from, to, out);
    case 6:
        return nurbs_curve_hyperbola(p.dim, p.o(), p.a(), p.d(), r, s, from, to, out);
    default: { // its points grow with the size in tolerances
        const double size = std::max({1.0, std::fabs(r), std::fabs(from), std::fabs(to)});
        return nurbs_curve_helix(p.dim, p.o(), p.a(), p.d(), r, in.coin() ? 0 : from, p.dim == 2 ? 0 : to,
                                 any_number(in), 0.1 + in.unit() * 8, std::ldexp(size, -in.below(40)), &error,
                                 out);
    }
    }
}

nurbs_status by_points(Input &in, nurbs **out) {
    const int32_t dim = in.rarely() ? in.bad_int() : 1 + in.below(4);
    const std::vector<double> p = vector_of(in, 5 * 4), t = vector_of(in, 2 * 4);
    const double *a = p.data(), *b = a + 4, *c = a + 8, *s = t.data(), *e = s + 4;
    const double number = any_number(in);
    switch (in.below(9)) {
    case 0:
        return nurbs_curve_line(dim, a, b, out);
    case 1:
        return nurbs_curve_polyline(in.rarely() ? in.bad_size() : in.below(5), dim, a, 4, 0,
                                    in.coin() ? s : nullptr, 0, out);
    case 2:
        return nurbs_curve_arc_through(dim, a, b, c, any_form(in), out);
    case 3:
        return nurbs_curve_arc_tangent(dim, a, s, b, any_form(in), out);
    case 4:
        return nurbs_curve_conic_triangle(dim, a, b, c, number, out);
    case 5:
        return nurbs_curve_conic_shoulder(dim, a, s, b, e, in.unit(), out);
    case 6:
        return nurbs_curve_conic_point(dim, a, s, b, e, c, any_form(in), out);
    case 7:
        return nurbs_curve_conic_through(dim, a, 4, 0, any_form(in), out);
    default:
        return nurbs_curve_conic_focus(dim, a, dim == 3 ? s : nullptr, b, length_of(in), number,
                                       any_number(in), any_form(in), out);
    }
}

nurbs_status by_equation(Input &in, nurbs **out) {
    const std::vector<double> q = vector_of(in, 6);
    const double from = any_number(in);
    return nurbs_curve_conic_implicit(q.data(), from, any_number(in), any_form(in), out);
}

// Ends are stored points: finite, and reached by evaluation. The weight of a triangle's tip may be 0.
void check(const nurbs *g) {
    double domain[2];
    int32_t dim = 0;
    int64_t count = 0;
    FUZZ_REQUIRE(nurbs_domain(g, 0, domain) == NURBS_OK && nurbs_dimension(g, &dim) == NURBS_OK &&
                 nurbs_point_count(g, &count) == NURBS_OK);
    std::vector<double> weights(static_cast<size_t>(count)), ends(2 * static_cast<size_t>(dim));
    FUZZ_REQUIRE(nurbs_weights(g, count, weights.data(), 0) == NURBS_OK);
    FUZZ_REQUIRE(weights.front() > 0 && weights.back() > 0);
    FUZZ_REQUIRE(std::all_of(weights.begin(), weights.end(), [](double w) { return w >= 0; }));
    FUZZ_REQUIRE(nurbs_eval(g, 2, domain, 0, 0, ends.data(), 0, 0, 0) == NURBS_OK);
    FUZZ_REQUIRE(std::all_of(ends.begin(), ends.end(), [](double x) { return std::isfinite(x); }));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Input in(data, size);
    nurbs *out = fuzz::poison();
    const int kind = in.below(8);
    const nurbs_status status = kind < 4   ? placed(in, &out)
                                : kind < 7 ? by_points(in, &out)
                                           : by_equation(in, &out);
    const fuzz::Handle g(FUZZ_MADE(status, out));
    if (g) {
        check(g.get());
    }
    return 0;
}
