// SPDX-License-Identifier: MIT
#include "base/error.h"
#include "io/faces/stated_offset.h"
#include "io/iges/geometry/geometry.h"
#include "io/iges/geometry/polylines.h"
#include "io/iges/geometry/shapes.h"
#include "model/shapes/curve_spline.h"

#include <cmath>
#include <cstdlib>

namespace nrb::io::iges {
namespace {

using model::CurvePiece;
using model::CurveShapePtr;

constexpr int64_t one_distance = 1, linear_distance = 2; // values of the flag; 3: a function

// The relative accuracy of parameters in files.
constexpr double parameter_digits = 1e-9;

bool about(double a, double b, Interval range) noexcept {
    return std::abs(a - b) <= parameter_digits * (range.upper - range.lower);
}

// The part between TT1 and TT2, or the whole curve where they are both 0 or are its ends.
CurvePiece part_of(CurvePiece piece, double first, double last) {
    const Interval all = piece.range;
    if ((first == 0 && last == 0) || (about(first, all.lower, all) && about(last, all.upper, all))) {
        return piece;
    }
    if (!(first < last) || !std::isfinite(last - first)) {
        fail(Status::empty_domain, "TT1 = %s and TT2 = %s, expected rising parameters", Number(first).text,
             Number(last).text);
    }
    if (!piece.forward || !standard_parameters(piece)) {
        fail(Status::unsupported,
             "TT1 = %s and TT2 = %s are no ends of the curve, whose parameters are not "
             "those of the standard",
             Number(first).text, Number(last).text);
    }
    piece.range = {about(first, all.lower, all) ? all.lower : first,
                   about(last, all.upper, all) ? all.upper : last};
    if (!(piece.range.lower >= all.lower) || !(piece.range.upper <= all.upper)) {
        fail(Status::outside_domain, "TT1 = %s and TT2 = %s lie outside [%s, %s]", Number(first).text,
             Number(last).text, Number(all.lower).text, Number(all.upper).text);
    }
    return piece;
}

// Distances that vary along the curve cannot be represented by the shapes of this library.
void check_flag(int64_t flag) {
    if (flag == one_distance) {
        return;
    }
    fail(flag == linear_distance || flag == 3 ? Status::unsupported : Status::syntax, "FLAG = %lld: %s",
         static_cast<long long>(flag),
         flag == linear_distance ? "a distance that changes linearly does not become a spline in this version"
         : flag == 3             ? "a distance that is a function does not become a spline in this version"
                                 : "expected 1, 2 or 3");
}

// Under a reflection, V x T becomes its mirror image with the opposite sign.
fit::CurveOffset placed_offset(const Placement &place, double distance, const Vector3 &normal) {
    const double scale = place.scale();
    if (scale == 0) {
        fail(Status::unsupported, "a matrix that is not a rotation does not keep distances");
    }
    Vector3 reference = place.vector(normal);
    if (place.parameter_plane) {
        reference.x = reference.y = 0;
    }
    if (!(length(reference) > 0)) {
        fail(Status::direction, "(VX, VY, VZ) = (%s, %s, %s), expected the normal of the plane of the curve",
             Number(normal.x).text, Number(normal.y).text, Number(normal.z).text);
    }
    return {(place.mirrors() ? -scale : scale) * distance, unit(reference)};
}

} // namespace

// C + D1 V x T / |V x T| with the unit tangent T of the curve and the normal V, over the parameters of the
// curve from TT1 to TT2.
CurvePiece Geometry::offset_curve(Reading &reading) {
    Record &record = reading.record;
    const int64_t pointer = record.integer("curve");
    check_flag(record.integer("FLAG"));
    record.skip(3); // function, its coordinate, and its argument
    const double distance = record.real("D1");
    record.skip(3); // TD1, D2, TD2
    const auto [x, y, z] = read_point(record, "normal");
    const double first = record.real("TT1"), last = record.real("TT2");
    reading.parts.push_back(pointer);
    CurvePiece basis =
        part_of(any_curve(pointer, reading.outer(), reading.place.parameter_plane), first, last);
    const fit::CurveOffset offset = placed_offset(reading.place, distance, {x, y, z});
    if (distance != 0 && approximated_.contains(pointer)) {
        fail(Status::unsupported, "the curve is approximated, which leaves its normals unknown");
    }
    entities_.spend(size_of(basis));
    model::MadeCurve made = stated_offset(entities_, shape_of_piece(basis), offset,
                                          reading.place.parameter_plane ? 0 : units_.resolution);
    remark(reading.entry.line, made.distance > 0, note_on(made));
    return whole(std::move(made.curve));
}

void Geometry::remark(int64_t pointer, bool approximated, std::string text) {
    if (approximated) {
        approximated_.insert(pointer);
    }
    if (!text.empty() && told_.insert(pointer).second) {
        remarks_.push_back({pointer, std::move(text), Status::tolerance});
    }
}

} // namespace nrb::io::iges
