// SPDX-License-Identifier: MIT
// The branch-and-bound search for the nearest or farthest points of one query.
#pragma once

#include "base/watch.h"
#include "closest/patch/patch_minima.h"
#include "closest/patch/patch_proof.h"
#include "closest/patch/tree/patch_candidates.h"
#include "pieces/best_first.h"

#include <vector>

namespace nrb::closest {

class PatchSearch : public PatchMinima {
public:
    PatchSearch(const PieceGrid &pieces, const PatchTree &tree, const Query &query);

    Foot nearest();
    // All minima that are as near as the nearest one to the tolerance, in increasing order of parameters.
    std::vector<Foot> all();

private:
    // Bounds the memory for parts that were put off; once the queue is full, the search continues depth
    // first.
    static constexpr size_t most_put_off = 4096;
    using Candidate = PatchCandidates::Candidate;
    struct PutOff {
        double best;                // best value at the time
        PatchItem item;             // without its values
        int axis;                   // along which to halve it
        std::vector<double> values; // those of the item
    };

    void start(const PatchTree::Centre &centre);
    void search();
    void search_piece(const PatchCandidates::Group &group);
    void search_later();
    void search_leaf(const PatchItem &whole, const PatchBox &part, const PatchTree::Leaf &leaf);
    // Proves that a part of a piece does not matter, or searches its halves.
    void examine(PatchItem &item, bool fresh);
    bool finished(const PatchItem &item, bool &fresh, int &axis);
    bool finished_without_squares(const PatchItem &item, bool &fresh);
    enum class Verdict {
        open,
        improved,
        finished
    }; // improved: a point of the part is the new best one, so the proof has to be repeated
    Verdict prove(const PatchItem &item, const PatchGap &gap, bool &fresh, int &axis);
    bool is_worse(const PatchItem &item, const PatchGap &gap);
    bool is_least(const PatchItem &item, const PatchGap &gap, const PatchProof &found);
    bool excluded_by_plane(const PatchItem &item);
    void split(PatchItem &item, int axis);
    void put_off(const PatchItem &item, int axis);
    [[nodiscard]] double order(const PatchItem &item) const;
    [[nodiscard]] bool spent() const noexcept {
        return spent_ + cost_ > query_.most_pieces() || work_ended();
    }
    void spend();
    bool improve(const PatchItem &item, AxisValues at);
    [[nodiscard]] PatchGoal goal(double value, const PatchItem &item) const noexcept;
    [[nodiscard]] bool asks_for_others() const noexcept {
        return all_ || (!query_.alone && !not_unique_ && extra_ < 24);
    }

    void search_minima();

    const PatchTree &tree_;
    bool incomplete_ = false;
    int64_t cost_ = 1; // of an item, in units of the budget
    int64_t work_ = 1; // of an item, in multiply-adds
    int64_t spent_ = 0;
    int64_t pause_ = 0;               // spent_ at which parts begin to be put off
    pieces::BestFirst<PutOff> later_; // ordered by negated order()
    int overdraft_ = 16;              // descents from middles of leaves, allowed after the budget
    int extra_ = 0;                   // items examined only because there may be other minima
};

} // namespace nrb::closest
