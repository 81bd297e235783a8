// Laws of the curves in which two surfaces meet.
#include "crossings.h"
#include "made_shapes.h"
#include "support/scale.h"

#include <numbers>

namespace surface_crossings {

namespace {

constexpr double pi = std::numbers::pi, tolerance = 1e-6;

SplineData ball(double r, const Point3 &centre) {
    return support::moved(revolved(ellipse_arc(0, 0, r, r, -pi / 2, pi), 0, 2 * pi), centre);
}
SplineData ring(double big, double small) {
    return revolved(ellipse_arc(big, 0, small, small, 0, 2 * pi), 0, 2 * pi);
}
SplineData tube(double r, double half) {
    return revolved(segment(r, -half, r, half), 0, 2 * pi);
}
SplineData flat(double z, double slope = 0) {
    return net_of({2, 2}, {1, 1}, false, [=](double u, double v) {
        return std::array<double, 4>{4 * u - 2, 4 * v - 2, z + slope * (4 * u - 2), 1};
    });
}

struct Counts {
    int64_t open, closed;
};
Crossing expect_complete(const SplineData &a, const SplineData &b, Counts expected, const std::string &name) {
    SCOPED_TRACE(name);
    const Handle first = create(a), second = create(b);
    Crossing crossing = crossing_of(first.get(), second.get(), tolerance);
    EXPECT_TRUE(crossing.found.complete);
    EXPECT_EQ(crossing.open_ways, expected.open);
    EXPECT_EQ(crossing.closed_ways, expected.closed);
    for (const Branch &branch : crossing.found.branches) {
        EXPECT_LE(branch.deviation, tolerance);
    }
    check_curves(crossing, Ground(first.get(), a), Ground(second.get(), b));
    check_nodes(crossing, 1e-9);
    return crossing;
}

TEST(SurfaceCrossings, KnownShapes) {
    expect_complete(tube(1, 3), turned(tube(0.6, 3)), {0, 2}, "cylinders of unequal radii");
    expect_complete(tube(1, 3), support::moved(turned(tube(0.6, 3)), {0, 0.7, 0}), {0, 1},
                    "one beside the axis of the other");
    expect_complete(ball(2, {0, 0, 0.01}), support::moved(tube(0.97, 3), {1, 0, 0}), {0, 2},
                    "all but Viviani's curve");
    expect_complete(ball(2, {0, 0, 0.01}), support::moved(tube(1.03, 3), {1, 0, 0}), {0, 1},
                    "the other side of it");
    expect_complete(ball(1, {3, 0, 0}), ring(3, 1.5), {0, 0}, "a ball in a ring");
    expect_complete(ball(1, {3.9, 0.1, 0.2}), ring(3, 0.5), {0, 1}, "a ball on a ring");
    expect_complete(ball(1.2, {3, 0.1, 0.05}), ring(3, 0.8), {0, 2}, "a ball around a ring");
    expect_complete(turned(tube(0.5, 6)), ring(3, 0.8), {0, 4}, "a rod through a ring");
    expect_complete(quadratic_graph(1, 0, -1, 0, -1, -1), flat(0.2), {2, 0}, "a saddle below a plane");
    expect_complete(quadratic_graph(1, 0, -1, 0, -1, -1), flat(-1e-4), {2, 0}, "a saddle above a plane");
}

// The plane through the axis z and the point (cos angle, sin angle, 0).
SplineData upright(double angle) {
    return net_of({2, 2}, {1, 1}, false, [=](double u, double v) {
        return std::array<double, 4>{(8 * u - 4) * std::cos(angle), (8 * u - 4) * std::sin(angle), 8 * v - 4,
                                     1};
    });
}
SplineData leaning(double slope) {
    return net_of({2, 2}, {1, 1}, false, [=](double u, double v) {
        return std::array<double, 4>{8 * u - 4, 8 * v - 4, slope * (8 * u - 4), 1};
    });
}
std::vector<Point3> points_on_surface(const nurbs *g, const std::vector<Place> &places) {
    std::vector<Point3> points(places.size());
    require_ok(nurbs_eval(g, std::ssize(places), places.front().data(), 0, 0, points.front().data(), 0, 0,
                          NURBS_ON_AXIS(0, NURBS_EXTRAPOLATE) | NURBS_ON_AXIS(1, NURBS_EXTRAPOLATE)));
    return points;
}
int64_t points_of(const Crossing &crossing) {
    int64_t sum = 0;
    for (const Branch &branch : crossing.found.branches) {
        int64_t count = 0;
        require_ok(nurbs_point_count(branch.space.get(), &count));
        sum += count;
    }
    return sum;
}

// Curves along knots, and near them, are found as others are, and once.
TEST(SurfaceCrossings, AlongKnots) {
    struct Case {
        SplineData a, b;
        Counts ways;
        double length;
        const char *name;
    };
    const SplineData globe = ball(1, {0, 0, 0}),
                     plane_of_knots = net_of({20, 20}, {3, 3}, false, [](double u, double v) {
                         return std::array<double, 4>{4 * u - 2, 4 * v - 2, 0, 1};
                     });
    std::vector<Case> cases{
        {globe, plane_of_knots, {0, 1}, 2 * pi, "a plane of many pieces"},
        {globe, flat(1e-9 / 2, 1e-9), {0, 1}, 2 * pi, "a plane that leans a little"},
        {globe, flat(0, 1e-5), {0, 1}, 2 * pi, "a plane that leans more"},
        {ring(1.2, 0.5), flat(0), {0, 2}, 2 * pi * 2.4, "a ring around a plane"},
        {ring(2, 0.5), upright(0), {0, 2}, 2 * pi, "a ring through a plane"},
        {ring(2, 0.5), upright(1), {0, 2}, 2 * pi, "a ring through another one"},
        {tube(1, 3), upright(0), {2, 0}, 12, "a tube through a plane"},
        {ball(2, {0, 0, 0}), tube(1, 3), {0, 2}, 4 * pi, "a ball around a tube"},
        {ball(2, {0, 0, 0}), ring(2, 0.5), {0, 2}, 7.75 * pi, "a ball on a ring"},
        {globe, ball(std::sqrt(2), {0, 0, 1}), {0, 1}, 2 * pi, "a ball with the equator of another one"},
        {globe, ball(1.3, {0, 0, 1}), {0, 1}, 6.20725, "balls with one axis"}};
    for (const double z : {0.0, 1e-15, 1e-13, 1e-12, 4e-12, 1e-11, 1e-10, 1e-8, 1e-6, 1e-4}) {
        for (const double side : {-z, z}) {
            cases.push_back({globe, flat(side), {0, 1}, 2 * pi, "near the equator"});
        }
    }
    for (const Case &test : cases) {
        SCOPED_TRACE(test.b.points[2]);
        for (const bool exchanged : {false, true}) {
            const Crossing crossing = expect_complete(exchanged ? test.b : test.a,
                                                      exchanged ? test.a : test.b, test.ways, test.name);
            EXPECT_NEAR(length_of(crossing.found), test.length, 1e-4) << test.name;
            EXPECT_LE(points_of(crossing), 1000) << test.name;
        }
    }
}

// Deviations are true ones: circles about the axis z, which are known.
TEST(SurfaceCrossings, Deviations) {
    struct Case {
        SplineData a, b;
        double radius, height;
        bool touch = false;
    };
    std::vector<Case> cases{{ball(2, {0, 0, 0}), tube(1, 3), 1, std::sqrt(3.0)},
                            {ring(2, 0.5), ball(2, {0, 0, 0}), 1.9375, std::sqrt(0.25 - 0.0625 * 0.0625)},
                            {ball(1, {0, 0, 0}), tube(1, 3), 1, 0, true},
                            {ring(1.2, 0.5), flat(0.5), 1.2, 0.5, true}};
    for (const double z : {0.0, 1e-12, 4e-12, 1e-9, 0.3, 0.7, 0.99}) {
        cases.push_back({ball(1, {0, 0, 0}), flat(z), std::sqrt(1 - z * z), z});
        cases.push_back({tube(1, 3), flat(z), 1, z});
    }
    for (const Case &test : cases) {
        const Handle a = create(test.a), b = create(test.b);
        for (const double wanted : {1e-3, 1e-5, test.touch ? 1e-6 : 1e-8}) {
            const Crossing crossing = crossing_of(a.get(), b.get(), wanted);
            EXPECT_FALSE(crossing.found.branches.empty());
            for (size_t i = 0; i < crossing.found.branches.size(); ++i) {
                const Branch &branch = crossing.found.branches[i];
                const std::vector<double> t = branch.params(1000);
                const std::vector<Point3> on_a = points_on_surface(a.get(), places_on(branch.on.get(), t)),
                                          on_b = points_on_surface(b.get(),
                                                                   places_on(crossing.on_second[i].get(), t)),
                                          space = points_on(branch.space.get(), t);
                double most = 0;
                for (const auto *points : {&on_a, &on_b, &space}) {
                    for (const Point3 &x : *points) {
                        most = std::max(most, std::hypot(std::hypot(x[0], x[1]) - test.radius,
                                                         std::abs(x[2]) - test.height));
                    }
                }
                const bool touch =
                    crossing.kinds[i] == NURBS_BRANCH_TOUCH; // of which the place is known less well
                EXPECT_LE(most, (touch ? 2 : 1) * branch.deviation + 1e-14) << test.height << ", " << wanted;
            }
        }
    }
}

// Waves of height 0.2 cross a surface of smaller ones six times.
SplineData waves(bool rational) {
    return net_of({20, 20}, {3, 3}, rational, [](double u, double v) {
        return std::array<double, 4>{u, v, 0.2 * std::sin(6 * pi * u) + 0.03 * std::cos(5 * v),
                                     1 + 0.5 * std::sin(7 * u + 3 * v)};
    });
}
SplineData ripples(bool rational, double height) {
    return net_of({20, 20}, {3, 3}, rational, [=](double u, double v) {
        return std::array<double, 4>{1.2 * u - 0.1, 1.2 * v - 0.1,
                                     height + 0.01 * std::sin(2 * pi * u + 4 * v),
                                     1 + 0.5 * std::cos(5 * u - 4 * v)};
    });
}

TEST(SurfaceCrossings, SixBranches) {
    for (const bool rational : {false, true}) {
        expect_complete(waves(rational), ripples(rational, 0.05), {6, 0},
                        rational ? "rational" : "polynomial");
    }
}

// The branch runs along N_b x N_a.
TEST(SurfaceCrossings, Direction) {
    const Handle a = create(waves(true)), b = create(ripples(true, 0.05));
    const Crossing crossing = crossing_of(a.get(), b.get(), tolerance);
    const auto product = [](const Point3 &x, const Point3 &y) {
        return Point3{x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
    };
    const auto normal = [&](const nurbs *g, const Place &at) {
        const std::vector<double> s = eval_derivs(g, 1, {at[0], at[1]});
        return product({s[3], s[4], s[5]}, {s[6], s[7], s[8]});
    };
    for (size_t i = 0; i < crossing.found.branches.size(); ++i) {
        const Branch &branch = crossing.found.branches[i];
        const std::vector<double> t = branch.params(20);
        const std::vector<Point3> space = points_on(branch.space.get(), t);
        const std::vector<Place> on_a = places_on(branch.on.get(), t),
                                 on_b = places_on(crossing.on_second[i].get(), t);
        for (size_t k = 0; k + 1 < t.size(); ++k) {
            const Point3 along = product(normal(b.get(), on_b[k]), normal(a.get(), on_a[k]));
            const Point3 step{space[k + 1][0] - space[k][0], space[k + 1][1] - space[k][1],
                              space[k + 1][2] - space[k][2]};
            EXPECT_GT(dot(along, step), 0) << "branch " << i << ", step " << k;
        }
    }
}

// Loops around the lowest point of z = x^2 + 0.3 x y + 0.8 y^2, down to a millionth of the surface.
TEST(SurfaceCrossings, SmallLoops) {
    for (const double r : {0.3, 1e-2, 1e-3, 1e-4, 1e-5, 4e-6}) {
        SCOPED_TRACE(r);
        const SplineData bowl = quadratic_graph(1, 0.3, 0.8, 0, -1.03, -1.01), plane = flat(r * r);
        const Handle a = create(bowl), b = create(plane);
        const Crossing crossing = crossing_of(a.get(), b.get(), tolerance);
        EXPECT_TRUE(crossing.found.complete);
        EXPECT_EQ(crossing.closed_ways, 1);
        EXPECT_EQ(crossing.open_ways, 0);
        EXPECT_NEAR(length_of(crossing.found) / r, 6.742, 0.01);
        check_curves(crossing, Ground(a.get(), bowl), Ground(b.get(), plane));
    }
}

// Random patches over the square [-1, 1]^2 and beyond it, on which the other surface is a graph.
SplineData random_patch(Random &random) {
    const std::array<int, 2> degrees{random.whole(1, 4), random.whole(1, 4)};
    const std::array<int, 2> counts{degrees[0] + random.whole(1, 4), degrees[1] + random.whole(1, 4)};
    const bool rational = random.chance(50);
    return net_of(counts, degrees, rational, [&](double u, double v) {
        return std::array<double, 4>{1.6 * u - 0.8 + random.between(-0.15, 0.15),
                                     1.6 * v - 0.8 + random.between(-0.15, 0.15), random.between(-0.6, 0.6),
                                     random.between(0.5, 2)};
    });
}

// The zeros of a polynomial on the patch, which are found in another way.
struct Oracle {
    bool complete;
    Counts counts;
    double length;
};
Oracle oracle_of(const nurbs *g, int32_t degree, const std::vector<double> &coefficients) {
    nurbs_meet *meet = nullptr;
    require_ok(nurbs_surface_level(g, degree, coefficients.data(), 1e-7, &meet));
    const MeetHandle owner(meet);
    Crossing crossing;
    count_ways(meet, crossing);
    const Found found = found_in(meet);
    return {found.complete && found.count(NURBS_NODE_TOUCH) == 0,
            {crossing.open_ways, crossing.closed_ways},
            length_of(found)};
}

TEST(SurfaceCrossings, AsManyAsZerosOfAPolynomial) {
    Random random(0x5c01);
    int64_t compared = 0, branches = 0;
    const int64_t cases = scaled(300);
    for (int64_t i = 0; i < cases; ++i) {
        SCOPED_TRACE(i);
        const SplineData patch = random_patch(random);
        const double a = random.between(-0.5, 0.5), b = random.between(-0.5, 0.5),
                     c = random.between(-0.5, 0.5), d = random.between(-0.3, 0.3);
        const SplineData graph = quadratic_graph(a, b, c, d, -1, -1);
        const Handle first = create(patch), second = create(graph);
        // Of x^2, x y, x z, x, y^2, y z, y, z^2, z, 1.
        const std::vector<double> coefficients{a, b, 0, 0, c, 0, 0, 0, -1, d};
        const Oracle oracle = oracle_of(first.get(), 2, coefficients);
        const Crossing crossing = crossing_of(first.get(), second.get(), 1e-5);
        if (!oracle.complete || !crossing.found.complete) {
            continue;
        }
        ++compared;
        branches += crossing.open_ways + crossing.closed_ways;
        EXPECT_EQ(crossing.open_ways, oracle.counts.open);
        EXPECT_EQ(crossing.closed_ways, oracle.counts.closed);
        EXPECT_NEAR(length_of(crossing.found), oracle.length, 1e-3 * (1 + oracle.length));
        check_curves(crossing, Ground(first.get(), patch), Ground(second.get(), graph), 40);
    }
    EXPECT_GE(compared, cases * 95 / 100);
    EXPECT_GE(branches, compared);
}

// Turned and moved at random, so that it cuts the other one anyhow.
SplineData anyhow(Random &random, SplineData data) {
    move(data, random_motion(random, 3, 1, 0.3));
    return data;
}

struct Ways {
    int64_t open, closed;
    bool complete;
    double length;
};
Ways ways_of(const nurbs *a, const nurbs *b) {
    const Crossing crossing = crossing_of(a, b, 1e-5);
    return {crossing.open_ways, crossing.closed_ways, crossing.found.complete, length_of(crossing.found)};
}
void expect_same(const Ways &a, const Ways &b, const char *law) {
    SCOPED_TRACE(law);
    if (a.complete && b.complete) {
        EXPECT_EQ(a.open, b.open);
        EXPECT_EQ(a.closed, b.closed);
        EXPECT_NEAR(a.length, b.length, 2e-4 * (1 + a.length));
    }
}

void expect_as_many(const Ways &a, const Ways &b) {
    if (a.complete && b.complete) {
        EXPECT_EQ(a.open, b.open) << "sheared";
        EXPECT_EQ(a.closed, b.closed) << "sheared";
    }
}
Handle sheared(const nurbs *g) {
    const std::array<double, 9> matrix{1.1, 0.3, -0.2, 0, 0.8, 0.5, 0.1, 0, 1.3};
    const std::array<double, 3> shift{0.7, -0.4, 0.2};
    return made([&](nurbs **out) { return nurbs_transform(g, 3, matrix.data(), shift.data(), out); });
}

// The same shapes in other forms, and the other way round, meet in as many curves.
TEST(SurfaceCrossings, LawsOfForms) {
    Random random(0x5c02);
    int64_t complete = 0, branches = 0;
    const int64_t cases = scaled(150);
    for (int64_t i = 0; i < cases; ++i) {
        SCOPED_TRACE(i);
        const SplineData data_a = random_patch(random), data_b = anyhow(random, random_patch(random));
        const Handle a = create(data_a), b = create(data_b);
        const Crossing crossing = crossing_of(a.get(), b.get(), 1e-5);
        check_curves(crossing, Ground(a.get(), data_a), Ground(b.get(), data_b), 40);
        const Ways ways{crossing.open_ways, crossing.closed_ways, crossing.found.complete,
                        length_of(crossing.found)};
        complete += ways.complete ? 1 : 0;
        branches += ways.open + ways.closed;
        expect_same(ways, ways_of(b.get(), a.get()), "exchanged");
        const Handle fine =
            made([&](nurbs **out) { return nurbs_refine_uniform(a.get(), random.whole(0, 1), 3, out); });
        expect_same(ways, ways_of(fine.get(), b.get()), "refined");
        const Handle raised = elevate(b.get(), random.whole(0, 1), 1);
        expect_same(ways, ways_of(a.get(), raised.get()), "elevated");
        const Handle other =
            disguised(random, made([&](nurbs **out) { return nurbs_clone(b.get(), out); }), 2);
        expect_same(ways, ways_of(a.get(), other.get()), "in another form");
        expect_as_many(ways, ways_of(sheared(a.get()).get(), sheared(b.get()).get()));
    }
    EXPECT_GE(complete, cases * 95 / 100);
    EXPECT_GE(branches, cases / 2);
}

// Of any knots and weights: repeated ones and jumps, unclamped and periodic axes, points far from the origin.
TEST(SurfaceCrossings, AnySplines) {
    Random random(0x5c03);
    int64_t complete = 0, branches = 0;
    const int64_t cases = scaled(60);
    for (int64_t i = 0; i < cases; ++i) {
        SCOPED_TRACE(i);
        Recipe recipe_a = random_recipe(random, 2, 3), recipe_b = random_recipe(random, 2, 3);
        recipe_a.dim = recipe_b.dim = 3;
        for (Recipe *recipe : {&recipe_a, &recipe_b}) {
            for (AxisRecipe &axis : recipe->axes) {
                axis.degree = std::max(axis.degree, 1);
            }
        }
        const SplineData data_a = random_spline(random, recipe_a), data_b = random_spline(random, recipe_b);
        const Handle a = create(data_a), b = create(data_b);
        const double size = std::max(extent(data_a), extent(data_b));
        nurbs_call_options call;
        require_ok(nurbs_call_options_init(&call, sizeof call));
        call.work = 20000000;
        const Crossing crossing = crossing_of(a.get(), b.get(), 1e-5 * size, &call);
        complete += crossing.found.complete ? 1 : 0;
        branches += crossing.open_ways + crossing.closed_ways;
        check_curves(crossing, Ground(a.get(), data_a), Ground(b.get(), data_b), 20);
        const Crossing exchanged = crossing_of(b.get(), a.get(), 1e-5 * size, &call);
        if (crossing.found.complete && exchanged.found.complete) {
            EXPECT_EQ(crossing.open_ways, exchanged.open_ways);
            EXPECT_EQ(crossing.closed_ways, exchanged.closed_ways);
        }
    }
    EXPECT_GE(complete, cases / 2);
    EXPECT_GE(branches, cases / 4);
}

// Of ranges that run beyond the upper end where a surface closes.
std::vector<double> in_domain(const nurbs *g, std::vector<double> at) {
    for (size_t k = 0; k < 2; ++k) {
        std::array<double, 2> domain{};
        require_ok(nurbs_domain(g, static_cast<int32_t>(k), domain.data()));
        at[k] -= at[k] > domain[1] ? domain[1] - domain[0] : 0;
    }
    return at;
}

// All of both surfaces in the ranges of a touch is between two planes as far apart as the tolerance, or in such a box.
double width_of_touch(const Crossing &crossing, size_t node, const nurbs *a, const nurbs *b) {
    constexpr int n = 12;
    std::vector<Point3> points;
    std::vector<Point3> normals;
    for (const bool second : {false, true}) {
        const MeetPart &part = second ? crossing.on_b[node] : crossing.found.nodes[node];
        for (int i = 0; i <= n; ++i) {
            for (int j = 0; j <= n; ++j) {
                std::vector<double> at(2);
                for (size_t k = 0; k < 2; ++k) {
                    const double t = static_cast<double>(k == 0 ? i : j) / n;
                    at[k] = (1 - t) * part.range[k][0] + t * part.range[k][1];
                }
                const std::vector<double> s = eval_derivs(second ? b : a, 1, in_domain(second ? b : a, at));
                points.push_back({s[0], s[1], s[2]});
                const Point3 normal{s[4] * s[8] - s[5] * s[7], s[5] * s[6] - s[3] * s[8],
                                    s[3] * s[7] - s[4] * s[6]};
                const double size = std::sqrt(dot(normal, normal));
                normals.push_back(size > 0 ? Point3{normal[0] / size, normal[1] / size, normal[2] / size}
                                           : Point3{});
            }
        }
    }
    const auto extent_along = [&](const Point3 &unit) {
        double lower = HUGE_VAL, upper = -HUGE_VAL;
        for (const Point3 &point : points) {
            lower = std::min(lower, dot(unit, point));
            upper = std::max(upper, dot(unit, point));
        }
        return upper - lower;
    };
    double least = std::max({extent_along({1, 0, 0}), extent_along({0, 1, 0}), extent_along({0, 0, 1})});
    for (const Point3 &normal : normals) {
        least = dot(normal, normal) > 0 ? std::min(least, extent_along(normal)) : least;
    }
    return least;
}
// How far a place is from the nearest touch.
double distance_to_touch(const Crossing &crossing, const nurbs *a, const Point3 &place) {
    double nearest = HUGE_VAL;
    for (const MeetPart &node : crossing.found.nodes) {
        if (node.kind == NURBS_NODE_TOUCH) {
            const std::vector<double> s = eval_derivs(a, 1, in_domain(a, {node.at[0], node.at[1]}));
            nearest = std::min(nearest, distance({s[0], s[1], s[2]}, place));
        }
    }
    return nearest;
}

// Where surfaces touch in a point, or their curves cross in one, that is told, with all branches around it.
TEST(SurfaceCrossings, TouchesInPoints) {
    struct Touch {
        SplineData a, b;
        int64_t branches;
        std::vector<Point3> places;
        double length;
        const char *name;
    };
    const double slope = std::tan(std::asin(0.5)), root = std::sqrt(3.0);
    const SplineData bowl = quadratic_graph(1, 0.3, 0.8, 0, -1.03, -1.01),
                     saddle = quadratic_graph(1, 0, -1, 0, -1, -1);
    const std::vector<Touch> touches{
        {saddle, flat(0), 4, {{0, 0, 0}}, 4 * std::numbers::sqrt2, "a saddle at its level"},
        {bowl, flat(0), 0, {{0, 0, 0}}, 0, "a bowl on a plane"},
        {bowl, flat(1e-14), 0, {{0, 0, 0}}, 0, "a bowl a little below a plane"},
        {ball(1, {0.1, 0.2, 1}), flat(0), 0, {{0.1, 0.2, 0}}, 0, "a pole on a plane"},
        {ball(1, {0, 0, 0}),
         support::moved(turned(flat(0)), {1, 0, 0}),
         0,
         {{1, 0, 0}},
         0,
         "a corner of pieces on a plane"},
        {ball(1, {0.1, 0.2, 0.3}),
         support::moved(ball(2, {0, 0, 0}), {0.1 + 3 * 0.6, 0.2, 0.3 + 3 * 0.8}),
         0,
         {{0.7, 0.2, 1.1}},
         0,
         "balls beside each other"},
        {ball(1.2, {0.5, 0, 0}), ring(2.5, 0.8), 0, {{1.7, 0, 0}}, 0, "a ball in a ring"},
        {tube(1, 3), turned(tube(1, 3)), 6, {{0, 1, 0}, {0, -1, 0}}, 15.2808, "tubes of equal radii"},
        {ball(2, {0, 0, 0}),
         support::moved(tube(1, 3), {1, 0, 0}),
         4,
         {{2, 0, 0}, {0, 0, 2}, {0, 0, -2}},
         15.2808,
         "Viviani's curve, and poles"},
        {ring(2, 1),
         leaning(slope),
         6,
         {{root * root / 2, 0, root / 2}, {-root * root / 2, 0, -root / 2}},
         8 * pi,
         "Villarceau's circles"},
        {ball(2, {0, 1, 0}), ring(2, 1), 8, {}, 8 * pi, "the same on a ball"},
        {ball(1, {0, 0, 0}), upright(0), 2, {{0, 0, 1}, {0, 0, -1}}, 2 * pi, "a plane through the poles"},
        {ball(1, {0, 0, 0}), upright(0.3), 2, {{0, 0, 1}, {0, 0, -1}}, 2 * pi, "another one"}};
    for (const Touch &touch : touches) {
        for (const bool exchanged : {false, true}) {
            SCOPED_TRACE(touch.name);
            const SplineData &data_a = exchanged ? touch.b : touch.a, &data_b = exchanged ? touch.a : touch.b;
            const Handle a = create(data_a), b = create(data_b);
            const Crossing crossing = crossing_of(a.get(), b.get(), tolerance);
            EXPECT_TRUE(crossing.found.complete);
            EXPECT_EQ(std::ssize(crossing.found.branches), touch.branches);
            // A touch is as wide as curves that cross in it stay within the tolerance of each other.
            const double wide = static_cast<double>(touch.places.size()) * std::sqrt(tolerance);
            EXPECT_NEAR(length_of(crossing.found), touch.length, 1e-4 + wide);
            if (!touch.places.empty()) {
                EXPECT_EQ(crossing.found.count(NURBS_NODE_TOUCH), std::ssize(touch.places));
            }
            for (const Point3 &place : touch.places) {
                EXPECT_LE(distance_to_touch(crossing, a.get(), place), 1e-4);
            }
            for (size_t i = 0; i < crossing.found.nodes.size(); ++i) {
                if (crossing.found.nodes[i].kind == NURBS_NODE_TOUCH) {
                    EXPECT_LE(width_of_touch(crossing, i, a.get(), b.get()), 1.0001 * tolerance);
                }
            }
            check_curves(crossing, Ground(a.get(), data_a), Ground(b.get(), data_b));
        }
    }
}

// Whatever the tolerance, no part is wider than that.
TEST(SurfaceCrossings, WidthsOfTouches) {
    const SplineData bowl = quadratic_graph(1, 0.3, 0.8, 0, -1.03, -1.01),
                     saddle = quadratic_graph(1, 0, -1, 0, -1, -1);
    int64_t touches = 0;
    for (const SplineData &shape : {bowl, saddle}) {
        const Handle a = create(shape), b = create(flat(0));
        for (const double wanted : {1e-3, 1e-6, 1e-9, 1e-11, 1e-12, 1e-13}) {
            const Crossing crossing = crossing_of(a.get(), b.get(), wanted);
            for (size_t i = 0; i < crossing.found.nodes.size(); ++i) {
                if (crossing.found.nodes[i].kind == NURBS_NODE_TOUCH) {
                    ++touches;
                    EXPECT_LE(width_of_touch(crossing, i, a.get(), b.get()), 1.0001 * wanted) << wanted;
                }
            }
        }
    }
    EXPECT_GE(touches, 8);
}

// Curves along which surfaces touch, at any place in space, as branches of that kind.
TEST(SurfaceCrossings, TouchesAlongCurves) {
    struct Touch {
        SplineData a, b;
        Counts ways;
        double length;
        const char *name;
    };
    const std::vector<Touch> touches{
        {ring(1.2, 0.5), flat(0.5), {0, 1}, 2.4 * pi, "a ring below a plane"},
        {ring(1.2, 0.5), flat(-0.5), {0, 1}, 2.4 * pi, "a ring on a plane"},
        {ball(1, {0, 0, 0}), tube(1, 2), {0, 1}, 2 * pi, "a ball in a tube"},
        {ball(1, {0, 0, 0.3}), tube(1, 2), {0, 1}, 2 * pi, "another place in it"},
        {ball(1.7, {0, 0, 0}), ring(2.5, 0.8), {0, 1}, 3.4 * pi, "a ball in a ring"},
        {ball(3.3, {0, 0, 0}), ring(2.5, 0.8), {0, 1}, 6.6 * pi, "a ring in a ball"},
        {tube(1, 1.5), support::moved(upright(pi / 2), {1, 0, 0}), {1, 0}, 3, "a tube on a plane"},
        {tube(1, 1.5), support::moved(tube(0.5, 1), {0.9, 1.2, 0.2}), {1, 0}, 2, "tubes side by side"},
        {revolved(ellipse_arc(0, 0, 1, 1, 0, pi / 2), 0, 2 * pi),
         tube(1, 2),
         {0, 1},
         2 * pi,
         "half a ball that ends where it touches a tube"}};
    Random random(0x5c04);
    for (const Touch &touch : touches) {
        for (const bool moved : {false, true}) {
            SCOPED_TRACE(touch.name);
            SplineData data_a = touch.a, data_b = touch.b;
            if (moved) {
                const Motion motion = random_motion(random, 3, 1, 0.3);
                move(data_a, motion);
                move(data_b, motion);
            }
            const Handle a = create(data_a), b = create(data_b);
            const Crossing crossing = crossing_of(a.get(), b.get(), 1e-5);
            EXPECT_TRUE(crossing.found.complete);
            EXPECT_EQ(crossing.open_ways, touch.ways.open);
            EXPECT_EQ(crossing.closed_ways, touch.ways.closed);
            EXPECT_NEAR(length_of(crossing.found), touch.length, 1e-4);
            EXPECT_EQ(std::ranges::count(crossing.kinds, NURBS_BRANCH_TOUCH), std::ssize(crossing.kinds));
            check_curves(crossing, Ground(a.get(), data_a), Ground(b.get(), data_b));
            check_nodes(crossing, 1e-9);
        }
    }
}

// What all but touches along curves is told as what it is: two curves beside each other, or none.
TEST(SurfaceCrossings, NearTouchesAlongCurves) {
    for (const double by : {1e-2, 1e-3, 1e-5}) {
        SCOPED_TRACE(by);
        Crossing crossing = expect_complete(ring(1.2, 0.5), flat(0.5 - by), {0, 2}, "a ring through a plane");
        EXPECT_EQ(std::ranges::count(crossing.kinds, NURBS_BRANCH_CROSSING), std::ssize(crossing.kinds));
        crossing = expect_complete(ring(1.2, 0.5), flat(0.5 + by), {0, 0}, "a ring below a plane");
    }
}

// Nothing depends on the units of length and of parameters.
TEST(SurfaceCrossings, Scales) {
    const SplineData a = waves(true), b = ripples(true, 0.05);
    const Ways ways = ways_of(create(a).get(), create(b).get());
    EXPECT_EQ(ways.open, 6);
    for (const double size : {0x1p-40, 1e-6, 1e6, 0x1p60}) {
        for (const double speed : {1e-9, 1.0, 1e9}) {
            const Handle first = create(scaled(a, size, speed)), second = create(scaled(b, size, 1 / speed));
            const Crossing crossing = crossing_of(first.get(), second.get(), 1e-5 * size);
            EXPECT_TRUE(crossing.found.complete);
            EXPECT_EQ(crossing.open_ways, 6);
            EXPECT_NEAR(length_of(crossing.found) / size, ways.length, 1e-4);
        }
    }
}

// Where the work ends early the answer says so; what it tells of curves holds.
TEST(SurfaceCrossings, LimitsOfWork) {
    const SplineData data_a = waves(false), data_b = ripples(false, 0.05);
    const Handle a = create(data_a), b = create(data_b);
    nurbs_call_options call;
    require_ok(nurbs_call_options_init(&call, sizeof call));
    bool complete = false;
    for (call.work = 1; call.work < 1000000000; call.work *= 4) {
        SCOPED_TRACE(call.work);
        const Crossing crossing = crossing_of(a.get(), b.get(), tolerance, &call);
        complete = crossing.found.complete;
        if (complete) {
            EXPECT_EQ(crossing.open_ways + crossing.closed_ways, 6);
        }
        for (const Branch &branch : crossing.found.branches) {
            EXPECT_GT(branch.deviation, 0);
        }
    }
    EXPECT_TRUE(complete);
}

} // namespace

} // namespace surface_crossings
