// Offsets of surfaces: within a proven distance of what they are by definition.
#include "base/error.h"
#include "build/conics/arc.h"
#include "build/placement.h"
#include "build/surfaces/profile.h"
#include "build/surfaces/revolve.h"
#include "eval/evaluate.h"
#include "fit/offset/offset_jet.h"
#include "fit/offset/offset_proof.h"
#include "fit/offset/offset_surface.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace offset_surface_test {

namespace {

using namespace nrb;

constexpr fit::OffsetRule usual{1e-4, 4096};

SplinePtr patch(std::mt19937_64 &random, bool rational, double height) {
    std::uniform_real_distribution<double> unit(0, 1);
    const auto axis = [] { return make_knot_vector(3, {0, 0, 0, 0, 0.25, 0.75, 1, 1, 1, 1}); };
    std::vector<double> points, weights;
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 6; ++j) {
            points.insert(points.end(), {i / 5.0, j / 5.0, height * unit(random)});
            if (rational) {
                weights.push_back(0.5 + unit(random));
            }
        }
    }
    return make_result({axis(), axis()}, 3, rational ? Form::rational : Form::polynomial, std::move(points),
                       std::move(weights));
}

// Turned about the z axis by a quarter: an arc around (2, 0, 0), whose sides are equally far from the axis.
SplinePtr quarter_of_a_ring(double minor) {
    const double h = std::sqrt(0.5);
    const SplinePtr arc = make_result({make_knot_vector(2, {0, 0, 0, 1, 1, 1})}, 3, Form::rational,
                                      {2 + minor, 0, 0, 2 + minor, 0, minor, 2, 0, minor}, {1, h, 1});
    const double origin[] = {0, 0, 0}, axis[] = {0, 0, 1};
    return build::revolve(*arc, origin, axis, 1.5, build::arc_quarters);
}

Vector3 point_of(const Spline &spline, double u, double v) {
    const double x[2] = {u, v};
    double found[3];
    eval::evaluate_points(spline, {}, 0, {x, 1, 2, 2, 1}, {found, 1, 3, 3, 1});
    return {found[0], found[1], found[2]};
}

// The largest distance from the definition at places that are none of its corners.
double largest_miss(const Spline &surface, double distance, const Spline &found) {
    std::array<std::vector<double>, 2> params;
    for (const int k : {0, 1}) {
        const Interval domain = surface.axis(k).domain();
        for (int i = 0; i <= 60; ++i) {
            params[static_cast<size_t>(k)].push_back(std::lerp(domain.lower, domain.upper, (i + 0.37) / 61));
        }
    }
    const std::vector<fit::OffsetJet> wanted = fit::offset_jets(surface, distance, params, {false, false});
    double worst = 0;
    for (size_t i = 0; i < params[0].size(); ++i) {
        for (size_t j = 0; j < params[1].size(); ++j) {
            const Vector3 x = point_of(found, params[0][i], params[1][j]);
            worst = std::max(worst, length(x - wanted[i * params[1].size() + j].point));
        }
    }
    return worst;
}

Status status_of(const SplinePtr &surface, double distance, const fit::OffsetRule &rule, std::string *text) {
    try {
        fit::offset_surface(surface, distance, rule);
    } catch (const Error &error) {
        *text = error.what();
        return error.status();
    }
    return Status::ok;
}

TEST(OffsetSurface, is_within_what_is_proven) {
    std::mt19937_64 random(20261127);
    for (int i = 0; i < 4; ++i) {
        const SplinePtr surface = patch(random, i % 2 == 1, 0.1);
        const double distance = (i < 2 ? 0.05 : -0.2);
        const fit::OffsetSurface made = fit::offset_surface(surface, distance, usual);
        const double miss = largest_miss(*surface, distance, *made.spline);
        EXPECT_LE(made.bound, usual.tolerance);
        EXPECT_LE(miss, made.bound);
        EXPECT_GE(miss, made.bound / 100);
        for (const int k : {0, 1}) {
            EXPECT_EQ(made.spline->axis(k).domain().upper, surface->axis(k).domain().upper);
        }
    }
}

// Along the arcs the radii are what they were and the distance more, wherever their parameters are.
TEST(OffsetSurface, of_a_ring_is_a_ring) {
    for (const double distance : {0.25, -0.25}) {
        const SplinePtr ring = quarter_of_a_ring(0.5);
        const fit::OffsetSurface made = fit::offset_surface(ring, distance, usual);
        const Vector3 middle = point_of(*ring, 0.3, 0.6), moved = point_of(*made.spline, 0.3, 0.6);
        const bool outwards =
            length(moved - middle) > 0 && std::hypot(std::hypot(moved.x, moved.y) - 2, moved.z) > 0.5;
        const double minor = 0.5 + (outwards ? 0.25 : -0.25);
        const Interval u = ring->axis(0).domain(), v = ring->axis(1).domain();
        for (int i = 0; i <= 40; ++i) {
            for (int j = 0; j <= 40; ++j) {
                const Vector3 x = point_of(*made.spline, std::lerp(u.lower, u.upper, i / 40.0),
                                           std::lerp(v.lower, v.upper, j / 40.0));
                EXPECT_NEAR(std::hypot(std::hypot(x.x, x.y) - 2, x.z), minor, made.bound);
            }
        }
    }
}

// A candidate that is moved is no nearer than that.
TEST(OffsetSurface, bounds_are_bounds_of_other_candidates) {
    std::mt19937_64 random(5);
    for (int i = 0; i < 6; ++i) {
        const SplinePtr surface = patch(random, i % 2 == 1, 0.1);
        const SplinePtr made = fit::offset_surface(surface, 0.1, {1e-4, 4096}).spline;
        std::vector<double> points(made->points().begin(), made->points().end());
        for (size_t k = 0; k < points.size(); k += 3) {
            points[k + static_cast<size_t>(i) % 3] += i < 3 ? 1e-3 : -1e-3;
        }
        const SplinePtr other = make_result(made->knot_vectors(), 3, Form::polynomial, std::move(points));
        std::array<std::vector<double>, 2> breaks;
        for (const int k : {0, 1}) {
            for (const KnotGroup &group : distinct_knots(made->axis(k).knots())) {
                breaks[static_cast<size_t>(k)].push_back(group.knot);
            }
        }
        const std::vector<double> bounds = fit::offset_bounds(*surface, 0.1, *other, breaks);
        const double worst = *std::max_element(bounds.begin(), bounds.end());
        EXPECT_GE(worst, largest_miss(*surface, 0.1, *other));
        EXPECT_LE(worst, 1e-2);
        // On the other side of the surface nothing is near.
        EXPECT_EQ(fit::offset_bounds(*surface, -0.1, *other, breaks).front(), INFINITY);
    }
}

// Over a plane the bound is the distance itself, on whichever side.
TEST(OffsetSurface, bounds_of_planes_are_sharp) {
    std::mt19937_64 random(3);
    const SplinePtr plane = patch(random, false, 0);
    const std::array<std::vector<double>, 2> breaks{{{0, 0.25, 0.75, 1}, {0, 0.25, 0.75, 1}}};
    for (const double off : {1e-3, -1e-3}) {
        std::vector<double> points(plane->points().begin(), plane->points().end());
        for (size_t k = 2; k < points.size(); k += 3) {
            points[k] = 0.125 + off;
        }
        const SplinePtr moved = make_result(plane->knot_vectors(), 3, Form::polynomial, std::move(points));
        for (const double bound : fit::offset_bounds(*plane, 0.125, *moved, breaks)) {
            EXPECT_GE(bound, 1e-3 * (1 - 1e-12));
            EXPECT_LE(bound, 1e-3 * (1 + 1e-9));
        }
    }
}

// The plane (u, v, 0) with weights 1 + 3 u; a candidate that is off where they are small, and one where they are large.
TEST(OffsetSurface, bounds_hold_whatever_the_weights_are) {
    const KnotVectorPtr line = make_knot_vector(1, {0, 0, 1, 1}),
                        square = make_knot_vector(2, {0, 0, 0, 1, 1, 1});
    const SplinePtr plane =
        make_result({square, line}, 3, Form::rational,
                    {0, 0, 0, 0, 1, 0, 0.2, 0, 0, 0.2, 1, 0, 1, 0, 0, 1, 1, 0}, {1, 1, 2.5, 2.5, 4, 4});
    for (const double first : {1e-3, -1e-3, 0.0}) {
        for (const double last : {0.0, 1e-3, -1e-3}) {
            const double a = 0.125 + first, b = 0.125 + last;
            const SplinePtr candidate =
                make_result({line, line}, 3, Form::polynomial, {0, 0, a, 0, 1, a, 1, 0, b, 1, 1, b});
            const double bound = fit::offset_bounds(*plane, 0.125, *candidate, {{{0, 1}, {0, 1}}}).front();
            EXPECT_GE(bound, std::max(std::abs(first), std::abs(last)) * (1 - 1e-12));
            EXPECT_LE(bound, 0.02);
        }
    }
}

// Patches join with equal derivatives where the surface has second ones.
TEST(OffsetSurface, is_smooth_where_the_surface_is) {
    std::mt19937_64 random(7);
    const SplinePtr made = fit::offset_surface(patch(random, false, 0.2), 0.1, usual).spline;
    for (const int k : {0, 1}) {
        const std::span<const double> knots = made->axis(k).knots();
        for (const KnotGroup &group : distinct_knots(knots)) {
            const bool end = group.knot == knots.front() || group.knot == knots.back();
            EXPECT_EQ(group.multiplicity, end ? 4 : 2);
        }
    }
}

// Without the mixed derivative it would take many more.
TEST(OffsetSurface, takes_few_control_points) {
    std::mt19937_64 random(20261127);
    const SplinePtr made = fit::offset_surface(patch(random, false, 0.1), 0.05, {1e-5, 4096}).spline;
    EXPECT_LE(made->point_count(), 2500);
}

TEST(OffsetSurface, says_what_it_cannot_do) {
    std::string text;
    std::mt19937_64 random(9);
    EXPECT_EQ(status_of(patch(random, false, 0.3), 0.1, {1e-12, 256}, &text), Status::not_converged);
    EXPECT_NE(text.find("expected 1e-12"), std::string::npos) << text;
    int64_t left = 100;
    EXPECT_EQ(status_of(patch(random, false, 0.3), 0.1, {1e-6, 4096, &left}, &text), Status::not_converged);
    EXPECT_NE(text.find("no patches are left"), std::string::npos) << text;
    EXPECT_EQ(left, 0);
    // A roof, and a fan that ends in a point.
    const KnotVectorPtr line = make_knot_vector(1, {0, 0, 1, 1}), kink = make_knot_vector(1, {0, 0, 1, 2, 2});
    const SplinePtr roof = make_result({kink, line}, 3, Form::polynomial,
                                       {0, 0, 0, 0, 1, 0, 1, 0, 1, 1, 1, 1, 2, 0, 0, 2, 1, 0});
    EXPECT_EQ(status_of(roof, 0.1, usual, &text), Status::unsupported);
    EXPECT_NE(text.find("kink"), std::string::npos) << text;
    const SplinePtr fan =
        make_result({line, line}, 3, Form::polynomial, {0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 1, 0});
    EXPECT_EQ(status_of(fan, 0.1, usual, &text), Status::unsupported);
    EXPECT_NE(text.find("no normal at (0, 0)"), std::string::npos) << text;
}

} // namespace

} // namespace offset_surface_test
