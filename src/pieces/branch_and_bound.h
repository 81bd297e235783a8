// SPDX-License-Identifier: MIT
// Branch and bound: encloses the largest value of a function over pieces that can be subdivided.
#pragma once

#include "pieces/best_first.h"

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
//     Enclosure bounds(const Piece &)             proven bounds of its largest value
//     double noise(const Piece &)                 how far rounding keeps these bounds apart
//     std::optional<Piece> split(Piece &)         returns one half and keeps the other, or returns none
//     void found(int64_t index, const Piece &)    the piece has the largest lower bound so far
//     bool reached(double lower, double upper, double noise)
// Pieces are loaded when they reach the top of the queue, so that only those are subdivided that may contain
// the largest value.
template <class Problem>
class BranchAndBound {
public:
    using Piece = typename Problem::Piece;

    // uppers: upper bounds of all pieces of the source; NaN counts as infinite. least: a lower bound that
    // holds without any piece.
    BranchAndBound(Problem &problem, std::span<const double> uppers, double least)
        : problem_(problem), queue_(unloaded(uppers)), lower_(least), least_(least) {}

    // Encloses the value; loads or halves at most `steps` pieces.
    Enclosure run(int64_t steps) {
        bool halved = true;
        const auto counts = [&](const Entry &top) {
            return halved && !problem_.reached(lower_, top.bound, top.item.noise);
        };
        queue_.run(steps, counts, [&](Entry top) { halved = refine(std::move(top)); });
        return {lower_, std::max(lower_, queue_.bound())};
    }

private:
    struct Candidate {
        double noise;
        int64_t index;
        std::optional<Piece> piece; // none: the piece of the source, not loaded yet
    };
    using Queue = BestFirst<Candidate>;
    static constexpr int64_t work_of_an_entry = 64; // for its memory
    using Entry = typename Queue::Entry;

    static std::vector<Entry> unloaded(std::span<const double> uppers) {
        std::vector<Entry> entries;
        entries.reserve(uppers.size());
        for (const double upper : uppers) {
            count_work(work_of_an_entry);
            const double bound = std::isnan(upper) ? std::numeric_limits<double>::infinity() : upper;
            entries.push_back({bound, {0, std::ssize(entries), std::nullopt}});
        }
        return entries;
    }

    // Loads the piece with the largest upper bound, or halves it; false if it cannot be halved.
    bool refine(Entry top) {
        Candidate &whole = top.item;
        if (!whole.piece) {
            push(problem_.load(whole.index), top);
            return true;
        }
        std::optional<Piece> half = problem_.split(*whole.piece);
        if (half) {
            push(std::move(*half), top);
        }
        push(std::move(*whole.piece), top);
        return half.has_value();
    }

    // A part has no larger values than the whole, whose bound is used where the part's own is NaN. Pieces
    // that cannot exceed the lower bound are dropped.
    void push(Piece &&piece, const Entry &whole) {
        const Enclosure bounds = problem_.bounds(piece);
        if (bounds.lower > lower_) {
            lower_ = bounds.lower;
            problem_.found(whole.item.index, piece);
        }
        const double upper = bounds.upper < whole.bound ? bounds.upper : whole.bound;
        if (upper > lower_ || lower_ == least_) {
            queue_.push(upper, {problem_.noise(piece), whole.item.index, std::move(piece)});
        }
    }

    Problem &problem_;
    Queue queue_;
    double lower_;
    double least_;
};

} // namespace nrb::pieces
