// SPDX-License-Identifier: MIT
#include "face/trims/loop_shape.h"

#include "base/numbers.h"
#include "numeric/nested_rule.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nrb::face {

namespace {

// The integral of u dv over a part of a piece, with u counted from the start of the part, and an estimate of
// its error. As both coordinates are monotone, the integral lies between 0 and the product of their steps,
// whatever the weights.
struct PartArea {
    double area = 0, off = 0;
};

struct PiecePart {
    Interval places;
    Point2 start, end;

    [[nodiscard]] double width() const noexcept { return end[0] - start[0]; }
    [[nodiscard]] double height() const noexcept { return end[1] - start[1]; }
    [[nodiscard]] double box() const noexcept { return width() * height(); }
};

PartArea by_rule(const TrimPieces &pieces, const TrimPiece &piece, const PiecePart &part, int level) {
    std::array<double, decay_sums> sums{};
    const double length = part.places.upper - part.places.lower;
    const DecayRows &rows = decay_rows[static_cast<size_t>(level)];
    for (int i = 0; i < rule_size(level); ++i) {
        if (rows[0][i] != 0) {
            const TrimPieces::Jet jet = pieces.jet(piece, part.places.lower + length * rule_places()[i]);
            const double value = length * (jet.point[0] - part.start[0]) * jet.derivative[1];
            for (size_t row = 0; row < rows.size(); ++row) {
                sums[row] += rows[row][i] * value;
            }
        }
    }
    const RuleDecay decay = decay_of(sums);
    return {decay.integral, decay.error(std::abs(part.box()))};
}

// Halves a part where, because of its weights, the rule is off by more than `room`, unless the whole box of
// the part is no larger than that.
PartArea weighted_area(const TrimPieces &pieces, const TrimPiece &piece, const PiecePart &part, double room) {
    constexpr int level = 3;
    const double most = std::abs(part.box());
    if (most <= room) {
        return {part.box() / 2, most / 2};
    }
    const PartArea whole = by_rule(pieces, piece, part, level);
    const double middle = part.places.lower / 2 + part.places.upper / 2;
    if (whole.off <= room || !(part.places.lower < middle && middle < part.places.upper)) {
        return {whole.area, std::min(whole.off, most)};
    }
    const Point2 at = pieces.point(piece, middle);
    const PiecePart first{{part.places.lower, middle}, part.start, at},
        second{{middle, part.places.upper}, at, part.end};
    const PartArea a = weighted_area(pieces, piece, first, room),
                   b = weighted_area(pieces, piece, second, room);
    return {a.area + first.width() * second.height() + b.area, a.off + b.off};
}

// The error of an area by the noise of the coordinates of a piece.
double rounding_of(const TrimPiece &piece) noexcept {
    return piece.noise[0] * std::abs(piece.end[1] - piece.start[1]) +
           piece.noise[1] * std::abs(piece.end[0] - piece.start[0]);
}

// The integral of (u - o) dv along a piece, exact to rounding where it is polynomial.
PartArea area_of(const TrimPieces &pieces, const TrimPiece &piece, const Point2 &origin) {
    const PiecePart all{{0, 1}, piece.start, piece.end};
    const double beside = (piece.start[0] - origin[0]) * all.height();
    if (piece.weighted) {
        const PartArea own =
            weighted_area(pieces, piece, all, 16 * eps * std::abs(all.box()) + rounding_of(piece));
        return {beside + own.area, own.off};
    }
    const double own =
        piece.degree == 1 ? all.box() / 2 : by_rule(pieces, piece, all, piece.degree > 12 ? 4 : 2).area;
    return {beside + own, 0};
}

struct Ends {
    Point2 first, last;
};

} // namespace

void add_area(const TrimPieces &pieces, const TrimPiece &piece, int direction, const Point2 &origin,
              LoopShape &shape) {
    const PartArea own = area_of(pieces, piece, origin);
    shape.area += direction * own.area;
    shape.noise += own.off + 8 * eps * std::abs(own.area) + rounding_of(piece);
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
