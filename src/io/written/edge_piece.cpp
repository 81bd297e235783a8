// SPDX-License-Identifier: MIT
#include "io/written/edge_piece.h"

#include "model/shapes/curve_spline.h"
#include "spline/same_numbers.h"

namespace nrb::io {

std::optional<model::CurvePiece> piece_of_shape(const model::Edge &edge, const Vector3 &start,
                                                const Vector3 &end, double tolerance) {
    const double first[] = {start.x, start.y, start.z}, last[] = {end.x, end.y, end.z};
    for (const bool forward : {true, false}) {
        try {
            const model::CurvePiece piece =
                model::piece_between(edge.shape, {first, last, forward, tolerance});
            if (same_numbers(*model::piece_spline(piece), *edge.curve)) {
                return piece;
            }
        } catch (const Error &) { // no part of the shape is between the vertices
            continue;
        }
    }
    return std::nullopt;
}

} // namespace nrb::io
