// SPDX-License-Identifier: MIT
#include "io/step/geometry/placements.h"

#include "base/error.h"

#include <algorithm>
#include <cmath>

namespace nrb::io::step {
namespace {

// A list of two or three numbers.
Point read_numbers(Attributes &attributes, const char *name) {
    Point point;
    point.dim = 0;
    attributes.open(name);
    while (attributes.more(name)) {
        const double value = attributes.real(name);
        if (point.dim == 3) {
            attributes.fail_attribute(Status::syntax, name, "more than 3 numbers");
        }
        point.x[static_cast<size_t>(point.dim++)] = value;
    }
    if (point.dim < 2) {
        attributes.fail_attribute(Status::syntax, name,
                                  std::to_string(point.dim) + " numbers, expected 2 or 3");
    }
    return point;
}

Vector3 unit_of(const Point &direction) noexcept {
    return unit({direction.x[0], direction.x[1], direction.x[2]});
}

// X across Z as the standard builds it.
Point default_x(const Point &z) noexcept {
    const Vector3 sine = cross(unit_of(z), {1, 0, 0});
    return largest(sine) > 1e-9 ? Point{{1, 0, 0}, 3} : Point{{0, 1, 0}, 3};
}

bool parallel(const Point &a, const Point &b) noexcept {
    return largest(cross(unit_of(a), unit_of(b))) <= 1e-12;
}

Attributes at_location(Entities &entities, const Instance &instance, Point &location, double length) {
    Attributes attributes(entities.instances(), instance);
    attributes.part("REPRESENTATION_ITEM");
    attributes.skip("name");
    attributes.part("PLACEMENT");
    location = read_point(entities, attributes.reference("location"), attributes, "location", length);
    return attributes;
}

void check_dimension(const Attributes &attributes, const Point &point, int dim, const char *name) {
    if (point.dim != dim) {
        attributes.fail_attribute(Status::syntax, name,
                                  std::to_string(point.dim) + " coordinates, expected " +
                                      std::to_string(dim));
    }
}

} // namespace

Point read_point(Entities &entities, const Instance &instance, double length) {
    Attributes attributes(entities.instances(), instance);
    attributes.part("REPRESENTATION_ITEM");
    attributes.skip("name");
    attributes.part("CARTESIAN_POINT");
    Point point = read_numbers(attributes, "coordinates");
    for (double &value : point.x) {
        value *= length;
    }
    return point;
}

Point read_point(Entities &entities, int64_t number, const Attributes &owner, const char *attribute,
                 double length) {
    return read_point(
        entities, entities.at(number, Kind::cartesian_point, owner, attribute, "a CARTESIAN_POINT"), length);
}

Point read_direction(Entities &entities, int64_t number, const Attributes &owner, const char *attribute) {
    Attributes attributes(entities.instances(),
                          entities.at(number, Kind::direction, owner, attribute, "a DIRECTION"));
    attributes.part("REPRESENTATION_ITEM");
    attributes.skip("name");
    attributes.part("DIRECTION");
    const Point direction = read_numbers(attributes, "direction_ratios");
    if (std::ranges::all_of(direction.x, [](double x) { return x == 0; })) {
        attributes.fail_attribute(Status::direction, "direction_ratios", "all are 0");
    }
    return direction;
}

std::optional<Point> read_optional(Entities &entities, Attributes &attributes, const char *name) {
    const int64_t number = attributes.upcoming() == ')' ? 0 : attributes.reference_or_none(name);
    return number == 0 ? std::nullopt : std::optional(read_direction(entities, number, attributes, name));
}

build::Placement space_frame(const Point &origin, const std::optional<Point> &axis,
                             const std::optional<Point> &reference) {
    const Point z = axis.value_or(Point{{0, 0, 1}, 3}),
                x = reference && !parallel(z, *reference) ? *reference : default_x(z);
    return build::make_placement(3, origin.x.data(), z.x.data(), x.x.data(), "location");
}

Vector3 Vector::value() const noexcept {
    const Vector3 along = scaled_to_one({direction.x[0], direction.x[1], direction.x[2]});
    return (magnitude / nrb::length(along)) * along;
}

Vector read_vector(Entities &entities, int64_t number, const Attributes &owner, const char *attribute,
                   double length) {
    Attributes attributes(entities.instances(),
                          entities.at(number, Kind::vector, owner, attribute, "a VECTOR"));
    attributes.part("REPRESENTATION_ITEM");
    attributes.skip("name");
    attributes.part("VECTOR");
    const int64_t orientation = attributes.reference("orientation");
    const double stated = attributes.real("magnitude"), magnitude = stated * length;
    if (!(magnitude > 0) || !std::isfinite(magnitude)) {
        attributes.fail_attribute(Status::length, "magnitude",
                                  std::string("found ") + Number(stated).text +
                                      ", expected a length above 0");
    }
    return {read_direction(entities, orientation, attributes, "orientation"), magnitude};
}

build::Placement read_placement(Entities &entities, int64_t number, const Attributes &owner,
                                const char *attribute, double length) {
    const Instance &instance = entities.at(number, owner, attribute);
    if (!is_axis2_placement(instance.kind())) {
        entities.fail_kind(instance, owner, attribute, "an AXIS2_PLACEMENT_2D or _3D");
    }
    const bool plane = instance.kind() == Kind::axis2_placement_2d;
    Point origin;
    Attributes attributes = at_location(entities, instance, origin, length);
    check_dimension(attributes, origin, plane ? 2 : 3, "location");
    attributes.part(plane ? "AXIS2_PLACEMENT_2D" : "AXIS2_PLACEMENT_3D");
    if (plane) {
        const Point x = read_optional(entities, attributes, "ref_direction").value_or(Point{{1, 0, 0}, 3});
        return build::make_placement(2, origin.x.data(), nullptr, x.x.data(), "location");
    }
    const std::optional<Point> z = read_optional(entities, attributes, "axis");
    return space_frame(origin, z, read_optional(entities, attributes, "ref_direction"));
}

build::Placement read_axis(Entities &entities, int64_t number, const Attributes &owner, const char *attribute,
                           double length) {
    const Instance &instance =
        entities.at(number, Kind::axis1_placement, owner, attribute, "an AXIS1_PLACEMENT");
    Point origin;
    Attributes attributes = at_location(entities, instance, origin, length);
    check_dimension(attributes, origin, 3, "location");
    attributes.part("AXIS1_PLACEMENT");
    return space_frame(origin, read_optional(entities, attributes, "axis"), std::nullopt);
}

} // namespace nrb::io::step
