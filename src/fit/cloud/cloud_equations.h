// SPDX-License-Identifier: MIT
// The equations of a step: which changes of the control points make a sum of quadratic models least.
#pragma once

#include "fit/cloud/squared_distance.h"
#include "fit/least_squares/active_functions.h"
#include "fit/least_squares/stencil_matrix.h"
#include "numeric/solvers/sparse/sparse_system.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace nrb::fit {

// What the control points of a spline pay for derivatives of an order: sum_c x_c^T P x_c over the coordinates (penalty.h). Of
// splines all of whose degrees are lower, derivatives of the highest one.
class CloudPenalty {
public:
    CloudPenalty(const Spline::Axes &axes, int order);

    [[nodiscard]] const StencilPattern &pattern() const noexcept { return form_.pattern(); }
    [[nodiscard]] int64_t size() const noexcept { return form_.size(); }
    // About what a function of mean square 1 pays that is orthogonal to those that pay nothing.
    [[nodiscard]] double least() const noexcept;
    // Of x [unknowns][dim].
    [[nodiscard]] double of(const std::vector<double> &x) const;
    // P x: what x rounds away is not in it, so that polynomials pay nothing beside data for large factors either.
    [[nodiscard]] std::vector<double> times(const std::vector<double> &x) const;
    // Calls visit(row, column, value) for all elements, mirrored ones too.
    template <class Visit>
    void for_each(Visit &&visit) const {
        for (int64_t j = 0; j < columns_.size(); ++j) {
            for_each_of(j, [&](int64_t row, const DoubleDouble &value) { visit(row, j, value.high); });
        }
    }
    // In which order to eliminate coordinates of unknowns, those of one after the other.
    [[nodiscard]] std::vector<int64_t> elimination_order(int dim) const;

private:
    // Calls visit(row, value) for a column.
    template <class Visit>
    void for_each_of(int64_t column, Visit &&visit) const {
        const auto first = static_cast<size_t>(columns_.starts[static_cast<size_t>(column)]),
                   end = static_cast<size_t>(columns_.starts[static_cast<size_t>(column) + 1]);
        for (size_t p = first; p < end; ++p) {
            visit(int64_t{columns_.rows[p]}, columns_.values[p]);
        }
    }

    int order_;
    StencilMatrix form_;
    ColumnsOf<DoubleDouble> columns_;
};

// The change d that makes sum_i w_i (r_i - sum_a b_a d_a)^T W_i (r_i - sum_a b_a d_a) + lambda P(x + d) + mu u |d|^2 least,
// u the mean of the diagonal of the first term. Unknowns are the coordinates of control points that differ. Elements are kept
// by the places of the pattern, each a symmetric matrix of dim rows.
class CloudEquations {
public:
    CloudEquations(const Spline::Axes &axes, int dim, const CloudPenalty &penalty);

    // For the functions b at the foot.
    void add(const ActiveFunctions &functions, double weight, const SquaredDistance &model);
    // With the penalty at x.
    void finish(double lambda, const std::vector<double> &x);

    struct Step {
        std::vector<double> change; // [unknowns][dim]
        double promise;             // by how much the sum gets less
    };
    // None where rounding leaves the equations without a solution.
    [[nodiscard]] std::optional<Step> step(double mu);

private:
    struct Pair {
        size_t a, b;  // of active functions
        int64_t step; // from the start of a
    };
    [[nodiscard]] const double *element(int64_t place) const noexcept {
        return matrix_.data() + static_cast<size_t>(place) * half_;
    }
    [[nodiscard]] double trace() const noexcept;
    void append_element(std::vector<Entry> &entries, int64_t first, int64_t second, int64_t place) const;
    void append_penalty(std::vector<Entry> &entries, double lambda) const;

    const CloudPenalty &penalty_;
    const StencilPattern &pattern_;
    size_t dim_, half_; // elements of a symmetric matrix of dim rows
    std::vector<Pair> pairs_;
    std::vector<double> matrix_, right_;
    double unit_ = 0;
    std::unique_ptr<SparseSystem> system_;
    std::vector<int64_t> unknowns_; // of the functions at a foot
};

} // namespace nrb::fit
