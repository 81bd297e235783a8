// Arcs joined end to beginning: whatever may be one place is one.
#include "intersect/surfaces/cross_chains.h"
#include "unit/face/face_shapes.h"
#include "unit/shapes.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace cross_chains_unit_test {

using namespace nrb;
using namespace nrb::intersect;

namespace {

constexpr double one_place = 32 * shift_of_sides;
constexpr double most_beyond = 0x1p-26; // of arcs along borders

// A prism: it closes along the first axis, in pieces of very different lengths.
SplinePtr prism() {
    std::vector<double> points;
    for (const auto &[x, y] :
         std::vector<std::pair<double, double>>{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}) {
        points.insert(points.end(), {x, y, 0, x, y, 1});
    }
    return make_spline({make_knot_vector(1, {0, 0, 0.1, 0.5, 0.52, 1, 1}), shapes::bezier_axis(1)}, 3,
                       Form::polynomial, std::move(points));
}

// Two ends that are one place, in pieces before and after a border of both surfaces, or in the same piece.
class Joints {
public:
    Joints(const pieces::PieceGrid &grid, int seed) : grid_(grid), engine_(static_cast<unsigned>(seed)) {}

    double unit() { return std::uniform_real_distribution<double>(-1, 1)(engine_); }
    [[nodiscard]] double length(int64_t piece) const {
        return grid_.break_at(0, piece + 1) - grid_.break_at(0, piece);
    }
    double noise() { return unit() < 0 ? 1e-15 : std::pow(10.0, -9 + 3 * unit()); }

    // Sets the last spot of one arc, and the first of the next one.
    void set(CrossSpot &end, CrossSpot &begin, int64_t before, int64_t after) {
        for (size_t i = 0; i < 4; ++i) {
            end.noise[i] = noise();
            begin.noise[i] = noise();
            const bool along = i % 2 == 0;
            end.index[i] = along ? before : 0;
            begin.index[i] = along ? after : 0;
            const double off = 15 * (one_place + end.noise[i] + begin.noise[i]) * unit();
            if (!along || before == after) {
                end.place[i] = 0.5;
                begin.place[i] = 0.5 + off;
            } else {
                const double own = length(before), other = length(after), beyond = most_beyond * unit();
                end.place[i] = 1 + beyond;
                begin.place[i] = (beyond * own + off * std::min(own, other)) / other;
            }
            set_parameter(end, i);
            set_parameter(begin, i);
        }
    }

private:
    void set_parameter(CrossSpot &spot, size_t i) const {
        const int axis = static_cast<int>(i % 2);
        const double lower = grid_.break_at(axis, spot.index[i]),
                     upper = grid_.break_at(axis, spot.index[i] + 1);
        spot.parameter[i] = lower * (1 - spot.place[i]) + upper * spot.place[i];
    }

    const pieces::PieceGrid &grid_;
    std::mt19937 engine_;
};

} // namespace

TEST(CrossChains, close_all_around) {
    const SplinePtr surface = prism();
    const pieces::PieceGrid &grid = pieces::piece_grid_of(*surface);
    const SurfaceBorders borders(grid);
    ASSERT_TRUE(borders.wraps(0));
    const int64_t n = grid.count(0);
    for (int trial = 0; trial < 1000; ++trial) {
        SCOPED_TRACE(trial);
        Joints joints(grid, trial);
        std::vector<JoinedArc> arcs(2 * static_cast<size_t>(n)); // two in each piece
        for (size_t i = 0; i < arcs.size(); ++i) {
            const auto at = static_cast<int64_t>(i);
            joints.set(arcs[i].spots[1], arcs[(i + 1) % arcs.size()].spots[0], at / 2, (at + 1) / 2 % n);
        }
        const CrossSurface both{grid, borders};
        const CrossChains found = joined_chains(both, both, arcs, {});
        EXPECT_TRUE(std::ranges::all_of(found.nodes,
                                        [](const MeetNode &node) { return node.kind == NodeKind::seam; }));
        ASSERT_EQ(found.chains.size(), 1U);
        EXPECT_EQ(found.chains[0].loop, 0);
        EXPECT_EQ(found.chains[0].arcs.size(), arcs.size());
    }
}

} // namespace cross_chains_unit_test
