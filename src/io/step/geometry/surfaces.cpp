// SPDX-License-Identifier: MIT
#include "base/error.h"
#include "io/step/geometry/geometry.h"
#include "io/step/geometry/placements.h"
#include "io/step/geometry/spline_data.h"
#include "model/shapes/offset_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace nrb::io::step {
namespace {

using model::Measure;
using model::SurfaceKind;
using model::SurfaceShape;
using model::SurfaceShapePtr;

SurfaceShape shape_of(SurfaceKind kind) {
    SurfaceShape shape{kind, {}, {0, 0}, {}, nullptr, {}, nullptr, 0, true, true, nullptr};
    shape.place.dim = 3;
    return shape;
}

// Not negative: 0 is a cone that begins at its apex.
double read_length(Attributes &attributes, const char *name, double factor, bool zero = false) {
    const double value = attributes.real(name);
    if (!(value > 0) && !(zero && value == 0)) {
        attributes.fail_attribute(Status::length, name,
                                  std::string("found ") + Number(value).text + ", expected a length above 0");
    }
    return factor * value;
}

} // namespace

SurfaceShapePtr Geometry::surface(int64_t number, const Attributes &owner, const char *attribute) {
    const Instance &instance = entities_.at(number, owner, attribute);
    if (!is_surface(instance.kind())) {
        entities_.fail_kind(instance, owner, attribute, "a surface");
    }
    return surface(instance);
}

SurfaceShapePtr Geometry::surface(const Instance &instance) {
    return naming(entities_.instances(), instance, [&] {
        const Entities::Visit visit(entities_, instance.number());
        entities_.spend(Entities::size_of_a_shape);
        return read_surface(instance);
    });
}

SurfaceShapePtr Geometry::read_surface(const Instance &instance) {
    Attributes attributes(entities_.instances(), instance);
    attributes.part("REPRESENTATION_ITEM");
    attributes.skip("name");
    SurfaceShape shape = shape_of(SurfaceKind::spline);
    switch (instance.kind()) {
    case Kind::b_spline_surface:
    case Kind::bezier_surface:
    case Kind::uniform_surface:
    case Kind::quasi_uniform_surface:
    case Kind::b_spline_surface_with_knots:
        shape.spline = read_b_spline_surface(entities_, instance, units_.length);
        break;
    case Kind::surface_of_revolution:
        shape = revolution(attributes);
        break;
    case Kind::surface_of_linear_extrusion:
        shape = extrusion(attributes);
        break;
    case Kind::offset_surface:
        return offset(attributes);
    case Kind::rectangular_trimmed_surface:
        shape = rectangular_trimmed(attributes);
        break;
    case Kind::curve_bounded_surface:
        attributes.part("CURVE_BOUNDED_SURFACE");
        return surface(attributes.reference("basis_surface"), attributes, "basis_surface");
    case Kind::surface_replica:
        return surface_replica(instance, attributes);
    case Kind::unread_surface:
        fail(Status::unsupported, "does not become a spline in this version");
    default:
        shape = elementary(instance, attributes);
    }
    return std::make_shared<const SurfaceShape>(std::move(shape));
}

SurfaceShape Geometry::elementary(const Instance &instance, Attributes &attributes) {
    attributes.part("ELEMENTARY_SURFACE");
    SurfaceShape shape = shape_of(SurfaceKind::plane);
    shape.place =
        read_placement(entities_, attributes.reference("position"), attributes, "position", units_.length);
    if (shape.place.dim != 3) {
        attributes.fail_attribute(Status::dimension, "position",
                                  "a placement of the plane, expected one of space");
    }
    switch (instance.kind()) {
    case Kind::cylindrical_surface:
        shape.kind = SurfaceKind::cylinder;
        attributes.part("CYLINDRICAL_SURFACE");
        shape.sizes[0] = read_length(attributes, "radius", units_.length);
        break;
    case Kind::conical_surface:
        shape.kind = SurfaceKind::cone;
        attributes.part("CONICAL_SURFACE");
        shape.sizes[0] = read_length(attributes, "radius", units_.length, true);
        shape.sizes[1] = units_.angle * attributes.real("semi_angle");
        if (!(std::fabs(shape.sizes[1]) < std::numbers::pi / 2)) {
            attributes.fail_attribute(Status::angle, "semi_angle",
                                      std::string("is ") + Number(shape.sizes[1]).text +
                                          " in radians, expected less than a quarter turn");
        }
        break;
    case Kind::spherical_surface:
        shape.kind = SurfaceKind::sphere;
        attributes.part("SPHERICAL_SURFACE");
        shape.sizes[0] = read_length(attributes, "radius", units_.length);
        break;
    case Kind::toroidal_surface:
    case Kind::degenerate_toroidal_surface:
        shape.kind = SurfaceKind::torus;
        attributes.part("TOROIDAL_SURFACE");
        shape.sizes[0] = read_length(attributes, "major_radius", units_.length);
        shape.sizes[1] = read_length(attributes, "minor_radius", units_.length);
        shape.range.v = {0, model::turn};
        if (instance.kind() == Kind::degenerate_toroidal_surface) {
            set_degenerate_range(shape, attributes);
        }
        break;
    default:
        break;
    }
    return shape;
}

// The tube meets the axis where s0 + s1 cos v = 0: outside of it the surface looks like an apple, inside like a lemon.
void Geometry::set_degenerate_range(SurfaceShape &torus, Attributes &attributes) {
    attributes.part("DEGENERATE_TOROIDAL_SURFACE");
    const bool outer = attributes.boolean("select_outer");
    if (!(torus.sizes[0] < torus.sizes[1])) {
        attributes.fail_attribute(Status::length, "major_radius", "is not below minor_radius");
    }
    const double meets = std::acos(-torus.sizes[0] / torus.sizes[1]);
    torus.range.v = outer ? Interval{-meets, meets} : Interval{meets, model::turn - meets};
}

SurfaceShape Geometry::revolution(Attributes &attributes) {
    attributes.part("SWEPT_SURFACE");
    SurfaceShape shape = shape_of(SurfaceKind::revolution);
    shape.curve = curve(attributes.reference("swept_curve"), attributes, "swept_curve");
    attributes.part("SURFACE_OF_REVOLUTION");
    shape.place = read_axis(entities_, attributes.reference("axis_position"), attributes, "axis_position",
                            units_.length);
    return shape;
}

SurfaceShape Geometry::extrusion(Attributes &attributes) {
    attributes.part("SWEPT_SURFACE");
    SurfaceShape shape = shape_of(SurfaceKind::extrusion);
    shape.curve = curve(attributes.reference("swept_curve"), attributes, "swept_curve");
    attributes.part("SURFACE_OF_LINEAR_EXTRUSION");
    shape.vector = read_vector(entities_, attributes.reference("extrusion_axis"), attributes,
                               "extrusion_axis", units_.length)
                       .value();
    return shape;
}

SurfaceShapePtr Geometry::offset(Attributes &attributes) {
    attributes.part("OFFSET_SURFACE");
    SurfaceShape shape = shape_of(SurfaceKind::offset);
    const int64_t before = entities_.approximations();
    shape.basis = surface(attributes.reference("basis_surface"), attributes, "basis_surface");
    if (entities_.approximations() != before) {
        attributes.fail_attribute(Status::unsupported, "basis_surface",
                                  "is made of an approximated curve, which leaves its normals unknown");
    }
    shape.distance = units_.length * attributes.real("distance");
    const SurfaceShapePtr known = model::known_offset(shape.basis, shape.distance);
    return known != nullptr ? known : std::make_shared<const SurfaceShape>(std::move(shape));
}

double Geometry::in_radians(double parameter, Measure measure) const noexcept {
    return parameter *
           (measure == Measure::angle ? units_.angle : (measure == Measure::length ? units_.length : 1));
}

// Around an axis the part may go on behind the seam. The senses say in which direction the first parameter leads to
// the second; without a seam the parameters themselves do.
SurfaceShape Geometry::rectangular_trimmed(Attributes &attributes) {
    attributes.part("RECTANGULAR_TRIMMED_SURFACE");
    SurfaceShape shape = shape_of(SurfaceKind::trimmed);
    shape.basis = surface(attributes.reference("basis_surface"), attributes, "basis_surface");
    const Measure u = measure_of(*shape.basis, 0), v = measure_of(*shape.basis, 1);
    double ends[4] = {0, 0, 0, 0};
    int i = 0;
    for (const char *name : {"u1", "u2", "v1", "v2"}) {
        ends[i] = in_radians(attributes.real(name), i < 2 ? u : v);
        ++i;
    }
    const auto part = [](double first, double second, bool &forward, Interval all, Measure measure) {
        if (measure != Measure::angle || !(all.upper - all.lower > 6)) {
            forward = first < second;
            return Interval{std::min(first, second), std::max(first, second)};
        }
        const double from = forward ? first : second, to = forward ? second : first;
        return Interval{from, to - model::turn * (std::ceil((to - from) / model::turn) - 1)};
    };
    shape.u_forward = attributes.boolean("usense");
    shape.v_forward = attributes.boolean("vsense");
    const model::Rectangle all = natural_range(*shape.basis);
    shape.range.u = part(ends[0], ends[1], shape.u_forward, all.u, u);
    shape.range.v = part(ends[2], ends[3], shape.v_forward, all.v, v);
    return shape;
}

} // namespace nrb::io::step
