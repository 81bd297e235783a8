// SPDX-License-Identifier: MIT
// Which fields shapes of each kind have, and how many numbers of 64 bits they take in a body.
#pragma once

#include "model/shapes/surface_shape.h"

namespace nrb::io {

using model::CurveKind;
using model::SurfaceKind;

inline constexpr size_t words_of_place = 27, words_of_piece = 4, words_of_curve = 6 + words_of_place,
                        words_of_surface = 15 + words_of_place;
inline constexpr uint64_t forward_u = 1, forward_v = 2;

constexpr bool has_place(CurveKind kind) noexcept {
    return kind <= CurveKind::hyperbola;
}
constexpr bool has_spline(CurveKind kind) noexcept {
    return kind == CurveKind::spline || kind == CurveKind::composite;
}
constexpr int sizes_of(CurveKind kind) noexcept {
    return !has_place(kind) ? 0 : kind == CurveKind::ellipse || kind == CurveKind::hyperbola ? 2 : 1;
}

constexpr bool has_place(SurfaceKind kind) noexcept {
    return kind <= SurfaceKind::revolution;
}
constexpr bool has_curve(SurfaceKind kind) noexcept {
    return kind == SurfaceKind::revolution || kind == SurfaceKind::extrusion;
}
constexpr bool has_basis(SurfaceKind kind) noexcept {
    return kind == SurfaceKind::offset || kind == SurfaceKind::trimmed;
}
constexpr int sizes_of(SurfaceKind kind) noexcept {
    const bool two = kind == SurfaceKind::cone || kind == SurfaceKind::torus;
    return two ? 2 : kind == SurfaceKind::cylinder || kind == SurfaceKind::sphere ? 1 : 0;
}

} // namespace nrb::io
