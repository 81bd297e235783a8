// SPDX-License-Identifier: MIT
#include "closest/pair/matched_bound.h"
#include "closest/pair/pair_bound.h"
#include "random_pieces.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace pair_bound_test {

using namespace nrb;
using random_pieces::random_piece;
using support::Random;

namespace {

// The best of descents from all combinations of three places on each axis.
closest::PairPlace best_place(const pieces::BezierPiece &a, const pieces::BezierPiece &b) {
    closest::PairDescent descent;
    closest::PairPlace best;
    best.distance = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 81; ++i) {
        closest::PairPlace at;
        at.a = {i % 3 / 2.0, i / 3 % 3 / 2.0, 0};
        at.b = {i / 9 % 3 / 2.0, i / 27 / 2.0, 0};
        descent.run(a, b, at);
        if (at.distance < best.distance) {
            best = at;
        }
    }
    return best;
}

} // namespace

// Never above the distance, and for pieces that are nearly flat close to it.
TEST(PairBound, is_below_the_distance_and_near_it) {
    Random random(771);
    closest::PairBound bound;
    for (int i = 0; i < 200; ++i) {
        const double size = i % 2 == 0 ? 1e-4 : 0.2;
        const SplinePtr f = random_piece(random, random.whole(1, 2), 0, size, random.chance(50));
        const SplinePtr g =
            random_piece(random, random.whole(1, 2), random.between(0.5, 1), size, random.chance(50));
        const pieces::Frame frame = pieces::frame_of({{f.get(), g.get()}});
        const pieces::BezierPiece a = pieces::bezier_pieces(*f, frame)[0],
                                  b = pieces::bezier_pieces(*g, frame)[0];
        const closest::PairPlace best = best_place(a, b);
        const double lower = bound.lower(a, b, best, std::numeric_limits<double>::infinity());
        EXPECT_LE(lower, best.distance);
        EXPECT_GE(lower, best.distance - 8 * size);
        EXPECT_LE(closest::box_distance(a.lower(), b.lower(), 3), best.distance);
    }
}

// Halves are parts of the whole, as far as rounding allows that they say.
TEST(BezierPiece, halves_have_the_points_of_the_whole) {
    Random random(772);
    closest::PieceJet whole_jet, half_jet;
    for (int i = 0; i < 50; ++i) {
        const SplinePtr f = random_piece(random, random.whole(1, 3), 0, 0.3, random.chance(50));
        const pieces::BezierPiece whole = pieces::bezier_pieces(*f, pieces::frame_of(*f))[0];
        pieces::BezierPiece upper = whole;
        for (int step = 0; step < 20; ++step) {
            std::optional<pieces::BezierPiece> lower = upper.halve();
            ASSERT_TRUE(lower.has_value());
            const pieces::BezierPiece &half = random.chance(50) ? *lower : upper;
            const pieces::LocalParam place{random.unit(), random.unit(), random.unit()};
            half_jet.evaluate(half, place, false);
            whole_jet.evaluate(whole, whole.place(half.parameter(place)), false);
            for (int c = 0; c < 3; ++c) {
                EXPECT_NEAR(half_jet.value()[c], whole_jet.value()[c], half.moved() + 1e-14);
                EXPECT_GE(half_jet.value()[c], half.lower()[c] - 1e-15);
                EXPECT_LE(half_jet.value()[c], half.upper()[c] + 1e-15);
            }
            upper = half;
        }
    }
}

// Central differences of values, and of first derivatives.
TEST(PieceJet, derivatives_are_limits_of_differences) {
    Random random(773);
    closest::PieceJet jet, more, less;
    for (int i = 0; i < 30; ++i) {
        const SplinePtr f = random_piece(random, random.whole(1, 3), 0, 0.4, random.chance(50));
        const pieces::BezierPiece piece = pieces::bezier_pieces(*f, pieces::frame_of(*f))[0];
        const pieces::LocalParam at{random.between(0.1, 0.9), random.between(0.1, 0.9),
                                    random.between(0.1, 0.9)};
        jet.evaluate(piece, at, true);
        constexpr double h = 1e-5;
        for (int k = 0; k < piece.axes(); ++k) {
            pieces::LocalParam high = at, low = at;
            high[static_cast<size_t>(k)] += h;
            low[static_cast<size_t>(k)] -= h;
            more.evaluate(piece, high, true);
            less.evaluate(piece, low, true);
            for (int c = 0; c < 3; ++c) {
                EXPECT_NEAR(jet.first(k)[c], (more.value()[c] - less.value()[c]) / (2 * h), 1e-8);
                for (int l = 0; l < piece.axes(); ++l) {
                    EXPECT_NEAR(jet.second(std::min(k, l), std::max(k, l))[c],
                                (more.first(l)[c] - less.first(l)[c]) / (2 * h), 1e-7);
                }
            }
        }
    }
}

// No point of one piece is farther from the other one.
TEST(MatchedBound, no_point_is_farther) {
    Random random(774);
    closest::MatchedBound bound;
    closest::PieceJet jet;
    closest::PairDescent descent;
    for (int i = 0; i < 60; ++i) {
        const SplinePtr f = random_piece(random, random.whole(1, 2), 0, 0.1, random.chance(50));
        const SplinePtr g = random_piece(random, random.whole(1, 2), 0, 0.1, random.chance(50));
        const pieces::Frame frame = pieces::frame_of({{f.get(), g.get()}});
        const pieces::BezierPiece a = pieces::bezier_pieces(*f, frame)[0],
                                  b = pieces::bezier_pieces(*g, frame)[0];
        const double upper = closest::MatchedBound::upper(a, b, bound.corners(a, b, {0.5, 0.5, 0.5}), 0);
        for (int k = 0; k < 20; ++k) {
            jet.evaluate(a, {random.unit(), random.unit(), 0}, false);
            const pieces::BezierPiece point(jet.value(), 3);
            closest::PairPlace at = best_place(point, b);
            EXPECT_LE(at.distance, upper);
        }
        EXPECT_LE(closest::MatchedBound::upper(a, a, bound.corners(a, a, {0.5, 0.5, 0.5}), 0), 1e-11);
    }
}

} // namespace pair_bound_test
