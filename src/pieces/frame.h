// SPDX-License-Identifier: MIT
// What splines are seen from: a centre, and a power of two as unit, that bring them near 1 in size.
#pragma once

#include "numeric/power_of_two.h"
#include "spline/spline.h"

#include <cmath>
#include <span>
#include <vector>

namespace nrb::pieces {

// A point x is (x - centre) 2^-exponent in the frame, and a distance d is d 2^-exponent.
struct Frame {
    std::vector<double> centre;
    int exponent = 0;

    [[nodiscard]] double scaled(double length) const noexcept {
        return times_power_of_two(length, -exponent);
    }
    [[nodiscard]] double unscaled(double length) const noexcept {
        return times_power_of_two(length, exponent);
    }
    // x - y, also where it overflows in the unit of the caller.
    [[nodiscard]] double difference(double x, double y) const noexcept {
        const double whole = x - y;
        return std::isfinite(whole) ? scaled(whole) : 2 * scaled(x / 2 - y / 2);
    }
    // Coordinate c of a point.
    [[nodiscard]] double coordinate(size_t c, double x) const noexcept { return difference(x, centre[c]); }
    [[nodiscard]] double original(size_t c, double x) const noexcept { return centre[c] + unscaled(x); }
};

// About the middle of the box of all control points that have influence and are not at infinity, which are
// within 1 of it along every axis. Precondition: one or more splines of one dimension.
Frame frame_of(std::span<const Spline *const> splines);
inline Frame frame_of(const Spline &spline) {
    const Spline *one = &spline;
    return frame_of({&one, 1});
}

} // namespace nrb::pieces
