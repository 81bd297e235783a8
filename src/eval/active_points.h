// SPDX-License-Identifier: MIT
// The control points that are active at a parameter, with the products over the axes of their polynomial
// basis functions, or of derivatives of these.
#pragma once

#include "base/scratch.h"
#include "eval/functions/axis_basis.h"
#include "eval/kernels/slots.h"

#include <array>
#include <optional>

namespace nrb::eval {

// Iterates over the active control points of one parameter after the other. A curve or surface is treated as
// a volume whose missing axes have one layer and the constant function 1.
class ActivePoints {
public:
    // `highest`: the highest order of derivatives that for_each() and functions() can be asked for, on each
    // axis.
    ActivePoints(const Spline::Axes &axes, const AxisRules &rules, const Orders &highest = {})
        : scratch_(size_t{max_axes} * max_basis + scratch_size(axes, highest)) {
        for (size_t k = 0; k < max_axes; ++k) {
            if (k < axes.size()) {
                degrees_[k] = axes[k]->degree();
                counts_[k] = axes[k]->count();
                axes_[k].emplace(*axes[k], rules[k], highest[k]);
                bases_[k].values = scratch_.take(axes_[k]->values_size());
            } else { // an axis that the spline lacks: one layer, and the constant 1 as its function
                bases_[k].values = scratch_.take(1);
                bases_[k].values[0] = 1;
            }
            size_ *= degrees_[k] + 1;
        }
    }

    // Number of active points.
    [[nodiscard]] int64_t size() const noexcept { return size_; }
    [[nodiscard]] int degree(size_t k) const noexcept { return degrees_[k]; }
    [[nodiscard]] int64_t span(size_t k) const noexcept { return bases_[k].first + degrees_[k]; }
    // Derivative `order` of the degree + 1 basis functions of axis k, at the parameter that was located last.
    [[nodiscard]] const double *functions(size_t k, int order) const noexcept {
        return bases_[k].values + static_cast<int64_t>(order) * (degrees_[k] + 1);
    }

    // Moves to parameter i. Returns false if the parameter gives NaN. The active points are then those of the
    // first degree + 1 layers of each axis, and the values of their functions are meaningless.
    bool locate(ConstRecords params, int64_t i) noexcept {
        bool valid = true;
        for (size_t k = 0; k < max_axes && axes_[k]; ++k) {
            valid = (*axes_[k])(params(i, static_cast<int64_t>(k)), bases_[k]) && valid;
        }
        for (size_t k = 0; k < max_axes && !valid; ++k) {
            bases_[k].first = 0;
        }
        return valid;
    }

    // Calls visit(point, value) for each active control point, the last axis varying fastest: its index in
    // the net, and the product of its basis functions, or of their derivatives of the given orders.
    template <class Visit>
    void for_each(const Orders &orders, Visit &&visit) const {
        const double *u = functions(0, orders[0]);
        const double *v = functions(1, orders[1]);
        const double *w = functions(2, orders[2]);
        for (int i = 0; i <= degrees_[0]; ++i) {
            for (int j = 0; j <= degrees_[1]; ++j) {
                const int64_t row = (bases_[0].first + i) * counts_[1] + bases_[1].first + j;
                for (int k = 0; k <= degrees_[2]; ++k) {
                    visit(row * counts_[2] + bases_[2].first + k, u[i] * v[j] * w[k]);
                }
            }
        }
    }
    template <class Visit>
    void for_each(Visit &&visit) const {
        for_each(Orders{}, visit);
    }

private:
    static size_t scratch_size(const Spline::Axes &axes, const Orders &highest) noexcept {
        size_t size = 0;
        for (size_t k = 0; k < axes.size(); ++k) {
            size += static_cast<size_t>(highest[k]) * (static_cast<size_t>(axes[k]->degree()) + 1);
        }
        return size;
    }

    Scratch scratch_;
    std::array<std::optional<AxisEvaluator>, max_axes> axes_;
    std::array<AxisBasis, max_axes> bases_;
    std::array<int, max_axes> degrees_{};
    std::array<int64_t, max_axes> counts_{1, 1, 1};
    int64_t size_ = 1;
};

} // namespace nrb::eval
