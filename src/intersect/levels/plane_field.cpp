// SPDX-License-Identifier: MIT
#include "base/numbers.h"
#include "intersect/levels/level_field.h"

namespace nrb::intersect {

namespace {

Noise noise_of(const pieces::PieceGrid &grid) {
    const double relative = 1.01 * grid.moved() + 16 * eps * grid.radius();
    return {relative, grid.positive() ? 0 : 2 * grid.rounding().record};
}

} // namespace

PlaneField::PlaneField(const pieces::PieceGrid &grid, const std::array<double, 3> &normal)
    : LevelField(grid), normal_(normal), noise_(noise_of(grid)),
      work_(static_cast<size_t>(grid.shape().values())), patch_(work_.size()) {
    for (int k = 0; k < grid.shape().axes; ++k) {
        degrees_[static_cast<size_t>(grid.spline_axis(k))] = grid.shape().degree(k);
    }
}

int PlaneField::degree(int axis) const noexcept {
    return degrees_[static_cast<size_t>(axis)];
}

void PlaneField::net(int64_t piece, std::span<double> values, std::span<double> weights) {
    grid().patch(piece, work_.data(), patch_.data());
    const double *record = patch_.data();
    for (size_t i = 0; i < values.size(); ++i, record += grid().shape().lanes) {
        values[i] = normal_[0] * record[0] + normal_[1] * record[1] + normal_[2] * record[2];
        if (!weights.empty()) {
            weights[i] = record[3];
        }
    }
}

} // namespace nrb::intersect
