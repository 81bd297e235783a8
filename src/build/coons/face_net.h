// SPDX-License-Identifier: MIT
// The faces of a Coons volume while they are brought to common knots: numerators over denominators that are
// products of one function for each axis.
#pragma once

#include "build/coons/blend_axis.h"

#include <array>

namespace nrb::build {

// The control net of a surface; point (i, j) is record i * counts[1] + j.
struct FaceNet {
    int dim;
    std::array<KnotVectorPtr, 2> axes;
    std::array<SplinePtr, 2> denominators; // along each axis; null: 1
    std::vector<double> points;            // numerators; in the end Cartesian points

    [[nodiscard]] size_t count(int axis) const noexcept {
        return static_cast<size_t>(axes[static_cast<size_t>(axis)]->count());
    }
    [[nodiscard]] const double *point(size_t i, size_t j) const noexcept {
        return points.data() + (i * count(1) + j) * static_cast<size_t>(dim);
    }
    [[nodiscard]] double *point(size_t i, size_t j) noexcept {
        return points.data() + (i * count(1) + j) * static_cast<size_t>(dim);
    }
    // The layer at an end of an axis.
    [[nodiscard]] std::vector<double> layer(int axis, bool upper) const;
};

// Whether every weight is a product of one factor for each axis, to rounding (8 eps of itself).
bool has_separate_weights(const Spline &face);

// The face clamped over the domains, its weights separated; `index` names it in messages. Throws
// Status::weights_vanish for a corner at infinity, and what clamping throws. Precondition:
// has_separate_weights().
FaceNet make_face_net(const SplinePtr &face, const std::array<Interval, 2> &domains, size_t index);

// along(): the net as a function of one axis whose records are the rows along the other axis. replace_axis():
// back to a net, from rows over other knots of that axis.
Quotient along(const FaceNet &net, int axis);
void replace_axis(FaceNet &net, int axis, KnotVectorPtr knots, const std::vector<double> &rows);

} // namespace nrb::build
