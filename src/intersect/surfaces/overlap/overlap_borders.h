// SPDX-License-Identifier: MIT
// The parts of the borders of two surfaces that run on the other surface: the candidates for the boundary of
// an overlap.
#pragma once

#include "intersect/surfaces/overlap/overlap_ground.h"

#include <vector>

namespace nrb::intersect {

// A side of a domain at which the surface ends: it is neither a seam nor a pole.
struct OverlapSide {
    size_t surface = 0, axis = 0, end = 0;
    double at = 0;       // the parameter of the axis
    Interval range{};    // of the free parameter
    bool closes = false; // whether the surface closes along the side
    double period = 0;
    SplinePtr curve;

    // Indices into a CrossPlace of the parameter that is fixed on the side, and of the free one.
    [[nodiscard]] size_t fixed() const noexcept { return 2 * surface + axis; }
    [[nodiscard]] size_t free() const noexcept { return 2 * surface + 1 - axis; }
    // Whether the surface is on the left of the side in its domain, as the free parameter rises.
    [[nodiscard]] bool is_left() const noexcept { return (axis == 1) == (end == 0); }
};

// A part of a side that is within the tolerance of the other surface, with places along it. Parameters are
// continuous: they leave the domain where a surface closes.
struct OverlapRun {
    size_t side = 0;
    bool closed = false;
    std::vector<CrossPlace> places; // by rising free parameter
    std::array<CrossPlace, 2> ends{};
};

struct OverlapBorders {
    std::vector<OverlapSide> sides;
    std::vector<OverlapRun> runs;
    // Single places where a border is near the other surface, which need not belong to an overlap.
    std::vector<CrossPlace> single;
};

// Follows a side, with the feet of its points on the other surface.
class OverlapFollower {
public:
    explicit OverlapFollower(const OverlapGround &ground) : ground_(ground) {}

    // The place with the free parameter `to`, found from the place `from` nearby; none: it is not found.
    [[nodiscard]] std::optional<CrossPlace> next(const OverlapSide &side, const CrossPlace &from,
                                                 double to) const;
    // The place of a run with the free parameter t; none: it is not found.
    [[nodiscard]] std::optional<CrossPlace> at(const OverlapSide &side, const OverlapRun &run,
                                               double t) const;

private:
    const OverlapGround &ground_;
};

// All sides, and all of their parts that run on the other surface. None: it is left open what a border does,
// or a surface has a jump inside. tolerance, near: the same tolerance in the unit of the caller, and in the
// frame.
std::optional<OverlapBorders> overlap_borders(const OverlapGround &ground, double tolerance, double near);

} // namespace nrb::intersect
