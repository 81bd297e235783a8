#include "query/small_svd.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace nrb {

SmallSvd::SmallSvd(std::vector<double> rows, int n, std::vector<double> right) : n_(static_cast<size_t>(n)) {
    const size_t m = std::max(rows.size() / n_, n_);
    rows.resize(m * n_, 0);
    right.resize(m, 0);
    triangulate(rows, right, m);
    vectors_.assign(n_ * n_, 0);
    for (size_t i = 0; i < n_; ++i) {
        vectors_[i * n_ + i] = 1;
    }
    bool turned = true;
    for (int sweep = 0; sweep < 30 && turned; ++sweep) {
        turned = false;
        for (size_t i = 0; i < n_; ++i) {
            for (size_t j = i + 1; j < n_; ++j) {
                turned = rotate(i, j) || turned;
            }
        }
    }
}

void SmallSvd::triangulate(std::vector<double> &rows, std::vector<double> &right, size_t m) {
    for (size_t k = 0; k < n_; ++k) {
        double square = 0;
        for (size_t i = k; i < m; ++i) {
            square += rows[i * n_ + k] * rows[i * n_ + k];
        }
        double &pivot = rows[k * n_ + k];
        const double norm = std::copysign(std::sqrt(square), -pivot), head = pivot - norm;
        if (square == 0) {
            continue;
        }
        const double factor = 1 / (norm * head); // of the reflection I + factor v v^T
        pivot = head;
        const auto reflect = [&](double *target, size_t step) {
            double sum = 0;
            for (size_t i = k; i < m; ++i) {
                sum += rows[i * n_ + k] * target[i * step];
            }
            for (size_t i = k; i < m; ++i) {
                target[i * step] += factor * sum * rows[i * n_ + k];
            }
        };
        for (size_t j = k + 1; j < n_; ++j) {
            reflect(rows.data() + j, n_);
        }
        reflect(right.data(), 1);
        pivot = norm;
        for (size_t i = k + 1; i < m; ++i) {
            rows[i * n_ + k] = 0;
        }
    }
    columns_.resize(n_ * n_);
    for (size_t i = 0; i < n_; ++i) {
        for (size_t j = 0; j < n_; ++j) {
            columns_[j * n_ + i] = rows[i * n_ + j];
        }
    }
    right_.assign(right.begin(), right.begin() + static_cast<std::ptrdiff_t>(n_));
}

// Makes two columns orthogonal; false if they are.
bool SmallSvd::rotate(size_t i, size_t j) noexcept {
    double *a = columns_.data() + i * n_, *b = columns_.data() + j * n_;
    double aa = 0, bb = 0, ab = 0;
    for (size_t k = 0; k < n_; ++k) {
        aa += a[k] * a[k];
        bb += b[k] * b[k];
        ab += a[k] * b[k];
    }
    if (!(std::abs(ab) > std::numeric_limits<double>::epsilon() * std::sqrt(aa) * std::sqrt(bb))) {
        return false;
    }
    const double zeta = (bb - aa) / (2 * ab);
    const double t = std::copysign(1 / (std::abs(zeta) + std::hypot(1, zeta)), zeta);
    const double c = 1 / std::hypot(1, t), s = c * t;
    const auto turn = [c, s, this](double *x, double *y) {
        for (size_t k = 0; k < n_; ++k) {
            const double old = x[k];
            x[k] = c * old - s * y[k];
            y[k] = s * old + c * y[k];
        }
    };
    turn(a, b);
    turn(vectors_.data() + i * n_, vectors_.data() + j * n_);
    return true;
}

double SmallSvd::length(size_t column) const noexcept {
    double square = 0;
    for (size_t k = 0; k < n_; ++k) {
        square += columns_[column * n_ + k] * columns_[column * n_ + k];
    }
    return std::sqrt(square);
}

std::vector<double> SmallSvd::direction(int rank) const {
    std::vector<size_t> order(n_);
    std::iota(order.begin(), order.end(), size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [this](size_t i, size_t j) { return length(i) < length(j); });
    const auto first = vectors_.begin() + static_cast<std::ptrdiff_t>(order[static_cast<size_t>(rank)] * n_);
    return {first, first + static_cast<std::ptrdiff_t>(n_)};
}

std::vector<double> SmallSvd::solution(double cutoff) const {
    double largest = 0;
    for (size_t j = 0; j < n_; ++j) {
        largest = std::max(largest, length(j));
    }
    std::vector<double> x(n_, 0.0);
    for (size_t j = 0; j < n_; ++j) {
        const double sigma = length(j);
        if (!(sigma > cutoff * largest)) {
            continue;
        }
        double part = 0;
        for (size_t k = 0; k < n_; ++k) {
            part += columns_[j * n_ + k] / sigma * right_[k];
        }
        for (size_t k = 0; k < n_; ++k) {
            x[k] += part / sigma * vectors_[j * n_ + k];
        }
    }
    return x;
}

} // namespace nrb
