// One tensor product of nested rules on one element.
#pragma once

#include "query/measure/nested_rule.h"
#include "query/measure/tensor_integral.h"

namespace nrb {

using Levels = std::array<int, max_axes>;

// The sums of an integrand over an element: by the rules of some levels, and by those of the two levels below
// along each axis.
class TensorRule {
public:
    TensorRule(const Elements &elements, const Integrand &integrand);

    // `net`: as in Element. Cost: one call of the integrand for each node, nodes of weight 0 left out.
    void evaluate(const double *net, const std::vector<double> &origin, const Levels &levels);

    [[nodiscard]] double value(int j) const noexcept { return sums_[static_cast<size_t>(j)]; }
    [[nodiscard]] double magnitude(int j) const noexcept { return magnitudes_[static_cast<size_t>(j)]; }
    // Of the rule along one axis; 0 for polynomials that it integrates exactly.
    [[nodiscard]] double error(int axis, int j) const noexcept;
    [[nodiscard]] double difference(int axis, int j) const noexcept;

private:
    void expand(const double *net, const Levels &levels);
    void visit_node(int64_t node, const std::vector<double> &origin);
    void add(const std::array<int, max_axes> &at, const Levels &levels);
    // Sums over rule `below` levels lower along an axis.
    [[nodiscard]] double lower(int axis, int below, int j) const noexcept {
        return sums_[static_cast<size_t>((2 * axis + below) * values_ + j)];
    }

    const Integrand &integrand_;
    int axes_, dim_, values_;
    bool rational_;
    std::array<int, max_axes> degrees_{};
    int64_t coefficients_;
    std::array<std::vector<double>, max_axes> basis_, derivatives_;
    std::array<std::vector<double>, max_axes + 1> nodes_; // derivatives along each axis, then values
    std::vector<double> work_;
    int64_t node_count_ = 1;
    std::vector<double> place_, first_, out_;
    std::vector<double> sums_, magnitudes_;
    std::array<bool, max_axes> exact_{};
    bool positive_ = false, negative_ = false; // values of the first function seen
};

} // namespace nrb
