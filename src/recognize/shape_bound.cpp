// SPDX-License-Identifier: MIT
#include "recognize/shape_bound.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "pieces/best_first.h"
#include "recognize/piece_distance.h"

#include <algorithm>
#include <cmath>

namespace nrb::recognize {

namespace {

struct Candidate {
    double noise;
    int depth;
    pieces::BezierPiece piece;
};
using Queue = pieces::BestFirst<Candidate>;

constexpr int64_t work_of_a_coefficient = 256; // products with other coefficients, and memory

class Search {
public:
    Search(const Shape &shape, double tolerance) : distance_(shape), tolerance_(tolerance) {}

    pieces::Enclosure run(std::vector<pieces::BezierPiece> pieces) {
        int64_t steps = 400 + 60 * std::ssize(pieces);
        for (pieces::BezierPiece &piece : pieces) {
            push(std::move(piece), infinity, 0);
        }
        bool halved = true;
        queue_.run(
            steps, [&](const Queue::Entry &top) { return halved && !done(top); },
            [&](Queue::Entry top) { halved = halve(std::move(top)); });
        return {lower_, queue_.bound()};
    }

private:
    // Noise much larger than the rounding of the points stems from a poor bound on the gradient, which
    // halving improves.
    [[nodiscard]] bool done(const Queue::Entry &top) const noexcept {
        const double moved = top.item.piece.sound() ? top.item.piece.records_moved() : 0;
        const bool final = top.item.depth >= 6 || top.item.noise <= 8 * moved;
        const double noise = final ? top.item.noise : 8 * moved;
        const bool hopeless = lower_ > tolerance_ || moved > tolerance_; // rounding alone exceeds it
        return hopeless || top.bound - noise <= 1.25 * (lower_ + noise);
    }

    bool halve(Queue::Entry top) {
        const int axis = widest_axis(top.item.piece), depth = top.item.depth + 1;
        if (axis < 0) {
            queue_.push(top.bound, std::move(top.item));
            return false;
        }
        push(top.item.piece.halve(axis), top.bound, depth);
        push(std::move(top.item.piece), top.bound, depth);
        return true;
    }

    // The distance of a part is at most that of the whole.
    void push(pieces::BezierPiece &&piece, double whole, int depth) {
        DistanceBound bound;
        count_work(work_of_a_coefficient * piece.coefficients());
        if (piece.sound()) {
            bound = distance_.upper(piece);
            lower_ = std::max(lower_, distance_.lower(piece, bound.noise));
        }
        queue_.push(std::min(bound.upper, whole), {bound.noise, depth, std::move(piece)});
    }

    PieceDistance distance_;
    double tolerance_;
    Queue queue_;
    double lower_ = 0;
};

} // namespace

pieces::Enclosure distance_from(const Spline &spline, const Shape &shape, double tolerance) {
    return Search(shape, tolerance).run(shape_pieces(spline, shape));
}

} // namespace nrb::recognize
