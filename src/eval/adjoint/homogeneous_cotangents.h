// SPDX-License-Identifier: MIT
// The adjoint of the quotient rule at one parameter: from cotangents of Cartesian derivatives to those of
// homogeneous ones.
#pragma once

#include "eval/active_points.h"
#include "eval/kernels/leibniz.h"

#include <algorithm>
#include <vector>

namespace nrb::eval {

// The orders of derivatives that are `order` on every axis of the spline.
inline Orders highest_orders(const Spline &spline, int order) noexcept {
    Orders orders{};
    std::fill_n(orders.begin(), spline.axes(), order);
    return orders;
}

// A point and its derivatives at one parameter.
struct PointDerivs {
    ConstRecords values; // record `row`: [slots][dim]
    int64_t row = 0;
    const double *point = nullptr; // [dim]: used instead of the point in `values`, unless null

    [[nodiscard]] double operator()(int64_t slot, int dim, int c) const noexcept {
        return slot == 0 && point != nullptr ? point[c] : values(row, slot * dim + c);
    }
};

// A point and its derivatives up to `order` are made from the homogeneous derivatives A^(b) = sum of N_i^(b)
// w_i P_i and w^(b) = sum of N_i^(b) w_i by the quotient rule. With q = 1 / w(t) and the cotangents g_s of
// the Cartesian derivatives C^(s), the adjoint of this rule is
//   dL/dA^(b) = sum over s >= b of binomial(s, b) q^(s-b) g_s,
//   dL/dw^(b) = -(sum over s >= b of binomial(s, b) q^(s-b) h_s),
//   h_b       = sum over s >= b of binomial(s, b) <g_s, C^(s-b)>,
// because dC = q (dA - C dw), differentiated by Leibniz' rule.
class HomogeneousCotangents {
public:
    // Cotangents: [count][slots][dim]. With `weighted` the cotangents of w^(b) are wanted, too. All
    // references are kept. The active points must offer derivatives up to `order` on every axis.
    HomogeneousCotangents(const Spline &spline, const ActivePoints &active, int order,
                          ConstRecords cotangents, bool weighted)
        : spline_(spline), active_(active), order_(order), cotangents_(cotangents), weighted_(weighted),
          width_(spline.dim() + (weighted ? 1 : 0)), reciprocal_(spline.axes(), order),
          products_(static_cast<size_t>(slot_count(spline.axes(), order))),
          result_(products_.size() * static_cast<size_t>(width_)) {}

    [[nodiscard]] int64_t width() const noexcept { return width_; }

    // Returns [slots][width]: dL/dA^(b) and, if weights are wanted, -dL/dw^(b); valid until the next call.
    // Precondition: the active points are at parameter i. The derivatives are read only if weights are
    // wanted.
    const double *operator()(int64_t i, const PointDerivs &derivs) noexcept {
        if (weighted_) {
            find_products(i, derivs);
        }
        if (spline_.rational()) {
            find_reciprocal();
            divide(i);
        } else {
            copy(i);
        }
        return result_.data();
    }

private:
    [[nodiscard]] double cotangent(int64_t i, int64_t slot, int c) const noexcept {
        return cotangents_(i, slot * spline_.dim() + c);
    }
    [[nodiscard]] double product(int64_t i, int64_t slot, const PointDerivs &derivs,
                                 int64_t other) const noexcept {
        double sum = 0;
        for (int c = 0; c < spline_.dim(); ++c) {
            sum += cotangent(i, slot, c) * derivs(other, spline_.dim(), c);
        }
        return sum;
    }

    // Computes h_b for all slots b.
    void find_products(int64_t i, const PointDerivs &derivs) noexcept {
        const int axes = spline_.axes();
        std::fill(products_.begin(), products_.end(), 0.0);
        for_each_slot(axes, order_, [&](int x, int y, int z) {
            const Orders s{x, y, z};
            const int64_t own = slot(axes, s);
            reciprocal_.leibniz().for_each(s, [&](const Orders &b, const Orders &rest, double factor) {
                products_[static_cast<size_t>(slot(axes, b))] +=
                    factor * product(i, own, derivs, slot(axes, rest));
            });
        });
    }

    void find_reciprocal() noexcept {
        for_each_slot(spline_.axes(), order_, [&](int x, int y, int z) {
            double weight = 0;
            active_.for_each({x, y, z},
                             [&](int64_t point, double value) { weight += value * spline_.weight(point); });
            reciprocal_.add({x, y, z}, weight);
        });
    }

    void divide(int64_t i) noexcept {
        const int axes = spline_.axes();
        std::fill(result_.begin(), result_.end(), 0.0);
        for_each_slot(axes, order_, [&](int x, int y, int z) {
            const Orders s{x, y, z};
            const int64_t own = slot(axes, s);
            reciprocal_.leibniz().for_each(s, [&](const Orders &b, const Orders &rest, double binomial) {
                add(i, own, binomial * reciprocal_[rest], result_.data() + slot(axes, b) * width_);
            });
        });
    }

    // For a polynomial spline, where all weights are 1: no division is needed.
    void copy(int64_t i) noexcept {
        double *out = result_.data();
        for (int64_t s = 0; s < std::ssize(products_); ++s) {
            for (int c = 0; c < spline_.dim(); ++c) {
                *out++ = cotangent(i, s, c);
            }
            if (weighted_) {
                *out++ = products_[static_cast<size_t>(s)];
            }
        }
    }

    void add(int64_t i, int64_t slot, double factor, double *out) const noexcept {
        const int dim = spline_.dim();
        for (int c = 0; c < dim; ++c) {
            out[c] += factor * cotangent(i, slot, c);
        }
        if (weighted_) {
            out[dim] += factor * products_[static_cast<size_t>(slot)];
        }
    }

    const Spline &spline_;
    const ActivePoints &active_;
    int order_;
    ConstRecords cotangents_;
    bool weighted_;
    int64_t width_;
    Reciprocal reciprocal_;
    std::vector<double> products_; // h_b
    std::vector<double> result_;
};

} // namespace nrb::eval
