#include "eval/shape_operator.h"

#include <cmath>
#include <limits>

namespace nrb {

namespace {

// S_u = a e1 and S_v = a b e1 + c e2; the second fundamental form (l, m, n).
struct Forms {
    Vector3 e1;
    Vector3 normal;
    double a;
    double b;
    double c;
    double l;
    double m;
    double n;
};

Forms forms(const SurfaceDerivatives &d) noexcept {
    Forms f;
    const Vector3 product = cross(d.u, d.v);
    const double area = length(product);
    f.a = length(d.u);
    f.e1 = unit(d.u);
    f.normal = unit(product);
    f.b = dot(d.v, f.e1) / f.a;
    f.c = area / f.a;
    f.l = dot(d.uu, f.normal);
    f.m = dot(d.uv, f.normal);
    f.n = dot(d.vv, f.normal);
    return f;
}

} // namespace

// The second form is J^T W J with J = (a, a b; 0, c).
ShapeOperator shape_operator(const SurfaceDerivatives &d) noexcept {
    const Forms f = forms(d);
    ShapeOperator w;
    w.e1 = f.e1;
    w.e2 = cross(f.normal, f.e1);
    w.w11 = f.l / f.a / f.a;
    w.w12 = (f.m - f.b * f.l) / f.a / f.c;
    w.w22 = ((f.n - f.b * f.m) - f.b * (f.m - f.b * f.l)) / f.c / f.c;
    return w;
}

double ShapeOperator::spread() const noexcept {
    return std::hypot(0.5 * (w11 - w22), w12);
}

// The angle phi from e1 has tan 2 phi = 2 w12 / (w11 - w22); the half angle is taken from the larger of its
// cosine and sine, so that nothing cancels.
Vector3 ShapeOperator::direction() const noexcept {
    const double half = 0.5 * (w11 - w22);
    const double d = spread();
    if (!(d > 0)) {
        return e1;
    }
    const double large = std::sqrt(0.5 * (1 + std::fabs(half) / d));
    const double small = std::fabs(w12) / (2 * d * large);
    const double along = half >= 0 ? large : small;
    const double across = std::copysign(half >= 0 ? small : large, along > 0 ? w12 : 1.0);
    return along * e1 + across * e2;
}

bool regular(const SurfaceDerivatives &d, const DerivativeErrors &errors) noexcept {
    return length(cross(d.u, d.v)) > length(d.u) * errors.v + errors.u * (length(d.v) + errors.v);
}

// Each factor of w11, w12 and w22 in turn, with a few eps for the operations themselves.
double spread_error(const SurfaceDerivatives &d, const DerivativeErrors &errors) noexcept {
    constexpr double own = 8 * std::numeric_limits<double>::epsilon();
    const Forms f = forms(d);
    const double b = std::fabs(f.b);
    const double turn = (length(d.u) * errors.v + length(d.v) * errors.u) / (f.a * f.c) + own; // of N
    const double of_a = errors.u / f.a + own;
    const double of_b = (errors.v + 2 * b * errors.u) / f.a + own * (b + length(d.v) / f.a);
    const double of_c = (errors.v + b * errors.u) / f.c + turn;
    const double of_l = errors.uu + length(d.uu) * turn;
    const double of_m = errors.uv + length(d.uv) * turn;
    const double of_n = errors.vv + length(d.vv) * turn;
    const ShapeOperator w = shape_operator(d);
    const double first = of_l / f.a / f.a + 2 * std::fabs(w.w11) * of_a;
    const double mixed =
        (of_m + b * of_l + std::fabs(f.l) * of_b) / f.a / f.c + std::fabs(w.w12) * (of_a + of_c);
    const double second =
        (of_n + 2 * b * of_m + b * b * of_l + 2 * of_b * (std::fabs(f.m) + b * std::fabs(f.l))) / f.c / f.c +
        2 * std::fabs(w.w22) * of_c;
    return 0.5 * (first + second) + mixed;
}

} // namespace nrb
