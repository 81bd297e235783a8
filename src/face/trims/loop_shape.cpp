// SPDX-License-Identifier: MIT
#include "face/trims/loop_shape.h"

#include "base/numbers.h"
#include "numeric/nested_rule.h"

#include <cmath>

namespace nrb::face {

namespace {

// The integral of (u - o) dv along a piece, exact to rounding where it is polynomial.
double area_of(const TrimPieces &pieces, const TrimPiece &piece, const Point2 &origin) {
    if (piece.degree == 1 && !piece.weighted) {
        return (piece.start[0] / 2 + piece.end[0] / 2 - origin[0]) * (piece.end[1] - piece.start[1]);
    }
    const int level = piece.weighted || piece.degree > 12 ? 4 : 2;
    double sum = 0;
    for (int i = 0; i < rule_size(level); ++i) {
        const double weight = rule_weights(level)[i];
        if (weight != 0) {
            const TrimPieces::Jet jet = pieces.jet(piece, rule_places()[i]);
            sum += weight * (jet.point[0] - origin[0]) * jet.derivative[1];
        }
    }
    return sum;
}

struct Ends {
    Point2 first, last;
};

} // namespace

void add_area(const TrimPieces &pieces, const TrimPiece &piece, int direction, const Point2 &origin,
              LoopShape &shape) {
    const double area = area_of(pieces, piece, origin);
    shape.area += direction * area;
    shape.noise += 8 * eps * std::abs(area) + piece.noise[0] * std::abs(piece.end[1] - piece.start[1]) +
                   piece.noise[1] * std::abs(piece.end[0] - piece.start[0]);
}

std::vector<LoopShape> loop_shapes(const TrimPieces &plane, size_t loops, const Covering &covering) {
    std::vector<LoopShape> result(loops);
    std::vector<Ends> ends(loops);
    std::vector<char> begun(loops, 0);
    for (const TrimPiece &piece : plane.all()) {
        const auto loop = static_cast<size_t>(piece.loop);
        if (begun[loop] == 0) {
            ends[loop].first = piece.start;
            begun[loop] = 1;
        }
        add_area(plane, piece, 1, ends[loop].first, result[loop]);
        ends[loop].last = piece.end;
    }
    for (size_t loop = 0; loop < loops; ++loop) {
        for (const int k : {0, 1}) {
            const auto at = static_cast<size_t>(k);
            const double run = std::abs(ends[loop].last[at] - ends[loop].first[at]);
            result[loop].around = result[loop].around || (covering.closed(k) && run > covering.period(k) / 2);
        }
    }
    return result;
}

} // namespace nrb::face
