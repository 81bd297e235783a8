// SPDX-License-Identifier: MIT
// The faces of a volume while they are brought to common knots: numerators, over denominators that are
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
    std::vector<double> points;            // numerators; Cartesian in the end

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

// Whether the weights are products of one factor for each axis, to rounding (8 eps of themselves).
bool has_separate_weights(const Spline &face);

// Clamped over the domains, the weights separated. Throws Status::weights_vanish for a corner at infinity,
// naming the face, and what clamping throws. Precondition: has_separate_weights().
FaceNet make_face_net(const SplinePtr &face, const std::array<Interval, 2> &domains, size_t index);

// The net as a function of one axis, whose records are the rows along the other one; and back, over another
// axis.
Quotient along(const FaceNet &net, int axis);
void replace_axis(FaceNet &net, int axis, KnotVectorPtr knots, const std::vector<double> &rows);

} // namespace nrb::build
