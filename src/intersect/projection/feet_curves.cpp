// SPDX-License-Identifier: MIT
#include "intersect/projection/feet_curves.h"

#include "base/watch.h"
#include "intersect/projection/feet_segment.h"
#include "intersect/surfaces/cross_chains.h"
#include "intersect/surfaces/curves/cross_curve.h"
#include "intersect/surfaces/surface_surface.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nrb::intersect {

namespace {

// A cluster is a touch if it is no larger than the tolerance on the surface and on the curve.
class FeetTouch final : public TouchTest {
public:
    FeetTouch(const std::array<double, 3> &speeds, double tolerance)
        : speeds_(speeds), tolerance_(tolerance) {}
    [[nodiscard]] bool is_touch(const std::array<Interval, 4> &ranges) const override {
        return size_in_space(speeds_, ranges) <= tolerance_;
    }
    void narrow(std::array<Interval, 4> & /*ranges*/) const override {}

private:
    std::array<double, 3> speeds_;
    double tolerance_;
};

class FeetCurves {
public:
    FeetCurves(const SplinePtr &curve, const Spline &surface, const Spline &lines, double tolerance)
        : surface_(surface), lines_(lines), frame_(frame_of_both(curve.get(), &surface)),
          tolerance_(frame_.scaled(tolerance)), borders_(pieces::piece_grid_of(surface)),
          line_borders_(pieces::piece_grid_of(lines)), ground_(surface, frame_, borders_, side_shifts[0]),
          of_lines_(lines, frame_, line_borders_, side_shifts[1]),
          search_(ground_, of_lines_, *curve, frame_),
          fitter_({surface.axis(0).degree(), surface.axis(1).degree()}, curve->axis(0).degree(), frame_,
                  tolerance_) {}

    Meet run() {
        const CrossSurface on_surface{ground_.grid, borders_}, on_lines{of_lines_.grid, line_borders_};
        find_parts();
        const FeetTouch touch(search_.speeds(), tolerance_);
        CrossChains chains = joined_chains(on_surface, on_lines, joined_arcs(),
                                           cross_groups(on_surface, on_lines, touch, found_.clusters));
        meet_.limited = meet_.limited || work_ended();
        meet_.of_two = true;
        meet_.periodic = {periodic_axes_of(surface_), periodic_axes_of(lines_)};
        meet_.nodes = std::move(chains.nodes);
        meet_.complete = std::ranges::none_of(
            meet_.nodes, [](const MeetNode &node) { return node.kind == NodeKind::undecided; });
        for (const CrossChain &chain : chains.chains) {
            std::vector<CrossSegment> segments;
            for (const size_t arc : chain.arcs) {
                fitter_.fit(found_.arcs[arc], segments);
            }
            meet_.branches.push_back(
                branch_along(cross_curve(frame_, on_surface, on_lines, std::move(segments), chain.closed),
                             chain.nodes, chain.loop, BranchKind::crossing));
        }
        return std::move(meet_);
    }

private:
    static pieces::Frame frame_of_both(const Spline *curve, const Spline *surface) {
        return pieces::frame_of({{surface, curve}});
    }

    void find_parts() {
        const PartOfWork half;
        found_ = search_.run(tolerance_);
        meet_.limited = work_ended();
        std::erase_if(found_.arcs, [&](const FeetArc &arc) { return is_at_pole(arc); });
    }
    // Whether the arc runs along a pole of its patch, so that all of it is one point of the surface.
    static bool is_at_pole(const FeetArc &arc) noexcept {
        constexpr double near = 4 * shift_of_sides;
        const FeetCell &cell = *arc.box.patch;
        for (size_t k = 0; k < 2; ++k) {
            for (size_t end = 0; end < 2; ++end) {
                const bool at_pole = std::ranges::all_of(arc.ends, [&](const GraphEnd<3> &e) {
                    const double place = cell.lower(k) + cell.length(k) * e.at[k];
                    return std::abs(place - static_cast<double>(end)) <= near;
                });
                if (cell.piece().poles[k][end] && at_pole) {
                    return true;
                }
            }
        }
        return false;
    }

    [[nodiscard]] std::vector<JoinedArc> joined_arcs() const {
        std::vector<JoinedArc> arcs;
        arcs.reserve(found_.arcs.size());
        for (const FeetArc &arc : found_.arcs) {
            JoinedArc &joined = arcs.emplace_back();
            for (size_t e = 0; e < 2; ++e) {
                const GraphEnd<3> &end = arc.ends[e];
                joined.spots[e] = spot_of(arc, end);
                joined.open[e] = arc.box.cell(end.coordinate).is_open(end.coordinate % 2, end.side);
                joined.creased[e] = is_at_crease(arc, end);
            }
        }
        return arcs;
    }
    [[nodiscard]] CrossSpot spot_of(const FeetArc &arc, const GraphEnd<3> &end) const noexcept {
        CrossSpot spot;
        const FeetPlace noise = noise_of_end(arc.box.chart, end);
        for (size_t i = 0; i < 3; ++i) {
            const FeetCell &cell = arc.box.cell(i);
            spot.index[i] = cell.piece().index[i % 2];
            spot.place[i] = cell.lower(i % 2) + cell.length(i % 2) * end.at[i];
            spot.noise[i] = cell.length(i % 2) * noise[i];
            const Interval &range = cell.piece().range[i % 2];
            spot.parameter[i] = range.lower * (1 - spot.place[i]) + range.upper * spot.place[i];
        }
        spot.place[3] = 0.5; // h does not take part in matching the ends of arcs
        spot.parameter[3] = fitter_.distance_at(arc, end.at);
        return spot;
    }
    // Whether the end is on a side of its patch along which the surface may have a crease.
    [[nodiscard]] bool is_at_crease(const FeetArc &arc, const GraphEnd<3> &end) const noexcept {
        const FeetCell &cell = *arc.box.patch;
        if (end.coordinate == 2 || !cell.is_border(end.coordinate, end.side)) {
            return false;
        }
        const int axis = static_cast<int>(end.coordinate);
        const int64_t at = cell.piece().index[end.coordinate] + static_cast<int64_t>(end.side),
                      n = ground_.grid.count(axis);
        return at == 0 || at == n || ground_.grid.kinks(axis, at);
    }

    const Spline &surface_, &lines_;
    pieces::Frame frame_;
    double tolerance_;
    SurfaceBorders borders_, line_borders_;
    CrossGround ground_, of_lines_;
    FeetSearch search_;
    FeetFitter fitter_;
    FeetParts found_;
    Meet meet_;
};

} // namespace

Meet feet_curves(const SplinePtr &curve, const Spline &surface, const Spline &lines, double tolerance) {
    const UsualLimit usual(usual_work(curve->point_count() + surface.point_count()));
    const LimitedSearch limited;
    return FeetCurves(curve, surface, lines, tolerance).run();
}

} // namespace nrb::intersect
