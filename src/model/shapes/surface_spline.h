// SPDX-License-Identifier: MIT
// Exact splines of parts of surfaces, and approximations of offset surfaces.
#pragma once

#include "model/shapes/curve_map.h"
#include "model/shapes/surface_shape.h"

namespace nrb::model {

// The spline of the surface over a part of its range, exact but for rounding. It has the same domain, but
// between the breaks the parameters of circles, ellipses and hyperbolas differ (curve_map.h). Throws
// Status::unsupported for an offset surface, length for an infinite range, empty_domain, and what the
// builders throw.
SplinePtr surface_spline(const SurfaceShape &surface, const Rectangle &range);

// A range of a trimmed surface in the parameters of its basis, and the spline of a part of the basis with the
// directions of the trimmed surface.
Rectangle range_in_basis(const SurfaceShape &trimmed, const Rectangle &range) noexcept;
SplinePtr directed(const SurfaceShape &trimmed, SplinePtr spline);

struct MadeSurface {
    SplinePtr spline;
    double distance = 0; // a bound at equal parameters; 0: exact but for rounding
};

// The tolerance of approximations of offset surfaces, and the limits of their patches, as in fit::OffsetRule.
struct SurfaceRule {
    double tolerance;
    int64_t most_patches;
    int64_t *left = nullptr;
};

// The same including offset surfaces, which are over the parameters of the spline of the surface that is
// offset. By ISO 10303-42 every surface has its normal along its own S_u x S_v. An offset of an offset is
// therefore one offset of the surface under both, by d1 + d2, or by d1 - d2 where the normal of the first
// offset is opposite to that of the surface. Throws what surface_spline() and fit::offset_surface() throw,
// and Status::unsupported where these directions are not the same everywhere. Defined in made_surface.cpp.
MadeSurface made_surface(const SurfaceShape &surface, const Rectangle &range, const SurfaceRule &rule);

// The law that relates the parameters of the surface along an axis to those of its spline at a parameter of
// the surface (curve_map.h). Only a composite profile has different ones.
ParameterLaw law_at(const SurfaceShape &surface, int axis, double t) noexcept;

} // namespace nrb::model
