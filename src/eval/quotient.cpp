#include "eval/quotient.h"

#include "eval/slots.h"

namespace nrb {

size_t QuotientRule::scratch_size(int order) noexcept {
    return static_cast<size_t>(slot_count(2, order));
}

QuotientRule::QuotientRule(int axes, int dim, int order, Scratch &scratch) noexcept
    : axes_(axes), dim_(dim), order_(order), binomials_(scratch.take(scratch_size(order))) {
    double *row = binomials_;
    for (int n = 0; n <= order; ++n) {
        const double *above = row - n;
        for (int k = 0; k <= n; ++k) {
            row[k] = k == 0 || k == n ? 1 : above[k - 1] + above[k];
        }
        row += n + 1;
    }
}

double QuotientRule::binomial(int n, int k) const noexcept {
    return binomials_[n * (n + 1) / 2 + k];
}

void QuotientRule::subtract_products(int i, int j, int k, const double *homogeneous, const double *cartesian,
                                     double *sum) const noexcept {
    const int64_t width = dim_ + 1;
    for (int a = 0; a <= i; ++a) {
        for (int b = 0; b <= j; ++b) {
            for (int c = a + b == 0 ? 1 : 0; c <= k; ++c) {
                const double factor = binomial(i, a) * binomial(j, b) * binomial(k, c) *
                                      homogeneous[slot(axes_, a, b, c) * width + dim_];
                const double *lower = cartesian + slot(axes_, i - a, j - b, k - c) * dim_;
                for (int d = 0; d < dim_; ++d) {
                    sum[d] -= factor * lower[d];
                }
            }
        }
    }
}

void QuotientRule::operator()(const double *homogeneous, double *cartesian) const noexcept {
    const double weight = homogeneous[dim_];
    const double *source = homogeneous;
    double *target = cartesian;
    for_each_slot(axes_, order_, [&](int i, int j, int k) {
        std::copy_n(source, dim_, target);
        subtract_products(i, j, k, homogeneous, cartesian, target);
        for (int d = 0; d < dim_; ++d) {
            target[d] /= weight;
        }
        source += dim_ + 1;
        target += dim_;
    });
}

} // namespace nrb
