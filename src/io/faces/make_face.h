// SPDX-License-Identifier: MIT
// Makes faces from the surfaces, edges and loops that files state.
#pragma once

#include "base/error.h"
#include "face/face.h"
#include "io/limits.h"
#include "model/shapes/surface_spline.h"

#include <string>
#include <vector>

namespace nrb::io {

// The tolerance of faces and edges where a file states none.
inline constexpr double usual_tolerance = 1e-7;

// The spline of a surface. Where the surface is unbounded, that of as much of it as contains the points, with
// a small margin. An offset surface is approximated within a quarter of the tolerance that the file states.
// `stated`: that tolerance; 0: none, and then usual_tolerance counts.
model::MadeSurface surface_around(Limits &limits, const model::SurfaceShape &surface,
                                  const std::vector<Vector3> &points, double stated);
// The text of a note on an offset surface that is approximated within a distance. It also says if that is
// more than the file states.
std::string note_on_surface(double distance, double stated);
// The same for an approximation of `what`: how near it is, and which tolerance it misses, if any.
std::string note_on_distance(const char *what, double distance, double stated);
// Appends the control points of a curve in space.
void append_points(const Spline &curve, std::vector<Vector3> &points);

// Whether a curve in the domain of a surface lies under an edge: the surface maps its ends to those of the
// edge, within the tolerance, and also its middle to that of the edge. The middle is not compared if the edge
// is rational, since curve and edge have equal parameters only if neither is a conic.
bool lies_under(const Spline &surface, const Spline &curve, const Spline &edge, double tolerance);

// Makes a face with its loops in the directions in which they run or, if they then have no common inside,
// with loops that are turned. Missing curves are made as precisely as the surface is written, since files
// state tolerances that are much larger.
face::FacePtr make_face(face::FaceParts parts, double tolerance);

// The same for files that say which loop is the outer one instead of in which direction loops run. Loops are
// turned according to which of them lie in which. The directions in which they run count only if that gives
// no face, or if they give one on a surface that has no boundary of its own.
face::FacePtr make_nested_face(face::FaceParts parts, double tolerance);

// Counts what a face takes besides its surface, whatever its loops share with others. Throws
// Status::too_large.
void spend(Limits &limits, const face::Face &face);

// The largest ratio of a tolerance that is used to the one that a file states.
inline constexpr double most_of_stated = 1e4;

// Calls make() with a tolerance and, while it throws Status::gap, with the next larger one by a power of ten.
// Returns the first tolerance that leaves no gap. Rethrows a gap if the next tolerance would be above `most`,
// and any other error.
template <class Make>
double least_tolerance(double tolerance, double most, Make &&make) {
    constexpr double rounding = 1.5; // for the rounding of the powers, which are multiplied one by one
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
