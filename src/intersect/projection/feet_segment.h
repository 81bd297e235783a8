// SPDX-License-Identifier: MIT
// Cubic pieces of curves along arcs of feet, each with a proven bound of its distance.
#pragma once

#include "intersect/projection/feet/feet_kernel.h"
#include "intersect/projection/feet_search.h"
#include "intersect/surfaces/curves/cross_segment.h"

#include <vector>

namespace nrb::intersect {

// As for CrossFitter: with places and tangents at both ends (Hermite), over a length that is measured in space on the surface and
// on the curve together, as one of both may stand still. F on the cubic is a polynomial of the parameter, and so are the
// difference of the curve in space from the surface, and h^2 w^2 W^2 - |A W - B w|^2, which tells how far h is from the distance
// of both places: all of them are at most sqrt 2 times as large as at 2 n + 1 Chebyshev points. In the chart of the arc F bounds
// how far places are from those of the feet.
class FeetFitter {
public:
    // tolerance: in the frame; degrees: of the surface, and of the curve.
    FeetFitter(const std::array<int, 2> &surface, int curve, const pieces::Frame &frame, double tolerance);

    void fit(const FeetArc &arc, std::vector<CrossSegment> &segments);
    // The signed distance, in the unit of the caller.
    [[nodiscard]] double distance_at(const FeetArc &arc, const FeetPlace &at) const noexcept;

private:
    struct Node {
        FeetPlace at{}, tangent_on{};
        std::array<double, 3> point{}, tangent{}, tangent_of_curve{};
        double distance = 0, slope = 0; // h
    };

    void set_arc(const FeetArc &arc);
    [[nodiscard]] Node node(const FeetPlace &at) const noexcept;
    void fit_between(const Node &a, const Node &b, int depth, std::vector<CrossSegment> &segments);
    void divide(const Node &a, const Node &b, double deviation, int depth,
                std::vector<CrossSegment> &segments);
    // In places of the parts, and distances in the frame.
    [[nodiscard]] CrossSegment hermite(const Node &a, const Node &b) const noexcept;
    void stay_in_pieces(CrossSegment &segment) const noexcept;
    void set_deviation(CrossSegment &segment);
    [[nodiscard]] LargestOfFeet largest_on(const CrossSegment &segment);
    [[nodiscard]] bool limit_to_box(const CrossSegment &segment, FeetPlace &off) const noexcept;
    // Of places at which |F| is no larger: how far they are off by coordinates.
    [[nodiscard]] FeetPlace off_at(const std::array<double, 2> &value) const noexcept;
    [[nodiscard]] double least_deviation() const noexcept;
    void to_parameters(CrossSegment &segment) const noexcept;

    const pieces::Frame &frame_;
    double tolerance_;
    CubicSamples samples_;
    std::vector<double> sampling_;
    const FeetArc *arc_ = nullptr;
    std::array<double, 3> speeds_{}; // the largest ones, by places in the parts
    double rounding_ = 0;            // of points, with what parameters make of them
    double least_weight_ = 1, least_of_curve_ = 1;
    int left_ = 0; // segments that the present arc may still have
};

} // namespace nrb::intersect
