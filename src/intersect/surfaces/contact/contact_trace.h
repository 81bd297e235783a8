// SPDX-License-Identifier: MIT
// Traces curves along which two surfaces touch.
#pragma once

#include "intersect/surfaces/contact/contact_point.h"
#include "intersect/surfaces/curves/cross_segment.h"

namespace nrb::intersect {

// Parameters of the places are continuous: they leave the domain where a surface closes.
struct ContactCurve {
    std::vector<ContactPoint> places;
    std::vector<CrossSegment> segments; // between the places, with parameters in the ranges of their pieces
    bool closed = false;
    bool ends = true; // whether both ends are at borders of a surface; if not, the curve was lost
};

// Marching: from a place of contact in both directions, with segments that end at each side of a piece. They
// are made as long as their deviations from both surfaces allow, which are bounded as in CrossFitter.
class ContactTracer {
public:
    // tolerance: in the frame.
    ContactTracer(const ContactSolver &solver, const std::array<int, 2> &degrees_a,
                  const std::array<int, 2> &degrees_b, double tolerance);

    [[nodiscard]] ContactCurve trace(const ContactPoint &start);
    // Whether |h| is within the tolerance all along the curve. change: ContactChart::change(), the largest
    // second derivative of h along the ridge. Finds as many places with h = 0 as are needed for that.
    [[nodiscard]] bool is_contact(const ContactCurve &curve, double change) const;
    // Whether a place is on a curve.
    [[nodiscard]] bool passes(const ContactCurve &curve, const ContactPoint &place) const noexcept;

    // A segment between two places, with the tangents `along` there, or opposite ones if way < 0; false: its
    // deviation is larger than the tolerance.
    [[nodiscard]] bool fit(const ContactPoint &from, const ContactPoint &to, double way,
                           CrossSegment &segment) const;
    // The first side of a piece that a coordinate reaches on the way from one place to another, at a share of
    // the way.
    struct Break {
        size_t coordinate = 4; // 4: none
        double share = 1, at = 0;
    };
    [[nodiscard]] Break first_break(const CrossPlace &from, const CrossPlace &to) const noexcept;

private:
    enum class End { none, closed, border, lost };
    struct Step {
        ContactPoint to;
        CrossSegment segment;
        bool border = false;
    };

    End follow(const ContactPoint &start, double way, std::vector<ContactPoint> &places,
               std::vector<CrossSegment> &segments);
    bool step(const ContactPoint &from, double way, Step &result) const;
    [[nodiscard]] std::optional<ContactPoint> next(const ContactPoint &from, double length) const;
    bool stop_at_break(const ContactPoint &from, double way, Step &result) const;
    // The first break of coordinate i between two values; NaN: there is none.
    [[nodiscard]] double break_between(size_t i, double from, double to) const noexcept;
    [[nodiscard]] bool is_border(size_t i, double at) const noexcept;
    [[nodiscard]] bool are_near(const CrossSegment &segment, double t,
                                const ContactPoint &place) const noexcept;
    [[nodiscard]] double largest_gap(size_t surface, CrossSegment &segment, const CrossPlace &middle) const;

    const ContactSolver &solver_;
    double tolerance_;
    CubicSamples samples_;
    mutable std::vector<double> sampling_;
};

} // namespace nrb::intersect
