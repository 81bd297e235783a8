// SPDX-License-Identifier: MIT
#include "base/error.h"
#include "io/iges/geometry/geometry.h"
#include "io/iges/geometry/polylines.h"
#include "io/iges/geometry/power_pieces.h"
#include "io/iges/geometry/shapes.h"
#include "io/iges/geometry/spline.h"
#include "model/shapes/offset_shape.h"

#include <cmath>

namespace nrb::io::iges {

using model::CurvePiece;
using model::SurfaceKind;
using model::SurfaceShape;

bool is_surface(int type) noexcept {
    switch (type) {
    case plane_type:
    case spline_patches_type:
    case ruled_type:
    case revolution_type:
    case tabulated_type:
    case spline_surface_type:
    case offset_surface_type:
    case plane_surface_type:
    case cylinder_type:
    case cone_type:
    case sphere_type:
    case torus_type:
        return true;
    default:
        return false;
    }
}

Surface Geometry::read_surface(Reading &reading) {
    auto &[entry, record, place, parts] = reading;
    switch (entry.type) {
    case plane_type:
        return plane(reading);
    case spline_patches_type:
        return surface_of_spline(read_spline_patches(record, place, units_.resolution));
    case ruled_type:
        return ruled(reading);
    case revolution_type:
        return revolution(reading);
    case tabulated_type:
        return tabulated(reading);
    case spline_surface_type:
        return surface_of_spline(build_spline(read_surface_data(record), place));
    case offset_surface_type:
        return offset(reading);
    case plane_surface_type:
    case cylinder_type:
    case cone_type:
    case sphere_type:
    case torus_type:
        return elementary(reading);
    default:
        fail(Status::unsupported, "does not become a surface in this version");
    }
}

CurvePiece Geometry::part_curve(Reading &reading, const char *what) {
    const int64_t pointer = reading.record.integer(what);
    const int type = entities_.at(pointer, what).type;
    if (!is_curve(type)) {
        fail(Status::syntax, "%s: directory line %lld is a %s (%d), expected a curve", what,
             static_cast<long long>(pointer), type_name(type), type);
    }
    reading.parts.push_back(pointer);
    return any_curve(pointer, reading.outer(), false);
}

// The axis runs from its first point to its second. A reflection reverses the sense of rotation.
Surface Geometry::revolution(Reading &reading) {
    const int64_t axis = reading.record.integer("axis");
    reading.parts.push_back(axis);
    const LineEnds ends = read(axis, "axis", reading.outer(), false, [](Reading &line) {
        expect(line.entry, line_type);
        return read_line_ends(line.record, line.place);
    });
    const CurvePiece profile = part_curve(reading, "generatrix");
    const double start = reading.record.real("start angle"), end = reading.record.real("end angle");
    if (reading.place.scale() == 0) {
        fail(Status::unsupported, "a matrix that is not a rotation does not keep what is revolved");
    }
    const double sign = reading.place.mirrors() ? -1 : 1;
    const double way[3] = {sign * (ends.second[0] - ends.first[0]), sign * (ends.second[1] - ends.first[1]),
                           sign * (ends.second[2] - ends.first[2])};
    return revolved(profile, build::make_placement(3, ends.first.data(), way, nullptr, "P1"), start, end);
}

// The directrix translated from its start to a given point.
Surface Geometry::tabulated(Reading &reading) {
    const CurvePiece directrix = part_curve(reading, "directrix");
    const std::array<double, 3> end =
        reading.place.point(read_point(reading.record, "end of the generatrix"));
    if (!std::isfinite(directrix.range.upper - directrix.range.lower)) {
        fail(Status::length, "the directrix has no ends");
    }
    const Vector3 start = start_of(directrix);
    return extruded(directrix, Vector3{end[0], end[1], end[2]} - start);
}

// At a distance from the basis along its normal, on the side of the indicator.
Surface Geometry::offset(Reading &reading) {
    const auto [x, y, z] = read_point(reading.record, "indicator");
    const double distance = reading.record.real("distance");
    const int64_t pointer = reading.record.integer("surface");
    Surface result = surface(pointer, reading.outer());
    reading.parts.push_back(pointer);
    if (approximated_.contains(pointer)) {
        fail(Status::unsupported,
             "the surface is made of an approximated curve, which leaves its normals unknown");
    }
    const double scale = reading.place.scale();
    if (scale == 0) {
        fail(Status::unsupported, "a matrix that is not a rotation does not keep distances");
    }
    entities_.spend(size_of(*result.shape));
    const Vector3 indicator = reading.place.vector({x, y, z});
    const double side = dot(normal_in_the_middle(*result.shape), indicator) < 0 ? -1 : 1;
    if (model::SurfaceShapePtr known = model::known_offset(result.shape, side * scale * distance)) {
        result.shape = std::move(known);
        return result;
    }
    SurfaceShape shape = shape_of(SurfaceKind::offset);
    shape.basis = result.shape;
    shape.distance = side * scale * distance;
    result.shape = std::make_shared<const SurfaceShape>(std::move(shape));
    return result;
}

} // namespace nrb::io::iges
