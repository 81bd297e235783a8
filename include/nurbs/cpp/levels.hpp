/* SPDX-License-Identifier: MIT */
/// \file levels.hpp
/// \brief Meshes of one shape for several distances.
#ifndef NURBS_CPP_LEVELS_HPP
#define NURBS_CPP_LEVELS_HPP

#include <nurbs/cpp/mesh.hpp>

#include <cstdint>
#include <vector>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

namespace detail {

// What f(number, distances, handles) makes.
template <class F>
std::vector<Mesh> levels(View<double> chords, F &&f) {
    std::vector<nurbs_mesh *> handles(chords.size());
    std::vector<Mesh> meshes;
    meshes.reserve(chords.size());
    attempt([&] { return f(length(chords), chords.data(), handles.data()); });
    for (nurbs_mesh *handle : handles) {
        meshes.push_back(Mesh(handle));
    }
    return meshes;
}

} // namespace detail

/// Meshes of a whole surface, one for each of the distances, in their order: each as Mesh::of_surface() makes it with that
/// `chord`, and no `relative_chord`.
[[nodiscard]] inline Returned<std::vector<Mesh>> mesh_levels(const Spline &g, View<double> chords,
                                                             const MeshOptions &options = {}) {
    return detail::levels(chords, [&](std::int64_t count, const double *own, nurbs_mesh **out) {
        return nurbs_mesh_surface_levels(g.get(), count, own, &options, out);
    });
}
/// The same; `call` can watch and end it.
[[nodiscard]] inline Returned<std::vector<Mesh>>
mesh_levels(const Spline &g, View<double> chords, const MeshOptions &options, const CallOptions &call) {
    const detail::Watch watch(call);
    return detail::levels(chords, [&](std::int64_t count, const double *own, nurbs_mesh **out) {
        return nurbs_mesh_surface_levels_with(g.get(), count, own, &options, watch.get(), out);
    });
}

/// The same of a trimmed face: Mesh::of_face().
[[nodiscard]] inline Returned<std::vector<Mesh>> mesh_levels(const Face &face, View<double> chords,
                                                             const MeshOptions &options = {}) {
    return detail::levels(chords, [&](std::int64_t count, const double *own, nurbs_mesh **out) {
        return nurbs_mesh_face_levels(face.get(), count, own, &options, out);
    });
}
/// The same; `call` can watch and end it.
[[nodiscard]] inline Returned<std::vector<Mesh>>
mesh_levels(const Face &face, View<double> chords, const MeshOptions &options, const CallOptions &call) {
    const detail::Watch watch(call);
    return detail::levels(chords, [&](std::int64_t count, const double *own, nurbs_mesh **out) {
        return nurbs_mesh_face_levels_with(face.get(), count, own, &options, watch.get(), out);
    });
}

/// The same of all faces of a model: Mesh::of_model().
[[nodiscard]] inline Returned<std::vector<Mesh>> mesh_levels(const Model &model, View<double> chords,
                                                             const MeshOptions &options = {}) {
    return detail::levels(chords, [&](std::int64_t count, const double *own, nurbs_mesh **out) {
        return nurbs_mesh_model_levels(model.get(), count, own, &options, out);
    });
}
/// The same; `call` can watch and end it.
[[nodiscard]] inline Returned<std::vector<Mesh>>
mesh_levels(const Model &model, View<double> chords, const MeshOptions &options, const CallOptions &call) {
    const detail::Watch watch(call);
    return detail::levels(chords, [&](std::int64_t count, const double *own, nurbs_mesh **out) {
        return nurbs_mesh_model_levels_with(model.get(), count, own, &options, watch.get(), out);
    });
}

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_LEVELS_HPP
