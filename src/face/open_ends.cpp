// SPDX-License-Identifier: MIT
#include "face/open_ends.h"

#include <algorithm>

namespace nrb::face {

namespace {

// Places along one end of axis k: where pieces touch or cross it, and the ends of the other axis. Between two
// neighbours the end is all inside or all outside.
std::vector<double> contacts(const Face &face, int k, double end) {
    const auto across = static_cast<size_t>(k), along = 1 - across;
    const TrimPieces &pieces = face.trims().pieces();
    const Interval domain = face.covering().domain(1 - k);
    std::vector<double> places{domain.lower, domain.upper};
    for (const TrimPiece &piece : pieces.all()) {
        if (piece.lower[across] > end || piece.upper[across] < end) {
            continue;
        }
        for (const Point2 &at :
             {piece.start, piece.end, pieces.point(piece, pieces.place_of(piece, k, end))}) {
            places.push_back(std::clamp(at[along], domain.lower, domain.upper));
        }
    }
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    return places;
}

void append_parts(const Face &face, int k, double end, std::vector<EndPart> &out) {
    const auto across = static_cast<size_t>(k), along = 1 - across;
    const std::vector<double> places = contacts(face, k, end);
    for (size_t i = 0; i + 1 < places.size(); ++i) {
        Point2 middle;
        middle[across] = end;
        middle[along] = places[i] / 2 + places[i + 1] / 2;
        if (face.trims().side(middle) > 0) {
            EndPart part{middle, middle};
            part.from[along] = places[i];
            part.to[along] = places[i + 1];
            out.push_back(part);
        }
    }
}

} // namespace

std::vector<EndPart> open_ends(const Face &face) {
    std::vector<EndPart> result;
    for (const int k : {0, 1}) {
        if (!face.covering().closed(k)) {
            append_parts(face, k, face.covering().domain(k).lower, result);
            append_parts(face, k, face.covering().domain(k).upper, result);
        }
    }
    return result;
}

} // namespace nrb::face
