// SPDX-License-Identifier: MIT
// The leaves of the tree that a query has to look at.
#pragma once

#include "closest/foot.h"
#include "closest/patch/patch_memory.h"
#include "closest/patch/tree/patch_tree.h"

namespace nrb::closest {

class PatchCandidates {
public:
    struct Candidate {
        double bound; // of sign * distance
        int64_t node;
    };
    using Candidates = ShortList<Candidate, 96>;
    // Those in one piece, in rising order of their bounds, the least of which is `bound`.
    struct Group {
        double bound;
        int64_t piece;
        Candidate *first, *last;
    };
    using Groups = ShortList<Group, 32>;

    // Those that may hold a point that is worse than the best one by no more than the margin; x as placed by
    // the pieces.
    PatchCandidates(const PieceGrid &pieces, const PatchTree &tree, const Query &query, const double *x,
                    double margin);

    // The best centre seen that is in the range, or else that of a leaf which meets it.
    [[nodiscard]] PatchTree::Centre start() const noexcept { return tree_.centre(start_level_, start_node_); }
    // Those whose bounds are at most a limit, in rising order of the bounds.
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
    double reached_ = 0; // of the best value, from above: the best centre in the range
    double outside_ = 0; // the best centre of a leaf while there is none
    int start_level_ = -1;
    int64_t start_node_ = 0;
    Candidates leaves_;
};

} // namespace nrb::closest
