// Laws of curves projected normally onto surfaces: all orthogonal feet, each on one branch.
#include "critical_points.h"
#include "crossings.h"
#include "faces.h"
#include "made_shapes.h"
#include "support/scale.h"

#include <numbers>

namespace normal_projection {

using namespace surface_crossings;

namespace {

constexpr double pi = std::numbers::pi;

struct Subject {
    const nurbs *g, *curve;
    Place domain{}; // of the curve
    std::array<Place, 2> sides{};

    Subject(const nurbs *surface, const nurbs *line) : g(surface), curve(line) {
        require_ok(nurbs_domain(curve, 0, domain.data()));
        for (int32_t k = 0; k < 2; ++k) {
            require_ok(nurbs_domain(g, k, sides[static_cast<size_t>(k)].data()));
        }
    }
};

Crossing projection(const nurbs *g, const nurbs *curve, double tolerance = 1e-6) {
    nurbs_meet *meet = nullptr;
    require_ok(nurbs_surface_project_curve(g, curve, nullptr, tolerance, &meet));
    return crossing_in(MeetHandle(meet).get());
}
Crossing projection(const Subject &s, double tolerance = 1e-6) {
    return projection(s.g, s.curve, tolerance);
}

Handle polyline(const std::vector<Point3> &points) {
    SplineData data{{1}, {std::ssize(points)}, {{0}}, 3, {}, {}, 0};
    for (size_t i = 0; i < points.size(); ++i) {
        data.points.insert(data.points.end(), points[i].begin(), points[i].end());
        data.knots[0].push_back(static_cast<double>(i));
    }
    data.knots[0].push_back(static_cast<double>(points.size() - 1));
    return create(data);
}

SplineData any_curve(Random &random) {
    const int degree = random.whole(1, 4), spans = random.whole(1, 4), count = degree + spans;
    SplineData data{{degree}, {count}, {{}}, 3, {}, {}, 0};
    const bool rational = random.chance(40);
    for (int i = 0; i < count; ++i) {
        data.points.insert(data.points.end(),
                           {random.between(-1, 1), random.between(-1, 1), random.between(-0.5, 0.8)});
        if (rational) {
            data.weights.push_back(random.between(0.5, 2));
        }
    }
    for (int i = 0; i < count + degree + 1; ++i) {
        data.knots[0].push_back(std::clamp(i - degree, 0, spans));
    }
    return data;
}

SplineData any_surface(Random &random, int least_degree = 2) {
    const std::array<int, 2> degrees{random.whole(least_degree, 3), random.whole(least_degree, 3)};
    const std::array<int, 2> counts{degrees[0] + random.whole(1, 3), degrees[1] + random.whole(1, 3)};
    return net_of(counts, degrees, random.chance(40), [&](double u, double v) {
        return std::array<double, 4>{2 * u - 1 + random.between(-0.15, 0.15),
                                     2 * v - 1 + random.between(-0.15, 0.15), random.between(-0.6, 0.6),
                                     random.between(0.6, 1.7)};
    });
}

Point3 minus(const Point3 &a, const Point3 &b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
double length(const Point3 &a) {
    return std::hypot(a[0], a[1], a[2]);
}

// S, S_v, S_u, one after the other as nurbs_eval_derivs() gives them.
std::array<Point3, 3> jet(const nurbs *g, Place at, const std::array<Place, 2> &sides) {
    for (size_t k = 0; k < 2; ++k) {
        at[k] = std::clamp(at[k], sides[k][0], sides[k][1]);
    }
    std::array<Point3, 3> result{};
    require_ok(nurbs_eval_derivs(g, 1, 1, at.data(), 0, 0, result.front().data(), 0, 0, 0));
    return result;
}

struct Sample {
    Place on;   // u, v
    Place of;   // t, h
    Point3 x;   // in space
    double off; // deviation
};
std::vector<Sample> samples_of(const Crossing &found, int n) {
    std::vector<Sample> samples;
    for (size_t i = 0; i < found.found.branches.size(); ++i) {
        const Branch &branch = found.found.branches[i];
        const std::vector<double> at = branch.params(n);
        const std::vector<Place> on = places_on(branch.on.get(), at),
                                 of = places_on(found.on_second[i].get(), at);
        const std::vector<Point3> x = points_on(branch.space.get(), at);
        for (size_t k = 0; k < at.size(); ++k) {
            samples.push_back({on[k], of[k], x[k], branch.deviation});
        }
    }
    return samples;
}

// What branches promise at each place: points and distances to within the deviation, and right angles to within what it makes of
// them where bends are of the order of 1.
void check_feet(const Crossing &found, const Subject &s, double most_deviation, int n = 1000) {
    for (const Sample &sample : samples_of(found, n)) {
        ASSERT_TRUE(sample.off <= most_deviation);
        ASSERT_TRUE(sample.of[0] >= s.domain[0] && sample.of[0] <= s.domain[1]);
        const auto [at, by_one, by_two] = jet(s.g, sample.on, s.sides);
        const Point3 c = points_on(s.curve, {sample.of[0]})[0], way = minus(at, c);
        EXPECT_LE(distance(at, sample.x), 2 * sample.off + 1e-14);
        EXPECT_LE(std::abs(length(way) - std::abs(sample.of[1])), 3 * sample.off + 1e-14);
        const double room = 100 * sample.off * (1 + length(way)) + 1e-13;
        for (const Point3 &slope : {by_one, by_two}) {
            EXPECT_LE(std::abs(dot(way, slope)), room * length(slope));
        }
    }
}

// Places of a branch along which t rises, or that it has at t to within its ends.
bool places_at(const Crossing &found, const Subject &s, double t, std::vector<Place> &places) {
    for (size_t i = 0; i < found.found.branches.size(); ++i) {
        const nurbs *of = found.on_second[i].get();
        auto [a, b] = found.found.branches[i].domain;
        const double first = places_on(of, {a})[0][0], last = places_on(of, {b})[0][0];
        const double near = 1e-4 * (s.domain[1] - s.domain[0]);
        if (std::abs(first - t) < near || std::abs(last - t) < near) {
            return false;
        }
        if (first > t || last < t) {
            continue;
        }
        for (int k = 0; k < 60; ++k) {
            const double middle = a / 2 + b / 2;
            (places_on(of, {middle})[0][0] < t ? a : b) = middle;
        }
        places.push_back(places_on(found.found.branches[i].on.get(), {a})[0]);
    }
    return true;
}

// The places inside of a surface at which the distance from a point is critical; false: not all are known, or one is near a side.
bool critical_places(const Subject &s, const Point3 &x, std::vector<Place> &places) {
    const Critical all = critical(s.g, {x[0], x[1], x[2]}, 1e-9);
    if ((all.status & NURBS_CLOSEST_CERTIFIED) == 0) {
        return false;
    }
    for (size_t i = 0; i < all.distances.size(); ++i) {
        const Place at{all.params[2 * i], all.params[2 * i + 1]};
        bool inside = true;
        for (size_t k = 0; k < 2; ++k) {
            const double from = std::min(at[k] - s.sides[k][0], s.sides[k][1] - at[k]),
                         near = 1e-3 * (s.sides[k][1] - s.sides[k][0]);
            inside = inside && from > 0;
            if (from > 0 && from < near) {
                return false;
            }
        }
        if (inside) {
            places.push_back(at);
        }
    }
    return true;
}

// Whether it could be compared.
bool compare_at(const Crossing &found, const Subject &s, double t) {
    std::vector<Place> places, expected;
    if (!critical_places(s, points_on(s.curve, {t})[0], expected) || !places_at(found, s, t, places)) {
        return false;
    }
    EXPECT_EQ(places.size(), expected.size()) << "t = " << t;
    for (const Place &at : expected) {
        const auto is_near = [&](const Place &x) { return std::hypot(x[0] - at[0], x[1] - at[1]) < 2e-3; };
        EXPECT_EQ(std::ranges::count_if(places, is_near), 1) << "t = " << t << ' ' << at[0] << ' ' << at[1];
    }
    return true;
}

TEST(NormalProjection, AllCriticalPointsAreOnOneBranch) {
    Random random(0x9d01);
    int64_t compared = 0, complete = 0, folds = 0, branches = 0;
    const int64_t cases = scaled(100);
    for (int64_t i = 0; i < cases; ++i) {
        SCOPED_TRACE(i);
        const Handle g = create(any_surface(random)), curve = create(any_curve(random));
        const Subject s(g.get(), curve.get());
        const Crossing found = projection(s);
        check_feet(found, s, 1e-6, 50);
        if (!found.found.complete) {
            continue;
        }
        ++complete;
        folds += found.found.count(NURBS_NODE_FOLD);
        branches += std::ssize(found.found.branches);
        for (int k = 0; k < 5; ++k) {
            compared += compare_at(found, s, random.between(s.domain[0], s.domain[1])) ? 1 : 0;
        }
    }
    EXPECT_GE(complete, cases * 9 / 10);
    EXPECT_GE(compared, complete * 4);
    EXPECT_GE(branches, cases / 2);
    EXPECT_GE(folds, cases / 8);
}

TEST(NormalProjection, BicubicPatches) {
    Random random(0x9d02);
    for (int64_t i = 0; i < std::max<int64_t>(scaled(5), 1); ++i) {
        SCOPED_TRACE(i);
        const Handle g = create(net_of({10, 10}, {3, 3}, false, [&](double u, double v) {
            return std::array<double, 4>{
                u, v, 0.1 * std::sin(5 * u) * std::cos(4 * v) + random.between(-0.01, 0.01), 1};
        }));
        SplineData line{{3}, {13}, {{0, 0, 0}}, 3, {}, {}, 0};
        for (int k = 0; k < 13; ++k) {
            line.points.insert(line.points.end(),
                               {k / 12.0, 0.5 + 0.4 * std::sin(k / 2.0), random.between(0.05, 0.4)});
            line.knots[0].push_back(std::clamp(k, 0, 10));
        }
        line.knots[0].insert(line.knots[0].end(), {10});
        line.knots[0] = {0, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 10, 10, 10};
        const Handle curve = create(line);
        const Subject s(g.get(), curve.get());
        const Crossing found = projection(s);
        EXPECT_TRUE(found.found.complete);
        check_feet(found, s, 1e-6);
        for (int k = 0; k < 20; ++k) {
            compare_at(found, s, random.between(s.domain[0], s.domain[1]));
        }
    }
}

// Onto a plane it is what the projection along its normal is.
TEST(NormalProjection, Planes) {
    Random random(0x9d03);
    for (int64_t i = 0; i < scaled(20); ++i) {
        SCOPED_TRACE(i);
        const Handle g = create(net_of({4, 3}, {3, 2}, false, [&](double u, double v) {
            return std::array<double, 4>{3 * u - 1.5, 3 * v - 1.5, 0.25, 1};
        }));
        const Handle curve = create(any_curve(random));
        const Subject s(g.get(), curve.get());
        const Crossing found = projection(s, 1e-9);
        const Point3 up{0, 0, 1};
        nurbs_meet *meet = nullptr;
        require_ok(nurbs_surface_project_curve(s.g, s.curve, up.data(), 1e-9, &meet));
        const Crossing along = crossing_in(MeetHandle(meet).get());
        ASSERT_TRUE(found.found.complete && along.found.complete);
        ASSERT_EQ(found.found.branches.size(), along.found.branches.size());
        EXPECT_NEAR(length_of(found.found), length_of(along.found), 1e-6);
        for (const Sample &sample : samples_of(found, 100)) {
            const Point3 c = points_on(s.curve, {sample.of[0]})[0];
            EXPECT_LE(std::hypot(sample.x[0] - c[0], sample.x[1] - c[1], sample.x[2] - 0.25), 3e-9);
            EXPECT_NEAR(sample.of[1], 0.25 - c[2], 3e-9);
        }
    }
}

Handle sphere(const Point3 &axis) {
    const double centre[] = {0, 0, 0};
    return made([&](nurbs **out) {
        return nurbs_surface_sphere(centre, axis.data(), nullptr, 1, NURBS_ARC_QUARTERS, out);
    });
}

// +-C / |C|, whatever axis the poles are on, if curves do not pass them.
TEST(NormalProjection, Spheres) {
    for (const Point3 &axis : {Point3{0, 1, 0}, Point3{1, 2, 3}}) {
        const Handle g = sphere(axis);
        for (const Handle &curve : {polyline({{-2, 0.28, 3}, {2, 0.3, 3}}),
                                    polyline({{-0.3, 0.28, 0.1}, {0.2, 0.3, 0.4}, {0.5, 0.1, -0.2}})}) {
            const Subject s(g.get(), curve.get());
            const Crossing found = projection(s, 1e-8);
            EXPECT_TRUE(found.found.complete);
            double projected = 0;
            for (const Sample &sample : samples_of(found, 200)) {
                const Point3 c = points_on(s.curve, {sample.of[0]})[0];
                const double side = dot(c, sample.x) > 0 ? 1 : -1, size = length(c);
                const Point3 foot{side * c[0] / size, side * c[1] / size, side * c[2] / size};
                EXPECT_LE(distance(foot, sample.x), 1e-7 / size);
                EXPECT_NEAR(std::abs(sample.of[1]), std::abs(size - side), 1e-7);
            }
            for (size_t i = 0; i < found.on_second.size(); ++i) {
                const auto [a, b] = found.found.branches[i].domain;
                projected += places_on(found.on_second[i].get(), {b})[0][0] -
                             places_on(found.on_second[i].get(), {a})[0][0];
            }
            EXPECT_NEAR(projected, 2 * (s.domain[1] - s.domain[0]), 1e-7);
        }
    }
}

// Four feet over each parameter of a curve away from the axis and from the middle circle; two sheets of a cylinder.
TEST(NormalProjection, ToriAndCylinders) {
    const double centre[] = {0, 0, 0}, up[] = {0, 0, 1};
    const Handle torus = made([&](nurbs **out) {
        return nurbs_surface_torus(centre, up, nullptr, 3, 1, 0, 2 * pi, 0, 2 * pi, NURBS_ARC_QUARTERS, out);
    });
    const Handle tube = made([&](nurbs **out) {
        return nurbs_surface_cylinder(centre, up, nullptr, 1, 2, 0, 2 * pi, NURBS_ARC_QUARTERS, out);
    });
    const Handle curve = polyline({{-2, 0.3, 0.2}, {4, 0.5, 1.4}}),
                 near = polyline({{-2, 0.3, 0.2}, {2, 0.5, 1.4}});
    const Subject on_torus(torus.get(), curve.get()), on_tube(tube.get(), near.get());
    const Crossing four = projection(on_torus, 1e-7), two = projection(on_tube, 1e-8);
    EXPECT_TRUE(four.found.complete && two.found.complete);
    check_feet(four, on_torus, 1e-7, 200);
    check_feet(two, on_tube, 1e-8, 200);
    EXPECT_EQ(four.open_ways, 4);
    EXPECT_EQ(two.open_ways, 2);
    for (const double t : {0.1, 0.37, 0.93}) {
        std::vector<Place> on_four, on_two;
        EXPECT_TRUE(places_at(four, on_torus, t, on_four) && places_at(two, on_tube, t, on_two));
        EXPECT_EQ(on_four.size(), 4U);
        EXPECT_EQ(on_two.size(), 2U);
    }
}

// A curve on the surface is its own projection, inside and along its sides; and so it is a little beside it.
TEST(NormalProjection, CurvesOnTheSurface) {
    Random random(0x9d04);
    for (int64_t i = 0; i < scaled(4); ++i) {
        SCOPED_TRACE(i);
        const Handle g = create(any_surface(random));
        for (const double at : {0.0, 0.5, 1.0, random.between(0, 1)}) {
            for (const int32_t axis : {0, 1}) {
                const Handle own = made([&](nurbs **out) { return nurbs_iso(g.get(), axis, at, 0, out); });
                const Subject s(g.get(), own.get());
                const Crossing found = projection(s);
                EXPECT_TRUE(found.found.complete) << at << ' ' << axis;
                double on = 0;
                for (size_t b = 0; b < found.on_second.size(); ++b) {
                    const auto [low, high] = found.found.branches[b].domain;
                    const Place first = places_on(found.on_second[b].get(), {low})[0],
                                last = places_on(found.on_second[b].get(), {high})[0],
                                middle = places_on(found.on_second[b].get(), {low / 2 + high / 2})[0];
                    on += std::abs(middle[1]) < 1e-6 ? last[0] - first[0] : 0;
                }
                EXPECT_NEAR(on, s.domain[1] - s.domain[0], 1e-6) << at << ' ' << axis;
            }
        }
    }
}

// Where feet leave the surface they end at its border.
TEST(NormalProjection, PastTheBorder) {
    const Handle g = create(net_of({3, 3}, {2, 2}, false, [](double u, double v) {
        return std::array<double, 4>{2 * u - 1, 2 * v - 1, 0, 1};
    }));
    const Handle line = polyline({{-2, -0.5, 1}, {2, 0.5, 1}});
    const Subject s(g.get(), line.get());
    const Crossing found = projection(s, 1e-9);
    EXPECT_TRUE(found.found.complete);
    ASSERT_EQ(found.found.branches.size(), 1U);
    EXPECT_EQ(found.found.count(NURBS_NODE_BORDER), 2);
    check_nodes(found, 1e-9);
    EXPECT_NEAR(places_on(found.on_second[0].get(), {found.found.branches[0].domain[0]})[0][0], 0.25, 1e-9);
    EXPECT_NEAR(places_on(found.on_second[0].get(), {found.found.branches[0].domain[1]})[0][0], 0.75, 1e-9);
}

void expect_alike(const Crossing &a, const Crossing &b, double scale = 1) {
    EXPECT_EQ(a.found.complete, b.found.complete);
    EXPECT_EQ(a.found.branches.size(), b.found.branches.size());
    EXPECT_EQ(a.found.count(NURBS_NODE_FOLD), b.found.count(NURBS_NODE_FOLD));
    EXPECT_NEAR(scale * length_of(a.found), length_of(b.found), 1e-4 * scale * (1 + length_of(a.found)));
}

// Exchanged axes, more knots, a higher degree, curves backwards and another size change nothing.
TEST(NormalProjection, OtherFormsOfTheSame) {
    Random random(0x9d05);
    int64_t compared = 0;
    const int64_t cases = scaled(8);
    for (int64_t i = 0; i < cases; ++i) {
        SCOPED_TRACE(i);
        const SplineData surface = any_surface(random), line = any_curve(random);
        const Handle g = create(surface), curve = create(line);
        const Crossing one = projection(g.get(), curve.get());
        if (!one.found.complete) {
            continue;
        }
        ++compared;
        const int32_t exchanged[] = {1, 0};
        const Handle turned = made([&](nurbs **out) { return nurbs_transpose(g.get(), exchanged, out); }),
                     finer = made([&](nurbs **out) { return nurbs_refine_uniform(g.get(), 1, 2, out); }),
                     higher = made([&](nurbs **out) { return nurbs_elevate(g.get(), 0, 1, out); }),
                     backwards = made([&](nurbs **out) { return nurbs_reverse(curve.get(), 0, 0, out); });
        for (const Handle *other : {&turned, &finer, &higher}) {
            expect_alike(one, projection(other->get(), curve.get()));
        }
        expect_alike(one, projection(g.get(), backwards.get()));
        SplineData large = surface, long_line = line;
        for (SplineData *data : {&large, &long_line}) {
            for (double &x : data->points) {
                x *= 0x1p20;
            }
        }
        const Handle big = create(large), big_curve = create(long_line);
        const Crossing scaled_up = projection(big.get(), big_curve.get(), 0x1p20 * 1e-6);
        expect_alike(one, scaled_up, 0x1p20);
        for (size_t k = 0; k < std::min(one.found.branches.size(), scaled_up.found.branches.size()); ++k) {
            EXPECT_EQ(one.found.branches[k].deviation * 0x1p20, scaled_up.found.branches[k].deviation);
        }
    }
    EXPECT_GE(compared, cases * 8 / 10);
}

// A limit of work leaves open what is not found, and all that is found is right.
TEST(NormalProjection, LimitsOfWork) {
    Random random(0x9d06);
    nurbs_call_options call;
    require_ok(nurbs_call_options_init(&call, sizeof call));
    for (int64_t i = 0; i < scaled(10); ++i) {
        SCOPED_TRACE(i);
        const Handle g = create(any_surface(random)), curve = create(any_curve(random));
        const Subject s(g.get(), curve.get());
        const Crossing all = projection(s);
        for (const int64_t work : {1, 10, 100, 10000, 1000000}) {
            call.work = work;
            nurbs_meet *meet = nullptr;
            require_ok(nurbs_surface_project_curve_with(s.g, s.curve, nullptr, 1e-6, &call, &meet));
            const Crossing some = crossing_in(MeetHandle(meet).get());
            if (some.found.complete) {
                EXPECT_EQ(some.found.branches.size(), all.found.branches.size());
                continue;
            }
            EXPECT_GE(some.found.count(NURBS_NODE_UNDECIDED), 1);
            EXPECT_TRUE(work > 100 || some.found.branches.empty());
        }
    }
}

// Of curves through centres whole circles, or all of a sphere, are feet: told, without the answer taking long.
TEST(NormalProjection, FeetThatFillRegions) {
    const double centre[] = {0, 0, 0}, up[] = {0, 0, 1};
    const Handle tube = made([&](nurbs **out) {
        return nurbs_surface_cylinder(centre, up, nullptr, 1, 2, 0, 2 * pi, NURBS_ARC_QUARTERS, out);
    });
    const Handle ball = sphere({0, 1, 0}), along = polyline({{0, 0, 0.2}, {0, 0, 1.4}}),
                 across = polyline({{-0.3, 0, 0.2}, {0.5, 0, 1.4}}),
                 point = polyline({{0, 0, 0.5}, {0, 0, 0.5}}), centres = polyline({{0, 0, 0}, {0, 0, 0}});
    for (const Handle *curve : {&along, &across, &point}) {
        const Crossing found = projection(tube.get(), curve->get());
        EXPECT_FALSE(found.found.complete);
        EXPECT_GE(found.found.count(NURBS_NODE_UNDECIDED), 1);
    }
    for (const Handle *curve : {&across, &centres}) {
        const Crossing found = projection(ball.get(), curve->get());
        EXPECT_EQ(found.found.complete, curve == &across);
    }
}

// Where weights are not certainly positive, neither the surface nor the curve has bounds there: what they have
// in common is left open, and no touch, however large the tolerance is.
TEST(NormalProjection, PartsWithoutBoundsAreLeftOpen) {
    std::vector<double> plane, line;
    for (const double x : {0.0, 0.5, 1.0}) {
        const double w = x == 0.5 ? -0.2 : 1;
        plane.insert(plane.end(), {w * x, 0, 0, w, w * x, w, 0, w});
        line.insert(line.end(), {w * x, w * (0.2 + x / 2), w, w});
    }
    const std::array<int32_t, 2> degrees{2, 1};
    const std::array<int64_t, 2> counts{3, 2};
    const std::array<double, 10> knots{0, 0, 0, 1, 1, 1, 0, 0, 1, 1};
    const Handle g = made([&](nurbs **out) {
        return nurbs_create_homogeneous(2, degrees.data(), counts.data(), knots.data(), 10, 3, plane.data(),
                                        0, 0, 0, out);
    });
    const Handle curve = made([&](nurbs **out) {
        return nurbs_create_homogeneous(1, degrees.data(), counts.data(), knots.data(), 6, 3, line.data(), 0,
                                        0, 0, out);
    });
    for (const double tolerance : {1e-9, 1e-3, 10.0}) {
        const Crossing found = projection(g.get(), curve.get(), tolerance);
        EXPECT_FALSE(found.found.complete);
        EXPECT_EQ(found.found.count(NURBS_NODE_TOUCH), 0);
        EXPECT_GE(found.found.count(NURBS_NODE_UNDECIDED), 1);
    }
}

// In a centre of curvature in the plane of symmetry of a trough two more branches begin: all of them meet in one small part.
TEST(NormalProjection, BranchesThatMeet) {
    const Handle g = create(quadratic_graph(0.5, 0, 0, 0, -1, -1)),
                 line = polyline({{0, 0.1, 0.2}, {0, 0.3, 1.4}});
    const Subject s(g.get(), line.get());
    const Crossing found = projection(s);
    check_feet(found, s, 1e-6, 200);
    ASSERT_EQ(found.found.branches.size(), 4U);
    EXPECT_EQ(found.found.count(NURBS_NODE_BORDER), 4);
    ASSERT_EQ(found.found.nodes.size(), 5U);
    for (size_t i = 0; i < 5; ++i) {
        if (found.found.nodes[i].kind != NURBS_NODE_BORDER) {
            const std::array<Place, 2> &range = found.found.nodes[i].range;
            EXPECT_LE(std::max(range[0][1] - range[0][0], range[1][1] - range[1][0]), 1e-2);
            EXPECT_NEAR(found.on_b[i].at[0], 2.0 / 3, 1e-2);
        }
    }
}

// A foot at a pole is one place, at which the branch may end and go on; sides of one point are not feet by themselves.
TEST(NormalProjection, Poles) {
    const Handle ball = sphere({0, 0, 1});
    const Handle beside = polyline({{-1, 0.001, 3}, {1, 0.002, 3}}), over = polyline({{-1, 0, 3}, {1, 0, 3}});
    const Crossing near = projection(ball.get(), beside.get());
    EXPECT_TRUE(near.found.complete);
    EXPECT_EQ(near.open_ways, 2);
    const Crossing through = projection(ball.get(), over.get());
    double projected = 0;
    for (size_t i = 0; i < through.on_second.size(); ++i) {
        const auto [a, b] = through.found.branches[i].domain;
        projected += places_on(through.on_second[i].get(), {b})[0][0] -
                     places_on(through.on_second[i].get(), {a})[0][0];
    }
    EXPECT_NEAR(projected, 2, 1e-3); // what is beside the poles is left open
    for (const Sample &sample : samples_of(through, 50)) {
        EXPECT_NEAR(length(sample.x), 1, 1e-5);
    }
}

// At a crease feet of either side end: between them the crease is nearest, and no foot.
TEST(NormalProjection, Creases) {
    SplineData roof{{1, 1}, {3, 2}, {{0, 0, 1, 2, 2}, {0, 0, 1, 1}}, 3, {}, {}, 0};
    roof.points = {-1, 0, 0, -1, 2, 0, 0, 0, 1, 0, 2, 1, 1, 0, 0, 1, 2, 0};
    const Handle g = create(roof), line = polyline({{-2, 0.5, 2}, {2, 1, 2}});
    const Subject s(g.get(), line.get());
    const Crossing found = projection(s, 1e-9);
    EXPECT_TRUE(found.found.complete);
    ASSERT_EQ(found.found.branches.size(), 2U); // |x| > 1 above, from the ridge at |x| = z - 1
    EXPECT_EQ(found.found.count(NURBS_NODE_BORDER), 4);
    for (const Sample &sample : samples_of(found, 20)) {
        const double x = points_on(line.get(), {sample.of[0]})[0][0];
        EXPECT_GE(std::abs(x), 1 - 1e-8);
    }
}

// Corners of curves are corners of branches, and closed curves close.
TEST(NormalProjection, KinksAndClosedCurves) {
    const Handle g = create(quadratic_graph(0.2, 0, -0.1, 0, -1, -1)),
                 square = polyline(
                     {{-0.5, -0.5, 1}, {0.5, -0.5, 1}, {0.5, 0.5, 1}, {-0.5, 0.5, 1}, {-0.5, -0.5, 1}});
    const Subject s(g.get(), square.get());
    const Crossing found = projection(s);
    EXPECT_TRUE(found.found.complete);
    check_feet(found, s, 1e-6, 200);
    EXPECT_EQ(found.open_ways + found.closed_ways, 1);
}

// What of the feet is inside of a face.
TEST(NormalProjection, OntoFaces) {
    Random random(0x9d07);
    int64_t cut = 0;
    const int64_t cases = scaled(6);
    for (int64_t i = 0; i < cases; ++i) {
        SCOPED_TRACE(i);
        const faces::Ground ground = faces::wavy(random);
        const Handle loop = create(faces::any_star(random, ground));
        const faces::Face face = faces::face_of(ground.surface.get(), {{loop.get()}});
        SplineData line = any_curve(random);
        for (double &x : line.points) {
            x += 0.5;
        }
        const Handle curve = create(line);
        const Subject s(ground.surface.get(), curve.get());
        nurbs_meet *meet = nullptr;
        require_ok(nurbs_face_project_curve(face.get(), curve.get(), nullptr, 1e-6, &meet));
        const Crossing found = crossing_in(MeetHandle(meet).get());
        cut += found.found.count(NURBS_NODE_BORDER);
        for (size_t b = 0; b < found.found.branches.size(); ++b) {
            const std::vector<double> at = found.found.branches[b].params(20);
            for (size_t k = 1; k + 1 < at.size(); ++k) {
                const Place on = places_on(found.found.branches[b].on.get(), {at[k]})[0];
                EXPECT_GE(faces::sides(face.get(), {on[0], on[1]})[0], 0);
            }
        }
        check_feet(found, s, 1e-6, 20);
    }
    EXPECT_GE(cut, cases / 2);
}

} // namespace

} // namespace normal_projection
