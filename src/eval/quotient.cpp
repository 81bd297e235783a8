#include "eval/quotient.h"

namespace nrb {

size_t QuotientRule::scratch_size(int order) noexcept {
    return static_cast<size_t>(slot_count(2, order));
}

QuotientRule::QuotientRule(int axes, int order, Scratch &scratch) noexcept
    : axes_(axes), order_(order), binomials_(scratch.take(scratch_size(order))) {
    double *row = binomials_;
    for (int n = 0; n <= order; ++n) {
        const double *above = row - n;
        for (int k = 0; k <= n; ++k) {
            row[k] = k == 0 || k == n ? 1 : above[k - 1] + above[k];
        }
        row += n + 1;
    }
    if (order <= listed_order) {
        list_terms();
    }
}

void QuotientRule::list_terms() noexcept {
    int64_t count = 0;
    int64_t s = 0;
    for_each_slot(axes_, order_, [&](int i, int j, int k) {
        first_term_[s++] = count;
        derive_terms(i, j, k, [&](const QuotientTerm &term) { list_[count++] = term; });
    });
    first_term_[s] = count;
}

} // namespace nrb
