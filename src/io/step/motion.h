// SPDX-License-Identifier: MIT
// Motions that place parts.
#pragma once

#include "build/placement.h"
#include "io/step/entities.h"
#include "model/shapes/moved_shape.h"

#include <array>

namespace nrb::io::step {

using Motion = model::Similarity;

// From the coordinates of a frame to those around it.
Motion motion_of(const build::Placement &frame) noexcept;
// The motion by which `from` becomes `to`. Precondition: the axes of `from` are at right angles and of length 1.
Motion between(const Motion &from, const Motion &to) noexcept;
// Rows of (M | t), without -0.
std::array<double, 12> matrix_of(const Motion &motion) noexcept;

bool is_operator(const Instances &instances, const Instance &instance);
// cartesian_transformation_operator_3d: axes that may be missing, and may be those of a mirror image; a scale. `length` is the
// factor of its unit. Throws Status::syntax, factor for a scale that is not positive.
Motion read_operator(Entities &entities, const Instance &instance, double length);

} // namespace nrb::io::step
