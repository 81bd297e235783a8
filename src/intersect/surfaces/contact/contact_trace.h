// SPDX-License-Identifier: MIT
// Curves along which two surfaces touch.
#pragma once

#include "intersect/surfaces/contact/contact_point.h"
#include "intersect/surfaces/curves/cross_segment.h"

namespace nrb::intersect {

// Parameters run on beyond domains that close, from each place to the next.
struct ContactCurve {
    std::vector<ContactPoint> places;
    std::vector<CrossSegment> segments; // between them, over parameters of the pieces that they are in
    bool closed = false;
    bool ends =
        true; // whether both ends are where a surface ends; if not it is left open how the curve goes on
};

// From a place of contact to both sides, from one side of pieces to the next: segments as long as their distances from both surfaces
// allow, which are bounded as those of CrossFitter.
class ContactTracer {
public:
    // tolerance: in the frame.
    ContactTracer(const ContactSolver &solver, const std::array<int, 2> &degrees_a,
                  const std::array<int, 2> &degrees_b, double tolerance);

    [[nodiscard]] ContactCurve trace(const ContactPoint &start);
    // Whether |h| is no larger than the tolerance all along, if it changes by no more than change dx^2 / 2 between places where it
    // and its derivative are 0, as they are in as many places of the curve as that takes.
    [[nodiscard]] bool is_contact(const ContactCurve &curve, double change) const;
    // Whether a place is on a curve.
    [[nodiscard]] bool passes(const ContactCurve &curve, const ContactPoint &place) const noexcept;

    // A segment between places on both surfaces along a curve that runs through them, or against it (way < 0); false: it
    // is farther from a surface than the tolerance.
    [[nodiscard]] bool fit(const ContactPoint &from, const ContactPoint &to, double way,
                           CrossSegment &segment) const;
    // The first side of a piece that a coordinate reaches on the way from one place to another, by shares of the way.
    struct Break {
        size_t coordinate = 4; // none
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
    // Of coordinate i; NaN: there is none.
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
