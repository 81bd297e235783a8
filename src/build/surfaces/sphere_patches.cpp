// SPDX-License-Identifier: MIT
#include "build/surfaces/sphere_patches.h"

#include "base/representable.h"
#include "refine/knots/bezier_rows.h"
#include "refine/parts/cut.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace nrb::build {

namespace {

struct NetPoint {
    double x;
    double y;
    double z;
    double weight;
};

// Control points (i, j), i <= j <= 2, of the face +Z, without the signs of x and y; r = sqrt(3).
constexpr NetPoint corner = {0.57735026918962576451, 0.57735026918962576451, 0.57735026918962576451,
                             1.2679491924311227065};          // 1 / r, 3 - r
constexpr NetPoint edge = {0.70958730763864230153,            // (4 - r) / (3 r - 2)
                           0.31287619229159269046,            // 1 / (3 r - 2)
                           0.70958730763864230153,            // as x
                           1.1300105259008360492};            // sqrt(2) (3 r - 2) / 4
constexpr NetPoint edge_middle = {0.75402078491454071099, 0,  // (2 r - 1) / (5 - r)
                                  0.75402078491454071099,     // as x
                                  1.0893163974770409022};     // (5 - r) / 3
constexpr NetPoint inner = {0.41336412579931957183,           // (3 r - 2) / (r + 6)
                            0.41336412579931957183, 1,        //
                            0.96650635094610966169};          // (r + 6) / 8
constexpr NetPoint inner_middle = {0.45730408049064640676, 0, // (7 - 2 r) / (r + 6)
                                   1.1200461886989793578,     // 5 r / (r + 6)
                                   0.91123092641847903258};   // sqrt(2) (r + 6) / 12
constexpr NetPoint middle = {0, 0, 1.2798332181751238532,     // 3 (5 - r) / (5 r - 1)
                             0.85113933753826516307};         // (5 r - 1) / 9

constexpr std::array<std::array<NetPoint, 3>, 3> quarter = {
    {{corner, edge, edge_middle}, {edge, inner, inner_middle}, {edge_middle, inner_middle, middle}}};

NetPoint net_point(int i, int j) noexcept {
    const int low_i = std::min(i, 4 - i), low_j = std::min(j, 4 - j);
    NetPoint point = quarter[static_cast<size_t>(low_i)][static_cast<size_t>(low_j)];
    if (low_i > low_j) {
        std::swap(point.x, point.y);
    }
    point.x = i < 2 ? -point.x : point.x;
    point.y = j < 2 ? -point.y : point.y;
    return point;
}

KnotVectorPtr quartic() {
    return refine::bezier_knots(4, std::array<double, 2>{0, 1});
}

// The face +Z of the unit sphere.
SplinePtr unit_face() {
    std::vector<double> points, weights;
    for (int i = 0; i < 5; ++i) {
        for (int j = 0; j < 5; ++j) {
            const NetPoint point = net_point(i, j);
            points.insert(points.end(), {point.x, point.y, point.z});
            weights.push_back(point.weight);
        }
    }
    return make_result({quartic(), quartic()}, 3, Form::rational, std::move(points), std::move(weights));
}

// The part y >= 0 of the face; y is exactly 0 on the edge by the symmetry of the face.
SplinePtr upper_half(const SplinePtr &face) {
    const SplinePtr half = refine::cut_axis(face, 1, 0.5, 1, {true, true});
    std::vector<double> points(half->points().begin(), half->points().end());
    for (size_t i = 1; i < points.size(); i += 15) {
        points[i] = 0;
    }
    return make_result({quartic(), quartic()}, 3, Form::rational, std::move(points),
                       {half->weights().begin(), half->weights().end()});
}

// For each face, which coordinates of the face +Z are its x, y and z, counted from 1 and with sign.
using Orientation = std::array<int, 3>;
constexpr std::array<Orientation, 6> faces = {
    {{3, 1, 2}, {-1, 3, 2}, {-3, -1, 2}, {1, -3, 2}, {1, 2, 3}, {1, -2, -3}}};

DoubleDouble coordinate(const double *point, int which, double radius) noexcept {
    return DoubleDouble::product(which < 0 ? -radius : radius, point[std::abs(which) - 1]);
}

SplinePtr placed(const Spline &face, const Orientation &turn, const Placement &place, double radius) {
    std::vector<double> points(face.points().size());
    for (size_t i = 0; i < points.size(); i += 3) {
        const double *point = face.points().data() + i;
        place.point(coordinate(point, turn[0], radius), coordinate(point, turn[1], radius),
                    coordinate(point, turn[2], radius), points.data() + i);
    }
    require_representable(points, "control points");
    return make_result(face.knot_vectors(), 3, Form::rational, std::move(points),
                       {face.weights().begin(), face.weights().end()});
}

} // namespace

std::vector<SplinePtr> sphere_patches(const Placement &place, double radius, bool half) {
    check_positive_length(radius, "radius");
    const SplinePtr face = unit_face(), side = half ? upper_half(face) : face;
    std::vector<SplinePtr> patches;
    for (size_t k = 0; k < (half ? 5 : 6); ++k) {
        patches.push_back(placed(k < 4 ? *side : *face, faces[k], place, radius));
    }
    return patches;
}

} // namespace nrb::build
