// SPDX-License-Identifier: MIT
// The cells that distances descend: their leaves are the pieces, whatever the number of them, and boxes hold
// what is below.
#include "closest/pair/pair_cells.h"

#include "support/cases.h"

#include <gtest/gtest.h>

#include <set>

namespace pair_cells_test {

using namespace nrb;
using closest::PairCell;
using closest::PairCells;
using support::Random;

namespace {

struct Leaves {
    std::set<int64_t> nodes;
    int64_t count = 0;
};

bool holds(const PairCell &outer, const PairCell &inner, double slack) {
    constexpr size_t dim = 3;
    for (size_t c = 0; c < dim; ++c) {
        if (!(outer.box[c] <= inner.box[c] + slack && outer.box[dim + c] >= inner.box[dim + c] - slack)) {
            return false;
        }
    }
    return true;
}

// Splits all cells that are no pieces. Boxes are rounded to single precision in units of the frame.
void visit(PairCells &cells, PairCell &cell, Leaves &leaves) {
    cells.tighten(cell);
    if (cell.piece) {
        leaves.nodes.insert(cell.node);
        ++leaves.count;
        return;
    }
    ASSERT_TRUE(cells.split(cell));
    EXPECT_GT(cell.children.size(), 1U) << "a node with one child";
    for (PairCell &child : cell.children) {
        cells.tighten(child);
        const bool whole_space = child.piece && !child.piece->positive();
        EXPECT_TRUE(whole_space || holds(cell, child, 1e-6))
            << "level " << cell.level << ", node " << cell.node;
        visit(cells, child, leaves);
    }
}

SplinePtr spline_of_spans(Random &random, std::vector<int> spans) {
    support::Recipe recipe = support::random_recipe(random, static_cast<int>(spans.size()), 3);
    recipe.dim = 3;
    for (size_t k = 0; k < spans.size(); ++k) {
        recipe.axes[k].spans = spans[k];
    }
    const support::SplineData data = support::random_spline(random, recipe);
    Spline::Axes axes;
    for (size_t k = 0; k < data.degrees.size(); ++k) {
        axes.push_back(make_knot_vector(data.degrees[k], data.knots[k]));
    }
    return make_spline(axes, data.dim, data.rational() ? Form::rational : Form::polynomial, data.points,
                       data.weights);
}

} // namespace

// Numbers of pieces about the powers of 4 and of 16 by which nodes are made.
TEST(PairCells, leaves_are_the_pieces_once_each) {
    Random random(1);
    for (const std::vector<int> &spans : std::vector<std::vector<int>>{{1},
                                                                       {2},
                                                                       {16},
                                                                       {17},
                                                                       {49},
                                                                       {64},
                                                                       {65},
                                                                       {257},
                                                                       {1, 1},
                                                                       {1, 17},
                                                                       {7, 7},
                                                                       {17, 3},
                                                                       {1, 1, 1},
                                                                       {5, 1, 4}}) {
        for (int repeat = 0; repeat < 5; ++repeat) {
            const SplinePtr spline = spline_of_spans(random, spans);
            PairCells cells(*spline, pieces::frame_of(*spline));
            Leaves leaves;
            visit(cells, cells.root(), leaves);
            const int64_t pieces = pieces::piece_tree_of(*spline).grid().count();
            EXPECT_EQ(leaves.count, pieces);
            EXPECT_EQ(std::ssize(leaves.nodes), pieces);
        }
    }
}

TEST(PairCells, halves_of_a_piece_lie_in_it) {
    Random random(2);
    for (int repeat = 0; repeat < 50; ++repeat) {
        const SplinePtr spline =
            spline_of_spans(random, std::vector<int>(static_cast<size_t>(1 + repeat % 3), 1));
        PairCells cells(*spline, pieces::frame_of(*spline));
        PairCell *cell = &cells.root();
        for (int depth = 0; depth < 20; ++depth) {
            if (!cells.split(*cell)) {
                break; // a point, or a piece whose parameters cannot be told apart any more
            }
            if (cell->piece && cell->piece->positive()) {
                ASSERT_EQ(cell->children.size(), 2U);
                EXPECT_TRUE(holds(*cell, cell->children[0], 1e-14));
                EXPECT_TRUE(holds(*cell, cell->children[1], 1e-14));
            }
            cell = &cell->children[static_cast<size_t>(random.whole(0, 1)) % cell->children.size()];
        }
    }
}

} // namespace pair_cells_test
