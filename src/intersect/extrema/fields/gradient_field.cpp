// SPDX-License-Identifier: MIT
#include "intersect/extrema/fields/gradient_field.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "spline/axis_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nrb::intersect {

namespace {

constexpr int64_t most_kept_values = 1 << 22;
constexpr int64_t work_of_a_piece = 8000;

RoundedPolynomial slope_of(const pieces::HomogeneousPiece &piece, const ConstantLayers &constants, int axes,
                           int k) {
    RoundedPolynomial slope = pieces::tangent_numerator(piece, k);
    for (double &error : slope.errors) {
        error += underflow;
    }
    for (int l = 0; l < axes; ++l) {
        for (const bool upper : {false, true}) {
            const int layers = constants.layers[static_cast<size_t>(l)][upper ? 1 : 0];
            set_zero(slope, piece.axis(l), upper, l == k ? layers - 1 : layers);
        }
    }
    return slope;
}

} // namespace

GradientField::GradientField(const Spline &spline) : spline_(spline), maker_(spline, whole_domain(spline)) {
    for (int k = 0; k < axes(); ++k) {
        const auto at = static_cast<size_t>(k);
        for (int64_t i = 0; i < count(k); ++i) {
            spans_[at].push_back(axis(k).find_span(parameter(k, i), false));
        }
        for (int64_t i = 0; i <= count(k); ++i) {
            joints_[at].push_back(joint_of(k, i));
        }
    }
}

JointKind GradientField::joint_of(int k, int64_t i) const {
    const KnotVector &knots = axis(k);
    if (!knots.periodic() && (i == 0 || i == count(k))) {
        return JointKind::end;
    }
    const int p = knots.degree(), m = multiplicity(knots.knots(), parameter(k, i % count(k)));
    if (m < p) {
        return JointKind::smooth;
    }
    const std::vector<int64_t> &spans = spans_[static_cast<size_t>(k)];
    const int64_t left = spans[static_cast<size_t>(beside(k, i, false))],
                  right = spans[static_cast<size_t>(beside(k, i, true))] - p;
    return m == p || continuous(k, left, right) ? JointKind::kink : JointKind::jump;
}

// Whether two layers of control points are the same.
bool GradientField::continuous(int k, int64_t left, int64_t right) const noexcept {
    const AxisView view = axis_view(spline_, k, 1);
    const auto width = static_cast<size_t>(spline_.stored_width());
    for (int64_t o = 0; o < view.outer; ++o) {
        for (int64_t i = 0; i < view.inner; ++i) {
            const auto a = static_cast<size_t>((o * view.count + left) * view.inner + i),
                       b = static_cast<size_t>((o * view.count + right) * view.inner + i);
            const auto first = spline_.points().subspan(a * width, width),
                       second = spline_.points().subspan(b * width, width);
            const bool weights =
                spline_.form() != Form::rational || spline_.weights()[a] == spline_.weights()[b];
            if (!weights || !std::ranges::equal(first, second)) {
                return false;
            }
        }
    }
    return true;
}

ConstantLayers GradientField::constants(const PieceIndex &index, const Sides &sides) const {
    std::array<int64_t, max_axes> spans{};
    for (size_t k = 0; k < static_cast<size_t>(axes()); ++k) {
        spans[k] = spans_[k][static_cast<size_t>(index[k])];
    }
    return constant_layers(spline_, spans, sides);
}

Interval GradientField::parameters(int k, int64_t i, Interval places) const noexcept {
    const double from = parameter(k, i), to = parameter(k, i + 1);
    const double off = 4 * eps * std::max(std::abs(from), std::abs(to));
    const auto at = [&](double place) { return place == 1 ? to : from + place * (to - from); };
    const Interval range{at(places.lower) - (places.lower == 0 ? 0 : off),
                         at(places.upper) + (places.upper == 1 ? 0 : off)};
    const Interval domain = axis(k).domain();
    return axis(k).periodic()
               ? range
               : Interval{std::max(range.lower, domain.lower), std::min(range.upper, domain.upper)};
}

int64_t GradientField::piece_at(int k, double parameter) const noexcept {
    const std::vector<double> &breaks = maker_.breaks(k);
    return std::clamp<int64_t>(std::ranges::upper_bound(breaks, parameter) - breaks.begin() - 1, 0,
                               count(k) - 1);
}

int64_t GradientField::number(const PieceIndex &index) const noexcept {
    int64_t at = 0;
    for (int k = 0; k < axes(); ++k) {
        at = at * count(k) + index[static_cast<size_t>(k)];
    }
    return at;
}

GradientPiecePtr GradientField::piece(const PieceIndex &index) const {
    const int64_t at = number(index);
    if (const auto found = kept_.find(at); found != kept_.end()) {
        return found->second;
    }
    GradientPiecePtr piece = made(index, at);
    const int64_t values = axes() * 4 * std::ssize(piece->slopes.front().values);
    if (kept_values_ + values > most_kept_values) {
        kept_.clear();
        kept_values_ = 0;
    }
    kept_values_ += values;
    kept_.emplace(at, piece);
    return piece;
}

GradientPiecePtr GradientField::made(const PieceIndex &index, int64_t at) const {
    count_work(work_of_a_piece);
    GradientPiece result{maker_.piece(at), {}, 0, constants(index)};
    result.exponent = result.piece.exponent + 2 * result.piece.weight_exponent;
    for (int k = 0; k < axes(); ++k) {
        result.slopes.push_back(slope_of(result.piece, result.constants, axes(), k));
    }
    return std::make_shared<const GradientPiece>(std::move(result));
}

} // namespace nrb::intersect
