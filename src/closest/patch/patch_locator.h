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

#include "closest/locator.h"
#include "closest/patch/tree/patch_tree.h"

#include <vector>

namespace nrb::closest {

class PatchLocator final : public Locator {
public:
    explicit PatchLocator(const pieces::PieceTree &tree) : pieces_(tree.grid()), tree_(tree) {}

    [[nodiscard]] Foot nearest(const Query &query) const override;
    [[nodiscard]] Foot local(const double *point, const double *guess) const override;
    [[nodiscard]] CriticalSet critical(const Query &query) const override;
    [[nodiscard]] CriticalSet minima(const Query &query) const override;

private:
    const PieceGrid &pieces_;
    PatchTree tree_;
};

} // namespace nrb::closest
