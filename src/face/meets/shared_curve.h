// SPDX-License-Identifier: MIT
// Curves that run on two surfaces at once.
#pragma once

#include "face/face.h"

#include <array>
#include <vector>

namespace nrb::face {

struct SharedCurve {
    SplinePtr space;             // clamped, as the curves in the domains
    std::array<SplinePtr, 2> on; // in the two domains, over the same parameters
    double deviation = 0;        // a bound on the distances of the images of these from the curve in space
};
using SharedLoop = std::vector<SharedCurve>;
using SharedLoops = std::vector<SharedLoop>; // of one region

// A part of a curve, or all of it; with `back`, in the opposite direction.
SharedCurve part_of(const SharedCurve &curve, Interval range, bool back);
SharedLoop turned(const SharedLoop &loop);

// Two surfaces that coincide to within a tolerance, on both of which curves are made.
class SharedGrounds {
public:
    // tolerances: those of the faces on the surfaces, by which axes count as closed.
    SharedGrounds(const std::array<SplinePtr, 2> &surfaces, const std::array<double, 2> &tolerances,
                  double tolerance);

    [[nodiscard]] const SplinePtr &surface(size_t k) const noexcept { return surfaces_[k]; }
    [[nodiscard]] const Covering &covering(size_t k) const noexcept { return coverings_[k]; }
    // Distances of at most this count as none: the largest of the tolerances of the surfaces and curves, and
    // of the faces.
    [[nodiscard]] double near() const noexcept { return near_; }

    // Makes shared curves from a curve in the plane that covers the domain of surface k. They are cut at the
    // seams of both surfaces, so that they lie in the domains. Throws Status::gap where the other surface is
    // too far away, and what curve_under() throws.
    [[nodiscard]] SharedLoop over(size_t k, const SplinePtr &curve) const;
    // Moves the starts of curves, so that each curve of a loop begins where the one before it ends: bit for
    // bit, up to periods of closed axes.
    void join(SharedLoop &loop) const;
    // Whether the normals of both surfaces, at a place of each, make an angle of less than 90 degrees.
    [[nodiscard]] bool is_alike(const Point2 &first, const Point2 &second) const;

private:
    void add_over(size_t k, const SplinePtr &own, SharedLoop &result) const;
    void set_start(SharedCurve &curve, const SharedCurve &before) const;

    std::array<SplinePtr, 2> surfaces_;
    std::array<Covering, 2> coverings_;
    std::array<std::array<double, 2>, 2> speeds_; // of both surfaces, by axes
    double tolerance_, near_;
};

// Whether a curve begins at another place of one of the domains than the one before it ends, as in another
// copy. A pole is passed like a seam: there, too, one point has places with different parameters.
bool passes_seam(const SharedCurve &before, const SharedCurve &after);

} // namespace nrb::face
