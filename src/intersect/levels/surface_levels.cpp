// SPDX-License-Identifier: MIT
#include "intersect/levels/surface_levels.h"

#include "base/watch.h"
#include "intersect/levels/curves/level_curve.h"

#include <algorithm>
#include <utility>

namespace nrb::intersect {

namespace {

std::array<double, 2> middle_of(const LevelPart &part) noexcept {
    return {part.lower[0] + part.length[0] / 2, part.lower[1] + part.length[1] / 2};
}

// Drops the arcs, and the small clusters, at which zeros do not count. What adjoins a dropped arc ends there.
void drop_what_does_not_count(LevelField &field, LevelPieces &found) {
    std::erase_if(found.arcs, [&](const LevelArc &arc) {
        const bool counts = field.counts(arc.part.piece, arc.first) && field.counts(arc.part.piece, arc.last);
        if (!counts) {
            found.roots[static_cast<size_t>(arc.from)].is_end = true;
            found.roots[static_cast<size_t>(arc.to)].is_end = true;
        }
        return !counts;
    });
    std::erase_if(found.clusters, [&](const LevelCluster &cluster) {
        constexpr double small = 0x1p-8;
        const bool one_place = std::max(cluster.part.length[0], cluster.part.length[1]) <= small;
        return one_place && !field.counts(cluster.part.piece, middle_of(cluster.part));
    });
}

} // namespace

SurfaceLevels::SurfaceLevels(LevelField &field, double tolerance)
    : field_(field), borders_(field.grid()), tolerance_(field.grid().scaled(tolerance)) {}

Meet SurfaceLevels::find(int64_t level) {
    LevelTrace trace(field_, borders_, tolerance_);
    for (int64_t piece = 0; piece < field_.grid().count(); ++piece) {
        if (field_.may_vanish(piece)) {
            trace.add(piece);
        }
    }
    LevelPieces found = trace.take();
    const bool searched_in_part = work_ended();
    drop_what_does_not_count(field_, found);
    const LevelChains chains = chains_of(field_.grid(), borders_, found);
    Meet meet;
    meet.limited = searched_in_part;
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

Meet levels_of_functions(const Spline &surface, const Spline &spline, size_t count,
                         const std::function<LevelFunction(size_t i)> &function, double tolerance) {
    const LimitedSearch whole; // for a limit set by the caller; each level has its own usual limit
    const pieces::PieceGrid &grid = pieces::piece_grid_of(surface);
    Meet all;
    Steps steps(static_cast<int64_t>(count));
    for (size_t i = 0; i < count; ++i, steps.next()) {
        const UsualLimit usual(usual_work(surface.point_count(), 200000));
        const LimitedSearch limited;
        LevelFunction own = function(i);
        PieceField field(spline, grid, std::move(own.function), std::move(own.sign));
        all.append(SurfaceLevels(field, tolerance).find(static_cast<int64_t>(i)));
    }
    return all;
}

} // namespace nrb::intersect
