// SPDX-License-Identifier: MIT
#include "base/error.h"
#include "build/polylines.h"
#include "io/step/geometry/geometry.h"
#include "io/step/geometry/placements.h"
#include "io/step/geometry/spline_data.h"
#include "io/step/geometry/trims.h"
#include "model/shapes/curve_spline.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace nrb::io::step {
namespace {

using model::CurveKind;
using model::CurvePiece;
using model::CurveShape;
using model::CurveShapePtr;

double read_positive(Attributes &attributes, const char *name, double factor) {
    const double value = attributes.real(name);
    if (!(value > 0)) {
        attributes.fail_attribute(Status::length, name,
                                  std::string("found ") + Number(value).text + ", expected a length above 0");
    }
    return factor * value;
}

void skip_name(Attributes &attributes) {
    attributes.part("REPRESENTATION_ITEM");
    attributes.skip("name");
}

// What a spline of the curve may hold.
int64_t size_of(const CurveShape &curve) noexcept {
    switch (curve.kind) {
    case CurveKind::spline:
    case CurveKind::composite:
        return curve.spline->point_count() * (curve.spline->dim() + 2);
    case CurveKind::trimmed:
        return size_of(*curve.pieces.front().curve);
    case CurveKind::hyperbola:
        return 4096;
    default:
        return 64;
    }
}

bool measured_by_angle(const CurveShape &curve) noexcept {
    switch (curve.kind) {
    case CurveKind::circle:
    case CurveKind::ellipse:
        return true;
    case CurveKind::trimmed:
        return measured_by_angle(*curve.pieces.front().curve);
    default:
        return false;
    }
}

// X along a direction; the others are any.
build::Placement frame_along(const Point &origin, const Point &x) {
    const build::Placement z = build::make_placement(3, origin.x.data(), x.x.data(), nullptr, "pnt");
    return {z.origin, z.z, z.x, z.y, 3, z.z_rest, z.x_rest, z.y_rest, {}, z.given_axis};
}

} // namespace

void rethrow_named(const Instances &instances, const Instance &instance, const Error &error) {
    if (error.what()[0] == '#') {
        throw error;
    }
    fail(error.status(), "%s: %s", label_of(instances, instance).c_str(), error.what());
}

CurveShapePtr Geometry::curve(int64_t number, const Attributes &owner, const char *attribute) {
    const Instance &instance = entities_.at(number, owner, attribute);
    if (!is_curve(instance.kind())) {
        entities_.fail_kind(instance, owner, attribute, "a curve");
    }
    return curve(instance);
}

CurveShapePtr Geometry::curve(const Instance &instance) {
    return naming(entities_.instances(), instance, [&] {
        const Entities::Visit visit(entities_, instance.number());
        entities_.spend(Entities::size_of_a_shape);
        return read_curve(instance);
    });
}

CurveShapePtr Geometry::read_curve(const Instance &instance) {
    switch (instance.kind()) {
    case Kind::b_spline_curve:
    case Kind::bezier_curve:
    case Kind::uniform_curve:
    case Kind::quasi_uniform_curve:
    case Kind::b_spline_curve_with_knots:
        return model::curve_of_spline(read_b_spline_curve(entities_, instance, units_.length));
    case Kind::pcurve:
        fail(Status::unsupported,
             "a curve in a parameter plane alone does not become a curve of space in this version");
    case Kind::unread_curve:
        fail(Status::unsupported, "does not become a spline in this version");
    default:
        break;
    }
    Attributes attributes(entities_.instances(), instance);
    skip_name(attributes);
    switch (instance.kind()) {
    case Kind::line:
        return line(attributes);
    case Kind::polyline:
        return polyline(attributes);
    case Kind::trimmed_curve:
        return trimmed_curve(attributes);
    case Kind::composite_curve:
        return composite(attributes);
    case Kind::offset_curve_2d:
    case Kind::offset_curve_3d:
        return offset_curve(instance);
    case Kind::curve_replica:
        return curve_replica(instance, attributes);
    case Kind::surface_curve:
        attributes.part("SURFACE_CURVE");
        return curve(attributes.reference("curve_3d"), attributes, "curve_3d");
    default:
        return conic(instance, attributes);
    }
}

CurveShapePtr Geometry::line(Attributes &attributes) {
    attributes.part("LINE");
    const Point point = read_point(entities_, attributes.reference("pnt"), attributes, "pnt", units_.length);
    const Vector vector =
        read_vector(entities_, attributes.reference("dir"), attributes, "dir", units_.length);
    const Point &way = vector.direction;
    if (point.dim != way.dim) {
        attributes.fail_attribute(Status::syntax, "dir", "another dimension than that of pnt");
    }
    CurveShape line{CurveKind::line, {}, {0, 0}, nullptr, {}};
    line.place = way.dim == 2 ? build::make_placement(2, point.x.data(), nullptr, way.x.data(), "pnt")
                              : frame_along(point, way);
    line.sizes[0] = vector.magnitude;
    return std::make_shared<const CurveShape>(std::move(line));
}

CurveShapePtr Geometry::conic(const Instance &instance, Attributes &attributes) {
    attributes.part("CONIC");
    CurveShape conic{CurveKind::circle, {}, {0, 0}, nullptr, {}};
    conic.place =
        read_placement(entities_, attributes.reference("position"), attributes, "position", units_.length);
    const auto read_sizes = [&](CurveKind kind, const char *type, const char *first, const char *second) {
        conic.kind = kind;
        attributes.part(type);
        conic.sizes[0] = read_positive(attributes, first, units_.length);
        conic.sizes[1] = second == nullptr ? 0 : read_positive(attributes, second, units_.length);
    };
    switch (instance.kind()) {
    case Kind::ellipse:
        read_sizes(CurveKind::ellipse, "ELLIPSE", "semi_axis_1", "semi_axis_2");
        break;
    case Kind::parabola:
        read_sizes(CurveKind::parabola, "PARABOLA", "focal_dist", nullptr);
        break;
    case Kind::hyperbola:
        read_sizes(CurveKind::hyperbola, "HYPERBOLA", "semi_axis", "semi_imag_axis");
        break;
    default:
        read_sizes(CurveKind::circle, "CIRCLE", "radius", nullptr);
    }
    return std::make_shared<const CurveShape>(std::move(conic));
}

CurveShapePtr Geometry::polyline(Attributes &attributes) {
    attributes.part("POLYLINE");
    std::vector<double> points;
    int dim = 0;
    attributes.open("points");
    while (attributes.more("points")) {
        entities_.spend(4);
        const Point point =
            read_point(entities_, attributes.reference("points"), attributes, "points", units_.length);
        if (dim != 0 && point.dim != dim) {
            attributes.fail_attribute(Status::syntax, "points",
                                      "another dimension than that of the first point");
        }
        dim = point.dim;
        points.insert(points.end(), point.x.begin(), point.x.begin() + dim);
    }
    if (dim == 0 || std::ssize(points) < 2 * dim) {
        attributes.fail_attribute(Status::too_few_points, "points", "fewer than 2 points");
    }
    std::vector<double> params(points.size() / static_cast<size_t>(dim));
    std::iota(params.begin(), params.end(), 0.0);
    return model::curve_of_spline(build::polyline(dim, std::move(points), std::move(params)));
}

// By points where the file prefers them or has no parameters, otherwise by parameters.
CurveShapePtr Geometry::trimmed_curve(Attributes &attributes) {
    attributes.part("TRIMMED_CURVE");
    const int64_t number = attributes.reference("basis_curve");
    const Trim first = read_trim(entities_, attributes, "trim_1", units_.length);
    const Trim second = read_trim(entities_, attributes, "trim_2", units_.length);
    const bool forward = attributes.boolean("sense_agreement");
    const bool prefers_points = attributes.enumeration("master_representation") == "CARTESIAN";
    const bool points = first.point && second.point, parameters = first.parameter && second.parameter;
    if (!points && !parameters) {
        attributes.fail_attribute(Status::syntax, "trim_2",
                                  "a point and a parameter, expected two of one kind");
    }
    const auto between = [&](const CurveShapePtr &basis) {
        entities_.spend(size_of(*basis));
        const double unit = measured_by_angle(*basis) ? units_.angle : 1;
        return model::piece_between(basis, unit * *first.parameter, unit * *second.parameter, forward,
                                    units_.tolerance);
    };
    const bool by_points = points && (prefers_points || !parameters);
    if (const Instance &offset = entities_.at(number, attributes, "basis_curve");
        !by_points && is_offset_curve(offset.kind())) {
        return trimmed_offset(offset, between);
    }
    const int64_t before = entities_.approximations();
    const CurveShapePtr basis = curve(number, attributes, "basis_curve");
    if (!by_points && entities_.approximations() != before) {
        attributes.fail_attribute(Status::unsupported, "basis_curve",
                                  "is approximated, over parameters that may be others between its knots");
    }
    if (by_points) {
        entities_.spend(size_of(*basis));
        return model::curve_of_piece(model::piece_between(
            basis, {first.point->x.data(), second.point->x.data(), forward, units_.tolerance}));
    }
    return model::curve_of_piece(between(basis));
}

CurvePiece Geometry::segment(int64_t number, const Attributes &owner) {
    const Instance &instance =
        entities_.at(number, Kind::composite_curve_segment, owner, "segments", "a COMPOSITE_CURVE_SEGMENT");
    return naming(entities_.instances(), instance, [&] {
        Attributes attributes(entities_.instances(), instance);
        attributes.part("COMPOSITE_CURVE_SEGMENT");
        attributes.skip("transition");
        const bool forward = attributes.boolean("same_sense");
        const CurveShapePtr parent = curve(attributes.reference("parent_curve"), attributes, "parent_curve");
        entities_.spend(size_of(*parent));
        if (!model::bounded(*parent)) {
            attributes.fail_attribute(Status::length, "parent_curve", "has no ends");
        }
        return CurvePiece{parent, model::natural_range(*parent), forward};
    });
}

CurveShapePtr Geometry::composite(Attributes &attributes) {
    attributes.part("COMPOSITE_CURVE");
    std::vector<CurvePiece> pieces;
    attributes.open("segments");
    while (attributes.more("segments")) {
        pieces.push_back(segment(attributes.reference("segments"), attributes));
    }
    if (pieces.empty()) {
        attributes.fail_attribute(Status::count, "segments", "is empty");
    }
    return model::composite_curve(std::move(pieces), units_.tolerance);
}

ParameterCurve Geometry::parameter_curve(const Instance &pcurve) {
    return naming(entities_.instances(), pcurve, [&] {
        Attributes attributes(entities_.instances(), pcurve);
        skip_name(attributes);
        attributes.part("PCURVE");
        const int64_t surface = attributes.reference("basis_surface");
        const Instance &representation =
            entities_.at(attributes.reference("reference_to_curve"), Kind::definitional_representation,
                         attributes, "reference_to_curve", "a DEFINITIONAL_REPRESENTATION");
        Attributes items(entities_.instances(), representation);
        items.part("REPRESENTATION");
        items.skip("name");
        items.open("items");
        const Units plain{1, units_.angle, 0};
        Geometry in_plane(entities_, plain);
        return ParameterCurve{surface, in_plane.curve(items.reference("items"), items, "items")};
    });
}

} // namespace nrb::io::step
