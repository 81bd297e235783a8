// SPDX-License-Identifier: MIT
#include "pieces/bezier_piece.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>

namespace nrb::pieces {

namespace {

// The weights of both ends of an interval in the convex combination that gives t. Each has a relative error
// within 3/2 eps, also near the other end, where subtracting from 1 would lose accuracy.
struct Shares {
    Shares(Interval ends, double t) noexcept
        : lower((ends.upper - t) / (ends.upper - ends.lower)),
          upper((t - ends.lower) / (ends.upper - ends.lower)) {}

    double lower, upper;
};

// Error of one step of de Casteljau's algorithm with such shares, for the coefficient and for its weight.
constexpr double error_of_cut = 5 * eps;

} // namespace

BezierPiece::BezierPiece(const double *point, int dim) : numbers_(point, point + dim) {
    shape_.width = dim + 1;
    numbers_.push_back(1);
    update();
}

BezierPiece::BezierPiece(BezierNet &net, int64_t index, int axes)
    : axes_(axes), shape_(net.shape()), numbers_(size_of_numbers()), part_(net.part(index)),
      rounding_(net.rounding(index)) {
    net.copy(index, numbers_.data(), shape_.width);
    update();
}

BezierPiece::BezierPiece(int axes, const BernsteinShape &shape, std::vector<double> values,
                         const std::array<Interval, max_axes> &part, const Rounding &rounding)
    : axes_(axes), shape_(shape), numbers_(std::move(values)), part_(part), rounding_(rounding) {
    update();
}

void BezierPiece::replace(int width, std::vector<double> values, const Rounding &rounding) {
    shape_.width = width;
    numbers_ = std::move(values);
    rounding_ = rounding;
    update();
}

LocalParam BezierPiece::parameter(const LocalParam &place) const noexcept {
    LocalParam result{};
    for (size_t k = 0; k < static_cast<size_t>(axes_); ++k) {
        const auto [lower, upper] = part_[k];
        const double t = lower * (1 - place[k]) + upper * place[k];
        result[k] = std::clamp(place[k] >= 1 ? upper : t, lower, upper);
    }
    return result;
}

LocalParam BezierPiece::place(const LocalParam &parameter) const noexcept {
    LocalParam result{};
    for (size_t k = 0; k < static_cast<size_t>(axes_); ++k) {
        const auto [lower, upper] = part_[k];
        result[k] = std::clamp((parameter[k] - lower) / (upper - lower), 0.0, 1.0);
    }
    return result;
}

void BezierPiece::update() {
    count_work(2 * coefficients() * shape_.width);
    if (weight(0) < 0 || (weight(0) == 0 && weight(coefficients() - 1) < 0)) {
        std::for_each_n(numbers_.begin(), shape_.values(), [](double &x) { x = -x; });
    }
    first_point_ = shape_.values();
    numbers_.resize(size_of_numbers());
    sound_ = set_points();
    set_box();
    moved_ = records_moved() + 4 * eps * reach_;
    sound_ = sound_ && std::isfinite(moved_) && std::isfinite(reach_);
    positive_ = positive_ && sound_;
}

// Returns whether each weight is positive, or 0 with the whole coefficient; sets positive_ to whether no
// coefficient is 0.
bool BezierPiece::set_points() noexcept {
    bool all = true;
    positive_ = true;
    least_weight_ = infinity;
    double farthest = 0; // squared distance
    for (int64_t i = 0; i < coefficients(); ++i) {
        const double *from = record(i), w = weight(i);
        const bool nothing = rounding_.relative() &&
                             std::all_of(from, from + shape_.width, [](double value) { return value == 0; });
        positive_ = positive_ && !nothing;
        if (nothing) {
            continue;
        }
        all = all && rounding_.positive(w);
        least_weight_ = std::min(least_weight_, w);
        double *x = points() + i * dim();
        std::transform(from, from + dim(), x, [w](double value) { return value / w; });
        farthest = std::max(farthest, dot(x, x, dim()));
    }
    reach_ = std::sqrt(farthest);
    if (!safe_square(farthest)) {
        set_reach();
    }
    return all && std::isfinite(least_weight_);
}

// For squares that may have over- or underflowed.
void BezierPiece::set_reach() noexcept {
    reach_ = 0;
    for (int64_t i = 0; i < coefficients(); ++i) {
        reach_ = std::max(reach_, has_point(i) ? norm(point(i), dim()) : 0);
    }
}

void BezierPiece::set_box() noexcept {
    double *low = points() + coefficients() * dim(), *high = low + dim();
    std::fill_n(low, dim(), infinity);
    std::fill_n(high, dim(), -infinity);
    const int64_t count = coefficients();
    const int n = dim();
    for (int64_t i = 0; i < count; ++i) {
        if (!has_point(i)) {
            continue;
        }
        const double *x = point(i);
        for (int c = 0; c < n; ++c) {
            low[c] = std::min(low[c], x[c]);
            high[c] = std::max(high[c], x[c]);
        }
    }
    size_ = 0;
    for (int c = 0; c < dim(); ++c) {
        size_ = std::max(size_, high[c] - low[c]);
    }
}

// The longest control polygon along an axis: the sum of the distances between neighbours.
double BezierPiece::legs(int axis) const noexcept {
    int64_t step = 1;
    for (int k = axes_; k-- > axis + 1;) {
        step *= degree(k) + 1;
    }
    double longest = 0;
    for (int64_t first = 0; first < coefficients(); ++first) {
        if (first / step % (degree(axis) + 1) != 0) {
            continue;
        }
        double sum = 0;
        for (int i = 0; i < degree(axis); ++i) {
            sum += distance(point(first + i * step), point(first + (i + 1) * step), dim());
        }
        longest = std::max(longest, sum);
    }
    return longest;
}

// Accounts for a step that replaces every coefficient by a mean of others, with an error of `relative` times
// the same mean of magnitudes.
void BezierPiece::add_rounding(double relative) noexcept {
    if (rounding_.relative()) {
        rounding_.apart += 1.01 * relative * reach_;
        return;
    }
    double most = 0, heaviest = 0;
    for (int64_t i = 0; i < coefficients(); ++i) {
        most = std::max(most, norm(record(i), dim()));
        heaviest = std::max(heaviest, std::abs(weight(i)));
    }
    rounding_.record += relative * most;
    rounding_.weight += relative * heaviest;
}

double BezierPiece::middle(int axis) const noexcept {
    const auto [lower, upper] = part_[static_cast<size_t>(axis)];
    return lower / 2 + upper / 2;
}

// Each value results from `degree` steps of means; its error is degree eps / 2 of the same means of
// magnitudes.
BezierPiece BezierPiece::halve(int axis) {
    count_work(coefficients() * degree(axis) * shape_.width / 2);
    add_rounding(degree(axis) * eps);
    BezierPiece lower = *this;
    nrb::halve(shape_, max_axes - axes_ + axis, numbers_.data(), lower.numbers_.data());
    const auto at = static_cast<size_t>(axis);
    lower.part_[at].upper = part_[at].lower = middle(axis);
    update();
    lower.update();
    return lower;
}

std::optional<BezierPiece> BezierPiece::halve() {
    int axis = -1;
    double longest = -1;
    for (int k = 0; k < axes_; ++k) {
        const auto [lower, upper] = part_[static_cast<size_t>(k)];
        if (degree(k) > 0 && middle(k) > lower && middle(k) < upper) {
            const double found = positive_ ? legs(k) : (upper - lower) / std::max(std::abs(upper), 1.0);
            if (!(found <= longest)) {
                longest = found;
                axis = k;
            }
        }
    }
    if (axis < 0) {
        return std::nullopt;
    }
    return halve(axis);
}

BezierPiece BezierPiece::between(Interval range) const {
    BezierPiece result = *this;
    count_work(coefficients() * degree(0) * shape_.width);
    if (range.lower > part_[0].lower) {
        result.cut_before(range.lower);
    }
    if (range.upper < part_[0].upper) {
        result.cut_after(range.upper);
    }
    result.keep_even_weights(*this);
    result.update();
    return result;
}

// A constant weight remains constant.
void BezierPiece::keep_even_weights(const BezierPiece &whole) noexcept {
    const double w = whole.weight(0);
    for (int64_t i = 1; i < coefficients(); ++i) {
        if (whole.weight(i) != w) {
            return;
        }
    }
    for (int64_t i = 0; i < coefficients(); ++i) {
        numbers_[static_cast<size_t>(i * shape_.width + dim())] = w;
    }
}

void BezierPiece::cut_before(double t) noexcept {
    const Shares share(part_[0], t);
    const int64_t n = shape_.coefficients() - 1, width = shape_.width;
    add_rounding(static_cast<double>(n) * error_of_cut);
    for (int64_t level = n; level > 0; --level) {
        for (int64_t i = 0; i < level * width; ++i) {
            double &value = numbers_[static_cast<size_t>(i)];
            value = share.lower * value + share.upper * numbers_[static_cast<size_t>(i + width)];
        }
    }
    part_[0].lower = t;
}

void BezierPiece::cut_after(double t) noexcept {
    const Shares share(part_[0], t);
    const int64_t n = shape_.coefficients() - 1, width = shape_.width;
    add_rounding(static_cast<double>(n) * error_of_cut);
    for (int64_t first = 1; first <= n; ++first) {
        for (int64_t i = (n + 1) * width; i-- > first * width;) {
            double &value = numbers_[static_cast<size_t>(i)];
            value = share.lower * numbers_[static_cast<size_t>(i - width)] + share.upper * value;
        }
    }
    part_[0].upper = t;
}

std::vector<BezierPiece> bezier_pieces(const Spline &spline, const Frame &frame,
                                       const BernsteinNet::Breaks &more) {
    BezierNet net(spline, frame, more);
    std::vector<BezierPiece> pieces;
    pieces.reserve(static_cast<size_t>(net.count()));
    for (int64_t i = 0; i < net.count(); ++i) {
        pieces.emplace_back(net, i, spline.axes());
    }
    return pieces;
}

} // namespace nrb::pieces
