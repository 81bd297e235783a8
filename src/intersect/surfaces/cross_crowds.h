// SPDX-License-Identifier: MIT
// Where so much of two surfaces is near each other that it is not worth the work to tell their parts apart.
#pragma once

#include "intersect/surfaces/cross_cell.h"

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace nrb::intersect {

// The distance of the middle of the first part from its foot point on the second one, by a few steps of the
// Gauss-Newton method; infinite if these leave the wide part.
double distance_of_middle(const CrossCell &part, const CrossCell &other);

// Whether the surroundings of the first part, several times as wide as the part, lie on the surface of the
// second one, judged by a few places in general position. If surfaces only touch or cross at a point, the
// parts in which they nearly coincide are small, so that their surroundings do not.
bool lies_on(const CrossCell &part, const CrossCell &other, double tolerance);

// Counts pairs of parts that are near each other all over, by the pairs of pieces that they belong to, in
// rounds of parts of one size. If there are many in a round, pairs of pieces become crowded: those with a
// part that lies on the other surface, their neighbours, in which such regions end, and those with more than
// their share. So a crowd in one place leaves the others alone.
class CrossCrowds {
public:
    using Number = uint32_t; // of a pair of pieces

    CrossCrowds(const CrossGround &a, const CrossGround &b) : grounds_{&a, &b} {}

    // Shares grow with the available work, if that is more than usual.
    void allow(int64_t work) noexcept { times_ = static_cast<size_t>(std::max(work / usual, int64_t{1})); }

    Number add(const CrossPiece &a, const CrossPiece &b);
    [[nodiscard]] bool is_crowded(Number pair) const noexcept { return pairs_[pair].crowded; }

    // along: whether the pair is thicker than the tolerance although the middle of one part is near the other
    // one.
    void count(Number pair, bool along);
    [[nodiscard]] bool are_many() const noexcept { return near_ > most_near || along_ > most_along; }
    // If they are many: whether lies_on() is to be evaluated for a pair of parts of this pair of pieces, and
    // its result passed to tell(). Only a few are asked in each round.
    [[nodiscard]] bool is_asked_for(Number pair) const noexcept {
        return !pairs_[pair].crowded && pairs_[pair].asked < most_asked;
    }
    void tell(Number pair, bool lies_on);
    // Ends the round, and marks what is crowded.
    void settle();

    // How many of the given pairs of parts belong to each pair of pieces, their member `of`.
    template <class Pairs>
    [[nodiscard]] std::vector<size_t> counts_of(const Pairs &pairs) const {
        std::vector<size_t> counts(pairs_.size());
        for (const auto &pair : pairs) {
            ++counts[pair.of];
        }
        return counts;
    }
    // Limits that follow from the counts that are not 0: an equal share of `most`, and eight times the
    // median. Both are at least as much as there may be in one isolated place.
    static size_t share_of(size_t most, const std::vector<size_t> &counts) noexcept;
    static size_t far_above(const std::vector<size_t> &counts);

private:
    static constexpr size_t most_near = 4096, most_along = 512; // of all together
    static constexpr size_t least_near = 64, least_along = 16;  // of one pair of pieces
    static constexpr int most_asked = 4;
    static constexpr int64_t usual = 400000000;

    struct PiecePair {
        std::array<int64_t, 2> pieces; // on each surface
        uint32_t near, along;
        int asked;
        bool crowded;
    };

    [[nodiscard]] int64_t key(int64_t a, int64_t b) const noexcept {
        return a * grounds_[1]->grid.count() + b;
    }
    void find_crowds();
    void mark_neighbours(const PiecePair &pair);
    [[nodiscard]] std::vector<int64_t> neighbours(size_t surface, int64_t piece) const;

    std::array<const CrossGround *, 2> grounds_;
    std::vector<PiecePair> pairs_;
    std::unordered_map<int64_t, std::vector<Number>> numbers_; // by keys; made when first needed
    std::vector<Number> counted_, found_;                      // in this round
    size_t near_ = 0, along_ = 0, times_ = 1;
};

} // namespace nrb::intersect
