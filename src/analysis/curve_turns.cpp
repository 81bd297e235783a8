// SPDX-License-Identifier: MIT
#include "analysis/curve_turns.h"

#include "base/numbers.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>

namespace nrb::analysis {

namespace {

// The coefficient at an end, with its error.
struct Bounded {
    double value;
    double error;
};
Bounded at_end(const RoundedPolynomial &f, bool upper, size_t c = 0) noexcept {
    const auto n = static_cast<size_t>(f.shape.width);
    const size_t i = upper ? f.values.size() - n + c : c;
    return {f.values[i], f.error(i)};
}

} // namespace

EndTangent end_tangent(const pieces::HomogeneousPiece &piece, bool upper) {
    RoundedPolynomial d = pieces::tangent_numerator(piece, 0);
    if (divide_end(d, last_axis, upper) < 0) {
        return {};
    }
    const int n = d.shape.width;
    EndTangent result{std::vector<double>(static_cast<size_t>(n)), 0};
    for (size_t c = 0; c < result.direction.size(); ++c) {
        result.direction[c] = at_end(d, upper, c).value;
    }
    const double size = norm(result.direction.data(), n);
    const double error = norm_of(n, [&](int c) { return at_end(d, upper, static_cast<size_t>(c)).error; });
    if (!(size > error)) {
        return {};
    }
    std::for_each(result.direction.begin(), result.direction.end(), [size](double &x) { x /= size; });
    result.turned = 1.01 * std::asin(std::min(1.0, error / size)) + 4 * eps;
    return result;
}

double turning_angle(const EndTangent &before, const EndTangent &after) {
    if (before.direction.empty() || after.direction.empty()) {
        return 0;
    }
    const std::vector<double> &a = before.direction, &b = after.direction;
    const auto n = static_cast<int>(a.size());
    const double apart =
        norm_of(n, [&](int c) { return a[static_cast<size_t>(c)] - b[static_cast<size_t>(c)]; });
    const double sum =
        norm_of(n, [&](int c) { return a[static_cast<size_t>(c)] + b[static_cast<size_t>(c)]; });
    const double angle = 2 * std::atan2(apart, sum);
    if (!(angle > before.turned + after.turned)) {
        return 0;
    }
    return n == 2 && a[0] * b[1] - a[1] * b[0] < 0 ? -angle : angle;
}

std::optional<EndCurvature> end_curvature(const pieces::HomogeneousPiece &piece, bool upper) {
    const RoundedPolynomial d = pieces::tangent_numerator(piece, 0), m = pieces::bend_numerator(piece);
    const Bounded s = at_end(dot(d, d), upper), w = at_end(piece.weight, upper);
    double bend = 0, error = 0;
    for (int c = 0; c < m.shape.width; ++c) {
        const Bounded x = at_end(m, upper, static_cast<size_t>(c));
        bend = std::hypot(bend, x.value);
        error = std::hypot(error, x.error);
    }
    if (!(s.value > 2 * s.error) || !(w.value > 2 * w.error)) {
        return std::nullopt;
    }
    const double factor = w.value * w.value * w.value / (s.value * std::sqrt(s.value));
    const double relative = 4 * w.error / w.value + 6 * s.error / s.value + 16 * eps;
    return EndCurvature{std::ldexp(bend * factor, -piece.exponent),
                        std::ldexp(factor * (error * (1 + relative) + bend * relative), -piece.exponent)};
}

} // namespace nrb::analysis
