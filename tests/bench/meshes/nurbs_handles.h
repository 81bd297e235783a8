// SPDX-License-Identifier: MIT
// The shapes as handles of this library, and its meshes as arrays.
#pragma once

#include "bench/meshes/foot.h"
#include "bench/meshes/shapes.h"

#include <memory>
#include <nurbs/nurbs.h>

namespace bench::meshes {

inline void good(nurbs_status status) {
    if (status != NURBS_OK) {
        char text[512];
        nurbs_last_error(text, sizeof text);
        std::fprintf(stderr, "%s: %s\n", nurbs_status_name(status), text);
        std::exit(1);
    }
}

struct Destroy {
    void operator()(nurbs *g) const noexcept { nurbs_destroy(g); }
    void operator()(nurbs_face *face) const noexcept { nurbs_face_destroy(face); }
    void operator()(nurbs_model *model) const noexcept { nurbs_model_destroy(model); }
    void operator()(nurbs_mesh *mesh) const noexcept { nurbs_mesh_destroy(mesh); }
};
using Surface = std::unique_ptr<nurbs, Destroy>;
using Face = std::unique_ptr<nurbs_face, Destroy>;
using Model = std::unique_ptr<nurbs_model, Destroy>;
using OwnMesh = std::unique_ptr<nurbs_mesh, Destroy>;

inline Surface surface_of(const Net &net) {
    const int32_t degrees[] = {net.degree, net.degree};
    const int64_t counts[] = {net.count, net.count};
    std::vector<double> knots = net.u_knots;
    knots.insert(knots.end(), net.v_knots.begin(), net.v_knots.end());
    nurbs *out = nullptr;
    good(nurbs_create(2, degrees, counts, knots.data(), static_cast<int64_t>(knots.size()), 3,
                      net.points[0].data(), 0, 0, net.weights.data(), 0, 0, &out));
    return Surface(out);
}

inline Surface surface_of(Kind::Surface surface) {
    using enum Kind::Surface;
    constexpr double whole = 2 * std::numbers::pi;
    nurbs *out = nullptr;
    switch (surface) {
    case patch:
        return surface_of(bench::meshes::patch());
    case plane:
        return surface_of(bench::meshes::plane());
    case sphere:
        good(nurbs_surface_sphere(nullptr, nullptr, nullptr, 1, NURBS_ARC_QUARTERS, &out));
        break;
    case torus:
        good(nurbs_surface_torus(nullptr, nullptr, nullptr, major, minor, 0, whole, 0, whole,
                                 NURBS_ARC_QUARTERS, &out));
        break;
    case cylinder:
        good(
            nurbs_surface_cylinder(nullptr, nullptr, nullptr, 1, height, 0, whole, NURBS_ARC_QUARTERS, &out));
        break;
    }
    return Surface(out);
}

// A line from each place to the next one, as one curve.
inline Surface polyline(const std::vector<Param> &places) {
    const int32_t degree = 1;
    const auto count = static_cast<int64_t>(places.size());
    std::vector<double> knots{0};
    for (int64_t i = 0; i < count; ++i) {
        knots.push_back(static_cast<double>(i));
    }
    knots.push_back(knots.back());
    nurbs *out = nullptr;
    good(nurbs_create(1, &degree, &count, knots.data(), count + 2, 2, places[0].data(), 0, 0, nullptr, 0, 0,
                      &out));
    return Surface(out);
}

inline Face face_of(const nurbs *surface, Trim trim) {
    std::vector<Param> places = corners();
    places.push_back(places.front());
    std::vector<Surface> curves;
    if (trim == Trim::polyline) {
        curves.push_back(polyline(places));
    } else {
        for (size_t i = 1; i < places.size(); ++i) {
            curves.push_back(polyline({places[i - 1], places[i]}));
        }
    }
    std::vector<const nurbs *> given;
    for (const Surface &curve : curves) {
        given.push_back(curve.get());
    }
    const auto size = static_cast<int64_t>(given.size());
    nurbs_face *out = nullptr;
    good(nurbs_face_create(surface, 1, &size, given.data(), nullptr, nullptr, 1e-9, 0, nullptr, &out));
    return Face(out);
}

inline Mesh arrays_of(const nurbs_mesh *mesh) {
    int64_t points = 0, vertices = 0, triangles = 0;
    good(nurbs_mesh_counts(mesh, &points, &vertices, &triangles, nullptr, nullptr, nullptr));
    std::vector<Point> at(static_cast<size_t>(points));
    std::vector<int64_t> own(static_cast<size_t>(vertices));
    Mesh all;
    all.params.resize(own.size());
    all.triangles.resize(static_cast<size_t>(triangles));
    good(nurbs_mesh_points(mesh, points, at.data()->data(), nullptr));
    good(nurbs_mesh_vertices(mesh, vertices, own.data(), all.params.data()->data(), nullptr, nullptr));
    good(nurbs_mesh_triangles(mesh, 0, triangles, all.triangles.data()->data(), nullptr));
    for (const int64_t i : own) {
        all.points.push_back(at[static_cast<size_t>(i)]);
    }
    return all;
}

inline Domain domain_of(const nurbs *surface) {
    double u[2], v[2];
    good(nurbs_domain(surface, 0, u));
    good(nurbs_domain(surface, 1, v));
    return {{u[0], v[0]}, {u[1], v[1]}};
}

inline Jet jet_of(const nurbs *surface, const Param &at) {
    Jet jet{};
    Point all[3];
    good(nurbs_eval_derivs(surface, 1, 1, at.data(), 0, 0, all[0].data(), 0, 0,
                           NURBS_CLAMP | NURBS_CLAMP << 8));
    jet.point = all[0], jet.along_u = all[1], jet.along_v = all[2];
    return jet;
}

inline nurbs_mesh_options limit(double chord) {
    nurbs_mesh_options options;
    good(nurbs_mesh_options_init(&options, sizeof options));
    options.chord = chord;
    options.relative_chord = 0;
    return options;
}

} // namespace bench::meshes
