// Distances of two splines: closed forms, dense samples, and the laws of distances.
#include "reference/number.h"
#include "support/cases.h"
#include "support/generators.h"
#include "support/handle.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace distance_test {

using namespace support;

namespace {

constexpr double pi = std::numbers::pi;
const double up[] = {0, 0, 1}, right[] = {1, 0, 0};

struct Pair {
    double at_least = -1, at_most = -1;
    std::vector<double> a{0, 0, 0}, b{0, 0, 0};
    int32_t status = -1;
};

Pair nearest(const nurbs *a, const nurbs *b, double tolerance = 1e-9, int64_t budget = 0) {
    Pair p;
    require_ok(
        nurbs_distance(a, b, tolerance, budget, &p.at_least, &p.at_most, p.a.data(), p.b.data(), &p.status));
    return p;
}

struct Two {
    double at_least[2] = {-1, -1}, at_most[2] = {-1, -1};
    std::vector<double> a{0, 0, 0}, b{0, 0, 0};
    int32_t status = -1;
};

Two hausdorff(const nurbs *a, const nurbs *b, double tolerance = 1e-6, int64_t budget = 0) {
    Two t;
    require_ok(nurbs_hausdorff_distance(a, b, tolerance, budget, t.at_least, t.at_most, t.a.data(),
                                        t.b.data(), &t.status));
    return t;
}

Handle circle(double x, double y, double r) {
    const double centre[] = {x, y};
    return made([&](nurbs **out) { return nurbs_curve_circle(2, centre, nullptr, right, r, 0, out); });
}
Handle sphere(double x, double r) {
    const double centre[] = {x, 0, 0};
    return made([&](nurbs **out) { return nurbs_surface_sphere(centre, up, right, r, 0, out); });
}
Handle cylinder(double r, double height) {
    const double centre[] = {0, 0, -height / 2};
    return made(
        [&](nurbs **out) { return nurbs_surface_cylinder(centre, up, right, r, height, 0, 2 * pi, 0, out); });
}
Handle polyline(int dim, const std::vector<double> &points) {
    SplineData data;
    const auto n = static_cast<int64_t>(points.size()) / dim;
    data.degrees = {1};
    data.counts = {n};
    data.knots = {{0}};
    for (int64_t i = 0; i < n; ++i) {
        data.knots[0].push_back(static_cast<double>(i));
    }
    data.knots[0].push_back(static_cast<double>(n - 1));
    data.dim = dim;
    data.points = points;
    return create(data);
}

SplineData random_net(Random &random, int axes, int degree, int count, double shift, bool rational) {
    SplineData data;
    data.dim = 3;
    int64_t total = 1;
    for (int k = 0; k < axes; ++k) {
        data.degrees.push_back(degree);
        data.counts.push_back(count);
        std::vector<double> knots(static_cast<size_t>(degree) + 1, 0.0);
        for (int i = degree + 1; i < count; ++i) {
            knots.push_back(knots.back() + random.between(0.3, 1));
        }
        knots.insert(knots.end(), static_cast<size_t>(degree) + 1, knots.back() + 1);
        data.knots.push_back(knots);
        total *= count;
    }
    for (int64_t i = 0; i < total; ++i) {
        for (int c = 0; c < 3; ++c) {
            data.points.push_back(random.between(-1, 1) + (c == 0 ? shift : 0));
        }
        if (rational) {
            data.weights.push_back(random.magnitude(0.4, 2.5));
        }
    }
    return data;
}

double between(const double *p, const double *q, int dim) {
    double square = 0;
    for (int c = 0; c < dim; ++c) {
        square += (p[c] - q[c]) * (p[c] - q[c]);
    }
    return std::sqrt(square);
}

std::vector<double> samples(Random &random, const SplineData &data, const nurbs *g, int n) {
    std::vector<double> params;
    for (int i = 0; i < n; ++i) {
        for (int k = 0; k < data.axes(); ++k) {
            params.push_back(random.between(data.lower(k), data.upper(k)));
        }
    }
    return eval(g, params);
}

void expect_distance(const nurbs *a, const nurbs *b, double exact, double tolerance) {
    const Pair p = nearest(a, b, tolerance);
    EXPECT_EQ(p.status, NURBS_CLOSEST_CERTIFIED) << exact << ' ' << p.at_least << ' ' << p.at_most;
    EXPECT_LE(p.at_least, exact + 1e-14);
    EXPECT_GE(p.at_most, exact - 1e-13 * (exact + 1));
    EXPECT_LE(p.at_most - p.at_least, tolerance + 1e-11);
}

} // namespace

TEST(Distance, lines_circles_and_spheres) {
    for (const double tolerance : {1e-4, 1e-9}) {
        const Handle segment = polyline(2, {0, 0, 1, 0}), level = polyline(2, {0.5, 1, 3, 1}),
                     steep = polyline(2, {0.25, -1, 0.5, 2}), away = polyline(2, {2, 1, 3, 7});
        expect_distance(segment.get(), level.get(), 1, tolerance);
        expect_distance(segment.get(), steep.get(), 0, tolerance);
        expect_distance(segment.get(), away.get(), std::sqrt(2), tolerance);
        const Handle one = circle(0, 0, 1);
        expect_distance(one.get(), circle(0, 0, 2).get(), 1, tolerance);
        expect_distance(one.get(), circle(5, 1, 2).get(), std::hypot(5, 1) - 3, tolerance);
        expect_distance(one.get(), circle(2, 1, 2).get(), 0, tolerance);
        expect_distance(one.get(), circle(3, 0, 2).get(), 0, tolerance);
        expect_distance(one.get(), one.get(), 0, tolerance);
        expect_distance(sphere(0, 1).get(), sphere(4, 2).get(), 1, tolerance);
        expect_distance(sphere(0, 1).get(), sphere(0, 2).get(), 1, tolerance);
        expect_distance(sphere(0, 1).get(), sphere(1, 1).get(), 0, tolerance);
        expect_distance(cylinder(1, 2).get(), cylinder(2, 3).get(), 1, tolerance);
        expect_distance(polyline(3, {0, 0, 0, 1, 1, 0}).get(), polyline(3, {0, 1, 1, 1, 0.1, 1}).get(), 1,
                        tolerance);
    }
}

TEST(Distance, no_sample_is_nearer) {
    Random random(6601);
    for (int i = 0; i < 40; ++i) {
        const int first = random.whole(1, 2), second = random.whole(1, 2);
        const SplineData a =
            random_net(random, first, random.whole(1, 4), random.whole(5, 9), 0, random.chance(50));
        const SplineData b = random_net(random, second, random.whole(1, 4), random.whole(5, 9),
                                        random.chance(50) ? 2.5 : 0.2, random.chance(50));
        const Handle f = create(a), g = create(b);
        const Pair p = nearest(f.get(), g.get(), 1e-8);
        EXPECT_EQ(p.status, NURBS_CLOSEST_CERTIFIED)
            << first << second << ' ' << p.at_least << ' ' << p.at_most;
        const std::vector<double> x = eval(f.get(), {p.a.begin(), p.a.begin() + first}),
                                  y = eval(g.get(), {p.b.begin(), p.b.begin() + second});
        EXPECT_NEAR(between(x.data(), y.data(), 3), p.at_most, 1e-15);
        EXPECT_LE(p.at_least, p.at_most);
        EXPECT_LE(p.at_most - p.at_least, 1e-8 + 1e-11);
        const std::vector<double> left = samples(random, a, f.get(), 300),
                                  other = samples(random, b, g.get(), 300);
        for (size_t k = 0; k < left.size(); k += 3) {
            for (size_t l = 0; l < other.size(); l += 3) {
                ASSERT_GE(between(&left[k], &other[l], 3), p.at_least);
            }
        }
        const Pair back = nearest(g.get(), f.get(), 1e-8);
        EXPECT_NEAR(back.at_most, p.at_most, 2.1e-8);
    }
}

// Powers of two change nothing but exponents.
TEST(Distance, scales_with_the_model) {
    Random random(6602);
    for (int i = 0; i < 5; ++i) {
        const SplineData a = random_net(random, 1, 3, 8, 0, true), b = random_net(random, 2, 2, 5, 2, false);
        const Pair before = nearest(create(a).get(), create(b).get(), 0x1p-30);
        for (const int power : {-200, 300}) {
            const double size = std::ldexp(1, power);
            const Pair after =
                nearest(create(scaled(a, size)).get(), create(scaled(b, size)).get(), 0x1p-30 * size);
            EXPECT_EQ(after.at_least, std::ldexp(before.at_least, power));
            EXPECT_EQ(after.at_most, std::ldexp(before.at_most, power));
            EXPECT_EQ(after.a, before.a);
        }
    }
}

// What a budget leaves open is told, and bounds stay bounds.
TEST(Distance, any_two_points_are_near_enough_for_an_infinite_tolerance) {
    for_each_case(4600, 60, [](Random &random, uint64_t) {
        Recipe recipes[] = {random_recipe(random, random.whole(1, 3), 3),
                            random_recipe(random, random.whole(1, 3), 0)};
        recipes[0].dim = recipes[1].dim = 3;
        const Handle a = create(random_spline(random, recipes[0])),
                     b = create(random_spline(random, recipes[1]));
        const Pair p = nearest(a.get(), b.get(), HUGE_VAL);
        EXPECT_EQ(p.status, NURBS_CLOSEST_CERTIFIED);
        EXPECT_TRUE(p.at_least >= 0 && p.at_least <= p.at_most);
    });
}

// Homogeneous records are known to eps of the place of their points, however near to each other these are.
TEST(Distance, of_homogeneous_segments_far_from_the_origin) {
    for_each_case(4700, 400, [](Random &random, uint64_t) {
        const double offset = random.magnitude(1e3, 1e12);
        std::vector<double> segments[2];
        reference::Rational ends[2][2];
        for (int i = 0; i < 4; ++i) {
            const double weight = random.between(0.5, 1.9), x = offset + random.unit() + (i < 2 ? 0 : 3);
            segments[i / 2].insert(segments[i / 2].end(), {weight * x, weight});
            ends[i / 2][i % 2] = reference::exact(weight * x) / reference::exact(weight);
        }
        Handle handles[2];
        const int32_t degree = 1;
        const int64_t count = 2;
        const double knots[] = {0, 0, 1, 1};
        for (int i = 0; i < 2; ++i) {
            nurbs *made = nullptr;
            require_ok(nurbs_create_homogeneous(1, &degree, &count, knots, 4, 1, segments[i].data(), 0, 0, 0,
                                                &made));
            handles[i].reset(made);
        }
        const Pair p = nearest(handles[0].get(), handles[1].get(), 0);
        const reference::Rational exact = std::min(ends[1][0], ends[1][1]) - std::max(ends[0][0], ends[0][1]);
        EXPECT_LE(reference::exact(p.at_least), exact) << offset;
    });
}

// The centres of frames are far beyond what the unit of the shapes can hold.
TEST(Distance, of_small_shapes_in_a_far_plane) {
    const double knots[] = {0, 0, 1, 1};
    const int32_t degree = 1;
    const int64_t count = 2;
    for (const double size : {1e-160, 1e-200}) {
        Handle handles[2];
        for (int i = 0; i < 2; ++i) {
            const double points[] = {0, 2 * i * size, 1 / size, size, 2 * i * size, 1 / size};
            nurbs *made = nullptr;
            require_ok(nurbs_create(1, &degree, &count, knots, 4, 3, points, 0, 0, nullptr, 0, 0, &made));
            handles[i].reset(made);
        }
        const Pair p = nearest(handles[0].get(), handles[1].get(), 0.01 * size);
        EXPECT_EQ(p.status, NURBS_CLOSEST_CERTIFIED);
        EXPECT_NEAR(p.at_least / size, 2, 0.02);
    }
}

TEST(Distance, a_budget_that_ends) {
    Random random(6603);
    const SplineData a = random_net(random, 2, 3, 9, 0, false), b = random_net(random, 2, 3, 9, 2.3, false);
    const Handle f = create(a), g = create(b);
    const Pair good = nearest(f.get(), g.get()), poor = nearest(f.get(), g.get(), 1e-12, 20);
    EXPECT_EQ(good.status, NURBS_CLOSEST_CERTIFIED);
    EXPECT_EQ(poor.status, NURBS_CLOSEST_BUDGET);
    EXPECT_LE(poor.at_least, good.at_most);
    EXPECT_GE(poor.at_most, good.at_least);
}

TEST(Hausdorff, circles_and_polygons) {
    const Handle one = circle(0, 0, 1), two = circle(0, 0, 2), aside = circle(0.5, 0, 1);
    for (const double tolerance : {1e-4, 1e-8}) {
        const Two rings = hausdorff(one.get(), two.get(), tolerance);
        const Two moved = hausdorff(one.get(), aside.get(), tolerance);
        for (const int side : {0, 1}) {
            EXPECT_LE(rings.at_least[side], 1 + 1e-13);
            EXPECT_GE(rings.at_most[side], 1 - 1e-13);
            EXPECT_LE(rings.at_most[side] - rings.at_least[side], tolerance + 1e-11);
            EXPECT_LE(moved.at_least[side], 0.5 + 1e-13);
            EXPECT_GE(moved.at_most[side], 0.5 - 1e-13);
            EXPECT_LE(moved.at_most[side] - moved.at_least[side], tolerance + 1e-11);
        }
        EXPECT_EQ(rings.status, NURBS_CLOSEST_CERTIFIED);
        EXPECT_EQ(moved.status, NURBS_CLOSEST_CERTIFIED);
    }
    std::vector<double> corners;
    for (int i = 0; i <= 8; ++i) {
        corners.push_back(std::cos(i * pi / 4));
        corners.push_back(std::sin(i * pi / 4));
    }
    const Two octagon = hausdorff(one.get(), polyline(2, corners).get(), 1e-8);
    for (const int side : {0, 1}) {
        EXPECT_NEAR(octagon.at_least[side], 1 - std::cos(pi / 8), 2e-8);
        EXPECT_NEAR(octagon.at_most[side], 1 - std::cos(pi / 8), 2e-8);
    }
    const Two part = hausdorff(polyline(2, {0, 0, 1, 0}).get(), polyline(2, {0, 0, 3, 0}).get(), 1e-9);
    EXPECT_LE(part.at_most[0], 1e-9 + 1e-11);
    EXPECT_NEAR(part.at_most[1], 2, 1e-8);
}

// Other parameters and other knots are the same set.
TEST(Hausdorff, the_same_set_has_none) {
    Random random(6604);
    for (int i = 0; i < 8; ++i) {
        const SplineData data =
            random_net(random, 1, random.whole(1, 4), random.whole(5, 9), 0, random.chance(50));
        const Handle g = create(data);
        const Handle other =
            insert(elevate(g.get(), 0, 1).get(), 0, random.between(data.lower(0), data.upper(0)), 1);
        const Handle back = made([&](nurbs **out) { return nurbs_reverse(other.get(), 0, 0, out); });
        for (const nurbs *h : {other.get(), back.get()}) {
            const Two found = hausdorff(g.get(), h, 1e-7);
            EXPECT_EQ(found.status, NURBS_CLOSEST_CERTIFIED);
            EXPECT_LE(std::max(found.at_most[0], found.at_most[1]), 1e-7 + 1e-11) << describe(data);
        }
    }
    const SplineData data = random_net(random, 2, 2, 5, 0, false);
    const Handle g = create(data);
    const Two found = hausdorff(g.get(), elevate(g.get(), 1, 1).get(), 1e-5);
    EXPECT_LE(std::max(found.at_most[0], found.at_most[1]), 1e-5 + 1e-11);
}

namespace {

Handle turned(const nurbs *g, int axis) {
    return made([&](nurbs **out) { return nurbs_reverse(g, axis, 0, out); });
}
Handle over(const nurbs *g, int axis, double lower, double upper) {
    return made([&](nurbs **out) { return nurbs_reparametrize(g, axis, lower, upper, out); });
}
Handle refined(const nurbs *g, int axis, double share) {
    double ends[2] = {0, 0};
    require_ok(nurbs_domain(g, axis, ends));
    return insert(elevate(g, axis, 1).get(), axis, ends[0] + share * (ends[1] - ends[0]), 1);
}

// The same set in other words: degrees, knots, directions, domains and the order of the axes.
std::vector<Handle> retold(const nurbs *g, int axes) {
    std::vector<Handle> all;
    all.push_back(made([&](nurbs **out) { return nurbs_make_rational(g, out); }));
    for (int k = 0; k < axes; ++k) {
        all.push_back(elevate(g, k, 1));
        all.push_back(turned(g, k));
        all.push_back(over(g, k, -3, 17));
        all.push_back(over(turned(refined(g, k, 0.37).get(), k).get(), k, 5, 5.5));
    }
    for (const std::vector<int32_t> &order :
         std::vector<std::vector<int32_t>>{{1, 0}, {2, 0, 1}, {1, 0, 2}}) {
        if (std::ssize(order) == axes) {
            all.push_back(made([&](nurbs **out) { return nurbs_transpose(g, order.data(), out); }));
            all.push_back(turned(refined(all.back().get(), 0, 0.61).get(), axes - 1));
        }
    }
    return all;
}

SplineData in_dimension(SplineData data, int dim) {
    for (int64_t i = 0; i < std::ssize(data.points) / 3; ++i) {
        std::copy_n(data.points.begin() + 3 * i, dim, data.points.begin() + dim * i);
    }
    data.points.resize(data.points.size() / 3 * static_cast<size_t>(dim));
    data.dim = dim;
    return data;
}

} // namespace

// Products with a weight that underflows have lost the point; its curve passes through it all the same.
TEST(Distance, of_a_point_whose_weight_underflows) {
    Random random(6608);
    for (int i = 0; i < 100; ++i) {
        SplineData curve = random_net(random, 1, 2, 3, 0, false);
        curve.weights = {std::ldexp(1.0, -random.whole(1000, 1070)), 1, 1};
        SplineData line = curve;
        line.weights.clear();
        line.degrees = {1};
        line.counts = {2};
        line.knots = {{0, 0, 1, 1}};
        line.points.resize(static_cast<size_t>(2 * line.dim));
        for (size_t c = 0; c < static_cast<size_t>(line.dim); ++c) {
            const double aside = random.between(-1, 1);
            line.points[c] -= aside;
            line.points[static_cast<size_t>(line.dim) + c] = curve.points[c] + aside;
        }
        const Handle f = create(curve), g = create(line);
        double at_least = 0, at_most = 0;
        require_ok(
            nurbs_distance(f.get(), g.get(), 1e-9, 300, &at_least, &at_most, nullptr, nullptr, nullptr));
        EXPECT_LE(at_least, 1e-12) << describe(curve);
    }
}

// Whatever the tolerance and however a shape folds over itself: with a budget that no search gets along with.
TEST(Hausdorff, the_same_set_is_told_at_once) {
    Random random(6606);
    for (int i = 0; i < support::scaled(12); ++i) {
        const int axes = 1 + i % 3;
        const SplineData data = in_dimension(random_net(random, axes, random.whole(1, axes == 3 ? 2 : 4),
                                                        random.whole(5, 6), 0, random.chance(50)),
                                             random.whole(1, 3));
        const Handle g = create(data), copy = create(data);
        for (const double tolerance : {0.0, 0.1}) {
            for (const nurbs *h :
                 {static_cast<const nurbs *>(g.get()), static_cast<const nurbs *>(copy.get())}) {
                const Two same = hausdorff(g.get(), h, tolerance, 1);
                EXPECT_EQ(same.status, NURBS_CLOSEST_CERTIFIED);
                EXPECT_EQ(std::max(same.at_most[0], same.at_most[1]), 0);
            }
            for (const Handle &h : retold(g.get(), axes)) {
                for (const auto &[a, b] : {std::pair(g.get(), h.get()), std::pair(h.get(), g.get())}) {
                    const Two found = hausdorff(a, b, tolerance, 2000);
                    EXPECT_EQ(found.status, NURBS_CLOSEST_CERTIFIED) << describe(data);
                    EXPECT_EQ(std::max(found.at_least[0], found.at_least[1]), 0);
                    EXPECT_LE(std::max(found.at_most[0], found.at_most[1]), tolerance + 1e-11)
                        << describe(data);
                }
            }
        }
    }
}

// A part, in its own words, of a shape that has knots elsewhere: all of it is near at once, and what is left
// out is far.
TEST(Hausdorff, a_part_is_told_at_once) {
    Random random(6607);
    for (int i = 0; i < 16; ++i) {
        const int axes = 1 + i % 2;
        const Handle g =
            create(random_net(random, axes, random.whole(2, 3), random.whole(6, 9), 0, random.chance(50)));
        std::vector<double> lower, upper;
        for (int k = 0; k < axes; ++k) {
            double ends[2] = {0, 0};
            require_ok(nurbs_domain(g.get(), k, ends));
            lower.push_back(ends[0] + 0.2 * (ends[1] - ends[0]));
            upper.push_back(ends[0] + 0.7 * (ends[1] - ends[0]));
        }
        const Handle part =
            made([&](nurbs **out) { return nurbs_extract(g.get(), lower.data(), upper.data(), out); });
        const Handle other = over(turned(refined(part.get(), 0, 0.4).get(), axes - 1).get(), 0, 0, 1);
        for (const nurbs *h : {part.get(), other.get()}) {
            const Two found = hausdorff(h, g.get(), 1e-12, 200);
            EXPECT_LE(found.at_most[0], 1e-11);
            EXPECT_GT(found.at_most[1], 1e-3);
        }
    }
}

TEST(Hausdorff, no_sample_is_farther) {
    Random random(6605);
    for (int i = 0; i < 20; ++i) {
        const int first = random.whole(1, 2), second = random.whole(1, 2);
        const SplineData a =
            random_net(random, first, random.whole(1, 3), random.whole(4, 6), 0, random.chance(50));
        const SplineData b =
            random_net(random, second, random.whole(1, 3), random.whole(4, 6), 0.7, random.chance(50));
        const Handle f = create(a), g = create(b);
        const Two found = hausdorff(f.get(), g.get(), 1e-4);
        EXPECT_EQ(found.status, NURBS_CLOSEST_CERTIFIED)
            << first << second << ' ' << found.at_least[0] << ' ' << found.at_most[0] << ' '
            << found.at_least[1] << ' ' << found.at_most[1];
        const std::vector<double> x = samples(random, a, f.get(), 200);
        std::vector<double> distances(200);
        require_ok(nurbs_closest_points(g.get(), 200, x.data(), 0, 0, nullptr, 1e-9, 0, nullptr, 0, 0,
                                        nullptr, 0, 0, distances.data(), 0, nullptr, 0));
        EXPECT_LE(*std::ranges::max_element(distances), found.at_most[0]);
        const std::vector<double> far = eval(f.get(), {found.a.begin(), found.a.begin() + first});
        double distance = 0;
        require_ok(nurbs_closest_points(g.get(), 1, far.data(), 0, 0, nullptr, 1e-9, 0, nullptr, 0, 0,
                                        nullptr, 0, 0, &distance, 0, nullptr, 0));
        EXPECT_GE(distance, found.at_least[0] - 1e-12);
        EXPECT_LE(found.at_least[0], found.at_most[0]);
    }
}

// Matched pieces prove what boxes cannot, at high degrees too.
TEST(Distance, solids_of_high_degree_are_compared) {
    SplineData solid;
    solid.degrees = {10, 10, 10};
    solid.dim = 3;
    solid.counts = {11, 11, 11};
    std::vector<double> knots(11, 0.0);
    knots.insert(knots.end(), 11, 1.0);
    solid.knots = {knots, knots, knots};
    for (int i = 0; i < 1331; ++i) {
        for (const int step : {121, 11, 1}) {
            solid.points.push_back((i / step % 11) / 10.0 + (i == 665 ? 0.01 : 0));
        }
    }
    SplineData moved = solid;
    for (double &x : moved.points) {
        x += 1e-5;
    }
    const Two found = hausdorff(create(solid).get(), create(moved).get(), 1e-3);
    EXPECT_EQ(found.status, NURBS_CLOSEST_CERTIFIED);
    EXPECT_LE(found.at_most[0], 1e-3);
}

} // namespace distance_test
