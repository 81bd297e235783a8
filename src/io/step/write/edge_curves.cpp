// SPDX-License-Identifier: MIT
#include "io/step/write/edge_curves.h"

#include "base/error.h"
#include "eval/curve_point.h"
#include "io/faces/make_face.h"
#include "io/step/write/write_geometry.h"
#include "io/written/edge_piece.h"
#include "model/shapes/curve_spline.h"
#include "refine/forms/parametrization.h"
#include "spline/part.h"

#include <algorithm>

namespace nrb::io::step {
namespace {

// Whether the two are at one place of space at equal parameters.
bool together(const face::Face &face, const Spline &curve, const model::CurveShape &edge, double tolerance) {
    const int64_t places = 16 + 4 * curve.count(0);
    for (int64_t i = 0; i <= places; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(places);
        const double t = parameter_in(curve.axis(0).domain(), share);
        face::Point2 place;
        eval::curve_point(curve, t, false, place.data());
        for (size_t k = 0; k < 2; ++k) {
            const Interval domain = face.covering().domain(static_cast<int>(k));
            place[k] = std::clamp(place[k], domain.lower, domain.upper);
        }
        const std::vector<double> x = face::point_at(*face.surface(), place);
        if (!(nrb::length(model::point_at(edge, t) - Vector3{x[0], x[1], x[2]}) <= tolerance)) {
            return false;
        }
    }
    return true;
}

// Whether readers take the curve of an edge, by its ends and its middle.
bool taken(const face::Face &face, const OrientedEdge &oriented, const model::CurvePiece &edge,
           double tolerance) {
    const SplinePtr along = oriented.along ? oriented.curve : refine::reverse(*oriented.curve, 0, false);
    return lies_under(*face.surface(), *along, *model::piece_spline(edge), tolerance);
}

} // namespace

model::CurvePiece stated_piece(const model::Edge &edge, const Vector3 &start, const Vector3 &end,
                               double tolerance) {
    if (edge.shape != nullptr && restatable(*edge.shape)) {
        if (const std::optional<model::CurvePiece> piece = piece_of_shape(edge, start, end, tolerance)) {
            return *piece;
        }
    }
    const model::CurveShapePtr curve = model::curve_of_spline(edge.curve);
    return {curve, model::natural_range(*curve), true};
}

SplinePtr parameter_curve(const face::Face &face, const OrientedEdge &oriented, const model::CurvePiece &edge,
                          double tolerance) {
    try {
        const SplinePtr curve =
            oriented.along == edge.forward ? oriented.curve : refine::reverse(*oriented.curve, 0, false);
        const SplinePtr over =
            same(curve->axis(0).domain(), edge.range) ? curve : refine::reparametrize(curve, 0, edge.range);
        const bool under = together(face, *over, *edge.curve, tolerance) ||
                           (face.tolerance() <= tolerance && taken(face, oriented, edge, tolerance));
        return under ? over : nullptr;
    } catch (const Error &) { // its knots would merge
        return nullptr;
    }
}

} // namespace nrb::io::step
