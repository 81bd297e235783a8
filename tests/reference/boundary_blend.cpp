#include "reference/boundary_blend.h"

#include "reference/exact_spline.h"

namespace reference {

namespace {

Point rational(const std::vector<Fraction> &values) {
    Point point;
    for (const Fraction &x : values) {
        point.emplace_back(x.numerator, x.denominator);
    }
    return point;
}

void add(Point &sum, const Rational &factor, const Point &x) {
    sum.resize(x.size());
    for (size_t c = 0; c < x.size(); ++c) {
        sum[c] += factor * x[c];
    }
}

} // namespace

Point exact_value(const support::SplineData &data, const std::vector<double> &param) {
    return rational(exact_point(data, param.data()));
}

Point exact_slope(const support::SplineData &curve, double t) {
    return rational(exact_derivatives(curve, 1, &t)[1]);
}

std::vector<Rational> blending_functions(size_t size, const Rational &lower, const Rational &upper,
                                         const Rational &t) {
    const Rational length = upper - lower, x = (t - lower) / length, y = 1 - x;
    if (size == 2) {
        return {y, x};
    }
    return {y * y * (1 + 2 * x), x * x * (1 + 2 * y), length * x * y * y, -length * x * x * y};
}

BoundaryBlend::BoundaryBlend(std::vector<support::SplineData> curves) : curves_(std::move(curves)) {
    for (size_t i = 0; i < order(); ++i) {
        for (size_t j = 0; j < order(); ++j) {
            Point mean;
            add(mean, Rational(1, 2), own(i, j, true));
            add(mean, Rational(1, 2), own(i, j, false));
            corners_.push_back(mean);
        }
    }
}

const support::SplineData &BoundaryBlend::curve(size_t functional, bool along1) const {
    return curves_[functional / 2 * 4 + functional % 2 + (along1 ? 0 : 2)];
}

Point BoundaryBlend::own(size_t i, size_t j, bool along1) const {
    const support::SplineData &one = curve(along1 ? i : j, along1);
    const size_t at = along1 ? j : i;
    const double t = at % 2 == 0 ? one.lower(0) : one.upper(0);
    return at < 2 ? exact_value(one, {t}) : exact_slope(one, t);
}

Point BoundaryBlend::entry(size_t i, double t, bool along1) const {
    const support::SplineData &one = curve(i, along1);
    Point point = exact_value(one, {t});
    const std::vector<Rational> blends =
        blending_functions(order(), exact(one.lower(0)), exact(one.upper(0)), exact(t));
    for (size_t j = 0; j < order(); ++j) {
        add(point, blends[j], along1 ? corner(i, j) : corner(j, i));
        add(point, -blends[j], along1 ? own(i, j, true) : own(j, i, false));
    }
    return point;
}

Point BoundaryBlend::value(double u, double v) const {
    const support::SplineData &across = curves_[2], &along = curves_[0];
    std::vector<Rational> f =
        blending_functions(order(), exact(across.lower(0)), exact(across.upper(0)), exact(u));
    std::vector<Rational> g =
        blending_functions(order(), exact(along.lower(0)), exact(along.upper(0)), exact(v));
    f.insert(f.begin(), Rational(-1));
    g.insert(g.begin(), Rational(-1));
    Point sum;
    for (size_t i = 0; i <= order(); ++i) {
        for (size_t j = i == 0 ? 1 : 0; j <= order(); ++j) { // entry (0, 0) is 0
            add(sum, -f[i] * g[j],
                i == 0   ? entry(j - 1, u, false)
                : j == 0 ? entry(i - 1, v, true)
                         : corner(i - 1, j - 1));
        }
    }
    return sum;
}

} // namespace reference
