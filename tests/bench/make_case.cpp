#include "bench/make_case.h"

#include "reference/magnitudes.h"
#include "support/generators.h"

#include <algorithm>
#include <cmath>

namespace bench {

using reference::Fraction;
using support::Random;
using support::SplineData;

namespace {

constexpr uint64_t seed = 20240229;
constexpr size_t sample_size = 300;
using Vector = std::vector<long double>;

// Clamped on [0, 1]; the longest span is four times the shortest.
std::vector<double> make_knots(Random &random, int degree, int64_t count) {
    std::vector<double> inner = {0};
    for (int64_t i = degree; i < count; ++i) {
        inner.push_back(inner.back() + random.between(0.5, 2));
    }
    std::vector<double> knots(static_cast<size_t>(degree), 0.0);
    for (const double t : inner) {
        knots.push_back(t / inner.back());
    }
    knots.insert(knots.end(), static_cast<size_t>(degree), 1.0);
    return knots;
}

// Coordinate k of a control point moves with its index along axis k, so that surfaces have normals; the
// others are random.
void make_points(Random &random, SplineData &spline) {
    for (int64_t i = 0; i < spline.point_count(); ++i) {
        int64_t rest = i;
        std::vector<double> point(static_cast<size_t>(std::max(spline.dim, spline.axes())));
        for (int axis = spline.axes(); axis-- > 0; rest /= spline.counts[static_cast<size_t>(axis)]) {
            const int64_t count = spline.counts[static_cast<size_t>(axis)];
            point[static_cast<size_t>(axis)] = static_cast<double>(rest % count) / static_cast<double>(count);
        }
        for (size_t c = 0; c < static_cast<size_t>(spline.dim); ++c) {
            const double noise =
                c < spline.degrees.size() ? 0.2 / static_cast<double>(spline.counts[c]) : 0.1;
            spline.points.push_back(point[c] + noise * random.between(-1, 1));
        }
    }
}

SplineData make_spline(Random &random, const Job &job) {
    SplineData spline;
    spline.dim = job.dim;
    for (int axis = 0; axis < job.axes; ++axis) {
        spline.degrees.push_back(job.degree);
        spline.counts.push_back(job.count);
        spline.knots.push_back(make_knots(random, job.degree, job.count));
    }
    make_points(random, spline);
    for (int64_t i = 0; job.rational && i < spline.point_count(); ++i) {
        spline.weights.push_back(random.between(0.5, 2));
    }
    return spline;
}

std::vector<double> uniform(Random &random, size_t n) {
    std::vector<double> values(n);
    std::ranges::generate(values, [&] { return random.unit(); });
    return values;
}

void make_grid(Random &random, Case &data) {
    data.grid = {1000, 1000};
    for (const int64_t n : data.grid) {
        std::vector<double> axis = uniform(random, static_cast<size_t>(n));
        std::ranges::sort(axis);
        data.params.insert(data.params.end(), axis.begin(), axis.end());
    }
}

void make_params(Random &random, const Job &job, Case &data) {
    if (job.params == Params::grid) {
        make_grid(random, data);
        return;
    }
    const size_t n = job.params == Params::single ? 100'000 : 1'000'000;
    data.params = uniform(random, n * static_cast<size_t>(job.axes));
    if (job.params == Params::sorted) {
        std::ranges::sort(data.params);
    }
}

std::vector<double> params_of_point(const Case &data, int64_t i) {
    if (!data.grid.empty()) {
        return {data.params[static_cast<size_t>(i / data.grid[1])],
                data.params[static_cast<size_t>(data.grid[0] + i % data.grid[1])]};
    }
    const int64_t axes = data.spline.axes();
    return {data.params.begin() + i * axes, data.params.begin() + (i + 1) * axes};
}

Vector cross(const Vector &a, const Vector &b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

long double length(const Vector &a) {
    return std::hypot(a[0], a[1], a[2]);
}

void append(Case &data, const Vector &values, const Vector &bounds) {
    for (size_t c = 0; c < values.size(); ++c) {
        data.expected.push_back(static_cast<double>(values[c]));
        // the rounding of the expected value is allowed for
        data.bounds.push_back(static_cast<double>(bounds[c] + reference::eps / 2 * std::abs(values[c])));
    }
}

// First order: |n - N| <= (|S_u| b_v + |S_v| b_u) / |S_u x S_v|, and some roundings of its own.
void append_normal(Case &data, const std::vector<Vector> &values, const std::vector<Vector> &bounds) {
    Vector normal = cross(values[1], values[2]);
    const long double size = length(normal);
    for (long double &x : normal) {
        x /= size;
    }
    const long double error =
        (length(values[1]) * length(bounds[2]) + length(values[2]) * length(bounds[1])) / size;
    append(data, normal, Vector(3, error + 16 * reference::eps));
}

// The bounds that nurbs.h states for each partial derivative.
std::vector<Vector> bounds_of(const SplineData &spline, int order, const double *param) {
    std::vector<Vector> bounds = reference::magnitudes(spline, order, param, reference::Terms::stored);
    const auto indices = support::graded_indices(spline.axes(), order);
    const long double c = reference::c_of(spline);
    for (size_t slot = 0; slot < bounds.size(); ++slot) {
        int total = 0;
        for (const int k : indices[slot]) {
            total += k;
        }
        for (long double &bound : bounds[slot]) {
            bound = slot == 0 ? c * reference::eps * reference::exact_hull(spline, param)
                              : 2 * (c + 2 * total) * reference::eps * bound;
        }
    }
    return bounds;
}

void append_exact(const Job &job, Case &data, int64_t point) {
    const std::vector<double> param = params_of_point(data, point);
    std::vector<Vector> values;
    for (const auto &slot : reference::exact_derivatives(data.spline, job.order, param.data())) {
        Vector &vector = values.emplace_back();
        for (const Fraction &x : slot) {
            vector.push_back(reference::quotient(x.numerator, x.denominator));
        }
    }
    const std::vector<Vector> bounds = bounds_of(data.spline, job.order, param.data());
    for (size_t slot = 0; slot < values.size(); ++slot) {
        append(data, values[slot], bounds[slot]);
    }
    if (job.normal) {
        append_normal(data, values, bounds);
    }
}

} // namespace

Case make_case(const Job &job) {
    Random random(seed);
    Case data;
    data.spline = make_spline(random, job);
    make_params(random, job, data);
    data.sample = {0, data.points() - 1};
    while (data.sample.size() < sample_size) {
        data.sample.push_back(random.whole(0, static_cast<int>(data.points()) - 1));
    }
    std::ranges::sort(data.sample);
    for (const int64_t point : data.sample) {
        append_exact(job, data, point);
    }
    return data;
}

} // namespace bench
