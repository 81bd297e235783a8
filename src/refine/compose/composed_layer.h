// SPDX-License-Identifier: MIT
// Control points of a composition whose supports hold several cells.
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

// A control point is the mean of G(F(..), F(..), ...) over all ways to give q of its knots to each argument of the polar form G of
// the outer function, with F that of the inner curve, of degree q. Ways that differ in the order of the arguments of an axis are
// taken once, and what control points between the same knots have in common is made once. Terms are added up as if in twice the
// precision.
class ComposedLayer {
public:
    // All must outlive this.
    ComposedLayer(const Spline &g, const Spline &f, const std::vector<CurvePiece> &pieces,
                  const Spline::Axes &axes);

    // Windows of the same knots, which differ in the copies of them; block: the control points of g that are active in the cell,
    // last axis fastest. Both must outlive the control points.
    void begin(std::span<const CommonKnots::Window> windows, std::span<const double> knots,
               const SpanCell &cell, const double *block);
    // The record of the control point of one of the windows, valid until the next one.
    const std::vector<double> &make(const CommonKnots::Window &window);

private:
    // Knots for an argument, and the values and the weight of f there.
    struct Choice {
        Copies copies;
        std::array<double, max_axes> values;
        double weight;
        double orders; // of the knots, where equal ones do not count
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
    std::array<std::vector<double>, max_axes> parts_; // of the first axis for all shares

    // Of the windows between the present knots.
    const SpanCell *cell_ = nullptr;
    size_t knots_ = 0;
    std::vector<Choice> choices_;
    std::vector<ArgumentChoice> of_axis_;
    std::array<DistributedRows, max_axes> rows_;

    // Of the control point that is being made.
    Copies left_{}; // of the knots
    std::vector<CompensatedSum> sums_;
    CompensatedSum total_;
    int64_t terms_ = 0;
    const double *only_ = nullptr;
    std::vector<double> record_;
};

} // namespace nrb::refine
