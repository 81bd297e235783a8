// SPDX-License-Identifier: MIT
#include "face/arrange/domain_area.h"

#include "base/error.h"
#include "base/numbers.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace nrb::face {

namespace {

// The integral over u of the value at the upper end of the column at u, times the height of the domain. That
// value changes only where loops pass the seam of axis 1.
template <class Value>
double area_from_top(const Covering &covering, std::span<const SeamPassage> passages, Value &&value) {
    const auto [lower, upper] = covering.domain(0);
    std::vector<double> places{lower, upper};
    for (const SeamPassage &passage : passages) {
        places.push_back(std::clamp(passage.at, lower, upper));
    }
    std::ranges::sort(places);
    double area = 0;
    for (size_t i = 0; i + 1 < places.size(); ++i) {
        const double width = places[i + 1] - places[i];
        area += width > 0 ? width * value(places[i] + width / 2) : 0;
    }
    return area * covering.period(1);
}

// The integral of v - low along a piece from (u0, v0) to (u1, v1), by parts:
//     int (v - low) du = (u1 - u0) (v1 - low) - int (u - u0) dv.
double area_under(const TrimPieces &pieces, const TrimPiece &piece, double low) {
    LoopShape shape;
    add_area(pieces, piece, 1, piece.start, shape);
    return (piece.end[0] - piece.start[0]) * (piece.end[1] - low) - shape.area;
}

// The length of the chords of all pieces, in units of about a period.
double length_of(const Arrangement &arrangement) {
    double length = 0;
    for (const TrimPiece &piece : arrangement.columns().pieces().all()) {
        length += arrangement.hits().distance(piece.start, piece.end);
    }
    return length;
}

} // namespace

double domain_area(const Face &face) {
    const TrimMap &trims = face.trims();
    double area =
        area_from_top(face.covering(), trims.passages(), [&](double u) { return trims.value_at_top(u); });
    for (const TrimPiece &piece : trims.pieces().all()) {
        const double own = area_under(trims.pieces(), piece, face.covering().domain(1).lower);
        area += trims.passed(piece) * (piece.start[0] < piece.end[0] ? own : -own);
    }
    return area;
}

double domain_area(const Arrangement &arrangement, std::span<const DirectedEdge> border,
                   const std::function<bool(double u)> &at_top) {
    const PieceColumns &columns = arrangement.columns();
    double area = area_from_top(arrangement.covering(), columns.passages(),
                                [&](double u) { return at_top(u) ? 1 : 0; });
    for (const DirectedEdge edge : border) {
        for (const TrimPiece &piece : arrangement.pieces(edge.edge)) {
            const double own = area_under(columns.pieces(), piece, arrangement.covering().domain(1).lower);
            area += edge.back ? own : -own;
        }
    }
    return area;
}

void check_area(const Arrangement &arrangement, std::span<const FacePtr> faces, double expected) {
    constexpr double most_times = 64; // of the distance that counts as none, along all edges
    double found = 0;
    for (const FacePtr &face : faces) {
        found += domain_area(*face);
    }
    const Point2 unit = arrangement.hits().scaled({1, 1});
    const double allowed = most_times * arrangement.near() * (1 + length_of(arrangement));
    if (!(std::abs(found - expected) * unit[0] * unit[1] <= allowed)) {
        fail(Status::not_converged,
             "curves come undecidably near each other: parts cover %s of the domain, not %s",
             Number(found).text, Number(expected).text);
    }
}

} // namespace nrb::face
