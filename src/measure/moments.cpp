// SPDX-License-Identifier: MIT
#include "measure/moments.h"

#include "base/error.h"
#include "base/numbers.h"
#include "base/representable.h"
#include "eval/evaluate.h"
#include "measure/curve_length.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>

namespace nrb::measure {

namespace {

// The area between two vectors: the longer one times what of the other is across it.
double parallelogram(const double *u, const double *v, int dim) noexcept {
    double uu = 0, vv = 0, uv = 0;
    for (int c = 0; c < dim; ++c) {
        uu += u[c] * u[c];
        vv += v[c] * v[c];
        uv += u[c] * v[c];
    }
    if (uu < vv) {
        std::swap(u, v);
        std::swap(uu, vv);
    }
    if (!(uu > 0)) {
        return uu;
    }
    double across = 0;
    for (int c = 0; c < dim; ++c) {
        const double x = v[c] - uv / uu * u[c];
        across += x * x;
    }
    return std::sqrt(uu * across);
}

double determinant(const double *u, const double *v, const double *w) noexcept {
    return u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) +
           u[2] * (v[0] * w[1] - v[1] * w[0]);
}

// A density times 1, x and x x^T.
class MomentIntegrand : public Integrand {
public:
    MomentIntegrand(int axes, int dim, MomentOrder order) : axes_(axes), dim_(dim), order_(order) {}

    [[nodiscard]] int values() const noexcept override {
        return 1 + (order_ >= MomentOrder::centroid ? dim_ : 0) +
               (order_ == MomentOrder::inertia ? dim_ * (dim_ + 1) / 2 : 0);
    }
    [[nodiscard]] bool absolute() const noexcept override { return axes_ == dim_; }
    [[nodiscard]] bool metric() const noexcept override { return true; }
    [[nodiscard]] int degree(int places) const noexcept override {
        return axes_ == dim_ ? (dim_ + static_cast<int>(order_)) * places : -1;
    }
    void operator()(const double *x, const double *derivatives, double *out) const noexcept override {
        const double f = density(x, derivatives);
        *out++ = f;
        for (int c = 0; c < dim_ && order_ >= MomentOrder::centroid; ++c) {
            *out++ = f * x[c];
        }
        for (int a = 0; a < dim_ && order_ == MomentOrder::inertia; ++a) {
            for (int b = a; b < dim_; ++b) {
                *out++ = f * x[a] * x[b];
            }
        }
    }

protected:
    [[nodiscard]] virtual double density(const double *, const double *d) const noexcept {
        if (axes_ == dim_) { // a polynomial, whose sign is left to absolute()
            return axes_ == 1 ? d[0] : axes_ == 2 ? d[0] * d[3] - d[1] * d[2] : determinant(d, d + 3, d + 6);
        }
        if (axes_ == 2) {
            return parallelogram(d, d + dim_, dim_);
        }
        double square = 0;
        for (int c = 0; c < dim_; ++c) {
            square += d[c] * d[c];
        }
        return std::sqrt(square);
    }
    [[nodiscard]] int dim() const noexcept { return dim_; }
    [[nodiscard]] MomentOrder order() const noexcept { return order_; }

private:
    int axes_, dim_;
    MomentOrder order_;
};

// x . n on the boundary of a region, and the normal itself of surfaces.
class BoundaryIntegrand : public MomentIntegrand {
public:
    using MomentIntegrand::MomentIntegrand;

    [[nodiscard]] bool absolute() const noexcept override { return false; }
    [[nodiscard]] bool metric() const noexcept override { return false; }
    [[nodiscard]] int degree(int places) const noexcept override {
        return (dim() + static_cast<int>(order())) * places;
    }
    [[nodiscard]] int independent() const noexcept override { return dim() == 3 ? 3 : 0; }
    [[nodiscard]] int values() const noexcept override { return MomentIntegrand::values() + independent(); }
    void operator()(const double *x, const double *d, double *out) const noexcept override {
        MomentIntegrand::operator()(x, d, out);
        if (dim() == 3) {
            out += MomentIntegrand::values();
            out[0] = d[1] * d[5] - d[2] * d[4];
            out[1] = d[2] * d[3] - d[0] * d[5];
            out[2] = d[0] * d[4] - d[1] * d[3];
        }
    }

protected:
    [[nodiscard]] double density(const double *x, const double *d) const noexcept override {
        return dim() == 2 ? x[0] * d[1] - x[1] * d[0] : determinant(x, d, d + 3);
    }
};

// What the integrals of the density times functions of degree 0, 1 and 2 are multiplied by, and the dimension
// of the content.
struct Factors {
    double content = 1, first = 1, second = 1;
    int dimension;
};

// Centroid and inertia from integrals in the frame of the model.
void add_moments(const Integrals &sums, const Factors &factors, const pieces::Frame &frame, MomentOrder order,
                 Moments &out) {
    const int dim = static_cast<int>(frame.centre.size());
    const double content = sums.values[0] * factors.content;
    if (!(std::abs(sums.values[0]) > 16 * eps * sums.size)) {
        fail(Status::length, "the content is %s, expected another than 0 for a centroid",
             Number(out.content).text);
    }
    std::vector<double> mean;
    for (int c = 0; c < dim; ++c) {
        mean.push_back(sums.values[static_cast<size_t>(1 + c)] * factors.first / content);
        out.centroid.push_back(frame.centre[static_cast<size_t>(c)] +
                               std::ldexp(mean.back(), frame.exponent));
    }
    if (order != MomentOrder::inertia) {
        return;
    }
    const double *second = sums.values.data() + 1 + dim;
    out.inertia.resize(static_cast<size_t>(dim * dim));
    double trace = 0;
    for (int a = 0; a < dim; ++a) {
        for (int b = a; b < dim; ++b) {
            const double about = *second++ * factors.second -
                                 content * mean[static_cast<size_t>(a)] * mean[static_cast<size_t>(b)];
            out.inertia[static_cast<size_t>(a * dim + b)] = out.inertia[static_cast<size_t>(b * dim + a)] =
                -about;
            trace += a == b ? about : 0;
        }
    }
    for (int a = 0; a < dim; ++a) {
        out.inertia[static_cast<size_t>(a * dim + a)] += trace;
    }
    for (double &x : out.inertia) {
        x = std::ldexp(x, frame.exponent * (factors.dimension + 2)) + 0.0;
    }
}

void check_finite(const Moments &found) {
    require_representable({&found.content, 1}, "content");
    require_representable(found.centroid, "centroid");
    require_representable(found.inertia, "inertia");
    require_representable({&found.openness, 1}, "openness");
}

Moments moments_of(const std::vector<Elements> &splines, const Integrand &integrand, const Factors &factors,
                   const pieces::Frame &frame, MomentOrder order, double relative_tolerance) {
    const Integrals sums = integrate(splines, integrand, relative_tolerance);
    const int power = frame.exponent * factors.dimension;
    Moments result;
    result.content = std::ldexp(sums.values[0] * factors.content, power);
    result.error = std::ldexp((sums.errors[0] + sums.rounding) * factors.content, power);
    if (!sums.converged || !std::isfinite(sums.values[0])) {
        fail(Status::not_converged, "content = %s: the error reached is %s, expected relative_tolerance = %s",
             Number(result.content).text, Number(result.error).text, Number(relative_tolerance).text);
    }
    if (order != MomentOrder::content) {
        add_moments(sums, factors, frame, order, result);
    }
    if (integrand.independent() > 0) {
        result.openness =
            std::ldexp(norm(sums.values.data() + sums.values.size() - 3, 3), 2 * frame.exponent);
    }
    check_finite(result);
    return result;
}

// The place of a curve at a parameter, from one side.
std::vector<double> place_of(const Spline &curve, double t, bool left) {
    std::vector<double> x(static_cast<size_t>(curve.dim()));
    eval::AxisRules rules{};
    rules[0].left = left;
    eval::evaluate_points(curve, rules, 0, {&t, 1}, {x.data(), 1, curve.dim(), curve.dim()});
    return x;
}

struct CurveEnd {
    int64_t curve;
    std::vector<double> place;
};

// Of the parts between jumps; that of a periodic curve at its seam has no end there.
void add_ends(const Spline &curve, int64_t number, std::vector<CurveEnd> &starts,
              std::vector<CurveEnd> &ends) {
    const KnotVector &axis = curve.axis(0);
    const auto [lower, upper] = axis.domain();
    for (const KnotGroup &group : distinct_knots(axis.knots())) {
        const bool jump = group.multiplicity > axis.degree(),
                   outer = group.knot == lower || group.knot == upper;
        if (group.knot < lower || group.knot > upper || !(jump || (outer && !axis.periodic()))) {
            continue;
        }
        if (group.knot > lower) {
            ends.push_back({number, place_of(curve, group.knot, true)});
        }
        if (group.knot < upper) {
            starts.push_back({number, place_of(curve, group.knot, false)});
        }
    }
}

} // namespace

Moments moments(const Spline &spline, const Part &part, MomentOrder order, double relative_tolerance) {
    const pieces::Frame frame = integral_frame(spline);
    std::vector<Elements> elements;
    elements.emplace_back(spline, frame, part);
    return moments_of(elements, MomentIntegrand(spline.axes(), spline.dim(), order), {1, 1, 1, spline.axes()},
                      frame, order, relative_tolerance);
}

Moments enclosed_moments(const std::vector<SplinePtr> &boundary, MomentOrder order,
                         double relative_tolerance) {
    std::vector<const Spline *> parts;
    parts.reserve(boundary.size());
    for (const SplinePtr &part : boundary) {
        parts.push_back(part.get());
    }
    const pieces::Frame frame = integral_frame(parts);
    std::vector<Elements> elements;
    elements.reserve(parts.size());
    for (const Spline *one : parts) {
        elements.emplace_back(*one, frame, whole_domain(*one));
    }
    const int n = parts.front()->dim();
    return moments_of(elements, BoundaryIntegrand(n - 1, n, order),
                      {1.0 / n, 1.0 / (n + 1), 1.0 / (n + 2), n}, frame, order, relative_tolerance);
}

void check_closed(const std::vector<SplinePtr> &curves, double tolerance) {
    std::vector<CurveEnd> starts, ends;
    for (int64_t i = 0; i < std::ssize(curves); ++i) {
        add_ends(*curves[static_cast<size_t>(i)], i, starts, ends);
    }
    for (const CurveEnd &end : ends) {
        double gap = infinity;
        for (const CurveEnd &start : starts) {
            gap = std::min(gap, distance(start.place.data(), end.place.data(), 2));
        }
        if (!(gap <= tolerance)) {
            fail(Status::gap, "curves[%lld] ends %s from the nearest start, expected at most tolerance = %s",
                 static_cast<long long>(end.curve), Number(gap).text, Number(tolerance).text);
        }
    }
}

} // namespace nrb::measure
