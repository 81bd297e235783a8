#include "build/conic_focus.h"

#include "base/error.h"
#include "base/norm.h"
#include "build/conic_arc.h"

#include <array>
#include <cmath>
#include <vector>

namespace nrb {

namespace {

// The arc of r (1 + e cos a) = e d between two angles less than a turn apart: the homogeneous points (e d cos a, e d sin
// a; 1 + e cos a) are a linear image of those of the circle.
ConicArc focal_arc(const Placement &place, double parameter, double e, const Angle &from, const Angle &to,
                   const Angle &mean, double half_cosine) {
    const Direction a = from.direction(), b = to.direction(), m = mean.direction();
    const double wa = 1 + e * a.cos, wb = 1 + e * b.cos;
    if (!(wa > 0) || !(wb > 0)) {
        fail(NURBS_ERROR_CONIC, "the angles reach infinity: 1 + eccentricity * cos(angle) is not positive");
    }
    const auto dim = static_cast<size_t>(place.dim);
    ConicArc arc{std::vector<double>(dim), std::vector<double>(dim), std::vector<double>(dim),
                 (half_cosine + e * m.cos) / std::sqrt(wa * wb)};
    place.point(parameter * a.cos / wa, parameter * a.sin / wa, 0, arc.start.data());
    place.point(parameter * b.cos / wb, parameter * b.sin / wb, 0, arc.end.data());
    const double root = std::sqrt(wa * wb);
    Placement at_origin = place;
    at_origin.origin = {};
    at_origin.point(parameter * m.cos / root - arc.weight * parameter * a.cos / wa,
                    parameter * m.sin / root - arc.weight * parameter * a.sin / wa, 0, arc.middle.data());
    return arc;
}

} // namespace

FocalFrame focal_frame(int32_t dim, const double *focus, const double *axis, const double *foot) {
    make_placement(dim, focus, axis, nullptr, "focus");
    check_point(foot, dim, "foot");
    std::array<double, 3> x{};
    for (size_t c = 0; c < static_cast<size_t>(dim); ++c) {
        x[c] = foot[c] - focus[c];
    }
    check_direction(x.data(), dim, "foot - focus");
    const FocalFrame frame{make_placement(dim, focus, axis, x.data(), "focus"), distance(foot, focus, dim)};
    const double lean = std::fabs(dot(frame.place.z, unit({x[0], x[1], x[2]})));
    const double size = largest(frame.place.origin) / frame.distance;
    if (dim == 3 && lean > 8 * 0x1p-52 * (1 + size)) {
        fail(NURBS_ERROR_DIRECTION,
             "axis is not perpendicular to foot - focus: the cosine of the angle is %s", Number(lean).text);
    }
    return frame;
}

SplinePtr conic_focus(const FocalFrame &frame, double eccentricity, const Turn &turn, int32_t form) {
    check_arc_form(form, NURBS_ARC_THIRDS);
    if (!std::isfinite(eccentricity) || !(eccentricity > 0)) {
        fail(NURBS_ERROR_FACTOR, "eccentricity = %s, expected a finite number above 0",
             Number(eccentricity).text);
    }
    const int64_t arcs = std::fabs(turn.sweep.radians()) > 3 ? 2 : 1; // less than half a turn, or just that
    const double half_cosine = turn.sweep.part(1, 2 * arcs).direction().cos;
    std::vector<ConicArc> pieces;
    for (int64_t i = 0; i < arcs; ++i) {
        const auto at = [&](int64_t half) { return turn.start.plus(turn.sweep, 2 * i + half, 2 * arcs); };
        pieces.push_back(focal_arc(frame.place, eccentricity * frame.distance, eccentricity, at(0), at(2),
                                   at(1), half_cosine));
    }
    if (turn.sweep.full_turn()) {
        pieces.back().end = pieces.front().start;
    }
    return conic_curve(pieces, form);
}

} // namespace nrb
