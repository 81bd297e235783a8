// SPDX-License-Identifier: MIT
#include "intersect/rays/turned_patches.h"

#include "base/watch.h"

namespace nrb::intersect {

TurnedPatches::TurnedPatches(const pieces::PieceGrid &grid)
    : grid_(grid), origin_(static_cast<size_t>(grid.shape().lanes)),
      work_(2 * static_cast<size_t>(grid.shape().values())) {}

void TurnedPatches::set_ray(const PlacedRay &ray) {
    along_ = ray.ray.direction;
    first_ = any_normal(along_);
    second_ = cross(along_, first_);
    std::copy_n(ray.ray.start.data(), 3, origin_.data());
}

void TurnedPatches::fill(int64_t piece, double *out) noexcept {
    const pieces::PatchShape &shape = grid_.shape();
    double *values = work_.data() + shape.values();
    grid_.patch(piece, work_.data(), values);
    pieces::shift_patch(shape, values, origin_.data(), work_.data());
    for (int64_t i = 0; i < shape.coefficients(); ++i, out += lanes) {
        const double *record = work_.data() + i * shape.lanes;
        const Vector3 x{record[0], record[1], record[2]};
        out[0] = dot(x, first_);
        out[1] = dot(x, second_);
        out[2] = dot(x, along_);
        out[3] = record[3];
    }
}

} // namespace nrb::intersect
