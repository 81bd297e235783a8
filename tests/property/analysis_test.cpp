// Monotone pieces, convexity, straightness, planarity, boundaries that meet, singular places and folds.
#include "exact_points.h"
#include "made_shapes.h"
#include "support/cases.h"
#include "support/handle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace analysis_test {

using namespace support;

namespace {

using Vec = std::vector<double>;
constexpr double pi = std::numbers::pi;

SplineData bezier(int dim, Vec points, Vec weights = {}) {
    const auto p = static_cast<int32_t>(points.size()) / dim - 1;
    SplineData data{{p}, {p + 1}, {{}}, dim, std::move(points), std::move(weights), 0};
    data.knots[0].assign(static_cast<size_t>(p) + 1, 0.0);
    data.knots[0].insert(data.knots[0].end(), static_cast<size_t>(p) + 1, 1.0);
    return data;
}

Handle ellipse(double a, double b, double start, double sweep) {
    return made([&](nurbs **out) {
        return nurbs_curve_ellipse(2, nullptr, nullptr, nullptr, a, b, start, sweep, NURBS_ARC_QUARTERS, out);
    });
}

int32_t convexity(const nurbs *g) {
    int32_t result = -1;
    require_ok(nurbs_curve_convexity(g, &result));
    return result;
}

struct Pieces {
    Vec starts;
    std::vector<int32_t> signs;
    int32_t complete = -1;
};

Pieces monotone(const nurbs *g, const Vec &direction) {
    Pieces p;
    int64_t count = -1;
    require_ok(nurbs_curve_monotone_pieces(g, direction.data(), 0, nullptr, nullptr, &count, &p.complete));
    p.starts.resize(static_cast<size_t>(count));
    p.signs.resize(static_cast<size_t>(count));
    require_ok(nurbs_curve_monotone_pieces(g, direction.data(), count, p.starts.data(), p.signs.data(),
                                           nullptr, nullptr));
    return p;
}

struct Places {
    Vec params, boxes;
    int64_t count = -1;
    int32_t complete = -1;
};

Places singular(const nurbs *g, double tolerance, size_t axes) {
    Places p;
    require_ok(nurbs_singular_points(g, tolerance, 0, nullptr, nullptr, &p.count, &p.complete));
    p.params.resize(static_cast<size_t>(p.count) * axes);
    p.boxes.resize(static_cast<size_t>(p.count) * axes * 2);
    require_ok(
        nurbs_singular_points(g, tolerance, p.count, p.params.data(), p.boxes.data(), nullptr, nullptr));
    return p;
}

struct Fold {
    int32_t result = -1;
    Vec positive = Vec(3), negative = Vec(3);
};

Fold fold(const nurbs *g, const double *reference = nullptr) {
    Fold f;
    require_ok(nurbs_fold_test(g, reference, &f.result, f.positive.data(), f.negative.data()));
    return f;
}

// The graph of a height over a grid in the plane, moved sideways by `lean` times a wave.
SplineData sheet(double lean) {
    SplineData data{{3, 3}, {6, 6}, {{0, 0, 0, 0, 1, 2, 3, 3, 3, 3}, {0, 0, 0, 0, 1, 2, 3, 3, 3, 3}}, 3, {},
                    {},     0};
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 6; ++j) {
            data.points.insert(data.points.end(), {i + lean * std::sin(2.0 * i), static_cast<double>(j),
                                                   std::cos(i + 2.0 * j) / 4});
        }
    }
    return data;
}

} // namespace

// In exact arithmetic the derivative has the sign of the piece.
TEST(MonotonePieces, have_the_sign_of_the_derivative) {
    int complete = 0;
    for_each_case(8100, 200, [&](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, 1, 6);
        const SplineData data = random_spline(random, recipe);
        const Handle g = create(data);
        Vec direction(static_cast<size_t>(data.dim));
        std::generate(direction.begin(), direction.end(), [&] { return random.between(-1, 1); });
        const Pieces pieces = monotone(g.get(), direction);
        ASSERT_FALSE(pieces.starts.empty());
        EXPECT_EQ(pieces.starts.front(), data.lower(0));
        complete += pieces.complete;
        for (const double t : random_params(random, data, 20)) {
            const auto d = reference::exact_derivatives(data, 1, &t);
            Rational along = 0;
            for (size_t c = 0; c < direction.size(); ++c) {
                along += exact(direction[c]) * Rational(d[1][c].numerator, d[1][c].denominator);
            }
            const auto beside = [&](double s) {
                return std::fabs(s - t) <= 1e-9 * (data.upper(0) - data.lower(0));
            };
            const bool near = std::any_of(pieces.starts.begin(), pieces.starts.end(), beside) ||
                              std::any_of(data.knots[0].begin(), data.knots[0].end(), beside);
            const auto i = static_cast<size_t>(
                std::upper_bound(pieces.starts.begin(), pieces.starts.end(), t) - pieces.starts.begin() - 1);
            if (!near && along != 0 && pieces.signs[i] != 0 && pieces.complete == 1) {
                EXPECT_EQ(pieces.signs[i], along > 0 ? 1 : -1) << t << where(seed, data);
            }
        }
    });
    EXPECT_GT(complete, support::of_whole_run(150));
}

TEST(MonotonePieces, of_a_circle_and_of_stairs) {
    const Handle g = ellipse(2, 2, 0, 2 * pi);
    const Pieces p = monotone(g.get(), {0, 1});
    EXPECT_EQ(p.complete, 1);
    EXPECT_EQ(p.signs, (std::vector<int32_t>{1, -1, 1}));
    EXPECT_EQ(p.starts, (Vec{0, 0.25, 0.75}));
    const Handle flat = create(bezier(2, {0, 1, 1, 1, 2, 1}));
    EXPECT_EQ(monotone(flat.get(), {0, 1}).signs, std::vector<int32_t>{0});
    EXPECT_EQ(monotone(flat.get(), {-1e300, 0}).signs, std::vector<int32_t>{-1});
    const SplineData jump{{1}, {4}, {{0, 0, 1, 1, 2, 2}}, 1, {0, 1, -5, 6}, {}, 0};
    EXPECT_EQ(monotone(create(jump).get(), {1}).starts, (Vec{0, 1}));
}

// The first span is perpendicular to the direction but for about the rounding of its coefficients, which hides
// all of it or a part at its start; the second span is not.
TEST(MonotonePieces, start_with_the_curve_where_rounding_hides_its_first_span) {
    int hidden = 0;
    for_each_case(8150, 400, [&](Random &random, uint64_t seed) {
        const double angle = random.between(0, 2 * pi), off = std::pow(10, random.between(-16.5, -14));
        const Vec d{std::cos(angle), std::sin(angle)};
        SplineData data{{3}, {7}, {{0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2}}, 2, {}, {}, 0};
        for (int i = 0; i < 7; ++i) {
            const double across = random.between(-1, 1), along = i < 4 ? off * random.between(-1, 1) : i;
            data.points.insert(data.points.end(),
                               {along * d[0] - across * d[1], along * d[1] + across * d[0]});
        }
        const Pieces pieces = monotone(create(data).get(), d);
        ASSERT_FALSE(pieces.starts.empty()) << where(seed, data);
        EXPECT_EQ(pieces.starts.front(), 0) << where(seed, data);
        EXPECT_EQ(pieces.signs.back(), 1) << where(seed, data);
        EXPECT_LE(pieces.starts.back(), 1) << where(seed, data);
        hidden += pieces.signs.front() == 0 ? 1 : 0;
    });
    EXPECT_GT(hidden, support::of_whole_run(0));
}

TEST(Convexity, known_curves) {
    for_each_case(8200, 50, [](Random &random, uint64_t seed) {
        const double a = random.between(0.1, 3),
                     sweep = random.chance(30) ? 2 * pi : random.between(0.1, 6.2);
        const double start = random.between(-3, 3);
        EXPECT_EQ(convexity(ellipse(a, 1, start, sweep).get()), NURBS_CONVEXITY_LEFT) << seed;
        EXPECT_EQ(convexity(ellipse(a, 1, start, -sweep).get()), NURBS_CONVEXITY_RIGHT) << seed;
    });
    const auto of = [](const SplineData &data) { return convexity(create(data).get()); };
    EXPECT_EQ(of(bezier(2, {0, 0, 1, 2, 2, 0})), NURBS_CONVEXITY_RIGHT);
    EXPECT_EQ(of(bezier(2, {0, 0, 1, 2, 2, -2, 3, 0})), NURBS_CONVEXITY_NONE);
    EXPECT_EQ(of(bezier(2, {0, 0, 1, 0.5, 2, 1, 3, 1.5})), NURBS_CONVEXITY_STRAIGHT);
    EXPECT_EQ(of(bezier(2, {0, 0, 2, 2, 1, 1})), NURBS_CONVEXITY_NONE);       // straight, and back
    EXPECT_EQ(of(bezier(2, {0, 0, 1, 1, 0, 1, 1, 0})), NURBS_CONVEXITY_NONE); // a cusp
    EXPECT_EQ(of(bezier(2, {0, 0, 0, 0, 1, 0, 1, 1})), NURBS_CONVEXITY_LEFT); // a double point at the end
    const SplineData square{{1}, {5}, {{0, 0, 1, 2, 3, 4, 4}}, 2, {0, 0, 1, 0, 1, 1, 0, 1, 0, 0}, {}, 0};
    EXPECT_EQ(of(square), NURBS_CONVEXITY_LEFT);
    SplineData star = square;
    star.points = {0, 0, 4, 0, 1, 3, 2, -1, 4, 3};
    EXPECT_EQ(of(star), NURBS_CONVEXITY_NONE);
    SplineData twice{{1}, {9}, {{0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 8}}, 2, {}, {}, 0}; // two turns
    for (int i = 0; i < 9; ++i) {
        twice.points.insert(twice.points.end(), {std::cos(pi / 2 * i), std::sin(pi / 2 * i)});
    }
    EXPECT_EQ(of(twice), NURBS_CONVEXITY_NONE);
}

// A convex curve in any of its forms.
TEST(Convexity, survives_refinement) {
    for_each_case(8300, 60, [](Random &random, uint64_t seed) {
        Vec points;
        const int p = random.whole(2, 8);
        for (int i = 0; i <= p; ++i) { // a convex polygon makes a convex curve
            const double angle = 3 * i / static_cast<double>(p);
            points.insert(points.end(), {std::cos(angle), 2 * std::sin(angle)});
        }
        SplineData data = bezier(2, points);
        move(data, random_motion(random, 2, random.magnitude(1e-6, 1e6), 2));
        const Handle g = disguised(random, create(data), 1);
        const int32_t found = convexity(g.get());
        EXPECT_TRUE(found == NURBS_CONVEXITY_LEFT || found == NURBS_CONVEXITY_RIGHT) << found << " " << seed;
    });
}

// Every point is within the bound, in exact arithmetic; on made shapes the bound is what it has to be.
TEST(Straightness, bounds_are_proven) {
    for_each_case(8400, 150, [](Random &random, uint64_t seed) {
        const SplineData data = random_spline(random, random_recipe(random, random.whole(1, 2), 4));
        const Handle g = create(data);
        const auto dim = static_cast<size_t>(data.dim);
        Vec origin(dim), direction(dim);
        double bound = -1;
        require_ok(nurbs_straightness(g.get(), origin.data(), direction.data(), &bound));
        Rational square = 0;
        for (const double x : direction) {
            square += exact(x) * exact(x);
        }
        for (int i = 0; i < 5; ++i) {
            const Point p = point_at(data, random_params(random, data, 1));
            Rational along = 0, far = 0;
            for (size_t c = 0; c < dim; ++c) {
                const Rational x = p[c] - exact(origin[c]);
                along += x * exact(direction[c]);
                far += x * x;
            }
            EXPECT_TRUE(far - along * along / square <= exact(bound) * exact(bound)) << where(seed, data);
        }
    });
    const Handle line = create(bezier(3, {1, 2, 3, 2, 3, 4, 5, 6, 7}));
    double bound = -1;
    Vec direction(3);
    require_ok(nurbs_straightness(line.get(), nullptr, direction.data(), &bound));
    EXPECT_LT(bound, 1e-13);
    EXPECT_NEAR(direction[0], 1 / std::sqrt(3.0), 1e-14);
    const Handle circle = ellipse(2, 2, 0, 2 * pi);
    require_ok(nurbs_straightness(circle.get(), nullptr, nullptr, &bound));
    EXPECT_NEAR(bound, 2, 3e-3);
}

TEST(Planarity, bounds_are_proven) {
    for_each_case(8500, 150, [](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, random.whole(1, 2), 4);
        recipe.dim = 3;
        const SplineData data = random_spline(random, recipe);
        const Handle g = create(data);
        Vec origin(3), normal(3);
        double bound = -1;
        require_ok(nurbs_planarity(g.get(), origin.data(), normal.data(), &bound));
        EXPECT_GT(*std::max_element(normal.begin(), normal.end()), 0.57);
        Rational square = 0;
        for (const double x : normal) {
            square += exact(x) * exact(x);
        }
        for (int i = 0; i < 5; ++i) {
            const Point p = point_at(data, random_params(random, data, 1));
            Rational along = 0;
            for (size_t c = 0; c < 3; ++c) {
                along += (p[c] - exact(origin[c])) * exact(normal[c]);
            }
            EXPECT_TRUE(along * along <= exact(bound) * exact(bound) * square) << where(seed, data);
        }
    });
    double bound = -1;
    const Handle plane = create(parallelogram(3, 2, 1));
    require_ok(nurbs_planarity(plane.get(), nullptr, nullptr, &bound));
    EXPECT_LT(bound, 1e-13);
}

TEST(BoundaryContacts, of_the_quadrics) {
    const Handle sphere = made([](nurbs **out) {
        return nurbs_surface_sphere(nullptr, nullptr, nullptr, 2, NURBS_ARC_QUARTERS, out);
    });
    std::array<int32_t, 2> closed{};
    std::array<int32_t, 4> collapsed{};
    std::array<double, 2> gaps{};
    std::array<double, 4> sizes{};
    require_ok(nurbs_boundary_contacts(sphere.get(), 1e-12, closed.data(), gaps.data(), collapsed.data(),
                                       sizes.data()));
    EXPECT_EQ(closed, (std::array<int32_t, 2>{1, 0}));
    EXPECT_EQ(collapsed, (std::array<int32_t, 4>{0, 0, 1, 1}));
    EXPECT_NEAR(gaps[1], 4, 1); // from pole to pole, bounded to a quarter
    EXPECT_GE(gaps[1], 4);
    EXPECT_NEAR(sizes[0], 2, 0.01); // half a circle about its centre
    EXPECT_EQ(gaps[0], 0);
    const Handle torus = made([](nurbs **out) {
        return nurbs_surface_torus(nullptr, nullptr, nullptr, 3, 1, 0, 2 * pi, 0, 2 * pi, NURBS_ARC_QUARTERS,
                                   out);
    });
    require_ok(nurbs_boundary_contacts(torus.get(), 0, closed.data(), nullptr, collapsed.data(), nullptr));
    EXPECT_EQ(closed, (std::array<int32_t, 2>{1, 1}));
    EXPECT_EQ(collapsed, (std::array<int32_t, 4>{0, 0, 0, 0}));
    require_ok(nurbs_boundary_contacts(torus.get(), 1.01, nullptr, nullptr, collapsed.data(), nullptr));
    EXPECT_EQ(collapsed, (std::array<int32_t, 4>{1, 1, 0, 0})); // circles of radius 1 and 4
    const Handle arc = ellipse(1, 1, 0, pi);
    double gap = 0;
    int32_t meets = -1, points[] = {-1, -1};
    require_ok(nurbs_boundary_contacts(arc.get(), 2 + 1e-9, &meets, &gap, points, nullptr));
    EXPECT_EQ(meets, 1);
    EXPECT_EQ(points[0], 1);
    EXPECT_EQ(points[1], 1);
    EXPECT_NEAR(gap, 2, 1e-13);
}

// Between the tolerances that bounds leave open the search goes on.
TEST(BoundaryContacts, tells_the_sides_of_the_tolerance) {
    const Handle sphere = made([](nurbs **out) {
        return nurbs_surface_spherical_patch(nullptr, nullptr, nullptr, 1, 0, 1, -0.5, 0.5,
                                             NURBS_ARC_QUARTERS, out);
    });
    double gap = 0;
    std::array<int32_t, 2> closed{};
    std::array<double, 2> gaps{};
    require_ok(nurbs_boundary_contacts(sphere.get(), 0, closed.data(), gaps.data(), nullptr, nullptr));
    gap = 2 * std::sin(0.5); // of the meridians, on the equator
    EXPECT_GE(gaps[0], gap);
    for (const double tolerance : {gap * (1 + 1e-6), gap * (1 - 1e-6)}) {
        require_ok(
            nurbs_boundary_contacts(sphere.get(), tolerance, closed.data(), gaps.data(), nullptr, nullptr));
        EXPECT_EQ(closed[0], tolerance > gap ? 1 : 0);
    }
}

TEST(SingularPoints, poles_and_cusps) {
    const Handle sphere = made([](nurbs **out) {
        return nurbs_surface_sphere(nullptr, nullptr, nullptr, 2, NURBS_ARC_QUARTERS, out);
    });
    const Places poles = singular(sphere.get(), 1e-6, 2);
    EXPECT_EQ(poles.complete, 1);
    EXPECT_EQ(poles.count, 8); // a point on each piece that has a pole as an edge
    for (size_t i = 0; i < 8; ++i) {
        EXPECT_TRUE(poles.params[2 * i + 1] == 0 || poles.params[2 * i + 1] == 1);
        EXPECT_EQ(poles.boxes[4 * i + 2], poles.boxes[4 * i + 3]);
    }
    const Handle torus = made([](nurbs **out) {
        return nurbs_surface_torus(nullptr, nullptr, nullptr, 3, 1, 0, 2 * pi, 0, 2 * pi, NURBS_ARC_QUARTERS,
                                   out);
    });
    EXPECT_EQ(singular(torus.get(), 1e-3, 2).count, 0);
    for_each_case(8600, 40, [](Random &random, uint64_t seed) {
        const double c = random.between(0.1, 0.9); // (t - c)^2, (t - c)^3
        const SplineData data =
            bezier(2, {c * c, -c * c * c, c * c - 2 * c / 3, -c * c * c + c * c, c * c - 4 * c / 3 + 1. / 3,
                       -c * c * c + 2 * c * c - c, (1 - c) * (1 - c), (1 - c) * (1 - c) * (1 - c)});
        const Places cusp = singular(create(data).get(), 1e-8, 1);
        ASSERT_EQ(cusp.count, 1) << seed;
        EXPECT_NEAR(cusp.params[0], c, 1e-7);
        EXPECT_LE(cusp.boxes[0], c);
        EXPECT_GE(cusp.boxes[1], c);
        EXPECT_LT(cusp.boxes[1] - cusp.boxes[0], 1e-7);
    });
}

// S = (u, v^2 / 2, v^3 / 3 + u v), S_v = (0, v, v^2 + u): singular where v = 0 and u = 0.
TEST(SingularPoints, whitney_like_point) {
    for_each_case(8700, 20, [](Random &random, uint64_t seed) {
        const double a = random.between(0.1, 0.9), b = random.between(0.1, 0.9); // where it lies
        SplineData data{{1, 3}, {2, 4}, {{0, 0, 1, 1}, {0, 0, 0, 0, 1, 1, 1, 1}}, 3, {}, {}, 0};
        for (const double u : {-a, 1 - a}) {
            const double s = -b, t = 1 - b; // v from s to t
            const Vec y{s * s / 2, s * (s + 2 * t) / 6, t * (t + 2 * s) / 6, t * t / 2};
            const Vec z{s * s * s / 3, s * s * t / 3, s * t * t / 3, t * t * t / 3};
            for (size_t j = 0; j < 4; ++j) {
                const double v = s + (t - s) * static_cast<double>(j) / 3;
                data.points.insert(data.points.end(), {u, y[j], z[j] + u * v});
            }
        }
        const Places found = singular(create(data).get(), 1e-6, 2);
        ASSERT_EQ(found.count, 1) << seed;
        EXPECT_EQ(found.complete, 1);
        EXPECT_NEAR(found.params[0], a, 1e-4);
        EXPECT_NEAR(found.params[1], b, 1e-4);
        EXPECT_TRUE(found.boxes[0] <= a && found.boxes[1] >= a && found.boxes[2] <= b && found.boxes[3] >= b);
    });
}

// In exact arithmetic the normal does not vanish outside the boxes.
TEST(SingularPoints, regular_outside_the_boxes) {
    for_each_case(8800, 25, [](Random &random, uint64_t seed) {
        Recipe recipe = random_recipe(random, 2, 3);
        recipe.dim = random.whole(2, 4);
        for (AxisRecipe &axis : recipe.axes) {
            axis.spans = 2;
        }
        const SplineData data = random_spline(random, recipe);
        const Places found = singular(create(data).get(), 0.05, 2);
        for (int64_t i = 0; i < found.count; ++i) {
            const auto at = static_cast<size_t>(i);
            for (size_t k = 0; k < 2; ++k) {
                EXPECT_LE(found.boxes[4 * at + 2 * k], found.params[2 * at + k]) << where(seed, data);
                EXPECT_GE(found.boxes[4 * at + 2 * k + 1], found.params[2 * at + k]) << where(seed, data);
            }
        }
    });
}

TEST(Folds, of_a_sheet) {
    const double up[] = {0, 0, 1};
    EXPECT_EQ(fold(create(sheet(0.2)).get(), up).result, NURBS_FOLD_NONE);
    const Handle folded = create(sheet(1.5));
    const Fold found = fold(folded.get(), up);
    EXPECT_EQ(found.result, NURBS_FOLD_FOUND);
    const SplineData data = sheet(1.5);
    for (const bool positive : {true, false}) {
        const Vec &at = positive ? found.positive : found.negative;
        const auto d = reference::exact_derivatives(data, 1, at.data());
        const auto x = [&](size_t slot, size_t c) {
            return Rational(d[slot][c].numerator, d[slot][c].denominator);
        };
        const Rational z = x(1, 0) * x(2, 1) - x(1, 1) * x(2, 0);
        EXPECT_TRUE(positive ? z > 0 : z < 0);
    }
    EXPECT_EQ(fold(create(sheet(0.2)).get()).result, NURBS_FOLD_NONE); // with its vector area
}

TEST(Folds, of_patches_in_the_plane_and_volumes) {
    SplineData square{{1, 1}, {2, 2}, {{0, 0, 1, 1}, {0, 0, 1, 1}}, 2, {0, 0, 0, 1, 1, 0, 1, 1}, {}, 0};
    EXPECT_EQ(fold(create(square).get()).result, NURBS_FOLD_NONE);
    EXPECT_TRUE(std::isnan(fold(create(square).get()).negative[0]));
    square.points = {0, 0, 0, 1, 1, 0, 0.2, 0.3}; // a corner pushed through the diagonal
    EXPECT_EQ(fold(create(square).get()).result, NURBS_FOLD_FOUND);
    square.points = {0, 0, 0, 0, 1, 0, 1, 1}; // an edge that is a point
    const Fold edge = fold(create(square).get());
    EXPECT_EQ(edge.result, NURBS_FOLD_NONE);
    for_each_case(8900, 20, [](Random &random, uint64_t seed) {
        const bool bent = random.chance(50);
        SplineData cube{{1, 2, 1}, {2, 3, 2}, {{0, 0, 1, 1}, {0, 0, 0, 1, 1, 1}, {0, 0, 1, 1}}, 3, {}, {}, 0};
        for (int i = 0; i < 2; ++i) {
            for (int j = 0; j < 3; ++j) {
                for (int k = 0; k < 2; ++k) {
                    const double middle = bent ? 3.0 : 0.5; // beyond the end: y turns back
                    cube.points.insert(cube.points.end(), {static_cast<double>(i), j == 1 ? middle : j / 2.0,
                                                           static_cast<double>(k)});
                }
            }
        }
        if (random.chance(50)) {
            for (int i = 0; i < 12; ++i) {
                cube.weights.push_back(random.between(0.9, 1.1));
            }
        }
        EXPECT_EQ(fold(create(cube).get()).result, bent ? NURBS_FOLD_FOUND : NURBS_FOLD_NONE) << seed;
    });
}

// Half a sphere over the plane has no fold in its direction; its pole is an edge. A whole one has.
TEST(Folds, of_a_sphere) {
    const double up[] = {0, 0, 1e-200};
    const Handle half = made([](nurbs **out) {
        return nurbs_surface_spherical_patch(nullptr, nullptr, nullptr, 1, 0, 2 * pi, 0.1, pi / 2,
                                             NURBS_ARC_QUARTERS, out);
    });
    EXPECT_EQ(fold(half.get(), up).result, NURBS_FOLD_NONE);
    EXPECT_EQ(fold(half.get()).result, NURBS_FOLD_NONE);
    const Handle whole = made([](nurbs **out) {
        return nurbs_surface_sphere(nullptr, nullptr, nullptr, 1, NURBS_ARC_QUARTERS, out);
    });
    EXPECT_EQ(fold(whole.get(), up).result, NURBS_FOLD_FOUND);
    int32_t result = -1;
    EXPECT_EQ(nurbs_fold_test(whole.get(), nullptr, &result, nullptr, nullptr), NURBS_ERROR_DIRECTION);
}

} // namespace analysis_test
