// Offsets of curves: within a proven distance of what they are by definition.
#include "fit/offset/offset_curve.h"

#include "base/error.h"
#include "eval/evaluate.h"
#include "fit/offset/offset_proof.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace offset_curve_test {

namespace {

using namespace nrb;

constexpr fit::OffsetRule usual{1e-6, 4096};

SplinePtr wave(std::mt19937_64 &random, bool rational, int dim) {
    std::uniform_real_distribution<double> unit_number(0, 1);
    std::vector<double> points, weights;
    for (int i = 0; i < 7; ++i) {
        points.push_back(i / 6.0);
        for (int c = 1; c < dim; ++c) {
            points.push_back(0.3 * unit_number(random));
        }
        weights.push_back(0.5 + unit_number(random));
    }
    return make_result({make_knot_vector(3, {0, 0, 0, 0, 0.25, 0.5, 0.75, 1, 1, 1, 1})}, dim,
                       rational ? Form::rational : Form::polynomial, std::move(points),
                       rational ? std::move(weights) : std::vector<double>());
}

Vector3 at(const Spline &curve, double t, int order) {
    std::vector<double> out(static_cast<size_t>((order + 1) * curve.dim()));
    eval::evaluate_points(curve, {}, order, {&t, 1, 1, 1, 1},
                          {out.data(), 1, std::ssize(out), std::ssize(out), 1});
    const double *x = out.data() + static_cast<ptrdiff_t>(order) * curve.dim();
    return {x[0], x[1], curve.dim() == 3 ? x[2] : 0};
}

Vector3 defined(const Spline &curve, const fit::CurveOffset &offset, double t) {
    return at(curve, t, 0) + offset.distance * unit(cross(offset.reference, at(curve, t, 1)));
}

double largest_miss(const Spline &curve, const fit::CurveOffset &offset, const Spline &found) {
    double worst = 0;
    for (int i = 0; i <= 1000; ++i) {
        const double t = i / 1000.0;
        worst = std::max(worst, length(at(found, t, 0) - defined(curve, offset, t)));
    }
    return worst;
}

Status status_of(const SplinePtr &curve, const fit::CurveOffset &offset, const fit::OffsetRule &rule,
                 std::string *text) {
    try {
        (void)fit::offset_curve(curve, offset, rule);
    } catch (const Error &error) {
        *text = error.what();
        return error.status();
    }
    return Status::ok;
}

TEST(OffsetCurve, is_within_what_is_proven) {
    std::mt19937_64 random(20261127);
    for (int i = 0; i < 12; ++i) {
        const int dim = i % 3 == 0 ? 2 : 3;
        const SplinePtr curve = wave(random, i % 2 == 1, dim);
        const fit::CurveOffset offset{i < 6 ? 0.05 : -0.2,
                                      dim == 2 ? Vector3{0, 0, 1} : unit(Vector3{0.3, -0.2, 1})};
        const fit::OffsetCurve made = fit::offset_curve(curve, offset, usual);
        const double miss = largest_miss(*curve, offset, *made.spline);
        EXPECT_LE(made.bound, usual.tolerance);
        EXPECT_LE(miss, made.bound);
        EXPECT_GE(miss, made.bound / 100);
        EXPECT_EQ(made.spline->dim(), dim);
        EXPECT_EQ(made.spline->axis(0).domain().upper, 1);
    }
}

// To the left of (t, t^2) in the plane: (t, t^2) + d (-2 t, 1) / sqrt(1 + 4 t^2).
TEST(OffsetCurve, of_a_parabola_is_to_its_left) {
    const SplinePtr parabola =
        make_result({make_knot_vector(2, {0, 0, 0, 1, 1, 1})}, 2, Form::polynomial, {0, 0, 0.5, 0, 1, 1});
    const fit::OffsetCurve made = fit::offset_curve(parabola, {0.25, {0, 0, 1}}, {1e-10, 4096});
    for (int i = 0; i <= 100; ++i) {
        const double t = i / 100.0, size = std::sqrt(1 + 4 * t * t);
        const Vector3 x = at(*made.spline, t, 0);
        EXPECT_NEAR(x.x, t - 0.25 * 2 * t / size, 1e-10);
        EXPECT_NEAR(x.y, t * t + 0.25 / size, 1e-10);
    }
    EXPECT_FALSE(made.turns_back);
}

// The radius of curvature of (t, t^2) at 0 is 1/2: farther away the offset has cusps, and runs back between them.
TEST(OffsetCurve, turns_back_beyond_the_centre_of_curvature) {
    const SplinePtr parabola =
        make_result({make_knot_vector(2, {-1, -1, -1, 1, 1, 1})}, 2, Form::polynomial, {-1, 1, 0, -1, 1, 1});
    for (const double distance : {0.4375, 0.5625, -0.5625}) {
        const fit::OffsetCurve made = fit::offset_curve(parabola, {distance, {0, 0, 1}}, usual);
        EXPECT_EQ(made.turns_back, distance > 0.5);
        EXPECT_LE(made.bound, usual.tolerance);
    }
}

// A candidate that is moved is no nearer than that, and on the other side of the curve nothing is near.
TEST(OffsetCurve, bounds_are_bounds_of_other_candidates) {
    std::mt19937_64 random(5);
    for (int i = 0; i < 6; ++i) {
        const SplinePtr curve = wave(random, i % 2 == 1, 3);
        const fit::CurveOffset offset{0.1, unit(Vector3{0, 0.5, 1})};
        const SplinePtr made = fit::offset_curve(curve, offset, usual).spline;
        std::vector<double> points(made->points().begin(), made->points().end()), breaks;
        for (size_t k = 0; k < points.size(); k += 3) {
            points[k + static_cast<size_t>(i) % 3] += i < 3 ? 1e-3 : -1e-3;
        }
        for (const KnotGroup &group : distinct_knots(made->axis(0).knots())) {
            if (!breaks.empty()) { // on shorter pieces bounds are sharper
                breaks.push_back(breaks.back() / 2 + group.knot / 2);
            }
            breaks.push_back(group.knot);
        }
        const SplinePtr other = make_result(made->knot_vectors(), 3, Form::polynomial, std::move(points));
        const std::vector<double> bounds = fit::offset_bounds(*curve, offset, *other, breaks);
        const double worst = *std::max_element(bounds.begin(), bounds.end());
        EXPECT_GE(worst, largest_miss(*curve, offset, *other));
        EXPECT_LE(worst, 2e-3);
        EXPECT_EQ(fit::offset_bounds(*curve, {-0.1, offset.reference}, *other, breaks).front(), INFINITY);
    }
}

// Along a line the bound is the distance itself, in whichever direction across it.
TEST(OffsetCurve, bounds_of_lines_are_sharp) {
    const SplinePtr line =
        make_result({make_knot_vector(1, {0, 0, 1, 1})}, 3, Form::polynomial, {0, 0, 0, 1, 0, 0});
    for (const Vector3 off :
         {Vector3{0, 1e-3, 0}, Vector3{0, -1e-3, 0}, Vector3{1e-3, 0, 0}, Vector3{0, 0, 1e-3}}) {
        const SplinePtr moved = make_result({make_knot_vector(1, {0, 0, 1, 1})}, 3, Form::polynomial,
                                            {off.x, 0.125 + off.y, off.z, 1 + off.x, 0.125 + off.y, off.z});
        const double bound = fit::offset_bounds(*line, {0.125, {0, 0, 1}}, *moved, {0, 1}).front();
        EXPECT_GE(bound, 1e-3 * (1 - 1e-12));
        EXPECT_LE(bound, 1e-3 * (1 + 1e-4));
    }
}

// The same curve, whatever its knots: clamped, unclamped, around and with a knot that splits it.
TEST(OffsetCurve, of_any_form_of_knots) {
    const fit::CurveOffset offset{0.1, {0, 0, 1}};
    const std::vector<double> even = {-3, -2, -1, 0, 1, 2, 3, 4, 5, 6, 7};
    std::vector<double> ring;
    for (int i = 0; i < 7; ++i) {
        ring.insert(ring.end(), {std::cos(i % 4 * std::acos(0)), std::sin(i % 4 * std::acos(0))});
    }
    const SplinePtr around = make_result({std::make_shared<const KnotVector>(3, even, true)}, 2,
                                         Form::polynomial, ring),
                    open = make_result({make_knot_vector(3, even)}, 2, Form::polynomial, ring),
                    split = make_result({make_knot_vector(1, {0, 0, 0.5, 0.5, 1, 1})}, 2, Form::polynomial,
                                        {0, 0, 1, 0, 1, 0, 2, 0});
    const fit::OffsetCurve a = fit::offset_curve(around, offset, usual),
                           b = fit::offset_curve(open, offset, usual),
                           c = fit::offset_curve(split, offset, usual);
    for (const double t : {0.0, 0.5, 1.75, 3.0, 3.999}) {
        EXPECT_LE(length(at(*a.spline, t, 0) - defined(*around, offset, t)), a.bound);
        EXPECT_LE(length(at(*b.spline, t, 0) - defined(*open, offset, t)), b.bound);
    }
    for (const double t : {0.0, 0.25, 0.5, 1.0}) {
        EXPECT_LE(length(at(*c.spline, t, 0) - Vector3{2 * t, 0.1, 0}), c.bound + 1e-15);
    }
}

TEST(OffsetCurve, says_why_there_is_none) {
    std::string text;
    const KnotVectorPtr straight = make_knot_vector(1, {0, 0, 0.5, 1, 1}),
                        bent = make_knot_vector(2, {0, 0, 0, 1, 1, 1});
    const SplinePtr corner = make_result({straight}, 2, Form::polynomial, {0, 0, 1, 0, 1, 1}),
                    stops = make_result({bent}, 2, Form::polynomial, {0, 0, 0, 0, 1, 1}),
                    along = make_result({bent}, 3, Form::polynomial, {0, 0, 0, 0, 0, 1, 0, 1, 2});
    const Vector3 z{0, 0, 1};
    EXPECT_EQ(status_of(corner, {0.5, z}, usual, &text), Status::unsupported);
    EXPECT_EQ(text, "the curve has a kink at a knot, where its offset has a gap of 0.7071067811865476");
    EXPECT_EQ(status_of(stops, {0.5, z}, usual, &text), Status::unsupported);
    EXPECT_EQ(text,
              "the curve has no tangent across the reference direction at 0, where its offset is not known");
    EXPECT_EQ(status_of(along, {0.5, z}, usual, &text), Status::unsupported);
    std::mt19937_64 random(3);
    EXPECT_EQ(status_of(wave(random, true, 3), {0.5, z}, {1e-9, 1}, &text), Status::not_converged);
    const SplinePtr steps =
                        make_result({make_knot_vector(0, {0, 0.5, 1})}, 2, Form::polynomial, {0, 0, 1, 0}),
                    weightless = make_result({bent}, 2, Form::rational, {0, 0, 1, 0, 1, 1}, {1, 0, 1});
    EXPECT_EQ(status_of(steps, {0.5, z}, usual, &text), Status::unsupported);
    EXPECT_EQ(status_of(weightless, {0.5, z}, usual, &text),
              Status::unsupported); // which has no tangent at its ends
    int64_t left = 10;
    EXPECT_EQ(status_of(wave(random, true, 3), {0.5, z}, {1e-9, 4096, &left}, &text), Status::not_converged);
    EXPECT_GE(left, 0);
}

// The nearest one that was met, with what is proven of it.
TEST(OffsetCurve, is_as_near_as_pieces_allow) {
    std::mt19937_64 random(3);
    const SplinePtr curve = wave(random, false, 3);
    const fit::CurveOffset offset{0.125, {0, 0, 1}};
    double before = 1;
    for (const int64_t most : {32, 128, 512}) {
        int64_t left = 10000;
        const fit::OffsetCurve made = fit::offset_curve(curve, offset, {1e-18, most, &left});
        EXPECT_LE(std::ssize(distinct_knots(made.spline->axis(0).knots())) - 1, most);
        EXPECT_GT(left, 10000 - 4 * most);
        EXPECT_LT(made.bound, before);
        for (int i = 0; i <= 500; ++i) {
            const double t =
                std::lerp(curve->axis(0).domain().lower, curve->axis(0).domain().upper, i / 500.0);
            EXPECT_LE(length(at(*made.spline, t, 0) - defined(*curve, offset, t)), made.bound);
        }
        before = made.bound;
    }
    EXPECT_LT(before, 1e-10);
}

TEST(OffsetCurve, by_next_to_nothing_is_the_curve) {
    std::mt19937_64 random(3);
    const SplinePtr curve = wave(random, true, 2);
    for (const double distance : {0.0, 1e-300, -1e-300, 1e-6}) {
        const fit::OffsetCurve made = fit::offset_curve(curve, {distance, {0, 0, 1}}, usual);
        EXPECT_EQ(made.spline, curve);
        EXPECT_EQ(made.bound, std::abs(distance));
        EXPECT_FALSE(made.turns_back);
    }
}

} // namespace

} // namespace offset_curve_test
