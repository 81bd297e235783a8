// SPDX-License-Identifier: MIT
// Splines along chains of arcs.
#pragma once

#include "intersect/levels/curves/level_segment.h"
#include "intersect/levels/trace/level_chains.h"

namespace nrb::intersect {

// Cubics with the same knots, whose parameter is about the length in space: in space, and in the parameter domain, where
// they may run into neighbouring periods. f > 0 on the left of the latter.
struct LevelCurve {
    SplinePtr space, on;
    double deviation; // of either, in space, from the level
};

LevelCurve curve_of(ArcFitter &fitter, const pieces::PieceGrid &grid, const SurfaceBorders &borders,
                    const LevelPieces &found, const LevelChain &chain);

} // namespace nrb::intersect
