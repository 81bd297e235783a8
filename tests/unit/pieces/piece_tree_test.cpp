// SPDX-License-Identifier: MIT
// The tree of pieces, seen in frames near and far, beside pieces that are made in the frame from the control points.
#include "pieces/tree/framed_pieces.h"

#include "base/numbers.h"
#include "numeric/norm.h"
#include "support/cases.h"

#include <gtest/gtest.h>

namespace piece_tree_test {

using namespace nrb;
using support::Random;

namespace {

// With all weights negative, or with some of both signs, when homogeneous.
SplinePtr spline_of(Random &random, const support::SplineData &data, bool homogeneous) {
    Spline::Axes axes;
    for (size_t k = 0; k < data.degrees.size(); ++k) {
        axes.push_back(make_knot_vector(data.degrees[k], data.knots[k]));
    }
    if (!homogeneous) {
        return make_spline(axes, data.dim, data.rational() ? Form::rational : Form::polynomial, data.points,
                           data.weights);
    }
    std::vector<double> records;
    const double heaviest = random.chance(50) ? -1 : 1;
    for (int64_t i = 0; i < data.point_count(); ++i) {
        const double w = random.between(heaviest < 0 ? -2 : -0.01, heaviest < 0 ? -0.5 : 1);
        for (int c = 0; c < data.dim; ++c) {
            records.push_back(w * data.coordinate(i, c));
        }
        records.push_back(w);
    }
    return make_spline(axes, data.dim, Form::homogeneous, records, {});
}

SplinePtr random_spline(Random &random) {
    support::Recipe recipe = support::random_recipe(random, random.whole(1, 3), 4);
    recipe.dim = random.whole(2, 4);
    for (support::AxisRecipe &axis : recipe.axes) {
        axis.spans = recipe.axes.size() == 1 ? 40 : recipe.axes.size() == 2 ? 9 : 3;
    }
    return spline_of(random, support::random_spline(random, recipe), random.chance(30));
}

// About another place, in another unit.
pieces::Frame random_frame(Random &random, const Spline &spline) {
    pieces::Frame frame = pieces::frame_of(spline);
    const double far = random.chance(50) ? 0 : random.magnitude(1e-3, 1e6);
    for (double &x : frame.centre) {
        x += frame.unscaled(far * random.between(-1, 1));
    }
    frame.exponent += static_cast<int>(std::ceil(std::log2(1 + far))) + random.whole(-2, 2);
    return frame;
}

// Whether a box [2][dim] holds another one but for `slack`.
bool holds(const double *box, const pieces::BezierPiece &piece, double slack) {
    for (int c = 0; c < piece.dim(); ++c) {
        if (!(box[c] <= piece.lower()[c] + slack && box[piece.dim() + c] >= piece.upper()[c] - slack)) {
            return false;
        }
    }
    return true;
}

double largest_difference(const pieces::BezierPiece &a, const pieces::BezierPiece &b) {
    double most = 0;
    for (int64_t i = 0; i < a.coefficients(); ++i) {
        most = std::max(most, distance(a.point(i), b.point(i), a.dim()));
    }
    return most;
}

void check_pieces(const pieces::FramedPieces &framed, const std::vector<pieces::BezierPiece> &direct) {
    ASSERT_EQ(std::ssize(direct), framed.tree().grid().count());
    for (size_t i = 0; i < direct.size(); ++i) {
        const pieces::BezierPiece piece = framed.piece(static_cast<int64_t>(i));
        const pieces::LocalParam ends[] = {{0, 0, 0}, {1, 1, 1}};
        for (const pieces::LocalParam &end : ends) {
            EXPECT_EQ(piece.parameter(end), direct[i].parameter(end));
        }
        if (piece.positive() && direct[i].positive()) {
            ASSERT_LE(largest_difference(piece, direct[i]), piece.moved() + direct[i].moved()) << i;
        }
    }
}

std::vector<size_t> pieces_in(const pieces::PieceTree &tree, int level, int64_t node) {
    const pieces::PieceTree::Extent extent = tree.extent(level, node);
    std::vector<size_t> inside;
    for (int64_t i = 0; i < tree.grid().count(); ++i) {
        const pieces::PieceGrid::Index at = tree.grid().index(i);
        bool in = true;
        for (size_t k = 0; k < static_cast<size_t>(tree.grid().spline_axes()); ++k) {
            in = in && at[k] >= extent.lower[k] && at[k] < extent.upper[k];
        }
        if (in) {
            inside.push_back(static_cast<size_t>(i));
        }
    }
    return inside;
}

void check_family(const pieces::FramedPieces &framed, const std::vector<pieces::BezierPiece> &direct,
                  int level, int64_t node) {
    const pieces::PieceTree::Family family = framed.tree().family(level, node);
    std::vector<double> box(static_cast<size_t>(2 * framed.dim()));
    size_t inside = 0;
    for (int64_t i = 0; i < family.count; ++i) {
        framed.disc_box(level, node, i, box.data());
        const std::vector<size_t> all = pieces_in(framed.tree(), level + 1, family.first + i);
        inside += all.size();
        for (const size_t piece : all) {
            if (direct[piece].sound()) {
                ASSERT_TRUE(holds(box.data(), direct[piece], direct[piece].moved())) << level << " " << node;
            }
        }
    }
    const std::vector<size_t> all = pieces_in(framed.tree(), level, node);
    EXPECT_EQ(inside, all.size());
    framed.box(level, node, box.data());
    for (const size_t piece : all) {
        if (direct[piece].sound()) {
            ASSERT_TRUE(holds(box.data(), direct[piece], direct[piece].moved())) << level << " " << node;
        }
    }
}

void check_boxes(const pieces::FramedPieces &framed, const std::vector<pieces::BezierPiece> &direct) {
    int64_t nodes = 1;
    for (int level = 0; level + 1 < framed.tree().levels(); ++level) {
        int64_t next = 0;
        for (int64_t node = 0; node < nodes; ++node) {
            check_family(framed, direct, level, node);
            next += framed.tree().family(level, node).count;
        }
        nodes = next;
    }
    EXPECT_EQ(nodes, framed.tree().grid().count());
}

} // namespace

TEST(PieceTree, pieces_and_boxes_in_a_frame_are_those_made_there) {
    support::for_each_case(7100, 200, [](Random &random, uint64_t) {
        const SplinePtr spline = random_spline(random);
        const pieces::PieceTree &tree = pieces::piece_tree_of(*spline);
        const pieces::Frame frame = random_frame(random, *spline);
        const pieces::FramedPieces framed(tree, frame);
        const std::vector<pieces::BezierPiece> direct = pieces::bezier_pieces(*spline, frame);
        check_pieces(framed, direct);
        check_boxes(framed, direct);
    });
}

TEST(PieceGrid, pieces_that_contain_parameters) {
    const auto axis = make_knot_vector(2, {0, 0, 0, 1, 2, 2, 2});
    std::vector<double> points(16, 0.0);
    for (size_t i = 0; i < points.size(); ++i) {
        points[i] = static_cast<double>(i);
    }
    const SplinePtr spline = make_spline({axis, axis}, 1, Form::polynomial, points, {});
    const pieces::PieceGrid grid(*spline);
    EXPECT_EQ(grid.containing({0.5, 0.5, 0}), (std::vector<int64_t>{0}));
    EXPECT_EQ(grid.containing({1, 1.5, 0}), (std::vector<int64_t>{1, 3}));
    EXPECT_EQ(grid.containing({1, 1, 0}), (std::vector<int64_t>{0, 1, 2, 3}));
    EXPECT_EQ(grid.containing({0, 2, 0}), (std::vector<int64_t>{1}));
    EXPECT_TRUE(grid.containing({2.5, 1, 0}).empty());
}

} // namespace piece_tree_test
