// SPDX-License-Identifier: MIT
// The equations of a step: which changes of the control points make a sum of quadratic models least.
#pragma once

#include "fit/cloud/squared_distance.h"
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

    [[nodiscard]] int64_t unknown(const Index &layer) const noexcept { return form_.unknown(layer); }
    [[nodiscard]] int64_t size() const noexcept { return form_.size(); }
    // Of x [unknowns][dim].
    [[nodiscard]] double of(const std::vector<double> &x) const;
    // P x.
    [[nodiscard]] std::vector<double> times(const std::vector<double> &x) const;
    // Calls visit(row, column, value) for all elements, mirrored ones too.
    template <class Visit>
    void for_each(Visit &&visit) const {
        for (int64_t j = 0; j < columns_.size(); ++j) {
            for (auto p = static_cast<size_t>(columns_.starts[static_cast<size_t>(j)]);
                 p < static_cast<size_t>(columns_.starts[static_cast<size_t>(j) + 1]); ++p) {
                visit(int64_t{columns_.rows[p]}, j, columns_.values[p].high);
            }
        }
    }
    // In which order to eliminate coordinates of unknowns, those of one after the other.
    [[nodiscard]] std::vector<int64_t> elimination_order(int dim) const;

private:
    StencilMatrix form_;
    ColumnsOf<DoubleDouble> columns_;
};

// The change d that makes sum_i w_i (r_i - sum_a b_a d_a)^T W_i (r_i - sum_a b_a d_a) + lambda P(x + d) + mu u |d|^2 least,
// u the mean of the diagonal of the first term. Unknowns are the coordinates of control points that differ. Elements are kept
// as those of StencilMatrix are, each a symmetric matrix of dim rows.
class CloudEquations {
public:
    CloudEquations(const Spline::Axes &axes, int dim, const CloudPenalty &penalty);

    // The functions b of each axis that do not vanish at the foot, the first of which is that of layer `first`.
    void add(const Index &first, const std::array<std::span<const double>, max_axes> &functions,
             double weight, const SquaredDistance &model);
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
        size_t a, b;
        int64_t place;
    };
    void make_pairs(const Spline::Axes &axes);
    [[nodiscard]] std::vector<Entry> entries(double lambda);
    template <class Visit>
    void for_each_element(Visit &&visit) const;

    const CloudPenalty &penalty_;
    size_t dim_, half_; // elements of a symmetric matrix of dim rows
    Index counts_{1, 1, 1}, reach_{};
    std::array<bool, max_axes> periodic_{};
    std::vector<Index> functions_; // of a span, from its first one
    std::vector<Pair> pairs_;
    std::vector<Index> offsets_;
    std::vector<double> matrix_, right_;
    double unit_ = 0;
    std::unique_ptr<SparseSystem> system_;
    // Of a point.
    std::vector<double> values_;
    std::vector<int64_t> unknowns_;
};

} // namespace nrb::fit
