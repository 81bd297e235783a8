// SPDX-License-Identifier: MIT
#include "eval/kernels/quotient.h"

namespace nrb::eval {

constexpr QuotientRule::List QuotientRule::list_terms(int axes) noexcept {
    List list{};
    int64_t count = 0;
    int64_t s = 0;
    const auto binomial = [](int n, int k) { return n == 2 && k == 1 ? 2.0 : 1.0; };
    for_each_slot(axes, listed_order, [&](int i, int j, int k) {
        list.first[s++] = count;
        derive_terms(axes, {i, j, k}, binomial,
                     [&](const QuotientTerm &term) { list.terms[count++] = term; });
    });
    list.first[s] = count;
    return list;
}

constinit const std::array<QuotientRule::List, max_axes> QuotientRule::lists{list_terms(1), list_terms(2),
                                                                             list_terms(3)};

size_t QuotientRule::scratch_size(int order) noexcept {
    return order <= listed_order ? 0 : static_cast<size_t>(slot_count(2, order));
}

QuotientRule::QuotientRule(int axes, int order, Scratch &scratch) noexcept
    : axes_(axes), list_(order <= listed_order ? &lists[static_cast<size_t>(axes - 1)] : nullptr),
      binomials_(scratch.take(scratch_size(order))) {
    double *row = binomials_;
    for (int n = 0; list_ == nullptr && n <= order; ++n) {
        const double *above = row - n;
        for (int k = 0; k <= n; ++k) {
            row[k] = k == 0 || k == n ? 1 : above[k - 1] + above[k];
        }
        row += n + 1;
    }
}

} // namespace nrb::eval
