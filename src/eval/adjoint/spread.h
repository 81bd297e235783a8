// SPDX-License-Identifier: MIT
// The adjoint (transpose) of the tensor product: from cotangents of derivatives to those of the active
// control points.
#pragma once

#include "eval/active_points.h"

#include <vector>

namespace nrb::eval {

// Computes sum over the slots b of N_i^(b) g_b for every active control point i, where g_b is the cotangent
// of derivative b. The axes are expanded one after the other, the last one first: the steps of evaluation in
// reverse order.
class Spread {
public:
    // `width`: the number of components of a cotangent. The active points must outlive the object and offer
    // derivatives up to `order` on every axis.
    Spread(const ActivePoints &active, int axes, int order, int64_t width)
        : active_(active), axes_(axes), order_(order) {
        lengths_[static_cast<size_t>(axes)] = width;
        for (int k = axes - 1; k >= 0; --k) {
            const auto at = static_cast<size_t>(k);
            lengths_[at] = (active.degree(at) + 1) * lengths_[at + 1];
            slabs_[at].resize(static_cast<size_t>(before(k) * lengths_[at]));
        }
    }

    // cotangents: [slots][width]. Returns [active.size()][width], valid until the next call.
    const double *operator()(const double *cotangents) noexcept {
        const double *in = cotangents;
        for (int k = axes_ - 1; k >= 0; --k) {
            expand(k, in);
            in = slabs_[static_cast<size_t>(k)].data();
        }
        return in;
    }

private:
    // The number of derivatives with respect to the axes before k.
    [[nodiscard]] int64_t before(int k) const noexcept { return k == 0 ? 1 : slot_count(k, order_); }

    void expand(int k, const double *in) noexcept {
        if (k == 0) {
            return expand_one(0, {}, in, slabs_[0].data());
        }
        double *out = slabs_[static_cast<size_t>(k)].data();
        for_each_slot(k, order_, [&](int i, int j, int) {
            expand_one(k, {i, j, 0}, in, out);
            out += lengths_[static_cast<size_t>(k)];
        });
    }

    // On axis k, out[r] = sum over a of N_r^(a) in[slot of `orders` with a added as the order along axis k].
    void expand_one(int k, Orders orders, const double *in, double *out) const noexcept {
        const auto at = static_cast<size_t>(k);
        const int64_t length = lengths_[at + 1];
        const int highest = order_ - orders[0] - orders[1];
        products<false>(at, 0, length, in + slot(k + 1, orders) * length, out);
        for (orders[at] = 1; orders[at] <= highest; ++orders[at]) {
            products<true>(at, orders[at], length, in + slot(k + 1, orders) * length, out);
        }
    }

    // Sets out[r][l] to N_r^(order) row[l], or adds this product to it.
    template <bool add>
    void products(size_t k, int order, int64_t length, const double *row, double *out) const noexcept {
        const double *functions = active_.functions(k, order);
        for (int r = 0; r <= active_.degree(k); ++r) {
            for (int64_t l = 0; l < length; ++l) {
                const double product = functions[r] * row[l];
                *out = add ? *out + product : product;
                ++out;
            }
        }
    }

    const ActivePoints &active_;
    int axes_;
    int order_;
    std::array<int64_t, max_axes + 1> lengths_{};
    std::array<std::vector<double>, max_axes> slabs_;
};

} // namespace nrb::eval
