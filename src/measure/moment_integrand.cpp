// SPDX-License-Identifier: MIT
#include "measure/moment_integrand.h"

#include "base/error.h"
#include "base/numbers.h"
#include "base/representable.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>

namespace nrb::measure {

namespace {

// The area of the parallelogram of two vectors: the length of the longer one times that of the component of
// the other one orthogonal to it.
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

// Centroid and inertia from integrals in the frame of the model.
void add_moments(const Integrals &sums, const Factors &factors, const pieces::Frame &frame, MomentOrder order,
                 Moments &out) {
    const size_t dim = frame.centre.size();
    const double content = sums.values[0] * factors.content;
    if (!(std::abs(sums.values[0]) > 16 * eps * sums.size)) {
        fail(Status::length, "the content is %s, expected another than 0 for a centroid",
             Number(out.content).text);
    }
    std::vector<double> mean;
    for (size_t c = 0; c < dim; ++c) {
        mean.push_back(sums.values[1 + c] * factors.first / content);
        out.centroid.push_back(frame.centre[c] + std::ldexp(mean.back(), frame.exponent));
    }
    if (order != MomentOrder::inertia) {
        return;
    }
    const double *second = sums.values.data() + 1 + dim;
    out.inertia.resize(dim * dim);
    double trace = 0;
    for (size_t a = 0; a < dim; ++a) {
        for (size_t b = a; b < dim; ++b) {
            const double about = *second++ * factors.second - content * mean[a] * mean[b];
            out.inertia[a * dim + b] = out.inertia[b * dim + a] = -about;
            trace += a == b ? about : 0;
        }
    }
    for (size_t a = 0; a < dim; ++a) {
        out.inertia[a * dim + a] += trace;
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

} // namespace

double determinant(const double *u, const double *v, const double *w) noexcept {
    return u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) +
           u[2] * (v[0] * w[1] - v[1] * w[0]);
}

void MomentIntegrand::operator()(const double *x, const double *derivatives, double *out) const noexcept {
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

double MomentIntegrand::density(const double *, const double *d) const noexcept {
    if (axes_ == dim_) { // a polynomial; absolute() deals with its sign
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

void BoundaryIntegrand::operator()(const double *x, const double *d, double *out) const noexcept {
    MomentIntegrand::operator()(x, d, out);
    if (dim() == 3) {
        out += MomentIntegrand::values();
        out[0] = d[1] * d[5] - d[2] * d[4];
        out[1] = d[2] * d[3] - d[0] * d[5];
        out[2] = d[0] * d[4] - d[1] * d[3];
    }
}

double BoundaryIntegrand::density(const double *x, const double *d) const noexcept {
    return dim() == 2 ? x[0] * d[1] - x[1] * d[0] : determinant(x, d, d + 3);
}

Moments moments_from(const Integrals &sums, int independent, const Factors &factors,
                     const pieces::Frame &frame, MomentOrder order, double relative_tolerance) {
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
    if (independent > 0) {
        result.openness =
            std::ldexp(norm(sums.values.data() + sums.values.size() - 3, 3), 2 * frame.exponent);
    }
    check_finite(result);
    return result;
}

} // namespace nrb::measure
