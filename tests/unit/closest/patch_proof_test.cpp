// SPDX-License-Identifier: MIT
// The squares of patches against exact arithmetic on every instruction set, discs against points in them, and
// proofs against dense samples: what is proved holds.
#include "base/numbers.h"
#include "closest/patch/patch_search.h"

#include "eval/kernels/contraction.h"
#include "numeric/norm.h"
#include "reference/number.h"
#include "support/generators.h"
#include "unit/targets.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace patch_proof_test {

using namespace nrb;
using support::Random;

namespace {

// A Bezier patch with the coordinates, weights and degrees of a random one.
SplinePtr random_patch(Random &random, int axes, int degree, bool weighted) {
    Spline::Axes knots;
    int64_t count = 1;
    for (int k = 0; k < axes; ++k) {
        const int p = random.whole(1, degree);
        std::vector<double> values(static_cast<size_t>(p) + 1, 0.0);
        values.insert(values.end(), static_cast<size_t>(p) + 1, 1.0);
        knots.push_back(std::make_shared<const KnotVector>(p, values));
        count *= p + 1;
    }
    std::vector<double> points, weights;
    for (int64_t i = 0; i < count; ++i) {
        for (int c = 0; c < 3; ++c) {
            points.push_back(random.between(-1, 1));
        }
        if (weighted) {
            weights.push_back(random.between(0.5, 2));
        }
    }
    return make_spline(knots, 3, weighted ? Form::rational : Form::polynomial, points, weights);
}

class PatchKernel : public targets::Targets {};

// c_i = sum over j + k = i of binomial(n, j) binomial(n, k) a_j a_k / binomial(2 n, i), axis by axis.
TEST_P(PatchKernel, squares_are_those_of_exact_arithmetic) {
    Random random(51);
    for (int round = 0; round < 30; ++round) {
        const SplinePtr spline = random_patch(random, 2, 5, true);
        const pieces::PieceGrid pieces(*spline);
        const pieces::PatchShape &shape = pieces.shape();
        std::vector<double> work(static_cast<size_t>(pieces::product_work(shape)));
        std::vector<double> squares(static_cast<size_t>(shape.products())), weights(squares);
        std::vector<double> patch(static_cast<size_t>(shape.values())), other(patch);
        pieces.patch(0, other.data(), patch.data());
        pieces::square_patch(shape, pieces.tables(), patch.data(), work.data(), squares.data(),
                             weights.data());
        const int m = shape.degree(0), n = shape.degree(1);
        const auto at = [&](int i, int j, int c) {
            return reference::exact(patch.data()[(i * (n + 1) + j) * shape.lanes + c]);
        };
        const auto binomial = [](int a, int b) {
            reference::Rational result = 1;
            for (int i = 0; i < b; ++i) {
                result = result * (a - i) / (i + 1);
            }
            return result;
        };
        for (int i = 0; i <= 2 * m; ++i) {
            for (int j = 0; j <= 2 * n; ++j) {
                reference::Rational square = 0, weight = 0, size = 0;
                for (int a = std::max(0, i - m); a <= std::min(m, i); ++a) {
                    for (int b = std::max(0, j - n); b <= std::min(n, j); ++b) {
                        const reference::Rational factor =
                            binomial(m, a) * binomial(m, i - a) * binomial(n, b) * binomial(n, j - b);
                        for (int c = 0; c < 3; ++c) {
                            const reference::Rational term = factor * at(a, b, c) * at(i - a, j - b, c);
                            square += term;
                            size += abs(term);
                        }
                        weight += factor * at(a, b, 3) * at(i - a, j - b, 3);
                    }
                }
                const reference::Rational whole = binomial(2 * m, i) * binomial(2 * n, j);
                const auto place = static_cast<size_t>(i * (2 * n + 1) + j);
                const reference::Rational allowed = reference::exact(pieces.product_error());
                ASSERT_LE(abs(reference::Rational(square / whole - reference::exact(squares[place]))),
                          allowed * size / whole);
                ASSERT_LE(abs(reference::Rational(weight / whole - reference::exact(weights[place]))),
                          allowed * weight / whole);
            }
        }
    }
}

// The points of a piece lie between the bounds of its disc, seen from anywhere.
TEST_P(PatchKernel, discs_hold_their_patches) {
    Random random(52);
    for (int round = 0; round < 60; ++round) {
        const SplinePtr spline = random_patch(random, random.whole(2, 3), 4, random.chance(50));
        const pieces::PieceTree &all = pieces::piece_tree_of(*spline);
        const pieces::PieceGrid &pieces = all.grid();
        const closest::PatchTree tree(all);
        std::vector<double> x(static_cast<size_t>(pieces.shape().lanes), 0.0);
        for (size_t c = 0; c < 3; ++c) {
            x[c] = random.between(-3, 3);
        }
        closest::PatchMemory memory;
        const closest::PatchDescent descent(pieces.shape(), memory);
        const closest::PatchItems items(pieces, x.data(), memory);
        const closest::PatchItem whole = items.whole(0);
        const closest::PatchTree::Family leaves = tree.family(tree.levels() - 2, 0);
        double nearest[closest::PatchTree::most_width], farthest[closest::PatchTree::most_width],
            centres[closest::PatchTree::most_width];
        tree.bound(tree.levels() - 2, 0, items.x(), false, {nearest, centres});
        tree.bound(tree.levels() - 2, 0, items.x(), true, {farthest, centres});
        for (int64_t i = 0; i < leaves.count; ++i) {
            const closest::PatchTree::Leaf leaf = tree.leaf(leaves.first + i);
            for (int sample = 0; sample < 10; ++sample) {
                closest::AxisValues at{};
                for (size_t k = 0; k < at.size(); ++k) {
                    at[k] = (leaf.part[k] + random.between(0, 1)) / tree.parts();
                }
                const double d = descent.distance(whole.values, at);
                ASSERT_LE(nearest[i], d);
                ASSERT_GE(-farthest[i], d);
            }
        }
    }
}

// Where weights of both signs nearly cancel, records count by a weight that is far smaller than theirs: the corner of
// such a piece, of exact numbers, is no nearer than the disc.
TEST_P(PatchKernel, discs_hold_corners_of_small_weight) {
    Random random(56);
    const auto across = std::make_shared<const KnotVector>(2, std::vector<double>{0, 0, 0, 1, 3, 3, 3}),
               along = std::make_shared<const KnotVector>(1, std::vector<double>{0, 0, 1, 1});
    for (int round = 0; round < 300; ++round) {
        const double sum = random.magnitude(1e-8, 1e-5);
        const double weights[] = {1, 1, sum - 2, 1};
        std::vector<double> records;
        for (int i = 0; i < 8; ++i) {
            for (int c = 0; c < 3; ++c) {
                records.push_back(random.between(-1, 1));
            }
            records.push_back(weights[i / 2]);
        }
        const SplinePtr spline = make_spline({across, along}, 3, Form::homogeneous, records, {});
        // At u = 1, v = 0: (2 R_1 + R_2) / 3 of the layers.
        std::array<double, 3> corner{};
        for (size_t c = 0; c < 3; ++c) {
            const auto exact = [&](size_t i) { return 2.0L * records[8 + i] + records[16 + i]; };
            corner[c] = static_cast<double>(exact(c) / exact(3));
        }
        const pieces::PieceTree &all = pieces::piece_tree_of(*spline);
        const pieces::PieceGrid &pieces = all.grid();
        const closest::PatchTree tree(all);
        closest::PatchMemory memory;
        const closest::PatchItems items(pieces, corner.data(), memory);
        double bounds[closest::PatchTree::most_width], centres[closest::PatchTree::most_width];
        const double rounding = 4 * eps * norm(items.x(), 3);
        for (int level = 0; level + 1 < tree.levels(); ++level) {
            tree.bound(level, 0, items.x(), false, {bounds, centres});
            const auto count = tree.family(level, 0).count;
            EXPECT_LE(*std::min_element(bounds, bounds + count), rounding) << round << ", level " << level;
        }
    }
}

// A spline whose weights are all negative is the one of the opposite records, and rounding is allowed for
// likewise.
TEST_P(PatchKernel, bounds_of_negative_weights_hold_for_the_opposite_ones) {
    Random random(57);
    const auto axis = std::make_shared<const KnotVector>(2, std::vector<double>{0, 0, 0, 1, 3, 3, 3});
    for (int round = 0; round < 100; ++round) {
        std::vector<double> records, opposite;
        double least = infinity, most = 0;
        for (int i = 0; i < 16; ++i) {
            const double w = random.magnitude(0.1, 10);
            least = std::min(least, w);
            most = std::max(most, w);
            for (int c = 0; c < 3; ++c) {
                records.push_back(w * random.between(-1, 1));
            }
            records.push_back(w);
        }
        std::ranges::transform(records, std::back_inserter(opposite), std::negate<>());
        const pieces::PieceGrid positive(*make_spline({axis, axis}, 3, Form::homogeneous, records, {})),
            negative(*make_spline({axis, axis}, 3, Form::homogeneous, opposite, {}));
        const double x[] = {random.between(-2, 2), random.between(-2, 2), random.between(-2, 2)};
        EXPECT_EQ(negative.weight_ratio(), most / least);
        EXPECT_GE(negative.unscaled(negative.radius()), positive.unscaled(positive.radius()) / 2);
        EXPECT_GE(closest::PatchQuery::noise(negative, x),
                  closest::PatchQuery::noise(positive, x) * (1 - 0x1p-40));
    }
}

// Halves and parts are the patch that they are a part of.
TEST_P(PatchKernel, parts_are_parts) {
    Random random(53);
    for (int round = 0; round < 60; ++round) {
        const SplinePtr spline = random_patch(random, random.whole(2, 3), 4, random.chance(50));
        const pieces::PieceGrid pieces(*spline);
        const std::vector<double> x(static_cast<size_t>(pieces.shape().lanes), 0.0);
        closest::PatchMemory memory;
        const closest::PatchDescent descent(pieces.shape(), memory);
        const closest::PatchItems items(pieces, x.data(), memory);
        const closest::PatchItem whole = items.whole(0);
        closest::PatchItem part = whole;
        items.measure(part);
        for (int k = 0; k < pieces.shape().axes; ++k) {
            const double lower = random.between(0, 0.6);
            part = items.part(part, k, lower, lower + random.between(0.1, 0.4));
            const closest::PatchItem half = items.halve_item(part, k);
            part = random.chance(50) ? half : part;
        }
        for (int sample = 0; sample < 10; ++sample) {
            closest::AxisValues at{}, place{};
            for (int k = 0; k < pieces.shape().axes; ++k) {
                const auto i = static_cast<size_t>(k);
                at[i] = random.between(0, 1);
                place[i] = part.to_piece(k, at[i]);
            }
            ASSERT_NEAR(descent.distance(part.values, at), descent.distance(whole.values, place), 200 * eps);
        }
    }
}

// With a goal at random: what is proved is true of all samples.
TEST_P(PatchKernel, what_is_proved_holds) {
    Random random(54);
    int proved = 0, by_shape = 0;
    for (int round = 0; round < 3000; ++round) {
        const SplinePtr spline = random_patch(random, random.whole(2, 3), 3, random.chance(50));
        const pieces::PieceGrid pieces(*spline);
        const pieces::PatchShape &shape = pieces.shape();
        std::vector<double> x(static_cast<size_t>(shape.lanes), 0.0);
        const double reach = random.magnitude(0.3, 30);
        for (size_t c = 0; c < 3; ++c) {
            x[c] = reach * random.between(-1, 1);
        }
        closest::PatchMemory memory;
        const closest::PatchDescent descent(shape, memory);
        const closest::PatchItems items(pieces, x.data(), memory);
        closest::PatchItem item = items.whole(0);
        items.measure(item);
        std::vector<double> samples;
        for (int sample = 0; sample < 200; ++sample) {
            closest::AxisValues at{random.between(0, 1), random.between(0, 1), random.between(0, 1)};
            if (sample < 8) {
                at = {static_cast<double>(sample & 1), static_cast<double>(sample >> 1 & 1),
                      static_cast<double>(sample >> 2)};
            }
            samples.push_back(descent.distance(item.values, at));
        }
        const auto [least, most] = std::minmax_element(samples.begin(), samples.end());
        closest::PatchGoal goal;
        goal.sign = random.chance(50) ? 1 : -1;
        goal.rho = goal.sign > 0 ? *least * random.between(0.8, 1.01) : *most * random.between(0.99, 1.2);
        std::vector<double> work(static_cast<size_t>(pieces::product_work(shape)));
        std::vector<double> squares(static_cast<size_t>(shape.products())), weights(squares), values(squares);
        pieces::square_patch(shape, pieces.tables(), item.values, work.data(), squares.data(),
                             weights.data());
        const closest::PatchGap gap{squares.data(), shape.weighted ? weights.data() : nullptr, values.data()};
        closest::PatchProof proof(pieces, descent, item, goal, gap);
        const bool positive = proof.positive(), convex = proof.convex(nullptr);
        if (positive || convex) {
            ++proved;
            ASSERT_TRUE(goal.sign > 0 ? *least >= goal.rho - 8 * eps * reach
                                      : *most <= goal.rho + 8 * eps * reach)
                << round;
        }
        if (convex) {
            ++by_shape;
            ASSERT_TRUE(proof.found());
        }
    }
    EXPECT_GT(proved, 1000);
    EXPECT_GT(by_shape, 50);
}

INSTANTIATE_TEST_SUITE_P(All, PatchKernel, targets::every_target(), targets::target_name);

} // namespace

} // namespace patch_proof_test
