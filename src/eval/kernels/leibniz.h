// SPDX-License-Identifier: MIT
// Leibniz' rule for products of functions of several variables, and derivatives of reciprocals.
#pragma once

#include "eval/kernels/slots.h"

#include <vector>

namespace nrb::eval {

// Calls visit(b) for all multi-indices b <= a, each after all those that are <= it.
template <class Visit>
void for_each_lower(const Orders &a, Visit &&visit) {
    Orders b{};
    for (b[0] = 0; b[0] <= a[0]; ++b[0]) {
        for (b[1] = 0; b[1] <= a[1]; ++b[1]) {
            for (b[2] = 0; b[2] <= a[2]; ++b[2]) {
                visit(b);
            }
        }
    }
}

// (f g)^(a) = sum over b <= a of binomial(a, b) f^(b) g^(a - b), with the binomials of the axes multiplied.
class Leibniz {
public:
    // For derivatives of total order up to `order`.
    explicit Leibniz(int order) : binomials_(static_cast<size_t>(slot_count(2, order))) {
        double *row = binomials_.data();
        for (int n = 0; n <= order; ++n) {
            for (int k = 0; k <= n; ++k) {
                row[k] = k == 0 || k == n ? 1 : row[k - n - 1] + row[k - n];
            }
            row += n + 1;
        }
    }

    // Calls visit(b, a - b, binomial(a, b)) for all b <= a, in the order of for_each_lower().
    template <class Visit>
    void for_each(const Orders &a, Visit &&visit) const {
        for_each_lower(a, [&](const Orders &b) {
            const Orders rest{a[0] - b[0], a[1] - b[1], a[2] - b[2]};
            visit(b, rest, binomial(a[0], b[0]) * binomial(a[1], b[1]) * binomial(a[2], b[2]));
        });
    }

private:
    [[nodiscard]] double binomial(int n, int k) const noexcept {
        return binomials_[static_cast<size_t>(n * (n + 1) / 2 + k)];
    }

    std::vector<double> binomials_; // Pascal's triangle
};

// The partial derivatives of q = 1 / w(t), computed from those of w.
class Reciprocal {
public:
    Reciprocal(int axes, int order)
        : leibniz_(order), axes_(axes), weight_(static_cast<size_t>(slot_count(axes, order))),
          values_(weight_.size()) {}

    [[nodiscard]] const Leibniz &leibniz() const noexcept { return leibniz_; }
    [[nodiscard]] double operator[](const Orders &a) const noexcept { return values_[at(a)]; }

    // Appends derivative a of q, given the same derivative of w. All derivatives b < a must have been
    // appended before.
    //   q^(a) = -(sum over 0 < b <= a of binomial(a, b) w^(b) q^(a-b)) / w,   q^(0) = 1 / w.
    void add(const Orders &a, double weight) noexcept {
        weight_[at(a)] = weight;
        double sum = a == Orders{} ? -1 : 0;
        leibniz_.for_each(a, [&](const Orders &b, const Orders &rest, double factor) {
            if (b != Orders{}) {
                sum += factor * weight_[at(b)] * values_[at(rest)];
            }
        });
        values_[at(a)] = -sum / weight_[0];
    }

private:
    [[nodiscard]] size_t at(const Orders &a) const noexcept { return static_cast<size_t>(slot(axes_, a)); }

    Leibniz leibniz_;
    int axes_;
    std::vector<double> weight_;
    std::vector<double> values_;
};

} // namespace nrb::eval
