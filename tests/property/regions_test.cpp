// Regions of the plane: areas add up exactly, the laws of sets hold, places are where both regions say, whatever curves cross,
// touch, or have in common.
#include "property/regions.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>

namespace regions_test {

using namespace support;
using namespace support::regions;

namespace {

constexpr double pi = std::numbers::pi;

// With spikes, or crossing itself where it goes around more than once.
Handle random_star(Random &random, const Point &center, double size) {
    const int corners = random.whole(5, 17), turns = random.chance(30) ? 2 : 1;
    const double start = random.between(0, 2 * pi);
    std::vector<Point> points;
    for (int i = 0; i < corners; ++i) {
        const double angle = start + 2 * pi * turns * i / corners, far = size * random.between(0.2, 1);
        points.push_back({center[0] + far * std::cos(angle), center[1] + far * std::sin(angle)});
    }
    return polygon(points);
}

// Whose control points are those of a star.
Handle random_smooth(Random &random, const Point &center, double size) {
    SplineData data{{3}, {0}, {{}}, 2, {}, {}};
    const int spans = random.whole(5, 11);
    const double start = random.between(0, 2 * pi);
    std::vector<Point> points;
    for (int i = 0; i < spans; ++i) {
        const double angle = start + 2 * pi * i / spans, far = size * random.between(0.3, 1.2);
        points.push_back({center[0] + far * std::cos(angle), center[1] + far * std::sin(angle)});
    }
    data.counts[0] = spans + 3;
    for (int i = 0; i < spans + 7; ++i) {
        data.knots[0].push_back(i - 3);
    }
    for (int i = 0; i < spans + 3; ++i) {
        const Point &x = points[static_cast<size_t>(i % spans)];
        data.points.insert(data.points.end(), x.begin(), x.end());
    }
    return create(data);
}

Curves random_curves(Random &random) {
    Curves curves;
    for (int i = random.whole(1, 3); i > 0; --i) {
        const Point center{random.between(-1, 1), random.between(-1, 1)};
        const double size = random.between(0.3, 1.5);
        switch (random.whole(0, 3)) {
        case 0:
            curves.push_back(circle(center[0], center[1], size));
            break;
        case 1:
            curves.push_back(random_smooth(random, center, size));
            break;
        default:
            curves.push_back(random_star(random, center, size));
        }
    }
    return curves;
}

Curves mapped(const Curves &curves, const double *matrix, const double *move) {
    Curves result;
    for (const Handle &curve : curves) {
        result.push_back(
            made([&](nurbs **out) { return nurbs_transform(curve.get(), 2, matrix, move, out); }));
    }
    return result;
}

bool is_near(const Curves &curves, const Vec &places, size_t i) {
    return std::ranges::any_of(curves, [&](const Handle &curve) {
        double distance = 0;
        require_ok(nurbs_closest_points(curve.get(), 1, &places[2 * i], 0, 0, nullptr, 1e-9, 0, nullptr, 0, 0,
                                        nullptr, 0, 0, &distance, 0, nullptr, 0));
        return distance < 5e-3;
    });
}

// On a coarse grid, so that corners and sides coincide.
Curves random_blocks(Random &random) {
    Curves curves;
    for (int i = random.whole(1, 4); i > 0; --i) {
        const int left = random.whole(0, 5), low = random.whole(0, 5);
        const int right = left + random.whole(1, 4), high = low + random.whole(1, 4);
        curves.push_back(
            random.chance(80)
                ? rectangle(left, low, right, high)
                : polygon({{1.0 * left, 1.0 * low}, {1.0 * right, 1.0 * low}, {1.0 * left, 1.0 * high}}));
    }
    return curves;
}

Vec random_places(Random &random, int count, double low, double high) {
    Vec places;
    for (int i = 0; i < 2 * count; ++i) {
        places.push_back(random.between(low, high));
    }
    return places;
}

bool holds(int32_t rule, bool in_a, bool in_b) {
    switch (rule) {
    case NURBS_REGION_UNION:
        return in_a || in_b;
    case NURBS_REGION_INTERSECTION:
        return in_a && in_b;
    case NURBS_REGION_DIFFERENCE:
        return in_a && !in_b;
    default:
        return in_a != in_b;
    }
}

constexpr std::array rules{NURBS_REGION_UNION, NURBS_REGION_INTERSECTION, NURBS_REGION_DIFFERENCE,
                           NURBS_REGION_EITHER};

void expect_places(const Model &a, const Model &b, const Vec &places) {
    const std::vector<int32_t> in_a = sides_of(a, places), in_b = sides_of(b, places);
    for (const int32_t rule : rules) {
        const std::vector<int32_t> found = sides_of(combine(rule, a, b), places);
        for (size_t i = 0; i < found.size(); ++i) {
            if (in_a[i] != 0 && in_b[i] != 0 && found[i] != 0) {
                ASSERT_EQ(found[i] > 0, holds(rule, in_a[i] > 0, in_b[i] > 0))
                    << "rule " << rule << " at " << places[2 * i] << ", " << places[2 * i + 1];
            }
        }
    }
}

void expect_areas(const Model &a, const Model &b) {
    const double of_a = area_of(a), of_b = area_of(b), all = area_of(combine(NURBS_REGION_UNION, a, b)),
                 common = area_of(combine(NURBS_REGION_INTERSECTION, a, b));
    const double size = of_a + of_b;
    EXPECT_NEAR(of_a + of_b, all + common, 1e-9 * size);
    EXPECT_NEAR(area_of(combine(NURBS_REGION_DIFFERENCE, a, b)), of_a - common, 1e-9 * size);
    EXPECT_NEAR(area_of(combine(NURBS_REGION_DIFFERENCE, b, a)), of_b - common, 1e-9 * size);
    EXPECT_NEAR(area_of(combine(NURBS_REGION_EITHER, a, b)), all - common, 1e-9 * size);
}

} // namespace

TEST(Regions, PlacesAreWhereBothSay) {
    for_each_case(8100, 60, [](Random &random, uint64_t) {
        const Model a = region(random_curves(random)), b = region(random_curves(random));
        expect_places(a, b, random_places(random, 1000, -2.5, 2.5));
    });
}

TEST(Regions, AreasAddUp) {
    for_each_case(8200, 60, [](Random &random, uint64_t) {
        expect_areas(region(random_curves(random)), region(random_curves(random)));
    });
}

TEST(Regions, SidesInCommon) {
    for_each_case(8300, 200, [](Random &random, uint64_t) {
        const Model a = region(random_blocks(random)), b = region(random_blocks(random));
        expect_areas(a, b);
        expect_places(a, b, random_places(random, 200, -0.5, 9.5));
    });
}

namespace {

Model split(const nurbs_face *face, const Curves &curves, double tolerance = 0) {
    std::vector<const nurbs *> given;
    for (const Handle &curve : curves) {
        given.push_back(curve.get());
    }
    nurbs_model *model = nullptr;
    require_ok(nurbs_face_split(face, std::ssize(given), given.data(), tolerance, &model));
    return Model(model);
}

Handle segment(const Point &from, const Point &to) {
    return create({{1}, {2}, {{0, 0, 1, 1}}, 2, {from[0], from[1], to[0], to[1]}, {}});
}

Handle line_through(Random &random) {
    const double angle = random.between(0, pi), off = random.between(-1, 1);
    const Point along{std::cos(angle), std::sin(angle)}, foot{-off * along[1], off * along[0]};
    return segment({foot[0] - 4 * along[0], foot[1] - 4 * along[1]},
                   {foot[0] + 4 * along[0], foot[1] + 4 * along[1]});
}

// Of the edges of a model: how many have one use, and two.
std::array<int64_t, 3> uses_of(const Model &model) {
    std::array<int64_t, 3> result{};
    for (int64_t i = 0; i < models::counts_of(model.get()).edges; ++i) {
        const auto uses = static_cast<size_t>(std::ssize(models::places_of(model.get(), i)));
        ++result.at(uses);
    }
    return result;
}

} // namespace

// Lines in general position divide a disk into 1 + lines + crossings inside of it; edges and nodes are those of a plane graph.
TEST(Regions, LinesDivideADisk) {
    for_each_case(8400, 60, [](Random &random, uint64_t) {
        Curves disk, lines;
        disk.push_back(circle(0, 0, 2));
        const Model whole = region(disk);
        for (int i = random.whole(0, 7); i > 0; --i) {
            lines.push_back(line_through(random));
        }
        int64_t crossings = 0;
        for (size_t i = 0; i < lines.size(); ++i) {
            for (size_t j = 0; j < i; ++j) {
                double at = -1;
                int64_t count = 0;
                require_ok(nurbs_curve_intersections(lines[i].get(), lines[j].get(), 0, 1, &at, nullptr,
                                                     nullptr, nullptr, nullptr, &count, nullptr));
                const Vec x = count == 0 ? Vec{9, 9} : eval(lines[i].get(), {at});
                crossings += std::hypot(x[0], x[1]) < 2 ? 1 : 0;
            }
        }
        const Model parts = split(models::face_of(whole.get(), 0).get(), lines);
        const models::ModelCounts counts = models::counts_of(parts.get());
        EXPECT_EQ(counts.faces, 1 + std::ssize(lines) + crossings);
        EXPECT_EQ(counts.euler(), 1);
        const auto uses = uses_of(parts);
        EXPECT_EQ(uses[2], std::ssize(lines) + 2 * crossings);
        EXPECT_NEAR(area_of(parts), 4 * pi, 1e-9);
    });
}

namespace {

// A circle of which the quarters run faster and faster, or slower and slower: their weights are 1, c / sqrt(2), c^2 by turns.
Handle uneven_circle(const Point &center, double radius, double start, double c) {
    SplineData data{{2}, {9}, {{0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}}, 2, {}, {}};
    for (int i = 0; i < 9; ++i) {
        const double angle = start + pi / 4 * i, far = radius * (i % 2 == 0 ? 1 : std::numbers::sqrt2);
        data.points.insert(data.points.end(),
                           {center[0] + far * std::cos(angle), center[1] + far * std::sin(angle)});
        data.weights.push_back(i % 2 == 1 ? c / std::numbers::sqrt2 : i % 4 == 0 ? 1 : c * c);
    }
    data.points[16] = data.points[0];
    data.points[17] = data.points[1];
    return create(data);
}

} // namespace

// However unevenly curves run, what they bound is the same.
TEST(Regions, WeightsFarApart) {
    for_each_case(8450, 40, [](Random &random, uint64_t seed) {
        SCOPED_TRACE(seed);
        const double c = std::pow(10, random.between(-3, 3));
        Curves disk, lines;
        disk.push_back(uneven_circle({0.1, -0.2}, 1.5, random.between(0, 2 * pi), c));
        const Model whole = region(disk);
        EXPECT_NEAR(area_of(whole), 2.25 * pi, 1e-9);
        lines.push_back(line_through(random));
        const Model parts = split(models::face_of(whole.get(), 0).get(), lines);
        EXPECT_EQ(models::counts_of(parts.get()).faces, 2);
        EXPECT_NEAR(area_of(parts), 2.25 * pi, 1e-9);
    });
}

namespace {

// Beyond both of them.
Model frame() {
    Curves curves;
    curves.push_back(rectangle(-4, -4, 4, 4));
    return region(curves);
}

// Equal to rounding: nothing is in one of them only.
void expect_equal(const Model &a, const Model &b) {
    EXPECT_NEAR(area_of(combine(NURBS_REGION_EITHER, a, b)), 0, 1e-9);
}

} // namespace

TEST(Regions, LawsOfSets) {
    for_each_case(8500, 30, [](Random &random, uint64_t) {
        const Model a = region(random_curves(random)), b = region(random_curves(random)), all = frame();
        const auto without = [&](const Model &x) { return combine(NURBS_REGION_DIFFERENCE, all, x); };
        expect_equal(without(combine(NURBS_REGION_UNION, a, b)),
                     combine(NURBS_REGION_INTERSECTION, without(a), without(b)));
        expect_equal(without(combine(NURBS_REGION_INTERSECTION, a, b)),
                     combine(NURBS_REGION_UNION, without(a), without(b)));
        expect_equal(without(without(a)), a);
        for (const int32_t rule : {NURBS_REGION_UNION, NURBS_REGION_INTERSECTION, NURBS_REGION_EITHER}) {
            expect_equal(combine(rule, a, b), combine(rule, b, a));
        }
    });
}

// What is cut and put together again has the borders that it had, where nothing else is.
TEST(Regions, IdenticalRegions) {
    for_each_case(8600, 60, [](Random &random, uint64_t) {
        Curves curves;
        curves.push_back(random.chance(50) ? random_smooth(random, {0, 0}, 1)
                                           : circle(0, 0, random.between(1, 2)));
        const Model a = region(curves);
        const models::ModelCounts counts = models::counts_of(a.get());
        for (const int32_t rule : {NURBS_REGION_UNION, NURBS_REGION_INTERSECTION}) {
            const Model same = combine(rule, a, a);
            EXPECT_EQ(models::counts_of(same.get()), counts);
            EXPECT_EQ(area_of(same), area_of(a));
        }
        for (const int32_t rule : {NURBS_REGION_DIFFERENCE, NURBS_REGION_EITHER}) {
            EXPECT_EQ(models::counts_of(combine(rule, a, a).get()).faces, 0);
        }
    });
}

TEST(Regions, RulesOfFillingAreTurnsAroundAPlace) {
    for_each_case(8700, 60, [](Random &random, uint64_t) {
        const Curves curves = random_curves(random);
        const Vec places = random_places(random, 100, -2.5, 2.5);
        std::vector<int> turns(places.size() / 2, 0);
        for (const Handle &curve : curves) {
            Vec params;
            double ends[2];
            require_ok(nurbs_domain(curve.get(), 0, ends));
            constexpr int samples = 4000;
            for (int i = 0; i <= samples; ++i) {
                params.push_back(std::min(ends[1], ends[0] + (ends[1] - ends[0]) * i / samples));
            }
            const Vec polygon = eval(curve.get(), params);
            for (size_t i = 0; i < turns.size(); ++i) {
                double angle = 0;
                for (size_t j = 0; j + 3 < polygon.size(); j += 2) {
                    const Point a{polygon[j] - places[2 * i], polygon[j + 1] - places[2 * i + 1]},
                        b{polygon[j + 2] - places[2 * i], polygon[j + 3] - places[2 * i + 1]};
                    angle += std::atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
                }
                turns[i] += static_cast<int>(std::lround(angle / (2 * pi)));
            }
        }
        for (const int32_t rule : {NURBS_FILL_NON_ZERO, NURBS_FILL_EVEN_ODD, NURBS_FILL_POSITIVE}) {
            const Model model = region(curves, rule);
            const std::vector<int32_t> sides = sides_of(model, places),
                                       beside = sides_of(model, places, 5e-3);
            for (size_t i = 0; i < sides.size(); ++i) {
                const bool inside = rule == NURBS_FILL_NON_ZERO   ? turns[i] != 0
                                    : rule == NURBS_FILL_EVEN_ODD ? turns[i] % 2 != 0
                                                                  : turns[i] > 0;
                // Where borders are left out nothing tells that a place is near one of the curves.
                EXPECT_TRUE(beside[i] == 0 || (sides[i] > 0) == inside || is_near(curves, places, i));
            }
        }
    });
}

// A cutter that goes back along its way, whichever edge comes first and whichever way it runs.
TEST(Regions, SpikesBoundNothing) {
    const auto side = [](const Point &a, const Point &b) {
        return create({{1}, {2}, {{0, 0, 1, 1}}, 2, {a[0], a[1], b[0], b[1]}, {}});
    };
    const Point corners[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (const bool turned : {false, true}) {
        const Point from{turned ? 0.5 : 1, 0}, to{turned ? 1 : 0.5, 0};
        for (const int32_t rule : {NURBS_FILL_NON_ZERO, NURBS_FILL_EVEN_ODD, NURBS_FILL_POSITIVE}) {
            Curves curves;
            curves.push_back(side(from, to));
            curves.push_back(side(to, from));
            for (size_t i = 0; i < 4; ++i) {
                curves.push_back(side(corners[i], corners[(i + 1) % 4]));
            }
            EXPECT_NEAR(area_of(region(curves, rule)), 1, 1e-12); // as it is asked for
        }
    }
    Curves outline;
    const Point way[] = {{0.5, 0}, {0.25, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}, {0.5, 0}};
    for (size_t i = 0; i + 1 < std::size(way); ++i) {
        outline.push_back(side(way[i], way[i + 1]));
    }
    EXPECT_NEAR(area_of(region(outline)), 1, 1e-12);
}

// Areas grow with the map, whatever it does to directions; powers of two change no bit.
TEST(Regions, FollowAffineMaps) {
    for_each_case(8800, 30, [](Random &random, uint64_t) {
        const Curves a = random_curves(random), b = random_curves(random);
        const double matrix[] = {random.between(0.5, 2), random.between(-1, 1), random.between(-1, 1) - 2,
                                 random.between(0.5, 2)};
        const double move[] = {random.between(-9, 9), random.between(-9, 9)};
        const double grows = std::abs(matrix[0] * matrix[3] - matrix[1] * matrix[2]);
        const Model plain = combine(NURBS_REGION_DIFFERENCE, region(a), region(b));
        const Model image = combine(NURBS_REGION_DIFFERENCE, region(mapped(a, matrix, move)),
                                    region(mapped(b, matrix, move)));
        EXPECT_NEAR(area_of(image), grows * area_of(plain), 1e-9 * grows);
        EXPECT_EQ(models::counts_of(image.get()).faces, models::counts_of(plain.get()).faces);
        const double twice[] = {0x1p-20, 0, 0, 0x1p-20};
        const Model small = combine(NURBS_REGION_DIFFERENCE, region(mapped(a, twice, nullptr)),
                                    region(mapped(b, twice, nullptr)));
        EXPECT_EQ(models::counts_of(small.get()), models::counts_of(plain.get()));
    });
}

// Sides that are apart by less than the tolerance are in common, and by more are not.
TEST(Regions, SidesWithinTheTolerance) {
    for (const double gap : {1e-9, -1e-9, 1e-7, -1e-7}) {
        Curves left, right;
        left.push_back(rectangle(0, 0, 1, 1));
        right.push_back(rectangle(1 + gap, 0, 2, 1));
        const Model all = combine(NURBS_REGION_UNION, region(left, NURBS_FILL_NON_ZERO, 1e-6),
                                  region(right, NURBS_FILL_NON_ZERO, 1e-6));
        EXPECT_EQ(models::counts_of(all.get()).faces, 1);
        EXPECT_NEAR(area_of(all), 2, 1e-6);
        const Model apart = combine(NURBS_REGION_UNION, region(left), region(right));
        EXPECT_EQ(models::counts_of(apart.get()).faces, gap > 0 ? 2 : 1);
    }
}

// The parts of a face cover it, and put together are the face.
TEST(Regions, PartsAreTheWhole) {
    for_each_case(8900, 40, [](Random &random, uint64_t) {
        const Model whole = region(random_curves(random));
        Curves curves = random_curves(random);
        curves.push_back(line_through(random));
        for (const models::Face &face : faces_of(whole.get())) {
            const Model parts = split(face.get(), curves);
            const Model one = models::model_of({face.get()});
            EXPECT_NEAR(area_of(parts), area_of(one), 1e-9);
            expect_equal(combine(NURBS_REGION_UNION, parts, Model(nullptr)), one);
            for (const auto uses : {uses_of(parts)}) {
                EXPECT_EQ(uses[0], 0);
            }
            const Vec places = random_places(random, 300, -2.5, 2.5);
            const std::vector<int32_t> in_whole = sides_of(one, places), in_parts = sides_of(parts, places);
            for (size_t i = 0; i < in_whole.size(); ++i) {
                EXPECT_TRUE(in_whole[i] == 0 || in_parts[i] == 0 || in_whole[i] == in_parts[i]);
            }
        }
    });
}

// Far from the origin ends agree to the rounding of their coordinates, whatever the size of the shape.
TEST(Regions, FarFromTheOrigin) {
    const double size = 100;
    for (const double far : {1e3, 5e6, -5e6, 3e9}) {
        const double next = std::nextafter(far, 2 * far); // to be closed by a segment of one rounding
        const Point corners[] = {{far, far}, {far + size, far}, {far + size, far + size}, {far, far + size}};
        for (const bool exact : {true, false}) {
            Curves sides;
            for (size_t i = 0; i < 4; ++i) {
                sides.push_back(
                    segment(corners[i], i == 3 && !exact ? Point{next, far} : corners[(i + 1) % 4]));
            }
            Model square;
            ASSERT_EQ(try_region(sides, NURBS_FILL_NON_ZERO, 0, square), NURBS_OK) << far;
            EXPECT_NEAR(area_of(square), size * size, 1e-14 * std::abs(far) * size);
        }
    }
}

// Where they are cut, curves in the domain begin and end in nodes, bit for bit, wherever the domain lies.
TEST(Regions, CutsEndInNodesFarFromTheOrigin) {
    for (const double far : {0.0, 1e3, 1e6, -1e6}) {
        Curves square;
        square.push_back(rectangle(far, far, far + 1, far + 1));
        const Model whole = region(square);
        for_each_case(8860, 10, [&](Random &random, uint64_t) {
            Curves lines;
            const auto at = [&] { return far + random.between(0.1, 0.9); };
            for (int i = 0; i < 3; ++i) {
                lines.push_back(segment({far - 0.01, at()}, {far + 1.01, at()}));
                lines.push_back(segment({at(), far - 0.01}, {at(), far + 1.01}));
            }
            const Model parts = split(models::face_of(whole.get(), 0).get(), lines);
            EXPECT_NEAR(models::area_of(parts.get(), 1e-8), 1, 1e-8);
            for (const models::Face &face : faces_of(parts.get())) {
                for (const auto &loop : loops_of(face.get())) {
                    for (size_t i = 0; i < loop.size(); ++i) {
                        const Use &use = loop[i], &next = loop[(i + 1) % loop.size()];
                        EXPECT_EQ(end_of(use.curve.get(), true), end_of(next.curve.get(), false));
                        EXPECT_EQ(end_of(use.edge.get(), use.key > 0), end_of(next.edge.get(), next.key < 0));
                    }
                }
            }
        });
    }
}

// A patch of degree 0 along one axis jumps there: a parallelogram of control points is no plane.
TEST(Regions, EdgesOnPatchesOfDegreeZero) {
    const Handle surface =
        create({{0, 1}, {2, 2}, {{0, 0.5, 1}, {0, 0, 1, 1}}, 3, {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0}, {}});
    const Handle border = rectangle(0.1, 0.1, 0.4, 0.9);
    const nurbs *loop = border.get();
    const int64_t size = 1;
    nurbs_face *out = nullptr;
    require_ok(nurbs_face_create(surface.get(), 1, &size, &loop, nullptr, nullptr, 1e-9, 0, nullptr, &out));
    const models::Face face(out);
    Curves lines;
    lines.push_back(segment({0, 0.4}, {0.5, 0.6}));
    const Model parts = split(face.get(), lines);
    const models::ModelCounts counts = models::counts_of(parts.get());
    EXPECT_EQ(counts.faces, 2);
    for (int64_t i = 0; i < counts.edges; ++i) {
        const Handle edge = models::edge_of(parts.get(), i);
        for (const bool upper : {false, true}) {
            EXPECT_EQ(end_of(edge.get(), upper)[0], 0);
        }
    }
}

} // namespace regions_test
