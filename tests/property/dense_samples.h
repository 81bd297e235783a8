// Distances of splines at many parameters, by de Boor's recurrence in long double.
#pragma once

#include "property/same_shape.h"
#include "reference/exact_basis.h"

#include <limits>

namespace support {

// N_(span-p), ..., N_span at t.
inline std::vector<long double> long_basis(const std::vector<double> &knots, int degree, int64_t span,
                                           double t) {
    std::vector<long double> values{1};
    const auto knot = [&](int64_t i) { return static_cast<long double>(knots[static_cast<size_t>(i)]); };
    for (int d = 1; d <= degree; ++d) {
        std::vector<long double> next(static_cast<size_t>(d) + 1, 0.0L);
        for (int r = 0; r < d; ++r) {
            const long double left = knot(span - d + 1 + r), right = knot(span + 1 + r);
            const long double share = values[static_cast<size_t>(r)] / (right - left);
            next[static_cast<size_t>(r)] += share * (right - t);
            next[static_cast<size_t>(r) + 1] += share * (t - left);
        }
        values = next;
    }
    return values;
}

// The Cartesian point at a parameter, on given sides of knots.
inline std::vector<long double> long_point(const SplineData &data, const double *param,
                                           reference::Sides left) {
    std::vector<std::vector<long double>> basis;
    std::vector<int64_t> first;
    int64_t total = 1;
    for (int k = 0; k < data.axes(); ++k) {
        const auto at = static_cast<size_t>(k);
        const int p = data.degrees[at];
        const int64_t span = reference::exact_span(data.knots[at], p, param[k], left[at]);
        basis.push_back(long_basis(data.knots[at], p, span, param[k]));
        first.push_back(span - p);
        total *= p + 1;
    }
    std::vector<long double> sum(static_cast<size_t>(data.dim) + 1, 0.0L);
    for (int64_t i = 0; i < total; ++i) {
        long double factor = 1;
        int64_t rest = i, place = 0, step = 1;
        for (int k = data.axes(); k-- > 0;) {
            const auto at = static_cast<size_t>(k);
            const int64_t j = rest % (data.degrees[at] + 1);
            rest /= data.degrees[at] + 1;
            factor *= basis[at][static_cast<size_t>(j)];
            place += (first[at] + j) * step;
            step *= data.counts[at];
        }
        const auto at = static_cast<size_t>(place);
        factor *= data.weights.empty() ? 1 : data.weights[at];
        for (size_t c = 0; c < static_cast<size_t>(data.dim); ++c) {
            sum[c] += factor * data.points[at * static_cast<size_t>(data.dim) + c];
        }
        sum.back() += factor;
    }
    for (long double &x : sum) {
        x /= sum.back();
    }
    sum.pop_back();
    return sum;
}

// `per_span` places in every span of both knot vectors, its ends among them.
struct SampledPlace {
    double t;
    bool left;
};
inline std::vector<SampledPlace> dense_places(const SplineData &f, const SplineData &g, int axis,
                                              int per_span) {
    const auto at = static_cast<size_t>(axis);
    std::vector<double> breaks = f.knots[at];
    breaks.insert(breaks.end(), g.knots[at].begin(), g.knots[at].end());
    std::sort(breaks.begin(), breaks.end());
    breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
    std::erase_if(breaks, [&](double t) { return t < f.lower(axis) || t > f.upper(axis); });
    std::vector<SampledPlace> places;
    for (size_t i = 0; i + 1 < breaks.size(); ++i) {
        for (int j = 0; j <= per_span; ++j) {
            const double x = static_cast<double>(j) / per_span;
            const double t = j == per_span ? breaks[i + 1] : breaks[i] + (breaks[i + 1] - breaks[i]) * x;
            places.push_back({t, j == per_span});
        }
    }
    return places;
}

// What the sums of long_point() may be off by.
inline long double sampling_error(const SplineData &data) {
    long double size = 0;
    int degrees = 0;
    for (const double x : data.points) {
        size = std::max(size, std::fabs(static_cast<long double>(x)));
    }
    for (const int32_t p : data.degrees) {
        degrees += p + 1;
    }
    return size * degrees * 16 * std::numeric_limits<long double>::epsilon() *
           std::sqrt(static_cast<long double>(data.dim));
}

// Largest distance over a dense grid of a curve or surface, less that.
inline long double dense_deviation(const SplineData &f, const SplineData &g, int per_span) {
    std::vector<std::vector<SampledPlace>> places;
    for (int k = 0; k < 2; ++k) {
        places.push_back(k < f.axes() ? dense_places(f, g, k, per_span)
                                      : std::vector<SampledPlace>{{0, false}});
    }
    long double largest = 0;
    for (const SampledPlace &u : places[0]) {
        for (const SampledPlace &v : places[1]) {
            const double param[] = {u.t, v.t};
            const reference::Sides left{u.left, v.left, false};
            const auto a = long_point(f, param, left), b = long_point(g, param, left);
            long double square = 0;
            for (size_t c = 0; c < a.size(); ++c) {
                square += (a[c] - b[c]) * (a[c] - b[c]);
            }
            largest = std::max(largest, std::sqrt(square));
        }
    }
    return std::max(0.0L, largest - sampling_error(f) - sampling_error(g));
}

// Of ratios, printed.
inline long double median(std::vector<long double> values, const char *title) {
    std::sort(values.begin(), values.end());
    const long double middle = values.empty() ? 0 : values[values.size() / 2];
    std::printf("%s: median %.3Lf, largest %.3Lf of %zu\n", title, middle,
                values.empty() ? 0.0L : values.back(), values.size());
    return middle;
}

} // namespace support
