// Loops that cross are refused, and no others: by exact arithmetic for polygons, by the sides of their places for curves.
#include "property/faces.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace face_crossings_test {

using namespace support;
using namespace support::faces;

namespace {

// Corners are multiples of 2^-10 in the unit square, so that all products of coordinates are exact.
struct Corner {
    int64_t u, v;
    bool operator==(const Corner &) const = default;
};
using Polygon = std::vector<Corner>;
constexpr int64_t side = 1024;

int turn(const Corner &a, const Corner &b, const Corner &c) {
    const int64_t area = (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
    return area > 0 ? 1 : area < 0 ? -1 : 0;
}

enum class Meet { none, touch, cross };

bool in_box(const Corner &a, const Corner &b, const Corner &x) {
    return std::min(a.u, b.u) <= x.u && x.u <= std::max(a.u, b.u) && std::min(a.v, b.v) <= x.v &&
           x.v <= std::max(a.v, b.v);
}

Meet meet(const Corner &a, const Corner &b, const Corner &c, const Corner &d) {
    const int abc = turn(a, b, c), abd = turn(a, b, d), cda = turn(c, d, a), cdb = turn(c, d, b);
    if (abc * abd < 0 && cda * cdb < 0) {
        return Meet::cross;
    }
    const bool touch = (abc == 0 && in_box(a, b, c)) || (abd == 0 && in_box(a, b, d)) ||
                       (cda == 0 && in_box(c, d, a)) || (cdb == 0 && in_box(c, d, b));
    return touch ? Meet::touch : Meet::none;
}

// Of sides that follow one another, only whether they run along each other counts.
Meet meet_of(const std::vector<Polygon> &loops) {
    Meet worst = Meet::none;
    for (size_t i = 0; i < loops.size(); ++i) {
        for (size_t j = i; j < loops.size(); ++j) {
            const size_t n = loops[i].size(), m = loops[j].size();
            for (size_t p = 0; p < n; ++p) {
                for (size_t q = i == j ? p + 1 : 0; q < m; ++q) {
                    const Corner &a = loops[i][p], &b = loops[i][(p + 1) % n];
                    const Corner &c = loops[j][q], &d = loops[j][(q + 1) % m];
                    const bool next = i == j && q == p + 1, before = i == j && (q + 1) % m == p;
                    const Corner &other = next ? d : c, &common = next ? b : a, &own = next ? a : b;
                    const bool turns = turn(own, common, other) != 0;
                    worst = std::max(worst, (next || before) && turns ? Meet::none : meet(a, b, c, d));
                }
            }
        }
    }
    return worst;
}

Polygon any_polygon(Random &random, int most) {
    Polygon polygon;
    for (int i = random.whole(3, most); i > 0; --i) {
        polygon.push_back({random.whole(1, side - 1), random.whole(1, side - 1)});
    }
    return polygon;
}

// Around a place, with corners farther and nearer, at rising angles.
Polygon any_star_polygon(Random &random, int corners, double radius) {
    const double room = 1 - 2 * radius;
    const double u = radius + room * random.unit(), v = radius + room * random.unit();
    Polygon polygon;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * pi * i / corners, r = radius * random.between(0.5, 1);
        polygon.push_back(
            {std::llround(side * (u + r * std::cos(angle))), std::llround(side * (v + r * std::sin(angle)))});
    }
    return polygon;
}

// Each side a curve, or all of them one.
std::vector<Handle> curves_of(Random &random, const Polygon &polygon) {
    std::vector<Place> places;
    for (const Corner &corner : polygon) {
        places.push_back({static_cast<double>(corner.u) / side, static_cast<double>(corner.v) / side});
    }
    std::vector<Handle> curves;
    if (random.chance(50)) {
        curves.push_back(faces::polygon(places));
    } else {
        for (size_t i = 0; i < places.size(); ++i) {
            curves.push_back(segment(places[i], places[(i + 1) % places.size()]));
        }
    }
    return curves;
}

nurbs_status status_of(Random &random, const std::vector<Polygon> &loops, double tolerance) {
    const Ground ground = plane();
    std::vector<std::vector<Handle>> handles;
    Curves curves;
    for (const Polygon &loop : loops) {
        handles.push_back(curves_of(random, loop));
        curves.emplace_back();
        for (const Handle &curve : handles.back()) {
            curves.back().push_back(curve.get());
        }
    }
    return checked(ground.surface.get(), curves, tolerance);
}

// A lobe that is smaller than 2^-20 takes corners nearer than 2^-10, which there are none.
TEST(FaceCrossings, polygons_agree_with_exact_arithmetic) {
    Random random(41);
    int crossing = 0, apart = 0;
    for (int round = 0; round < 1500; ++round) {
        std::vector<Polygon> loops;
        if (random.chance(30)) {
            loops.push_back(any_polygon(random, 7));
        }
        for (int i = random.whole(1, 4); i > 0; --i) {
            loops.push_back(any_star_polygon(random, random.whole(3, 30), random.between(0.02, 0.4)));
        }
        const Meet known = meet_of(loops);
        const nurbs_status found = status_of(random, loops, random.chance(50) ? 0 : 1e-9);
        if (known == Meet::cross) {
            EXPECT_EQ(found, NURBS_ERROR_CROSSING) << round << ' ' << last_error();
            ++crossing;
        } else if (known == Meet::none) {
            EXPECT_EQ(found, NURBS_OK) << round << ' ' << last_error();
            ++apart;
        }
    }
    EXPECT_GT(crossing, 300);
    EXPECT_GT(apart, 300);
}

// A corner is moved onto a side of another loop or onto another corner: what crossed or did not still does.
TEST(FaceCrossings, corners_on_sides_are_no_crossing_by_themselves) {
    Random random(42);
    for (int round = 0; round < 200; ++round) {
        const int64_t v = random.whole(300, 700), u = random.whole(300, 700), reach = random.whole(20, 200);
        const Polygon square{{128, 128}, {896, 128}, {896, 896}, {128, 896}};
        const bool right = random.chance(50), corner = random.chance(50);
        const int64_t at = corner ? 128 : v;
        const Polygon within{{128, at}, {u, right ? at + reach : at + 1}, {u, at + reach + 1}};
        const Polygon across{{128, at}, {u, at + reach}, {64, at + reach + 1}};
        EXPECT_EQ(status_of(random, {square, within}, 1e-9), NURBS_OK) << last_error();
        EXPECT_EQ(status_of(random, {square, across}, 1e-9), NURBS_ERROR_CROSSING) << last_error();
    }
}

std::vector<int32_t> sides_of_places(const Ground &ground, const nurbs *loop, const nurbs *other,
                                     double near) {
    constexpr int samples = 4000;
    double ends[2];
    require_ok(nurbs_domain(other, 0, ends));
    Vec params;
    for (int i = 0; i <= samples; ++i) {
        params.push_back(i == samples ? ends[1] : ends[0] + (ends[1] - ends[0]) * i / samples);
    }
    return sides(face_of(ground.surface.get(), {{loop}}, 1e-9).get(), eval(other, params), near);
}

// Two loops cross if one of them has places on both sides of the other; what is too near to tell is left out.
TEST(FaceCrossings, curves_agree_with_the_sides_of_their_places) {
    Random random(43);
    int crossing = 0, apart = 0;
    for (int round = 0; round < 60; ++round) {
        for (const Ground &ground : grounds(random)) {
            double area = 0;
            require_ok(nurbs_surface_area(ground.surface.get(), nullptr, 1e-6, &area, nullptr));
            const double near = 0.02 * std::sqrt(area);
            Star kind;
            kind.degree = random.whole(1, 10);
            kind.rational = random.chance(50);
            std::array<Handle, 2> loops;
            for (Handle &loop : loops) {
                kind.radius = random.between(0.05, 0.25);
                loop = create(star(random, ground,
                                   ground.at(random.between(0.25, 0.75), random.between(0.25, 0.75)), kind));
            }
            const std::vector<int32_t> found = sides_of_places(ground, loops[0].get(), loops[1].get(), near);
            const auto in = std::ranges::count(found, 1), out = std::ranges::count(found, -1);
            const nurbs_status status =
                checked(ground.surface.get(), {{loops[0].get()}, {loops[1].get()}}, 1e-9);
            if (in > 0 && out > 0) {
                EXPECT_EQ(status, NURBS_ERROR_CROSSING) << last_error();
                ++crossing;
            } else if (in == std::ssize(found) || out == std::ssize(found)) {
                EXPECT_EQ(status, NURBS_OK) << last_error();
                ++apart;
            }
        }
    }
    EXPECT_GT(crossing, 30);
    EXPECT_GT(apart, 60);
}

// By periods of closed axes, backwards, with other orders of loops and curves, and cut where it pleases.
TEST(FaceCrossings, do_not_depend_on_how_loops_are_stated) {
    Random random(44);
    int crossing = 0;
    for (int round = 0; round < 12; ++round) {
        for (const Ground &ground : grounds(random)) {
            std::array<SplineData, 2> data;
            for (SplineData &loop : data) {
                Star kind;
                kind.radius = random.between(0.1, 0.2);
                loop = star(random, ground,
                            ground.at(ground.closed[0] ? random.unit() : random.between(0.3, 0.7),
                                      ground.closed[1] ? random.unit() : random.between(0.3, 0.7)),
                            kind);
            }
            const Handle a = create(data[0]), b = create(data[1]);
            const nurbs_status expected = checked(ground.surface.get(), {{a.get()}, {b.get()}}, 1e-9);
            ASSERT_TRUE(expected == NURBS_OK || expected == NURBS_ERROR_CROSSING) << last_error();
            crossing += expected == NURBS_OK ? 0 : 1;
            SplineData copy = data[1];
            for (const size_t k : {size_t{0}, size_t{1}}) {
                const double shift = ground.closed[k] ? ground.period[k] * random.whole(-1, 1) : 0;
                for (size_t i = k; i < copy.points.size(); i += 2) {
                    copy.points[i] += shift;
                }
            }
            const Handle moved = create(copy);
            const Handle back = made([&](nurbs **out) { return nurbs_reverse(a.get(), 0, 0, out); });
            EXPECT_EQ(checked(ground.surface.get(), {{moved.get()}, {back.get()}}, 1e-9), expected);
            double ends[2];
            require_ok(nurbs_domain(a.get(), 0, ends));
            const double at = ends[0] + (ends[1] - ends[0]) * random.between(0.2, 0.8);
            nurbs *parts[2] = {};
            require_ok(nurbs_split(a.get(), 0, at, &parts[0], &parts[1]));
            const Handle first(parts[0]), second(parts[1]);
            EXPECT_EQ(checked(ground.surface.get(), {{second.get(), first.get()}, {moved.get()}}, 1e-9),
                      expected);
        }
    }
    EXPECT_GT(crossing, 10);
}

TEST(FaceCrossings, do_not_depend_on_units) {
    for (const double size : {1e-140, 1e-9, 1e9, 1e140}) {
        for (const double length : {1e-140, 1e-9, 1e9, 1e140}) {
            const Ground ground = plane(size, length);
            const auto square = [&](double lower, double upper) {
                const double a = lower * length, b = upper * length;
                return polygon({{a, a}, {b, a}, {b, b}, {a, b}});
            };
            const Handle outer = square(0.125, 0.75), inner = square(0.25, 0.5), other = square(0.375, 0.875);
            for (const double tolerance : {0.0, 1e-9 * size}) {
                EXPECT_EQ(checked(ground.surface.get(), {{outer.get()}, {inner.get()}}, tolerance), NURBS_OK)
                    << size << ' ' << length << last_error();
                EXPECT_EQ(checked(ground.surface.get(), {{outer.get()}, {other.get()}}, tolerance),
                          NURBS_ERROR_CROSSING)
                    << size << ' ' << length << last_error();
            }
        }
    }
}

// What overlaps by less than the tolerance is no crossing, and by more than a few times of it is one.
TEST(FaceCrossings, are_thicker_than_the_tolerance) {
    Random random(45);
    for (int round = 0; round < 100; ++round) {
        const double size = random.magnitude(1e-3, 1e3), wide = random.magnitude(1e-7, 1e-3);
        const Ground ground = plane(size);
        const double edge = random.between(0.3, 0.7);
        const Handle square = polygon({{0.1, 0.1}, {0.9, 0.1}, {0.9, edge}, {0.1, edge}});
        const Handle other = polygon({{0.3, edge - wide}, {0.7, edge - wide}, {0.8, 0.95}, {0.2, 0.95}});
        const Curves loops{{square.get()}, {other.get()}};
        EXPECT_EQ(checked(ground.surface.get(), loops, 1.001 * wide * size), NURBS_OK) << last_error();
        EXPECT_EQ(checked(ground.surface.get(), loops, 0.25 * wide * size), NURBS_ERROR_CROSSING);
    }
}

} // namespace

} // namespace face_crossings_test
