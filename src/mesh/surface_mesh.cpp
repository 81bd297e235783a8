// SPDX-License-Identifier: MIT
#include "mesh/surface_mesh.h"

#include "base/watch.h"
#include "mesh/domain/domain_mesher.h"
#include "mesh/extent.h"
#include "mesh/outside.h"
#include "model/from_faces.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>

namespace nrb::mesh {

namespace {

// Rounds in which faces follow the edges that others changed.
constexpr int most_edge_rounds = 12;
// Of a face, at borders of which points or all triangles become others.
constexpr int most_attempts = 12;
// Triangles of faces that are kept so that these can go on: some ten megabytes.
constexpr size_t most_kept = size_t{1} << 17;
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
    mesh.paired.insert(mesh.paired.end(), part.paired.begin(), part.paired.end());
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

// Of edges: those for which others stand.
void drop_loose_points(Mesh &mesh) {
    std::vector<int32_t> number(mesh.points.size(), -1);
    const auto use = [&](int32_t point) { number[static_cast<size_t>(point)] = 0; };
    std::ranges::for_each(mesh.edge_points, use);
    std::ranges::for_each(mesh.vertices, use, &MeshVertex::point);
    int32_t count = 0;
    for (size_t i = 0; i < number.size(); ++i) {
        if (number[i] == 0) {
            number[i] = count;
            mesh.points[static_cast<size_t>(count++)] = mesh.points[i];
        }
    }
    mesh.points.resize(static_cast<size_t>(count));
    for (int32_t &point : mesh.edge_points) {
        point = number[static_cast<size_t>(point)];
    }
    for (MeshVertex &vertex : mesh.vertices) {
        vertex.point = number[static_cast<size_t>(vertex.point)];
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

// The mesh of a face, with all that it takes to go on where its border changes.
struct FaceWork {
    MeshDomain domain;
    std::optional<DomainMesher> mesher{};
};

class ModelMesher {
public:
    ModelMesher(const model::Model &model, const MeshRule &rule)
        : model_(model), rule_(rule),
          edges_(model, {rule.chord * share_of_edges, angle_within_reach(rule.angle), rule.longest}),
          parts_(model.faces.size()), works_(parts_.size()), old_(parts_.size(), true) {}

    Mesh mesh() {
        for (int round = 0; round < most_edge_rounds && has_old(); ++round) {
            const Phase phase;
            mesh_faces(round + 1 == most_edge_rounds);
        }
        works_.clear();
        Mesh result;
        result.points = edges_.points();
        append_edges(edges_, result);
        for (size_t i = 0; i < parts_.size(); ++i) {
            append(parts_[i], result);
        }
        drop_loose_points(result);
        return result;
    }

private:
    [[nodiscard]] bool has_old() const { return std::ranges::find(old_, true) != old_.end(); }
    // Those whose edges changed; last: no edge may change any more.
    void mesh_faces(bool last);
    void mesh_face(size_t face, bool last);
    [[nodiscard]] std::unique_ptr<FaceWork> work_for(size_t face);
    void drop_work(size_t face);
    [[nodiscard]] bool is_kept(const FaceWork &work, size_t triangles) noexcept;
    bool change_edges(const FaceBorder &border, const BorderWish &wish);

    const model::Model &model_;
    MeshRule rule_;
    ModelEdges edges_;
    std::vector<DomainMesh> parts_;
    std::vector<std::unique_ptr<FaceWork>> works_; // of faces that go on where they are old
    size_t kept_ = 0;                              // triangles of these
    std::vector<bool> old_;                        // faces whose edges changed
};

void ModelMesher::mesh_faces(bool last) {
    Steps steps(std::ssize(parts_));
    for (size_t i = 0; i < parts_.size(); ++i, steps.next()) {
        if (old_[i]) {
            mesh_face(i, last);
        }
    }
}

std::unique_ptr<FaceWork> ModelMesher::work_for(size_t face) {
    std::unique_ptr<FaceWork> work = std::move(works_[face]);
    if (work) {
        kept_ -= parts_[face].triangles.size();
    } else {
        const face::Face &own = *model_.faces[face].face;
        work = std::make_unique<FaceWork>();
        work->domain = domain_of(*own.surface(), own.covering());
        work->domain.points = &edges_.points();
        work->domain.inside = [&own](const face::Point2 &x) { return own.trims().side(x) > 0; };
        work->domain.cut = [&own](const Rectangle &part) { return own.trims().cuts(part.lower, part.upper); };
        work->domain.change_border = [this, face, &domain = work->domain](const BorderWish &wish) {
            const bool changed = change_edges(domain.border, wish);
            if (changed) {
                domain.border = border_of(model_, static_cast<int64_t>(face), edges_);
            }
            return changed;
        };
    }
    work->domain.border = border_of(model_, static_cast<int64_t>(face), edges_);
    return work;
}

void ModelMesher::drop_work(size_t face) {
    kept_ -= works_[face] ? parts_[face].triangles.size() : 0;
    works_[face].reset();
}

// Faces beside others may have to go on. What that takes is kept where it is not too much.
bool ModelMesher::is_kept(const FaceWork &work, size_t triangles) noexcept {
    return parts_.size() > 1 && work.mesher->goes_on() && kept_ + triangles <= most_kept;
}

void ModelMesher::mesh_face(size_t face, bool last) {
    std::unique_ptr<FaceWork> work = work_for(face);
    if (last) {
        work->domain.change_border = {};
    }
    bool done = work->mesher && work->mesher->take_border() && work->mesher->run();
    for (int attempt = 1; !done && attempt <= most_attempts; ++attempt) {
        if (attempt == most_attempts) {
            work->domain.change_border = {};
        }
        work->mesher.emplace(work->domain, rule_);
        done = work->mesher->run();
    }
    const bool keep = !last && is_kept(*work, work->mesher->triangle_count());
    parts_[face] = work->mesher->output(!keep);
    old_[face] = false;
    if (keep) {
        kept_ += parts_[face].triangles.size();
        works_[face] = std::move(work);
    }
}

// Where a face needs it. Returns whether there is something new; other faces there are old then.
bool ModelMesher::change_edges(const FaceBorder &border, const BorderWish &wish) {
    std::map<int64_t, std::vector<double>> places; // on polylines
    const auto add = [&](int32_t segment, double share) {
        const BorderSegment &weak = border.segments[static_cast<size_t>(segment)];
        if (weak.line >= 0) {
            places[weak.line].push_back(weak.params[0] * (1 - share) + weak.params[1] * share);
        }
    };
    for (const auto &[segment, count] : wish.weak) {
        for (int i = 1; i < count; ++i) {
            add(segment, static_cast<double>(i) / count);
        }
    }
    for (const auto &[segment, share] : wish.touched) {
        add(segment, share);
    }
    bool any = false;
    for (auto &[line, params] : places) {
        std::ranges::sort(params);
        for (const int64_t user : edges_.add_vertices(line, params)) {
            old_[static_cast<size_t>(user)] = any = true;
        }
    }
    for (const int64_t user : edges_.unite(wish.united)) {
        old_[static_cast<size_t>(user)] = any = true;
        drop_work(static_cast<size_t>(user)); // its points are others
    }
    return any;
}

void check_surfaces(const model::Model &model) {
    for (const model::ModelFace &face : model.faces) {
        check_surface(*face.face->surface());
    }
}

// Of the work that is left for this distance and smaller ones: triangles are as many as what they are near to is large.
double share_of(double chord, double rest) noexcept {
    return std::isfinite(1 / chord) && rest > 0 ? 1 / chord / rest : 0.5;
}

// Calls make(chord), from coarse to fine: a limit of work is for the coarse ones first.
template <class Make>
std::vector<MeshPtr> level_by_level(const Levels &levels, Make &&make) {
    std::vector<size_t> order(levels.chords.size());
    std::iota(order.begin(), order.end(), size_t{0});
    std::ranges::sort(order, {}, [&](size_t i) { return std::pair(-levels.chords[i], i); });
    double rest = 0;
    for (const double chord : levels.chords) {
        rest += 1 / chord;
    }
    std::vector<MeshPtr> meshes(order.size());
    for (size_t i = 0; i < order.size(); ++i) {
        const double chord = levels.chords[order[i]];
        if (i > 0 && chord == levels.chords[order[i - 1]]) {
            meshes[order[i]] = meshes[order[i - 1]];
            continue;
        }
        const Phase phase(share_of(chord, rest));
        const UsualLimit usual(levels.usual_work);
        const LimitedSearch limited;
        meshes[order[i]] = make(chord);
        rest -= 1 / chord;
    }
    return meshes;
}

MeshRule with_chord(MeshRule rule, double chord) {
    rule.chord = chord;
    return rule;
}

} // namespace

MeshPtr mesh_of(const Spline &surface, const MeshRule &rule) {
    check_surface(surface);
    std::vector<Interval> box;
    const MeshRule own = settled(rule, extent_of(surface.effective(), box));
    Mesh mesh;
    append(mesh_of(domain_of(surface, face::Covering(surface, 0)), own), mesh);
    label_as_one_part(mesh);
    return std::make_shared<const Mesh>(std::move(mesh));
}

MeshPtr mesh_of(const face::FacePtr &face, const MeshRule &rule) {
    return mesh_of(model::model_of_faces({face}, 0), rule);
}

MeshPtr mesh_of(const model::Model &model, const MeshRule &rule) {
    check_surfaces(model);
    Mesh mesh = ModelMesher(model, settled(model, rule)).mesh();
    label(model, mesh);
    return std::make_shared<const Mesh>(std::move(mesh));
}

std::vector<MeshPtr> meshes_of(const Spline &surface, const MeshRule &rule, const Levels &levels) {
    return level_by_level(levels, [&](double chord) { return mesh_of(surface, with_chord(rule, chord)); });
}

std::vector<MeshPtr> meshes_of(const face::FacePtr &face, const MeshRule &rule, const Levels &levels) {
    return meshes_of(model::model_of_faces({face}, 0), rule, levels);
}

std::vector<MeshPtr> meshes_of(const model::Model &model, const MeshRule &rule, const Levels &levels) {
    return level_by_level(levels, [&](double chord) { return mesh_of(model, with_chord(rule, chord)); });
}

} // namespace nrb::mesh
