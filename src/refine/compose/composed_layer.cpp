// SPDX-License-Identifier: MIT
#include "refine/compose/composed_layer.h"

#include "base/watch.h"
#include "numeric/binomial.h"
#include "spline/contract.h"

#include <algorithm>

namespace nrb::refine {

namespace {

constexpr int64_t work_of_a_term = 100; // for each component: one contraction, one compensated sum

} // namespace

ComposedLayer::ComposedLayer(const Spline &g, const Spline &f, const std::vector<CurvePiece> &pieces,
                             const Spline::Axes &axes)
    : g_(g), f_(f), pieces_(pieces), axes_(axes), weighted_(f.rational()) {
    int64_t length = g.width();
    for (int k = g.axes(); k-- > 0;) {
        lengths_[static_cast<size_t>(k)] = length;
        parts_[static_cast<size_t>(k)].resize(static_cast<size_t>(length));
        length *= g.axis(k).degree() + 1;
    }
    sums_.resize(static_cast<size_t>(g.width()));
    record_.resize(static_cast<size_t>(g.width()));
}

void ComposedLayer::begin(std::span<const CommonKnots::Window> windows, std::span<const double> knots,
                          const SpanCell &cell, const double *block) {
    cell_ = &cell;
    knots_ = knots.size();
    CommonKnots::Window most = windows.front();
    for (const CommonKnots::Window &window : windows) {
        std::ranges::transform(most.copies, window.copies, most.copies.begin(),
                               [](int a, int b) { return std::max(a, b); });
    }
    list_choices(most, knots);
    for (size_t k = 0; k < static_cast<size_t>(g_.axes()); ++k) {
        distribute(k, windows, knots);
    }
    contract_first(block);
}

void ComposedLayer::list_choices(const CommonKnots::Window &most, std::span<const double> knots) {
    choices_.clear();
    if (most.size == 0 && f_.axis(0).degree() > 0) { // g has degree 0 and takes no arguments
        return;
    }
    for_each_choice(most, f_.axis(0).degree(),
                    [&](const int *chosen, double) { choices_.push_back(choice_of(chosen, knots)); });
}

// If all arguments are one knot, the value of f there may be a knot of g, to which it is then snapped.
ComposedLayer::Choice ComposedLayer::choice_of(const int *chosen,
                                               std::span<const double> knots) const noexcept {
    Choice choice{{}, {}, 1, 1};
    std::array<double, max_basis> arguments;
    double *end = arguments.data();
    int distinct = 0;
    for (size_t i = 0; i < knots.size(); ++i) {
        choice.copies[i] = static_cast<int8_t>(chosen[i]);
        end = std::fill_n(end, chosen[i], knots[i]);
        distinct += chosen[i] > 0 ? 1 : 0;
        choice.orders *= binomials(static_cast<int>(end - arguments.data()))[chosen[i]];
    }
    const std::span<const double> given(arguments.data(), end);
    const CurvePiece &piece = pieces_[cell_->piece];
    choice.weight = weighted_ ? piece.polar_weight(given) : 1;
    for (int k = 0; k < g_.axes(); ++k) {
        const auto at = static_cast<size_t>(k);
        const double value = piece.polar_value(k, given);
        choice.values[at] =
            distinct == 1 ? snapped_value(*axes_[at], value, pieces_, cell_->piece, k, given[0]) : value;
    }
    return choice;
}

// Values that lie between those at the first and the last knot, to within rounding, are clamped to that
// interval, and are later replaced by affine combinations of the least and the greatest of them.
void ComposedLayer::distribute(size_t k, std::span<const CommonKnots::Window> windows,
                               std::span<const double> knots) {
    const Interval ends = ends_of(k, knots);
    const double rounding = pieces_[cell_->piece].rounding(static_cast<int>(k));
    Interval between{ends.upper, ends.lower};
    of_axis_.clear();
    for (const Choice &choice : choices_) {
        double value = choice.values[k];
        if (value >= ends.lower - rounding && value <= ends.upper + rounding) {
            value = std::clamp(value, ends.lower, ends.upper);
            between = {std::min(between.lower, value), std::max(between.upper, value)};
        }
        of_axis_.push_back({choice.copies, value, choice.weight, choice.orders});
    }
    rows_[k].make(*axes_[k], cell_->spans[k], of_axis_, between, bounds_of(k, windows));
}

Interval ComposedLayer::ends_of(size_t k, std::span<const double> knots) const noexcept {
    if (choices_.empty() || knots.empty()) {
        const double only = choices_.empty() ? 0 : choices_[0].values[k];
        return {only, only};
    }
    std::array<int, max_basis> chosen{};
    const auto value_at = [&](size_t i) {
        chosen.fill(0);
        chosen[i] = f_.axis(0).degree();
        return choice_of(chosen.data(), knots).values[k];
    };
    const auto [lower, upper] = std::minmax({value_at(0), value_at(knots.size() - 1)});
    return {lower, upper};
}

// Copies that the arguments of the other axes can take need not be taken by those of this axis.
CopyBounds ComposedLayer::bounds_of(size_t k, std::span<const CommonKnots::Window> windows) const noexcept {
    const int q = f_.axis(0).degree(), own = q * axes_[k]->degree();
    int others = -own;
    for (const KnotVectorPtr &axis : axes_) {
        others += q * axis->degree();
    }
    CopyBounds bounds{knots_, {}, {}};
    for (size_t i = 0; i < knots_; ++i) {
        const auto [least, most] = std::ranges::minmax(
            windows, {}, [i](const CommonKnots::Window &window) { return window.copies[i]; });
        bounds.least[i] = static_cast<int8_t>(std::max(0, least.copies[i] - others));
        bounds.most[i] = static_cast<int8_t>(std::min(own, most.copies[i]));
    }
    return bounds;
}

void ComposedLayer::contract_first(const double *block) {
    const int64_t length = lengths_[0];
    const std::vector<DistributedRows::Share> &shares = rows_[0].shares();
    parts_[0].resize(shares.size() * static_cast<size_t>(length));
    double *out = parts_[0].data();
    for (const DistributedRows::Share &share : shares) {
        contract(share.row.data(), g_.axis(0).degree() + 1, block, length, length, out);
        out += length;
    }
}

const std::vector<double> &ComposedLayer::make(const CommonKnots::Window &window) {
    std::ranges::transform(window.copies, left_.begin(), [](int n) { return static_cast<int8_t>(n); });
    std::ranges::fill(sums_, CompensatedSum{});
    total_ = {};
    terms_ = 0;
    next_axis(0, nullptr, 1);
    for (size_t c = 0; c < sums_.size(); ++c) {
        record_[c] = terms_ == 1 ? only_[c] : sums_[c].value() / total_.value();
    }
    return record_;
}

bool ComposedLayer::is_left(const Copies &copies) const noexcept {
    for (size_t i = 0; i < knots_; ++i) {
        if (copies[i] > left_[i]) {
            return false;
        }
    }
    return true;
}

void ComposedLayer::take(const DistributedRows::Share &share, int times) noexcept {
    for (size_t i = 0; i < knots_; ++i) {
        left_[i] = static_cast<int8_t>(left_[i] - times * share.copies[i]);
    }
}

// Adds the values of G for all ways to distribute the remaining knots over the arguments of axes k, k + 1,
// .... The last axis takes all knots that are left. The number of orders of equal knots is the same for all
// ways and cancels in the mean.
void ComposedLayer::next_axis(int k, const double *points, double times) {
    const DistributedRows &rows = rows_[static_cast<size_t>(k)];
    if (k == g_.axes() - 1) {
        if (const DistributedRows::Share *share = rows.find(left_); share != nullptr) {
            add_share(k, *share, points, times);
        }
        return;
    }
    for (const DistributedRows::Share &share : rows.shares()) {
        add_share(k, share, points, times);
    }
}

void ComposedLayer::add_share(int k, const DistributedRows::Share &share, const double *points,
                              double times) {
    if (!is_left(share.copies)) {
        return;
    }
    times *= share.ways;
    const auto at = static_cast<size_t>(k);
    const int64_t length = lengths_[at];
    double *part = parts_[at].data();
    if (k == 0) {
        part += (&share - rows_[0].shares().data()) * length;
    } else {
        contract(share.row.data(), g_.axis(k).degree() + 1, points, length, length, part);
    }
    if (k == g_.axes() - 1) {
        return add_term(part, times);
    }
    take(share, 1);
    next_axis(k + 1, part, times);
    take(share, -1);
}

void ComposedLayer::add_term(const double *points, double times) {
    count_work(work_of_a_term * std::ssize(sums_));
    for (size_t c = 0; c < sums_.size(); ++c) {
        sums_[c].add(times * points[c]);
    }
    total_.add(times);
    only_ = points;
    ++terms_;
}

} // namespace nrb::refine
