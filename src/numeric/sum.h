// SPDX-License-Identifier: MIT
// Compensated summation: sums as accurate as if computed in twice the precision.
#pragma once

namespace nrb::inline numeric {

// Knuth's two-sum gives the rounding error of each addition exactly; the errors are summed separately (T.
// Ogita, S. Rump, S. Oishi, "Accurate sum and dot product", SIAM J. Sci. Comput. 26 (2005), Sum2). The error
// of the result is at most eps / 2 of the value plus (n eps / 2)^2 of the sum of the magnitudes of the n
// terms.
struct CompensatedSum {
    double sum = 0;
    double rest = 0;

    void add(double term) noexcept {
        const double total = sum + term;
        const double part = total - sum;
        rest += (sum - (total - part)) + (term - part);
        sum = total;
    }
    [[nodiscard]] double value() const noexcept { return sum + rest; }
};

} // namespace nrb::inline numeric
