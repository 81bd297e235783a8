// SPDX-License-Identifier: MIT
#include "eval/frames/single_frame.h"

#include "base/numbers.h"
#include "eval/derivative_errors.h"
#include "eval/frames/magnitude.h"
#include "eval/kernels/derivative_source.h"
#include "numeric/vector3.h"

#include <algorithm>
#include <cmath>

namespace nrb::eval {

namespace {

Vector3 vector_at(const double *values) noexcept {
    return {values[0], values[1], values[2]};
}

// The normal of one point, with the operations of unit_normals(). Returns whether it is certainly regular.
bool unit_normal(const SingleFrameTables &tables, SingleFrame &frame) noexcept {
    const Vector3 u = vector_at(frame.data() + 3), v = vector_at(frame.data() + 6);
    const Vector3 n = cross(u, v);
    const double squared = dot(n, n);
    const double noise =
        dot(u, u) * (2 * tables.error_v * tables.error_v) + dot(v, v) * (2 * tables.error_u * tables.error_u);
    const Vector3 normal = (1 / std::sqrt(squared)) * n;
    frame[9] = normal.x;
    frame[10] = normal.y;
    frame[11] = normal.z;
    return squared > noise && in_range(squared);
}

} // namespace

const SingleFrameTables *single_frame_tables(const Spline &surface) noexcept {
    const Spline::AnyCache *found = surface.slot(Spline::Cache::single_frame).peek();
    return found == nullptr ? nullptr : static_cast<const SingleFrameTables *>(found->get());
}

void keep_single_frame_tables(const Spline &surface) {
    if (single_frame_tables(surface) != nullptr) {
        return;
    }
    const Spline &moved = derivative_source(surface, 1);
    const DerivativeErrors errors = derivative_errors(surface, {}, 0);
    keep_single_tables(surface);
    keep_single_tables(moved);
    const SingleFrameTables tables{single_tables(surface), single_tables(moved), errors.u, errors.v};
    if (tables.points != nullptr && tables.derivs != nullptr && std::isfinite(errors.u) &&
        usual_magnitude(surface)) {
        static_cast<void>(surface.kept<SingleFrameTables>(
            Spline::Cache::single_frame, [&] { return std::make_shared<const SingleFrameTables>(tables); }));
    }
}

bool evaluate_single_frame(const SingleFrameTables &tables, const double *params,
                           SingleFrame &frame) noexcept {
    return evaluate_single_derivs(*tables.derivs, params, frame.data()) &&
           (tables.derivs == tables.points || evaluate_single(*tables.points, params, frame.data())) &&
           unit_normal(tables, frame);
}

} // namespace nrb::eval
