// Lengths of curves in fifty digits, from the definition: Gauss rules on halves of the spans until they
// agree.
#pragma once

#include "reference/float50.h"
#include "reference/number.h"
#include "support/spline_data.h"

#include <vector>

namespace support {

using Long = reference::Float50;

// |C'(t)| by de Boor's algorithm; span names the piece.
inline Long exact_speed(const SplineData &data, size_t span, const Long &t) {
    const auto p = static_cast<size_t>(data.degrees[0]), dim = static_cast<size_t>(data.dim);
    if (p == 0) {
        return 0;
    }
    const std::vector<double> &u = data.knots[0];
    std::vector<std::vector<Long>> d(p + 1, std::vector<Long>(dim + 1));
    for (size_t i = 0; i <= p; ++i) {
        const auto at = static_cast<int64_t>(span - p + i);
        d[i][dim] = data.weight(at);
        for (size_t c = 0; c < dim; ++c) {
            d[i][c] = d[i][dim] * data.coordinate(at, static_cast<int>(c));
        }
    }
    std::vector<Long> slope(dim + 1);
    for (size_t r = 1; r <= p; ++r) {
        if (r == p) {
            for (size_t c = 0; c <= dim; ++c) {
                slope[c] = Long(p) * (d[p][c] - d[p - 1][c]) / (Long(u[span + 1]) - u[span]);
            }
        }
        for (size_t i = p; i >= r; --i) {
            const size_t k = span - p + i;
            const Long low = u[k], a = (t - low) / (Long(u[k + p - r + 1]) - low);
            for (size_t c = 0; c <= dim; ++c) {
                d[i][c] = (1 - a) * d[i - 1][c] + a * d[i][c];
            }
        }
    }
    Long square = 0;
    for (size_t c = 0; c < dim; ++c) {
        const Long x = (slope[c] - d[p][c] / d[p][dim] * slope[dim]) / d[p][dim];
        square += x * x;
    }
    return sqrt(square);
}

// Over [lower, upper] of a span, to `tolerance`.
inline Long exact_part(const SplineData &data, size_t span, const Long &lower, const Long &upper,
                       const Long &tolerance, int depth = 0) {
    const auto f = [&](const Long &t) { return exact_speed(data, span, t); };
    const Long coarse = boost::math::quadrature::gauss<Long, 20>::integrate(f, lower, upper);
    const Long fine = boost::math::quadrature::gauss<Long, 30>::integrate(f, lower, upper);
    if (abs(fine - coarse) <= tolerance || depth > 60) {
        return fine;
    }
    const Long middle = (lower + upper) / 2;
    return exact_part(data, span, lower, middle, tolerance, depth + 1) +
           exact_part(data, span, middle, upper, tolerance, depth + 1);
}

inline Long exact_length(const SplineData &data, double lower, double upper, double tolerance) {
    Long sum = 0;
    const std::vector<double> &u = data.knots[0];
    for (auto i = static_cast<size_t>(data.degrees[0]); i < static_cast<size_t>(data.counts[0]); ++i) {
        const double first = std::max(u[i], lower), last = std::min(u[i + 1], upper);
        if (first < last) {
            sum += exact_part(data, i, first, last, tolerance);
        }
    }
    return sum;
}

} // namespace support
