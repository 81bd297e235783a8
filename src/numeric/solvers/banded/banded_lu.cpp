// SPDX-License-Identifier: MIT
#include "numeric/solvers/banded/banded_lu.h"

#include "base/small_width.h"
#include "base/watch.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace nrb::inline numeric {

namespace {

constexpr int64_t work_of_a_pivot = 8;
// Right-hand sides that are solved together: as many as keep a band of layers in the cache.
constexpr int64_t most_together = 256;

// Bands of two beside the diagonal, of cubic splines, have loops of their own.
using Two = std::integral_constant<int64_t, 2>;

// target -= factor * source
template <class Size>
void subtract(double *target, double factor, const double *source, Size n) noexcept {
    for (int64_t c = 0; c < n; ++c) {
        target[c] -= factor * source[c];
    }
}

} // namespace

BandedLu::BandedLu(int64_t rows, int below, int above) : rows_(rows), below_(below), above_(above) {
    grow_watched(band_, static_cast<size_t>(rows * stride()));
}

bool BandedLu::factor_row(int64_t i) noexcept {
    const bool shorter = i < below_ || i + above_ > rows_; // than the band is wide
    return shorter || below_ != Two() || above_ != Two() ? eliminate(i) : eliminate_within(i, Two(), Two());
}

template <class Below, class Above>
bool BandedLu::eliminate_within(int64_t i, Below below, Above above) noexcept {
    double *const target = band_.data() + i * (below + above + 1) + below;
    for (int64_t k = -below; k < 0; ++k) {
        const double *const pivot = target + k * (below + above + 1);
        target[k] *= *pivot;
        subtract(target + k + 1, target[k], pivot + 1, above);
    }
    *target = 1 / *target;
    return std::isfinite(*target);
}

// Row i of both factors; false if the pivot is 0 or not finite.
bool BandedLu::eliminate(int64_t i) noexcept {
    double *const target = row(i) + below_; // its diagonal
    for (int64_t k = std::max<int64_t>(i - below_, 0); k < i; ++k) {
        const double *const pivot = row(k) + below_;
        double &factor = target[k - i];
        if (factor != 0) {
            factor *= *pivot;
            subtract(target + (k - i) + 1, factor, pivot + 1, std::min<int64_t>(above_, rows_ - 1 - k));
        }
    }
    *target = 1 / *target;
    return std::isfinite(*target);
}

double BandedLu::largest_of_upper(int64_t i) const noexcept {
    const double *const diagonal = band_.data() + i * stride() + below_;
    double largest = std::abs(1 / *diagonal);
    for (int64_t j = 1; j <= std::min<int64_t>(above_, rows_ - 1 - i); ++j) {
        largest = std::max(largest, std::abs(diagonal[j]));
    }
    return largest;
}

bool BandedLu::factor_checked(double most) {
    std::vector<double> largest(static_cast<size_t>(rows_));
    for (int64_t i = 0; i < rows_; ++i) {
        count_work(2 * (int64_t{below_} * above_ + work_of_a_pivot));
        if (!eliminate(i)) {
            return false;
        }
        double product = largest[static_cast<size_t>(i)] = largest_of_upper(i);
        for (int64_t k = std::max<int64_t>(i - below_, 0); k < i; ++k) {
            product += std::abs(row(i)[below_ + k - i]) * largest[static_cast<size_t>(k)];
        }
        if (!(product <= most)) {
            return false;
        }
    }
    return true;
}

void BandedLu::solve(double *values, int64_t width) const {
    for (int64_t first = 0; first < width; first += most_together) {
        const int64_t some = std::min(most_together, width - first);
        count_work(rows_ * (below_ + above_ + 1) * some);
        with_width(some, [&](auto size) { solve_some(values + first, width, size); });
    }
}

template <class Size>
void BandedLu::solve_some(double *values, int64_t width, Size some) const noexcept {
    if (below_ == Two() && above_ == Two()) {
        return solve_band(values, width, some, Two(), Two());
    }
    solve_band(values, width, some, int64_t{below_}, int64_t{above_});
}

template <class Below, class Above, class Size>
void BandedLu::solve_band(double *values, int64_t width, Size some, Below below, Above above) const noexcept {
    const int64_t stride = below + above + 1;
    for (int64_t i = 0; i < rows_; ++i) {
        const double *const from = band_.data() + i * stride + below;
        for (int64_t k = std::max<int64_t>(i - below, 0); k < i; ++k) {
            subtract(values + i * width, from[k - i], values + k * width, some);
        }
    }
    for (int64_t i = rows_; i-- > 0;) {
        const double *const from = band_.data() + i * stride + below;
        double *const target = values + i * width;
        const int64_t last = std::min<int64_t>(i + above, rows_ - 1);
        for (int64_t k = i + 1; k <= last; ++k) {
            subtract(target, from[k - i], values + k * width, some);
        }
        const double inverse = *from;
        std::for_each_n(target, static_cast<int64_t>(some), [inverse](double &x) { x *= inverse; });
    }
}

void BandedLu::solve_transposed(double *values, int64_t width) const {
    count_work(rows_ * (below_ + above_ + 1) * width);
    for (int64_t i = 0; i < rows_; ++i) {
        const double *const from = band_.data() + i * stride() + below_;
        double *const source = values + i * width;
        std::for_each_n(source, width, [inverse = *from](double &x) { x *= inverse; });
        for (int64_t k = i + 1; k <= std::min(i + above_, rows_ - 1); ++k) {
            subtract(values + k * width, from[k - i], source, width);
        }
    }
    for (int64_t i = rows_; i-- > 0;) {
        const double *const from = band_.data() + i * stride() + below_;
        for (int64_t k = std::max<int64_t>(i - below_, 0); k < i; ++k) {
            subtract(values + k * width, from[k - i], values + i * width, width);
        }
    }
}

} // namespace nrb::inline numeric
