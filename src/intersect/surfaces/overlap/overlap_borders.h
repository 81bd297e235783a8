// SPDX-License-Identifier: MIT
// Borders of two surfaces that run on the other one.
#pragma once

#include "intersect/surfaces/overlap/overlap_ground.h"

#include <vector>

namespace nrb::intersect {

// Where a surface ends: a side that neither closes nor is one point.
struct OverlapSide {
    size_t surface = 0, axis = 0, end = 0;
    double at = 0;       // parameter of the axis
    Interval range{};    // of the other one
    bool closes = false; // along that
    double period = 0;
    SplinePtr curve;

    [[nodiscard]] size_t fixed() const noexcept { return 2 * surface + axis; } // of the four parameters
    [[nodiscard]] size_t free() const noexcept { return 2 * surface + 1 - axis; }
    // Whether the surface is on the left where the free parameter rises.
    [[nodiscard]] bool is_left() const noexcept { return (axis == 1) == (end == 0); }
};

// A part of a side that is within the tolerance of the other surface, with places along it; parameters run on beyond domains
// that close.
struct OverlapRun {
    size_t side = 0;
    bool closed = false;
    std::vector<CrossPlace> places; // the free parameter of the side rises
    std::array<CrossPlace, 2> ends{};
};

struct OverlapBorders {
    std::vector<OverlapSide> sides;
    std::vector<OverlapRun> runs;
    // Where a border is near in a place, which may have nothing to do with any region.
    std::vector<CrossPlace> single;
};

// Along a side, from a place of it.
class OverlapFollower {
public:
    explicit OverlapFollower(const OverlapGround &ground) : ground_(ground) {}

    // The place with a value of the free parameter, next to one; none: it is not found.
    [[nodiscard]] std::optional<CrossPlace> next(const OverlapSide &side, const CrossPlace &from,
                                                 double to) const;
    [[nodiscard]] std::optional<CrossPlace> at(const OverlapSide &side, const OverlapRun &run,
                                               double t) const;

private:
    const OverlapGround &ground_;
};

// All of them; none: it is left open what a border does, or a surface jumps inside. tolerance, near: of the caller, and in the
// frame.
std::optional<OverlapBorders> overlap_borders(const OverlapGround &ground, double tolerance, double near);

} // namespace nrb::intersect
