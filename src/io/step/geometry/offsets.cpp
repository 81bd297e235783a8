// SPDX-License-Identifier: MIT
#include "base/error.h"
#include "io/faces/stated_offset.h"
#include "io/step/geometry/geometry.h"
#include "io/step/geometry/placements.h"
#include "model/shapes/curve_spline.h"

#include <utility>

namespace nrb::io::step {
namespace {

using model::CurvePiece;
using model::CurveShapePtr;

// Of directions that are parallel, after their rounding.
constexpr double parallel_sine = 1e-14;

// Of a curve of the plane the normal is to the left, which is Z x T.
Vector3 read_reference(Entities &entities, Attributes &attributes) {
    const Point direction =
        read_direction(entities, attributes.reference("ref_direction"), attributes, "ref_direction");
    if (direction.dim != 3) {
        attributes.fail_attribute(Status::dimension, "ref_direction",
                                  "a direction of the plane, expected one of space");
    }
    return unit({direction.x[0], direction.x[1], direction.x[2]});
}

} // namespace

// The parameters of all of them are those of the basis.
Geometry::OffsetChain Geometry::offset_chain(const Instance &instance, const BasisPart &part) {
    const bool plane = instance.kind() == Kind::offset_curve_2d;
    Attributes attributes(entities_.instances(), instance);
    attributes.part("REPRESENTATION_ITEM");
    attributes.skip("name");
    attributes.part(plane ? "OFFSET_CURVE_2D" : "OFFSET_CURVE_3D");
    const int64_t before = entities_.approximations(), number = attributes.reference("basis_curve");
    OffsetChain chain;
    if (const Instance &under = entities_.at(number, attributes, "basis_curve");
        is_offset_curve(under.kind())) {
        const Entities::Visit visit(entities_, number);
        entities_.spend(Entities::size_of_a_shape);
        chain = naming(entities_.instances(), under, [&] { return offset_chain(under, part); });
    } else {
        const CurveShapePtr all = curve(number, attributes, "basis_curve");
        chain.basis = part ? part(all) : all;
    }
    if ((chain.basis->place.dim == 2) != plane) {
        attributes.fail_attribute(Status::dimension, "basis_curve",
                                  plane ? "a curve of space, expected one of the plane"
                                        : "a curve of the plane, expected one of space");
    }
    double distance = units_.length * attributes.real("distance");
    attributes.skip("self_intersect");
    const Vector3 reference = plane ? Vector3{0, 0, 1} : read_reference(entities_, attributes);
    if (distance != 0 && entities_.approximations() != before) {
        attributes.fail_attribute(Status::unsupported, "basis_curve",
                                  "is approximated, which leaves its normals unknown");
    }
    if (!chain.distances.empty() && length(cross(reference, chain.reference)) > parallel_sine) {
        attributes.fail_attribute(Status::unsupported, "basis_curve",
                                  "is an offset about another reference direction");
    }
    const bool against = !chain.distances.empty() && dot(reference, chain.reference) < 0;
    chain.reference = chain.distances.empty() ? reference : chain.reference;
    chain.distances.push_back(against ? -distance : distance);
    return chain;
}

// C + d V x T / |V x T| with the unit tangent T of the basis and the reference direction V.
CurveShapePtr Geometry::offset_curve(const Instance &instance, const BasisPart &part) {
    const OffsetChain chain = offset_chain(instance, part);
    model::MadeCurve made =
        stated_offset(entities_, chain.basis, chain.distances, chain.reference, units_.tolerance);
    entities_.remark(instance.number(), made.distance > 0, note_on(made));
    return std::move(made.curve);
}

// Between parameters, which are those of the basis: a part of the offset is the offset of a part of the basis, which needs no ends.
CurveShapePtr Geometry::trimmed_offset(const Instance &offset, const PartBetween &between) {
    return naming(entities_.instances(), offset, [&] {
        const Entities::Visit visit(entities_, offset.number());
        entities_.spend(Entities::size_of_a_shape);
        bool forward = true;
        CurveShapePtr whole = offset_curve(offset, [&](const CurveShapePtr &basis) {
            CurvePiece piece = between(basis);
            forward = std::exchange(piece.forward, true); // the normal is that of the basis
            return model::curve_of_piece(std::move(piece));
        });
        const Interval range = model::natural_range(*whole);
        return forward ? whole : model::curve_of_piece({std::move(whole), range, false});
    });
}

} // namespace nrb::io::step
