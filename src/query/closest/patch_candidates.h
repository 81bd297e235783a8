// The leaves of the tree that a query has to look at.
#pragma once

#include "query/closest/foot.h"
#include "query/closest/patch_memory.h"
#include "query/closest/patch_tree.h"

namespace nrb {

class PatchCandidates {
public:
    struct Candidate {
        double bound; // of sign * distance
        int64_t node;
    };
    using Candidates = ShortList<Candidate, 96>;

    // Those that may hold a point that is worse than the best one by no more than the margin; x as placed by
    // the pieces.
    PatchCandidates(const PatchPieces &pieces, const PatchTree &tree, const Query &query, const double *x,
                    double margin);

    [[nodiscard]] Candidates &leaves() noexcept { return leaves_; }
    // The one with the best centre.
    [[nodiscard]] int64_t start() const noexcept { return start_leaf_; }

private:
    enum class Part { none, some, all };
    [[nodiscard]] Part inside(const PatchTree::Extent &extent) const noexcept;
    void visit_children(int level, const Candidate &parent, Candidates &next);

    const PatchPieces &pieces_;
    const PatchTree &tree_;
    const Query &query_;
    const double *x_;
    double margin_;
    double reached_ = 0; // of the best value, from above
    int64_t start_leaf_ = -1;
    Candidates leaves_;
};

} // namespace nrb
