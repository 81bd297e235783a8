// SPDX-License-Identifier: MIT
// Nearest and farthest points of surfaces and volumes, with proof.
//
// The pieces of a spline stand in a tree of discs; a query takes those that may hold a point that counts,
// finds a minimum by Newton's method, and proves of each part of a piece that is left that it holds no better
// one: all Bernstein coefficients of |A - x w|^2 - r^2 w^2 are >= 0, or that polynomial is convex, or its
// halves are looked at. The idea of eliminating by these coefficients is Chen, Yong, Wang, Paul & Xu's
// ("Computing the minimum distance between a point and a NURBS curve", CAD 40, 2008). All rounding is in the
// proofs.
#pragma once

#include "base/lazy.h"
#include "closest/locator.h"
#include "closest/patch/tree/patch_tree.h"

namespace nrb::closest {

class PatchLocator final : public Locator {
public:
    // Kept with the spline.
    explicit PatchLocator(const Spline &spline) : spline_(spline), pieces_(pieces::piece_grid_of(spline)) {}

    [[nodiscard]] Foot nearest(const Query &query) const override;
    [[nodiscard]] Foot local(const double *point, const double *guess) const override;
    [[nodiscard]] CriticalSet critical(const Query &query) const override;
    [[nodiscard]] CriticalSet minima(const Query &query) const override;

private:
    // Descents need none.
    [[nodiscard]] const PatchTree &tree() const {
        return tree_.get([this] { return PatchTree(pieces::piece_tree_of(spline_)); });
    }

    const Spline &spline_;
    const PieceGrid &pieces_;
    Lazy<PatchTree> tree_;
};

} // namespace nrb::closest
