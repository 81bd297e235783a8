// SPDX-License-Identifier: MIT
#include "mesh/surface_mesh.h"

#include "base/watch.h"

#include <algorithm>

namespace nrb::mesh {

namespace {

// Rounds in which edges get more vertices for the sake of faces.
constexpr int most_rounds = 8;
// Of the tolerance, for edges: their segments, and what faces make of them.
constexpr double share_of_edges = 0.8;

MeshDomain domain_of(const Spline &surface, const face::Covering &covering) {
    MeshDomain domain;
    domain.surface = &surface;
    for (int k = 0; k < 2; ++k) {
        const auto at = static_cast<size_t>(k);
        domain.closed[at] = covering.closed(k);
        domain.collapsed[at] = {covering.collapsed(k, 0), covering.collapsed(k, 1)};
    }
    return domain;
}

// With own points behind all others.
void append(const DomainMesh &part, int64_t face, Mesh &mesh) {
    const auto base = static_cast<int32_t>(mesh.vertices.size()), first = static_cast<int32_t>(mesh.points.size());
    MeshFace info;
    info.face = face;
    info.first_vertex = mesh.vertices.size();
    info.vertices = part.vertices.size();
    info.first_triangle = mesh.triangles.size();
    info.triangles = part.triangles.size();
    info.from_shape = part.from_shape;
    info.from_mesh = part.from_mesh;
    info.reached = part.reached;
    mesh.faces.push_back(info);
    mesh.points.insert(mesh.points.end(), part.points.begin(), part.points.end());
    for (MeshVertex vertex : part.vertices) {
        vertex.point = vertex.point < 0 ? first - 1 - vertex.point : vertex.point;
        mesh.vertices.push_back(vertex);
    }
    for (const auto &triangle : part.triangles) {
        mesh.triangles.push_back({base + triangle[0], base + triangle[1], base + triangle[2]});
    }
}

class ModelMesher {
public:
    ModelMesher(const model::Model &model, const MeshRule &rule)
        : model_(model), rule_(rule), edges_(model, {rule.chord * share_of_edges}), parts_(model.faces.size()) {}

    Mesh mesh() {
        std::vector<bool> old(parts_.size(), true);
        for (int round = 0; round < most_rounds; ++round) {
            const Phase phase;
            if (!mesh_faces(old) || !divide_edges(old)) {
                break;
            }
        }
        Mesh result;
        result.points = edges_.points();
        for (size_t i = 0; i < parts_.size(); ++i) {
            append(parts_[i], static_cast<int64_t>(i), result);
        }
        return result;
    }

private:
    // Those whose edges changed.
    bool mesh_faces(const std::vector<bool> &old);
    // Where faces need it. Returns whether there is something new; then `old` tells for whom.
    bool divide_edges(std::vector<bool> &old);

    const model::Model &model_;
    const MeshRule &rule_;
    ModelEdges edges_;
    std::vector<DomainMesh> parts_;
    std::vector<std::pair<int64_t, double>> weak_; // polylines, and where they are to be divided
};

bool ModelMesher::mesh_faces(const std::vector<bool> &old) {
    weak_.clear();
    Steps steps(std::ssize(parts_));
    for (size_t i = 0; i < parts_.size(); ++i, steps.next()) {
        if (!old[i]) {
            continue;
        }
        const face::Face &face = *model_.faces[i].face;
        MeshDomain domain = domain_of(*face.surface(), face.covering());
        domain.border = border_of(model_, static_cast<int64_t>(i), edges_);
        domain.points = &edges_.points();
        domain.inside = [&face](const face::Point2 &x) { return face.trims().side(x) > 0; };
        domain.cut = [&face](const Rectangle &part) { return face.trims().cuts(part.lower, part.upper); };
        parts_[i] = mesh_of(domain, rule_);
        for (const int32_t segment : parts_[i].weak) {
            const BorderSegment &weak = domain.border.segments[static_cast<size_t>(segment)];
            if (weak.line >= 0) {
                weak_.emplace_back(weak.line, weak.middle);
            }
        }
    }
    return !weak_.empty();
}

bool ModelMesher::divide_edges(std::vector<bool> &old) {
    std::ranges::sort(weak_);
    weak_.erase(std::ranges::unique(weak_).begin(), weak_.end());
    old.assign(old.size(), false);
    bool any = false;
    for (const auto &[line, param] : weak_) {
        for (const int64_t face : edges_.add_vertex(line, param)) {
            old[static_cast<size_t>(face)] = any = true;
        }
    }
    return any;
}

} // namespace

MeshPtr mesh_of(const Spline &surface, const MeshRule &rule) {
    Mesh mesh;
    append(mesh_of(domain_of(surface, face::Covering(surface, 0)), rule), 0, mesh);
    return std::make_shared<const Mesh>(std::move(mesh));
}

MeshPtr mesh_of(const model::Model &model, const MeshRule &rule) {
    return std::make_shared<const Mesh>(ModelMesher(model, rule).mesh());
}

} // namespace nrb::mesh
