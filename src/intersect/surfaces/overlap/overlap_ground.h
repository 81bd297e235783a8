// SPDX-License-Identifier: MIT
// Evaluation, foot points and borders of two surfaces that may overlap, as all steps of the search for
// overlaps need them.
#pragma once

#include "intersect/surfaces/contact/contact_point.h"

#include <optional>

namespace nrb::intersect {

// All places are given by parameters, which may leave the domain where a surface closes.
class OverlapGround {
public:
    // frame: the common one of both; points are in it. All arguments must outlive the object.
    OverlapGround(const Spline &a, const Spline &b, const pieces::Frame &frame, const ContactSolver &solver)
        : splines_{&a, &b}, frame_(frame), solver_(solver) {}

    struct Point {
        Vector3 at;
        std::array<Vector3, 2> slope; // derivatives by parameters
    };
    // None: the weights are not positive, a degree is 0, or the place is far beyond the domain.
    [[nodiscard]] std::optional<Point> point(size_t surface, const double *at) const;
    // Newton's method from `at` to the foot of a point on the surface, to rounding; false: it is not found.
    [[nodiscard]] bool find_foot(size_t surface, const Vector3 &of, double *at) const;
    // The parameters of the point of the whole surface that is nearest to a point; none: it is farther than
    // `near`.
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
    // How far apart two places are in space: the largest difference of a parameter, times the derivative at
    // the first place. Where a surface closes, whole periods do not count.
    [[nodiscard]] double apart(const CrossPlace &at, const CrossPlace &other) const;

private:
    std::array<const Spline *, 2> splines_;
    const pieces::Frame &frame_;
    const ContactSolver &solver_;
};

} // namespace nrb::intersect
