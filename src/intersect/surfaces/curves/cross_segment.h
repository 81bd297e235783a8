// SPDX-License-Identifier: MIT
// Cubic pieces of curves along common arcs of two surfaces, each with a proven bound of its distance.
#pragma once

#include "intersect/levels/curves/sample_kernel.h"
#include "intersect/surfaces/cross_arc.h"

#include <array>
#include <vector>

namespace nrb::intersect {

// Control points over a length of the parameter: parameters of both surfaces, and points in the frame of both.
struct CrossSegment {
    double length = 0;
    std::array<std::array<std::array<double, 2>, 4>, 2> on{};
    std::array<std::array<double, 3>, 4> space{};
    double deviation = 0;           // of all three, in space, from the common curve
    std::array<double, 4> slopes{}; // the largest ones around, by parameters
};

// So that the curve of all of them runs the other way.
void reverse(std::vector<CrossSegment> &segments) noexcept;

// With points, and tangents of length 1 in space, at both ends (Hermite). The differences of the curve in space from each
// surface over its curve there, times weights, are polynomials of the parameter. Of degree n they are at most sqrt 2 times as
// large as at 2 n + 1 Chebyshev points: a trigonometric polynomial of degree n falls from its largest value no faster than the
// cosine of n times the way (M. Riesz, Jahresber. Dtsch. Math.-Ver. 23 (1914)), and none of these is farther than pi / (4 n)
// from a point. What both add up to bounds |F| of the places on both, and so, in the chart of the arc, how far these are from
// the zero with the same coordinate k (CrossChart::off_at()).
class CrossFitter {
public:
    // tolerance: in the frame.
    CrossFitter(const std::array<int, 2> &degrees_a, const std::array<int, 2> &degrees_b, double tolerance);

    void fit(const CrossArc &arc, std::vector<CrossSegment> &segments);

    // Where differences are sampled, and room for it.
    [[nodiscard]] static CubicSamples samples_for(const std::array<int, 2> &degrees_a,
                                                  const std::array<int, 2> &degrees_b);
    [[nodiscard]] static std::vector<double> sampling_for(const std::array<int, 2> &degrees_a,
                                                          const std::array<int, 2> &degrees_b);

private:
    struct Node {
        CrossPlace at{}, tangent_on{};
        std::array<double, 3> point{}, tangent{};
    };

    void set_arc(const CrossArc &arc);
    [[nodiscard]] Node node(const CrossPlace &at) const noexcept;
    void fit_between(const Node &a, const Node &b, int depth, std::vector<CrossSegment> &segments);
    void divide(const Node &a, const Node &b, double deviation, int depth,
                std::vector<CrossSegment> &segments);
    // In places of the parts.
    [[nodiscard]] CrossSegment hermite(const Node &a, const Node &b) const noexcept;
    void stay_in_pieces(CrossSegment &segment) const noexcept;
    void set_deviation(CrossSegment &segment);
    bool limit_to_box(const CrossSegment &segment, CrossPlace &off) const noexcept;
    // Of places that are off by coordinates: how far the surface over them is in space.
    [[nodiscard]] double moved_by(const CrossPlace &off, size_t surface) const noexcept;
    [[nodiscard]] double largest_gap(const CrossSegment &segment, size_t surface);
    void to_parameters(CrossSegment &segment) const noexcept;

    double tolerance_;
    CubicSamples samples_;
    std::vector<double> sampling_;
    const CrossArc *arc_ = nullptr;
    std::array<double, 4> slopes_{}; // the largest ones, by places in the parts
    double rounding_ = 0;            // of the parameters, in space
    int left_ = 0;                   // segments that the present arc may still have
};

} // namespace nrb::intersect
