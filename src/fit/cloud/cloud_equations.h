// SPDX-License-Identifier: MIT
// The linear equations of a step: the changes of the control points that minimise a sum of quadratic models.
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

// The roughness penalty of the control points of a spline: sum_c x_c^T P x_c over the coordinates c
// (penalty.h). An order above all degrees is lowered to the highest of them.
class CloudPenalty {
public:
    CloudPenalty(const Spline::Axes &axes, int order);

    [[nodiscard]] const StencilPattern &pattern() const noexcept { return form_.pattern(); }
    [[nodiscard]] int64_t size() const noexcept { return form_.size(); }
    // About the least penalty of a function of mean square 1 that is orthogonal to the functions without
    // penalty.
    [[nodiscard]] double least() const noexcept;
    // The penalty of x [unknowns][dim].
    [[nodiscard]] double of(const std::vector<double> &x) const;
    // P x, summed in double-double precision, so that polynomials have no penalty beside the data for large
    // factors either.
    [[nodiscard]] std::vector<double> times(const std::vector<double> &x) const;
    // Calls visit(row, column, value) for all elements, mirrored ones included.
    template <class Visit>
    void for_each(Visit &&visit) const {
        for (int64_t j = 0; j < columns_.size(); ++j) {
            for_each_of(j, [&](int64_t row, const DoubleDouble &value) { visit(row, j, value.high); });
        }
    }
    // The order in which to eliminate the coordinates of the unknowns; those of one unknown follow each
    // other.
    [[nodiscard]] std::vector<int64_t> elimination_order(int dim) const;

private:
    // Calls visit(row, value) for the elements of a column.
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

// The Levenberg-Marquardt equations: they give the change d of the control points that minimises
//     sum_i w_i (r_i - sum_a b_a d_a)^T W_i (r_i - sum_a b_a d_a) + lambda P(x + d) + mu u |d|^2
// with r_i and W_i of SquaredDistance, the basis functions b_a at foot i, and the mean u of the diagonal of
// the first term. Unknowns are the coordinates of the distinct control points. Elements are stored at the
// places of the pattern, each a symmetric matrix of dim rows.
class CloudEquations {
public:
    CloudEquations(const Spline::Axes &axes, int dim, const CloudPenalty &penalty);

    // Adds the model of a point; `functions` are the b_a at its foot.
    void add(const ActiveFunctions &functions, double weight, const SquaredDistance &model);
    // Adds the penalty at x and completes the equations.
    void finish(double lambda, const std::vector<double> &x);

    struct Step {
        std::vector<double> change; // [unknowns][dim]
        double promise;             // by how much the sum decreases
    };
    // Nothing where rounding leaves the equations without a solution.
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
