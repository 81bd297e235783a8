// SPDX-License-Identifier: MIT
// Replaces control points and weights of a spline one by one; copies on periodic axes follow their originals.
#pragma once

#include "spline/spline.h"

#include <vector>

namespace nrb::modify {

// The first of the copies that periodic axes make of a control point.
int64_t original_of(const Spline &spline, int64_t point) noexcept;

class NetEditor {
public:
    // The spline must outlive this.
    explicit NetEditor(const Spline &spline);

    // Replaces the weight of an original control point, which keeps its place. A polynomial spline becomes
    // rational. Throws Status::point_not_finite if the control point is homogeneous and of weight 0, and so
    // has no place.
    void set_weight(int64_t point, double weight);
    // Moves an original control point by scale * offset; its weight stays.
    void move(int64_t point, const double *offset, double scale) noexcept;
    // Throws what make_result() throws, and Status::not_representable when a value overflows.
    [[nodiscard]] SplinePtr finish();

private:
    [[nodiscard]] double *record(int64_t point) noexcept {
        return points_.data() + point * spline_.stored_width();
    }

    const Spline &spline_;
    std::vector<double> points_;
    std::vector<double> weights_;
};

} // namespace nrb::modify
