// SPDX-License-Identifier: MIT
// Cubic segments along common arcs of two surfaces, each with a proven bound of its deviation.
#pragma once

#include "intersect/levels/curves/sample_kernel.h"
#include "intersect/surfaces/cross_arc.h"

#include <array>
#include <vector>

namespace nrb::intersect {

// Bezier points of three cubics over an interval of this length: in the parameter domains of both surfaces,
// and in space, in the frame that both share.
struct CrossSegment {
    double length = 0;
    std::array<std::array<std::array<double, 2>, 4>, 2> on{};
    std::array<std::array<double, 3>, 4> space{};
    double deviation = 0;           // of all three, in space, from the common curve
    std::array<double, 4> slopes{}; // bounds of derivatives nearby, by u, v, s and t
};

// Reverses the curve that the segments make up.
void reverse(std::vector<CrossSegment> &segments) noexcept;

// Fits cubic Hermite segments to arcs, with the points at both ends, and tangents that have length 1 in
// space. The difference between the curve in space and either surface along its curve in the domain, times
// the weight, is a polynomial of the parameter. A polynomial of degree n is nowhere more than sqrt 2 times as
// large as at 2 n + 1 Chebyshev points: as a trigonometric polynomial of degree n, it falls from its largest
// value no faster than the cosine of n times the angle (M. Riesz, Jahresber. Dtsch. Math.-Ver. 23 (1914)),
// and no angle is farther than pi / (4 n) from that of a point. The sum of both differences bounds |F| at the
// places on both surfaces, and so, in the chart of the arc, how far these are from the zero with the same
// coordinate k (CrossChart::off_at()).
class CrossFitter {
public:
    // tolerance: in the frame.
    CrossFitter(const std::array<int, 2> &degrees_a, const std::array<int, 2> &degrees_b, double tolerance);

    void fit(const CrossArc &arc, std::vector<CrossSegment> &segments);

    // Where differences are sampled, and working memory for it.
    [[nodiscard]] static CubicSamples samples_for(const std::array<int, 2> &degrees_a,
                                                  const std::array<int, 2> &degrees_b);
    [[nodiscard]] static std::vector<double> sampling_for(const std::array<int, 2> &degrees_a,
                                                          const std::array<int, 2> &degrees_b);

private:
    // A zero on the arc: its place and its point, with the tangents of length 1 in space.
    struct Node {
        CrossPlace at{}, tangent_on{};
        std::array<double, 3> point{}, tangent{};
    };

    void set_arc(const CrossArc &arc);
    [[nodiscard]] Node node(const CrossPlace &at) const noexcept;
    void fit_between(const Node &a, const Node &b, int depth, std::vector<CrossSegment> &segments);
    void divide(const Node &a, const Node &b, double deviation, int depth,
                std::vector<CrossSegment> &segments);
    // The curves in the domains are in places of the parts.
    [[nodiscard]] CrossSegment hermite(const Node &a, const Node &b) const noexcept;
    void stay_in_pieces(CrossSegment &segment) const noexcept;
    void set_deviation(CrossSegment &segment);
    bool limit_to_box(const CrossSegment &segment, CrossPlace &off) const noexcept;
    // How far, in space, points of a surface move at most if their places are off by this.
    [[nodiscard]] double moved_by(const CrossPlace &off, size_t surface) const noexcept;
    [[nodiscard]] double largest_gap(const CrossSegment &segment, size_t surface);
    void to_parameters(CrossSegment &segment) const noexcept;

    double tolerance_;
    CubicSamples samples_;
    std::vector<double> sampling_;
    const CrossArc *arc_ = nullptr;
    std::array<double, 4> slopes_{}; // bounds of derivatives by places in the parts
    double rounding_ = 0;            // of parameters, as moved in space
    int left_ = 0;                   // segments that the present arc may still have
};

} // namespace nrb::intersect
