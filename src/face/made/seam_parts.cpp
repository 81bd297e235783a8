// SPDX-License-Identifier: MIT
#include "face/made/seam_parts.h"

#include "eval/curve_point.h"
#include "face/trims/monotone.h"
#include "refine/forms/transform.h"
#include "refine/parts/cut.h"

#include <algorithm>
#include <cmath>

namespace nrb::face {

namespace {

constexpr double rounding = 0x1p-40; // of the domain: how far outside the rounding of cuts may set parts

// The ends of the domain of a curve and, in between, the parameters at which it crosses seams.
std::vector<double> passages_of(const Covering &covering, const SplinePtr &curve) {
    const Interval domain = curve->axis(0).domain();
    const double room = rounding * (domain.upper - domain.lower);
    std::vector<double> places, breaks{domain.lower};
    TrimPieces pieces;
    append_monotone({{curve}}, 0, {0, 0}, pieces);
    for (const TrimPiece &piece : pieces.all()) {
        const bool closes = piece.range.lower == piece.range.upper; // a segment, not a part of the curve
        for (int k = 0; k < 2 && !closes; ++k) {
            if (!covering.closed(k)) {
                continue;
            }
            const auto at = static_cast<size_t>(k);
            for_each_copy(
                covering.domain(k).lower, covering.period(k), {piece.lower[at], piece.upper[at]},
                [&](double seam) { places.push_back(parameter_at(piece, pieces.place_of(piece, k, seam))); });
        }
    }
    std::ranges::sort(places);
    for (const double t : places) {
        if (t - breaks.back() > room && domain.upper - t > room) {
            breaks.push_back(t);
        }
    }
    breaks.push_back(domain.upper);
    return breaks;
}

// A part moved by whole periods so that its middle is in the domain.
SplinePtr moved_back(const Covering &covering, const SplinePtr &part) {
    const Interval domain = part->axis(0).domain();
    const std::vector<double> middle = eval::curve_point(*part, domain.lower / 2 + domain.upper / 2, false);
    const Point2 x{middle[0], middle[1]}, inside = covering.canonical(x);
    const double matrix[] = {1, 0, 0, 1}, move[] = {inside[0] - x[0], inside[1] - x[1]};
    return inside == x ? part : refine::transform(*part, {2, 2, matrix}, move);
}

} // namespace

SplinePtr set_inside(const Covering &covering, const SplinePtr &curve, bool closed_too, Point2 &off) {
    const auto width = static_cast<size_t>(curve->stored_width());
    std::vector<double> points(curve->points().begin(), curve->points().end());
    bool changed = false;
    for (int64_t i = 0; i < curve->point_count(); ++i) {
        const double weight = curve->form() == Form::homogeneous ? curve->weight(i) : 1;
        for (const int k : {0, 1}) {
            const auto axis = static_cast<size_t>(k);
            const auto [lower, upper] = covering.domain(k);
            const double x = curve->coordinate(i, k),
                         inside = closed_too || !covering.closed(k) ? std::clamp(x, lower, upper) : x;
            if (x != inside) {
                off[axis] = std::max(off[axis], std::abs(x - inside));
                points[static_cast<size_t>(i) * width + axis] = inside * weight;
                changed = true;
            }
        }
    }
    return changed ? make_result(curve->knot_vectors(), curve->dim(), curve->form(), std::move(points),
                                 std::vector<double>(curve->weights().begin(), curve->weights().end()))
                   : curve;
}

SeamParts seam_parts(const Covering &covering, const SplinePtr &curve) {
    const refine::PartedSpline parts = refine::split_axis(curve, 0, passages_of(covering, curve));
    SeamParts result;
    for (int64_t i = 0; i < parts.size(); ++i) {
        result.parts.push_back(set_inside(covering, moved_back(covering, parts.part(i)), true, result.off));
        if (result.off[0] > rounding * covering.reach(0) || result.off[1] > rounding * covering.reach(1)) {
            return {};
        }
    }
    return result;
}

} // namespace nrb::face
