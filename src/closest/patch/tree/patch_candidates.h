// SPDX-License-Identifier: MIT
// The leaves of the tree that a query has to examine.
#pragma once

#include "closest/foot.h"
#include "closest/patch/patch_memory.h"
#include "closest/patch/tree/patch_tree.h"

namespace nrb::closest {

class PatchCandidates {
public:
    struct Candidate {
        double bound; // lower bound on sign * distance
        int64_t node;
    };
    using Candidates = ShortList<Candidate, 96>;
    // The candidates in one piece in increasing order of their bounds; `bound` is the smallest one.
    struct Group {
        double bound;
        int64_t piece;
        Candidate *first, *last;
    };
    using Groups = ShortList<Group, 32>;

    // Collects the leaves that may hold a point that is worse than the best one by at most the margin. x: the
    // query point in the frame of the pieces.
    PatchCandidates(const PieceGrid &pieces, const PatchTree &tree, const Query &query, const double *x,
                    double margin);

    // The best centre seen in the range; if there is none, the best centre of a leaf that meets the range.
    [[nodiscard]] PatchTree::Centre start() const noexcept { return tree_.centre(start_level_, start_node_); }
    // Groups the candidates whose bounds are at most a limit, in increasing order of the bounds.
    void order(double limit, Groups &groups);

private:
    enum class Overlap { none, some, all };
    [[nodiscard]] Overlap inside(const PatchTree::Extent &extent) const noexcept;
    [[nodiscard]] bool holds_centre(int level, int64_t node) const noexcept;
    void visit_children(int level, const Candidate &parent, Candidates &next);

    const PieceGrid &pieces_;
    const PatchTree &tree_;
    const Query &query_;
    const double *x_;
    double margin_;
    double reached_ = 0; // upper bound on the best value: that of the best centre in the range
    double outside_ = 0; // value of the best centre of a leaf, as long as no centre is in the range
    int start_level_ = -1;
    int64_t start_node_ = 0;
    Candidates leaves_;
};

} // namespace nrb::closest
