// SPDX-License-Identifier: MIT
// Motions that place parts: similarities, which may scale and mirror.
#pragma once

#include "build/placement.h"
#include "io/step/entities.h"
#include "model/shapes/moved_shape.h"

#include <array>

namespace nrb::io::step {

using Motion = model::Similarity;

// The motion from the coordinates of a frame, enlarged by a scale, to those in which it is given.
Motion motion_of(const build::Placement &frame, double scale = 1) noexcept;
// The motion that carries `from` to `to`. Precondition: the axes of `from` are orthonormal.
Motion between(const Motion &from, const Motion &to) noexcept;
// The rows of (M | t), without -0.
std::array<double, 12> matrix_of(const Motion &motion) noexcept;

bool is_operator(const Instances &instances, const Instance &instance);
// Reads a cartesian_transformation_operator_3d: axes as those of a placement, but with a second one that may
// make it a mirror image, and a scale. `length`: the factor of its unit of length. Throws Status::syntax, and
// factor for a scale that is not positive.
Motion read_operator(Entities &entities, const Instance &instance, double length);

} // namespace nrb::io::step
