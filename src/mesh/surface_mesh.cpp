// SPDX-License-Identifier: MIT
#include "mesh/surface_mesh.h"

#include "base/watch.h"
#include "mesh/extent.h"
#include "model/from_faces.h"

#include <algorithm>

namespace nrb::mesh {

namespace {

// Rounds in which edges get more vertices for the sake of faces.
constexpr int most_edge_rounds = 12;
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
void append(const DomainMesh &part, Mesh &mesh) {
    const auto base = static_cast<int32_t>(mesh.vertices.size()),
               first = static_cast<int32_t>(mesh.points.size());
    MeshFace info;
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

void append_edges(const ModelEdges &edges, Mesh &mesh) {
    for (const EdgeLine &line : edges.lines()) {
        mesh.edges.push_back(
            {line.edge, mesh.edge_points.size(), line.points.size(), line.bound, line.reached});
        mesh.edge_points.insert(mesh.edge_points.end(), line.points.begin(), line.points.end());
    }
}

MeshRule settled(const model::Model &model, const MeshRule &rule) {
    std::vector<Interval> box;
    double extent = 0;
    for (const model::ModelFace &face : model.faces) {
        extent = std::max(extent, extent_of(face.face->surface()->effective(), box));
    }
    return settled(rule, extent);
}

void check_surface(const Spline &surface) {
    if (surface.axes() != 2) {
        fail(Status::axes, "a spline of %d axes, expected a surface", surface.axes());
    }
    if (surface.dim() != 2 && surface.dim() != 3) {
        fail(Status::dimension, "a surface of dimension %d, expected 2 or 3", surface.dim());
    }
}

class ModelMesher {
public:
    ModelMesher(const model::Model &model, const MeshRule &rule)
        : model_(model), rule_(rule), edges_(model, {rule.chord * share_of_edges, 0, rule.longest}),
          parts_(model.faces.size()) {}

    Mesh mesh() {
        std::vector<bool> old(parts_.size(), true);
        for (int round = 0; round < most_edge_rounds; ++round) {
            const Phase phase;
            if (!mesh_faces(old, round + 1 == most_edge_rounds) || !divide_edges(old)) {
                break;
            }
        }
        Mesh result;
        result.points = edges_.points();
        append_edges(edges_, result);
        for (size_t i = 0; i < parts_.size(); ++i) {
            append(parts_[i], result);
        }
        return result;
    }

private:
    // Those whose edges changed.
    bool mesh_faces(const std::vector<bool> &old, bool last);
    // Where faces need it. Returns whether there is something new; then `old` tells for whom.
    bool divide_edges(std::vector<bool> &old);

    const model::Model &model_;
    MeshRule rule_;
    ModelEdges edges_;
    std::vector<DomainMesh> parts_;
    std::vector<std::pair<int64_t, double>> weak_; // polylines, and where they are to be divided
};

bool ModelMesher::mesh_faces(const std::vector<bool> &old, bool last) {
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
        domain.border_grows = !last;
        domain.inside = [&face](const face::Point2 &x) { return face.trims().side(x) > 0; };
        domain.cut = [&face](const Rectangle &part) { return face.trims().cuts(part.lower, part.upper); };
        parts_[i] = mesh_of(domain, rule_);
        for (const auto &[segment, count] : parts_[i].weak) {
            const BorderSegment &weak = domain.border.segments[static_cast<size_t>(segment)];
            for (int part = 1; part < count && weak.line >= 0; ++part) {
                const double share = static_cast<double>(part) / count;
                weak_.emplace_back(weak.line, weak.params[0] * (1 - share) + weak.params[1] * share);
            }
        }
    }
    return !weak_.empty();
}

bool ModelMesher::divide_edges(std::vector<bool> &old) {
    std::ranges::sort(weak_);
    weak_.erase(std::unique(weak_.begin(), weak_.end()), weak_.end());
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
    check_surface(surface);
    std::vector<Interval> box;
    const MeshRule own = settled(rule, extent_of(surface.effective(), box));
    Mesh mesh;
    append(mesh_of(domain_of(surface, face::Covering(surface, 0)), own), mesh);
    return std::make_shared<const Mesh>(std::move(mesh));
}

MeshPtr mesh_of(const face::FacePtr &face, const MeshRule &rule) {
    return mesh_of(model::model_of_faces({face}, 0), rule);
}

MeshPtr mesh_of(const model::Model &model, const MeshRule &rule) {
    for (const model::ModelFace &face : model.faces) {
        check_surface(*face.face->surface());
    }
    return std::make_shared<const Mesh>(ModelMesher(model, settled(model, rule)).mesh());
}

} // namespace nrb::mesh
