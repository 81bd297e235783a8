// SPDX-License-Identifier: MIT
#include "eval/functions/collocation.h"

#include "base/numbers.h"
#include "eval/kernels/leibniz.h"

#include <algorithm>

namespace nrb::eval {

namespace {

// The row of one parameter: derivatives of the B-spline basis functions.
struct BasisFunctions {
    Orders orders;

    void operator()(const ActivePoints &active, double *values) const noexcept {
        active.for_each(orders, [&values](int64_t, double value) { *values++ = value; });
    }
};

// The row of one parameter: derivative a of all active rational basis functions. With q = 1 / w(t), that of
// function i is w_i times the sum over b <= a of binomial(a, b) N_i^(b) q^(a-b). In this form the quotient
// rule takes one term for each b and each function.
class RationalFunctions {
public:
    RationalFunctions(const Spline &spline, const Orders &orders)
        : spline_(spline), orders_(orders), reciprocal_(spline.axes(), orders[0] + orders[1] + orders[2]) {}

    void operator()(const ActivePoints &active, double *values) noexcept {
        if (orders_ == Orders{}) {
            return quotients(active, values);
        }
        for_each_lower(orders_, [&](const Orders &b) {
            double weight = 0;
            active.for_each(b, [&](int64_t point, double value) { weight += value * spline_.weight(point); });
            reciprocal_.add(b, weight);
        });
        products(active, values);
    }

private:
    // Order 0, with the operations, and therefore the bits, of rational_basis().
    void quotients(const ActivePoints &active, double *values) const noexcept {
        double sum = 0;
        double *next = values;
        active.for_each([&](int64_t point, double value) {
            *next = value * spline_.weight(point);
            sum += *next++;
        });
        std::for_each(values, next, [sum](double &value) { value /= sum; });
    }

    // The sum over b, once the derivatives of q are known.
    void products(const ActivePoints &active, double *values) const noexcept {
        std::fill_n(values, active.size(), 0.0);
        reciprocal_.leibniz().for_each(orders_, [&](const Orders &b, const Orders &rest, double binomial) {
            const double factor = binomial * reciprocal_[rest];
            double *next = values;
            active.for_each(
                b, [&](int64_t point, double value) { *next++ += factor * (value * spline_.weight(point)); });
        });
    }

    const Spline &spline_;
    Orders orders_;
    Reciprocal reciprocal_;
};

template <class Functions>
void fill_rows(const Spline::Axes &axes, const AxisRules &rules, const Orders &orders, ConstRecords params,
               Functions &&functions, const SparseRows &rows) {
    ActivePoints active(axes, rules, orders);
    const int64_t length = active.size();
    for (int64_t i = 0; i < params.count && (rows.values != nullptr || rows.columns != nullptr); ++i) {
        const bool valid = active.locate(params, i);
        if (rows.values != nullptr && valid) {
            functions(active, rows.values + i * length);
        } else if (rows.values != nullptr) {
            std::fill_n(rows.values + i * length, length, nan_value);
        }
        if (rows.columns != nullptr) {
            int64_t *next = rows.columns + i * length;
            active.for_each([&next](int64_t point, double) { *next++ = point; });
        }
    }
    for (int64_t i = 0; i <= params.count && rows.row_pointers != nullptr; ++i) {
        rows.row_pointers[i] = i * length;
    }
}

} // namespace

int64_t row_length(const Spline::Axes &axes) noexcept {
    int64_t length = 1;
    for (const KnotVectorPtr &axis : axes) {
        length *= axis->degree() + 1;
    }
    return length;
}

void collocation(const Spline::Axes &axes, const AxisRules &rules, const Orders &orders, ConstRecords params,
                 const SparseRows &rows) {
    fill_rows(axes, rules, orders, params, BasisFunctions{orders}, rows);
}

void rational_collocation(const Spline &spline, const AxisRules &rules, const Orders &orders,
                          ConstRecords params, const SparseRows &rows) {
    if (spline.rational()) {
        fill_rows(spline.knot_vectors(), rules, orders, params, RationalFunctions(spline, orders), rows);
    } else {
        collocation(spline.knot_vectors(), rules, orders, params, rows);
    }
}

} // namespace nrb::eval
