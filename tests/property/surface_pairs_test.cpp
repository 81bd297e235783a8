// Branches of random pairs of surfaces are those that an oracle proves to be all, in whatever form the surfaces are given.
#include "surface_pairs.h"

#include "bench/meets/pairs.h"
#include "models.h"
#include "real_files.h"

#include <numbers>

namespace surface_pairs_test {

using namespace surface_crossings;

namespace {

constexpr double tolerance = 1e-6;

struct Met {
    Handle a, b;
    Crossing crossing;
    reference::PairCount count;
};
Met met_of(const Pair &pair) {
    Met met{create(pair.a), create(pair.b), {}, reference::count_curves(pair.a, pair.b)};
    met.crossing = crossing_of(met.a.get(), met.b.get(), tolerance);
    return met;
}

// With the oracle; curves are looked at in so many places.
Met compared(const Pair &pair, int places, Tally &tally) {
    Met met = met_of(pair);
    compare(met.crossing, met.count, tally);
    check_places(met.crossing, met.a.get(), met.count, 2 * tolerance);
    check_curves(met.crossing, Ground(met.a.get(), pair.a), Ground(met.b.get(), pair.b), places);
    check_nodes(met.crossing, 1e-9);
    return met;
}

TEST(SurfacePairsSizes, BranchesAreThoseOfTheOracle) {
    Random random(0x5d01);
    Tally tally;
    const int64_t cases = scaled(100);
    for (int64_t i = 0; i < cases; ++i) {
        SCOPED_TRACE(i);
        check_closed_branches(compared(random_pair(random), 1000, tally).crossing);
    }
    tally.tell();
    EXPECT_GE(tally.compared, cases * 99 / 100);
    EXPECT_GE(tally.open, cases);
    EXPECT_GE(tally.closed, cases / 10);
}

// Curves that pass kinks are cut there: pieces of polynomials that go on beyond their borders are none of theirs, and leave nothing open.
TEST(SurfacePairsSizes, BranchesOfSurfacesWithKinks) {
    Random random(0x5d06);
    Tally tally;
    const int64_t cases = scaled(100);
    for (int64_t i = 0; i < cases; ++i) {
        SCOPED_TRACE(i);
        const Met met = compared(kinked_pair(random), 100, tally);
        const Crossing exchanged = crossing_of(met.b.get(), met.a.get(), tolerance);
        EXPECT_EQ(exchanged.open_ways, met.crossing.open_ways);
        EXPECT_EQ(exchanged.closed_ways, met.crossing.closed_ways);
    }
    tally.tell();
    EXPECT_GE(tally.compared, cases * 99 / 100);
    EXPECT_GE(tally.open, cases);
}

// Curves that leave a surface where they all but run along a knot: parts beyond it have none of them, and are not left open.
TEST(SurfacePairs, BesideKnots) {
    Random random(0x5d01);
    Tally tally;
    for (int64_t i = 0; i <= 4986; ++i) {
        const Pair pair = random_pair(random);
        if (i == 3176 || i == 4986) {
            const Met met = met_of(pair);
            compare(met.crossing, met.count, tally);
        }
    }
    EXPECT_EQ(tally.compared, 2);
    EXPECT_EQ(tally.open, 7);
}

Handle mapped(const nurbs *g, const std::array<double, 16> &matrix) {
    return made([&](nurbs **out) { return nurbs_transform_projective(g, 3, matrix.data(), out); });
}
// The last rows are positive on all pairs.
constexpr std::array<double, 16> affine{1.1, 0.3, -0.2, 0.7, 0, 0.8, 0.5, -0.4, 0.1, 0, 1.3, 0.2, 0, 0, 0, 1},
    projective{1, 0.2, -0.1, 0.3, 0.1, 0.9, 0.2, -0.2, -0.1, 0.1, 1.2, 0.1, 0.2, -0.15, 0.1, 1.5};

TEST(SurfacePairsSizes, FormsChangeNoCount) {
    Random random(0x5d02);
    std::array<Tally, 6> tallies;
    const int64_t cases = scaled(40);
    for (int64_t i = 0; i < cases; ++i) {
        SCOPED_TRACE(i);
        const Pair pair = random_pair(random);
        const Handle a = create(pair.a), b = create(pair.b);
        const reference::PairCount count = reference::count_curves(pair.a, pair.b);
        const auto expect = [&](size_t law, const nurbs *first, const nurbs *second) {
            SCOPED_TRACE(law);
            compare(crossing_of(first, second, tolerance), count, tallies[law]);
        };
        expect(0, b.get(), a.get());
        const int32_t axis = random.whole(0, 1);
        const Handle fine = made([&](nurbs **out) { return nurbs_refine_uniform(a.get(), axis, 3, out); });
        expect(1, fine.get(), b.get());
        expect(2, a.get(), elevate(b.get(), axis, 1).get());
        expect(3, mapped(a.get(), affine).get(), mapped(b.get(), affine).get());
        expect(4, mapped(a.get(), projective).get(), mapped(b.get(), projective).get());
        const Handle same = made([&](nurbs **out) { return nurbs_clone(b.get(), out); });
        expect(5, a.get(),
               disguised(random, made([&](nurbs **out) { return nurbs_clone(same.get(), out); }), 2).get());
    }
    for (const Tally &tally : tallies) {
        tally.tell();
        EXPECT_GE(tally.compared, cases * 97 / 100);
    }
}

// A bowl anywhere in space, of size 1 from corner to corner of its box, which a plane cuts in an ellipse that is so long and wide, about.
Pair bowl_with_loop(Random &random, double diameter) {
    const double a = random.between(0.8, 1.2), b = random.between(-0.5, 0.5), c = random.between(0.8, 1.2);
    SplineData bowl = quadratic_graph(a, b, c, 0, random.between(-1.4, -0.6), random.between(-1.4, -0.6));
    Point3 lower{HUGE_VAL, HUGE_VAL, HUGE_VAL}, upper{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    for (size_t i = 0; i < bowl.points.size(); ++i) {
        lower[i % 3] = std::min(lower[i % 3], bowl.points[i]);
        upper[i % 3] = std::max(upper[i % 3], bowl.points[i]);
    }
    const double size = distance(lower, upper), radius = diameter * size / 2;
    SplineData plane = net_of({2, 2}, {1, 1}, false, [=](double u, double v) {
        return std::array<double, 4>{4 * u - 2, 4 * v - 2, radius * radius, 1};
    });
    Pair pair{support::scaled(bowl, 1 / size), support::scaled(plane, 1 / size)};
    const Motion motion = random_motion(random, 3, 1, 0.3);
    move(pair.a, motion);
    move(pair.b, motion);
    return pair;
}

// Told to a tenth of what they are large.
TEST(SurfacePairs, SmallLoopsAreFound) {
    Random random(0x5d04);
    const int64_t cases = scaled(10);
    for (const double diameter : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 4e-6}) {
        for (int64_t i = 0; i < cases; ++i) {
            SCOPED_TRACE(testing::Message() << diameter << ", " << i);
            const Pair pair = bowl_with_loop(random, diameter);
            const Handle a = create(pair.a), b = create(pair.b);
            const Crossing crossing = crossing_of(a.get(), b.get(), diameter / 10);
            EXPECT_TRUE(crossing.found.complete);
            EXPECT_TRUE(crossing.found.nodes.empty());
            ASSERT_EQ(crossing.kinds, std::vector<int32_t>{NURBS_BRANCH_CROSSING});
            EXPECT_EQ(crossing.closed_ways, 1);
            EXPECT_LE(crossing.found.branches[0].deviation, diameter / 10);
            EXPECT_NEAR(length_of(crossing.found) / diameter, std::numbers::pi, 0.6);
            check_curves(crossing, Ground(a.get(), pair.a), Ground(b.get(), pair.b));
        }
    }
}

// Down to where double precision does not tell them from touches there is a loop, or a node that says that there may be one.
TEST(SurfacePairs, SmallerLoopsAreNotLost) {
    Random random(0x5d05);
    const int64_t cases = scaled(10);
    int64_t loops = 0;
    for (const double diameter : {2e-6, 1e-6, 5e-7, 2e-7, 1e-7, 1e-8}) {
        for (int64_t i = 0; i < cases; ++i) {
            SCOPED_TRACE(testing::Message() << diameter << ", " << i);
            const Pair pair = bowl_with_loop(random, diameter);
            const Handle a = create(pair.a), b = create(pair.b);
            const Crossing crossing = crossing_of(a.get(), b.get(), diameter / 10);
            const bool loop = crossing.closed_ways == 1 && crossing.found.complete;
            EXPECT_EQ(crossing.found.nodes.empty(), loop);
            EXPECT_TRUE(loop ||
                        crossing.found.count(NURBS_NODE_TOUCH) + crossing.found.count(NURBS_NODE_UNDECIDED) >
                            0);
            loops += loop ? 1 : 0;
        }
    }
    EXPECT_GE(loops, cases);
    EXPECT_LT(loops, 6 * cases);
}

SplineData data_of_net(const bench::meets::Net &net) {
    SplineData data{{3, 3}, {net.counts[0], net.counts[1]}, {net.knots[0], net.knots[1]}, 3, {}, {}, 0};
    for (const bench::meets::Point &x : net.points) {
        data.points.insert(data.points.end(), x.begin(), x.end());
    }
    return data;
}

// Crests that are hardly above a surface: two curves side by side each, known ones, within the usual limit of work.
TEST(SurfacePairs, SmallAngles) {
    const bench::meets::Pair known = bench::meets::pair_of("near");
    const Handle a = create(data_of_net(known.a)), b = create(data_of_net(known.b));
    const Crossing crossing = crossing_of(a.get(), b.get(), tolerance);
    EXPECT_TRUE(crossing.found.complete);
    EXPECT_EQ(crossing.open_ways, 6);
    EXPECT_EQ(crossing.closed_ways, 0);
    for (const Branch &branch : crossing.found.branches) {
        EXPECT_LE(branch.deviation, tolerance);
        for (const Point3 &x : points_on(branch.space.get(), branch.params(10))) {
            EXPECT_LE(bench::meets::distance_from(known, x), branch.deviation + 1e-12);
        }
    }
}

// Within the unit ball about the origin.
SplineData of_unit_size(SplineData data) {
    const Point3 centre{data.points[0], data.points[1], data.points[2]};
    data = support::moved(data, {-centre[0], -centre[1], -centre[2]});
    return support::scaled(data, 1 / extent(data));
}

// What the oracle can take, and no more pieces than it can do in a fraction of a second.
bool suits(const SplineData &data) {
    if (data.axes() != 2 || data.dim != 3 || extent(data) == 0 || data.point_count() > 400) {
        return false;
    }
    return std::ranges::all_of(data.degrees, [](int32_t p) { return p >= 1 && p <= 9; }) &&
           std::ranges::all_of(data.weights, [](double w) { return w > 0; });
}

// The surfaces of faces, of which some models have a thousand that are much the same.
void add_surfaces(const std::filesystem::path &file, std::vector<SplineData> &surfaces) {
    nurbs_model *made_model = nullptr;
    require_ok(nurbs_read_model_file(file.c_str(), nullptr, &made_model));
    const models::Model model(made_model);
    const int64_t faces = models::counts_of(model.get()).faces, step = 1 + faces / 40;
    for (int64_t i = 0; i < faces; i += step) {
        const models::Face face = models::face_of(model.get(), i);
        const SplineData data =
            read_back(made([&](nurbs **out) { return nurbs_face_surface(face.get(), out); }).get());
        if (suits(data)) {
            surfaces.push_back(of_unit_size(data));
        }
    }
}

// A patch with the same parameters in the plane, where those are of one to one, and with values of a function of these times a factor
// added to it.
struct Parting {
    SplineData a, b;
    SplineData values; // (u, v, f)
};
Parting parting(Random &random, double factor) {
    const std::array<int, 2> counts{random.whole(4, 7), random.whole(4, 7)};
    Parting made;
    made.a = net_of(counts, {3, 3}, false, [&](double u, double v) {
        return std::array<double, 4>{2 * u - 1 + random.between(-0.04, 0.04),
                                     2 * v - 1 + random.between(-0.04, 0.04), random.between(-0.3, 0.3), 1};
    });
    made.b = made.values = made.a;
    for (size_t i = 0; i < made.a.points.size(); i += 3) {
        const double f = random.between(-1, 1);
        made.b.points[i + 2] += factor * f;
        made.values.points[i + 2] = f;
    }
    return made;
}

// What a and a + factor f have in common is where f is 0, whatever the factor: the ways are as many as those of the section of f,
// which knows nothing of pairs.
TEST(SurfacePairsSizes, SmallAnglesChangeNoCount) {
    constexpr std::array<double, 3> up{0, 0, 1};
    constexpr double level = 0;
    // Case 5 of the second one has curves that turn where planes of tangents are nearly one.
    std::array<Random, 2> randoms{Random(0x5d07), Random(2)};
    const int64_t cases = scaled(15);
    int64_t told = 0, of_all = 0, ways = 0;
    for (int64_t i = 0; i < cases; ++i) {
        Random &random = randoms[static_cast<size_t>(i / 8 % 2)];
        for (const double factor : {1e-1, 1e-2, 1e-3}) {
            SCOPED_TRACE(testing::Message() << i << ", " << factor);
            const Parting pair = parting(random, factor);
            const Handle a = create(pair.a), values = create(pair.values),
                         b = disguised(random, create(pair.b), 2);
            const Crossing crossing = crossing_of(a.get(), b.get(), tolerance);
            nurbs_meet *out = nullptr;
            require_ok(nurbs_surface_sections(values.get(), up.data(), 1, &level, tolerance, &out));
            const MeetHandle meet(out);
            Crossing section;
            section.found = found_in(meet.get());
            count_ways(meet.get(), section);
            ++of_all;
            // Ways end where surfaces are within the tolerance of each other and branches are not separated.
            const bool touches = std::ranges::any_of(
                crossing.found.nodes, [](const MeetPart &node) { return node.kind == NURBS_NODE_TOUCH; });
            if (crossing.found.complete && section.found.complete && !touches) {
                ++told;
                ways += section.open_ways + section.closed_ways;
                EXPECT_EQ(crossing.open_ways, section.open_ways);
                EXPECT_EQ(crossing.closed_ways, section.closed_ways);
            }
            check_curves(crossing, Ground(a.get(), pair.a), Ground(b.get(), pair.b), 100);
        }
    }
    std::printf("%lld of %lld pairs, %lld ways\n", static_cast<long long>(told),
                static_cast<long long>(of_all), static_cast<long long>(ways));
    EXPECT_GE(told, of_all / 2);
    EXPECT_GE(ways, told);
}

class SurfacePairsFilesSizes : public RealFiles {};

// Surfaces of files, one of which lies anyhow so that it has a point of the other one.
TEST_F(SurfacePairsFilesSizes, BranchesAreThoseOfTheOracle) {
    std::vector<SplineData> surfaces;
    for (const RealSpline &spline : json()) {
        if (suits(spline.data)) {
            surfaces.push_back(of_unit_size(spline.data));
        }
    }
    std::vector<std::filesystem::path> files;
    for (const auto &entry : std::filesystem::directory_iterator(std::getenv("NURBS_TEST_DATA"))) {
        const std::string kind = entry.path().extension();
        if (kind == ".iges" || kind == ".igs" || kind == ".step" || kind == ".stp") {
            files.push_back(entry.path());
        }
    }
    std::ranges::sort(files); // cases are the same everywhere
    for (const auto &file : files) {
        add_surfaces(file, surfaces);
    }
    ASSERT_FALSE(surfaces.empty());
    const auto any = [&](Random &random) -> const SplineData & {
        return surfaces[static_cast<size_t>(random.whole(0, static_cast<int>(surfaces.size()) - 1))];
    };
    const auto any_point = [](Random &random, const SplineData &data) {
        const Handle g = create(data);
        const auto at = [&](int axis) {
            const double t = random.unit();
            return (1 - t) * data.lower(axis) + t * data.upper(axis);
        };
        const double u = at(0), v = at(1);
        return point_at(g.get(), u, v);
    };
    Random random(0x5d03);
    Tally tally;
    const int64_t cases = scaled(40);
    for (int64_t i = 0; i < cases; ++i) {
        SCOPED_TRACE(i);
        Pair pair{any(random), any(random)};
        move(pair.b, random_motion(random, 3, 1, 0));
        const Point3 to = any_point(random, pair.a), from = any_point(random, pair.b);
        pair.b = support::moved(pair.b, {to[0] - from[0], to[1] - from[1], to[2] - from[2]});
        const Met met = met_of(pair);
        compare(met.crossing, met.count, tally);
        check_curves(met.crossing, Ground(met.a.get(), pair.a), Ground(met.b.get(), pair.b), 100);
    }
    std::printf("%zu surfaces: ", surfaces.size());
    tally.tell();
    EXPECT_GE(tally.compared, cases * 3 / 4);
    EXPECT_GE(tally.open, cases / 2);
}

} // namespace

} // namespace surface_pairs_test
