// Faces of solids that share edges, made through the interface.
#pragma once

#include "property/models.h"
#include "support/generators.h"

#include <cmath>
#include <numbers>

namespace support::solids {

using namespace support::models;

inline Handle segment(std::array<double, 2> from, std::array<double, 2> to) {
    return create({{1}, {2}, {{0, 0, 1, 1}}, 2, {from[0], from[1], to[0], to[1]}, {}});
}

// Around the domain: along u at the lower end of v, up, back, and down. Keys are negative against the loop.
inline Face around_domain(const Handle &surface, const std::array<int64_t, 4> &keys,
                          double tolerance = 1e-9) {
    double u[2], v[2];
    require_ok(nurbs_domain(surface.get(), 0, u));
    require_ok(nurbs_domain(surface.get(), 1, v));
    const std::array<double, 2> corners[] = {{u[0], v[0]}, {u[1], v[0]}, {u[1], v[1]}, {u[0], v[1]}};
    std::vector<Handle> curves;
    std::vector<const nurbs *> given;
    for (size_t i = 0; i < 4; ++i) {
        curves.push_back(segment(corners[i], corners[(i + 1) % 4]));
        given.push_back(curves.back().get());
    }
    const int64_t four = 4;
    nurbs_face *face = nullptr;
    require_ok(nurbs_face_create(surface.get(), 1, &four, given.data(), nullptr, keys.data(), tolerance, 0,
                                 nullptr, &face));
    return Face(face);
}

inline Handle plane(const std::array<double, 3> &origin, const std::array<double, 3> &u,
                    const std::array<double, 3> &v) {
    return made([&](nurbs **out) { return nurbs_surface_plane(3, origin.data(), u.data(), v.data(), out); });
}

// The sides of a box of random size, somewhere. Keys are the same for edges that are one. With a gap the sides end by so much
// before their edges, which is within their tolerance.
inline std::vector<Face> box(Random &random, std::array<double, 3> &size, std::array<double, 3> &origin,
                             double gap = 0) {
    for (size_t k = 0; k < 3; ++k) {
        origin[k] = std::ldexp(random.whole(-8, 8), -2); // so that sums are exact
        size[k] = std::ldexp(random.whole(1, 16), -2);
    }
    std::vector<Face> faces;
    for (size_t axis = 0; axis < 3; ++axis) {
        const size_t a = (axis + 1) % 3, b = (axis + 2) % 3;
        for (const int64_t side : {0, 1}) {
            std::array<double, 3> corner = origin, u{}, v{};
            corner[axis] += side == 0 ? 0 : size[axis];
            u[a] = size[a] - 2 * gap;
            v[b] = size[b] - 2 * gap;
            corner[a] += gap;
            corner[b] += gap;
            // The edge along an axis that lies at these ends of the two that follow.
            const auto key = [](size_t along, int64_t first, int64_t second) {
                return 1 + 4 * static_cast<int64_t>(along) + first + 2 * second;
            };
            faces.push_back(around_domain(
                plane(corner, u, v), {key(a, 0, side), key(b, side, 1), -key(a, 1, side), -key(b, side, 0)},
                std::max(1e-9, gap)));
        }
    }
    return faces;
}

inline std::vector<Face> box(Random &random, std::array<double, 3> &size) {
    std::array<double, 3> origin{};
    return box(random, size, origin);
}

// All of a surface that needs no edges.
inline Face whole(const Handle &surface) {
    nurbs_face *face = nullptr;
    require_ok(
        nurbs_face_create(surface.get(), 0, nullptr, nullptr, nullptr, nullptr, 1e-9, 0, nullptr, &face));
    return Face(face);
}

// A disc that closes a cylinder about z at a height, with the key of its edge.
inline Face disc(double radius, double height, int64_t key) {
    const Handle ground = plane({-2 * radius, -2 * radius, height}, {4 * radius, 0, 0}, {0, 4 * radius, 0});
    const double centre[] = {0, 0, height};
    const Handle edge = made([&](nurbs **out) {
        return nurbs_curve_circle(3, centre, nullptr, nullptr, radius, NURBS_ARC_QUARTERS, out);
    });
    const nurbs *edges[] = {edge.get()};
    const int64_t one = 1;
    nurbs_face *face = nullptr;
    require_ok(nurbs_face_create(ground.get(), 1, &one, nullptr, edges, &key, 1e-9, 0, nullptr, &face));
    return Face(face);
}

// Around z from 0 to a height, closed by discs.
inline std::vector<Face> closed_cylinder(double radius, double height) {
    const Handle side = made([&](nurbs **out) {
        return nurbs_surface_cylinder(nullptr, nullptr, nullptr, radius, height, 0, 2 * std::numbers::pi,
                                      NURBS_ARC_QUARTERS, out);
    });
    std::vector<Face> faces;
    faces.push_back(around_domain(side, {1, 3, -2, -3}));
    faces.push_back(disc(radius, 0, 1));
    faces.push_back(disc(radius, height, 2));
    return faces;
}

inline std::vector<const nurbs_face *> given(const std::vector<Face> &faces) {
    std::vector<const nurbs_face *> all;
    for (const Face &face : faces) {
        all.push_back(face.get());
    }
    return all;
}

} // namespace support::solids
