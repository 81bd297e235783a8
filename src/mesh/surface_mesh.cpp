// SPDX-License-Identifier: MIT
#include "mesh/surface_mesh.h"

#include "base/watch.h"

namespace nrb::mesh {

MeshPtr mesh_of(const Spline &surface, const MeshRule &rule) {
    const face::Covering covering(surface, 0);
    MeshDomain domain;
    domain.surface = &surface;
    for (int k = 0; k < 2; ++k) {
        const auto at = static_cast<size_t>(k);
        domain.closed[at] = covering.closed(k);
        domain.collapsed[at] = {covering.collapsed(k, 0), covering.collapsed(k, 1)};
    }
    Mesh mesh;
    mesh.faces.push_back(add_mesh(domain, rule, mesh));
    return std::make_shared<const Mesh>(std::move(mesh));
}

MeshPtr mesh_of(const model::Model &model, const MeshRule &rule) {
    const ModelEdges edges(model, {rule.chord * 0.8});
    Mesh mesh;
    mesh.points = edges.points();
    Steps steps(std::ssize(model.faces));
    for (int64_t i = 0; i < std::ssize(model.faces); ++i, steps.next()) {
        const face::Face &face = *model.faces[static_cast<size_t>(i)].face;
        MeshDomain domain;
        domain.surface = face.surface().get();
        domain.border = border_of(model, i, edges);
        for (int k = 0; k < 2; ++k) {
            const auto at = static_cast<size_t>(k);
            domain.closed[at] = face.covering().closed(k);
            domain.collapsed[at] = {face.covering().collapsed(k, 0), face.covering().collapsed(k, 1)};
        }
        domain.inside = [&face](const face::Point2 &x) { return face.trims().side(x) > 0; };
        domain.cut = [&face](const Rectangle &part) { return face.trims().cuts(part.lower, part.upper); };
        mesh.faces.push_back(add_mesh(domain, rule, mesh));
        mesh.faces.back().face = i;
    }
    return std::make_shared<const Mesh>(std::move(mesh));
}

} // namespace nrb::mesh
