// SPDX-License-Identifier: MIT
#include "fit/parameters.h"

#include "base/error.h"
#include "base/finite.h"
#include "base/small_width.h"
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

// Uniform parameters i / (count - 1), rounded once: what exact sums of equal steps would give.
std::vector<double> even(int64_t count) {
    std::vector<double> params(static_cast<size_t>(count), 0.0);
    for (int64_t i = 1; i < count; ++i) {
        params[static_cast<size_t>(i)] = static_cast<double>(i) / static_cast<double>(count - 1);
    }
    return params;
}

// The angle between two steps, from their unit vectors by W. Kahan's formula, which is accurate at all
// angles.
template <class A, class B>
double angle_between(A &&a, double a_length, B &&b, double b_length, int dim) noexcept {
    const auto sum = norm_of(dim, [&](int c) { return a(c) / a_length + b(c) / b_length; });
    const auto difference = norm_of(dim, [&](int c) { return a(c) / a_length - b(c) / b_length; });
    return 2 * std::atan2(difference, sum);
}

// The steps between the points of one line of the grid, which are `stride` doubles apart. The scale keeps
// chord lengths from overflowing.
struct Line {
    const double *points;
    int64_t stride;
    int dim;
    bool closed;
    double scale;

    [[nodiscard]] double step(size_t i, int c) const noexcept {
        const double *const point = points + static_cast<int64_t>(i) * stride;
        return point[stride + c] * scale - point[c] * scale;
    }
};

// The factor by which the turning angles at its ends lengthen a step of a line (T. Foley, G. Nielson, "Knot
// selection for parametric spline interpolation", in: Mathematical Methods in Computer Aided Geometric
// Design, 1989), with Euclidean chord lengths.
class Turning {
public:
    Turning(const Line &line, std::span<const double> chords) : line_(line), chords_(chords) {}

    [[nodiscard]] double operator()(size_t i) const noexcept {
        const size_t n = chords_.size();
        const bool before = line_.closed || i > 0, after = line_.closed || i + 1 < n;
        return 1 + 1.5 * ((before ? part(i, (i + n - 1) % n) : 0) + (after ? part(i, (i + 1) % n) : 0));
    }

private:
    // The contribution of the angle between a step and its neighbour: the turning angle, pi minus the inner
    // angle, but at most pi / 2, times the share of the neighbour in both chords.
    [[nodiscard]] double part(size_t i, size_t beside) const noexcept {
        if (!(chords_[beside] > 0)) {
            return 0;
        }
        const auto step = [&](size_t at) { return [this, at](int c) { return line_.step(at, c); }; };
        const double turn = angle_between(step(i), chords_[i], step(beside), chords_[beside], line_.dim);
        return std::min(turn, std::numbers::pi / 2) * (chords_[beside] / (chords_[beside] + chords_[i]));
    }

    const Line &line_;
    std::span<const double> chords_;
};

// Turns chord lengths into the lengths of the rule, in units of the largest chord so that no rule leaves the
// range of doubles.
void apply(ParameterRule rule, double exponent, double largest, const Line &line, std::span<double> chords) {
    const auto replace = [&](auto &&length) { std::ranges::transform(chords, chords.begin(), length); };
    switch (rule) {
    case ParameterRule::centripetal:
        return replace([=](double chord) { return std::sqrt(chord / largest); });
    case ParameterRule::power:
        return replace([=](double chord) { return chord > 0 ? std::pow(chord / largest, exponent) : 0; });
    case ParameterRule::foley_nielson: {
        const std::vector<double> own(chords.begin(), chords.end());
        const Turning turning(line, own);
        for (size_t i = 0; i < own.size(); ++i) {
            chords[i] = own[i] > 0 ? own[i] / largest * turning(i) : 0;
        }
        return;
    }
    default:
        return replace([=](double chord) { return chord / largest; });
    }
}

// Adds the parameters of a line to `params`; `room` is for its chord lengths. False if the line has no
// length.
bool add(const Line &line, ParameterRule rule, double exponent, std::span<double> room,
         std::span<double> params) {
    with_width(line.dim, [&](auto dim) {
        norms_of(
            dim, [&](size_t i, int c) { return line.step(i, c); }, room);
    });
    const double largest = largest_magnitude(room);
    if (!(largest > 0)) {
        return false;
    }
    apply(rule, exponent, largest, line, room);
    std::partial_sum(room.begin(), room.end(), room.begin());
    const double total = room.back();
    for (size_t i = 0; i < room.size(); ++i) {
        params[i + 1] += room[i] / total;
    }
    return true;
}

std::vector<double> of_axis(const GridShape &grid, std::span<const double> points, size_t k,
                            ParameterRule rule, double exponent, double scale) {
    const int64_t count = grid.counts[k];
    if (rule == ParameterRule::uniform || count < 2) {
        return even(count);
    }
    const GridLayers of = layers_of(grid, k);
    std::vector<double> params(static_cast<size_t>(count), 0.0), room(static_cast<size_t>(count - 1));
    int64_t lines = 0;
    for (int64_t o = 0; o < of.outer; ++o) {
        for (int64_t i = 0; i < of.inner; i += grid.dim) {
            count_work(work_of_a_step * count);
            const double *const first = points.data() + o * count * of.inner + i;
            const Line line{first, of.inner, grid.dim, grid.periodic[k], scale};
            lines += add(line, rule, exponent, room, params) ? 1 : 0;
        }
    }
    if (lines == 0) {
        fail(Status::length, "points: no line along axis %zu has a length", k);
    }
    if (const double last = params.back(); last != 1) {
        std::ranges::for_each(params, [last](double &t) { t /= last; });
    }
    return params;
}

// A power of two that scales all coordinates to less than 1/4, as far as normal powers of two reach.
double scale_of(std::span<const double> points) noexcept {
    const double largest = largest_magnitude(points);
    return largest > 0 ? std::ldexp(1.0, std::clamp(-std::ilogb(largest) - 3, -1022, 1022)) : 1;
}

} // namespace

GridLayers layers_of(const GridShape &grid, size_t axis) noexcept {
    GridLayers layers{1, grid.counts[axis], grid.dim};
    for (size_t k = 0; k < grid.counts.size(); ++k) {
        (k < axis ? layers.outer : layers.inner) *= k == axis ? 1 : grid.counts[k];
    }
    return layers;
}

std::vector<double> parametrize(const GridShape &grid, std::span<const double> points, ParameterRule rule,
                                double exponent) {
    const double scale = scale_of(points);
    std::vector<double> all = of_axis(grid, points, 0, rule, exponent, scale);
    for (size_t k = 1; k < grid.counts.size(); ++k) {
        const std::vector<double> params = of_axis(grid, points, k, rule, exponent, scale);
        all.insert(all.end(), params.begin(), params.end());
    }
    return all;
}

namespace {

// Whether a basis function still increases at t, which lies inside a span.
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

// The place of the maximum, by bisection: a B-spline increases up to its only maximum and decreases after it.
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
        // Away from the ends, and at degrees up to 1, a basis function is symmetric about the middle of its
        // support.
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
