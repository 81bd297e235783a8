// Frames and curvatures through the C API, all outputs packed; and surfaces and curves whose frames are
// known.
#pragma once

#include "support/handle.h"

#include <array>
#include <optional>

namespace support {

struct SurfaceFrames {
    std::vector<double> points;
    std::vector<double> du;
    std::vector<double> dv;
    std::vector<double> normals;
    std::vector<int32_t> status;
};
SurfaceFrames surface_frames(const nurbs *g, const std::vector<double> &params, uint32_t flags = 0);
SurfaceFrames surface_grid_frames(const nurbs *g, const std::vector<std::vector<double>> &params,
                                  uint32_t flags = 0);

struct Curvatures {
    std::vector<double> principal;
    std::vector<double> directions;
    std::vector<double> mean;
    std::vector<double> gaussian;
    std::vector<int32_t> status;
};
Curvatures surface_curvatures(const nurbs *g, const std::vector<double> &params, uint32_t flags = 0);

struct CurveFrames {
    std::vector<double> points;
    std::vector<double> tangents;
    std::vector<double> normals;
    std::vector<double> binormals; // empty in the plane, as are the torsions
    std::vector<double> curvatures;
    std::vector<double> torsions;
    std::vector<int32_t> status;
};
CurveFrames curve_frames(const nurbs *g, const std::vector<double> &params, uint32_t flags = 0);
CurveFrames minimal_frames(const nurbs *g, const std::vector<double> &params,
                           const std::optional<std::array<double, 3>> &first_normal = std::nullopt,
                           uint32_t flags = 0);

// The surface that a curve in the half plane (r, z) sweeps around the z axis: axis 0 is the angle, a full
// circle of nine points over [0, 1] from the x axis towards the y axis; axis 1 is the curve's.
SplineData revolved(const SplineData &profile);
// Half circle of radius r around (distance, 0), from below to above; with distance 0 it revolves to a sphere.
SplineData half_circle(double r, double distance);
// Full circle of radius r around (distance, 0).
SplineData full_circle(double r, double distance);
SplineData moved(SplineData data, const std::array<double, 3> &by);
// The axes of a surface exchanged.
SplineData transposed(const SplineData &data);

using Vector = std::array<long double, 3>;
Vector vector_at(const std::vector<double> &values, size_t record, size_t width = 3, size_t first = 0);
long double dot(const Vector &a, const Vector &b);
Vector cross(const Vector &a, const Vector &b);
Vector minus(const Vector &a, const Vector &b);
Vector times(long double s, const Vector &a);
long double norm(const Vector &a);
Vector unit(const Vector &a);

} // namespace support
