// SPDX-License-Identifier: MIT
// Meets that are trimmed to faces.
#include "face/trimmed_meet.h"

#include "build/polylines.h"
#include "face_shapes.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace {

using namespace nrb;
using namespace face_shapes;
using face::Face;
using intersect::Meet;
using intersect::MeetNode;
using intersect::NodeKind;

// A closed branch through the given places.
Meet closed_branch(const std::vector<Point2> &places) {
    std::vector<double> points;
    for (size_t i = 0; i <= places.size(); ++i) {
        const Point2 &place = places[i % places.size()];
        points.insert(points.end(), {place[0], place[1], 0});
    }
    SplinePtr on = polygon(places);
    std::vector<double> params;
    for (int64_t i = 0; i < on->point_count(); ++i) {
        params.push_back(static_cast<double>(i));
    }
    Meet meet;
    meet.branches.push_back({0, build::polyline(3, points, params), std::move(on), 0, {-1, -1}, 0});
    return meet;
}

// What is kept of a closed branch that begins on the border ends there in a border, as it does elsewhere. One that
// begins inside is cut there, too.
TEST(TrimmedMeet, BranchesThatBeginOnTheBorderEndThere) {
    const Face half({plane(), {loop_of({polygon({{0, 0}, {0.5, 0}, {0.5, 1}, {0, 1}})})}, 1e-12}, nullptr);
    const Meet two = face::trimmed(half, closed_branch({{0.2, 0.3}, {0.2, 0.7}, {0.8, 0.7}, {0.8, 0.3}}));
    EXPECT_EQ(two.branches.size(), 2U);
    EXPECT_EQ(std::ranges::count(two.nodes, NodeKind::seam, &MeetNode::kind), 2);
    std::vector<Point2> places{{0.5, 0.3}, {0.2, 0.3}, {0.2, 0.7}, {0.8, 0.7}, {0.8, 0.3}};
    for (int turn = 0; turn < 2; ++turn) {
        const Meet one = face::trimmed(half, closed_branch(places));
        EXPECT_EQ(one.branches.size(), 1U);
        ASSERT_EQ(one.nodes.size(), 2U);
        for (const MeetNode &node : one.nodes) {
            EXPECT_EQ(node.kind, NodeKind::border);
            EXPECT_EQ(node.next, -1);
        }
        std::reverse(places.begin() + 1, places.end());
    }
}

} // namespace
