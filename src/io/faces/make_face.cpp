// SPDX-License-Identifier: MIT
#include "io/faces/make_face.h"

#include "bounds/box.h"
#include "eval/evaluate.h"
#include "model/shapes/surface_spline.h"
#include "numeric/norm.h"
#include "spline/part.h"

#include <algorithm>

namespace nrb::io {
namespace {

// The precision of curves that are made, as a share of the size of the surface.
constexpr double share_of_precision = 0x1p-22;
// The least tolerance and precision, as a share of the size of the surface. Files may state less, but cannot
// keep it, since they give coordinates with fewer digits.
constexpr double share_of_rounding = 0x1p-36;
// The doubles that a piece of a loop takes in the maps of its face.
constexpr int64_t size_of_a_piece = 64;

std::vector<double> point_of(const Spline &spline, const double *params) {
    std::vector<double> point(static_cast<size_t>(spline.dim()));
    eval::evaluate_points(spline, {}, 0, {params, 1, spline.axes(), spline.axes(), 1},
                          {point.data(), 1, spline.dim(), spline.dim(), 1});
    return point;
}

void set_tolerance(face::FaceParts &parts, double tolerance) {
    const double size = bounds::extent(*parts.surface);
    parts.tolerance = std::max(tolerance, share_of_rounding * size);
    parts.precision = std::max(std::min(tolerance / 2, share_of_precision * size), share_of_rounding * size);
    parts.prove = false;
}

face::FacePtr face_as(face::FaceParts parts, bool as_oriented) {
    parts.as_oriented = as_oriented;
    return std::make_shared<const face::Face>(std::move(parts), nullptr);
}

// Null if the loops have no common inside.
face::FacePtr face_if_oriented(const face::FaceParts &parts, bool as_oriented) {
    try {
        return face_as(parts, as_oriented);
    } catch (const Error &error) {
        if (error.status() != Status::orientation) {
            throw;
        }
        return nullptr;
    }
}

bool is_offset(const model::SurfaceShape &surface) noexcept {
    return surface.kind == model::SurfaceKind::offset ||
           (surface.kind == model::SurfaceKind::trimmed && is_offset(*surface.basis));
}

} // namespace

model::MadeSurface surface_around(Limits &limits, const model::SurfaceShape &surface,
                                  const std::vector<Vector3> &points, double stated) {
    constexpr double margin = 1.0 / 64; // of the extent of the points
    constexpr double share = 0.25;      // of the tolerance; the rest is left to other errors
    const model::Rectangle range = model::bounded(surface) ? model::natural_range(surface)
                                                           : model::range_around(surface, points, margin);
    return model::made_surface(surface, range,
                               {share * (stated > 0 ? stated : usual_tolerance),
                                is_offset(surface) ? limits.patches_of_next() : 0, &limits.patches()});
}

std::string note_on_distance(const char *what, double distance, double stated) {
    const double wanted = stated > 0 ? stated : usual_tolerance;
    std::string text = std::string("its ") + what + " is approximated within " + Number(distance).text;
    if (distance > wanted) {
        text += std::string(", which is more than the ") +
                (stated > 0 ? "tolerance of the file, " : "usual tolerance, ") + Number(wanted).text;
    }
    return text;
}

std::string note_on_surface(double distance, double stated) {
    return note_on_distance("offset surface", distance, stated);
}

void append_points(const Spline &curve, std::vector<Vector3> &points) {
    for (int64_t i = 0; i < curve.point_count(); ++i) {
        points.push_back({curve.coordinate(i, 0), curve.coordinate(i, 1), curve.coordinate(i, 2)});
    }
}

bool lies_under(const Spline &surface, const Spline &curve, const Spline &edge, double tolerance) {
    const Interval from = curve.axis(0).domain(), to = edge.axis(0).domain();
    for (const double share : {0.0, 0.5, 1.0}) {
        const double t = parameter_in(from, share), s = parameter_in(to, share);
        std::vector<double> place = point_of(curve, &t);
        for (size_t k = 0; k < 2; ++k) {
            const Interval range = surface.axis(static_cast<int>(k)).domain();
            place[k] = std::clamp(place[k], range.lower, range.upper);
        }
        const std::vector<double> point = point_of(surface, place.data()), wanted = point_of(edge, &s);
        if ((share != 0.5 || !edge.rational()) && !(distance(point.data(), wanted.data(), 3) <= tolerance)) {
            return false;
        }
    }
    return true;
}

face::FacePtr make_face(face::FaceParts parts, double tolerance) {
    set_tolerance(parts, tolerance);
    face::make_curves(parts);
    face::FacePtr face = face_if_oriented(parts, true);
    return face != nullptr ? face : face_as(std::move(parts), false);
}

face::FacePtr make_nested_face(face::FaceParts parts, double tolerance) {
    set_tolerance(parts, tolerance);
    face::make_curves(parts);
    face::FacePtr face = face_if_oriented(parts, false);
    if (face == nullptr) {
        return face_as(std::move(parts), true);
    }
    if (face::natural_loops(face->covering()).empty()) {
        if (face::FacePtr as_it_runs = face_if_oriented(parts, true)) {
            return as_it_runs;
        }
    }
    return face;
}

void spend(Limits &limits, const face::Face &face) {
    for (const face::Loop &loop : face.loops()) {
        for (const face::Coedge &coedge : loop) {
            limits.spend(Limits::size_of_a_shape + 3 * coedge.curve->point_count());
        }
    }
    for (const face::TrimPiece &piece : face.trims().pieces().all()) {
        limits.spend(size_of_a_piece + 3 * piece.degree);
    }
}

} // namespace nrb::io
