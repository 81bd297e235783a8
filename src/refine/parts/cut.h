// SPDX-License-Identifier: MIT
// Parts of splines: every cut raises a knot to multiplicity degree + 1, after which layers and knots separate
// without further arithmetic (de Casteljau's subdivision, for a single Bezier piece).
#pragma once

#include "refine/knots/axis_table.h"

#include <array>
#include <vector>

namespace nrb::refine {

// The knots with all breaks at multiplicity degree + 1. Precondition: the breaks are sorted and lie in the
// domain.
std::vector<double> saturated(int degree, std::span<const double> knots, std::span<const double> breaks);

// Chosen ends of an axis: of a part, those ends of the domain that are to be clamped like all others.
struct AxisEnds {
    bool lower;
    bool upper;
};

// The part over [lower, upper] of an axis. It is no longer periodic, and is clamped at both new ends and
// where `ends` says so. Precondition: domain.lower <= lower < upper <= domain.upper.
SplinePtr cut_axis(const SplinePtr &spline, int axis, double lower, double upper, AxisEnds ends);

// The chosen ends of the domain clamped; ends that are clamped already stay as they are. An axis that was
// periodic becomes a plain one.
SplinePtr clamp_ends(const SplinePtr &spline, int axis, AxisEnds ends = {true, true});

// The same as cut_axis(), but the ends of the domain stay as they are; the whole domain gives the same
// spline, periodic if it was.
SplinePtr restrict_axis(const SplinePtr &spline, int axis, double lower, double upper);

// A spline whose layers separate into parts, which are made when they are requested.
class PartedSpline {
public:
    // Layers [bounds[i], bounds[i + 1]) belong to part i of an axis; one part: the axis itself.
    using Bounds = std::array<std::vector<int64_t>, max_axes>;
    PartedSpline(SplinePtr whole, Bounds bounds);

    // All parts in one net, not yet separated.
    [[nodiscard]] const Spline &whole() const noexcept { return *whole_; }
    [[nodiscard]] int axes() const noexcept { return whole_->axes(); }
    [[nodiscard]] int64_t parts(int k) const noexcept {
        return std::ssize(bounds_[static_cast<size_t>(k)]) - 1;
    }
    [[nodiscard]] int64_t size() const noexcept { return size_; } // of the product of the axes
    // Last axis fastest.
    [[nodiscard]] SplinePtr part(int64_t index) const;

private:
    SplinePtr whole_;
    Bounds bounds_;
    int64_t size_;
};

// The parts between consecutive breaks, which are rising, distinct, and begin and end with the ends of the
// domain.
PartedSpline split_axis(const SplinePtr &spline, int axis, std::span<const double> breaks);

// The knots of the closed domain at which the order of continuity, degree - multiplicity, is less than
// `order`, and the two ends of the domain: breaks for split_axis(). The seam of a periodic axis counts as an
// end.
std::vector<double> rough_knots(const KnotVector &axis, int order);

// The polynomial pieces as Bezier splines over their own domains.
PartedSpline bezier_pieces(const SplinePtr &spline);

} // namespace nrb::refine
