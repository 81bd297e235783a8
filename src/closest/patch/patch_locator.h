// SPDX-License-Identifier: MIT
// Nearest and farthest points of surfaces and volumes, with proof.
//
// The pieces of a spline are kept in a tree of bounding discs. A query selects those that may hold a point
// that counts, finds a minimum by Newton's method, and then has to prove for every remaining part of a piece
// that it holds no better point. The proof for a part with a homogeneous patch A / w, a query point x and a
// distance r is that all Bernstein coefficients of |A - x w|^2 - r^2 w^2 are >= 0, or that this polynomial is
// convex and its minimum is >= 0; failing that, the part is halved. Elimination by these coefficients is due
// to Chen, Yong, Wang, Paul & Xu ("Computing the minimum distance between a point and a NURBS curve", CAD 40,
// 2008). The proofs include all rounding errors.
#pragma once

#include "base/lazy.h"
#include "closest/locator.h"
#include "closest/patch/tree/patch_tree.h"

namespace nrb::closest {

class PatchLocator final : public Locator {
public:
    // The spline keeps the locator.
    explicit PatchLocator(const Spline &spline) : spline_(spline), pieces_(pieces::piece_grid_of(spline)) {}

    [[nodiscard]] Foot nearest(const Query &query) const override;
    [[nodiscard]] Foot local(const double *point, const double *guess) const override;
    [[nodiscard]] CriticalSet critical(const Query &query) const override;
    [[nodiscard]] CriticalSet minima(const Query &query) const override;

private:
    // Built when it is first needed; descents do without it.
    [[nodiscard]] const PatchTree &tree() const {
        return tree_.get([this] { return PatchTree(pieces::piece_tree_of(spline_)); });
    }

    const Spline &spline_;
    const PieceGrid &pieces_;
    Lazy<PatchTree> tree_;
};

} // namespace nrb::closest
