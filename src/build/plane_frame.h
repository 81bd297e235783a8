// SPDX-License-Identifier: MIT
// The plane of three points in any dimension, with coordinates in it.
#pragma once

#include "numeric/double_double.h"

#include <cmath>
#include <span>
#include <vector>

namespace nrb::build {

// A point or vector of a plane, in twice the precision.
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

// Coordinates are offsets from the first point, times a power of two that brings the largest offset of the
// three points to about 1. In dimension 2 they are along the coordinate axes and exact; otherwise they are
// along the chord to the second point, and across it towards the third.
class PlaneFrame {
public:
    using Coordinates = std::span<const double>;

    // Throws Status::collinear if the height of `third` over the line through the other two is at most 8
    // eps of the largest coordinate, or if two of the points are as close as that; `what` names the points.
    PlaneFrame(Coordinates first, Coordinates second, Coordinates third, const char *what);

    [[nodiscard]] Point2 point(Coordinates x) const;
    // The coordinates of a direction, brought to about 1 by a power of two.
    [[nodiscard]] Point2 direction(Coordinates v) const;
    // The largest possible rounding of the given coordinates, in these coordinates.
    [[nodiscard]] double rounding() const noexcept { return rounding_; }
    // Throws Status::conic if a point, or a direction, is out of the plane by more than rounding explains.
    void check_point(Coordinates x, const char *name) const;
    void check_direction(Coordinates v, const char *name) const;

    // The vector in space for a vector of the plane.
    [[nodiscard]] std::vector<double> vector(const Point2 &v) const;

private:
    [[nodiscard]] std::vector<double> offset(Coordinates x) const;
    [[nodiscard]] double distance(std::span<const double> v) const;

    std::vector<double> origin_;
    std::vector<double> u_;
    std::vector<double> v_;
    double scale_; // a power of two
    double rounding_;
    double tilt_; // uncertainty of the plane's direction
};

} // namespace nrb::build
