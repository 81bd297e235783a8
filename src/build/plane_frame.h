// The plane of three points in any dimension, with coordinates in it.
#pragma once

#include <span>
#include <vector>

namespace nrb {

struct Point2 {
    double x;
    double y;
};

inline double cross(Point2 a, Point2 b) noexcept {
    return a.x * b.y - a.y * b.x;
}
inline Point2 operator-(Point2 a, Point2 b) noexcept {
    return {a.x - b.x, a.y - b.y};
}

// Coordinates are offsets from the first point, times a power of two that brings the largest of the three points'
// to about 1; in dimension 2 they are along the coordinate axes, otherwise along the chord to the second point and
// across it towards the third.
class PlaneFrame {
public:
    using Coordinates = std::span<const double>;

    // Throws NURBS_ERROR_COLLINEAR if the height of `third` over the line through the other two is at most 8 eps of the
    // largest coordinate, or if two of the points are as close as that; `what` names the points.
    PlaneFrame(Coordinates first, Coordinates second, Coordinates third, const char *what);

    [[nodiscard]] Point2 point(Coordinates x) const;
    // Of a direction, brought to about 1 by a power of two.
    [[nodiscard]] Point2 direction(Coordinates v) const;
    // What rounding of the given coordinates can be in these ones.
    [[nodiscard]] double rounding() const noexcept { return rounding_; }
    // Throws NURBS_ERROR_CONIC if a point, or a direction, is out of the plane by more than rounding explains.
    void check_point(Coordinates x, const char *name) const;
    void check_direction(Coordinates v, const char *name) const;

    // The vector of the space for one of the plane.
    [[nodiscard]] std::vector<double> vector(Point2 v) const;

private:
    [[nodiscard]] std::vector<double> offset(Coordinates x) const;
    [[nodiscard]] Point2 along(std::span<const double> v) const;
    [[nodiscard]] double distance(std::span<const double> v) const;

    std::vector<double> origin_;
    std::vector<double> u_;
    std::vector<double> v_;
    double scale_; // a power of two
    double rounding_;
    double tilt_; // uncertainty of the plane's direction
};

} // namespace nrb
