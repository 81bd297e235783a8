// SPDX-License-Identifier: MIT
// Where so much of two surfaces is near that parts of them are not worth being told apart.
#pragma once

#include "intersect/surfaces/cross_cell.h"

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace nrb::intersect {

// How far the middle of the first part is from the second one, near its foot there; infinite if that is not in the wide part.
double distance_of_middle(const CrossCell &part, const CrossCell &other);

// Whether what is around the first part, several times as wide, lies on the surface of the second one, as far as a few places
// tell that are in line with nothing. Where surfaces touch in a point, or cross in one, parts that are all but one are small.
bool lies_on(const CrossCell &part, const CrossCell &other, double tolerance);

// Pairs of parts that are near each other all over, counted by the pairs of pieces that they are of, in rounds of parts of one
// size. Where these are many it is told which pairs of pieces are crowded: those of which a part lies on the other surface, their
// neighbours, in which such parts end, and those that have more than their share. So a crowd in one place is none in another.
class CrossCrowds {
public:
    using Number = uint32_t; // of a pair of pieces

    CrossCrowds(const CrossGround &a, const CrossGround &b) : grounds_{&a, &b} {}

    // Shares grow with the work that may be done, if it is more than usual.
    void allow(int64_t work) noexcept { times_ = static_cast<size_t>(std::max(work / usual, int64_t{1})); }

    Number add(const CrossPiece &a, const CrossPiece &b);
    [[nodiscard]] bool is_crowded(Number pair) const noexcept { return pairs_[pair].crowded; }

    // along: whether one lies on the other one, as far as its middle tells.
    void count(Number pair, bool along);
    [[nodiscard]] bool are_many() const noexcept { return near_ > most_near || along_ > most_along; }
    // If they are: for some of those that are along each other, whether lies_on().
    [[nodiscard]] bool is_asked_for(Number pair) const noexcept {
        return !pairs_[pair].crowded && pairs_[pair].asked < most_asked;
    }
    void tell(Number pair, bool lies_on);
    // Ends the round.
    void settle();

    // How many of some there are, which know the pieces that they are of.
    template <class Pairs>
    [[nodiscard]] std::vector<size_t> counts_of(const Pairs &pairs) const {
        std::vector<size_t> counts(pairs_.size());
        for (const auto &pair : pairs) {
            ++counts[pair.of];
        }
        return counts;
    }
    // Of those that there are of any of: the share of so many, and what is far more than most have; both at least what may be in
    // one place alone.
    static size_t share_of(size_t most, const std::vector<size_t> &counts) noexcept;
    static size_t far_above(const std::vector<size_t> &counts);

private:
    static constexpr size_t most_near = 4096, most_along = 512; // of all
    static constexpr size_t least_near = 64, least_along = 16;  // of one pair of pieces
    static constexpr int most_asked = 4;
    static constexpr int64_t usual = 400000000;

    struct PiecePair {
        std::array<int64_t, 2> pieces; // of each surface
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
    std::unordered_map<int64_t, std::vector<Number>> numbers_; // by keys, made when neighbours are asked for
    std::vector<Number> counted_, found_;                      // in this round
    size_t near_ = 0, along_ = 0, times_ = 1;
};

} // namespace nrb::intersect
