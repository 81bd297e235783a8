// SPDX-License-Identifier: MIT
// The binary form of a spline.
#pragma once

#include "io/binary/envelope.h"
#include "spline/spline.h"

namespace nrb::io {

// The numbers of the header are axes, dim and the form: 0 polynomial, 1 Cartesian points with weights, 2
// homogeneous points. The body:
//
//     64   16 bytes for each of three axes: the number of control points (64 bits), degree, flags (32 bits
//          each): 1 periodic
//     112  where the points are, where the weights are, 0 if there are none (64 bits each)
//     128  the knots of all axes, one axis after the other; the points; the weights; each part at a multiple
//          of 64 bytes
//
// The numbers are those of the handle, bit for bit: a spline has the same bytes on every machine.
size_t size_in_bytes(const Spline &spline) noexcept;
// Precondition: `out` has size_in_bytes() bytes.
void write_bytes(const Spline &spline, std::span<unsigned char> out) noexcept;

// Throws what ByteReader and make_spline() throw, and Status::syntax, axes, dimension or flags for numbers
// that no spline has.
SplinePtr spline_from(std::span<const unsigned char> bytes);

// Whether two splines have the same bytes.
bool same_bytes(const Spline &a, const Spline &b) noexcept;

} // namespace nrb::io
