// SPDX-License-Identifier: MIT
#include "intersect/levels/surface_levels.h"

#include "intersect/levels/level_curve.h"

namespace nrb::intersect {

SurfaceLevels::SurfaceLevels(LevelField &field, double tolerance)
    : field_(field), borders_(field.grid()), tolerance_(field.grid().scaled(tolerance)) {}

Meet SurfaceLevels::find(int64_t level) {
    LevelTrace trace(field_, borders_, tolerance_);
    for (int64_t piece = 0; piece < field_.grid().count(); ++piece) {
        if (field_.may_vanish(piece)) {
            trace.add(piece);
        }
    }
    const LevelPieces found = trace.take();
    const LevelChains chains = chains_of(field_.grid(), borders_, found);
    Meet meet;
    for (const MeetNode &node : chains.nodes) {
        meet.nodes.push_back(node);
        meet.nodes.back().level = level;
        meet.complete = meet.complete && node.kind != NodeKind::undecided;
    }
    ArcFitter fitter(field_, tolerance_);
    for (const LevelChain &chain : chains.chains) {
        LevelCurve curve = curve_of(fitter, field_.grid(), borders_, found, chain);
        meet.branches.push_back({level,
                                 std::move(curve.space),
                                 std::move(curve.on),
                                 curve.deviation,
                                 {chain.nodes[0], chain.nodes[1]},
                                 chain.loop});
    }
    return meet;
}

} // namespace nrb::intersect
