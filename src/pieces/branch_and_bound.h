// SPDX-License-Identifier: MIT
// The largest value of a function over pieces that can be halved, enclosed by branch and bound.
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

    // Upper bounds of all pieces of the source, infinite where they are no numbers; `least` is a lower bound
    // that needs no piece.
    BranchAndBound(Problem &problem, std::span<const double> uppers, double least)
        : problem_(problem), queue_(unloaded(uppers)), lower_(least), least_(least) {}

    // At most `steps` pieces are loaded or halved beyond the first look at each that matters.
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
        std::optional<Piece> piece; // none: that of the source, not looked at yet
    };
    using Queue = BestFirst<Candidate>;
    static constexpr int64_t work_of_an_entry = 64; // its memory
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

    // Looks at the piece with the largest upper bound, or halves it; false if it cannot be halved.
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

    // A part has no larger values than the whole, and no other bound where its own is not a number. What
    // cannot exceed the lower bound is not kept.
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
