// SPDX-License-Identifier: MIT
#include "face/arrange/returns.h"

#include "face/trims/monotone.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace nrb::face {

namespace {

using Directions = std::array<int, 2>; // of both coordinates: 1, -1, or 0 for a constant one

Directions directions_of(const TrimPiece &piece, double least) noexcept {
    Directions result{};
    for (size_t k = 0; k < 2; ++k) {
        const double step = piece.end[k] - piece.start[k];
        result[k] = step > least ? 1 : step < -least ? -1 : 0;
    }
    return result;
}

// Whether at least one coordinate reverses and none continues in its direction.
bool turns_back(const Directions &from, const Directions &to) noexcept {
    return from[0] * to[0] <= 0 && from[1] * to[1] <= 0 && from[0] * to[0] + from[1] * to[1] < 0;
}

} // namespace

std::vector<double> places_of_return(const Spline &curve) {
    constexpr double rounding = 0x1p-40; // of the size of the curve
    TrimPieces pieces;
    const SplinePtr own(&curve, [](const Spline *) {}); // owns nothing: used during the call only
    append_monotone({{own}}, 0, {0, 0}, pieces);
    double size = 0;
    for (const TrimPiece &piece : pieces.all()) {
        size = std::max(
            {size, std::abs(piece.end[0] - piece.start[0]), std::abs(piece.end[1] - piece.start[1])});
    }
    std::vector<double> places;
    Directions before{};
    for (const TrimPiece &piece : pieces.all()) {
        const Directions own_directions = directions_of(piece, rounding * size);
        if (own_directions == Directions{} || piece.range.lower == piece.range.upper) {
            continue; // between two turns, or the segment that closes the curve
        }
        if (turns_back(before, own_directions)) {
            places.push_back(piece.range.lower);
        }
        before = own_directions;
    }
    return places;
}

} // namespace nrb::face
