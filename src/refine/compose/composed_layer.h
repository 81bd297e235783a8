// SPDX-License-Identifier: MIT
// The control points of a composition, by blossoming: means over all ways to distribute the knots of a
// window.
#pragma once

#include "numeric/sum.h"
#include "refine/algebra/common_knots.h"
#include "refine/compose/crossings.h"
#include "refine/compose/distributed_rows.h"
#include "refine/compose/span_cells.h"
#include "spline/spline.h"

#include <array>
#include <span>
#include <vector>

namespace nrb::refine {

// Computes control points of g(f(t)). With G the polar form of g, and F that of f, of degree q, a control
// point is the mean of G(F(...), F(...), ...) over all ways to give q of its knots to each argument of G.
// Ways that differ only in the order of the arguments of an axis are computed once, and so is what control
// points between the same knots have in common. The terms are added by compensated summation.
class ComposedLayer {
public:
    // All arguments must outlive this.
    ComposedLayer(const Spline &g, const Spline &f, const std::vector<CurvePiece> &pieces,
                  const Spline::Axes &axes);

    // Prepares for windows that contain the same distinct knots and differ only in their multiplicities.
    // block: the control points of g that are active in the cell, last axis fastest. cell and block must
    // outlive the calls of make().
    void begin(std::span<const CommonKnots::Window> windows, std::span<const double> knots,
               const SpanCell &cell, const double *block);
    // The record of the control point with this window, one of those that begin() was given. It is valid
    // until the next call.
    const std::vector<double> &make(const CommonKnots::Window &window);

private:
    // Knots chosen for one argument of G, and the values and the weight of f at them.
    struct Choice {
        Copies copies;
        std::array<double, max_axes> values;
        double weight;
        double orders; // of the chosen knots, equal ones not distinguished
    };

    void list_choices(const CommonKnots::Window &most, std::span<const double> knots);
    [[nodiscard]] Choice choice_of(const int *chosen, std::span<const double> knots) const noexcept;
    void distribute(size_t k, std::span<const CommonKnots::Window> windows, std::span<const double> knots);
    [[nodiscard]] Interval ends_of(size_t k, std::span<const double> knots) const noexcept;
    [[nodiscard]] CopyBounds bounds_of(size_t k, std::span<const CommonKnots::Window> windows) const noexcept;
    void contract_first(const double *block);
    [[nodiscard]] bool is_left(const Copies &copies) const noexcept;
    void take(const DistributedRows::Share &share, int times) noexcept;
    void next_axis(int k, const double *points, double times);
    void add_share(int k, const DistributedRows::Share &share, const double *points, double times);
    void add_term(const double *points, double times);

    const Spline &g_, &f_;
    const std::vector<CurvePiece> &pieces_;
    const Spline::Axes &axes_;
    bool weighted_;
    std::array<int64_t, max_axes> lengths_{};
    std::array<std::vector<double>, max_axes> parts_; // [0]: for all shares of axis 0

    // Data of the windows between the present knots.
    const SpanCell *cell_ = nullptr;
    size_t knots_ = 0;
    std::vector<Choice> choices_;
    std::vector<ArgumentChoice> of_axis_;
    std::array<DistributedRows, max_axes> rows_;

    // Data of the control point that is being computed.
    Copies left_{}; // of the knots
    std::vector<CompensatedSum> sums_;
    CompensatedSum total_;
    int64_t terms_ = 0;
    const double *only_ = nullptr;
    std::vector<double> record_;
};

} // namespace nrb::refine
