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
    SplinePtr spline; // scaled, in the copy of the plane in which its box begins in the domain
    int loop = 0;
    int index = -1;      // in the loop; -1: a segment
    bool around = false; // of a loop that ends in another copy of the domain
};

// Of two curves, or of one with itself. All of what the solver tells, ends that follow one another included.
struct LoopHit {
    size_t a, b; // of the curves
    double at_a, at_b;
    Interval range_a, range_b;
    intersect::HitKind kind;
    Point2 move;          // of b, by periods
    bool against = false; // an overlap that runs against b
};

// Curves are compared in all copies that closed axes make of them, as far as their boxes meet; each coordinate in units of about a
// period, so that a long axis does not hide by its rounding what happens along a short one.
class LoopHits {
public:
    // near: what counts as no distance, in units of about a period. Throws Status::not_converged at the limit of work. Cost:
    // n log n for n curves, and what those take whose boxes meet.
    LoopHits(const Covering &covering, std::span<const ClosedLoop> loops, double near = 0);

    [[nodiscard]] const std::vector<LoopCurve> &curves() const noexcept { return curves_; }
    [[nodiscard]] const std::vector<LoopHit> &all() const noexcept { return hits_; }
    // In the plane that covers the domain.
    [[nodiscard]] Point2 place(size_t curve, double t) const;
    // In units of about a period.
    [[nodiscard]] Point2 scaled(const Point2 &x) const noexcept {
        return {x[0] * scale_[0], x[1] * scale_[1]};
    }
    [[nodiscard]] double distance(const Point2 &x, const Point2 &y) const noexcept;
    // The parameter of a curve at its place nearest to another one, in a range if that lies in the domain.
    [[nodiscard]] double foot(size_t curve, const Point2 &x, Interval range) const;
    // Positive to the left of the tangent at t.
    [[nodiscard]] double side(size_t curve, double t, const Point2 &x) const;
    [[nodiscard]] std::string name(size_t curve) const;
    // Whether b begins where a ends: the next curve of a loop, or a segment that may be there.
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
    std::vector<intersect::Box3> boxes_; // of the curves; flat
    std::vector<int> sizes_;             // of the loops
    std::vector<LoopHit> hits_;
};

} // namespace nrb::face
