// Models that stand on each other: the region that two of their faces have in common is told, and around it nothing else.
#include "blocks.h"
#include "face_regions.h"
#include "faces.h"
#include "polygons.h"
#include "solids.h"
#include "support/cases.h"

#include <numbers>

namespace model_regions_test {

using namespace face_regions;
using namespace support;
using namespace support::models;
using blocks::Block;

namespace {

constexpr double tolerance = 1e-7;

using polygons::Corner;

// A parallelogram in the plane z = 0, and a direction up or down.
struct Column {
    Corner corner, u, v;
    Point3 up;

    [[nodiscard]] std::vector<Corner> base() const {
        std::vector<Corner> at{corner, corner, corner, corner};
        for (size_t k = 0; k < 2; ++k) {
            at[1][k] += u[k];
            at[2][k] += u[k] + v[k];
            at[3][k] += v[k];
        }
        return at;
    }
    // Sides 4 and 5 are that in the plane z = 0, and that opposite.
    [[nodiscard]] Block block() const {
        Block block;
        block.origin = {corner[0], corner[1], 0};
        block.edges = {Point3{u[0], u[1], 0}, Point3{v[0], v[1], 0}, up};
        return block;
    }
};

Model model_of(const Column &column) {
    const Block block = blocks::with_sides(column.block());
    std::vector<const nurbs_face *> faces;
    for (const models::Face &side : block.sides) {
        faces.push_back(side.get());
    }
    return models::model_of(faces);
}

struct Touch {
    Overlap overlap;
    std::vector<int64_t> faces, faces_second;
    int64_t closed = 0, open = 0; // ways
};

Touch touch_of(const nurbs_model *a, const nurbs_model *b) {
    nurbs_meet *made = nullptr;
    require_ok(nurbs_model_intersections(a, b, tolerance, &made));
    const MeetHandle meet(made);
    Touch touch{overlap_in(meet.get()), {}, {}};
    const auto n = touch.overlap.crossing.kinds.size();
    touch.faces.resize(n);
    touch.faces_second.resize(n);
    require_ok(nurbs_meet_faces(meet.get(), std::ssize(touch.faces), touch.faces.data(), nullptr, nullptr));
    require_ok(nurbs_meet_faces_second(meet.get(), std::ssize(touch.faces), touch.faces_second.data(),
                                       nullptr, nullptr));
    return touch;
}

// In the plane z = 0.
double area_of(const Touch &touch) {
    double area = 0;
    for (const Region &region : touch.overlap.regions) {
        double own = 0;
        for (const std::vector<size_t> &loop : region.loops) {
            for (const size_t i : loop) {
                const Branch &branch = touch.overlap.crossing.found.branches[i];
                const std::vector<Point3> x = points_on(branch.space.get(), branch.params(4));
                for (size_t k = 0; k + 1 < x.size(); ++k) {
                    own += (x[k][0] * x[k + 1][1] - x[k + 1][0] * x[k][1]) / 2;
                }
            }
        }
        area += std::abs(own);
    }
    return area;
}

Column random_column(Random &random, double up) {
    Column column{{random.between(-0.8, 0), random.between(-0.8, 0)},
                  {random.between(0.6, 1.5), random.between(-0.3, 0.3)},
                  {random.between(-0.3, 0.3), random.between(0.6, 1.5)},
                  {random.between(-0.4, 0.4), random.between(-0.4, 0.4), up}};
    return column;
}

void expect_touch(const Column &lower, const Column &upper, double area, int64_t edges) {
    const Model a = model_of(lower), b = model_of(upper);
    for (const bool exchanged : {false, true}) {
        const Touch touch = exchanged ? touch_of(b.get(), a.get()) : touch_of(a.get(), b.get());
        EXPECT_TRUE(touch.overlap.crossing.found.complete);
        EXPECT_EQ(touch.overlap.regions.size(), area > 0 ? 1U : 0U);
        EXPECT_NEAR(area_of(touch), area, 1e-9);
        EXPECT_EQ(std::ranges::count(touch.overlap.crossing.kinds, NURBS_BRANCH_CROSSING), 0);
        EXPECT_EQ(std::ranges::count(touch.overlap.crossing.kinds, NURBS_BRANCH_EDGE), edges);
        check_loops(touch.overlap);
        for (const Region &region : touch.overlap.regions) {
            ASSERT_EQ(region.loops.size(), 1U);
            for (const size_t i : region.loops[0]) {
                EXPECT_EQ(touch.faces[i], 4);
                EXPECT_EQ(touch.faces_second[i], 4);
            }
        }
    }
}

} // namespace

TEST(ModelRegions, ColumnsOnEachOther) {
    int64_t met = 0;
    for_each_case(7730000, 12, [&](Random &random, uint64_t seed) {
        SCOPED_TRACE(seed);
        const Column lower = random_column(random, -1), upper = random_column(random, 1.2);
        const double area = polygons::area_of(polygons::common_part(lower.base(), upper.base()));
        if (area > 1e-3) {
            expect_touch(lower, upper, area, 0);
            ++met;
        }
    });
    EXPECT_GE(met, of_whole_run(8));
}

// Sides in one plane share the edges between them.
TEST(ModelRegions, BoxesOnEachOther) {
    const auto box = [](double x, double y, double width, double depth, double up) {
        return Column{{x, y}, {width, 0}, {0, depth}, {0, 0, up}};
    };
    const Column lower = box(0, 0, 1, 1, -1);
    expect_touch(lower, box(0.25, 0.25, 0.5, 0.5, 1), 0.25, 0);
    expect_touch(lower, box(0, 0, 1, 1, 1), 1, 4);
    expect_touch(lower, box(0, 0.25, 1, 0.5, 1), 0.5, 2);
    expect_touch(lower, box(0.5, 0.5, 1, 1, 1), 0.25, 0);
    expect_touch(lower, box(-1, -1, 3, 3, 1), 1, 0);
    expect_touch(lower, box(1, 0, 1, 1, 1), 0, 4); // an edge of four sides
    expect_touch(lower, box(1, 1, 1, 1, 1), 0, 0);
}

namespace {

constexpr double pi = std::numbers::pi;

// A cylinder of radius 1 around the z axis, whose seam is turned.
Handle tube(double low, double high, double angle) {
    const Handle whole = std::move(faces::cylinder(1, high - low).surface);
    const double c = std::cos(angle), s = std::sin(angle);
    const double matrix[] = {c, -s, 0, s, c, 0, 0, 0, 1}, move[] = {0, 0, low};
    return made([&](nurbs **out) { return nurbs_transform(whole.get(), 3, matrix, move, out); });
}
models::Face face_of(const Handle &surface, const faces::Curves &loops) {
    return models::Face(faces::face_of(surface.get(), loops).release());
}
// The square [-2, 2]^2 at a height: all of it, the disc of radius 1 in it, or what is around that.
enum class Plate { whole, disc, ring };
models::Face plate(double z, Plate kind) {
    const Handle surface = support::solids::plane({-2, -2, z}, {4, 0, 0}, {0, 4, 0}),
                 square = faces::polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    const double centre[] = {0.5, 0.5};
    const Handle circle = made([&](nurbs **out) {
        return nurbs_curve_circle(2, centre, nullptr, nullptr, 0.25, NURBS_ARC_QUARTERS, out);
    });
    faces::Curves loops;
    if (kind != Plate::disc) {
        loops.push_back({square.get()});
    }
    if (kind != Plate::whole) {
        loops.push_back({circle.get()});
    }
    return face_of(surface, loops);
}
Model pin() {
    const models::Face side = face_of(tube(0, 2, 0), {}), low = plate(0, Plate::disc),
                       high = plate(2, Plate::disc);
    return models::model_of({side.get(), low.get(), high.get()});
}

void expect_round(const Model &a, const Model &b, size_t regions, double length) {
    for (const bool exchanged : {false, true}) {
        const Touch touch = exchanged ? touch_of(b.get(), a.get()) : touch_of(a.get(), b.get());
        EXPECT_TRUE(touch.overlap.crossing.found.complete);
        EXPECT_EQ(touch.overlap.regions.size(), regions);
        EXPECT_EQ(std::ranges::count(touch.overlap.crossing.kinds, NURBS_BRANCH_OVERLAP),
                  std::ssize(touch.overlap.crossing.kinds));
        EXPECT_NEAR(length_of(touch.overlap, NURBS_BRANCH_OVERLAP), length, 1e-6);
        check_loops(touch.overlap);
    }
}

} // namespace

// Boundaries of regions are circles, and what ends in these goes no farther.
TEST(ModelRegions, RoundModels) {
    const models::Face side = face_of(tube(0.5, 1.5, 0.6), {}), low = plate(0.5, Plate::ring),
                       high = plate(1.5, Plate::ring), on_top = plate(2, Plate::whole);
    expect_round(pin(), models::model_of({side.get(), low.get(), high.get()}), 1, 4 * pi); // in a bore
    expect_round(pin(), models::model_of({on_top.get()}), 1, 2 * pi);
    expect_round(pin(), pin(), 3, 8 * pi);
}

} // namespace model_regions_test
