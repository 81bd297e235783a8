// SPDX-License-Identifier: MIT
#include "intersect/extrema/piece_value.h"

#include <cmath>

namespace nrb::intersect {

double value_of(const pieces::HomogeneousPiece &piece, const std::array<double, max_axes> &place) {
    RoundedPolynomial points = piece.points, weight = piece.weight;
    for (int k = 0; k < max_axes - piece.first_axis; ++k) {
        points = value_at(std::move(points), piece.axis(k), place[static_cast<size_t>(k)]);
        weight = value_at(std::move(weight), piece.axis(k), place[static_cast<size_t>(k)]);
    }
    return piece.centre[0] + std::ldexp(points.values[0] / weight.values[0], piece.exponent);
}

} // namespace nrb::intersect
