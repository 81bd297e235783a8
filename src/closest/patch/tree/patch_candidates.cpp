// SPDX-License-Identifier: MIT
#include "closest/patch/tree/patch_candidates.h"

#include "base/numbers.h"
#include "closest/patch/patch_place.h"

#include <algorithm>

namespace nrb::closest {

PatchCandidates::Overlap PatchCandidates::inside(const PatchTree::Extent &extent) const noexcept {
    Overlap part = Overlap::all;
    for (int k = 0; query_.range != nullptr && k < pieces_.spline_axes(); ++k) {
        const auto at = static_cast<size_t>(k);
        const double first = pieces_.break_at(k, extent.lower[at]),
                     last = pieces_.break_at(k, extent.upper[at]);
        const Interval &range = query_.range[k];
        if (last <= range.lower || first >= range.upper) {
            return Overlap::none;
        }
        part = first < range.lower || last > range.upper ? Overlap::some : part;
    }
    return part;
}

// Whether the centre of a node that is partly in the range is in the range.
bool PatchCandidates::holds_centre(int level, int64_t node) const noexcept {
    const PatchTree::Centre centre = tree_.centre(level, node);
    PatchTree::Extent piece{};
    piece.lower = piece.upper = pieces_.index(centre.piece);
    for (int64_t &i : piece.upper) {
        ++i;
    }
    const PatchBox box = box_in_range(pieces_, centre.piece, query_.range);
    bool holds = inside(piece) != Overlap::none;
    for (size_t k = 0; k < static_cast<size_t>(pieces_.shape().axes); ++k) {
        holds = holds && centre.at[k] >= box.lower[k] && centre.at[k] <= box.upper[k];
    }
    return holds;
}

void PatchCandidates::visit_children(int level, const Candidate &parent, Candidates &next) {
    const PatchTree::Family family = tree_.family(level, parent.node);
    double bounds[PatchTree::most_width], centres[PatchTree::most_width];
    tree_.bound(level, parent.node, x_, query_.farthest, {bounds, centres});
    const bool leaves = level + 2 == tree_.levels();
    for (int64_t i = 0; i < family.count; ++i) {
        if (!(bounds[i] <= reached_ + margin_)) {
            continue;
        }
        const int64_t node = family.first + i;
        const Overlap part = query_.range == nullptr ? Overlap::all : inside(tree_.extent(level + 1, node));
        if (part == Overlap::none) {
            continue;
        }
        if (centres[i] < reached_ && (part == Overlap::all || holds_centre(level + 1, node))) {
            reached_ = centres[i];
            start_level_ = level + 1;
            start_node_ = node;
        } else if (leaves && reached_ == infinity && (start_level_ < 0 || centres[i] < outside_)) {
            outside_ = centres[i];
            start_level_ = level + 1;
            start_node_ = node;
        }
        next.push_back({bounds[i], node});
    }
}

PatchCandidates::PatchCandidates(const PieceGrid &pieces, const PatchTree &tree, const Query &query,
                                 const double *x, double margin)
    : pieces_(pieces), tree_(tree), query_(query), x_(x), margin_(margin) {
    Candidates other;
    Candidates *now = &leaves_, *next = &other;
    if (tree_.levels() % 2 == 0) { // so that the last level ends up in leaves_
        std::swap(now, next);
    }
    reached_ = infinity;
    now->push_back({-infinity, 0});
    for (int level = 0; level + 1 < tree_.levels(); ++level) {
        next->clear();
        for (const Candidate &candidate : *now) {
            if (candidate.bound <= reached_ + margin_) {
                visit_children(level, candidate, *next);
            }
        }
        std::swap(now, next);
    }
}

// The leaves of a piece are consecutive.
void PatchCandidates::order(double limit, Groups &groups) {
    const auto nearer = [](const auto &a, const auto &b) { return a.bound < b.bound; };
    for (Candidate *first = leaves_.begin(); first != leaves_.end();) {
        const int64_t piece = tree_.leaf(first->node).piece;
        Candidate *end = first, *last = first;
        for (; end != leaves_.end() && tree_.leaf(end->node).piece == piece; ++end) {
            if (end->bound <= limit) {
                *last++ = *end;
            }
        }
        if (last != first) {
            std::sort(first, last, nearer);
            groups.push_back({first->bound, piece, first, last});
        }
        first = end;
    }
    std::sort(groups.begin(), groups.end(), nearer);
}

} // namespace nrb::closest
