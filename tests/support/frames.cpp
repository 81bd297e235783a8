#include "support/frames.h"

#include <algorithm>
#include <cmath>

namespace support {

namespace {

SurfaceFrames room_for_frames(size_t n) {
    return {std::vector<double>(3 * n), std::vector<double>(3 * n), std::vector<double>(3 * n),
            std::vector<double>(3 * n), std::vector<int32_t>(n)};
}

SplineData around(double r, double distance, std::vector<double> unit_points, std::vector<double> knots) {
    SplineData data;
    data.degrees = {2};
    data.counts = {static_cast<int64_t>(unit_points.size() / 2)};
    data.knots = {std::move(knots)};
    data.dim = 2;
    for (size_t i = 0; i < unit_points.size(); ++i) {
        data.points.push_back(r * unit_points[i] + (i % 2 == 0 ? distance : 0));
        if (i % 2 == 0) {
            data.weights.push_back(i % 4 == 0 ? 1 : std::sqrt(0.5));
        }
    }
    return data;
}

} // namespace

SurfaceFrames surface_frames(const nurbs *g, const std::vector<double> &params, uint32_t flags) {
    SurfaceFrames f = room_for_frames(params.size() / 2);
    require_ok(nurbs_surface_eval_frames(g, static_cast<int64_t>(params.size() / 2), params.data(), 0, 0,
                                         f.points.data(), 0, 0, f.du.data(), 0, 0, f.dv.data(), 0, 0,
                                         f.normals.data(), 0, 0, f.status.data(), flags));
    return f;
}

SurfaceFrames surface_grid_frames(const nurbs *g, const std::vector<std::vector<double>> &params,
                                  uint32_t flags) {
    const std::array<int64_t, 2> counts{static_cast<int64_t>(params[0].size()),
                                        static_cast<int64_t>(params[1].size())};
    std::vector<double> all = params[0];
    all.insert(all.end(), params[1].begin(), params[1].end());
    SurfaceFrames f = room_for_frames(params[0].size() * params[1].size());
    require_ok(nurbs_surface_eval_grid_frames(g, counts.data(), all.data(), f.points.data(), 0, 0,
                                              f.du.data(), 0, 0, f.dv.data(), 0, 0, f.normals.data(), 0, 0,
                                              f.status.data(), flags));
    return f;
}

Curvatures surface_curvatures(const nurbs *g, const std::vector<double> &params, uint32_t flags) {
    const size_t n = params.size() / 2;
    Curvatures c{std::vector<double>(2 * n), std::vector<double>(6 * n), std::vector<double>(n),
                 std::vector<double>(n), std::vector<int32_t>(n)};
    require_ok(nurbs_surface_eval_curvatures(g, static_cast<int64_t>(n), params.data(), 0, 0,
                                             c.principal.data(), 0, 0, c.directions.data(), 0, 0,
                                             c.mean.data(), 0, c.gaussian.data(), 0, c.status.data(), flags));
    return c;
}

CurveFrames curve_frames(const nurbs *g, const std::vector<double> &params, uint32_t flags) {
    int32_t dim = 0;
    require_ok(nurbs_dimension(g, &dim));
    const size_t n = params.size();
    const size_t width = n * static_cast<size_t>(dim);
    const size_t space = dim == 3 ? n : 0;
    CurveFrames f{std::vector<double>(width),     std::vector<double>(width), std::vector<double>(width),
                  std::vector<double>(3 * space), std::vector<double>(n),     std::vector<double>(space),
                  std::vector<int32_t>(n)};
    require_ok(nurbs_curve_eval_frames(g, static_cast<int64_t>(n), params.data(), 0, f.points.data(), 0, 0,
                                       f.tangents.data(), 0, 0, f.normals.data(), 0, 0,
                                       dim == 3 ? f.binormals.data() : nullptr, 0, 0, f.curvatures.data(), 0,
                                       dim == 3 ? f.torsions.data() : nullptr, 0, f.status.data(), flags));
    return f;
}

CurveFrames minimal_frames(const nurbs *g, const std::vector<double> &params,
                           const std::optional<std::array<double, 3>> &first_normal, uint32_t flags) {
    const size_t n = params.size();
    CurveFrames f{std::vector<double>(3 * n),
                  std::vector<double>(3 * n),
                  std::vector<double>(3 * n),
                  std::vector<double>(3 * n),
                  {},
                  {},
                  std::vector<int32_t>(n)};
    require_ok(nurbs_curve_rotation_minimizing_frames(
        g, static_cast<int64_t>(n), params.data(), 0, first_normal ? first_normal->data() : nullptr,
        f.points.data(), 0, 0, f.tangents.data(), 0, 0, f.normals.data(), 0, 0, f.binormals.data(), 0, 0,
        f.status.data(), flags));
    return f;
}

SplineData revolved(const SplineData &profile) {
    static constexpr int corner[9][2] = {{1, 0},   {1, 1},  {0, 1},  {-1, 1}, {-1, 0},
                                         {-1, -1}, {0, -1}, {1, -1}, {1, 0}};
    SplineData data;
    data.degrees = {2, profile.degrees[0]};
    data.counts = {9, profile.counts[0]};
    data.knots = {{0, 0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1, 1}, profile.knots[0]};
    data.dim = 3;
    for (int i = 0; i < 9; ++i) {
        for (int64_t j = 0; j < profile.counts[0]; ++j) {
            const double r = profile.coordinate(j, 0);
            data.points.insert(data.points.end(),
                               {r * corner[i][0], r * corner[i][1], profile.coordinate(j, 1)});
            data.weights.push_back((i % 2 == 0 ? 1 : std::sqrt(0.5)) * profile.weight(j));
        }
    }
    return data;
}

SplineData half_circle(double r, double distance) {
    return around(r, distance, {0, -1, 1, -1, 1, 0, 1, 1, 0, 1}, {0, 0, 0, 0.5, 0.5, 1, 1, 1});
}

SplineData full_circle(double r, double distance) {
    return around(r, distance, {1, 0, 1, 1, 0, 1, -1, 1, -1, 0, -1, -1, 0, -1, 1, -1, 1, 0},
                  {0, 0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1, 1});
}

SplineData moved(SplineData data, const std::array<double, 3> &by) {
    for (size_t i = 0; i < data.points.size(); ++i) {
        data.points[i] += by[i % 3];
    }
    return data;
}

SplineData transposed(const SplineData &data) {
    SplineData other = data;
    std::swap(other.degrees[0], other.degrees[1]);
    std::swap(other.counts[0], other.counts[1]);
    std::swap(other.knots[0], other.knots[1]);
    other.flags = (data.periodic(0) ? NURBS_ON_AXIS(1, NURBS_PERIODIC) : 0) |
                  (data.periodic(1) ? NURBS_ON_AXIS(0, NURBS_PERIODIC) : 0);
    other.points.clear();
    other.weights.clear();
    for (int64_t j = 0; j < data.counts[1]; ++j) {
        for (int64_t i = 0; i < data.counts[0]; ++i) {
            const int64_t from = i * data.counts[1] + j;
            for (int c = 0; c < data.dim; ++c) {
                other.points.push_back(data.coordinate(from, c));
            }
            if (data.rational()) {
                other.weights.push_back(data.weight(from));
            }
        }
    }
    return other;
}

Vector vector_at(const std::vector<double> &values, size_t record, size_t width, size_t first) {
    const size_t at = record * width + first;
    return {values[at], values[at + 1], values[at + 2]};
}

long double dot(const Vector &a, const Vector &b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector cross(const Vector &a, const Vector &b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector minus(const Vector &a, const Vector &b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Vector times(long double s, const Vector &a) {
    return {s * a[0], s * a[1], s * a[2]};
}

long double norm(const Vector &a) {
    return std::hypot(a[0], std::hypot(a[1], a[2]));
}

Vector unit(const Vector &a) {
    return times(1 / norm(a), a);
}

} // namespace support
