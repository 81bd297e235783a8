// SPDX-License-Identifier: MIT
#include "base/error.h"
#include "io/step/geometry/geometry.h"
#include "io/step/motion.h"

namespace nrb::io::step {
namespace {

using model::CurveShapePtr;
using model::SurfaceShapePtr;

Motion read_transformation(Entities &entities, Attributes &attributes, double length) {
    const Instance &instance =
        entities.at(attributes.reference("transformation"), attributes, "transformation");
    if (!is_operator(entities.instances(), instance)) {
        entities.fail_kind(instance, attributes, "transformation", "a CARTESIAN_TRANSFORMATION_OPERATOR_3D");
    }
    return read_operator(entities, instance, length);
}

} // namespace

// What has been approximated in it is no nearer than that, times the scale.
void Geometry::tell_scale(const Instance &instance, double scale, int64_t before) {
    if (scale != 1 && entities_.approximations() != before) {
        entities_.remark(instance.number(), false,
                         std::string("scales what is approximated by ") + Number(scale).text);
    }
}

CurveShapePtr Geometry::curve_replica(const Instance &instance, Attributes &attributes) {
    attributes.part("CURVE_REPLICA");
    const int64_t before = entities_.approximations();
    const CurveShapePtr parent = curve(attributes.reference("parent_curve"), attributes, "parent_curve");
    if (parent->place.dim == 2) {
        attributes.fail_attribute(
            Status::unsupported, "parent_curve",
            "a curve of the plane, whose replica does not become a spline in this version");
    }
    const Motion motion = read_transformation(entities_, attributes, units_.length);
    entities_.spend(parent->spline == nullptr ? 0 : parent->spline->point_count() * parent->spline->width());
    tell_scale(instance, motion.scale(), before);
    return model::moved(parent, motion);
}

SurfaceShapePtr Geometry::surface_replica(const Instance &instance, Attributes &attributes) {
    attributes.part("SURFACE_REPLICA");
    const int64_t before = entities_.approximations();
    const SurfaceShapePtr parent =
        surface(attributes.reference("parent_surface"), attributes, "parent_surface");
    const Motion motion = read_transformation(entities_, attributes, units_.length);
    entities_.spend(parent->spline == nullptr ? 0 : parent->spline->point_count() * parent->spline->width());
    tell_scale(instance, motion.scale(), before);
    return model::moved(parent, motion);
}

} // namespace nrb::io::step
