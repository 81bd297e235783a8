// SPDX-License-Identifier: MIT
#include "refine/compose/crossings.h"

#include "base/numbers.h"
#include "numeric/binomial.h"
#include "refine/algebra/derivative.h"
#include "refine/knots/blossom.h"
#include "refine/knots/blossom_rows.h"

#include <algorithm>
#include <cmath>

namespace nrb::refine {

CurvePiece::CurvePiece(const Spline &curve, int64_t span) : curve_(&curve), span_(span) {
    if (curve.rational()) {
        const Coefficients values = weights_between(lower(), upper());
        weights_.assign(values.begin(), values.begin() + degree() + 1);
    }
    for (int k = 0; k < curve.dim(); ++k) {
        const Coefficients values = coefficients_between(k, lower(), upper());
        coefficients_.insert(coefficients_.end(), values.begin(), values.begin() + degree() + 1);
        known_.push_back(known_of(k));
    }
}

namespace {

// The rows of a polar form with `to` as j of its arguments and `from` as the others, j = 0, ..., degree. If
// neither is a knot at an end of the span, all rows are computed together, with the bits of blossom_row().
class BernsteinRows {
public:
    BernsteinRows(const KnotVector &axis, int64_t span, double from, double to) noexcept
        : axis_(axis), span_(span) {
        const auto q = static_cast<size_t>(axis.degree());
        std::fill_n(arguments_.begin(), q, from);
        std::fill_n(arguments_.begin() + axis.degree(), q, to);
        together_ =
            q > 1 && axis[span] < from && to < axis[span + 1]; // knots as arguments would shorten rows
        if (together_) {
            const double *right = axis.knots().data() + span + 1;
            sliding_blossom_rows(axis.degree(), right, right, arguments_.data(), axis.degree() + 1,
                                 values_.data());
        }
    }
    // The row in which `to` occurs j times.
    [[nodiscard]] BlossomRow row(int j) const noexcept {
        const int q = axis_.degree();
        if (!together_) {
            return blossom_row(axis_, span_,
                               std::span(arguments_).subspan(static_cast<size_t>(j), static_cast<size_t>(q)));
        }
        BlossomRow row;
        row.first = span_ - q;
        row.size = q + 1;
        std::copy_n(values_.begin() + int64_t{j} * (q + 1), q + 1, row.coefficients);
        return row;
    }

private:
    const KnotVector &axis_;
    int64_t span_;
    bool together_ = false;
    std::array<double, 2 * max_basis> arguments_{};
    std::array<double, (max_basis + row_lanes) * max_basis> values_; // of all rows, if computed together
};

} // namespace

Coefficients CurvePiece::coefficients_between(int k, double from, double to) const noexcept {
    Coefficients values{};
    const BernsteinRows rows(curve_->axis(0), span_, from, to);
    for (int j = 0; j <= degree(); ++j) {
        values[static_cast<size_t>(j)] = value_of(rows.row(j), k);
    }
    return values;
}

Coefficients CurvePiece::weights_between(double from, double to) const noexcept {
    Coefficients values{};
    const BernsteinRows rows(curve_->axis(0), span_, from, to);
    for (int j = 0; j <= degree(); ++j) {
        values[static_cast<size_t>(j)] = weight_of(rows.row(j));
    }
    return values;
}

double CurvePiece::weight(int64_t i) const noexcept {
    return std::ldexp(curve_->weight(i), -std::ilogb(curve_->all_weights().largest));
}

double CurvePiece::weight_of(const BlossomRow &row) const noexcept {
    double sum = 0;
    for (int i = 0; i < row.size; ++i) {
        sum += row.coefficients[i] * weight(row.first + i);
    }
    return sum;
}

double CurvePiece::polar_weight(std::span<const double> arguments) const noexcept {
    return curve_->rational() ? weight_of(blossom_row(curve_->axis(0), span_, arguments)) : 1;
}

double CurvePiece::quotient(const BlossomRow &row, int k) const noexcept {
    if (row.size == 1) {
        return curve_->coordinate(row.first, k);
    }
    double sum = 0, weights = 0;
    for (int i = 0; i < row.size; ++i) {
        const double share = row.coefficients[i] * weight(row.first + i);
        sum += share * curve_->coordinate(row.first + i, k);
        weights += share;
    }
    return sum / weights;
}

double CurvePiece::value_of(const BlossomRow &row, int k) const noexcept {
    if (curve_->rational()) {
        return quotient(row, k);
    }
    const double *points = curve_->points().data() + row.first * curve_->dim() + k;
    double value = 0;
    for (int i = 0; i < row.size; ++i) {
        value += row.coefficients[i] * points[int64_t{i} * curve_->dim()];
    }
    return value;
}

double CurvePiece::polar_value(int k, std::span<const double> arguments) const noexcept {
    return value_of(blossom_row(curve_->axis(0), span_, arguments), k);
}

double CurvePiece::value(int k, double t) const noexcept {
    Coefficients arguments{};
    arguments.fill(t);
    return polar_value(k, std::span(arguments).first(static_cast<size_t>(degree())));
}

// Magnitudes are multiplied by eps before anything can overflow; t / length is at most 1 / eps.
CurvePiece::Known CurvePiece::known_of(int k) const {
    const int q = degree();
    const Interval eps_range = eps_times_range(k);
    const double eps_largest = std::max(-eps_range.lower, eps_range.upper);
    const double rounding = (curve_->rational() ? 8 * (q + 2) : 4 * (q + 1)) * eps_largest;
    const Known known{rounding, rounding + eps_times_slope(k, 0)};
    if (curve_->rational() && eps * eps_times_slope(k, 2) > (eps_range.upper - eps_range.lower) / 4) {
        fail(Status::not_representable,
             "coordinate %d between t = %s and %s is too steep, by weights that differ so much: no parameter "
             "tells where in its range it is",
             k, Number(lower()).text, Number(upper()).text);
    }
    if (!std::isfinite(known.uncertainty)) {
        fail(Status::not_representable,
             "coordinate %d between t = %s and %s is too steep: the uncertainty of its values overflows", k,
             Number(lower()).text, Number(upper()).text);
    }
    return known;
}

// eps times the range of the coordinate over the active control points.
Interval CurvePiece::eps_times_range(int k) const noexcept {
    Interval range{HUGE_VAL, -HUGE_VAL};
    for (int64_t i = span_ - degree(); i <= span_; ++i) {
        const double x = eps * curve_->coordinate(i, k);
        range = {std::min(range.lower, x), std::max(range.upper, x)};
    }
    return range;
}

// A bound of eps |t| |F'|, the maximum over the control points of what their differences contribute. With
// weights, F' is the sum of q N_i (w_(i+1) (F_(i+1) - F) - w_i (F_i - F)) / (t_(i+q+1) - t_(i+1)), divided by
// the weight, where the N_i have degree q - 1 and F lies among the F_i. So the differences are bounded by the
// range of the F_i times (w_i + w_(i+1)) / min w. For equal weights this factor is 2; `even` is subtracted
// from it.
double CurvePiece::eps_times_slope(int k, double even) const noexcept {
    const KnotVector &axis = curve_->axis(0);
    const int q = axis.degree();
    const double t = std::max(std::fabs(lower()), std::fabs(upper()));
    const Interval eps_range = eps_times_range(k);
    double least = curve_->weight(span_), slope = 0;
    for (int64_t i = span_ - q; i < span_; ++i) {
        least = std::min(least, curve_->weight(i));
    }
    for (int64_t i = span_ - q; i < span_; ++i) {
        const double length = axis[i + q + 1] - axis[i + 1];
        const double ratios = curve_->weight(i) / least + curve_->weight(i + 1) / least - even;
        const double eps_step = eps * curve_->coordinate(i + 1, k) - eps * curve_->coordinate(i, k);
        const double way =
            curve_->rational() ? ratios * (eps_range.upper - eps_range.lower) : std::fabs(eps_step);
        slope = std::max(slope, q * way * (t / length));
    }
    return slope;
}

double CurvePiece::uncertainty_at(int k, double t) const noexcept {
    const KnotVector &axis = curve_->axis(0);
    const int q = axis.degree();
    const bool stored =
        q == 0 || (t == lower() && axis[span_ - q + 1] == t) || (t == upper() && axis[span_ + q] == t);
    return stored ? rounding(k) : uncertainty(k);
}

namespace {

// The signs of coordinate k minus c over a part of the piece, given its Bernstein coefficients and weights
// there.
SignProfile profile_of(const CurvePiece &piece, int k, double c, double uncertainty,
                       std::span<const double> values, std::span<const double> weights, Interval part) {
    UncertainNet<max_basis> net{piece.degree(), uncertainty, !weights.empty()};
    for (size_t j = 0; j < values.size(); ++j) {
        net.values[j] = values[j] - c;
        if (!weights.empty()) {
            net.values[j] *= weights[j];
            net.weights[j] = weights[j];
        }
    }
    return signs_between(part.lower, part.upper, net,
                         [&piece, k, c](double t) { return piece.value(k, t) - c; });
}

// Whether a jump between two pieces does not go against the direction of the curve.
bool continues(const CurvePiece &before, const CurvePiece &piece, bool rising) noexcept {
    const double from = before.coefficients(0).back(), to = piece.coefficients(0).front();
    const double slack = std::max(before.uncertainty(0), piece.uncertainty(0));
    return rising ? to >= from - slack : to <= from + slack;
}

} // namespace

SignProfile sign_profile(const CurvePiece &piece, int k, double c) {
    return profile_of(piece, k, c, piece.uncertainty(k), piece.coefficients(k), piece.weights(),
                      {piece.lower(), piece.upper()});
}

bool lies_above(const CurvePiece &piece, int k, double c, Interval part) {
    const double middle = piece.value(k, part.lower + (part.upper - part.lower) / 2);
    if (std::fabs(middle - c) > piece.uncertainty(k)) {
        return middle > c;
    }
    const Coefficients values = piece.coefficients_between(k, part.lower, part.upper);
    const size_t size = piece.coefficients(k).size();
    Coefficients weights{};
    if (!piece.weights().empty()) {
        weights = piece.weights_between(part.lower, part.upper);
    }
    for (const double uncertainty : {piece.uncertainty(k), piece.rounding(k)}) {
        const SignProfile profile = profile_of(piece, k, c, uncertainty, std::span(values).first(size),
                                               std::span(weights).first(piece.weights().size()), part);
        if (profile.below || profile.above) {
            return profile.below && profile.above ? middle >= c : profile.above;
        }
    }
    return true;
}

namespace {

// The signs of the derivative of a one-dimensional rational curve. From B_i' B_j - B_i B_j' = (i - j) B_i B_j
// / (t (1 - t)), the numerator of the derivative has the Bernstein coefficients
//
//     sum over i + j = k + 1, i < j, of
//         (j - i) binomial(q, i) binomial(q, j) / binomial(2 q - 2, k) w_i w_j (F_j - F_i),
//
// which no translation of the F_i changes.
SignProfile quotient_slope(const CurvePiece &piece) {
    constexpr size_t size = 2 * max_basis;
    const std::span<const double> points = piece.coefficients(0), weights = piece.weights();
    const int q = piece.degree(), degree = std::max(2 * q - 2, 0);
    UncertainNet<size> net{degree, 2 * piece.rounding(0), true};
    for (int i = 0; i <= q; ++i) {
        for (int j = i + 1; j <= q; ++j) {
            const auto a = static_cast<size_t>(i), b = static_cast<size_t>(j), k = a + b - 1;
            const double size_of_term = (j - i) * (binomial(q, i) / binomial(degree, i + j - 1)) *
                                        binomial(q, j) * weights[a] * weights[b];
            net.values[k] += size_of_term * (points[b] - points[a]);
            net.weights[k] += size_of_term;
        }
    }
    const auto any = [](double) { return 0.0; }; // the places of zeros are not needed
    return signs_between(piece.lower(), piece.upper(), net, any);
}

// Calls check(signs of the derivative) for one piece after another, until it returns false.
template <class Check>
bool all_slopes(const SplinePtr &curve, Check check) {
    const SplinePtr slope = curve->rational() ? curve : polynomial_derivative(curve, 0, 1);
    const std::span<const int64_t> spans = slope->axis(0).spans().indices();
    return std::all_of(spans.begin(), spans.end(), [&](int64_t span) {
        const CurvePiece piece(*slope, span);
        return check(curve->rational() ? quotient_slope(piece) : sign_profile(piece, 0, 0));
    });
}

} // namespace

bool strictly_monotone(const SplinePtr &curve) {
    bool below = false, above = false;
    const bool moving = all_slopes(curve, [&](const SignProfile &profile) {
        below = below || profile.below;
        above = above || profile.above;
        return profile.below != profile.above;
    });
    if (!moving) {
        return false;
    }
    const std::span<const int64_t> spans = curve->axis(0).spans().indices();
    for (size_t i = 1; i < spans.size(); ++i) {
        if (!continues(CurvePiece(*curve, spans[i - 1]), CurvePiece(*curve, spans[i]), above)) {
            return false;
        }
    }
    return below != above;
}

} // namespace nrb::refine
