// SPDX-License-Identifier: MIT
#include "model/shapes/offset_shape.h"

#include <cmath>
#include <optional>

namespace nrb::model {

namespace {

using Result = std::optional<SurfaceShape>;

void move(build::Placement &place, const Vector3 &by) noexcept {
    place.origin = place.origin + by;
}

Result grown(SurfaceShape shape, int size, double by) {
    shape.sizes[size] += by;
    return shape.sizes[size] > 0 ? Result(std::move(shape)) : std::nullopt;
}

// With half of the angle a at the apex the normal is cos a outwards and -sin a along the axis.
Result cone_at(SurfaceShape cone, double distance) {
    const double half = cone.sizes[1];
    move(cone.place, -std::sin(half) * distance * cone.place.z);
    return grown(std::move(cone), 0, std::cos(half) * distance);
}

// A tube that meets itself or the axis is none that could be stated.
Result torus_at(SurfaceShape torus, double distance) {
    const double major = torus.sizes[0], minor = torus.sizes[1] + distance;
    return torus.sizes[1] < major && minor < major ? grown(std::move(torus), 1, distance) : std::nullopt;
}

// S_u x S_v of a line along X that is moved along V is the same everywhere; of a circle that is moved along its axis it is outwards
// from it, or inwards against it.
Result extrusion_at(SurfaceShape extrusion, double distance) {
    const Vector3 &way = extrusion.vector;
    CurveShape curve = *extrusion.curve;
    if (curve.kind == CurveKind::line) {
        const Vector3 normal = cross(curve.place.x, way);
        if (!(length(normal) > 0)) {
            return std::nullopt;
        }
        move(curve.place, distance / length(normal) * normal);
    } else if (curve.kind == CurveKind::circle && length(cross(curve.place.z, way)) <= 1e-15 * length(way)) {
        curve.sizes[0] += dot(curve.place.z, way) > 0 ? distance : -distance;
        if (!(curve.sizes[0] > 0)) {
            return std::nullopt;
        }
    } else {
        return std::nullopt;
    }
    extrusion.curve = std::make_shared<const CurveShape>(std::move(curve));
    return extrusion;
}

// With one parameter in the other direction so is the normal.
Result part_at(SurfaceShape part, double distance) {
    part.basis = known_offset(part.basis, part.u_forward == part.v_forward ? distance : -distance);
    return part.basis != nullptr ? Result(std::move(part)) : std::nullopt;
}

Result offset_of(const SurfaceShape &basis, double distance) {
    switch (basis.kind) {
    case SurfaceKind::plane: {
        SurfaceShape plane = basis;
        move(plane.place, distance * plane.place.z);
        return plane;
    }
    case SurfaceKind::cylinder:
    case SurfaceKind::sphere:
        return grown(basis, 0, distance);
    case SurfaceKind::cone:
        return cone_at(basis, distance);
    case SurfaceKind::torus:
        return torus_at(basis, distance);
    case SurfaceKind::extrusion:
        return extrusion_at(basis, distance);
    case SurfaceKind::trimmed:
        return part_at(basis, distance);
    default:
        return std::nullopt;
    }
}

} // namespace

SurfaceShapePtr known_offset(const SurfaceShapePtr &basis, double distance) {
    if (distance == 0) {
        return basis;
    }
    if (basis->kind == SurfaceKind::offset) {
        return known_offset(basis->basis, basis->distance + distance);
    }
    Result found = offset_of(*basis, distance);
    return found ? std::make_shared<const SurfaceShape>(*std::move(found)) : nullptr;
}

} // namespace nrb::model
