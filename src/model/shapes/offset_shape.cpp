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

// Rotates the frame by half a turn about Z.
void turn_around(build::Placement &place) noexcept {
    for (Vector3 *v : {&place.x, &place.y, &place.x_rest, &place.y_rest, &place.given_x}) {
        *v = -1.0 * *v;
    }
}

// Beyond the axis the radius is negative: the offset is then a cylinder that starts on the opposite side.
Result cylinder_at(SurfaceShape cylinder, double distance) {
    const double radius = cylinder.sizes[0] + distance;
    if (radius < 0) {
        turn_around(cylinder.place);
    }
    cylinder.sizes[0] = std::abs(radius);
    return radius != 0 ? Result(std::move(cylinder)) : std::nullopt;
}

// The same beyond the centre, where besides v runs backwards, and the normal points inwards.
Result sphere_at(SurfaceShape sphere, double distance) {
    const double radius = sphere.sizes[0] + distance;
    sphere.sizes[0] = std::abs(radius);
    if (radius >= 0) {
        return radius > 0 ? Result(std::move(sphere)) : std::nullopt;
    }
    turn_around(sphere.place);
    SurfaceShape turned = sphere;
    turned.kind = SurfaceKind::trimmed;
    turned.range = natural_range(sphere);
    turned.v_forward = false;
    turned.basis = std::make_shared<const SurfaceShape>(std::move(sphere));
    return turned;
}

// With half the apex angle a, the unit normal is cos a times the outward radial direction minus sin a times
// the axis.
Result cone_at(SurfaceShape cone, double distance) {
    const double half = cone.sizes[1];
    move(cone.place, -std::sin(half) * distance * cone.place.z);
    return grown(std::move(cone), 0, std::cos(half) * distance);
}

// A torus whose tube meets itself or the axis is not an elementary surface.
Result torus_at(SurfaceShape torus, double distance) {
    const double major = torus.sizes[0], minor = torus.sizes[1] + distance;
    return torus.sizes[1] < major && minor < major ? grown(std::move(torus), 1, distance) : std::nullopt;
}

// The normal S_u x S_v is constant for a line along X that is extruded along V. For a circle that is extruded
// along its axis it points outwards, or inwards if V is opposite to the axis.
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
        const double radius = curve.sizes[0] + (dot(curve.place.z, way) > 0 ? distance : -distance);
        if (radius == 0) {
            return std::nullopt;
        }
        if (radius < 0) {
            turn_around(curve.place);
        }
        curve.sizes[0] = std::abs(radius);
    } else {
        return std::nullopt;
    }
    extrusion.curve = std::make_shared<const CurveShape>(std::move(curve));
    return extrusion;
}

// Reversing one parameter reverses the normal.
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
        return cylinder_at(basis, distance);
    case SurfaceKind::sphere:
        return sphere_at(basis, distance);
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

int sign_of(double x) noexcept {
    return x > 0 ? 1 : x < 0 ? -1 : 0;
}

// The curvature around the tube gives the sign. The one around the axis does not change it unless the larger
// tube reaches the axis; then the side is not the same everywhere.
int side_of_torus(const SurfaceShape &torus, double distance) noexcept {
    const double minor = torus.sizes[1] + distance;
    return torus.sizes[1] < torus.sizes[0] && std::abs(minor) < torus.sizes[0] ? sign_of(minor) : 0;
}

// 1 if the normal of the offset is that of the basis, -1 if it is opposite, 0 if that is not the same
// everywhere or not known. It is the sign of (1 - k1 d)(1 - k2 d) with the distance d and the principal
// curvatures k1, k2 of the basis. A radius r becomes r + d, and its curvature is -1 / r.
int side_of(const SurfaceShape &basis, double distance) noexcept {
    switch (basis.kind) {
    case SurfaceKind::plane:
        return 1;
    case SurfaceKind::cylinder:
        return sign_of(basis.sizes[0] + distance);
    case SurfaceKind::sphere: // both factors change their sign together
        return basis.sizes[0] + distance != 0 ? 1 : 0;
    case SurfaceKind::cone: // inwards, the apex moves into the surface
        return distance >= 0 ? 1 : 0;
    case SurfaceKind::torus:
        return side_of_torus(basis, distance);
    case SurfaceKind::trimmed:
        return side_of(*basis.basis, basis.u_forward == basis.v_forward ? distance : -distance);
    default:
        return 0;
    }
}

} // namespace

SurfaceShapePtr known_offset(const SurfaceShapePtr &basis, double distance) {
    if (distance == 0) {
        return basis;
    }
    if (basis->kind == SurfaceKind::offset) {
        const int side = side_of(*basis->basis, basis->distance);
        return side != 0 ? known_offset(basis->basis, basis->distance + side * distance) : nullptr;
    }
    Result found = offset_of(*basis, distance);
    return found ? std::make_shared<const SurfaceShape>(*std::move(found)) : nullptr;
}

} // namespace nrb::model
