// SPDX-License-Identifier: MIT
// Curves that run on two surfaces at once.
#pragma once

#include "face/face.h"

#include <array>
#include <vector>

namespace nrb::face {

struct SharedCurve {
    SplinePtr space;             // clamped, as those in the domains
    std::array<SplinePtr, 2> on; // over the same parameters
    double deviation = 0;        // a bound of how far what surfaces make of these is from the one in space
};
using SharedLoop = std::vector<SharedCurve>;
using SharedLoops = std::vector<SharedLoop>; // of one part

// A part of it, or all, as it runs or against that.
SharedCurve part_of(const SharedCurve &curve, Interval range, bool back);
SharedLoop turned(const SharedLoop &loop);

// Two surfaces that are one, to within a tolerance, where curves are made on both.
class SharedGrounds {
public:
    // tolerances: of the faces on them, which say what closes.
    SharedGrounds(const std::array<SplinePtr, 2> &surfaces, const std::array<double, 2> &tolerances,
                  double tolerance);

    [[nodiscard]] const SplinePtr &surface(size_t k) const noexcept { return surfaces_[k]; }
    [[nodiscard]] const Covering &covering(size_t k) const noexcept { return coverings_[k]; }
    // Of surfaces and curves, and of faces on them: what is no farther apart counts as one.
    [[nodiscard]] double near() const noexcept { return near_; }

    // From a curve in the plane that covers the domain of one of them, cut where either closes: in the domains. Throws Status::gap
    // where the other one is not there, and what curve_under() does.
    [[nodiscard]] SharedLoop over(size_t k, const SplinePtr &curve) const;
    // Each curve of a loop begins where the one before ends, bit for bit, but for periods of axes that close.
    void join(SharedLoop &loop) const;
    // Whether both surfaces have one normal, to within a right angle, at places of them.
    [[nodiscard]] bool is_alike(const Point2 &first, const Point2 &second) const;

private:
    void add_over(size_t k, const SplinePtr &own, SharedLoop &result) const;
    void set_start(SharedCurve &curve, const SharedCurve &before) const;

    std::array<SplinePtr, 2> surfaces_;
    std::array<Covering, 2> coverings_;
    std::array<std::array<double, 2>, 2> speeds_; // of surfaces, by axes
    double tolerance_, near_;
};

// Whether a curve begins in another copy of a domain than the one before ends.
bool passes_seam(const SharedCurve &before, const SharedCurve &after);

} // namespace nrb::face
