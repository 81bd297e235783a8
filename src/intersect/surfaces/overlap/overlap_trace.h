// SPDX-License-Identifier: MIT
// Traces curves along the side of one surface where it runs on the other surface.
#pragma once

#include "intersect/surfaces/contact/contact_trace.h"
#include "intersect/surfaces/overlap/overlap_borders.h"

namespace nrb::intersect {

class OverlapTracer {
public:
    // near: the tolerance in the frame.
    OverlapTracer(const OverlapGround &ground, const ContactTracer &tracer, double near)
        : ground_(ground), tracer_(tracer), follower_(ground), near_(near) {}

    // The segments from one place of a side to another, by rising free parameter. along: the side of the
    // other surface along which the curve runs as well, or null. None: no curve is found within the
    // tolerance.
    [[nodiscard]] std::optional<std::vector<CrossSegment>> trace(const OverlapSide &side,
                                                                 const OverlapSide *along,
                                                                 const CrossPlace &start,
                                                                 const CrossPlace &end) const;

private:
    [[nodiscard]] std::optional<ContactPoint> contact(const OverlapSide &side, const OverlapSide *along,
                                                      const CrossPlace &place) const;
    [[nodiscard]] std::optional<CrossPlace> step(const OverlapSide &side, const CrossPlace &from,
                                                 const CrossPlace &end, double length) const;
    bool stop_at_break(const OverlapSide &side, const CrossPlace &from, CrossPlace &to) const;
    bool stop_at_line(const OverlapSide &side, const CrossPlace &from, size_t coordinate, double line,
                      CrossPlace &to) const;
    void set_end(const CrossPlace &at, CrossSegment &segment, size_t place) const noexcept;

    const OverlapGround &ground_;
    const ContactTracer &tracer_;
    OverlapFollower follower_;
    double near_;
};

} // namespace nrb::intersect
