// SPDX-License-Identifier: MIT
#include "face/trims/near.h"

#include "base/limits.h"
#include "base/numbers.h"
#include "basis/bspline.h"
#include "bernstein/de_casteljau.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>

namespace nrb::face {

namespace {

constexpr double decided = 1e-6; // in units of the distance
constexpr int max_depth = 60;

// A part of a piece by its homogeneous control points, with the place x as the origin: (u w, v w, w).
struct Part3 {
    int degree;
    std::array<double, 3 * max_basis> values;

    [[nodiscard]] Point2 point(int i) const noexcept {
        const double *record = values.data() + 3 * static_cast<size_t>(i);
        return {record[0] / record[2], record[1] / record[2]};
    }
};

Part3 about(const TrimPieces &pieces, const TrimPiece &piece, const Point2 &x) {
    Part3 result{piece.degree, {}};
    const auto values = pieces.coefficients(piece);
    const size_t width = piece.weighted ? 3 : 2;
    for (size_t i = 0; i <= static_cast<size_t>(piece.degree); ++i) {
        const double weight = piece.weighted ? values[i * width + 2] : 1;
        for (size_t k = 0; k < 2; ++k) {
            result.values[3 * i + k] = values[i * width + k] - x[k] * weight;
        }
        result.values[3 * i + 2] = weight;
    }
    return result;
}

// The squared distance of the origin from a segment.
double from_segment(const Metric &metric, const Point2 &a, const Point2 &b) noexcept {
    const double u = b[0] - a[0], v = b[1] - a[1], length = metric.squared(u, v);
    const double along = metric.uu * a[0] * u + metric.uv * (a[0] * v + a[1] * u) + metric.vv * a[1] * v;
    const double t = length > 0 ? std::clamp(-along / length, 0.0, 1.0) : 0;
    return std::max(metric.squared(a[0] + t * u, a[1] + t * v),
                    0.0); // rounding of a metric that is nearly singular
}

// By the convex hull property, the part is no farther from its chord than its control points are.
bool near_part(const Metric &metric, Part3 &part, int depth) {
    const Point2 first = part.point(0), last = part.point(part.degree);
    const double chord = std::sqrt(from_segment(metric, first, last));
    double bulge = 0;
    for (int i = 1; i < part.degree; ++i) {
        const Point2 x = part.point(i);
        bulge = std::max(bulge, from_segment(metric, {first[0] - x[0], first[1] - x[1]},
                                             {last[0] - x[0], last[1] - x[1]}));
    }
    bulge = std::sqrt(bulge);
    if (chord > 1 + bulge) {
        return false;
    }
    if (std::min(metric.squared(first[0], first[1]), metric.squared(last[0], last[1])) <= 1) {
        return true;
    }
    if (bulge <= decided || depth == 0) {
        return chord <= 1;
    }
    Part3 lower = part;
    subdivide(part.degree, 3, 0.5, part.values.data(), lower.values.data());
    return near_part(metric, lower, depth - 1) || near_part(metric, part, depth - 1);
}

} // namespace

Metric Metric::of(const double *u, const double *v, int dim, double unit) noexcept {
    const double a = norm(u, dim) / unit, b = norm(v, dim) / unit;
    return {a * a, dot(u, v, dim) / unit / unit, b * b};
}

Point2 Metric::reach() const noexcept {
    const double determinant = uu * vv - uv * uv;
    if (!(determinant > 1e-20 * uu * vv)) {
        return {infinity, infinity};
    }
    return {std::sqrt(vv / determinant), std::sqrt(uu / determinant)};
}

bool is_near(const TrimPieces &pieces, const TrimPiece &piece, const Point2 &x, const Metric &metric) {
    Part3 part = about(pieces, piece, x);
    return near_part(metric, part, max_depth);
}

} // namespace nrb::face
