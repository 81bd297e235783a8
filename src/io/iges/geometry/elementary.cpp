// SPDX-License-Identifier: MIT
// Planes (entities 108 and 190), cylinders (192), cones (194), spheres (196) and tori (198).
#include "base/error.h"
#include "io/iges/geometry/geometry.h"
#include "io/iges/geometry/polylines.h"
#include "io/iges/geometry/shapes.h"

#include <cmath>
#include <numbers>

namespace nrb::io::iges {
namespace {

using model::SurfaceKind;
using model::SurfaceShape;

constexpr double radians_per_degree = std::numbers::pi / 180;

double read_length(Record &record, const char *name, double scale, bool zero = false) {
    const double value = record.real(name);
    if (!(value > 0) && !(zero && value == 0)) {
        fail(Status::length, "%s = %s, expected a length above 0", name, Number(value).text);
    }
    return scale * value;
}

double read_cone_angle(Record &record) {
    const double value = record.real("semi-angle");
    if (!(std::fabs(value) < 90)) {
        fail(Status::angle, "semi-angle = %s degrees, expected less than 90", Number(value).text);
    }
    return radians_per_degree * value;
}

// The foot point of the origin on the plane A x + B y + C z = D.
std::array<double, 3> foot(const Vector3 &normal, double d) {
    const Vector3 n = scaled_to_one(normal);
    const double factor = std::ldexp(d, -size_exponent(normal)) / dot(n, n);
    return {factor * n.x, factor * n.y, factor * n.z};
}

} // namespace

Vector3 Geometry::part_point(Reading &reading, const char *what) {
    const int64_t pointer = reading.record.integer(what);
    reading.parts.push_back(pointer);
    return point(pointer, reading.outer());
}

Vector3 Geometry::part_direction(Reading &reading, const char *what) {
    const int64_t pointer = reading.record.integer(what);
    reading.parts.push_back(pointer);
    return read(pointer, what, reading.outer(), false, [](Reading &direction) {
        expect(direction.entry, direction_type);
        const auto [x, y, z] = read_point(direction.record, "direction");
        return direction.place.vector({x, y, z});
    });
}

// Any affine image of a plane is a plane. The standard defines no parameters for it.
Surface Geometry::plane(Reading &reading) {
    auto &[entry, record, place, parts] = reading;
    const auto [a, b, c] = read_point(record, "coefficients");
    const double d = record.real("coefficients", 3), normal[3] = {a, b, c};
    build::check_direction(normal, 3, "coefficients");
    const build::Placement own =
        build::make_placement(3, foot({a, b, c}, d).data(), normal, nullptr, "coefficients");
    const Vector3 x = place.vector(own.x), axis = cross(x, place.vector(own.y));
    const double along[3] = {x.x, x.y, x.z}, up[3] = {axis.x, axis.y, axis.z};
    SurfaceShape shape = shape_of(SurfaceKind::plane);
    shape.place = build::make_placement(3, place.point({own.origin.x, own.origin.y, own.origin.z}).data(), up,
                                        along, "coefficients");
    const int64_t boundary = record.integer("boundary");
    record.skip(4); // location and size of its display symbol
    return {std::make_shared<const SurfaceShape>(std::move(shape)),
            {},
            false,
            entry.form == 0 ? 0 : boundary,
            entry.form < 0};
}

// Form 1 has a reference direction, and hence parameters: angles in degrees, lengths along the axis. The
// parameters of a torus are not used: files disagree on which of its angles comes first. A reflection
// reverses the angles.
Surface Geometry::elementary(Reading &reading) {
    auto &[entry, record, place, parts] = reading;
    const double scale = place.scale();
    if (scale == 0) {
        fail(Status::unsupported, "a matrix that is not a rotation does not keep the kind of the surface");
    }
    const bool oriented = entry.form == 1, sphere = entry.type == sphere_type;
    const Vector3 location = part_point(reading, "location");
    SurfaceShape shape = shape_of(SurfaceKind::plane);
    ParameterMap map{false, {radians_per_degree, scale}};
    if (sphere) {
        shape.kind = SurfaceKind::sphere;
        shape.sizes[0] = read_length(record, "radius", scale);
        map.scale = {radians_per_degree, radians_per_degree};
    }
    const Vector3 axis = !sphere || oriented ? part_direction(reading, "axis") : Vector3{0, 0, 1};
    switch (entry.type) {
    case cylinder_type:
        shape.kind = SurfaceKind::cylinder;
        shape.sizes[0] = read_length(record, "radius", scale);
        break;
    case cone_type:
        shape.kind = SurfaceKind::cone;
        shape.sizes[0] = read_length(record, "radius", scale, true);
        shape.sizes[1] = read_cone_angle(record);
        break;
    case torus_type:
        shape.kind = SurfaceKind::torus;
        shape.sizes[0] = read_length(record, "major radius", scale);
        shape.sizes[1] = read_length(record, "minor radius", scale);
        shape.range.v = {0, model::turn};
        break;
    case plane_surface_type:
        map.scale = {scale, scale};
        break;
    default:
        break;
    }
    const Vector3 x = oriented ? part_direction(reading, "reference direction") : any_normal(unit(axis));
    const double origin[3] = {location.x, location.y, location.z}, up[3] = {axis.x, axis.y, axis.z};
    const double along[3] = {x.x, x.y, x.z};
    shape.place = build::make_placement(3, origin, up, along, "location");
    const bool parametrized = oriented && entry.type != torus_type && !place.mirrors();
    return {std::make_shared<const SurfaceShape>(std::move(shape)), map, parametrized};
}

} // namespace nrb::io::iges
