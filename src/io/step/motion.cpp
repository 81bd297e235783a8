// SPDX-License-Identifier: MIT
#include "io/step/motion.h"

#include "io/step/geometry/placements.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace nrb::io::step {
namespace {

// The rounding of products of two unit vectors.
constexpr double product_rounding = 0x1p-50;

// Whether two directions are the first and the third axis of a frame of this scale, but for rounding. Such
// directions are kept as given, so that a motion that was written is read unchanged.
bool is_frame(const Vector3 &x, const Vector3 &z, double scale) noexcept {
    const double square = scale * scale, most = product_rounding * square;
    return std::fabs(dot(x, x) - square) <= most && std::fabs(dot(z, z) - square) <= most &&
           std::fabs(dot(x, z)) <= most;
}

// Skips attributes until only `left` of them are left.
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

// Given directions are kept if they are those of a frame of this scale, but for rounding.
Motion motion_of(const build::Placement &frame, double scale) noexcept {
    const Vector3 &z = frame.given_axis, &x = frame.given_x;
    const bool given = is_frame(x, z, scale);
    const Vector3 across = given ? x : scale * frame.x, along = given ? z : scale * frame.z;
    return {{across, cross((1 / scale) * along, across), along}, frame.origin};
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

// base_axis() of ISO 10303-42. The third direction gives z, and the part of the first one perpendicular to z
// gives x. The second one only decides on which side y is.
Motion read_operator(Entities &entities, const Instance &instance, double length) {
    Attributes attributes(entities.instances(), instance);
    if (attributes.complex()) {
        attributes.part("CARTESIAN_TRANSFORMATION_OPERATOR");
    } else { // writers differ in how many names and descriptions come first
        skip_to_last(attributes, 5);
    }
    const std::optional<Point> first = read_optional(entities, attributes, "axis1"),
                               second = read_optional(entities, attributes, "axis2");
    const Point origin =
        read_point(entities, attributes.reference("local_origin"), attributes, "local_origin", length);
    const double scale = attributes.real_or("scale", 1);
    attributes.part("CARTESIAN_TRANSFORMATION_OPERATOR_3D");
    const std::optional<Point> third = read_optional(entities, attributes, "axis3");
    if (!(scale > 0)) {
        attributes.fail_attribute(Status::factor, "scale", "expected more than 0");
    }
    Motion motion = motion_of(space_frame(origin, third, first), scale);
    Vector3 &y = motion.columns[1];
    if (second && dot(scaled_to_one(vector_of(second->x.data(), 3)), y) < 0) {
        y = -1.0 * y;
    }
    return motion;
}

} // namespace nrb::io::step
