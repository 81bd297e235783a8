// SPDX-License-Identifier: MIT
// Curves and surfaces of a file as shapes.
#pragma once

#include "base/error.h"
#include "io/step/entities.h"
#include "model/shapes/surface_shape.h"

#include <functional>

namespace nrb::io::step {

// A curve in the parameter plane of a surface, in the units of the file.
struct ParameterCurve {
    int64_t surface; // the number of the instance
    model::CurveShapePtr curve;
};

// What goes wrong throws Error and names the instance in which it does: Status::syntax, unsupported for entities that
// are not read, too_large, and what the builders throw.
class Geometry {
public:
    Geometry(Entities &entities, const Units &units) noexcept : entities_(entities), units_(units) {}

    // A curve of space or of the plane, whatever its entity. Surface curves are their 3D curves.
    model::CurveShapePtr curve(const Instance &instance);
    model::CurveShapePtr curve(int64_t number, const Attributes &owner, const char *attribute);
    model::SurfaceShapePtr surface(const Instance &instance);
    model::SurfaceShapePtr surface(int64_t number, const Attributes &owner, const char *attribute);
    ParameterCurve parameter_curve(const Instance &pcurve);

    [[nodiscard]] const Units &units() const noexcept { return units_; }
    [[nodiscard]] Entities &entities() const noexcept { return entities_; }

private:
    model::CurveShapePtr read_curve(const Instance &instance);
    model::CurveShapePtr line(Attributes &attributes);
    model::CurveShapePtr conic(const Instance &instance, Attributes &attributes);
    model::CurveShapePtr polyline(Attributes &attributes);
    model::CurveShapePtr trimmed_curve(Attributes &attributes);
    model::CurveShapePtr composite(Attributes &attributes);
    model::CurveShapePtr curve_replica(const Instance &instance, Attributes &attributes);
    model::CurvePiece segment(int64_t number, const Attributes &owner);
    using BasisPart = std::function<model::CurveShapePtr(const model::CurveShapePtr &basis)>;
    model::CurveShapePtr offset_curve(const Instance &instance, const BasisPart &part = {});
    // Offsets of each other, from the innermost one on, and the curve under them.
    struct OffsetChain {
        model::CurveShapePtr basis;
        std::vector<double> distances;
        Vector3 reference;
    };
    OffsetChain offset_chain(const Instance &instance, const BasisPart &part);
    using PartBetween = std::function<model::CurvePiece(const model::CurveShapePtr &basis)>;
    model::CurveShapePtr trimmed_offset(const Instance &offset, const PartBetween &between);

    model::SurfaceShapePtr read_surface(const Instance &instance);
    model::SurfaceShape elementary(const Instance &instance, Attributes &attributes);
    static void set_degenerate_range(model::SurfaceShape &torus, Attributes &attributes);
    model::SurfaceShape revolution(Attributes &attributes);
    model::SurfaceShape extrusion(Attributes &attributes);
    model::SurfaceShapePtr offset(Attributes &attributes);
    model::SurfaceShapePtr surface_replica(const Instance &instance, Attributes &attributes);
    void tell_scale(const Instance &instance, double scale, int64_t before);
    model::SurfaceShape rectangular_trimmed(Attributes &attributes);
    [[nodiscard]] double in_radians(double parameter, model::Measure measure) const noexcept;

    Entities &entities_;
    const Units &units_;
};

// Rethrows what fn() throws, with the label of an instance before messages that name none.
template <class Function>
auto naming(const Instances &instances, const Instance &instance, Function &&function);

// Throws the error that is being handled, with the label of an instance before a message that names none.
[[noreturn]] void rethrow_named(const Instances &instances, const Instance &instance, const Error &error);

template <class Function>
auto naming(const Instances &instances, const Instance &instance, Function &&function) {
    try {
        return function();
    } catch (const Error &error) {
        rethrow_named(instances, instance, error);
    }
}

} // namespace nrb::io::step
