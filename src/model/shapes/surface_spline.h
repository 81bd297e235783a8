// SPDX-License-Identifier: MIT
// The exact splines of parts of surfaces.
#pragma once

#include "model/shapes/curve_map.h"
#include "model/shapes/surface_shape.h"

namespace nrb::model {

// The surface over a part of its range, exact but for rounding, over the same parameters; in between, those of
// circles, ellipses and hyperbolas are others. Throws Status::unsupported for an offset surface; length for infinite
// ranges; empty_domain, and what the builders throw.
SplinePtr surface_spline(const SurfaceShape &surface, const Rectangle &range);

// A range of a trimmed surface in the parameters of its basis, and a part of that with the directions of the trimmed one.
Rectangle range_in_basis(const SurfaceShape &trimmed, const Rectangle &range) noexcept;
SplinePtr directed(const SurfaceShape &trimmed, SplinePtr spline);

struct MadeSurface {
    SplinePtr spline;
    double distance = 0; // from the surface at equal parameters, at most; 0: but for rounding
};

// How near offset surfaces are to be approximated, with how many patches (fit/offset/offset_surface.h).
struct SurfaceRule {
    double tolerance;
    int64_t most_patches;
    int64_t *left = nullptr;
};

// The same of offset surfaces, too; these over the parameters of the spline of the surface from which they are offset. An offset of an
// offset is one of the surface under both: by d1 + d2, or by d1 - d2 where the normal of the first one is turned around (ISO 10303-42
// has the normals of all surfaces along their own S_u x S_v). Throws what surface_spline() and fit::offset_surface() do, and
// Status::unsupported where that is not the same everywhere. Defined in made_surface.cpp.
MadeSurface made_surface(const SurfaceShape &surface, const Rectangle &range, const SurfaceRule &rule);

// How the parameters of the surface along an axis and those of its spline belong together (curve_map.h).
ParameterLaw law_of(const SurfaceShape &surface, int axis) noexcept;

} // namespace nrb::model
