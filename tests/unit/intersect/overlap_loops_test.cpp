// The regions that loops bound on a closed surface.
#include "intersect/surfaces/overlap/overlap_loops.h"
#include "pieces/frame.h"
#include "unit/face/face_shapes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace overlap_loops_unit_test {

using namespace nrb;
using namespace nrb::intersect;

namespace {

using Place2 = std::array<double, 2>;
using Curve = std::function<Place2(double)>; // over [0, 1]

// A cylinder; both parameters run from 0 to 1.
class Cylinder {
public:
    [[nodiscard]] OverlapGround ground() const { return {*spline_, *spline_, frame_, solver_}; }

private:
    static SplinePtr made() {
        const SplinePtr ring = build::cylinder(build::make_placement(3, nullptr, nullptr, nullptr, "centre"),
                                               1, 1, build::full_turn(), 0);
        return refine::reparametrize(refine::reparametrize(ring, 0, {0, 1}), 1, {0, 1});
    }

    SplinePtr spline_ = made();
    pieces::Frame frame_ = pieces::frame_of(*spline_);
    SurfaceBorders borders_{pieces::piece_grid_of(*spline_)};
    CrossGround ground_{*spline_, frame_, borders_, side_shifts[0]};
    ContactSolver solver_{ground_, ground_};
};

OverlapEdge closed_edge(const Curve &curve) {
    constexpr int parts = 24;
    OverlapEdge edge;
    edge.closed = true;
    for (int i = 0; i < parts; ++i) {
        const Place2 from = curve(static_cast<double>(i) / parts), to = curve((i + 1.0) / parts);
        CrossSegment &segment = edge.segments.emplace_back();
        for (size_t j = 0; j < 4; ++j) {
            const double share = static_cast<double>(j) / 3;
            segment.on[0][j] = {from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])};
        }
    }
    return edge;
}

constexpr double turn = 2 * std::numbers::pi;
// All borders of strips undulate alike, by more than strips are wide.
double height(double u) {
    return 0.25 * std::sin(turn * u);
}
Curve around(double from, double level, bool forward) {
    return [=](double t) {
        const double u = from + (forward ? t : -t);
        return Place2{u, level + height(u)};
    };
}
// Clockwise.
Curve hole(double u, double level) {
    return [=](double t) {
        return Place2{u + 0.02 * std::sin(turn * t), level + height(u) + 0.01 * std::cos(turn * t)};
    };
}

} // namespace

TEST(OverlapLoops, strips_that_undulate_have_their_holes) {
    const Cylinder cylinder;
    const OverlapGround ground = cylinder.ground();
    std::mt19937 engine(5);
    std::uniform_real_distribution<double> unit(0, 1);
    const std::array<double, 4> levels{0.3, 0.42, 0.55, 0.7};
    for (int trial = 0; trial < 200; ++trial) {
        SCOPED_TRACE(trial);
        std::vector<size_t> strip_of; // of each edge
        OverlapEdges edges;
        const auto add = [&](size_t strip, const Curve &curve) {
            strip_of.push_back(strip);
            edges.edges.push_back(closed_edge(curve));
        };
        for (const size_t strip : {size_t{0}, size_t{1}}) {
            const double below = levels[2 * strip], above = levels[2 * strip + 1];
            add(strip, around(unit(engine), below, true));
            add(strip, around(unit(engine), above, false));
            add(strip, hole(unit(engine), below / 2 + above / 2));
        }
        const std::optional<OverlapRegions> regions = overlap_regions(ground, edges);
        ASSERT_TRUE(regions);
        ASSERT_EQ(regions->list.size(), 2U);
        for (const OverlapRegion &region : regions->list) {
            ASSERT_EQ(region.loops.size(), 3U);
            for (const OverlapLoop &loop : region.loops) {
                EXPECT_EQ(strip_of[loop.front()], strip_of[region.loops.front().front()]);
            }
        }
    }
}

} // namespace overlap_loops_unit_test
