// SPDX-License-Identifier: MIT
// The part of an analytic curve that an edge is.
#pragma once

#include "model/model.h"

#include <optional>

namespace nrb::io {

// The piece of the shape of an edge between its vertices, if its spline equals that of the edge bit for bit.
std::optional<model::CurvePiece> piece_of_shape(const model::Edge &edge, const Vector3 &start,
                                                const Vector3 &end, double tolerance);

} // namespace nrb::io
