// SPDX-License-Identifier: MIT
#include "io/step/motion.h"

#include "io/step/geometry/placements.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace nrb::io::step {
namespace {

Vector3 unit_vector(const Vector3 &x) noexcept {
    const Vector3 y = scaled_to_one(x);
    return (1 / std::sqrt(dot(y, y))) * y;
}

std::optional<Vector3> read_axis_direction(Entities &entities, Attributes &attributes, const char *name) {
    const int64_t number = attributes.reference_or_none(name);
    if (number == 0) {
        return std::nullopt;
    }
    const Point direction = read_direction(entities, number, attributes, name);
    return unit_vector({direction.x[0], direction.x[1], direction.x[2]});
}

// base_axis() of ISO 10303-42: the third rules, then the first, and the second says on which side.
Motion axes_of(const std::optional<Vector3> &first, const std::optional<Vector3> &second,
               const std::optional<Vector3> &third) noexcept {
    const Vector3 z = third.value_or(Vector3{0, 0, 1});
    const Vector3 wanted = first.value_or(std::fabs(z.x) < 0.9 ? Vector3{1, 0, 0} : Vector3{0, 1, 0});
    const Vector3 x = unit_vector(wanted - dot(wanted, z) * z), y = cross(z, x);
    const bool mirrored = second && dot(*second, y) < 0;
    return {{x, mirrored ? -1.0 * y : y, z}, {}};
}

// Goes to the place where so many attributes are left.
void skip_to_last(Attributes &attributes, int left) {
    Attributes ahead = attributes;
    int all = 0;
    for (; ahead.upcoming() != ')'; ++all) {
        ahead.skip("attribute");
    }
    for (; all > left; --all) {
        attributes.skip("name");
    }
}

} // namespace

Motion motion_of(const build::Placement &frame) noexcept {
    return {{frame.x, frame.y, frame.z}, frame.origin};
}

Motion between(const Motion &from, const Motion &to) noexcept {
    Motion result;
    const auto &[x, y, z] = from.columns;
    const std::array<Vector3, 3> rows{Vector3{x.x, y.x, z.x}, Vector3{x.y, y.y, z.y}, Vector3{x.z, y.z, z.z}};
    for (size_t k = 0; k < 3; ++k) {
        result.columns[k] = to.turned(rows[k]);
    }
    result.shift = to.shift - result.turned(from.shift);
    return result;
}

std::array<double, 12> matrix_of(const Motion &motion) noexcept {
    const auto &[x, y, z] = motion.columns;
    const Vector3 &t = motion.shift;
    std::array<double, 12> rows{x.x, y.x, z.x, t.x, x.y, y.y, z.y, t.y, x.z, y.z, z.z, t.z};
    std::for_each(rows.begin(), rows.end(), [](double &value) { value += 0.0; });
    return rows;
}

bool is_operator(const Instances &instances, const Instance &instance) {
    return instances.keyword(instance).starts_with("CARTESIAN_TRANSFORMATION_OPERATOR");
}

Motion read_operator(Entities &entities, const Instance &instance, double length) {
    Attributes attributes(entities.instances(), instance);
    if (attributes.complex()) {
        attributes.part("CARTESIAN_TRANSFORMATION_OPERATOR");
    } else { // writers differ on how many names and descriptions stand before
        skip_to_last(attributes, 5);
    }
    const std::optional<Vector3> first = read_axis_direction(entities, attributes, "axis1"),
                                 second = read_axis_direction(entities, attributes, "axis2");
    const Point origin =
        read_point(entities, attributes.reference("local_origin"), attributes, "local_origin", length);
    const double scale = attributes.real_or("scale", 1);
    attributes.part("CARTESIAN_TRANSFORMATION_OPERATOR_3D");
    const std::optional<Vector3> third = read_axis_direction(entities, attributes, "axis3");
    if (!(scale > 0)) {
        attributes.fail_attribute(Status::factor, "scale", "expected more than 0");
    }
    Motion motion = axes_of(first, second, third);
    for (Vector3 &column : motion.columns) {
        column = scale * column;
    }
    motion.shift = {origin.x[0], origin.x[1], origin.x[2]};
    return motion;
}

} // namespace nrb::io::step
