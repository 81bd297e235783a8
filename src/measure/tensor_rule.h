// SPDX-License-Identifier: MIT
// A tensor product of nested quadrature rules on one element.
#pragma once

#include "measure/tensor_integral.h"
#include "numeric/nested_rule.h"

#include <algorithm>

namespace nrb::measure {

using Levels = std::array<int, max_axes>;

// The integrals over an element by the rules of given levels, one for each axis, with an error estimate for
// each axis from the sums across all other axes.
class TensorRule {
public:
    TensorRule(const Elements &elements, const Integrand &integrand);

    // `net`: as in Element. Cost: one call of the integrand per node; nodes of weight 0 are left out.
    void evaluate(const double *net, const std::vector<double> &origin, const Levels &levels);

    [[nodiscard]] double value(size_t j) const noexcept { return decay(0, j).integral; }
    [[nodiscard]] double magnitude(size_t j) const noexcept { return magnitudes_[j]; }
    // The estimated error of the rule along one axis; 0 for polynomials that it integrates exactly.
    [[nodiscard]] double error(int axis, size_t j) const noexcept;
    [[nodiscard]] bool exact() const noexcept {
        return std::all_of(exact_.begin(), exact_.begin() + axes_, [](bool x) { return x; });
    }
    [[nodiscard]] const RuleDecay &decay(int axis, size_t j) const noexcept {
        return decays_[static_cast<size_t>(axis) * values_ + j];
    }

private:
    void expand(const double *net, const Levels &levels);
    void visit_node(int64_t node, const std::vector<double> &origin);
    struct Line {
        const double *weights; // of the nodes of the line, which runs along the last axis
        int size;
        double weight; // product of the weights of the other axes
    };
    void add_line(int64_t first, const Line &line, const std::vector<double> &origin);
    void add_line_sums(const std::array<int, 2> &at, const std::array<double, 2> &weights);
    void finish(const Levels &levels);

    const Integrand &integrand_;
    int axes_, dim_;
    size_t values_;
    bool rational_;
    std::array<int, max_axes> degrees_{};
    int64_t coefficients_;
    std::array<std::vector<double>, max_axes> basis_, derivatives_;
    std::array<std::vector<double>, max_axes + 1> nodes_; // derivatives along each axis, then values
    std::vector<double> work_;
    int64_t node_count_ = 1;
    std::vector<double> place_, first_, out_;
    std::vector<double>
        across_; // [axes][values][rule_capacity]: sums over all nodes with the same position along an axis
    std::vector<double> magnitudes_;
    std::vector<double> line_; // [2][values]: the sums of a line, and those of its magnitudes
    std::vector<RuleDecay> decays_;
    std::array<bool, max_axes> exact_{};
    bool positive_ = false, negative_ = false; // signs of the first value that have been seen
};

} // namespace nrb::measure
