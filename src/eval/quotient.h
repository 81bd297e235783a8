// From homogeneous derivatives to Cartesian ones: the quotient rule in several variables (Leibniz; Piegl &
// Tiller 4.3, 4.5). With A = w C,
//   C^a = (A^a - sum over 0 < b <= a of binomial(a, b) w^b C^(a-b)) / w.
#pragma once

#include "base/scratch.h"
#include "eval/slots.h"

#include <cstdint>

namespace nrb {

// One product of the sum: binomial * (derivative `weight` of w) * (derivative `value` of C).
struct QuotientTerm {
    double binomial;
    int64_t weight;
    int64_t value;
};

class QuotientRule {
public:
    [[nodiscard]] static size_t scratch_size(int order) noexcept;
    QuotientRule(int axes, int order, Scratch &scratch) noexcept;

    // Calls visit(term) for the terms of slot s in their fixed order; (i, j, k) are the orders of the slot.
    template <class Visit>
    void for_each_term(int64_t s, int i, int j, int k, Visit &&visit) const noexcept {
        if (order_ > listed_order) {
            return derive_terms(i, j, k, visit);
        }
        for (int64_t t = first_term_[s]; t < first_term_[s + 1]; ++t) {
            visit(list_[t]);
        }
    }

private:
    // Low orders, which are what is asked for again and again, have their terms listed.
    static constexpr int listed_order = 2;
    static constexpr int64_t listed_slots = 10;
    static constexpr int64_t listed_terms = 18; // three axes, order 2: 3 of one, 3 of two, 3 of three terms

    [[nodiscard]] double binomial(int n, int k) const noexcept { return binomials_[n * (n + 1) / 2 + k]; }
    void list_terms() noexcept;

    template <class Visit>
    void derive_terms(int i, int j, int k, Visit &&visit) const noexcept {
        for (int a = 0; a <= i; ++a) {
            for (int b = 0; b <= j; ++b) {
                for (int c = a + b == 0 ? 1 : 0; c <= k; ++c) {
                    visit(QuotientTerm{binomial(i, a) * binomial(j, b) * binomial(k, c), slot(axes_, a, b, c),
                                       slot(axes_, i - a, j - b, k - c)});
                }
            }
        }
    }

    int axes_;
    int order_;
    double *binomials_; // Pascal's triangle, row n from n (n + 1) / 2 on
    QuotientTerm list_[listed_terms];
    int64_t first_term_[listed_slots + 1];
};

} // namespace nrb
