// SPDX-License-Identifier: MIT
#include "numeric/solvers/banded_least_squares.h"

#include "base/checked.h"
#include "base/watch.h"

#include <algorithm>
#include <cmath>

namespace nrb::inline numeric {

namespace {

constexpr int64_t work_of_a_rotation = 60; // computing its angle

} // namespace

BandedLeastSquares::BandedLeastSquares(int64_t columns, int bandwidth, int border, int64_t width)
    : banded_(columns - border), bandwidth_(bandwidth), border_(border), width_(width),
      stride_(bandwidth + border + width), fresh_(static_cast<size_t>(stride_)) {
    grow_watched(rows_, static_cast<size_t>(checked_product(columns, stride_, "least squares")));
}

// Rotates the fresh row and a row of the factor so that entry `at` of the fresh row vanishes; entries before
// `from` are zero in both.
void BandedLeastSquares::rotate(double *pivot, int64_t at, int64_t from) noexcept {
    double *fresh = fresh_.data();
    if (fresh[at] == 0) {
        return;
    }
    const double length = std::hypot(pivot[at], fresh[at]);
    const double c = pivot[at] / length, s = fresh[at] / length;
    for (int64_t i = from; i < stride_; ++i) {
        const double old = pivot[i];
        pivot[i] = c * old + s * fresh[i];
        fresh[i] = c * fresh[i] - s * old;
    }
    fresh[at] = 0;
}

void BandedLeastSquares::enter(int64_t column, double value) {
    if (column >= banded_) {
        entered_border_.resize(static_cast<size_t>(border_));
        entered_border_[static_cast<size_t>(column - banded_)] += value;
        return;
    }
    entered_ = entered_band_.empty() ? column : entered_;
    entered_band_.push_back(value);
}

void BandedLeastSquares::add_entered(const double *right) {
    add_row(entered_, entered_band_, entered_border_, right);
    entered_ = 0;
    entered_band_.clear();
    entered_border_.clear();
}

void BandedLeastSquares::add_row(int64_t first, std::span<const double> band, std::span<const double> border,
                                 const double *right) {
    count_work((8 * stride_ + work_of_a_rotation) * (bandwidth_ + border_));
    std::fill(fresh_.begin(), fresh_.end(), 0.0);
    std::copy(band.begin(), band.end(), fresh_.begin());
    std::copy(border.begin(), border.end(), fresh_.begin() + bandwidth_);
    std::copy_n(right, width_, fresh_.begin() + bandwidth_ + border_);
    const auto end = fresh_.begin() + bandwidth_;
    for (int64_t i = first; i < banded_ && std::any_of(fresh_.begin(), end, [](double x) { return x != 0; });
         ++i) {
        rotate(row(i), 0, 0);
        std::shift_left(fresh_.begin(), end, 1); // the diagonal of the next row comes first
        if (bandwidth_ > 0) {
            fresh_[static_cast<size_t>(bandwidth_) - 1] = 0;
        }
    }
    for (int64_t i = 0; i < border_; ++i) {
        rotate(row(banded_ + i), bandwidth_ + i, bandwidth_ + i);
    }
}

bool BandedLeastSquares::solve(double *x) const {
    const int64_t columns = banded_ + border_;
    for (int64_t i = columns; i-- > 0;) {
        count_work(width_ * (bandwidth_ + border_));
        const bool banded = i < banded_;
        const double *from = row(i);
        const double diagonal = banded ? from[0] : from[bandwidth_ + i - banded_];
        if (!(diagonal != 0)) {
            return false;
        }
        double *target = x + i * width_;
        std::copy_n(from + bandwidth_ + border_, width_, target);
        const auto subtract = [&](double factor, int64_t column) {
            const double *known = x + column * width_;
            std::transform(target, target + width_, known, target,
                           [factor](double a, double b) { return a - factor * b; });
        };
        for (int64_t j = 1; banded && j < std::min<int64_t>(bandwidth_, banded_ - i); ++j) {
            subtract(from[j], i + j);
        }
        for (int64_t j = banded ? 0 : i - banded_ + 1; j < border_; ++j) {
            subtract(from[bandwidth_ + j], banded_ + j);
        }
        std::for_each_n(target, width_, [diagonal](double &value) { value /= diagonal; });
    }
    return true;
}

} // namespace nrb::inline numeric
