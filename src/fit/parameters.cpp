// SPDX-License-Identifier: MIT
#include "fit/parameters.h"

#include "base/error.h"
#include "base/numbers.h"
#include "base/watch.h"
#include "basis/bspline.h"
#include "basis/generators.h"
#include "basis/knot_vector.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace nrb::fit {

namespace {

constexpr int64_t work_of_a_step = 16;

// Sums of equal steps are exact: i / last.
std::vector<double> even(int64_t count) {
    std::vector<double> params(static_cast<size_t>(count), 0.0);
    for (int64_t i = 1; i < count; ++i) {
        params[static_cast<size_t>(i)] = static_cast<double>(i) / static_cast<double>(count - 1);
    }
    return params;
}

// The angle between two vectors, from those of unit length (W. Kahan): accurate at all angles.
double angle_between(const double *a, double a_length, const double *b, double b_length, int dim) noexcept {
    const auto sum = norm_of(dim, [&](int c) { return a[c] / a_length + b[c] / b_length; });
    const auto difference = norm_of(dim, [&](int c) { return a[c] / a_length - b[c] / b_length; });
    return 2 * std::atan2(difference, sum);
}

// The steps of one line of the grid, and what the rule makes of them.
class Line {
public:
    Line(int64_t count, int dim, bool closed)
        : dim_(dim), closed_(closed), steps_(static_cast<size_t>((count - 1) * dim)),
          chords_(static_cast<size_t>(count - 1)), lengths_(chords_) {}

    // Points are `stride` doubles apart. The scale keeps chords from overflowing.
    void set(const double *points, int64_t stride, double scale) noexcept {
        for (size_t i = 0; i < chords_.size(); ++i, points += stride) {
            double *const step = steps_.data() + i * static_cast<size_t>(dim_);
            for (int c = 0; c < dim_; ++c) {
                step[c] = points[stride + c] * scale - points[c] * scale;
            }
            chords_[i] = norm(step, dim_);
        }
    }

    // Lengths in units of their largest chord, so that no rule leaves the range of doubles.
    const std::vector<double> &lengths(ParameterRule rule, double exponent) noexcept {
        const double largest = *std::max_element(chords_.begin(), chords_.end());
        for (size_t i = 0; i < chords_.size(); ++i) {
            const double chord = largest > 0 ? chords_[i] / largest : 0;
            lengths_[i] = chord == 0                           ? 0
                          : rule == ParameterRule::chord       ? chord
                          : rule == ParameterRule::centripetal ? std::sqrt(chord)
                          : rule == ParameterRule::power       ? std::pow(chord, exponent)
                                                               : chord * turning(i);
        }
        return lengths_;
    }

private:
    // How much longer a step counts for the angles at its ends (T. Foley, G. Nielson, "Knot selection for parametric
    // spline interpolation", in: Mathematical Methods in Computer Aided Geometric Design, 1989), with Euclidean chords.
    [[nodiscard]] double turning(size_t i) const noexcept {
        const size_t n = chords_.size();
        const bool before = closed_ || i > 0, after = closed_ || i + 1 < n;
        return 1 + 1.5 * ((before ? part(i, (i + n - 1) % n) : 0) + (after ? part(i, (i + 1) % n) : 0));
    }
    // Of the angle between a step and one beside it: pi minus the inner angle, but at most a right one.
    [[nodiscard]] double part(size_t i, size_t beside) const noexcept {
        if (!(chords_[beside] > 0)) {
            return 0;
        }
        const auto step = [&](size_t at) { return steps_.data() + at * static_cast<size_t>(dim_); };
        const double turn = angle_between(step(i), chords_[i], step(beside), chords_[beside], dim_);
        return std::min(turn, std::numbers::pi / 2) * (chords_[beside] / (chords_[beside] + chords_[i]));
    }

    int dim_;
    bool closed_;
    std::vector<double> steps_;
    std::vector<double> chords_, lengths_;
};

// Adds the parameters of a line; false if it has no length.
bool add(const std::vector<double> &lengths, std::vector<double> &params) {
    const double total = std::accumulate(lengths.begin(), lengths.end(), 0.0);
    if (!(total > 0)) {
        return false;
    }
    double sum = 0;
    for (size_t i = 0; i < lengths.size(); ++i) {
        sum += lengths[i];
        params[i + 1] += sum / total;
    }
    return true;
}

std::vector<double> of_axis(const PointGrid &grid, int k, ParameterRule rule, double exponent, double scale) {
    const auto at = static_cast<size_t>(k);
    const int64_t count = grid.counts[at];
    if (rule == ParameterRule::uniform || count < 2) {
        return even(count);
    }
    const GridLayers of = layers_of(grid, at);
    std::vector<double> params(static_cast<size_t>(count), 0.0);
    Line line(count, grid.dim, grid.periodic[at]);
    int64_t lines = 0;
    for (int64_t o = 0; o < of.outer; ++o) {
        for (int64_t i = 0; i < of.inner; i += grid.dim) {
            count_work(work_of_a_step * count);
            line.set(grid.points.data() + o * count * of.inner + i, of.inner, scale);
            lines += add(line.lengths(rule, exponent), params) ? 1 : 0;
        }
    }
    if (lines == 0) {
        fail(Status::length, "points: no line along axis %d has a length", k);
    }
    const double last = params.back();
    std::for_each(params.begin(), params.end(), [last](double &t) { t /= last; });
    return params;
}

// A power of two that makes all coordinates less than 1/4.
double scale_of(const std::vector<double> &points) noexcept {
    double largest = 0;
    for (const double x : points) {
        largest = std::max(largest, std::abs(x));
    }
    return largest > 0 ? std::ldexp(1.0, std::clamp(-std::ilogb(largest) - 3, -1022, 1022)) : 1;
}

} // namespace

GridLayers layers_of(const PointGrid &grid, size_t axis) noexcept {
    GridLayers layers{1, grid.counts[axis], grid.dim};
    for (size_t k = 0; k < grid.counts.size(); ++k) {
        (k < axis ? layers.outer : layers.inner) *= k == axis ? 1 : grid.counts[k];
    }
    return layers;
}

std::vector<double> parametrize(const PointGrid &grid, ParameterRule rule, double exponent) {
    std::vector<double> all;
    const double scale = scale_of(grid.points);
    for (int k = 0; k < static_cast<int>(grid.counts.size()); ++k) {
        const std::vector<double> params = of_axis(grid, k, rule, exponent, scale);
        all.insert(all.end(), params.begin(), params.end());
    }
    return all;
}

namespace {

// Whether a function over the knots still rises at t, which lies inside a span.
bool rises(const KnotVector &axis, int64_t function, double t) noexcept {
    const int p = axis.degree();
    const int64_t span = axis.find_span(t, false);
    const int64_t place = function - (span - p);
    if (place < 0 || place > p) {
        return place > p; // its support comes later
    }
    double values[2 * max_basis];
    basis_derivs(axis.knots().data(), p, span, t, 1, values);
    return values[p + 1 + place] > 0;
}

// A B-spline rises to its only maximum and falls after it.
double largest_at(const KnotVector &axis, int64_t function) noexcept {
    double lower = axis[function], upper = axis[function + axis.degree() + 1];
    for (;;) {
        const double middle = lower + (upper - lower) / 2;
        if (!(middle > lower && middle < upper)) {
            return middle;
        }
        (rises(axis, function, middle) ? lower : upper) = middle;
    }
}

} // namespace

std::vector<double> universal_params(int degree, int64_t count) {
    std::vector<double> knots(static_cast<size_t>(count + degree + 1));
    open_uniform_knots(degree, count, 0, 1, knots);
    const KnotVector axis(degree, std::move(knots));
    std::vector<double> params(static_cast<size_t>(count));
    for (int64_t i = 0; i < (count + 1) / 2; ++i) {
        count_work(work_of_a_step);
        // Away from the ends, and at low degrees, a function is symmetric.
        const double first = axis[i], last = axis[i + degree + 1];
        const bool symmetric = degree <= 1 || i >= degree || 2 * i + 1 == count;
        const double t = symmetric ? first + (last - first) / 2 : largest_at(axis, i);
        params[static_cast<size_t>(i)] = degree > 0 && i == 0 ? 0 : degree == 1 ? axis[i + 1] : t;
    }
    for (int64_t i = 0; i < count / 2; ++i) {
        params[static_cast<size_t>(count - 1 - i)] = 1 - params[static_cast<size_t>(i)];
    }
    return params;
}

} // namespace nrb::fit
