// SPDX-License-Identifier: MIT
#include "fit/tangents.h"

#include "base/watch.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>

namespace nrb::fit {

namespace {

constexpr int64_t work_of_a_tangent = 32;

// The parameter steps and the slopes of the chords, with two more beyond either end: those of the other end
// if the data are closed, else slopes extrapolated along a parabola (H. Akima, J. ACM 17 (1970)).
class Slopes {
public:
    Slopes(std::span<const double> params, int dim, std::span<const double> points, bool closed)
        : dim_(dim), chords_(std::ssize(params) - 1), steps_(params.size() + 3),
          slopes_(steps_.size() * static_cast<size_t>(dim)) {
        for (int64_t i = 0; i < chords_; ++i) {
            const auto at = static_cast<size_t>(i);
            step(i) = params[at + 1] - params[at];
            const double *const from = points.data() + i * dim;
            for (int c = 0; c < dim; ++c) {
                slope(i)[c] = (from[dim + c] - from[c]) / step(i);
            }
        }
        for (const int64_t i : {-1, -2}) {
            extend(i, closed ? (i + 2 * chords_) % chords_ : i, 1);
        }
        for (const int64_t i : {chords_, chords_ + 1}) {
            extend(i, closed ? i % chords_ : i, -1);
        }
    }

    [[nodiscard]] double step(int64_t i) const noexcept { return steps_[static_cast<size_t>(i + 2)]; }
    // The slope of the chord from point i to the next, -2 <= i <= n.
    [[nodiscard]] const double *slope(int64_t i) const noexcept { return slopes_.data() + (i + 2) * dim_; }

private:
    double &step(int64_t i) noexcept { return steps_[static_cast<size_t>(i + 2)]; }
    double *slope(int64_t i) noexcept { return slopes_.data() + (i + 2) * dim_; }

    // Makes chord i a copy of another one, or extrapolates it from the two after it (inside = 1) or before it
    // (-1).
    void extend(int64_t i, int64_t copy, int inside) noexcept {
        const int64_t near = i + inside, far = chords_ > 1 ? i + 2 * inside : near;
        step(i) = step(copy != i ? copy : near);
        for (int c = 0; c < dim_; ++c) {
            slope(i)[c] = copy != i ? slope(copy)[c] : 2 * slope(near)[c] - slope(far)[c];
        }
    }

    int dim_;
    int64_t chords_;
    std::vector<double> steps_;
    std::vector<double> slopes_;
};

// The derivative of the parabola through three points, at the middle one.
double parabola(double before, double h_before, double after, double h_after) noexcept {
    return before * (h_after / (h_before + h_after)) + after * (h_before / (h_before + h_after));
}

// The weighted harmonic mean of slopes of equal sign, else 0 (F. Fritsch, J. Butland, SIAM J. Sci. Stat.
// Comput. 5 (1984)). It is at most three times the smaller slope, which makes a cubic monotone (C. de Boor,
// B. Swartz, J. Approx. Theory 21 (1977)). It is reduced a little, so that rounding cannot exceed that limit.
double harmonic(double before, double h_before, double after, double h_after) noexcept {
    constexpr double less = 1 - 0x1p-40;
    if (!((before > 0 && after > 0) || (before < 0 && after < 0))) {
        return 0;
    }
    const double share = (2 * h_after + h_before) / (3 * (h_before + h_after));
    const double low = std::min(std::abs(before), std::abs(after)),
                 high = std::max(std::abs(before), std::abs(after));
    const double of_low = std::abs(before) <= std::abs(after) ? share : 1 - share;
    return std::copysign(less * (low / (of_low + (1 - of_low) * (low / high))), before);
}

// At an end of open data, from its chord and the next one: the derivative of the parabola, limited so that
// the cubic stays monotone.
double monotone_end(double own, double h_own, double next, double h_next) noexcept {
    const double wanted = own + (own - next) * (h_own / (h_own + h_next));
    if (!(own > 0 ? wanted > 0 : wanted < 0)) {
        return 0;
    }
    const double most = 3 * (1 - 0x1p-40) * std::abs(own);
    return std::copysign(std::min(std::abs(wanted), most), own);
}

class TangentMaker {
public:
    TangentMaker(TangentRule rule, const Slopes &slopes, int64_t n, int dim, bool closed)
        : rule_(rule), slopes_(slopes), last_(n - 1), dim_(dim), closed_(closed) {}

    void write(int64_t i, double *tangent) const noexcept {
        const bool start = !closed_ && i == 0, end = !closed_ && i == last_;
        if (rule_ == TangentRule::akima) {
            return akima(i, tangent);
        }
        if (start || end) {
            return at_end(start ? 0 : last_ - 1, start ? 1 : last_ - 2, tangent);
        }
        const double *const before = slopes_.slope(i - 1), *const after = slopes_.slope(i);
        const double h_before = slopes_.step(i - 1), h_after = slopes_.step(i);
        for (int c = 0; c < dim_; ++c) {
            tangent[c] = rule_ == TangentRule::catmull_rom ? parabola(before[c], h_after, after[c], h_before)
                         : rule_ == TangentRule::bessel    ? parabola(before[c], h_before, after[c], h_after)
                                                           : harmonic(before[c], h_before, after[c], h_after);
        }
    }

private:
    void at_end(int64_t own, int64_t next, double *tangent) const noexcept {
        next = std::clamp<int64_t>(next, 0, last_ - 1);
        const double *const slope = slopes_.slope(own), *const other = slopes_.slope(next);
        const double h = slopes_.step(own), h_next = slopes_.step(next);
        for (int c = 0; c < dim_; ++c) {
            tangent[c] = rule_ == TangentRule::catmull_rom ? slope[c]
                         : rule_ == TangentRule::bessel
                             ? slope[c] + (slope[c] - other[c]) * (h / (h + h_next))
                             : monotone_end(slope[c], h, other[c], h_next);
        }
    }

    // The weighted mean of the slopes beside the point; the slope that changes less on its own side counts
    // more.
    void akima(int64_t i, double *tangent) const noexcept {
        const double *const before = slopes_.slope(i - 1), *const after = slopes_.slope(i);
        const double change_before = distance(before, slopes_.slope(i - 2), dim_);
        const double change_after = distance(slopes_.slope(i + 1), after, dim_);
        const double largest = std::max(change_before, change_after);
        const double a = largest > 0 ? change_after / largest : 1,
                     b = largest > 0 ? change_before / largest : 1;
        for (int c = 0; c < dim_; ++c) {
            tangent[c] = before[c] * (a / (a + b)) + after[c] * (b / (a + b));
        }
    }

    TangentRule rule_;
    const Slopes &slopes_;
    int64_t last_;
    int dim_;
    bool closed_;
};

} // namespace

std::vector<double> tangents_of(TangentRule rule, std::span<const double> params, int dim,
                                std::span<const double> points, bool closed) {
    const Slopes slopes(params, dim, points, closed);
    const TangentMaker maker(rule, slopes, std::ssize(params), dim, closed);
    std::vector<double> tangents(points.size());
    for (int64_t i = 0; i < std::ssize(params); ++i) {
        count_work(work_of_a_tangent * dim);
        maker.write(i, tangents.data() + i * dim);
    }
    return tangents;
}

} // namespace nrb::fit
