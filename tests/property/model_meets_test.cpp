// Where models meet: blocks, whose sides cut each other in segments that are known, and their laws.
#include "blocks.h"
#include "face_meets.h"
#include "model_sections.h"
#include "support/cases.h"

#include <map>

namespace model_meets_test {

using namespace face_meets;
using namespace support::blocks;
using namespace support::models;
using support::blocks::cross;

namespace {

constexpr double tolerance = 1e-8;

struct ModelMeet {
    model_sections::Section section;
    std::vector<Handle> on_second;
    std::vector<int64_t> faces_second, instances_second, node_faces_second;

    [[nodiscard]] bool complete() const { return section.found.complete; }
    [[nodiscard]] double length(size_t branch) const {
        double own = 0;
        require_ok(
            nurbs_curve_length(section.found.branches[branch].space.get(), nullptr, 1e-10, &own, nullptr));
        return own;
    }
};

ModelMeet model_meet(const nurbs_model *a, const nurbs_model *b, double within = tolerance) {
    nurbs_meet *made_meet = nullptr;
    require_ok(nurbs_model_intersections(a, b, within, &made_meet));
    const MeetHandle meet(made_meet);
    ModelMeet found{model_sections::section_in(meet.get()), {}, {}, {}, {}};
    const size_t branches = found.section.found.branches.size(), nodes = found.section.found.nodes.size();
    found.faces_second.resize(branches);
    found.instances_second.resize(branches);
    found.node_faces_second.resize(nodes);
    require_ok(nurbs_meet_faces_second(meet.get(), std::ssize(found.faces_second), found.faces_second.data(),
                                       found.instances_second.data(), nullptr));
    require_ok(nurbs_meet_joints_second(meet.get(), std::ssize(found.node_faces_second),
                                        found.node_faces_second.data(), nullptr, nullptr));
    for (size_t i = 0; i < branches; ++i) {
        found.on_second.push_back(made(
            [&](nurbs **out) { return nurbs_meet_branch_second(meet.get(), static_cast<int64_t>(i), out); }));
    }
    return found;
}

Model model_of(const Block &block) {
    std::vector<const nurbs_face *> faces;
    for (const auto &side : block.sides) {
        faces.push_back(side.get());
    }
    return support::models::model_of(faces);
}

Point3 combined(const Point3 &a, double s, const Point3 &b) {
    return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]};
}

// A side of a block as corner + s u + t v.
struct Side {
    Point3 corner, u, v, normal;
};
Side side_of(const Block &block, size_t number) {
    const size_t axis = number / 2;
    return {combined(block.origin, static_cast<double>(number % 2), block.edges[axis]),
            block.edges[(axis + 1) % 3], block.edges[(axis + 2) % 3], normal_of(block, axis)};
}

// Of the line x + t way what lies over a side: where both of its parameters are from 0 to 1.
void clip(const Side &side, const Point3 &x, const Point3 &way, double &lower, double &upper) {
    const double size = dot(side.normal, side.normal);
    const Point3 of_u = cross(side.v, side.normal), of_v = cross(side.normal, side.u);
    for (const Point3 &dual : {of_u, of_v}) {
        const double at = dot(dual, combined(x, -1, side.corner)) / size, step = dot(dual, way) / size;
        const double from = -at / step, to = (1 - at) / step;
        lower = std::max(lower, std::min(from, to));
        upper = std::min(upper, std::max(from, to));
    }
}

// The length of the segment that two sides have in common.
double common_length(const Side &a, const Side &b) {
    const Point3 way = cross(a.normal, b.normal);
    const double square = dot(way, way), c = dot(a.normal, a.corner), d = dot(b.normal, b.corner);
    const Point3 first = cross(b.normal, way), second = cross(way, a.normal);
    Point3 x{};
    for (size_t k = 0; k < 3; ++k) {
        x[k] = (c * first[k] + d * second[k]) / square;
    }
    double lower = -1e9, upper = 1e9;
    clip(a, x, way, lower, upper);
    clip(b, x, way, lower, upper);
    return std::max(0.0, upper - lower) * std::sqrt(square);
}

using Lengths = std::map<std::pair<int64_t, int64_t>, double>; // by faces

Lengths lengths_of(const ModelMeet &found) {
    Lengths lengths;
    for (size_t i = 0; i < found.section.faces.size(); ++i) {
        EXPECT_EQ(found.section.instances[i], 0);
        EXPECT_EQ(found.instances_second[i], 0);
        lengths[{found.section.faces[i], found.faces_second[i]}] += found.length(i);
    }
    return lengths;
}

// Each branch of a way ends where the next one begins, and the faces of nodes are those of their branches.
void check_ways(const ModelMeet &found) {
    for (const model_sections::Way &way : found.section.ways) {
        for (size_t k = 0; k < way.branches.size(); ++k) {
            const size_t i = way.branches[k], j = way.branches[(k + 1) % way.branches.size()];
            const Branch &own = found.section.found.branches[i], &next = found.section.found.branches[j];
            if (own.closed() || (!way.closed && k + 1 == way.branches.size())) {
                continue;
            }
            const auto node = static_cast<size_t>(own.nodes[1]);
            EXPECT_EQ(found.section.next_nodes[node], next.nodes[0]);
            EXPECT_EQ(found.section.node_faces[node], found.section.faces[i]);
            EXPECT_EQ(found.node_faces_second[node], found.faces_second[i]);
            const Point3 end = points_on(own.space.get(), {own.domain[1]})[0],
                         begin = points_on(next.space.get(), {next.domain[0]})[0];
            EXPECT_LE(surface_sections::distance(end, begin), found.section.gaps[node] + 1e-12);
        }
    }
}

// Out of a block.
Point3 outer_normal(const Block &block, int64_t face) {
    const Point3 normal = normal_of(block, static_cast<size_t>(face / 2));
    const bool outwards = (dot(normal, block.edges[static_cast<size_t>(face / 2)]) > 0) == (face % 2 == 1);
    return combined({}, outwards ? 1 : -1, normal);
}

// Branches run along n_b x n_a. Normals of faces that bound no solid are those of the first one, which is that of the left side: all
// of them point inwards where edges are those of a right hand.
void check_directions(const ModelMeet &found, const Block &a, const Block &b) {
    const bool alike = (dot(normal_of(a, 0), a.edges[0]) > 0) == (dot(normal_of(b, 0), b.edges[0]) > 0);
    for (size_t i = 0; i < found.section.faces.size(); ++i) {
        const Branch &branch = found.section.found.branches[i];
        const std::vector<Point3> ends = points_on(branch.space.get(), {branch.domain[0], branch.domain[1]});
        const Point3 along =
            cross(outer_normal(b, found.faces_second[i]), outer_normal(a, found.section.faces[i]));
        EXPECT_EQ(dot(combined(ends[1], -1, ends[0]), along) > 0, alike) << "branch " << i;
    }
}

} // namespace

TEST(ModelMeets, OfBlocksAreTheSegmentsOfTheirSides) {
    int64_t met = 0;
    for_each_case(6330000, 30, [&](Random &random, uint64_t seed) {
        SCOPED_TRACE(seed);
        const Block one = random_block(random, 0, 0.7), other = random_block(random, 0, 0.7);
        const Model a = model_of(one), b = model_of(other);
        const ModelMeet found = model_meet(a.get(), b.get()), back = model_meet(b.get(), a.get());
        EXPECT_TRUE(found.complete());
        EXPECT_EQ(found.section.open(), 0);
        const Lengths lengths = lengths_of(found), reverse = lengths_of(back);
        for (size_t i = 0; i < 6; ++i) {
            for (size_t j = 0; j < 6; ++j) {
                const double expected = common_length(side_of(one, i), side_of(other, j));
                const std::pair<int64_t, int64_t> own(i, j), exchanged(j, i);
                EXPECT_NEAR(lengths.contains(own) ? lengths.at(own) : 0, expected, 1e-7) << i << ", " << j;
                EXPECT_NEAR(reverse.contains(exchanged) ? reverse.at(exchanged) : 0, expected, 1e-7)
                    << i << ", " << j;
                met += expected > 0 ? 1 : 0;
            }
        }
        EXPECT_EQ(found.section.ways.size(), back.section.ways.size());
        check_ways(found);
        check_ways(back);
        check_directions(found, one, other);
        check_directions(back, other, one);
    });
    EXPECT_GE(met, of_whole_run(60));
}

// A rod through a block that it is thinner than: two ways around it, and one if it ends inside.
TEST(ModelMeets, OfABlockAndARod) {
    const auto rod = [](double from, double to) {
        Block block;
        block.edges = {Point3{0.25, 0, 0}, Point3{0, 0.25, 0}, Point3{0, 0, to - from}};
        block.origin = {0.3, 0.4, from};
        return block;
    };
    const auto model_of_rod = [&](double from, double to) {
        const Block shape = rod(from, to);
        const auto key = [](size_t along, int64_t first, int64_t second) {
            return 1 + 4 * static_cast<int64_t>(along) + first + 2 * second;
        };
        std::vector<support::models::Face> sides;
        std::vector<const nurbs_face *> given;
        for (size_t axis = 0; axis < 3; ++axis) {
            const size_t p = (axis + 1) % 3, q = (axis + 2) % 3;
            for (const int64_t side : {0, 1}) {
                sides.push_back(support::solids::around_domain(
                    support::solids::plane(
                        combined(shape.origin, static_cast<double>(side), shape.edges[axis]), shape.edges[p],
                        shape.edges[q]),
                    {key(p, 0, side), key(q, side, 1), -key(p, 1, side), -key(q, side, 0)}));
                given.push_back(sides.back().get());
            }
        }
        return support::models::model_of(given);
    };
    const Handle sphere = made([](nurbs **out) {
        return nurbs_surface_sphere(nullptr, nullptr, nullptr, 1, NURBS_ARC_QUARTERS, out);
    });
    const support::models::Face ball = support::solids::whole(sphere);
    const Model round = support::models::model_of({ball.get()});
    for (const bool through : {true, false}) {
        const Model thin = model_of_rod(through ? -2 : 0.1, 2);
        const ModelMeet found = model_meet(thin.get(), round.get(), 1e-7);
        EXPECT_TRUE(found.complete());
        EXPECT_EQ(found.section.ways.size(), through ? 2U : 1U);
        EXPECT_EQ(found.section.open(), 0);
        check_ways(found);
    }
}

} // namespace model_meets_test
