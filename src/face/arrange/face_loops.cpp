// SPDX-License-Identifier: MIT
#include "face/arrange/face_loops.h"

#include "build/polylines.h"
#include "face/open_ends.h"

#include <algorithm>
#include <cmath>

namespace nrb::face {

namespace {

ArrangedLoop segment(const Point2 &from, const Point2 &to, int32_t owner, bool in_a_point) {
    const SplinePtr line = build::polyline(2, {from[0], from[1], to[0], to[1]}, {0, 1});
    return {{{{line, {0, 0}}}, {0, 0}}, owner, in_a_point};
}

bool is_rounding(const Covering &covering, const Joint &joint) noexcept {
    constexpr double rounding = 0x1p-40; // of the reach of an axis
    return std::abs(joint.to[0] - joint.from[0]) <= rounding * covering.reach(0) &&
           std::abs(joint.to[1] - joint.from[1]) <= rounding * covering.reach(1);
}

// The end of the domain that a part lies along: 0 for the lower end of the axis, 1 for the upper one.
struct End {
    int axis;
    int end;

    End(const Covering &covering, const EndPart &part) noexcept
        : axis(part.from[0] == part.to[0] ? 0 : 1),
          end(part.from[static_cast<size_t>(axis)] == covering.domain(axis).upper ? 1 : 0) {}
    // Whether the direction that has the domain to the left is that to smaller parameters.
    [[nodiscard]] bool runs_back() const noexcept { return (axis == 0) == (end == 0); }
};

// The value that the loops alone leave beyond an end of the domain: the value at the corner and all that is
// passed on the way from there, along the seam and, for the lower end of axis 1, down a column.
int value_beyond(const Face &face, const EndPart &part, const End &end) {
    const TrimMap &trims = face.trims();
    const Covering &covering = face.covering();
    if (end.axis == 0) {
        const double u = part.from[0], period = covering.period(0);
        return trims.value_at_top(end.end == 0 ? u - period : u + period);
    }
    const double u = part.from[0] / 2 + part.to[0] / 2;
    int value = trims.value_at_top(u);
    if (end.end == 0) {
        trims.in_column(u, [&](const TrimPiece &piece) { value += trims.passed(piece); });
    }
    return value;
}

} // namespace

double largest_gap(const Face &face) {
    double largest = 0;
    for (const Loop &loop : face.loops()) {
        largest = std::max(largest, largest_gap(*face.surface(), face.covering(), loop));
    }
    return largest;
}

std::vector<ArrangedLoop> loops_of(const Face &face, int32_t owner) {
    const Covering &covering = face.covering();
    std::vector<ArrangedLoop> result;
    for (const Loop &loop : face.loops()) {
        result.push_back({placed(*face.surface(), covering, loop, face.tolerance()), owner});
    }
    for (const Joint &joint : face.joints()) {
        if (!is_rounding(covering, joint)) {
            result.push_back(segment(joint.from, joint.to, owner, true));
        }
    }
    for (const EndPart &part : open_ends(face)) {
        const End end(covering, part);
        if (value_beyond(face, part, end) > 0) {
            const bool back = end.runs_back();
            result.push_back(segment(back ? part.to : part.from, back ? part.from : part.to, owner,
                                     covering.collapsed(end.axis, end.end)));
        }
    }
    return result;
}

AtCorner::AtCorner(const Arrangement &arrangement)
    : corner_{arrangement.covering().domain(0).lower, arrangement.covering().domain(1).lower},
      closed_(arrangement.covering().closed(0) && arrangement.covering().closed(1)) {}

void AtCorner::add(const Face &face, int32_t owner) {
    const int side = closed_ ? face.trims().side(corner_) : -1;
    if (side == 0) {
        fail_undecided(corner_);
    }
    if (side > 0) {
        sums_.push_back({owner, 1});
        sums_ = summed(std::move(sums_));
    }
}

} // namespace nrb::face
