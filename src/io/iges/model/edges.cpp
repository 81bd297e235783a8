// SPDX-License-Identifier: MIT
#include "io/iges/model/edges.h"

#include "eval/curve_point.h"
#include "face/deviation.h"
#include "io/iges/types.h"
#include "numeric/norm.h"

namespace nrb::io::iges {
namespace {

using Place = std::array<double, 3>;

Place end_of(const Spline &curve, bool upper) {
    Place x;
    eval::end_point(curve, upper, x.data());
    return x;
}

class EdgeReader {
public:
    EdgeReader(Geometry &geometry, const TopologyEntities &topology, model::Model &model,
               std::vector<Damage> &damages)
        : geometry_(geometry), topology_(topology), model_(model), damages_(damages) {}

    EdgeLists run() {
        add_vertices();
        EdgeLists lists;
        for (const auto &[pointer, edges] : topology_.edge_lists) {
            std::vector<ListedEdge> &list = lists[pointer];
            for (const EdgeEntity &edge : edges) {
                list.push_back(guarded(pointer, std::ssize(list) + 1, edge));
            }
        }
        return lists;
    }

private:
    ListedEdge guarded(int64_t pointer, int64_t number, const EdgeEntity &edge) {
        try {
            return read(edge);
        } catch (const Error &error) {
            const Entry &entry = geometry_.entities().at(pointer, "edge list");
            damages_.push_back({pointer, error.status(),
                                label_of(entry) + "edge " + std::to_string(number) + ": " + error.what()});
            return {};
        }
    }
    ListedEdge read(const EdgeEntity &entity) {
        model::CurvePiece piece = geometry_.curve(entity.curve);
        geometry_.entities().spend(Limits::size_of_a_shape + size_of(piece));
        SplinePtr spline = spline_of(piece);
        model::Edge edge;
        for (size_t end = 0; end < 2; ++end) {
            edge.vertices[end] = vertex(entity.vertex_lists[end], entity.vertex_indices[end]);
        }
        if (runs_backwards(*spline, edge.vertices)) {
            piece.forward = !piece.forward;
            spline = spline_of(piece);
        }
        edge.curve = spline;
        edge.shape = piece.curve;
        model_.edges.push_back(std::move(edge));
        return {std::move(spline), std::ssize(model_.edges) - 1};
    }
    // Adds the vertices that edges refer to, in the order of their lists.
    void add_vertices() {
        for (const auto &[pointer, edges] : topology_.edge_lists) {
            for (const EdgeEntity &edge : edges) {
                for (size_t end = 0; end < 2; ++end) {
                    if (point_at(edge.vertex_lists[end], edge.vertex_indices[end]) != nullptr) {
                        vertices_[{edge.vertex_lists[end], edge.vertex_indices[end]}] = 0;
                    }
                }
            }
        }
        for (auto &[place, number] : vertices_) {
            const Place &x = *point_at(place.first, place.second);
            number = std::ssize(model_.vertices);
            model_.vertices.push_back({x[0], x[1], x[2]});
        }
    }
    [[nodiscard]] const Place *point_at(int64_t list, int64_t index) const {
        const auto points = topology_.vertex_lists.find(list);
        const auto count = points == topology_.vertex_lists.end() ? 0 : std::ssize(points->second);
        return index < 1 || index > count ? nullptr : &points->second[static_cast<size_t>(index - 1)];
    }
    [[nodiscard]] int64_t vertex(int64_t list, int64_t index) const {
        const auto known = vertices_.find({list, index});
        if (known == vertices_.end()) {
            fail(Status::syntax, "the vertex list (502) at directory line %lld has no vertex %lld",
                 static_cast<long long>(list), static_cast<long long>(index));
        }
        return known->second;
    }
    // Whether the curve begins nearer to the vertex at which it should end, and ends nearer to the other one.
    [[nodiscard]] bool runs_backwards(const Spline &curve, const std::array<int64_t, 2> &vertices) const {
        const Place start = end_of(curve, false), end = end_of(curve, true);
        const Vector3 a = model_.vertices[static_cast<size_t>(vertices[0])],
                      b = model_.vertices[static_cast<size_t>(vertices[1])];
        const Place from{a.x, a.y, a.z}, to{b.x, b.y, b.z};
        return distance(start.data(), to.data(), 3) < distance(start.data(), from.data(), 3) &&
               distance(end.data(), from.data(), 3) < distance(end.data(), to.data(), 3);
    }

    Geometry &geometry_;
    const TopologyEntities &topology_;
    model::Model &model_;
    std::vector<Damage> &damages_;
    std::map<std::pair<int64_t, int64_t>, int64_t> vertices_; // by list and index
};

// The coedges with keys from first_key on, in the order of keys: loops may have been reversed.
std::vector<const face::Coedge *> coedges_from(const face::Face &face, int64_t first_key, size_t count) {
    std::vector<const face::Coedge *> result(count, nullptr);
    for (const face::Loop &loop : face.loops()) {
        for (const face::Coedge &coedge : loop) {
            if (coedge.key >= first_key) {
                result[static_cast<size_t>(coedge.key - first_key)] = &coedge;
            }
        }
    }
    return result;
}

// Adds a vertex where each edge begins, which is also where the edge before it in the loop ends. Where the
// loop is open, an edge that ends elsewhere gets an end vertex of its own.
void add_vertices(const face::Face &face, const std::vector<OwnEdge> &edges, std::vector<model::Edge> &made,
                  model::Model &model) {
    const auto first = static_cast<size_t>(std::ssize(model.vertices));
    for (const model::Edge &edge : made) {
        const Place x = end_of(*edge.curve, false);
        model.vertices.push_back({x[0], x[1], x[2]});
    }
    for (size_t i = 0, start = 0; i < made.size(); ++i) {
        const bool last = i + 1 == made.size() || edges[i + 1].loop != edges[i].loop;
        size_t next = first + (last ? start : i + 1);
        const Place x = end_of(*made[i].curve, true);
        if (const Vector3 end{x[0], x[1], x[2]}; !(length(end - model.vertices[next]) <= face.tolerance())) {
            next = model.vertices.size();
            model.vertices.push_back(end);
        }
        made[i].vertices = {static_cast<int64_t>(first + i), static_cast<int64_t>(next)};
        start = last ? i + 1 : start;
    }
}

} // namespace

EdgeLists read_edges(Geometry &geometry, const TopologyEntities &topology, model::Model &model,
                     std::vector<Damage> &damages) {
    return EdgeReader(geometry, topology, model, damages).run();
}

void add_own_edges(Geometry &geometry, const face::Face &face, const std::vector<OwnEdge> &edges,
                   int64_t part, model::Model &model) {
    const std::vector<const face::Coedge *> coedges =
        coedges_from(face, std::ssize(model.edges) + 1, edges.size());
    std::vector<model::Edge> made;
    for (size_t i = 0; i < edges.size(); ++i) {
        model::Edge edge;
        edge.curve = face::edge_of(face, *coedges[i]);
        edge.shape = edges[i].shape;
        edge.part = part;
        geometry.entities().spend(Limits::size_of_a_shape + edge.curve->point_count() * edge.curve->width());
        made.push_back(std::move(edge));
    }
    add_vertices(face, edges, made, model);
    std::move(made.begin(), made.end(), std::back_inserter(model.edges));
}

} // namespace nrb::io::iges
