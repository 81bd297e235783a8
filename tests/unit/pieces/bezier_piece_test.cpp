// SPDX-License-Identifier: MIT
// Pieces against exact arithmetic: long doubles are exact enough beside what doubles lose.
#include "pieces/bezier_piece.h"

#include "support/generators.h"

#include <gtest/gtest.h>

namespace bezier_piece_test {

using namespace nrb;
using support::Random;

namespace {

SplinePtr random_curve(Random &random, int degree, double offset, bool signs) {
    std::vector<double> knots(static_cast<size_t>(degree) + 1, 0.0), points, weights;
    knots.insert(knots.end(), static_cast<size_t>(degree) + 1, 1.0);
    for (int i = 0; i <= degree; ++i) {
        const double w = random.between(0.5, 2) * (signs ? -1 : 1);
        for (int c = 0; c < 3; ++c) {
            const double x = offset + random.between(-1, 1);
            points.push_back(signs ? w * x : x);
        }
        (signs ? points : weights).push_back(w);
    }
    return make_spline({make_knot_vector(degree, std::move(knots))}, 3,
                       signs ? Form::homogeneous : Form::rational, std::move(points), std::move(weights));
}

// Coordinate c at t, less that of the centre.
long double exact_coordinate(const Spline &curve, double t, int c, double centre) {
    const int degree = curve.axis(0).degree();
    std::vector<long double> x, w;
    for (int i = 0; i <= degree; ++i) {
        const long double weight = curve.weight(i);
        const bool homogeneous = curve.form() == Form::homogeneous;
        const long double value = curve.points()[static_cast<size_t>(i * curve.stored_width() + c)];
        w.push_back(weight);
        x.push_back((homogeneous ? value : weight * value) - weight * static_cast<long double>(centre));
    }
    for (int n = degree; n > 0; --n) {
        for (size_t i = 0; i < static_cast<size_t>(n); ++i) {
            x[i] += static_cast<long double>(t) * (x[i + 1] - x[i]);
            w[i] += static_cast<long double>(t) * (w[i + 1] - w[i]);
        }
    }
    return x[0] / w[0];
}

void expect_end(const Spline &curve, const pieces::Frame &frame, const pieces::BezierPiece &piece,
                bool last) {
    const double t = piece.parameter({last ? 1.0 : 0.0, 0, 0})[0];
    const double *point = piece.point(last ? piece.degree(0) : 0);
    for (int c = 0; c < 3; ++c) {
        const double centre = frame.centre[static_cast<size_t>(c)];
        const long double exact = std::ldexp(exact_coordinate(curve, t, c, centre), -frame.exponent);
        EXPECT_NEAR(static_cast<double>(point[c] - exact), 0, piece.moved());
        EXPECT_LE(std::abs(point[c]), piece.reach());
    }
}

} // namespace

TEST(Frame, is_in_the_middle_of_both_and_about_one_in_size) {
    Random random(41);
    const SplinePtr a = random_curve(random, 3, 1e6, false), b = random_curve(random, 2, -1e6, false);
    const pieces::Frame frame = pieces::frame_of({{a.get(), b.get()}});
    for (size_t c = 0; c < 3; ++c) {
        EXPECT_LE(std::abs(frame.centre[c]), 1);
        EXPECT_LE(std::abs(frame.coordinate(c, 1e6)), 1);
        EXPECT_GT(frame.coordinate(c, 1e6), 0.25);
        EXPECT_EQ(frame.original(c, frame.coordinate(c, frame.centre[c] + 64)), frame.centre[c] + 64);
    }
}

TEST(Frame, has_a_unit_for_the_smallest_models) {
    const SplinePtr line = make_spline({make_knot_vector(1, {0, 0, 1, 1})}, 1, Form::polynomial,
                                       {0, std::numeric_limits<double>::denorm_min()});
    EXPECT_GT(pieces::frame_of(*line).scaled(std::numeric_limits<double>::denorm_min()), 0.25);
}

// Halved towards a place, a piece keeps ends that are within moved() of the exact points.
TEST(BezierPiece, ends_of_halves_are_within_what_rounding_may_have_moved) {
    Random random(42);
    for (int i = 0; i < 200; ++i) {
        const SplinePtr curve =
            random_curve(random, random.whole(1, 9), random.chance(50) ? 0 : 1e3, random.chance(50));
        const pieces::Frame frame = pieces::frame_of(*curve);
        pieces::BezierPiece piece = pieces::bezier_pieces(*curve, frame)[0];
        for (int step = 0; step < 30; ++step) {
            ASSERT_TRUE(piece.positive());
            expect_end(*curve, frame, piece, false);
            expect_end(*curve, frame, piece, true);
            std::optional<pieces::BezierPiece> lower = piece.halve();
            ASSERT_TRUE(lower);
            piece = random.chance(50) ? *lower : piece;
        }
        EXPECT_LE(piece.moved(), 1e-10);
    }
}

// A control point of weight 0 has no place; the piece is sound without it, but not positive.
TEST(BezierPiece, is_sound_where_a_whole_coefficient_is_nothing) {
    const SplinePtr curve = make_spline({make_knot_vector(2, {0, 0, 0, 1, 1, 1})}, 2, Form::rational,
                                        {0, 0, 5, 5, 2, 2}, {1, 0, 1});
    pieces::BezierPiece piece = pieces::bezier_pieces(*curve, pieces::frame_of(*curve))[0];
    EXPECT_TRUE(piece.sound());
    EXPECT_FALSE(piece.positive());
    EXPECT_FALSE(piece.has_point(1));
    EXPECT_TRUE(piece.has_point(0));
}

} // namespace bezier_piece_test
