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
            const double low = covering.domain(k).lower, period = covering.period(k);
            auto copy = static_cast<int64_t>(std::ceil((piece.lower[at] - low) / period));
            const auto seam = [&] { return low + static_cast<double>(copy) * period; };
            for (; seam() <= piece.upper[at] && piece.lower[at] < piece.upper[at]; ++copy) {
                places.push_back(parameter_at(piece, pieces.place_of(piece, k, seam())));
            }
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

// Sets control points that are outside the domain by rounding to its ends, and notes how far they were off;
// null if one is farther outside.
SplinePtr set_inside(const Covering &covering, const SplinePtr &part, Point2 &off) {
    const auto width = static_cast<size_t>(part->stored_width());
    std::vector<double> points(part->points().begin(), part->points().end());
    bool changed = false;
    for (int64_t i = 0; i < part->point_count(); ++i) {
        for (const int k : {0, 1}) {
            const auto [lower, upper] = covering.domain(k);
            const double x = part->coordinate(i, k), inside = std::clamp(x, lower, upper);
            if (std::abs(x - inside) > rounding * covering.reach(k)) {
                return nullptr;
            }
            if (x != inside) {
                double &most = off[static_cast<size_t>(k)];
                most = std::max(most, std::abs(x - inside));
                const double weight = part->form() == Form::homogeneous ? part->weight(i) : 1;
                points[static_cast<size_t>(i) * width + static_cast<size_t>(k)] = inside * weight;
                changed = true;
            }
        }
    }
    return changed ? make_result(part->knot_vectors(), part->dim(), part->form(), std::move(points),
                                 std::vector<double>(part->weights().begin(), part->weights().end()))
                   : part;
}

} // namespace

SeamParts seam_parts(const Covering &covering, const SplinePtr &curve) {
    const refine::PartedSpline parts = refine::split_axis(curve, 0, passages_of(covering, curve));
    SeamParts result;
    for (int64_t i = 0; i < parts.size(); ++i) {
        const SplinePtr part = set_inside(covering, moved_back(covering, parts.part(i)), result.off);
        if (part == nullptr) {
            return {};
        }
        result.parts.push_back(part);
    }
    return result;
}

} // namespace nrb::face
