// SPDX-License-Identifier: MIT
// What a proof of an overlap takes from the pieces around the one that a part lies along.
#include "intersect/surfaces/overlap/overlap_proof.h"

#include <cstdlib>

namespace nrb::intersect {

// None: the surface ends there. Null: the weights of the neighbour are not positive.
std::optional<const CrossPiece *> OverlapProof::neighbour(const CrossPiece &piece,
                                                          const std::array<int, 2> &step) const {
    Index index = piece.index;
    const pieces::PieceGrid &grid = ground_.grid(1);
    for (size_t k = 0; k < 2; ++k) {
        if (step[k] == 0) {
            continue;
        }
        const int64_t n = grid.count(static_cast<int>(k));
        index[k] += step[k];
        if ((index[k] < 0 || index[k] >= n) && !ground_.borders(1).wraps(k)) {
            return std::nullopt;
        }
        index[k] = (index[k] + n) % n;
    }
    return ground_.pieces(1).piece(index);
}

// Where the feet of the last look are along each axis of a piece: below it, in it, and above it, each by more
// than a little.
OverlapProof::Beyond OverlapProof::beyond_of(const CrossPiece &piece) {
    const PlaceBox &feet = map_.feet();
    Beyond beyond{};
    for (size_t k = 0; k < 2; ++k) {
        const double room = map_.room_on(piece, k, near_);
        const double above_start = feet[k].upper, below_end = 1 - feet[k].lower;
        beyond[k] = {-feet[k].lower > room, above_start > room && below_end > room, feet[k].upper - 1 > room};
    }
    return beyond;
}

// Where feet are beyond a side of the piece by more than a little, the part has to lie along the neighbour
// there, too. A part inside of a region must have that neighbour; where an edge runs through, the surface may
// end.
bool OverlapProof::lies_along_neighbours(const Part &part, const CrossPiece &other, bool inside) {
    const PlaceBox feet = map_.feet();
    const Beyond beyond = beyond_of(other);
    for (const int i : {-1, 0, 1}) {
        for (const int j : {-1, 0, 1}) {
            const bool any = beyond[0][static_cast<size_t>(i + 1)] && beyond[1][static_cast<size_t>(j + 1)];
            if (!any || (i == 0 && j == 0)) {
                continue;
            }
            const std::optional<const CrossPiece *> next = neighbour(other, {i, j});
            if (!next && !inside) {
                continue;
            }
            if (!next || *next == nullptr) {
                return false;
            }
            std::array<double, 2> start{};
            for (size_t k = 0; k < 2; ++k) {
                const int step = k == 0 ? i : j;
                const double own = other.range[k].upper - other.range[k].lower,
                             there = (*next)->range[k].upper - (*next)->range[k].lower,
                             middle = feet[k].lower / 2 + feet[k].upper / 2;
                start[k] = step == 0  ? middle
                           : step > 0 ? (middle - 1) * own / there
                                      : 1 + middle * own / there;
            }
            if (!lies_along_neighbour(part, **next, start, {i, j}, beyond, inside)) {
                return false;
            }
        }
    }
    return true;
}

// step: from the piece that the part lies along to the neighbour; told: in which pieces around the former
// feet are looked for. Where the neighbour is short, feet may leave it, too. That is allowed only towards
// these pieces, or where the surface may end.
bool OverlapProof::lies_along_neighbour(const Part &part, const CrossPiece &next,
                                        const std::array<double, 2> &start, const std::array<int, 2> &step,
                                        const Beyond &told, bool inside) {
    if (!lies_along(part, next, start)) {
        return false;
    }
    const Beyond beyond = beyond_of(next);
    for (size_t k = 0; k < 2; ++k) {
        for (const int on : {-1, 1}) {
            const int to = step[k] + on;
            const bool is_told = std::abs(to) <= 1 && told[k][static_cast<size_t>(to + 1)];
            std::array<int, 2> further{};
            further[k] = on;
            if (beyond[k][static_cast<size_t>(on + 1)] && !is_told && (inside || neighbour(next, further))) {
                return false;
            }
        }
    }
    return true;
}

} // namespace nrb::intersect
