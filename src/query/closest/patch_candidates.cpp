#include "query/closest/patch_candidates.h"

#include <limits>

namespace nrb {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

} // namespace

PatchCandidates::Part PatchCandidates::inside(const PatchTree::Extent &extent) const noexcept {
    Part part = Part::all;
    for (int k = 0; query_.range != nullptr && k < pieces_.spline_axes(); ++k) {
        const auto at = static_cast<size_t>(k);
        const double first = pieces_.break_at(k, extent.lower[at]),
                     last = pieces_.break_at(k, extent.upper[at]);
        const Interval &range = query_.range[k];
        if (last <= range.lower || first >= range.upper) {
            return Part::none;
        }
        part = first < range.lower || last > range.upper ? Part::some : part;
    }
    return part;
}

void PatchCandidates::visit_children(int level, const Candidate &parent, Candidates &next) {
    const PatchTree::Family &family = tree_.family(level, parent.node);
    double bounds[PatchTree::most_width], centres[PatchTree::most_width];
    bound_discs(tree_.discs(family), family.width, pieces_.shape().dim, tree_.normals(), x_, query_.farthest,
                {bounds, centres});
    const bool leaves = level + 2 == tree_.levels();
    for (int64_t i = 0; i < family.count; ++i) {
        if (!(bounds[i] <= reached_ + margin_)) {
            continue;
        }
        const int64_t node = family.first + i;
        const Part part = query_.range == nullptr ? Part::all : inside(tree_.extent(level + 1, node));
        if (part == Part::none) {
            continue;
        }
        if (part == Part::all && centres[i] < reached_) {
            reached_ = centres[i];
        }
        if (leaves && (start_leaf_ < 0 || centres[i] <= reached_)) {
            start_leaf_ = node;
        }
        next.push_back({bounds[i], node});
    }
}

PatchCandidates::PatchCandidates(const PatchPieces &pieces, const PatchTree &tree, const Query &query,
                                 const double *x, double margin)
    : pieces_(pieces), tree_(tree), query_(query), x_(x), margin_(margin) {
    Candidates &leaves = leaves_;
    Candidates other;
    Candidates *now = &leaves, *next = &other;
    reached_ = infinite;
    now->push_back({-infinite, 0});
    for (int level = 0; level + 1 < tree_.levels(); ++level) {
        next->clear();
        for (const Candidate &candidate : *now) {
            if (candidate.bound <= reached_ + margin_) {
                visit_children(level, candidate, *next);
            }
        }
        std::swap(now, next);
    }
    if (now != &leaves) {
        leaves.clear();
        for (const Candidate &candidate : *now) {
            leaves.push_back(candidate);
        }
    }
}

} // namespace nrb
