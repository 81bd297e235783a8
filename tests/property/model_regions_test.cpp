// Models that stand on each other: the region that two of their faces have in common is told, and around it nothing else.
#include "blocks.h"
#include "face_regions.h"
#include "model_sections.h"
#include "support/cases.h"

namespace model_regions_test {

using namespace face_regions;
using namespace support;
using namespace support::models;
using blocks::Block;

namespace {

constexpr double tolerance = 1e-8;

using Corner = std::array<double, 2>;

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

// The part of a convex polygon in another one, both anticlockwise (Sutherland & Hodgman 1974).
double common_area(std::vector<Corner> part, const std::vector<Corner> &of) {
    for (size_t i = 0; i < of.size(); ++i) {
        const Corner &p = of[i], &q = of[(i + 1) % of.size()];
        const auto side = [&](const Corner &x) {
            return (q[0] - p[0]) * (x[1] - p[1]) - (q[1] - p[1]) * (x[0] - p[0]);
        };
        std::vector<Corner> left;
        for (size_t k = 0; k < part.size(); ++k) {
            const Corner &x = part[k], &y = part[(k + 1) % part.size()];
            const double at_x = side(x), at_y = side(y);
            if (at_x >= 0) {
                left.push_back(x);
            }
            if ((at_x > 0 && at_y < 0) || (at_x < 0 && at_y > 0)) {
                const double t = at_x / (at_x - at_y);
                left.push_back({x[0] + t * (y[0] - x[0]), x[1] + t * (y[1] - x[1])});
            }
        }
        part = left;
    }
    double area = 0;
    for (size_t i = 0; i < part.size(); ++i) {
        const Corner &p = part[i], &q = part[(i + 1) % part.size()];
        area += (p[0] * q[1] - q[0] * p[1]) / 2;
    }
    return area;
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
        const double area = common_area(lower.base(), upper.base());
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

} // namespace model_regions_test
