// Boxes of the zeros of a function on a piece.
#include "intersect/levels/trace/level_boxes.h"

#include <gtest/gtest.h>

namespace level_boxes_unit_test {

using namespace nrb;
using namespace nrb::intersect;

namespace {

// f = 2 u - 1, seen by a border that has no root and calls its corners above: as from a neighbour whose rounding hides all.
LevelPieces zeros_with_contradicting_border() {
    LevelBorder border;
    border.above = {{{true, true}, {true, true}}};
    border.sides.fill(LevelSide::joined);
    LevelPieces found;
    BoxSearch(found, 1e-12).run(7, {{0, 0}, {1, 1}}, {{1, 1}, {0, 1e-15}, 0, {-1, -1, 1, 1}, {}}, border);
    return found;
}

} // namespace

TEST(LevelBoxes, end_where_signs_of_edges_contradict_each_other) {
    const LevelPieces found = zeros_with_contradicting_border();
    EXPECT_TRUE(found.arcs.empty());
    EXPECT_GE(found.clusters.size(), 1U);
    EXPECT_LE(found.clusters.size(), 128U);
    double covered = 0;
    for (const LevelCluster &cluster : found.clusters) {
        EXPECT_EQ(cluster.part.piece, 7);
        EXPECT_EQ(cluster.part.lower[0], 0);
        EXPECT_EQ(cluster.part.length[0], 0);
        covered += cluster.part.length[1];
    }
    EXPECT_EQ(covered, 1); // all of the side, in parts that halving has made
}

} // namespace level_boxes_unit_test
