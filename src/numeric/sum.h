// SPDX-License-Identifier: MIT
// Sums that are as accurate as if they had been formed in twice the precision.
#pragma once

namespace nrb::inline numeric {

// D. Knuth's two-sum gives the rounding error of an addition exactly; the errors are added up on their own
// (T. Ogita, S. Rump, S. Oishi, "Accurate sum and dot product", SIAM J. Sci. Comput. 26 (2005), Sum2): the
// value is off by at most eps / 2 of itself and (n eps / 2)^2 of the sum of the magnitudes of n terms.
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
