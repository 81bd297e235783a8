// SPDX-License-Identifier: MIT
// A spline as bytes.
#pragma once

#include "io/binary/envelope.h"
#include "spline/spline.h"

namespace nrb::io {

// The numbers of the header are axes, dim and the form: 0 polynomial, 1 Cartesian points with weights, 2 homogeneous points.
// The body:
//
//     64   16 bytes for each axis: the number of its control points (64 bits), its degree, flags (32 bits each): 1 periodic
//     112  where the points are, where the weights are, 0 if there are none (64 bits each)
//     128  the knots of all axes, one after the other; the points; the weights, each part at a multiple of 64 bytes
//
// The numbers are those of the handle, bit for bit: the same spline has the same bytes, on every machine.
size_t size_in_bytes(const Spline &spline) noexcept;
// Precondition: `out` has that size.
void write_bytes(const Spline &spline, std::span<unsigned char> out) noexcept;

// Throws what ByteReader and make_spline() do, and Status::syntax, axes, dimension, flags for numbers that no spline has.
SplinePtr spline_from(std::span<const unsigned char> bytes);

// Whether the bytes of two splines are the same.
bool same_bytes(const Spline &a, const Spline &b) noexcept;

} // namespace nrb::io
