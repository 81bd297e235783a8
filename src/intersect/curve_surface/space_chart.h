// SPDX-License-Identifier: MIT
// Pieces of a curve and of a surface in space that meet once at most.
#pragma once

#include "intersect/contraction.h"
#include "intersect/curve_surface/patch_slopes.h"

namespace nrb::intersect {

// A piece of a surface whose weights are positive.
struct SlopedPatch {
    const pieces::BezierPiece *piece;
    PatchSlopes *slopes;
    [[nodiscard]] const double *mean(int axis) const noexcept { return slopes->mean(axis); }
    [[nodiscard]] const pieces::Slopes &along(int axis) const { return slopes->along(axis); }
};

// The contraction of F(t, u, v) = C(t) - S(u, v): M is the inverse of (c, -s_u, -s_v), with the means of the derivatives.
class SpaceChart {
public:
    // M alone, of these pieces.
    void set(const pieces::SlopedPiece &arc, const SlopedPatch &patch);
    // Whether there is one, and which way the curve goes through the surface then: 1 or -1.
    [[nodiscard]] int turn() const noexcept { return turn_; }
    // Whether a row of M F is nowhere as small as where |F| <= near, as control points tell. Precondition: turn() != 0.
    [[nodiscard]] bool excludes(const pieces::SlopedPiece &arc, const SlopedPatch &patch,
                                double near) const noexcept;

    // The contraction. The hulls of derivatives are asked for only if the corners leave room for a proof.
    void prove(const pieces::SlopedPiece &arc, const SlopedPatch &patch);
    [[nodiscard]] bool proven() const noexcept { return contraction_.proven(); }
    [[nodiscard]] const Contraction &contraction() const noexcept { return contraction_; }
    // M times a difference.
    [[nodiscard]] Place<3> step(const double *difference) const noexcept;
    // Whether the curve bends more than the surface, as M has it.
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

// The step of Newton's method from a difference where the derivatives are these; false if they all but lie in a plane.
bool newton_step(const double *c, const double *u, const double *v, const double *difference,
                 Place<3> &step) noexcept;

} // namespace nrb::intersect
