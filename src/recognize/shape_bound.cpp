#include "recognize/shape_bound.h"

#include "recognize/piece_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nrb::recognize {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

struct Candidate {
    DistanceBound bound;
    int depth = 0;
    pieces::BezierPiece piece;

    [[nodiscard]] bool operator<(const Candidate &other) const noexcept {
        return bound.upper < other.bound.upper;
    }
};

class Search {
public:
    Search(const Shape &shape, double tolerance) : distance_(shape), tolerance_(tolerance) {}

    pieces::Enclosure run(std::vector<pieces::BezierPiece> pieces) {
        const auto steps = 400 + 60 * std::ssize(pieces);
        for (pieces::BezierPiece &piece : pieces) {
            push(std::move(piece), infinite, 0);
        }
        for (int64_t step = 0; step < steps && !done(); ++step) {
            if (!refine()) {
                break;
            }
        }
        return {lower_, heap_.front().bound.upper};
    }

private:
    // Rounding much above that of the points comes from a gradient that is bounded badly, which halving
    // cures.
    [[nodiscard]] bool done() const noexcept {
        const Candidate &top = heap_.front();
        const bool final = top.depth >= 6 || top.bound.noise <= 8 * top.piece.records_moved();
        const double noise = final ? top.bound.noise : 8 * top.piece.records_moved();
        const bool hopeless =
            lower_ > tolerance_ || top.piece.records_moved() > tolerance_; // rounding alone is more
        return hopeless || top.bound.upper - noise <= 1.25 * (lower_ + noise);
    }

    bool refine() {
        std::pop_heap(heap_.begin(), heap_.end());
        Candidate top = std::move(heap_.back());
        heap_.pop_back();
        const double whole = top.bound.upper;
        const int depth = top.depth + 1;
        const int axis = widest_axis(top.piece);
        if (axis < 0) {
            heap_.push_back(std::move(top));
            std::push_heap(heap_.begin(), heap_.end());
            return false;
        }
        push(top.piece.halve(axis), whole, depth);
        push(std::move(top.piece), whole, depth);
        return true;
    }

    // A part has no larger distances than the whole.
    void push(pieces::BezierPiece &&piece, double whole, int depth) {
        Candidate candidate;
        candidate.depth = depth;
        if (piece.sound()) {
            candidate.bound = distance_.upper(piece);
            lower_ = std::max(lower_, distance_.lower(piece, candidate.bound.noise));
        }
        candidate.bound.upper = std::min(candidate.bound.upper, whole);
        candidate.piece = std::move(piece);
        heap_.push_back(std::move(candidate));
        std::push_heap(heap_.begin(), heap_.end());
    }

    PieceDistance distance_;
    double tolerance_;
    std::vector<Candidate> heap_;
    double lower_ = 0;
};

} // namespace

pieces::Enclosure distance_from(const Spline &spline, const Shape &shape, double tolerance) {
    return Search(shape, tolerance).run(shape_pieces(spline, shape));
}

} // namespace nrb::recognize
