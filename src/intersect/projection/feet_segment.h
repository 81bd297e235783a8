// SPDX-License-Identifier: MIT
// Cubic Hermite segments along arcs of feet, each with a proven bound of its deviation.
#pragma once

#include "intersect/projection/feet/feet_kernel.h"
#include "intersect/projection/feet_search.h"
#include "intersect/surfaces/curves/cross_segment.h"

#include <vector>

namespace nrb::intersect {

// As CrossFitter: each segment interpolates places and tangents at both ends. Its length is measured in space
// on the surface S = A / w and on the curve C = B / W together, since the foot on one of them may stand
// still. Three polynomials of its parameter bound its deviation: F (FeetNet), which in the chart of the arc
// bounds how far the places are from those of feet; w times the difference of the curve in space from S at
// the places; and h^2 w^2 W^2 - |A W - B w|^2, which bounds how far |h| is from the distance |S - C| of the
// places. Of degree n, each is at most sqrt 2 times as large as at 2 n + 1 Chebyshev points (see
// CrossFitter).
class FeetFitter {
public:
    // surface, curve: their degrees. tolerance: in the frame.
    FeetFitter(const std::array<int, 2> &surface, int curve, const pieces::Frame &frame, double tolerance);

    void fit(const FeetArc &arc, std::vector<CrossSegment> &segments);
    // The signed distance, in the unit of the caller.
    [[nodiscard]] double distance_at(const FeetArc &arc, const FeetPlace &at) const noexcept;

private:
    struct Node {
        FeetPlace at{}, tangent_on{};
        std::array<double, 3> point{}, tangent{}, tangent_of_curve{};
        double distance = 0, slope = 0; // h and its derivative
    };

    void set_arc(const FeetArc &arc);
    [[nodiscard]] Node node(const FeetPlace &at) const noexcept;
    void fit_between(const Node &a, const Node &b, int depth, std::vector<CrossSegment> &segments);
    void divide(const Node &a, const Node &b, double deviation, int depth,
                std::vector<CrossSegment> &segments);
    // (u, v) and t are places in the parts, h is in the frame.
    [[nodiscard]] CrossSegment hermite(const Node &a, const Node &b) const noexcept;
    void stay_in_pieces(CrossSegment &segment) const noexcept;
    void set_deviation(CrossSegment &segment);
    [[nodiscard]] LargestOfFeet largest_on(const CrossSegment &segment);
    [[nodiscard]] bool limit_to_box(const CrossSegment &segment, FeetPlace &off) const noexcept;
    // How far places at which the |F_k| are at most these may be from feet, by coordinates.
    [[nodiscard]] FeetPlace off_at(const std::array<double, 2> &value) const noexcept;
    [[nodiscard]] double least_deviation() const noexcept;
    void to_parameters(CrossSegment &segment) const noexcept;

    const pieces::Frame &frame_;
    double tolerance_;
    CubicSamples samples_;
    std::vector<double> sampling_;
    const FeetArc *arc_ = nullptr;
    std::array<double, 3> speeds_{}; // bounds of the derivatives of points, by places in the parts
    double rounding_ = 0;            // of points, including what the rounding of parameters moves them by
    double least_weight_ = 1, least_of_curve_ = 1; // of w and W
    int left_ = 0;                                 // number of segments that the present arc may still have
};

} // namespace nrb::intersect
