// Meets of parts that are placed in parts, against those of the parts themselves where they are placed.
#include "build/polylines.h"
#include "eval/curve_point.h"
#include "io/step/read_step.h"
#include "model/meets/model_meets.h"
#include "model/meets/region_borders.h"
#include "model/rays/instances.h"
#include "support/step_reading.h"
#include "support/step_solids.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <random>

namespace model_meets_unit_test {

namespace {

using namespace nrb;
using namespace nrb::model;

using Rows = std::array<double, 12>;

class Placements {
public:
    explicit Placements(unsigned seed) : engine_(seed) {}
    // Turned, mirrored where the scale is negative, sheared, and moved a little.
    Rows next() {
        Rows rows{};
        const double angle = between(-3, 3), scale = between(0.8, 1.25) * (between(-1, 1) < 0 ? -1 : 1);
        const std::array<std::array<double, 3>, 3> turn{
            {{std::cos(angle), -std::sin(angle), between(-0.4, 0.4)},
             {std::sin(angle), std::cos(angle), 0},
             {0.3, -0.1, 1}}};
        for (size_t i = 0; i < 3; ++i) {
            for (size_t k = 0; k < 3; ++k) {
                rows[4 * i + k] = scale * turn[i][k];
            }
            rows[4 * i + 3] = between(-0.5, 0.5);
        }
        return rows;
    }

private:
    double between(double lower, double upper) {
        return std::uniform_real_distribution<double>(lower, upper)(engine_);
    }
    std::mt19937 engine_;
};

Model read(bool is_cube) {
    return io::read_model(is_cube ? step_test::step_cube() : step_test::step_cylinder(false), {});
}

// The first part at places of the whole, some of them in a group that is placed itself.
Model placed(Model model, const std::vector<Rows> &alone, const Rows &group, const Rows &in_group) {
    model.parts.emplace_back();
    const int64_t last = std::ssize(model.parts) - 1;
    model.uses = {{-1, last, group, ""}, {last, 0, in_group, ""}};
    for (const Rows &rows : alone) {
        model.uses.push_back({-1, 0, rows, ""});
    }
    return model;
}
Model placed_once(Model model, const Rows &rows) {
    model.uses = {{-1, 0, rows, ""}};
    return model;
}

double length_of(const Spline &curve) {
    constexpr int n = 256;
    const Interval domain = curve.axis(0).domain();
    double sum = 0;
    std::vector<double> before = eval::end_point(curve, false);
    for (int i = 1; i <= n; ++i) {
        const std::vector<double> x = eval::curve_point(
            curve, i == n ? domain.upper : domain.lower + (domain.upper - domain.lower) * i / n, i == n);
        sum += std::hypot(x[0] - before[0], x[1] - before[1], x[2] - before[2]);
        before = x;
    }
    return sum;
}

using Lengths = std::map<std::array<int64_t, 2>, double>; // by faces

// Of the branches of an instance of the first model; their ways have to close.
Lengths lengths_of(const intersect::Meet &meet, int64_t instance) {
    Lengths lengths;
    for (const intersect::MeetWay &way : meet.ways) {
        for (int64_t i = way.first; i < way.first + way.count; ++i) {
            const intersect::MeetBranch &branch = meet.branches[static_cast<size_t>(i)];
            if (branch.instance == instance) {
                EXPECT_TRUE(way.closed);
                lengths[{branch.face, branch.second_face}] += length_of(*branch.space);
            }
        }
    }
    return lengths;
}

intersect::MeetBranch segment(intersect::BranchKind kind, double from, double to,
                              std::array<int64_t, 2> nodes) {
    intersect::MeetBranch branch{};
    branch.kind = kind;
    branch.space = build::polyline(3, {from, 0, 0, to, 0, 0}, {0, 1});
    branch.nodes = nodes;
    return branch;
}

} // namespace

// Of two branches that continue in each other at a seam the one along the border of a region is dropped.
TEST(ModelMeets, nothing_continues_in_what_only_repeats_the_border_of_a_region) {
    using intersect::BranchKind;
    using intersect::NodeKind;
    intersect::Meet meet;
    meet.branches = {segment(BranchKind::overlap, 0, 1, {-1, -1}),
                     segment(BranchKind::crossing, 0, 1, {0, 1}),
                     segment(BranchKind::crossing, 1, 2, {2, 3})};
    for (const auto &[kind, next] : {std::pair(NodeKind::border, -1),
                                     {NodeKind::seam, 2},
                                     {NodeKind::seam, 1},
                                     {NodeKind::border, -1}}) {
        intersect::MeetNode node{};
        node.kind = kind;
        node.next = next;
        node.gap = next < 0 ? 0 : 1e-9;
        meet.nodes.push_back(node);
    }
    std::vector<FacePair> of_branches{{0, 0}, {0, 1}, {0, 1}};
    drop_along_regions(1e-7, of_branches, meet);
    ASSERT_EQ(meet.branches.size(), 2U);
    EXPECT_EQ(of_branches.size(), 2U);
    EXPECT_EQ(meet.branches[1].nodes[0], 2);
    EXPECT_EQ(meet.nodes[2].next, -1);
    EXPECT_EQ(meet.nodes[2].gap, 0);
}

TEST(ModelMeets, of_placed_parts_are_those_of_the_parts_where_they_stand) {
    Placements placements(11);
    int64_t met = 0;
    for (int trial = 0; trial < 6; ++trial) {
        const Model other = placed_once(read(true), placements.next());
        const Rows outer = placements.next(), inner = placements.next(), alone = placements.next();
        const bool is_cube = trial % 2 == 0;
        const Model all = placed(read(is_cube), {alone}, outer, inner);
        const intersect::Meet found = model_intersections(all, other, 1e-7);
        EXPECT_TRUE(found.complete);
        const std::vector<Instance> instances = instances_of(all);
        for (size_t i = 0; i < instances.size(); ++i) {
            if (instances[i].part != 0) {
                continue;
            }
            const intersect::Meet expected =
                model_intersections(placed_once(read(is_cube), instances[i].placement), other, 1e-7);
            EXPECT_TRUE(expected.complete);
            const Lengths own = lengths_of(found, static_cast<int64_t>(i)), given = lengths_of(expected, 0);
            ASSERT_EQ(own.size(), given.size());
            for (const auto &[faces, length] : given) {
                ASSERT_TRUE(own.contains(faces));
                EXPECT_NEAR(own.at(faces), length, 1e-5 * (1 + length));
                ++met;
            }
        }
    }
    EXPECT_GE(met, 40);
}

} // namespace model_meets_unit_test
