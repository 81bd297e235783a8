// SPDX-License-Identifier: MIT
#include "io/iges/write/write_topology.h"

#include "io/faces/make_face.h"
#include "io/iges/types.h"
#include "io/written/lone_vertices.h"
#include "io/written/spline_facts.h"
#include "refine/forms/parametrization.h"

#include <algorithm>

namespace nrb::io::iges {
namespace {

constexpr int edge_of_loop = 0, vertex_of_loop = 1;
constexpr int list_form = 1, loop_form = 1, face_form = 1;

// By its control points; a closed axis has no ends.
bool is_inside(const Spline &curve, const face::Covering &covering) {
    for (int64_t i = 0; i < curve.point_count(); ++i) {
        for (const int k : {0, 1}) {
            const Interval domain = covering.domain(k);
            const double x = curve.coordinate(i, k);
            if (!covering.closed(k) && !(domain.lower <= x && x <= domain.upper)) {
                return false;
            }
        }
    }
    return true;
}

} // namespace

bool StatedShapes::any_edge() const noexcept {
    return std::ranges::any_of(edges, [](const auto &piece) { return piece.has_value(); });
}

bool StatedShapes::any_face() const noexcept {
    return std::ranges::find(faces, true) != faces.end();
}

TopologyWriter::TopologyWriter(GeometryWriter &geometry, LevelWriter &levels, const model::Model &model,
                               const Topology &topology, const StatedShapes &stated, double resolution)
    : geometry_(geometry), text_(geometry.text()), levels_(levels), model_(model), topology_(topology),
      stated_(stated), resolution_(resolution) {}

void TopologyWriter::run() {
    const auto count = std::ssize(model_.faces);
    Steps steps(std::ssize(topology_.edges) + count);
    add_vertices();
    add_edges(steps);
    const int64_t first = text_.reserve(count);
    for (int64_t i = 0; i < count; ++i) {
        faces_.push_back(first + 2 * i);
        add_face(static_cast<size_t>(i));
        steps.next();
    }
}

// The vertices of the topology, then those that only faces have.
void TopologyWriter::add_vertices() {
    std::vector<Vector3> all = topology_.vertices;
    for (size_t i = 0; i < model_.faces.size(); ++i) {
        std::vector<int64_t> &own = lone_vertices_.emplace_back();
        for (const Vector3 &at : lone_vertices(model_.faces[i], stated_.faces[i])) {
            all.push_back(at);
            own.push_back(std::ssize(all));
        }
    }
    if (all.empty()) {
        return;
    }
    vertex_list_ = text_.begin({vertex_list_type, list_form, dependent});
    text_.put(std::ssize(all));
    for (const Vector3 &at : all) {
        const double length = geometry_.length();
        text_.put(length * at.x, length * at.y, length * at.z);
    }
    text_.end();
}

int64_t TopologyWriter::edge_curve(size_t index) {
    const std::optional<model::CurvePiece> &piece = stated_.edges[index];
    return piece ? geometry_.curve(*piece) : geometry_.spline(*topology_.edges[index].curve);
}

void TopologyWriter::add_edges(Steps &steps) {
    std::vector<int64_t> curves(topology_.edges.size());
    for (size_t i = 0; i < curves.size(); ++i) {
        curves[i] = edge_curve(i);
        steps.next();
    }
    if (curves.empty()) {
        return;
    }
    edge_list_ = text_.begin({edge_list_type, list_form, dependent});
    text_.put(std::ssize(curves));
    for (size_t i = 0; i < curves.size(); ++i) {
        const auto &ends = topology_.edges[i].vertices;
        text_.put(curves[i], vertex_list_, ends[0] + 1, vertex_list_, ends[1] + 1);
    }
    text_.end();
}

// Each surface is written once, however many faces share it.
int64_t TopologyWriter::surface(size_t index) {
    const model::ModelFace &face = model_.faces[index];
    const bool shape = stated_.faces[index];
    const void *const key = shape ? static_cast<const void *>(face.shape.get()) : face.face->surface().get();
    const auto [known, fresh] = surfaces_.try_emplace(key);
    if (fresh) {
        if (!shape) {
            check_surface(*face.face->surface(), index, "IGES");
        }
        known->second = shape ? geometry_.surface(*face.shape) : geometry_.spline(*face.face->surface());
    }
    return known->second;
}

// Writes a curve in the domain only if it lies under the edge, and inside the domain unless the tolerance of
// the file, with which readers begin, suffices for the face. Surfaces that are not splines have other
// parameters in the standard, so their curves are left out. Readers make the curves that are missing.
int64_t TopologyWriter::parameter_curve(size_t index, const OrientedEdge &edge) {
    const face::Face &face = *model_.faces[index].face;
    const SplinePtr &along = topology_.edges[edge.edge].curve;
    const bool taken =
        !stated_.faces[index] &&
        (face.tolerance() <= resolution_ || is_inside(*edge.curve, face.covering())) &&
        lies_under(*face.surface(), *edge.curve, *(edge.along ? along : refine::reverse(*along, 0, false)),
                   face.tolerance());
    return taken ? geometry_.parameter_curve(*edge.curve) : 0;
}

int64_t TopologyWriter::loop(size_t face, size_t index) {
    const std::vector<OrientedEdge> &edges = topology_.loops[face][index];
    std::vector<int64_t> curves;
    curves.reserve(edges.size());
    for (const OrientedEdge &edge : edges) {
        curves.push_back(parameter_curve(face, edge));
    }
    const int64_t number = text_.begin({loop_type, loop_form, dependent});
    text_.put(std::ssize(edges));
    for (size_t i = 0; i < edges.size(); ++i) {
        text_.put(edge_of_loop, edge_list_, static_cast<int64_t>(edges[i].edge) + 1, edges[i].along ? 1 : 0);
        if (curves[i] == 0) {
            text_.put(0);
        } else {
            text_.put(1, 0, curves[i]); // one curve, not marked as isoparametric
        }
    }
    text_.end();
    return number;
}

int64_t TopologyWriter::vertex_loop(int64_t vertex) {
    return text_.add({loop_type, loop_form, dependent}, 1, vertex_of_loop, vertex_list_, vertex, 1, 0);
}

int64_t TopologyWriter::colour(const std::array<double, 3> &rgb) {
    const auto [known, fresh] = colours_.try_emplace(rgb);
    if (fresh) {
        known->second = text_.add({colour_type, 0, definition}, 100 * rgb[0], 100 * rgb[1], 100 * rgb[2],
                                  std::string_view()); // percentages
    }
    return known->second;
}

void TopologyWriter::add_face(size_t index) {
    const model::ModelFace &face = model_.faces[index];
    const int64_t on = surface(index), coloured = face.colour ? -colour(*face.colour) : 0;
    const int64_t level = levels_.level(face.layers);
    std::vector<int64_t> loops;
    for (size_t i = 0; i < topology_.loops[index].size(); ++i) {
        loops.push_back(loop(index, i));
    }
    for (const int64_t vertex : lone_vertices_[index]) {
        loops.push_back(vertex_loop(vertex));
    }
    text_.begin(faces_[index], {face_type, face_form, dependent, coloured, 0, level});
    text_.put(on, std::ssize(loops), loops.size() == 1 ? 1 : 0); // whether the first loop is the outer one
    for (const int64_t pointer : loops) {
        text_.put(pointer);
    }
    text_.end_named(face.name);
}

} // namespace nrb::io::iges
