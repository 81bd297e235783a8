// SPDX-License-Identifier: MIT
// A Krawczyk test for a curve piece and a surface piece that meet at most once.
#pragma once

#include "intersect/contraction.h"
#include "intersect/curve_surface/patch_slopes.h"

namespace nrb::intersect {

// A surface piece with positive weights, and its derivatives.
struct SlopedPatch {
    const pieces::BezierPiece *piece;
    PatchSlopes *slopes;
    [[nodiscard]] const double *mean(int axis) const noexcept { return slopes->mean(axis); }
    [[nodiscard]] const pieces::Slopes &along(int axis) const { return slopes->along(axis); }
};

// The contraction of F(t, u, v) = C(t) - S(u, v). M is the inverse of (c, -s_u, -s_v), the mean derivatives.
class SpaceChart {
public:
    // Sets M for these pieces, without a proof.
    void set(const pieces::SlopedPiece &arc, const SlopedPatch &patch);
    // 0: M does not exist. Otherwise 1 or -1: in which sense the curve passes through the surface.
    [[nodiscard]] int turn() const noexcept { return turn_; }
    // Whether some row of M F is everywhere larger than |F| <= near allows, as the control points show.
    // Precondition: turn() != 0.
    [[nodiscard]] bool excludes(const pieces::SlopedPiece &arc, const SlopedPatch &patch,
                                double near) const noexcept;

    // Sets the contraction. The hulls of derivatives are computed only if the corners leave room for a proof.
    void prove(const pieces::SlopedPiece &arc, const SlopedPatch &patch);
    [[nodiscard]] bool proven() const noexcept { return contraction_.proven(); }
    [[nodiscard]] const Contraction &contraction() const noexcept { return contraction_; }
    // M times a difference.
    [[nodiscard]] Place<3> step(const double *difference) const noexcept;
    // Whether the curve contributes more to rho than the surface.
    [[nodiscard]] bool curve_bends_more() const noexcept { return curve_bends_more_; }

private:
    using Rows = std::array<std::array<double, 3>, 3>;
    [[nodiscard]] double least_rho(const pieces::SlopedPiece &arc, const SlopedPatch &patch) noexcept;
    void set_rho(const pieces::SlopedPiece &arc, const SlopedPatch &patch);

    Rows rows_{}; // of M
    Contraction contraction_;
    int turn_ = 0;
    bool curve_bends_more_ = false;
};

// The Newton step for a difference, from the derivatives; false if they are nearly coplanar.
bool newton_step(const double *c, const double *u, const double *v, const double *difference,
                 Place<3> &step) noexcept;

} // namespace nrb::intersect
