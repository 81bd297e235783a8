// SPDX-License-Identifier: MIT
// Control points of a composition whose supports hold several cells.
#pragma once

#include "numeric/sum.h"
#include "refine/algebra/common_knots.h"
#include "refine/compose/crossings.h"
#include "refine/compose/span_cells.h"
#include "refine/knots/blossom.h"
#include "spline/spline.h"

#include <array>
#include <span>
#include <vector>

namespace nrb::refine {

// A control point is the mean of G(F(..), F(..), ...) over all ways to give q of its knots to each argument of the polar form G of
// the outer function, with F that of the inner curve, of degree q. Ways that differ in the order of the arguments of an axis are
// taken once, and rows of coefficients that begin alike are made together. Terms are added up as if in twice the precision.
class ComposedLayer {
public:
    // All must outlive this.
    ComposedLayer(const Spline &g, const Spline &f, const std::vector<CurvePiece> &pieces,
                  const Spline::Axes &axes);

    // The record of the control point, valid until the next one. knots: those of its window; block: the control points of g that
    // are active in the cell, last axis fastest.
    const std::vector<double> &make(const CommonKnots::Window &window, std::span<const double> knots,
                                    const SpanCell &cell, const double *block);

private:
    // Knots of the window for an argument, and the values and the weight of f there.
    struct Choice {
        std::array<int, max_basis> copies;
        std::array<double, max_axes> values;
        double weight;
    };
    // Those of an axis: first the ones whose values are knots of it, which shorten the rows.
    struct AxisChoices {
        std::vector<const Choice *> all;
        size_t knots = 0;
        std::vector<std::array<int, max_basis>> most; // copies of each knot, in any choice from this one on
    };

    void list_choices(const CommonKnots::Window &window, std::span<const double> knots);
    [[nodiscard]] Choice choice_of(const int *chosen, std::span<const double> knots) const noexcept;
    void order_choices(size_t k);
    [[nodiscard]] double ways_of(const Choice &choice) const noexcept;
    [[nodiscard]] bool are_enough(const std::array<int, max_basis> &most, int arguments) const noexcept;
    void take(const Choice &choice, int times) noexcept;
    void next_axis(int k, const double *points, double times);
    void next_argument(int k, int number, size_t place, int run, const OpenRow *row, const double *points,
                       double times);
    void contract_axis(int k, const OpenRow &row, const double *points) noexcept;
    [[nodiscard]] double product_of_weights() const noexcept;

    const Spline &g_, &f_;
    const std::vector<CurvePiece> &pieces_;
    const Spline::Axes &axes_;
    bool weighted_;
    std::array<int64_t, max_axes> lengths_{};
    std::array<std::vector<double>, max_axes> parts_;

    // Of the control point that is being made.
    const SpanCell *cell_ = nullptr;
    int window_size_ = 0;
    std::array<int, max_basis> left_{}; // of the knots
    std::vector<Choice> choices_;
    std::array<AxisChoices, max_axes> of_axis_;
    std::array<std::array<double, max_basis>, max_axes> arguments_{}, weights_{};
    std::array<std::array<OpenRow, max_basis>, max_axes> rows_;
    std::vector<CompensatedSum> sums_;
    CompensatedSum total_;
    int64_t terms_ = 0;
    const double *only_ = nullptr;
    double only_weight_ = 1;
    std::vector<double> record_;
};

} // namespace nrb::refine
