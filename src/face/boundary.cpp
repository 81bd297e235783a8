// SPDX-License-Identifier: MIT
#include "face/boundary.h"

#include "build/polylines.h"
#include "face/made/seam_parts.h"
#include "face/open_ends.h"

#include <algorithm>
#include <span>

namespace nrb::face {

namespace {

// A piece of the boundary as a curve, with the ends that it has in common with its neighbours.
SplinePtr curve_of(const TrimPieces &pieces, const TrimPiece &piece) {
    const std::span<const double> coefficients = pieces.coefficients(piece);
    const size_t count = static_cast<size_t>(piece.degree) + 1, width = piece.weighted ? 3 : 2;
    std::vector<double> points, weights, knots(2 * count, 1.0);
    std::fill_n(knots.begin(), count, 0.0);
    for (size_t i = 0; i < count; ++i) {
        const double w = piece.weighted ? coefficients[i * width + 2] : 1;
        points.insert(points.end(), {coefficients[i * width] / w, coefficients[i * width + 1] / w});
        if (piece.weighted) {
            weights.push_back(w);
        }
    }
    std::ranges::copy(piece.start, points.begin());
    std::ranges::copy(piece.end, points.end() - 2);
    return make_spline({make_knot_vector(piece.degree, std::move(knots))}, 2,
                       piece.weighted ? Form::rational : Form::polynomial, std::move(points),
                       std::move(weights));
}

BoundaryCurve boundary_curve(const Face &face, SplinePtr plane, int32_t loop) {
    SplinePtr space = composed_edge(face.surface(), face.covering(), plane);
    return {std::move(plane), std::move(space), loop};
}

// In the copy of the domain in which it begins.
SplinePtr line_between(const Face &face, const Point2 &start, const Point2 &end) {
    const Point2 from = face.covering().in_domain(start),
                 to{end[0] + (from[0] - start[0]), end[1] + (from[1] - start[1])};
    return build::polyline(2, {from[0], from[1], to[0], to[1]}, {0, 1});
}

BoundaryCurve segment(const Face &face, const Point2 &start, const Point2 &end) {
    return boundary_curve(face, line_between(face, start, end), -1);
}

// The segment that closes a gap, in pieces between the seams that it crosses; whole if it leaves the domain.
void append_joint(const Face &face, const Joint &joint, std::vector<BoundaryCurve> &curves) {
    const SplinePtr line = line_between(face, joint.from, joint.to);
    std::vector<SplinePtr> parts = seam_parts(face.covering(), line).parts;
    if (parts.empty()) {
        parts.push_back(line);
    }
    for (SplinePtr &part : parts) {
        curves.push_back(boundary_curve(face, std::move(part), -1));
    }
}

std::vector<BoundaryCurve> curves_of_loop(const Face &face, int32_t number) {
    std::vector<BoundaryCurve> curves;
    for (const Coedge &coedge : face.loops()[static_cast<size_t>(number)]) {
        curves.push_back(boundary_curve(face, coedge.curve, number));
    }
    if (std::ranges::all_of(curves, [](const BoundaryCurve &curve) { return curve.space != nullptr; })) {
        return curves;
    }
    curves.clear();
    const TrimPieces &pieces = face.trims().pieces();
    for (const TrimPiece &piece : pieces.all()) {
        if (piece.loop == number) {
            curves.push_back(boundary_curve(face, curve_of(pieces, piece), number));
        }
    }
    return curves;
}

} // namespace

std::vector<BoundaryCurve> boundary_curves(const Face &face) {
    std::vector<BoundaryCurve> curves;
    for (int32_t i = 0; i < static_cast<int32_t>(face.loops().size()); ++i) {
        std::ranges::move(curves_of_loop(face, i), std::back_inserter(curves));
    }
    for (const Joint &joint : face.joints()) {
        append_joint(face, joint, curves);
    }
    for (const EndPart &part : open_ends(face)) {
        curves.push_back(segment(face, part.from, part.to));
        curves.back().at_end = true;
    }
    return curves;
}

std::vector<BoundaryCurve> seam_curves(const Face &face) {
    const Covering &covering = face.covering();
    const Point2 lower{covering.domain(0).lower, covering.domain(1).lower};
    std::vector<BoundaryCurve> curves;
    for (size_t k = 0; k < 2; ++k) {
        if (covering.closed(static_cast<int>(k))) {
            Point2 end = lower;
            end[1 - k] = covering.domain(static_cast<int>(1 - k)).upper;
            curves.push_back(segment(face, lower, end));
        }
    }
    return curves;
}

} // namespace nrb::face
