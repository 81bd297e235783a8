// The largest value of a function over pieces that can be halved, enclosed by branch and bound.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace nrb::pieces {

struct Enclosure {
    double lower;
    double upper;
};

// A Problem has a type Piece and
//     Piece load(int64_t index)                   piece `index` of the source
//     Enclosure bounds(const Piece &)             proven: of its largest value
//     double noise(const Piece &)                 how far rounding keeps these bounds apart
//     std::optional<Piece> split(Piece &)         gives one half and keeps the other, or neither
//     void found(int64_t index, const Piece &)    the piece has the largest lower bound so far
//     bool reached(double lower, double upper, double noise)
// Pieces are loaded when it is their turn, so that only those are halved that may hold the largest value.
template <class Problem>
class BranchAndBound {
public:
    using Piece = typename Problem::Piece;

    // Upper bounds of all pieces of the source, infinite where they are no numbers; `least` is a lower bound that
    // needs no piece.
    BranchAndBound(Problem &problem, std::span<const double> uppers, double least)
        : problem_(problem), lower_(least), least_(least) {
        heap_.reserve(uppers.size());
        for (size_t i = 0; i < uppers.size(); ++i) {
            const double upper = std::isnan(uppers[i]) ? std::numeric_limits<double>::infinity() : uppers[i];
            heap_.push_back({upper, 0, static_cast<int64_t>(i), std::nullopt});
        }
        std::make_heap(heap_.begin(), heap_.end());
    }

    // At most `steps` pieces are loaded or halved beyond the first look at each that matters.
    Enclosure run(int steps) {
        for (int step = 0; step < steps && !done(); ++step) {
            if (!refine()) {
                break;
            }
        }
        return {lower_, heap_.empty() ? lower_ : std::max(lower_, heap_.front().upper)};
    }

private:
    struct Candidate {
        double upper;
        double noise;
        int64_t index;
        std::optional<Piece> piece; // none: that of the source, not looked at yet

        [[nodiscard]] bool operator<(const Candidate &other) const noexcept { return upper < other.upper; }
    };

    [[nodiscard]] bool done() const {
        return heap_.empty() || problem_.reached(lower_, heap_.front().upper, heap_.front().noise);
    }

    // Looks at the piece with the largest upper bound, or halves it; false if it cannot be halved.
    bool refine() {
        std::pop_heap(heap_.begin(), heap_.end());
        Candidate top = std::move(heap_.back());
        heap_.pop_back();
        if (!top.piece) {
            push(problem_.load(top.index), top);
            return true;
        }
        std::optional<Piece> half = problem_.split(*top.piece);
        const bool halved = half.has_value();
        if (halved) {
            push(std::move(*half), top);
        }
        push(std::move(*top.piece), top);
        return halved;
    }

    // A part has no larger values than the whole, and no other bound where its own is not a number. What cannot
    // exceed the lower bound is not kept.
    void push(Piece &&piece, const Candidate &whole) {
        const Enclosure bounds = problem_.bounds(piece);
        if (bounds.lower > lower_) {
            lower_ = bounds.lower;
            problem_.found(whole.index, piece);
        }
        const double upper = bounds.upper < whole.upper ? bounds.upper : whole.upper;
        if (upper > lower_ || lower_ == least_) {
            heap_.push_back({upper, problem_.noise(piece), whole.index, std::move(piece)});
            std::push_heap(heap_.begin(), heap_.end());
        }
    }

    Problem &problem_;
    std::vector<Candidate> heap_;
    double lower_;
    double least_;
};

} // namespace nrb::pieces
