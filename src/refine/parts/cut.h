// SPDX-License-Identifier: MIT
// Parts of splines: cutting, clamping, Bezier decomposition. A cut raises the multiplicity of a knot to
// degree + 1, after which layers and knots separate without further arithmetic. For a single Bezier piece
// this is de Casteljau's subdivision.
#pragma once

#include "refine/knots/axis_table.h"

#include <array>
#include <vector>

namespace nrb::refine {

// The knots with every break raised to multiplicity degree + 1. Precondition: the breaks are sorted and lie
// in the domain.
std::vector<double> saturated(int degree, std::span<const double> knots, std::span<const double> breaks);

// Selects ends of the domain of an axis, such as those to be clamped.
struct AxisEnds {
    bool lower;
    bool upper;
};

// The part over [lower, upper] of an axis. The axis is no longer periodic. The part is clamped at ends inside
// the domain, and at the ends of the domain that `ends` selects. Precondition: domain.lower <= lower < upper
// <= domain.upper.
SplinePtr cut_axis(const SplinePtr &spline, int axis, double lower, double upper, AxisEnds ends);

// Clamps the selected ends of the domain; ends that are clamped already stay as they are. A periodic axis
// becomes an ordinary one.
SplinePtr clamp_ends(const SplinePtr &spline, int axis, AxisEnds ends = {true, true});

// The part over [lower, upper], in which ends of the domain stay as they are. The whole domain gives the same
// spline, still periodic if it was.
SplinePtr restrict_axis(const SplinePtr &spline, int axis, double lower, double upper);

// A spline whose layers separate into parts. A part is made when it is requested.
class PartedSpline {
public:
    // Part i of an axis has the layers [bounds[i], bounds[i + 1]). With a single part the axis is not cut.
    using Bounds = std::array<std::vector<int64_t>, max_axes>;
    PartedSpline(SplinePtr whole, Bounds bounds);

    // All parts in one net, not yet separated.
    [[nodiscard]] const Spline &whole() const noexcept { return *whole_; }
    [[nodiscard]] int axes() const noexcept { return whole_->axes(); }
    [[nodiscard]] int64_t parts(int k) const noexcept {
        return std::ssize(bounds_[static_cast<size_t>(k)]) - 1;
    }
    [[nodiscard]] int64_t size() const noexcept { return size_; } // the number of all parts
    // Part `index`, last axis fastest.
    [[nodiscard]] SplinePtr part(int64_t index) const;

private:
    SplinePtr whole_;
    Bounds bounds_;
    int64_t size_;
};

// Cuts an axis at breaks, which are strictly increasing and include both ends of the domain.
PartedSpline split_axis(const SplinePtr &spline, int axis, std::span<const double> breaks);

// The breaks for split_axis() at which a spline may be rough: the knots inside the domain whose order of
// continuity, degree - multiplicity, is less than `order`, and both ends of the domain. The seam of a
// periodic axis counts as an end.
std::vector<double> rough_knots(const KnotVector &axis, int order);

// Bezier decomposition: the polynomial pieces as Bezier splines over their own domains.
PartedSpline bezier_pieces(const SplinePtr &spline);

} // namespace nrb::refine
