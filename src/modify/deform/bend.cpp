// SPDX-License-Identifier: MIT
#include "modify/deform/bend.h"

#include "base/finite.h"
#include "base/numbers.h"
#include "base/watch.h"
#include "modify/deform/bend_bound.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>

namespace nrb::modify {

namespace {

// Makes x a unit vector. It is first scaled by a power of two, so that no length over- or underflows.
void normalise(std::vector<double> &x) noexcept {
    const int exponent = -std::ilogb(largest_magnitude(x));
    for (double &value : x) {
        value = std::ldexp(value, exponent);
    }
    const double length = norm(x.data(), static_cast<int>(x.size()));
    for (double &value : x) {
        value /= length;
    }
}

} // namespace

Bend make_bend(int dim, const double *origin, const double *along, const double *across, double curvature,
               double lower, double upper) {
    std::vector<double> e(along, along + dim), n(across, across + dim);
    normalise(e);
    normalise(n);
    for (int twice = 0; twice < 2; ++twice) { // the second pass removes the rounding of the first
        const double part = dot(e, n);
        for (size_t c = 0; c < n.size(); ++c) {
            n[c] -= part * e[c];
        }
        const double left = norm(n.data(), dim);
        if (!(left > 8 * dim * eps)) {
            fail(Status::direction, "across is parallel to along");
        }
        normalise(n);
    }
    return {origin, std::move(e), std::move(n), curvature, lower, upper};
}

namespace {

constexpr int64_t work_of_a_point = 100; // sines and cosines

double along_of(const Bend &bend, const double *point) noexcept {
    double a = 0;
    for (size_t c = 0; c < bend.along.size(); ++c) {
        a += (point[c] - bend.origin[c]) * bend.along[c];
    }
    return a;
}

// Let u be a in the bent part, and the end of that part for a beyond it; let h = k u / 2. Then (1/k + b)
// sin(k u) = u sinc(2 h) + b sin(2 h) and (1/k + b) cos(k u) - 1/k = b cos(2 h) - u sinc(h) sin(h), where
// sinc(x) = sin(x) / x. These forms are accurate for any curvature. Beyond the end the image goes on straight
// for a - u.
void bend_point(const Bend &bend, BendPart part, double a, const double *point, double *image) noexcept {
    double b = 0;
    for (size_t c = 0; c < bend.across.size(); ++c) {
        b += (point[c] - bend.origin[c]) * bend.across[c];
    }
    const double u = part == BendPart::bent ? a : part == BendPart::before ? bend.lower : bend.upper;
    const double beyond = a - u, angle = bend.curvature * u, half = angle / 2;
    const double sine = std::sin(angle), cosine = std::cos(angle), sine_of_half = std::sin(half);
    const double straight = angle == 0 ? u : u * (sine / angle);
    const double sagging = half == 0 ? 0 : u * (sine_of_half / half) * sine_of_half;
    const double to_a = straight + b * sine + beyond * cosine;
    const double to_b = b * cosine - sagging - beyond * sine;
    for (size_t c = 0; c < bend.along.size(); ++c) {
        image[c] = point[c] + ((to_a - a) * bend.along[c] + (to_b - b) * bend.across[c]);
    }
}

} // namespace

void bend_point(const Bend &bend, BendPart part, const double *point, double *image) noexcept {
    bend_point(bend, part, along_of(bend, point), point, image);
}

void bend_point(const Bend &bend, const double *point, double *image) noexcept {
    const double a = along_of(bend, point);
    bend_point(bend,
               a < bend.lower   ? BendPart::before
               : a > bend.upper ? BendPart::after
                                : BendPart::bent,
               a, point, image);
}

DeformedShape bend(const SplinePtr &spline, const Bend &bend, double tolerance) {
    if (bend.curvature == 0) {
        return {spline, 0, true};
    }
    const UsualLimit usual(usual_work(spline->point_count(), 200000));
    const size_t dim = bend.along.size();
    const fit::PointMap map = [&bend, dim](const std::vector<double> &points, std::vector<double> &images) {
        constexpr size_t points_between_counts = 64;
        for (size_t i = 0; i < points.size(); i += dim) {
            if (i % (points_between_counts * dim) == 0) {
                count_work(points_between_counts * work_of_a_point);
            }
            bend_point(bend, points.data() + i, images.data() + i);
        }
    };
    const fit::Judge judge = [&bend, tolerance](const SplinePtr &refined, const SplinePtr &candidate,
                                                fit::Cuts &cuts) {
        return bend_bound(*refined, *candidate, bend, tolerance, cuts);
    };
    const bool positive = spline->all_weights().smallest > 0;
    fit::FittedImage image = fit::fit_image(spline, map, tolerance, positive ? judge : nullptr);
    return {std::move(image.spline), image.deviation, image.proven};
}

} // namespace nrb::modify
