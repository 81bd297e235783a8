// Clusters of two surfaces made into groups: whatever is in one of them is in a group.
#include "intersect/levels/trace/cluster_groups.h"
#include "intersect/surfaces/cross_clusters.h"
#include "unit/face/face_shapes.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace cross_groups_unit_test {

using namespace nrb;
using namespace nrb::intersect;

namespace {

using Ranges = std::array<Interval, 4>;

// Leaves groups as they are.
class Nowhere final : public TouchTest {
public:
    [[nodiscard]] bool is_touch(const Ranges & /*ranges*/) const override { return false; }
    void narrow(Ranges & /*ranges*/) const override {}
};

SplinePtr ring() {
    return build::torus(build::make_placement(3, nullptr, nullptr, nullptr, "centre"), 3, 1,
                        build::full_turn(), build::full_turn(), 0);
}

class Surface {
public:
    explicit Surface(SplinePtr spline) : spline_(std::move(spline)) {}
    [[nodiscard]] CrossSurface of() const { return {grid_, borders_}; }
    [[nodiscard]] const pieces::PieceGrid &grid() const { return grid_; }

private:
    SplinePtr spline_;
    const pieces::PieceGrid &grid_ = pieces::piece_grid_of(*spline_);
    SurfaceBorders borders_{grid_};
};

// From a few places where parts hang together, to parts that go all round.
std::vector<CrossCluster> random_clusters(std::mt19937 &engine, const pieces::PieceGrid &grid) {
    std::uniform_real_distribution<double> unit(0, 1);
    const int count = 1 + static_cast<int>(12 * unit(engine));
    const double most = unit(engine) < 0.5 ? 0.05 : 0.6;
    std::vector<CrossCluster> clusters;
    for (int n = 0; n < count; ++n) {
        CrossCluster cluster;
        for (size_t i = 0; i < 4; ++i) {
            const Interval domain = domain_along(grid, i % 2);
            const double length = domain.upper - domain.lower, lower = domain.lower + length * unit(engine);
            cluster.ranges[i] = {lower, std::min(domain.upper, lower + most * length * unit(engine))};
        }
        clusters.push_back(cluster);
    }
    return clusters;
}

bool holds(const Ranges &group, const Ranges &part, const pieces::PieceGrid &grid) {
    for (size_t i = 0; i < 4; ++i) {
        const Interval domain = domain_along(grid, i % 2);
        const double period = domain.upper - domain.lower, room = 1e-12 * period;
        bool any = false;
        for (const double by : {0.0, period, -period}) {
            any = any || (part[i].lower + by >= group[i].lower - room &&
                          part[i].upper + by <= group[i].upper + room);
        }
        if (!any) {
            return false;
        }
    }
    return true;
}

} // namespace

TEST(CrossGroups, hold_all_clusters) {
    std::mt19937 engine(11);
    const Surface surface(ring());
    for (int trial = 0; trial < 1000; ++trial) {
        SCOPED_TRACE(trial);
        const std::vector<CrossCluster> clusters = random_clusters(engine, surface.grid());
        const std::vector<CrossGroup> groups = cross_groups(surface.of(), surface.of(), Nowhere(), clusters);
        for (const CrossCluster &cluster : clusters) {
            ASSERT_TRUE(std::ranges::any_of(groups, [&](const CrossGroup &group) {
                return holds(group.ranges, cluster.ranges, surface.grid());
            }));
        }
    }
}

} // namespace cross_groups_unit_test
