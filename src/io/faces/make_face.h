// SPDX-License-Identifier: MIT
// Faces from the surfaces, edges and loops that files state.
#pragma once

#include "base/error.h"
#include "face/face.h"
#include "io/limits.h"
#include "model/shapes/surface_spline.h"

#include <string>
#include <vector>

namespace nrb::io {

// Of faces and edges, where a file states none.
inline constexpr double usual_tolerance = 1e-7;

// The spline of a surface; where it has no ends, as much of it as contains the points, and a little more. Offset surfaces are
// approximated within a quarter of the tolerance that the file states, 0 if it states none.
model::MadeSurface surface_around(Limits &limits, const model::SurfaceShape &surface,
                                  const std::vector<Vector3> &points, double stated);
// What a note says on an offset surface that is so far from the one of the file: also whether that is more than what the file states.
std::string note_on_surface(double distance, double stated);
// How near an approximation of `what` is, and which tolerance it misses, if it does.
std::string note_on_distance(const char *what, double distance, double stated);
void append_points(const Spline &curve, std::vector<Vector3> &points);

// Whether a curve in the domain has the ends of an edge, and its middle too unless the edge is rational: the two have equal
// parameters where neither is a conic.
bool lies_under(const Spline &surface, const Spline &curve, const Spline &edge, double tolerance);

// With the loops as they run, or turned where that makes no sense. Curves that are missing are made as precisely as the surface is
// written, since files state tolerances that are much larger.
face::FacePtr make_face(face::FaceParts parts, double tolerance);

// The same for files that say which loop is the outer one rather than in which direction it runs: loops are turned by which of them
// lie in which, and count as they run only where that makes no sense, and on surfaces that have no boundary of their own.
face::FacePtr make_nested_face(face::FaceParts parts, double tolerance);

// What a face took beyond its surface, whatever its loops share with others. Throws Status::too_large.
void spend(Limits &limits, const face::Face &face);

// How much larger than what a file states tolerances may get.
inline constexpr double most_of_stated = 1e4;

// Calls make(tolerance) with a tolerance, or the least one larger by powers of ten that leaves no gap; returns it. None is larger
// than `most` if the first one is not.
template <class Make>
double least_tolerance(double tolerance, double most, Make &&make) {
    constexpr double rounding = 1.5; // of the powers, which are multiplied one by one
    for (;;) {
        try {
            make(tolerance);
            return tolerance;
        } catch (const Error &error) {
            tolerance *= 10;
            if (error.status() != Status::gap || !(tolerance <= rounding * most)) {
                throw;
            }
        }
    }
}

} // namespace nrb::io
