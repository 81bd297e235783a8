// Laws of curves projected onto surfaces: as many sheets over each parameter as its line has hits.
#include "crossings.h"
#include "faces.h"
#include "support/scale.h"

namespace projected_curves {

using namespace surface_crossings;

namespace {

constexpr double tolerance = 1e-6;

Crossing projection(const nurbs *g, const nurbs *curve, const Point3 &direction) {
    nurbs_meet *meet = nullptr;
    require_ok(nurbs_surface_project_curve(g, curve, direction.data(), tolerance, &meet));
    return crossing_in(MeetHandle(meet).get());
}

Point3 any_direction(Random &random) {
    return {random.between(-1.5, 1.5), random.between(-1.5, 1.5), random.magnitude(0.05, 2)};
}

Point3 unit(const Point3 &d) {
    const double length = std::hypot(d[0], d[1], d[2]);
    return {d[0] / length, d[1] / length, d[2] / length};
}

// A curve in space about a point: of any degree, rational, periodic, with kinks, or straight.
SplineData any_curve(Random &random, const Point3 &about) {
    const int degree = random.whole(1, 5), spans = random.whole(1, 4);
    const bool periodic = degree > 1 && random.chance(30), rational = random.chance(40);
    const int own = spans + degree, count = periodic ? own + degree : own;
    SplineData data{{degree}, {count}, {{}}, 3, {}, {}, periodic ? NURBS_PERIODIC : 0};
    for (int i = 0; i < count; ++i) {
        for (size_t c = 0; c < 3; ++c) {
            data.points.push_back(i >= own ? data.points[static_cast<size_t>(3 * (i - own)) + c]
                                           : random.between(-1, 1) + about[c]);
        }
        if (rational) {
            data.weights.push_back(i >= own ? data.weights[static_cast<size_t>(i - own)]
                                            : random.between(0.5, 2));
        }
    }
    for (int i = 0; i < count + degree + 1; ++i) {
        data.knots[0].push_back(periodic ? i : std::clamp(i - degree, 0, count - degree));
    }
    return data;
}

SplineData any_surface(Random &random) {
    const std::array<int, 2> degrees{random.whole(1, 3), random.whole(1, 3)};
    const std::array<int, 2> counts{degrees[0] + random.whole(1, 3), degrees[1] + random.whole(1, 3)};
    return net_of(counts, degrees, random.chance(50), [&](double u, double v) {
        return std::array<double, 4>{2.4 * u - 1.2 + random.between(-0.3, 0.3),
                                     2.4 * v - 1.2 + random.between(-0.3, 0.3), random.between(-1.2, 1.2),
                                     random.between(0.5, 2)};
    });
}

// The ways h along a line through a point of the curve to the surface, rising, if they are known.
bool ways_along(const nurbs *g, const Point3 &from, const Point3 &direction, std::vector<double> &ways,
                std::vector<Place> &places) {
    const Point3 along = unit(direction);
    const double all[] = {-HUGE_VAL, HUGE_VAL};
    std::vector<double> params(200), distances(100);
    int64_t count = 0;
    int32_t complete = 0;
    require_ok(nurbs_surface_ray_hits(g, from.data(), along.data(), all, 100, params.data(), distances.data(),
                                      nullptr, &count, &complete));
    ways.assign(distances.begin(), distances.begin() + count);
    places.clear();
    for (size_t i = 0; i < static_cast<size_t>(count); ++i) {
        places.push_back({params[2 * i], params[2 * i + 1]});
    }
    return complete == 1;
}

// Where a curve of (t, h), along which t rises, has a value of t or one that is periods away.
void add_ways_at(const nurbs *lines, const Place &domain, double t, std::vector<double> &ways,
                 double &nearest) {
    const Place low = places_on(lines, {domain[0]})[0], high = places_on(lines, {domain[1]})[0];
    nearest = std::min({nearest, std::abs(t - low[0]), std::abs(t - high[0])});
    if (t < low[0] || t > high[0]) {
        return;
    }
    double a = domain[0], b = domain[1];
    for (int i = 0; i < 60; ++i) {
        const double middle = a / 2 + b / 2;
        (places_on(lines, {middle})[0][0] < t ? a : b) = middle;
    }
    ways.push_back(places_on(lines, {a})[0][1]);
}

struct Subject {
    const nurbs *g, *curve;
    Point3 direction;
    Place domain;
    bool periodic;
};

// t rises along each branch, and the surface is on the lines.
void check_sheets(const Crossing &found, const Subject &s, const Ground &ground) {
    const Point3 along = unit(s.direction);
    for (size_t i = 0; i < found.found.branches.size(); ++i) {
        const Branch &branch = found.found.branches[i];
        ASSERT_TRUE(std::isfinite(branch.deviation)) << "branch " << i;
        const std::vector<double> at = branch.params(100);
        const std::vector<Place> on = places_on(branch.on.get(), at),
                                 lines = places_on(found.on_second[i].get(), at);
        const std::vector<Point3> space = points_on(branch.space.get(), at);
        for (size_t k = 0; k < at.size(); ++k) {
            const double period = s.domain[1] - s.domain[0],
                         t = s.periodic
                                 ? lines[k][0] - period * std::floor((lines[k][0] - s.domain[0]) / period)
                                 : lines[k][0];
            ASSERT_TRUE(ground.contains(on[k]) && t >= s.domain[0] && t <= s.domain[1]);
            Point3 x = points_on(s.curve, {t})[0];
            for (size_t c = 0; c < 3; ++c) {
                x[c] += lines[k][1] * along[c];
            }
            EXPECT_LE(ground.gap(on[k], x), 2 * branch.deviation + 1e-12) << "branch " << i;
            EXPECT_LE(distance(space[k], x), 2 * branch.deviation + 1e-12) << "branch " << i;
            EXPECT_GE(lines[k][0] - (k > 0 ? lines[k - 1][0] : lines[k][0]), -1e-3 * period)
                << "branch " << i;
        }
        EXPECT_GT(lines.back()[0], lines.front()[0]);
    }
}

// Whether it could be compared: t may be too near an end of a branch, or its line touch the surface.
template <class Counts>
bool compare_at(const Crossing &found, const Subject &s, double t, Counts &&counts) {
    std::vector<double> expected, all, ways;
    std::vector<Place> places;
    if (!ways_along(s.g, points_on(s.curve, {t})[0], s.direction, all, places)) {
        return false;
    }
    for (size_t i = 0; i < all.size(); ++i) {
        if (counts(places[i])) {
            expected.push_back(all[i]);
        }
    }
    double nearest = HUGE_VAL;
    const double period = s.domain[1] - s.domain[0];
    for (size_t i = 0; i < found.found.branches.size(); ++i) {
        for (int shift = s.periodic ? -2 : 0; shift <= (s.periodic ? 2 : 0); ++shift) {
            add_ways_at(found.on_second[i].get(), found.found.branches[i].domain, t + shift * period, ways,
                        nearest);
        }
    }
    if (nearest < 1e-3 * period) {
        return false;
    }
    std::ranges::sort(ways);
    EXPECT_EQ(ways.size(), expected.size()) << "t = " << t;
    for (size_t i = 0; i < std::min(ways.size(), expected.size()); ++i) {
        EXPECT_NEAR(ways[i], expected[i], 1e-3) << "t = " << t;
    }
    return true;
}

TEST(ProjectedCurves, AsManySheetsAsHitsOfLines) {
    Random random(0x9c01);
    int64_t compared = 0, complete = 0, folds = 0, branches = 0;
    const int64_t cases = scaled(300);
    for (int64_t i = 0; i < cases; ++i) {
        SCOPED_TRACE(i);
        const SplineData surface = any_surface(random);
        const Point3 d = any_direction(random);
        const SplineData line = any_curve(random, unit(d));
        const Handle g = create(surface), curve = create(line);
        Subject s{g.get(), curve.get(), d, {}, line.periodic(0)};
        require_ok(nurbs_domain(curve.get(), 0, s.domain.data()));
        const Crossing found = projection(s.g, s.curve, s.direction);
        check_sheets(found, s, Ground(g.get(), surface));
        if (!found.found.complete) {
            continue;
        }
        ++complete;
        folds += found.found.count(NURBS_NODE_FOLD);
        branches += std::ssize(found.found.branches);
        for (int k = 0; k < 5; ++k) {
            const double t = random.between(s.domain[0], s.domain[1]);
            compared += compare_at(found, s, t, [](const Place &) { return true; }) ? 1 : 0;
        }
    }
    EXPECT_GE(complete, cases * 9 / 10);
    EXPECT_GE(compared, complete * 4);
    EXPECT_GE(branches, cases / 2);
    EXPECT_GE(folds, cases / 4);
}

// Against the direction, along the curve backwards, and with more knots the same sheets are found.
TEST(ProjectedCurves, DirectionsAndKnots) {
    Random random(0x9c02);
    int64_t compared = 0;
    const int64_t cases = scaled(60);
    for (int64_t i = 0; i < cases; ++i) {
        SCOPED_TRACE(i);
        const SplineData surface = any_surface(random);
        const Point3 d = any_direction(random);
        const Handle g = create(surface), curve = create(any_curve(random, unit(d)));
        const Handle reversed = made([&](nurbs **out) { return nurbs_reverse(curve.get(), 0, 0, out); });
        const Handle finer = made([&](nurbs **out) { return nurbs_refine_uniform(g.get(), 1, 2, out); });
        const Crossing one = projection(g.get(), curve.get(), d),
                       against = projection(g.get(), curve.get(), {-2 * d[0], -2 * d[1], -2 * d[2]}),
                       backwards = projection(finer.get(), reversed.get(), d);
        if (!one.found.complete || !against.found.complete || !backwards.found.complete) {
            continue;
        }
        ++compared;
        for (const Crossing *other : {&against, &backwards}) {
            EXPECT_EQ(one.found.branches.size(), other->found.branches.size());
            EXPECT_EQ(one.found.count(NURBS_NODE_FOLD), other->found.count(NURBS_NODE_FOLD));
            EXPECT_NEAR(length_of(one.found), length_of(other->found), 1e-4 * (1 + length_of(one.found)));
        }
    }
    EXPECT_GE(compared, cases * 8 / 10);
}

// Of lines through a face, those hits count that are inside.
TEST(ProjectedCurves, OntoFaces) {
    Random random(0x9c03);
    int64_t compared = 0, cut = 0;
    const int64_t cases = scaled(60);
    for (int64_t i = 0; i < cases; ++i) {
        SCOPED_TRACE(i);
        const faces::Ground ground = faces::wavy(random);
        const Handle loop = create(faces::any_star(random, ground));
        const faces::Face face = faces::face_of(ground.surface.get(), {{loop.get()}});
        const Point3 d = any_direction(random), along = unit(d);
        const SplineData line = any_curve(random, {along[0] + 0.5, along[1] + 0.5, along[2]});
        const Handle curve = create(line);
        Subject s{ground.surface.get(), curve.get(), d, {}, line.periodic(0)};
        require_ok(nurbs_domain(curve.get(), 0, s.domain.data()));
        nurbs_meet *meet = nullptr;
        require_ok(nurbs_face_project_curve(face.get(), s.curve, s.direction.data(), tolerance, &meet));
        const Crossing found = crossing_in(MeetHandle(meet).get());
        if (!found.found.complete) {
            continue;
        }
        if (!s.periodic) { // else nodes are in the domain, and branches may be in others of its periods
            check_nodes(found, 1e-9);
        }
        cut += found.found.count(NURBS_NODE_BORDER);
        const auto is_inside = [&](const Place &at) {
            return faces::sides(face.get(), {at[0], at[1]})[0] >= 0;
        };
        for (int k = 0; k < 5; ++k) {
            compared += compare_at(found, s, random.between(s.domain[0], s.domain[1]), is_inside) ? 1 : 0;
        }
    }
    EXPECT_GE(compared, 3 * cases);
    EXPECT_GE(cut, cases / 4);
}

} // namespace

} // namespace projected_curves
