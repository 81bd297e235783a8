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
#include <numbers>
#include <numeric>
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
    const std::vector<fit::TaylorVector> wanted = fit::offset_jets(surface, distance, params, {false, false});
    double worst = 0;
    for (size_t i = 0; i < params[0].size(); ++i) {
        for (size_t j = 0; j < params[1].size(); ++j) {
            const Vector3 x = point_of(found, params[0][i], params[1][j]);
            worst = std::max(worst, length(x - wanted[i * params[1].size() + j].at(0, 0)));
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

int multiplicity_of(const Spline &spline, int axis, double knot) {
    return multiplicity(spline.axis(axis).knots(), knot);
}

// Patches join with two equal derivatives where the surface has three, and with one where it has two.
TEST(OffsetSurface, is_smooth_where_the_surface_is) {
    std::mt19937_64 random(7);
    const SplinePtr made = fit::offset_surface(patch(random, false, 0.2), 0.1, usual).spline;
    for (const int k : {0, 1}) {
        const std::span<const double> knots = made->axis(k).knots();
        for (const KnotGroup &group : distinct_knots(knots)) {
            const bool end = group.knot == knots.front() || group.knot == knots.back(),
                       own = group.knot == 0.25 || group.knot == 0.75;
            EXPECT_EQ(group.multiplicity, end ? 6 : own ? 4 : 3);
        }
    }
}

// The offset has the derivatives of the surface but for one: with d/du of degree 3 on both sides of a double knot only points agree.
TEST(OffsetSurface, joins_in_points_alone_where_second_derivatives_jump) {
    const KnotVectorPtr twice = make_knot_vector(3, {0, 0, 0, 0, 0.5, 0.5, 1, 1, 1, 1}),
                        line = make_knot_vector(1, {0, 0, 1, 1});
    std::vector<double> points;
    for (int i = 0; i < 6; ++i) {
        for (const double v : {0.0, 1.0}) {
            points.insert(points.end(), {i / 5.0, v, i == 4 ? 0.1 : 0.0});
        }
    }
    const SplinePtr sheet = make_result({twice, line}, 3, Form::polynomial, std::move(points));
    const fit::OffsetSurface made = fit::offset_surface(sheet, 0.05, usual);
    EXPECT_EQ(multiplicity_of(*made.spline, 0, 0.5), 5);
    EXPECT_LE(made.bound, usual.tolerance);
    EXPECT_LE(largest_miss(*sheet, 0.05, *made.spline), made.bound);
}

// Quintic patches come nearer by the sixth power of their size: a hundredth of the error takes about 4.6 times as many, and bounds
// are not far above the error.
TEST(OffsetSurface, takes_few_control_points) {
    std::mt19937_64 random(20261127);
    const SplinePtr surface = patch(random, false, 0.1);
    int64_t before = 0;
    for (const double tolerance : {1e-5, 1e-7, 1e-9}) {
        const fit::OffsetSurface made = fit::offset_surface(surface, 0.05, {tolerance, 1 << 16});
        const int64_t points = made.spline->point_count();
        EXPECT_LE(made.bound, tolerance);
        EXPECT_LE(made.bound, 8 * largest_miss(*surface, 0.05, *made.spline));
        EXPECT_LE(points, before == 0 ? 1400 : 7 * before);
        before = points;
    }
}

int64_t patches_of(const Spline &spline) {
    int64_t patches = 1;
    for (const int k : {0, 1}) {
        patches *= std::ssize(distinct_knots(spline.axis(k).knots())) - 1;
    }
    return patches;
}

// The nearest one that was met, with what is proven of it.
TEST(OffsetSurface, is_as_near_as_patches_allow) {
    std::mt19937_64 random(9);
    const SplinePtr surface = patch(random, false, 0.3);
    double before = 1;
    for (const int64_t most : {40, 160, 640}) {
        int64_t left = 100000;
        const fit::OffsetSurface made = fit::offset_surface(surface, 0.05, {1e-14, most, &left});
        EXPECT_LE(patches_of(*made.spline), most);
        EXPECT_GE(patches_of(*made.spline), most / 3);
        EXPECT_GT(left, 100000 - 4 * most);
        EXPECT_GT(made.bound, 1e-14);
        EXPECT_LT(made.bound, before / 8);
        EXPECT_LE(largest_miss(*surface, 0.05, *made.spline), made.bound);
        before = made.bound;
    }
    for (const int64_t all : {50, 500}) {
        int64_t left = all;
        const fit::OffsetSurface made = fit::offset_surface(surface, 0.05, {1e-14, 1 << 16, &left});
        EXPECT_GE(left, 0);
        EXPECT_LE(patches_of(*made.spline), all);
        EXPECT_LE(largest_miss(*surface, 0.05, *made.spline), made.bound);
    }
}

// Whatever its normals are: a fan, too.
TEST(OffsetSurface, by_next_to_nothing_is_the_surface) {
    std::mt19937_64 random(1);
    const SplinePtr surface = patch(random, true, 0.3);
    for (const double distance : {0.0, -0.0, 1e-300, -1e-300, 5e-324, 1e-4, -1e-4}) {
        const fit::OffsetSurface made = fit::offset_surface(surface, distance, usual);
        EXPECT_EQ(made.spline, surface);
        EXPECT_EQ(made.bound, std::abs(distance));
    }
}

// The same surface in other forms: with a knot vector that goes on beyond the domain, and with knots that repeat.
SplinePtr bowl(const KnotVectorPtr &u) {
    std::vector<double> points;
    const KnotVectorPtr v = make_knot_vector(2, {0, 0, 0, 1, 1, 1});
    for (int64_t i = 0; i < u->count(); ++i) {
        for (const double y : {0.0, 0.5, 1.0}) {
            points.insert(points.end(), {0.25 * static_cast<double>(i), y,
                                         std::sin(static_cast<double>(i)) / 4 + y * y / 4});
        }
    }
    return make_result({u, v}, 3, Form::polynomial, std::move(points));
}

TEST(OffsetSurface, of_other_forms_of_knots) {
    for (const KnotVectorPtr &u : {make_knot_vector(3, {-3, -2, -1, 0, 1, 2, 3, 4, 5, 6}),
                                   make_knot_vector(2, {-2, -1, 0, 1, 1.5, 2, 4}),
                                   make_knot_vector(3, {0, 0, 0, 0, 1, 1, 2, 2, 2, 2})}) {
        const SplinePtr surface = bowl(u);
        const fit::OffsetSurface made = fit::offset_surface(surface, -0.1, {1e-6, 1 << 14});
        EXPECT_LE(made.bound, 1e-6);
        EXPECT_LE(largest_miss(*surface, -0.1, *made.spline), made.bound);
        EXPECT_EQ(made.spline->axis(0).domain().lower, u->domain().lower);
        EXPECT_EQ(made.spline->axis(0).domain().upper, u->domain().upper);
    }
}

// A closed tube with a periodic knot vector: its offset is closed, too.
TEST(OffsetSurface, of_a_periodic_tube_is_closed) {
    std::vector<double> points;
    for (int i = 0; i < 11; ++i) {
        const double angle = 2 * std::numbers::pi * (i % 8) / 8;
        for (const double z : {0.0, 1.0}) {
            points.insert(points.end(), {std::cos(angle), std::sin(angle), z});
        }
    }
    std::vector<double> knots(15);
    std::iota(knots.begin(), knots.end(), -3.0);
    const SplinePtr tube = make_result({make_knot_vector(3, knots), make_knot_vector(1, {0, 0, 1, 1})}, 3,
                                       Form::polynomial, std::move(points));
    const fit::OffsetSurface made = fit::offset_surface(tube, 0.25, {1e-6, 1 << 14});
    EXPECT_LE(made.bound, 1e-6);
    EXPECT_LE(largest_miss(*tube, 0.25, *made.spline), made.bound);
    EXPECT_LE(length(point_of(*made.spline, 0, 0.5) - point_of(*made.spline, 8, 0.5)), 1e-14);
}

// The point of a weight of 0 has no influence; the ones around it have.
TEST(OffsetSurface, of_weights_of_0_inside) {
    std::mt19937_64 random(4);
    const SplinePtr surface = patch(random, true, 0.1);
    std::vector<double> weights;
    std::vector<double> points;
    for (int64_t i = 0; i < surface->point_count(); ++i) {
        weights.push_back(i == 14 ? 0 : surface->weight(i));
        for (const int c : {0, 1, 2}) {
            points.push_back(surface->coordinate(i, c));
        }
    }
    const SplinePtr other =
        make_result(surface->knot_vectors(), 3, Form::rational, std::move(points), std::move(weights));
    const fit::OffsetSurface made = fit::offset_surface(other, 0.02, {1e-5, 1 << 14});
    EXPECT_LE(made.bound, 1e-5);
    EXPECT_LE(largest_miss(*other, 0.02, *made.spline), made.bound);
    // Two rows of 1 with one of 0 between them stop at their ends.
    const KnotVectorPtr square = make_knot_vector(2, {0, 0, 0, 1, 1, 1}),
                        line = make_knot_vector(1, {0, 0, 1, 1});
    const SplinePtr sheet =
        make_result({square, line}, 3, Form::rational, {0, 0, 0, 0, 1, 0, 5, 5, 5, 5, 5, 5, 1, 0, 1, 1, 1, 1},
                    {1, 1, 0, 0, 1, 1});
    std::string text;
    EXPECT_EQ(status_of(sheet, 0.25, usual, &text), Status::unsupported);
    EXPECT_NE(text.find("no normal at (0, 0)"), std::string::npos) << text;
}

// Bilinear: the hyperbolic paraboloid z = x y, by its definition. Degree 0 has no tangent.
TEST(OffsetSurface, of_low_degrees) {
    const KnotVectorPtr line = make_knot_vector(1, {0, 0, 1, 1});
    const SplinePtr saddle =
        make_result({line, line}, 3, Form::polynomial, {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 1});
    const fit::OffsetSurface made = fit::offset_surface(saddle, 0.5, {1e-8, 1 << 14});
    for (const double u : {0.2, 0.7}) {
        for (const double v : {0.1, 0.9}) {
            const Vector3 normal{-v, -u, 1};
            const Vector3 wanted = Vector3{u, v, u * v} + 0.5 / length(normal) * normal;
            EXPECT_LE(length(point_of(*made.spline, u, v) - wanted), made.bound);
        }
    }
    std::string text;
    const SplinePtr step = make_result({make_knot_vector(0, {0, 1, 2}), line}, 3, Form::polynomial,
                                       {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 1});
    EXPECT_EQ(status_of(step, 0.1, usual, &text), Status::unsupported);
    EXPECT_NE(text.find("no normal at (0, 0)"), std::string::npos) << text;
}

TEST(OffsetSurface, says_what_it_cannot_do) {
    std::string text;
    std::mt19937_64 random(9);
    int64_t left = 8; // there are nine pieces
    EXPECT_EQ(status_of(patch(random, false, 0.3), 0.1, {1e-6, 4096, &left}, &text), Status::not_converged);
    EXPECT_NE(text.find("no patches are left for the offset surface, which takes 9"), std::string::npos)
        << text;
    EXPECT_EQ(status_of(patch(random, false, 0.3), 0.1, {1e-6, 8}, &text), Status::not_converged);
    // Normals turn by more than half a turn on its one piece, which no direction shows.
    const KnotVectorPtr quartic = make_knot_vector(4, {0, 0, 0, 0, 0, 1, 1, 1, 1, 1}),
                        line = make_knot_vector(1, {0, 0, 1, 1});
    const SplinePtr hook =
        make_result({quartic, line}, 3, Form::polynomial, {0, 0, 0, 0, 1, 0, 3, 0, 0, 3, 1, 0, 3, 0, 3,
                                                           3, 1, 3, 0, 0, 3, 0, 1, 3, 0, 0, 1, 0, 1, 1});
    EXPECT_EQ(status_of(hook, 0.1, {1e-6, 1}, &text), Status::not_converged);
    EXPECT_NE(text.find("could not be told with the 1 patches"), std::string::npos) << text;
    EXPECT_EQ(status_of(hook, 0.1, {1e-6, 4096}, &text), Status::ok);
    // A roof, and a fan that ends in a point.
    const KnotVectorPtr kink = make_knot_vector(1, {0, 0, 1, 2, 2});
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
