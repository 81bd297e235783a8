// SPDX-License-Identifier: MIT
// The power spans and Bernstein spans of a curve, and which spans have them.
#include "base/finite.h"
#include "base/numbers.h"
#include "base/watch.h"
#include "basis/bernstein_span.h"
#include "spline/spline.h"

#include <algorithm>
#include <cmath>

namespace nrb::inline spline {

namespace {

constexpr int64_t work_of_a_lerp = 40; // in double-double arithmetic

} // namespace

bool Spline::even(WeightRange range) noexcept {
    constexpr double largest_ratio = 4;
    return range.smallest > 0 && range.largest <= largest_ratio * range.smallest;
}

Spline::WeightRange Spline::weight_range(int64_t first, int64_t count) const noexcept {
    if (form_ == Form::polynomial) {
        return {};
    }
    if (form_ == Form::rational) {
        const auto [smallest, largest] =
            extremes(weights().subspan(static_cast<size_t>(first), static_cast<size_t>(count)));
        return {smallest, largest};
    }
    const int64_t step = weight_step();
    const double *at = weight_data() + first * step;
    WeightRange range{*at, *at};
    for (int64_t i = 1; i < count; ++i) {
        range.smallest = std::min(range.smallest, at[i * step]);
        range.largest = std::max(range.largest, at[i * step]);
    }
    return range;
}

bool Spline::has_power_span(int64_t span) const noexcept {
    const int degree = axis(0).degree();
    return axis(0).has_power_span(span) && (even_weights_ || even(weight_range(span - degree, degree + 1))) &&
           (moderate_.load(std::memory_order_relaxed) || moderate_window(span));
}

// moderate() of the whole curve implies this for every window. So the choice of method for a span does not
// depend on whether moderate() has been evaluated.
bool Spline::moderate_window(int64_t span) const noexcept {
    return window_below(span, moderate_limit, moderate_product);
}

// Whether the coordinates of a window's points, and their products with the weights, are below the limits.
// Points of weight 0 have no influence and are ignored.
bool Spline::window_below(int64_t span, double points, double products) const noexcept {
    bool below = true;
    for (int64_t i = span - axis(0).degree(); i <= span; ++i) {
        const double weight = form_ == Form::rational ? scaled_weight(i) : 1;
        for (int c = 0; c < stored_width() && weight != 0; ++c) {
            const double value = std::abs(points_[static_cast<size_t>(i * stored_width() + c)]);
            below = below && value < points && weight * value < products;
        }
    }
    return below;
}

// Copies the points of a span, [degree + 1][lanes], and the weights that they are to be multiplied by.
void Spline::copy_window(int64_t span, int lanes, double *weights, double *points) const noexcept {
    const int degree = axis(0).degree();
    for (int j = 0; j <= degree; ++j) {
        const int64_t i = span - degree + j;
        double *point = points + static_cast<int64_t>(j) * lanes;
        std::fill(std::copy_n(points_.data() + i * stored_width(), stored_width(), point), point + lanes,
                  0.0);
        if (form_ != Form::homogeneous && dim_ < lanes) {
            point[dim_] = 1;
        }
        weights[j] = form_ == Form::rational ? scaled_weight(i) : 1;
    }
}

// The power span of the curve from that of the basis functions. points: working memory, [degree + 1][lanes].
void Spline::combine(int64_t span, const double *basis, const double *rests, double *points,
                     double *power_span) const noexcept {
    const int degree = axis(0).degree();
    const int lanes = PowerSpan::lanes(width());
    double weights[max_power_span_degree + 1];
    copy_window(span, lanes, weights, points);
    std::copy_n(basis, static_cast<int>(PowerSpan::head_size), power_span);
    combine_power_spans(basis, rests, degree, weights, points, lanes, power_span + PowerSpan::head_size);
}

void Spline::low_power_span_of(int64_t span, double *points, double *power_span) const noexcept {
    const int lanes = PowerSpan::lanes(width());
    double weights[max_blossom_degree + 1];
    copy_window(span, lanes, weights, points);
    low_power_span(axis(0).knots().data(), axis(0).degree(), span, weights, points, lanes, power_span);
}

void Spline::curve_power_span(int64_t span, double *points, double *power_span) const noexcept {
    if (axis(0).degree() <= max_blossom_degree) {
        low_power_span_of(span, points, power_span);
        return;
    }
    double basis[max_basis_power_span];
    double rests[max_basis_power_span];
    double *const power_spans[1] = {basis};
    double *const low[1] = {rests};
    basis_power_spans(axis(0).knots().data(), axis(0).degree(), &span, 1, power_spans, low);
    combine(span, basis, rests, points, power_span);
}

bool Spline::has_bernstein_span(int64_t span) const noexcept {
    constexpr double shortest = 0x1p-900, longest = 0x1p900, largest = 0x1p960;
    const KnotVector &knots = axis(0);
    const int degree = knots.degree();
    const double length = knots[span + 1] - knots[span];
    const double extent = knots[span + degree] - knots[span + 1 - degree];
    return degree >= 1 && dim_ < span_lanes() && length >= shortest && extent <= longest &&
           weight_range(span - degree, degree + 1).smallest >= 0 && window_below(span, largest, largest);
}

void Spline::curve_bernstein_span(int64_t span, double *points, double *bernstein_span) const noexcept {
    double weights[max_degree + 1];
    const int lanes = span_lanes();
    copy_window(span, lanes, weights, points);
    make_bernstein_span(axis(0).knots().data(), axis(0).degree(), span, weights, points, lanes,
                        bernstein_span);
}

void Spline::fill_power_spans(PowerSpans &power_spans, std::vector<double> &points) const {
    static_cast<void>(moderate()); // then no window has to be examined
    const SpanTable &spans = axis(0).spans();
    const int degree = axis(0).degree();
    if (degree <= max_blossom_degree) {
        for (int64_t e = 0; e < spans.size(); ++e) {
            const int64_t span = spans.indices()[static_cast<size_t>(e)];
            count_work(int64_t{degree + 1} * (degree + 1) * (degree + 1));
            if (has_power_span(span)) {
                low_power_span_of(span, points.data(), power_spans[e]);
            }
        }
        return;
    }
    double basis[most_power_spans_together][max_basis_power_span];
    double rests[most_power_spans_together][max_basis_power_span];
    double *together[most_power_spans_together];
    double *low[most_power_spans_together];
    for (int l = 0; l < most_power_spans_together; ++l) {
        together[l] = basis[l];
        low[l] = rests[l];
    }
    for (int64_t first = 0; first < spans.size(); first += power_spans_together()) {
        const auto count = static_cast<int>(std::min<int64_t>(power_spans_together(), spans.size() - first));
        const int64_t *indices = spans.indices().data() + first;
        count_work(count * int64_t{degree + 1} * (degree + 1) * (degree + 1));
        basis_power_spans(axis(0).knots().data(), degree, indices, count, together, low);
        for (int l = 0; l < count; ++l) {
            if (has_power_span(indices[l])) {
                combine(indices[l], basis[l], rests[l], points.data(), power_spans[first + l]);
            }
        }
    }
}

PowerSpans Spline::curve_power_spans() const {
    const SpanTable &spans = axis(0).spans();
    const int degree = axis(0).degree();
    PowerSpans power_spans(spans.size(), PowerSpan::head_size + int64_t{degree + 1} * span_lanes());
    std::vector<double> points(static_cast<size_t>((degree + 1) * span_lanes()));
    for (int64_t e = 0; e < spans.size(); ++e) {
        std::fill_n(power_spans[e], static_cast<int>(PowerSpan::head_size), nan_value);
    }
    if (power_span_degree(degree)) {
        fill_power_spans(power_spans, points);
    }
    for (int64_t e = 0; e < spans.size(); ++e) {
        const int64_t span = spans.indices()[static_cast<size_t>(e)];
        if (std::isnan(power_spans[e][PowerSpan::lower]) && has_bernstein_span(span)) {
            count_work(work_of_a_lerp * (degree + 1) * (degree + 1) * span_lanes());
            curve_bernstein_span(span, points.data(), power_spans[e]);
        }
    }
    return power_spans;
}

// The largest table, in doubles, for a degree too high for power spans. Most are much smaller.
constexpr int64_t most_doubles = int64_t{1} << 24;

const PowerSpans *Spline::power_spans_after(int64_t uses) const {
    const int degree = axis(0).degree();
    const bool wanted =
        power_span_degree(degree) || (degree > 0 && count(0) <= most_doubles / ((degree + 2) * span_lanes()));
    if (power_spans_.peek() != nullptr || (wanted && uses_.pay(uses, count(0) / 3))) {
        return &power_spans_.get([this] { return curve_power_spans(); });
    }
    return nullptr;
}

} // namespace nrb::inline spline
