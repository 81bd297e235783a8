// SPDX-License-Identifier: MIT
// The plane of three points in a space of any dimension, with coordinates in the plane.
#pragma once

#include "numeric/double_double.h"

#include <cmath>
#include <span>
#include <vector>

namespace nrb::build {

// A point or vector of a plane, in double-double precision.
struct Point2 {
    DoubleDouble x;
    DoubleDouble y;
};

inline DoubleDouble cross(const Point2 &a, const Point2 &b) noexcept {
    return a.x * b.y - a.y * b.x;
}
inline DoubleDouble dot(const Point2 &a, const Point2 &b) noexcept {
    return a.x * b.x + a.y * b.y;
}
inline Point2 operator-(const Point2 &a, const Point2 &b) noexcept {
    return {a.x - b.x, a.y - b.y};
}
inline Point2 operator*(const DoubleDouble &s, const Point2 &a) noexcept {
    return {s * a.x, s * a.y};
}
inline double length(const Point2 &a) noexcept {
    return std::hypot(a.x.value(), a.y.value());
}

// Plane coordinates: offsets from the first point, times a power of two that brings the largest offset of the
// other two points near 1. In dimension 2 the axes are the coordinate axes, and the coordinates are exact.
// Otherwise the first axis is along the chord to the second point, the other one perpendicular to it, towards
// the third.
class PlaneFrame {
public:
    using Coordinates = std::span<const double>;

    // Throws Status::collinear if the height of `third` over the line through the other two is at most 8 eps
    // times the largest coordinate, or if two of the points are that close to each other; `what` names the
    // points.
    PlaneFrame(Coordinates first, Coordinates second, Coordinates third, const char *what);

    [[nodiscard]] Point2 point(Coordinates x) const;
    // The plane coordinates of a direction, scaled near 1 by a power of two.
    [[nodiscard]] Point2 direction(Coordinates v) const;
    // The largest possible rounding error of the given coordinates, in plane coordinates.
    [[nodiscard]] double rounding() const noexcept { return rounding_; }
    // Throw Status::conic if a point, or a direction, leaves the plane by more than rounding explains.
    void check_point(Coordinates x, const char *name) const;
    void check_direction(Coordinates v, const char *name) const;

    // A vector of the plane as a vector of space.
    [[nodiscard]] std::vector<double> vector(const Point2 &v) const;

private:
    [[nodiscard]] std::vector<double> offset(Coordinates x) const;
    [[nodiscard]] double distance(std::span<const double> v) const;

    std::vector<double> origin_;
    std::vector<double> u_;
    std::vector<double> v_;
    double scale_; // a power of two
    double rounding_;
    double tilt_; // by which angle rounding may tilt the plane
};

} // namespace nrb::build
