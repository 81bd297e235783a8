// SPDX-License-Identifier: MIT
// Where the curves of loops meet each other and themselves.
#pragma once

#include "face/loop.h"
#include "intersect/hits.h"
#include "intersect/rays/box_tree.h"

#include <span>
#include <string>
#include <vector>

namespace nrb::face {

struct LoopCurve {
    SplinePtr spline; // scaled, and moved by periods so that its box begins in the domain
    int loop = 0;
    int index = -1;      // in the loop; -1: a segment that closes a gap
    bool around = false; // whether its loop ends in another copy of the domain
};

// A hit of two curves, or of one with itself. All that the solver reports is here, also ends at which one
// curve continues the other.
struct LoopHit {
    size_t a, b; // indices of curves
    double at_a, at_b;
    Interval range_a, range_b;
    intersect::HitKind kind;
    Point2 move;          // of b, by periods
    bool against = false; // of an overlap: it runs against b
};

// Compares curves in all copies that closed axes make of them, as far as their boxes meet. Each coordinate is
// scaled to units of about a period, so that rounding along a long axis does not hide what happens along a
// short one.
class LoopHits {
public:
    // near: distances of at most this count as none, in units of about a period. Throws Status::not_converged
    // at the limit of work. Cost: n log n for n curves, plus the intersections of those whose boxes meet.
    LoopHits(const Covering &covering, std::span<const ClosedLoop> loops, double near = 0);

    [[nodiscard]] const std::vector<LoopCurve> &curves() const noexcept { return curves_; }
    [[nodiscard]] const std::vector<LoopHit> &all() const noexcept { return hits_; }
    // In the plane that covers the domain, not scaled.
    [[nodiscard]] Point2 place(size_t curve, double t) const;
    // In units of about a period, as distance().
    [[nodiscard]] Point2 scaled(const Point2 &x) const noexcept {
        return {x[0] * scale_[0], x[1] * scale_[1]};
    }
    [[nodiscard]] double distance(const Point2 &x, const Point2 &y) const noexcept;
    // The parameter of the place of a curve that is nearest to x; within a range if that lies in the domain.
    [[nodiscard]] double foot(size_t curve, const Point2 &x, Interval range) const;
    // Positive if x is to the left of the tangent at t.
    [[nodiscard]] double side(size_t curve, double t, const Point2 &x) const;
    [[nodiscard]] std::string name(size_t curve) const;
    // Whether b may begin where a ends: as the next curve of the loop, or because one of them is a segment of
    // the loop.
    [[nodiscard]] bool follows(size_t a, size_t b) const noexcept;

private:
    void add(std::span<const ClosedLoop> loops);
    void add(const Spline &curve, Point2 shift, LoopCurve of);
    void compare(size_t a, const intersect::BoxTree &tree);
    void compare(size_t a, size_t b, const Point2 &move);
    [[nodiscard]] int64_t points() const noexcept;

    const Covering &covering_;
    double near_;
    Point2 scale_; // powers of two
    std::vector<LoopCurve> curves_;
    std::vector<intersect::Box3> boxes_; // of the curves, without height
    std::vector<int> sizes_;             // numbers of curves of the loops
    std::vector<LoopHit> hits_;
};

} // namespace nrb::face
