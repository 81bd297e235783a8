// SPDX-License-Identifier: MIT
// Frames: a centre and a power of two as unit of length, which bring splines near 1 in size.
#pragma once

#include "numeric/power_of_two.h"
#include "spline/spline.h"

#include <cmath>
#include <span>
#include <vector>

namespace nrb::pieces {

// The frame coordinates of a point x are (x - centre) 2^-exponent; a distance d becomes d 2^-exponent.
struct Frame {
    std::vector<double> centre;
    int exponent = 0;

    [[nodiscard]] double scaled(double length) const noexcept {
        return times_power_of_two(length, -exponent);
    }
    [[nodiscard]] double unscaled(double length) const noexcept {
        return times_power_of_two(length, exponent);
    }
    // x - y in the frame, also where it overflows in the caller's unit.
    [[nodiscard]] double difference(double x, double y) const noexcept {
        const double whole = x - y;
        return std::isfinite(whole) ? scaled(whole) : 2 * scaled(x / 2 - y / 2);
    }
    // Coordinate c of a point in the frame.
    [[nodiscard]] double coordinate(size_t c, double x) const noexcept { return difference(x, centre[c]); }
    [[nodiscard]] double original(size_t c, double x) const noexcept { return centre[c] + unscaled(x); }
};

// The frame about the middle of the bounding box of all control points that have influence and are not at
// infinity; they are within 1 of it along every axis. Precondition: one or more splines of one dimension.
Frame frame_of(std::span<const Spline *const> splines);
inline Frame frame_of(const Spline &spline) {
    const Spline *one = &spline;
    return frame_of({&one, 1});
}

} // namespace nrb::pieces
