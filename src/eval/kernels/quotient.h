// SPDX-License-Identifier: MIT
// The quotient rule in several variables, which turns homogeneous derivatives into Cartesian ones (Leibniz;
// Piegl & Tiller 4.3, 4.5). With multi-indices a, b and A = w C,
//   C^a = (A^a - sum over 0 < b <= a of binomial(a, b) w^b C^(a-b)) / w.
#pragma once

#include "base/scratch.h"
#include "eval/kernels/slots.h"

#include <array>
#include <cstdint>

namespace nrb::eval {

// One product of the sum: `binomial` times derivative (slot) `weight` of w times derivative (slot) `value` of
// C.
struct QuotientTerm {
    double binomial;
    int64_t weight;
    int64_t value;
};

// The terms of the sum for each slot, in a fixed order.
class QuotientRule {
public:
    [[nodiscard]] static size_t scratch_size(int order) noexcept;
    QuotientRule(int axes, int order, Scratch &scratch) noexcept;

    // Calls visit(term) for the terms of slot s in their fixed order. (i, j, k): the orders of the slot.
    template <class Visit>
    void for_each_term(int64_t s, int i, int j, int k, Visit &&visit) const noexcept {
        if (list_ == nullptr) {
            const auto binomial = [this](int n, int m) { return binomials_[n * (n + 1) / 2 + m]; };
            return derive_terms(axes_, {i, j, k}, binomial, visit);
        }
        for (int64_t t = list_->first[s]; t < list_->first[s + 1]; ++t) {
            visit(list_->terms[t]);
        }
    }

private:
    // For low orders, which are the usual ones, the terms are listed. Those of slot s begin at first[s].
    static constexpr int listed_order = 2;
    struct List {
        static constexpr int64_t most_slots = 10;
        static constexpr int64_t most_terms = 18; // three axes: 3 slots each of one, two and three terms
        QuotientTerm terms[most_terms];
        int64_t first[most_slots + 1];
    };
    static constexpr List list_terms(int axes) noexcept;
    static const std::array<List, max_axes> lists;

    // Calls visit(term) for all (a, b, c) with 0 < (a, b, c) <= (i, j, k). binomial(n, k) is called with n <=
    // order.
    template <class Binomial, class Visit>
    static constexpr void derive_terms(int axes, const Orders &orders, Binomial &&binomial, Visit &&visit) {
        const auto [i, j, k] = orders;
        for (int a = 0; a <= i; ++a) {
            for (int b = 0; b <= j; ++b) {
                for (int c = a + b == 0 ? 1 : 0; c <= k; ++c) {
                    visit(QuotientTerm{binomial(i, a) * binomial(j, b) * binomial(k, c), slot(axes, a, b, c),
                                       slot(axes, i - a, j - b, k - c)});
                }
            }
        }
    }

    int axes_;
    const List *list_;  // null above the listed orders
    double *binomials_; // above them: Pascal's triangle, row n from n (n + 1) / 2 on
};

} // namespace nrb::eval
