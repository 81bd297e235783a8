// SPDX-License-Identifier: MIT
#include "pieces/tree/patch_squares.h"

#include <algorithm>
#include <limits>

namespace nrb::pieces {

// The factors, and the quotient by the binomials, are rounded twice each. Then there is one rounding for
// every term, at most (coefficients + 2) / 2 of them, since each pair is taken once, and one for each
// coordinate; subtracting a multiple of w^2 takes two more.
PatchSquares::PatchSquares(const PatchShape &shape) {
    BernsteinShape once{{}, 1};
    std::copy_n(shape.degrees.begin(), shape.axes, once.degrees.begin());
    const BernsteinShape twice = product_shape(once, once);
    binomials_ = binomial_factors(once);
    for (const double b : binomial_factors(twice)) {
        inverses_.push_back(1 / b);
    }
    const auto &[a, b, c] = once.degrees;
    for (int i = 0; i <= a; ++i) {
        for (int j = 0; j <= b; ++j) {
            for (int k = 0; k <= c; ++k) {
                offsets_.push_back((i * (2 * b + 1) + j) * (2 * c + 1) + k);
            }
        }
    }
    const auto terms = static_cast<double>(shape.coefficients() + 2) / 2;
    error_ = std::numeric_limits<double>::epsilon() / 2 * (terms + shape.dim + 6);
}

} // namespace nrb::pieces
