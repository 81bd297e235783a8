// SPDX-License-Identifier: MIT
#include "numeric/solvers/banded/banded_lu.h"

#include "base/small_width.h"
#include "base/watch.h"

#include <algorithm>
#include <cmath>

namespace nrb::inline numeric {

namespace {

// Number of right-hand sides solved together: as many as keep a band of them in the cache.
constexpr int64_t most_together = 256;

// target -= factor * source
template <class Size>
void subtract(double *target, double factor, const double *source, Size n) noexcept {
    for (int64_t c = 0; c < n; ++c) {
        target[c] -= factor * source[c];
    }
}

} // namespace

BandedLu::BandedLu(int64_t rows, int width) : rows_(rows), width_(width) {
    grow_watched(entries_, static_cast<size_t>(rows * width));
    grow_watched(places_, static_cast<size_t>(rows));
    grow_watched(reaches_, static_cast<size_t>(rows));
}

double *BandedLu::next_row(int64_t i, int64_t first_column) noexcept {
    const int64_t place = i - first_column;
    places_[static_cast<size_t>(i)] = static_cast<int8_t>(place);
    return place < 0 || place >= width_ ? nullptr : entries_.data() + i * width_;
}

// Entries of the row above after its diagonal may fill in entries of this row.
void BandedLu::set_reach(int64_t i) noexcept {
    const int place = places_[static_cast<size_t>(i)];
    const double *const row = entries_.data() + i * width_;
    int begin = 0, end = width_;
    while (begin < place && row[begin] == 0) {
        ++begin;
    }
    const int least = place + (i > 0 ? std::max<int>(1, reach(i - 1).after) : 1);
    while (end > least && row[end - 1] == 0) {
        --end;
    }
    reaches_[static_cast<size_t>(i)] = {static_cast<int8_t>(place - begin),
                                        static_cast<int8_t>(end - 1 - place)};
}

bool BandedLu::factor_row(int64_t i) noexcept {
    set_reach(i);
    double *const target = diagonal(i);
    for (int64_t k = -reach(i).before; k < 0; ++k) {
        const double *const pivot = diagonal(i + k);
        target[k] *= *pivot;
        subtract(target + k + 1, target[k], pivot + 1, int64_t{reach(i + k).after});
    }
    *target = 1 / *target;
    return std::isfinite(*target);
}

double BandedLu::largest_of_upper(int64_t i) const noexcept {
    const double *const entries = diagonal(i);
    double largest = std::abs(1 / *entries);
    for (int j = 1; j <= reach(i).after; ++j) {
        largest = std::max(largest, std::abs(entries[j]));
    }
    return largest;
}

bool BandedLu::grows_little(double most) const {
    std::vector<double> largest(static_cast<size_t>(rows_));
    for (int64_t i = 0; i < rows_; ++i) {
        double product = largest[static_cast<size_t>(i)] = largest_of_upper(i);
        for (int64_t k = -reach(i).before; k < 0; ++k) {
            product += std::abs(diagonal(i)[k]) * largest[static_cast<size_t>(i + k)];
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
        count_work(rows_ * width_ * some);
        with_width(some, [&](auto size) { solve_some(values + first, width, size); });
    }
}

template <class Size>
void BandedLu::solve_some(double *values, int64_t width, Size some) const noexcept {
    for (int64_t i = 0; i < rows_; ++i) {
        const double *const from = diagonal(i);
        double *const target = values + i * width;
        for (int64_t k = -reach(i).before; k < 0; ++k) {
            subtract(target, from[k], target + k * width, some);
        }
    }
    for (int64_t i = rows_; i-- > 0;) {
        const double *const from = diagonal(i);
        double *const target = values + i * width;
        for (int64_t k = 1; k <= reach(i).after; ++k) {
            subtract(target, from[k], target + k * width, some);
        }
        std::for_each_n(target, static_cast<int64_t>(some), [inverse = *from](double &x) { x *= inverse; });
    }
}

void BandedLu::solve_transposed(double *values, int64_t width) const {
    count_work(rows_ * width_ * width);
    for (int64_t i = 0; i < rows_; ++i) {
        const double *const from = diagonal(i);
        double *const source = values + i * width;
        std::for_each_n(source, width, [inverse = *from](double &x) { x *= inverse; });
        for (int64_t k = 1; k <= reach(i).after; ++k) {
            subtract(source + k * width, from[k], source, width);
        }
    }
    for (int64_t i = rows_; i-- > 0;) {
        const double *const from = diagonal(i);
        double *const source = values + i * width;
        for (int64_t k = -reach(i).before; k < 0; ++k) {
            subtract(source + k * width, from[k], source, width);
        }
    }
}

} // namespace nrb::inline numeric
