// SPDX-License-Identifier: MIT
#include "mesh/model_mesher.h"

#include "base/error.h"
#include "base/watch.h"
#include "mesh/domain/domain_mesher.h"
#include "mesh/extent.h"

#include <algorithm>
#include <map>
#include <utility>

namespace nrb::mesh {

namespace {

// Rounds in which faces are meshed again because others changed their edges.
constexpr int most_edge_rounds = 12;
// Attempts at a face in one round: a new one starts from scratch after a change of the border that the
// triangles cannot take.
constexpr int most_attempts = 12;
// Limit on the triangles in the kept state of faces, which can then be resumed: some ten megabytes.
constexpr size_t most_kept = size_t{1} << 17;
// When the work counts as not enough: faces are expected to need more than too_much times what there is, or
// it ended in a face whose deviation is more than most_off times the chord. In the latter case the total is
// put at unknown_rest times the expected work of all faces, since nobody knows what that face still needs.
constexpr double too_much = 1.15, most_off = 8, unknown_rest = 2;
// How often in a row the crossing segments of a border are divided although they do not become fewer.
constexpr int most_in_vain = 6;
// The share of the chord error that is left to edges: to their polylines, and to the images of these in the
// faces.
constexpr double share_of_edges = 0.8;

// Whether a polyline keeps to the rule with the points that it has by now.
bool is_reached(const ModelEdges &edges, const EdgeLine &line, const MeshRule &rule) {
    bool result = line.reached && line.bound <= rule.chord;
    for (size_t i = 1; result && rule.longest > 0 && i < line.points.size(); ++i) {
        const auto point = [&](size_t k) { return edges.points()[static_cast<size_t>(line.points[k])]; };
        result = length(point(i) - point(i - 1)) <= rule.longest;
    }
    return result;
}

void append_edges(const ModelEdges &edges, const MeshRule &rule, Mesh &mesh) {
    for (const EdgeLine &line : edges.lines()) {
        mesh.edges.push_back({line.edge, mesh.edge_points.size(), line.points.size(), line.bound,
                              is_reached(edges, line, rule)});
        mesh.edge_points.insert(mesh.edge_points.end(), line.points.begin(), line.points.end());
    }
}

// Drops points of edges that nothing uses any more, because others replaced them (ModelEdges::unite()).
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

} // namespace

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

void append(const DomainMesh &part, Mesh &mesh) {
    constexpr size_t most = std::numeric_limits<int32_t>::max();
    if (part.vertices.size() > most - mesh.vertices.size() ||
        part.points.size() > most - mesh.points.size()) {
        fail(Status::overflow, "a mesh of more than %zu vertices", most);
    }
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

// The mesh of a face with the state that it takes to resume when its border changes.
struct ModelMesher::FaceWork {
    MeshDomain domain;
    std::optional<DomainMesher> mesher{};
};

ModelMesher::ModelMesher(const model::Model &model, const MeshRule &rule, std::vector<double> work_of_faces)
    : model_(model), rule_(rule), shares_(std::move(work_of_faces)),
      edges_(model, {rule.chord * share_of_edges, angle_within_reach(rule.angle), rule.longest}),
      parts_(model.faces.size()), works_(parts_.size()), old_(parts_.size(), true),
      crossings_(parts_.size()) {}

ModelMesher::~ModelMesher() = default;

std::optional<Mesh> ModelMesher::mesh(bool may_fail) {
    may_fail_ = may_fail;
    for (int round = 0; round < most_edge_rounds && has_old(); ++round) {
        const Phase phase;
        mesh_faces(round + 1 == most_edge_rounds);
        if (may_fail_ && wanted_work_ > 0) {
            return std::nullopt;
        }
    }
    works_.clear();
    Mesh result;
    result.points = edges_.points();
    append_edges(edges_, rule_, result);
    for (const DomainMesh &part : parts_) {
        append(part, result);
    }
    drop_loose_points(result);
    return result;
}

bool ModelMesher::has_old() const {
    return std::ranges::find(old_, true) != old_.end();
}

void ModelMesher::mesh_faces(bool last) {
    shares_.begin(old_);
    Steps steps(std::ssize(parts_));
    for (size_t i = 0; i < parts_.size(); ++i, steps.next()) {
        if (old_[i]) {
            judge(i, shares_.run(i, [&] { mesh_face(i, last); }));
            if (may_fail_ && wanted_work_ > 0) {
                return;
            }
        }
    }
}

// Decides, after a face, whether the work is going to be enough. `enough`: whether it was for this face. Where
// no work of faces is expected the answer is always yes: of single faces and coarse meshes, what there is when
// the work ends is mostly closer than a coarser mesh that is made with the rest of it.
void ModelMesher::judge(size_t face, bool enough) noexcept {
    const bool far =
        !enough && std::max(parts_[face].from_shape, parts_[face].from_mesh) > most_off * rule_.chord;
    if (far || shares_.pressure() > too_much) {
        wanted_work_ = (far ? unknown_rest : 1) * shares_.expected();
    }
}

std::unique_ptr<ModelMesher::FaceWork> ModelMesher::work_for(size_t face) {
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
            const bool changed = change_edges(face, domain.border, wish);
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

// Faces with neighbours may have to be resumed. Their state is kept as long as all of it together is small
// enough.
bool ModelMesher::is_kept(const FaceWork &work, size_t triangles) noexcept {
    return parts_.size() > 1 && work.mesher->goes_on() && kept_ + triangles <= most_kept;
}

// Resumes with the triangles that there are, or else starts from scratch.
void ModelMesher::run(FaceWork &work) {
    bool done = work.mesher && work.mesher->take_border() && work.mesher->run();
    for (int attempt = 1; !done && attempt <= most_attempts; ++attempt) {
        if (attempt == most_attempts) {
            work.domain.change_border = {};
        }
        work.mesher.emplace(work.domain, rule_);
        done = work.mesher->run();
    }
}

// Whether a second attempt with triangles that are fat in space may do better: with long cells, triangles at
// a pole may lie on each other, so that nothing is proven.
bool ModelMesher::is_better_in_space(const FaceWork &work, const DomainMesh &made) noexcept {
    const auto &[u, v] = work.domain.collapsed;
    return !work.domain.in_space && !(made.from_shape < infinity) && (u[0] || u[1] || v[0] || v[1]);
}

void ModelMesher::mesh_face(size_t face, bool last) {
    std::unique_ptr<FaceWork> work = work_for(face);
    if (last) {
        work->domain.change_border = {};
    }
    run(*work);
    bool keep = !last && is_kept(*work, work->mesher->triangle_count());
    parts_[face] = work->mesher->output(!keep);
    if (is_better_in_space(*work, parts_[face])) {
        work->domain.in_space = true;
        work->mesher.reset();
        run(*work);
        keep = !last && is_kept(*work, work->mesher->triangle_count());
        parts_[face] = work->mesher->output(!keep);
    }
    old_[face] = false;
    if (keep) {
        kept_ += parts_[face].triangles.size();
        works_[face] = std::move(work);
    }
}

// Whether dividing crossing segments has failed too often. Borders that overlap, or pass each other at a
// corner, cross the more often the more vertices they have; borders that are merely close stop crossing once
// their segments are close enough to their curves.
bool ModelMesher::is_hopeless(size_t face, size_t crossed) noexcept {
    if (crossed == 0) { // nothing was divided, nor is it now
        return false;
    }
    Crossings &own = crossings_[face];
    own.in_vain = crossed < own.fewest ? 0 : own.in_vain + 1;
    own.fewest = std::min(own.fewest, crossed);
    return own.in_vain > most_in_vain;
}

// Divides segments and unites points of edges as a face asks. Returns whether anything changed; all faces at
// the changed edges are then marked as old.
bool ModelMesher::change_edges(size_t face, const FaceBorder &border, const BorderWish &wish) {
    std::map<int64_t, std::vector<double>> places; // new parameters on polylines, by their numbers
    const auto add = [&](int32_t segment, double share) {
        const BorderSegment &weak = border.segments[static_cast<size_t>(segment)];
        if (weak.line >= 0) {
            places[weak.line].push_back(weak.params[0] * (1 - share) + weak.params[1] * share);
        }
    };
    const auto divide = [&](int32_t segment, int count) {
        for (int i = 1; i < count; ++i) {
            add(segment, static_cast<double>(i) / count);
        }
    };
    for (const auto &[segment, count] : wish.weak) {
        divide(segment, count);
    }
    if (!is_hopeless(face, wish.crossed.size())) {
        for (const int32_t segment : wish.crossed) { // many of the parts no longer cross
            divide(segment, 4);
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
        drop_work(static_cast<size_t>(user)); // the points that it refers to were replaced
    }
    return any;
}

} // namespace nrb::mesh
