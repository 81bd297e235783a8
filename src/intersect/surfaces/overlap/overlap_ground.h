// SPDX-License-Identifier: MIT
// Places of two surfaces that may be one in a region.
#pragma once

#include "intersect/surfaces/contact/contact_point.h"

#include <optional>

namespace nrb::intersect {

// By parameters, which may run beyond domains that close.
class OverlapGround {
public:
    // frame: that of both, in which points are told. Splines outlive it.
    OverlapGround(const Spline &a, const Spline &b, const pieces::Frame &frame, const ContactSolver &solver)
        : splines_{&a, &b}, frame_(frame), solver_(solver) {}

    struct Point {
        Vector3 at;
        std::array<Vector3, 2> slope; // by parameters
    };
    // None: weights are not positive, or it is far beyond the domain.
    [[nodiscard]] std::optional<Point> point(size_t surface, const double *at) const;
    // From a place near it to the foot of a point of the other surface, to rounding.
    [[nodiscard]] bool find_foot(size_t surface, const Vector3 &of, double *at) const;
    // The nearest place of all of a surface; none: it is farther than what counts as near.
    [[nodiscard]] std::optional<std::array<double, 2>> nearest(size_t surface, const Vector3 &of,
                                                               double near) const;

    [[nodiscard]] const Spline &spline(size_t surface) const noexcept { return *splines_[surface]; }
    [[nodiscard]] CrossGround &pieces(size_t surface) const noexcept { return solver_.ground(surface); }
    [[nodiscard]] const pieces::PieceGrid &grid(size_t surface) const noexcept {
        return solver_.ground(surface).grid;
    }
    [[nodiscard]] const SurfaceBorders &borders(size_t surface) const noexcept {
        return solver_.ground(surface).borders;
    }
    [[nodiscard]] Interval domain(size_t surface, size_t axis) const noexcept;
    [[nodiscard]] const ContactSolver &solver() const noexcept { return solver_; }
    [[nodiscard]] const pieces::Frame &frame() const noexcept { return frame_; }
    // How far apart two places are in space, along the parameter in which they are farthest, as slopes at the first one tell;
    // where surfaces close their periods are left out.
    [[nodiscard]] double apart(const CrossPlace &at, const CrossPlace &other) const;

private:
    std::array<const Spline *, 2> splines_;
    const pieces::Frame &frame_;
    const ContactSolver &solver_;
};

} // namespace nrb::intersect
