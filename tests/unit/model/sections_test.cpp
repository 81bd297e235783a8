// Sections of parts that are placed in parts, against those of the parts themselves.
#include "eval/curve_point.h"
#include "io/step/read_step.h"
#include "model/rays/instances.h"
#include "model/sections/model_sections.h"
#include "support/step_reading.h"
#include "support/step_solids.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace model_sections_unit_test {

namespace {

using namespace nrb;
using namespace nrb::model;

using Rows = std::array<double, 12>;

class Numbers {
public:
    explicit Numbers(unsigned seed) : engine_(seed) {}
    double between(double lower, double upper) {
        return std::uniform_real_distribution<double>(lower, upper)(engine_);
    }
    Vector3 vector() { return {between(-1, 1), between(-1, 1), between(-1, 1)}; }
    // Turned, mirrored where the scale is negative, sheared and moved.
    Rows placement() {
        Rows rows{};
        const double angle = between(-3, 3), scale = between(0.5, 2) * (between(-1, 1) < 0 ? -1 : 1);
        const double shear = between(-0.4, 0.4);
        const std::array<std::array<double, 3>, 3> turn{{{std::cos(angle), -std::sin(angle), shear},
                                                         {std::sin(angle), std::cos(angle), 0},
                                                         {0.3, -0.1, 1}}};
        for (size_t i = 0; i < 3; ++i) {
            for (size_t k = 0; k < 3; ++k) {
                rows[4 * i + k] = scale * turn[i][k];
            }
            rows[4 * i + 3] = between(-5, 5);
        }
        return rows;
    }

private:
    std::mt19937 engine_;
};

Vector3 column(const Rows &rows, size_t k) {
    return {rows[k], rows[4 + k], rows[8 + k]};
}
double determinant(const Rows &rows) {
    return dot(column(rows, 0), cross(column(rows, 1), column(rows, 2)));
}

// Of the ways of an instance, by polygons; all of them have to close.
double area_of(const intersect::Meet &meet, int64_t instance, const Vector3 &normal) {
    double twice = 0;
    for (const intersect::MeetWay &way : meet.ways) {
        const auto first = static_cast<size_t>(way.first);
        if (meet.branches[first].instance != instance) {
            continue;
        }
        EXPECT_TRUE(way.closed);
        std::vector<Vector3> points;
        for (size_t i = first; i < first + static_cast<size_t>(way.count); ++i) {
            EXPECT_EQ(meet.branches[i].instance, instance);
            const Spline &curve = *meet.branches[i].space;
            const Interval domain = curve.axis(0).domain();
            for (int k = 0; k < 200; ++k) {
                const auto x =
                    eval::curve_point(curve, domain.lower + (domain.upper - domain.lower) * k / 200, false);
                points.push_back({x[0], x[1], x[2]});
            }
        }
        for (size_t i = 0; i < points.size(); ++i) {
            twice += dot(normal, cross(points[i] - points[0], points[(i + 1) % points.size()] - points[0]));
        }
    }
    return twice / 2 / length(normal);
}

} // namespace

// With A x + t, the plane n . x = o of the whole is A^T n . x = o - n . t in the part, and areas are |det A| / |A^T n| times as large.
TEST(ModelSections, of_placed_parts_are_those_of_the_parts) {
    int64_t cut = 0;
    for (const bool is_cube : {true, false}) {
        Model own = io::read_model(is_cube ? step_test::step_cube() : step_test::step_cylinder(false), {});
        Numbers numbers(is_cube ? 5 : 6);
        for (int trial = 0; trial < 20; ++trial) {
            Model placed =
                io::read_model(is_cube ? step_test::step_cube() : step_test::step_cylinder(false), {});
            placed.parts.emplace_back();
            const int64_t group = std::ssize(placed.parts) - 1;
            const Rows outer = numbers.placement(), inner = numbers.placement(), alone = numbers.placement();
            placed.uses = {{-1, group, outer, ""}, {group, 0, inner, ""}, {-1, 0, alone, ""}};
            const std::vector<Instance> instances = instances_of(placed);
            ASSERT_EQ(instances.size(), 3U);
            for (size_t i = 0; i < instances.size(); ++i) {
                if (instances[i].part != 0) {
                    continue;
                }
                const Rows &rows = instances[i].placement;
                const Vector3 normal = numbers.vector();
                const Vector3 in_part{dot(column(rows, 0), normal), dot(column(rows, 1), normal),
                                      dot(column(rows, 2), normal)};
                const double offset = dot(in_part, {numbers.between(0, 2), numbers.between(0, 1.5), 1});
                const SectionPlane of_part{in_part, offset},
                    of_whole{normal, offset + dot(normal, column(rows, 3))};
                const intersect::Meet expected = model_sections(own, std::span(&of_part, 1), 1e-7),
                                      found = model_sections(placed, std::span(&of_whole, 1), 1e-7);
                EXPECT_TRUE(found.complete && expected.complete);
                const double area = area_of(expected, 0, in_part);
                cut += area > 0.1 ? 1 : 0;
                EXPECT_NEAR(area_of(found, static_cast<int64_t>(i), normal),
                            area * std::abs(determinant(rows)) * length(normal) / length(in_part),
                            1e-3 * (1 + area));
            }
        }
    }
    EXPECT_GE(cut, 60);
}

} // namespace model_sections_unit_test
