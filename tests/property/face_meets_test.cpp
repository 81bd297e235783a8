// Neighbours meet in the edges that they share and nowhere else: sides of boxes, however they lie and whatever gaps they have, and
// the faces of real files. NURBS_TEST_SCALE >= 2 runs all of these.
#include "blocks.h"
#include "face_meets.h"
#include "support/cases.h"
#include "support/scale.h"

#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>

namespace face_meets_test {

using namespace face_meets;
using namespace support::blocks;
using namespace support::models;
namespace solids = support::solids;

namespace {

constexpr double tolerance = 1e-8;

Point3 way_of(const Branch &branch) {
    const std::vector<Point3> ends = points_on(branch.space.get(), {branch.domain[0], branch.domain[1]});
    return {ends[1][0] - ends[0][0], ends[1][1] - ends[0][1], ends[1][2] - ends[0][2]};
}

} // namespace

TEST(FaceMeets, SidesOfBlocksMeetInTheirEdges) {
    for_each_case(6320000, 20, [](Random &random, uint64_t seed) {
        SCOPED_TRACE(seed);
        const double gap = random.chance(50) ? 0 : 1e-7;
        const Block block = random_block(random, gap);
        for (size_t i = 0; i < 6; ++i) {
            for (size_t j = 0; j < 6; ++j) {
                if (i == j) {
                    continue;
                }
                const FaceMeet found = face_meet(block.sides[i].get(), block.sides[j].get(), tolerance);
                const bool opposite = i / 2 == j / 2;
                const size_t along = 3 - i / 2 - j / 2;
                EXPECT_TRUE(found.complete()) << i << " and " << j;
                EXPECT_EQ(found.kinds,
                          opposite ? std::vector<int32_t>() : std::vector<int32_t>{NURBS_BRANCH_EDGE})
                    << i << " and " << j;
                if (!opposite) {
                    const double edge = std::sqrt(dot(block.edges[along], block.edges[along]));
                    EXPECT_NEAR(found.length(NURBS_BRANCH_EDGE), edge, 4 * gap * edge + 1e-9);
                    EXPECT_LE(found.crossing.found.branches[0].deviation, 4 * gap + 1e-12);
                    EXPECT_GT(dot(cross(normal_of(block, j / 2), normal_of(block, i / 2)),
                                  way_of(found.crossing.found.branches[0])),
                              0)
                        << i << " and " << j;
                }
            }
        }
    });
}

// Two faces that share an edge and cross again elsewhere: a floor, and a wave that rises from its side and comes down through it.
TEST(FaceMeets, NeighboursMayCrossElsewhere) {
    const Handle floor = solids::plane({0, 0, 0}, {4, 0, 0}, {0, 2, 0});
    const SplineData wave{{2, 1},
                          {3, 2},
                          {{0, 0, 0, 1, 1, 1}, {0, 0, 1, 1}},
                          3,
                          {0, 0, 0, 0, 2, 0, 1, 0, 2, 1, 2, 2, 3, 0, -1, 3, 2, -1},
                          {}};
    const Handle hill = create(wave);
    const Face a = solids::around_domain(floor, {0, 0, 0, -5}),
               b = solids::around_domain(hill, {0, 0, 0, -5});
    for (const bool exchanged : {false, true}) {
        const FaceMeet found =
            exchanged ? face_meet(b.get(), a.get(), tolerance) : face_meet(a.get(), b.get(), tolerance);
        EXPECT_TRUE(found.complete());
        EXPECT_EQ(found.count(NURBS_BRANCH_EDGE), 1);
        EXPECT_EQ(found.count(NURBS_BRANCH_CROSSING), 1);
        EXPECT_NEAR(found.length(NURBS_BRANCH_EDGE), 2, 1e-9);
        EXPECT_NEAR(found.length(NURBS_BRANCH_CROSSING), 2, 1e-7);
        const Ground on_floor(floor.get(), read_back(floor.get())), on_hill(hill.get(), wave);
        check_curves(found.crossing, exchanged ? on_hill : on_floor, exchanged ? on_floor : on_hill, 100);
        check_nodes(found.crossing, 1e-8);
    }
}

// The height .05 y - .1 y^2 is nowhere more than a few tolerances, the crossing at y = 1/2 as long as the edge: what is farther from
// an edge than faces stay by its side is not of it.
TEST(FaceMeets, CrossingsBesideFlatEdgesAreTold) {
    const Handle floor = solids::plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    const Handle hill = create({{1, 2},
                                {2, 3},
                                {{0, 0, 1, 1}, {0, 0, 0, 1, 1, 1}},
                                3,
                                {0, 0, 0, 0, 0.5, 0.025, 0, 1, -0.05, 1, 0, 0, 1, 0.5, 0.025, 1, 1, -0.05},
                                {}});
    const Face a = solids::around_domain(floor, {-5, 0, 0, 0}),
               b = solids::around_domain(hill, {-5, 0, 0, 0});
    for (const double near : {1e-6, 1e-4, 2e-3}) {
        const FaceMeet found = face_meet(a.get(), b.get(), near);
        EXPECT_EQ(found.count(NURBS_BRANCH_EDGE), 1) << near;
        EXPECT_EQ(found.count(NURBS_BRANCH_CROSSING), 1) << near;
        EXPECT_NEAR(found.length(NURBS_BRANCH_CROSSING), 1, near);
    }
}

namespace {

using Pair = std::pair<int64_t, int64_t>;

// Pairs of faces with common edges, and the lengths of these.
std::map<Pair, double> neighbours_in(const nurbs_model *model) {
    std::map<Pair, double> pairs;
    for (int64_t edge = 0; edge < counts_of(model).edges; ++edge) {
        double length = 0;
        require_ok(nurbs_curve_length(edge_of(model, edge).get(), nullptr, 1e-9, &length, nullptr));
        const std::vector<support::models::Place> uses = places_of(model, edge);
        std::set<Pair> own;
        for (const auto &a : uses) {
            for (const auto &b : uses) {
                if (a[0] < b[0]) {
                    own.emplace(a[0], b[0]);
                }
            }
        }
        for (const Pair &pair : own) {
            pairs[pair] += length;
        }
    }
    return pairs;
}

double size_of(const nurbs_face *face) {
    Point3 lower{}, upper{};
    require_ok(nurbs_face_box(face, 1e-3, lower.data(), upper.data(), nullptr));
    return surface_sections::distance(lower, upper);
}

Model sewn_together(const nurbs_model *model, double within) {
    std::vector<Face> faces;
    std::vector<const nurbs_face *> given;
    for (int64_t i = 0; i < counts_of(model).faces; ++i) {
        given.push_back(faces.emplace_back(face_of(model, i)).get());
    }
    nurbs_model *sewn = nullptr;
    require_ok(nurbs_model_sew(std::ssize(given), given.data(), within, 1, &sewn));
    return Model(sewn);
}

struct FileCase {
    const char *name;
    int64_t every;   // how many pairs there are for one that is looked at by default
    double sewn = 0; // within which faces that know no common edges are sewn
};

void PrintTo(const FileCase &file, std::ostream *out) { // a name that GoogleTest knows
    *out << file.name;
}

} // namespace

class FaceMeetsInFiles : public ::testing::TestWithParam<FileCase> {};

TEST_P(FaceMeetsInFiles, NeighboursMeetInTheirEdges) {
    const char *folder = std::getenv("NURBS_TEST_DATA");
    if (folder == nullptr) {
        GTEST_SKIP() << "NURBS_TEST_DATA is not set";
    }
    nurbs_model *made = nullptr;
    require_ok(
        nurbs_read_model_file((std::filesystem::path(folder) / GetParam().name).c_str(), nullptr, &made));
    const Model read(made);
    const Model sewn = GetParam().sewn > 0 ? sewn_together(read.get(), GetParam().sewn) : nullptr;
    const Model &model = sewn ? sewn : read;
    const std::map<Pair, double> pairs = neighbours_in(model.get());
    ASSERT_FALSE(pairs.empty());
    const int64_t every =
        scale() >= 2 ? 1
                     : static_cast<int64_t>(static_cast<double>(GetParam().every) / std::min(scale(), 1.0));
    int64_t number = 0, clear = 0, done = 0;
    for (const auto &[pair, length] : pairs) {
        if (number++ % every != 0) {
            continue;
        }
        SCOPED_TRACE(std::to_string(pair.first) + " and " + std::to_string(pair.second));
        const Face a = face_of(model.get(), pair.first), b = face_of(model.get(), pair.second);
        const FaceMeet found = face_meet(a.get(), b.get(), 1e-6 * size_of(a.get()));
        const double edges = found.length(NURBS_BRANCH_EDGE), contacts = found.length(NURBS_BRANCH_CONTACT);
        EXPECT_NEAR(edges + contacts, length, 1e-6 * length);
        EXPECT_EQ(found.count(NURBS_BRANCH_CROSSING), 0);
        done += found.complete() ? 1 : 0;
        if (contacts == 0) {
            EXPECT_TRUE(found.complete());
            ++clear;
        }
    }
    std::printf("%s: %lld pairs, %lld without contact, %lld complete\n", GetParam().name,
                static_cast<long long>((number + every - 1) / every), static_cast<long long>(clear),
                static_cast<long long>(done));
}

INSTANTIATE_TEST_SUITE_P(Files, FaceMeetsInFiles,
                         ::testing::Values(FileCase{"boxed_sphere.step", 32},
                                           FileCase{"countersunk_screw.step", 4},
                                           FileCase{"satellite_mainbody.stp", 5}, FileCase{"nacelle.stp", 7},
                                           FileCase{"stellarator_magnets.step", 4},
                                           FileCase{"goteborg_hull.iges", 1},
                                           FileCase{"pipe_hollow_deformed.iges", 1, 1e-2},
                                           FileCase{"iea15mw_blade.igs", 1, 1e-3}));

} // namespace face_meets_test
