// SPDX-License-Identifier: MIT
#include "model/shapes/moved_shape.h"

#include "base/numbers.h"
#include "refine/forms/transform.h"

#include <cmath>

namespace nrb::model {

namespace {

SplinePtr moved_spline(const Spline &spline, const Similarity &motion) {
    const auto &[x, y, z] = motion.columns;
    const double matrix[9] = {x.x, y.x, z.x, x.y, y.y, z.y, x.z, y.z, z.z},
                 way[3] = {motion.shift.x, motion.shift.y, motion.shift.z};
    return refine::transform(spline, {3, 3, matrix}, way);
}

build::Placement frame_at(const Vector3 &origin, const Vector3 &z, const Vector3 &x) {
    const double at[3] = {origin.x, origin.y, origin.z}, axis[3] = {z.x, z.y, z.z},
                 across[3] = {x.x, x.y, x.z};
    return build::make_placement(3, at, axis, across, "origin");
}

// The frame with the images of X and Y. Its Z is the image of Z or, in a mirror, opposite to it.
build::Placement moved_frame(const build::Placement &place, const Similarity &motion) {
    const Vector3 x = motion.turned(place.x);
    return frame_at(motion.point(place.origin), cross(x, motion.turned(place.y)), x);
}

CurveShapePtr shared(CurveShape curve) {
    return std::make_shared<const CurveShape>(std::move(curve));
}

CurveShapePtr moved_curve(CurveShape curve, const Similarity &motion) {
    curve.place = moved_frame(curve.place, motion);
    for (double &size : curve.sizes) {
        size *= motion.scale();
    }
    return shared(std::move(curve));
}

std::vector<CurvePiece> moved_pieces(const std::vector<CurvePiece> &given, const Similarity &motion) {
    std::vector<CurvePiece> pieces = given;
    for (CurvePiece &piece : pieces) {
        piece.curve = moved(piece.curve, motion);
    }
    return pieces;
}

// The image of an elementary surface as an extrusion or a surface of revolution, made from the images of the
// axes of its frame.
class Swept {
public:
    Swept(const SurfaceShape &surface, const Similarity &motion)
        : given_(surface), origin_(motion.point(surface.place.origin)), x_(motion.turned(surface.place.x)),
          y_(motion.turned(surface.place.y)), z_(motion.turned(surface.place.z)), scale_(motion.scale()) {}

    [[nodiscard]] SurfaceShape shape() const {
        switch (given_.kind) {
        case SurfaceKind::plane:
            return extruded(line(x_, scale_), y_);
        case SurfaceKind::cylinder:
            return extruded(circle(origin_, y_, given_.sizes[0]), z_);
        case SurfaceKind::cone: // radius s0 at v = 0, growing by tan s1 per unit along the axis
            return revolved(line(std::tan(given_.sizes[1]) * x_ + z_, scale_ / std::cos(given_.sizes[1]),
                                 origin_ + given_.sizes[0] * x_));
        case SurfaceKind::sphere:
            return revolved(part_of_circle(circle(origin_, z_, given_.sizes[0]), natural_range(given_).v));
        default:
            return revolved(part_of_circle(circle(origin_ + given_.sizes[0] * x_, z_, given_.sizes[1]),
                                           natural_range(given_).v));
        }
    }

private:
    static SurfaceShape empty(SurfaceKind kind) {
        SurfaceShape shape{kind, {}, {0, 0}, {}, nullptr, {}, nullptr, 0, true, true, nullptr};
        shape.place.dim = 3;
        return shape;
    }
    static SurfaceShape extruded(CurveShapePtr curve, const Vector3 &way) {
        SurfaceShape shape = empty(SurfaceKind::extrusion);
        shape.curve = std::move(curve);
        shape.vector = way;
        return shape;
    }
    // The angle u runs from X to Y.
    [[nodiscard]] SurfaceShape revolved(CurveShapePtr curve) const {
        SurfaceShape shape = empty(SurfaceKind::revolution);
        shape.curve = std::move(curve);
        shape.place = frame_at(origin_, cross(x_, y_), x_);
        return shape;
    }
    [[nodiscard]] CurveShapePtr line(const Vector3 &way, double size) const {
        return line(way, size, origin_);
    }
    [[nodiscard]] CurveShapePtr line(const Vector3 &way, double size, const Vector3 &from) const {
        // any Z perpendicular to the line will do
        return shared({CurveKind::line, frame_at(from, cross(way, y_), way), {size, 0}, nullptr, {}});
    }
    // The angle runs from X to another of the axes.
    [[nodiscard]] CurveShapePtr circle(const Vector3 &centre, const Vector3 &to, double radius) const {
        return shared(
            {CurveKind::circle, frame_at(centre, cross(x_, to), x_), {radius * scale_, 0}, nullptr, {}});
    }
    static CurveShapePtr part_of_circle(CurveShapePtr circle, Interval range) {
        const bool all = range.lower == 0 && range.upper == turn;
        return all ? circle : curve_of_piece({std::move(circle), range});
    }

    const SurfaceShape &given_;
    Vector3 origin_, x_, y_, z_;
    double scale_;
};

// Whether the image, with the parameters of the given surface, is one of the same kind.
bool keeps_kind(SurfaceKind kind, const Similarity &motion) noexcept {
    switch (kind) {
    case SurfaceKind::plane:
        return motion.scale() == 1;
    case SurfaceKind::cylinder:
    case SurfaceKind::cone:
        return motion.scale() == 1 && !motion.mirrors();
    default:
        return !motion.mirrors();
    }
}

SurfaceShape elementary(SurfaceShape surface, const Similarity &motion) {
    if (!keeps_kind(surface.kind, motion)) {
        return Swept(surface, motion).shape();
    }
    surface.place = moved_frame(surface.place, motion);
    surface.sizes[0] *= motion.scale();
    surface.sizes[1] *= surface.kind == SurfaceKind::torus ? motion.scale() : 1; // that of a cone is an angle
    return surface;
}

// A mirror reverses the rotation about an axis, and the side to which normals along S_u x S_v point.
SurfaceShape image(SurfaceShape surface, const Similarity &motion) {
    const double side = motion.mirrors() ? -1 : 1;
    switch (surface.kind) {
    case SurfaceKind::revolution:
        surface.place = frame_at(motion.point(surface.place.origin), side * motion.turned(surface.place.z),
                                 motion.turned(surface.place.x));
        surface.curve = moved(surface.curve, motion);
        return surface;
    case SurfaceKind::extrusion:
        surface.curve = moved(surface.curve, motion);
        surface.vector = motion.turned(surface.vector);
        return surface;
    case SurfaceKind::offset:
        surface.basis = moved(surface.basis, motion);
        surface.distance *= side * motion.scale();
        return surface;
    case SurfaceKind::trimmed:
        surface.basis = moved(surface.basis, motion);
        return surface;
    case SurfaceKind::spline:
        surface.spline = moved_spline(*surface.spline, motion);
        return surface;
    default:
        return elementary(std::move(surface), motion);
    }
}

} // namespace

double Similarity::scale() const noexcept {
    const double l = length(columns[0]);
    return std::abs(l - 1) <= 8 * eps ? 1 : l;
}

bool Similarity::mirrors() const noexcept {
    return dot(cross(columns[0], columns[1]), columns[2]) < 0;
}

CurveShapePtr moved(const CurveShapePtr &curve, const Similarity &motion) {
    switch (curve->kind) {
    case CurveKind::spline:
        return curve_of_spline(moved_spline(*curve->spline, motion));
    case CurveKind::trimmed:
        return curve_of_piece(moved_pieces(curve->pieces, motion).front());
    case CurveKind::composite:
        return curve_of_pieces(moved_pieces(curve->pieces, motion), moved_spline(*curve->spline, motion));
    default:
        return moved_curve(*curve, motion);
    }
}

SurfaceShapePtr moved(const SurfaceShapePtr &surface, const Similarity &motion) {
    return std::make_shared<const SurfaceShape>(image(*surface, motion));
}

} // namespace nrb::model
