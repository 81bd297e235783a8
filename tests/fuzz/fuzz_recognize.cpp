// Conics by their equation and weights, and recognition: what is said of a shape holds at points of it.
#include "fuzz/harness.h"

using fuzz::Input;

namespace {

bool finite(const double *x, int n) {
    return std::all_of(x, x + n, [](double value) { return std::isfinite(value); });
}

void axes(Input &in) {
    std::vector<double> q(6);
    for (double &x : q) {
        x = in.rarely() ? in.anything() : in.number();
    }
    int32_t type = 0;
    double origin[2], x[2], sizes[2];
    if (FUZZ_OK(nurbs_conic_axes(q.data(), &type, origin, x, sizes))) {
        FUZZ_REQUIRE(type >= NURBS_CONIC_ELLIPSE && type <= NURBS_CONIC_HYPERBOLA);
        FUZZ_REQUIRE(finite(origin, 2) && finite(sizes, 2) &&
                     std::fabs(std::hypot(x[0], x[1]) - 1) <= 4 * fuzz::eps);
        FUZZ_REQUIRE(type != NURBS_CONIC_ELLIPSE || sizes[0] >= sizes[1] * (1 - 8 * fuzz::eps));
    }
}

void factor(const nurbs *g) {
    double value = 0;
    int32_t type = 0;
    if (FUZZ_OK(nurbs_curve_shape_factor(g, &value, &type))) {
        FUZZ_REQUIRE(type >= NURBS_CONIC_ELLIPSE && type <= NURBS_CONIC_LINE && value >= 0);
    }
}

// A quarter or half turn of a conic or segment about the axis z, or the profile itself, moved a little or
// not.
fuzz::Spline any_shape(Input &in) {
    fuzz::Spline s;
    const bool surface = in.coin();
    const int profile = 1 + in.below(2);
    std::vector<double> points(static_cast<size_t>(2 * (profile + 1)));
    std::generate(points.begin(), points.end(), [&] { return 2 * in.unit() - (in.coin() ? 1 : 0); });
    const double middle = in.coin() ? std::sqrt(0.5) : 2 * in.unit() + 0.01;
    const double turn[] = {1, 0, 1, 1, 0, 1}, turns[] = {1, std::sqrt(0.5), 1};
    const double noise = in.rarely() ? 1e-3 : 0, scale = in.number() + 0.5;
    s.dim = 3;
    for (int i = 0; i < (surface ? 3 : 1); ++i) {
        for (int j = 0; j <= profile; ++j) {
            const double r = points[static_cast<size_t>(2 * j)], z = points[static_cast<size_t>(2 * j + 1)];
            for (const double x : {turn[2 * i] * r, turn[2 * i + 1] * r, z}) {
                s.points.push_back(scale * (x + noise * in.unit()));
            }
            s.weights.push_back(turns[i] * (j == 1 && profile == 2 ? middle : 1));
        }
    }
    for (const int degree : surface ? std::vector<int>{2, profile} : std::vector<int>{profile}) {
        s.degrees.push_back(degree);
        s.counts.push_back(degree + 1);
        s.knots.insert(s.knots.end(), static_cast<size_t>(degree) + 1, 0.0);
        s.knots.insert(s.knots.end(), static_cast<size_t>(degree) + 1, 1.0);
        s.total *= degree + 1;
    }
    return s;
}

double along(const double *p, const double *axis) {
    return p[0] * axis[0] + p[1] * axis[1] + p[2] * axis[2];
}

// The distance of a point from a shape other than an ellipse, parabola or hyperbola.
double distance(int32_t shape, const double *placement, const double *sizes, const double *point) {
    const double p[] = {point[0] - placement[0], point[1] - placement[1], point[2] - placement[2]};
    const double far = std::hypot(p[0], p[1], p[2]), z = along(p, placement + 3);
    const double s = std::hypot(p[0] - z * placement[3], p[1] - z * placement[4], p[2] - z * placement[5]);
    switch (shape) {
    case NURBS_SHAPE_POINT:
        return far;
    case NURBS_SHAPE_LINE:
        return s;
    case NURBS_SHAPE_CIRCLE:
        return std::hypot(s - sizes[0], z);
    case NURBS_SHAPE_PLANE:
        return std::fabs(z);
    case NURBS_SHAPE_SPHERE:
        return std::fabs(far - sizes[0]);
    case NURBS_SHAPE_CYLINDER:
        return std::fabs(s - sizes[0]);
    case NURBS_SHAPE_CONE:
        return std::fabs(s * std::cos(sizes[0]) - z * std::sin(sizes[0]));
    case NURBS_SHAPE_TORUS: {
        const double d = std::hypot(s - sizes[0], z), a = sizes[0], b = sizes[1];
        const bool inner = b > a && (a - s) * b > a * d; // the nearest point is on the part beyond the axis
        return inner ? std::hypot(s, std::fabs(z) - std::sqrt((b - a) * (b + a))) : std::fabs(d - b);
    }
    default:
        return 0;
    }
}

void check_points(const nurbs *g, const fuzz::Spline &s, int32_t shape, const double *placement,
                  const double *sizes, double deviation) {
    const double reach =
        s.size() + std::fabs(placement[0]) + std::fabs(placement[1]) + std::fabs(placement[2]) + sizes[0];
    for (int i = 0; i <= 8; ++i) {
        double param[2] = {0, 0}, point[3] = {0, 0, 0};
        for (int32_t k = 0; k < s.axes32(); ++k) {
            double domain[2];
            FUZZ_REQUIRE(nurbs_domain(g, k, domain) == NURBS_OK);
            const double t = (k == 0 ? i : 3 * i % 9) / 8.0;
            param[k] = std::min(domain[1], domain[0] + t * (domain[1] - domain[0]));
        }
        FUZZ_REQUIRE(nurbs_eval(g, 1, param, 0, 0, point, 0, 0, 0) == NURBS_OK);
        FUZZ_REQUIRE(distance(shape, placement, sizes, point) <= deviation + 4096 * fuzz::eps * reach);
    }
}

void recognize(Input &in, const nurbs *g, const fuzz::Spline &s) {
    const double tolerance =
        in.rarely() ? in.anything() : s.size() * std::ldexp(1 + in.unit(), -in.below(48));
    int32_t shape = -1;
    double placement[9], sizes[3], deviation = -1;
    if (!FUZZ_OK(nurbs_recognize(g, tolerance, &shape, placement, sizes, &deviation))) {
        return;
    }
    const bool curve = s.axes() == 1;
    const bool either = shape <= NURBS_SHAPE_LINE; // none, a point, a line
    FUZZ_REQUIRE(either || (shape < NURBS_SHAPE_PLANE) == curve);
    FUZZ_REQUIRE(shape >= NURBS_SHAPE_NONE && shape <= NURBS_SHAPE_TORUS);
    FUZZ_REQUIRE(finite(placement, 9) && finite(sizes, 3) && deviation >= 0 && deviation <= tolerance);
    FUZZ_REQUIRE(sizes[0] >= 0 && sizes[1] >= 0 && (shape != NURBS_SHAPE_NONE || deviation == 0));
    const double ratio = s.weight_ratio();
    if (ratio > 0 && ratio < 16) {
        check_points(g, s, shape, placement, sizes, deviation);
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Input in(data, size);
    axes(in);
    const fuzz::Spline s = in.coin() ? any_shape(in) : fuzz::any_spline(in);
    const fuzz::Handle g(fuzz::create(s));
    int64_t degrees = 1;
    for (const int32_t p : s.degrees) {
        degrees *= p + 1;
    }
    if (g && degrees <= 100) { // the time grows with the square of this
        factor(g.get());
        recognize(in, g.get(), s);
    }
    return 0;
}
