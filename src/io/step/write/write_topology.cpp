// SPDX-License-Identifier: MIT
#include "io/step/write/write_topology.h"

#include "base/error.h"
#include "io/iges/text.h"
#include "io/step/write/edge_curves.h"
#include "io/step/write/write_spline.h"
#include "io/written/lone_vertices.h"
#include "io/written/spline_facts.h"
#include "spline/same_numbers.h"

#include <algorithm>

namespace nrb::io::step {
namespace {

// Whether a face is written on what its surface was in a file.
bool on_shape(const model::ModelFace &face) {
    return face.shape != nullptr && face.shape->kind != model::SurfaceKind::spline && restatable(*face.shape);
}

} // namespace

TopologyWriter::TopologyWriter(GeometryWriter &geometry, const model::Model &model, const Topology &topology,
                               const std::vector<double> &tolerances)
    : geometry_(geometry), text_(geometry.text()), model_(model), topology_(topology),
      tolerances_(tolerances), vertices_(topology.vertices.size()) {}

void TopologyWriter::run() {
    for (size_t i = 0; i < model_.faces.size(); ++i) {
        if (!on_shape(model_.faces[i])) {
            check_surface(*model_.faces[i].face->surface(), i, "STEP");
        }
        add_surface(model_.faces[i]);
    }
    const auto uses = uses_of_edges();
    Steps steps(std::ssize(uses) + std::ssize(model_.faces));
    for (size_t i = 0; i < uses.size(); ++i) {
        add_edge(i, uses[i]);
        steps.next();
    }
    for (size_t i = 0; i < model_.faces.size(); ++i) {
        add_face(i);
        steps.next();
    }
}

// Once, however many faces have it.
void TopologyWriter::add_surface(const model::ModelFace &face) {
    const bool shape = on_shape(face);
    const void *const key = shape ? static_cast<const void *>(face.shape.get()) : face.face->surface().get();
    const auto [known, fresh] = known_.try_emplace(key);
    if (fresh) {
        known->second = {shape ? geometry_.surface(*face.shape) : geometry_.spline(*face.face->surface()),
                         !shape};
    }
    surfaces_.push_back(known->second);
}

std::vector<std::vector<model::EdgeUse>> TopologyWriter::uses_of_edges() const {
    std::vector<std::vector<model::EdgeUse>> uses(topology_.edges.size());
    for (int64_t f = 0; f < std::ssize(topology_.loops); ++f) {
        const auto &loops = topology_.loops[static_cast<size_t>(f)];
        for (int64_t i = 0; i < std::ssize(loops); ++i) {
            const std::vector<OrientedEdge> &edges = loops[static_cast<size_t>(i)];
            for (int64_t j = 0; j < std::ssize(edges); ++j) {
                uses[edges[static_cast<size_t>(j)].edge].push_back({f, i, j});
            }
        }
    }
    return uses;
}

int64_t TopologyWriter::vertex_at(const Vector3 &at) {
    return text_.add("VERTEX_POINT", no_name, Ref{geometry_.point(at)});
}

int64_t TopologyWriter::vertex(int64_t index) {
    int64_t &number = vertices_[static_cast<size_t>(index)];
    if (number == 0) {
        number = vertex_at(topology_.vertices[static_cast<size_t>(index)]);
    }
    return number;
}

void TopologyWriter::add_edge(size_t index, const std::vector<model::EdgeUse> &uses) {
    const model::Edge &edge = topology_.edges[index];
    const auto end = [&](size_t i) { return topology_.vertices[static_cast<size_t>(edge.vertices[i])]; };
    const model::CurvePiece piece =
        stated_piece(edge, end(0), end(1), tolerances_[static_cast<size_t>(edge.part)]);
    const int64_t curve = with_parameter_curves(geometry_.curve(*piece.curve), piece, uses);
    const int64_t first = vertex(edge.vertices[0]), last = vertex(edge.vertices[1]);
    edges_.push_back(text_.add("EDGE_CURVE", no_name, Ref{first}, Ref{last}, Ref{curve}, piece.forward));
}

// Curves in the domains of surfaces that are splines here, for which readers take them. Of a seam the two are told apart only if
// they differ.
int64_t TopologyWriter::with_parameter_curves(int64_t curve, const model::CurvePiece &piece,
                                              const std::vector<model::EdgeUse> &uses) {
    struct Found {
        int64_t face;
        SplinePtr curve;
    };
    std::vector<Found> found;
    bool seam = false;
    for (const model::EdgeUse &use : uses) {
        const auto f = static_cast<size_t>(use.face), i = static_cast<size_t>(use.loop),
                   j = static_cast<size_t>(use.index);
        if (!surfaces_[f].spline) {
            continue;
        }
        const face::Face &face = *model_.faces[f].face;
        SplinePtr made = parameter_curve(face, topology_.loops[f][i][j], piece,
                                         tolerances_[static_cast<size_t>(model_.faces[f].part)]);
        const auto before = std::ranges::find(found, use.face, &Found::face);
        if (made == nullptr) {
            continue;
        }
        if (before != found.end() && same_numbers(*before->curve, *made)) {
            found.erase(before);
            continue;
        }
        seam = seam || before != found.end();
        found.push_back({use.face, std::move(made)});
    }
    if (found.empty()) {
        return curve;
    }
    std::vector<int64_t> numbers;
    numbers.reserve(found.size());
    for (const Found &one : found) {
        numbers.push_back(
            geometry_.parameter_curve(*one.curve, surfaces_[static_cast<size_t>(one.face)].number));
    }
    return text_.add(seam && found.size() == 2 ? "SEAM_CURVE" : "SURFACE_CURVE", no_name, Ref{curve},
                     Refs{numbers}, Word{".CURVE_3D."});
}

// Around the face as its own normal sees it.
int64_t TopologyWriter::loop(const std::vector<OrientedEdge> &edges, bool against) {
    std::vector<int64_t> oriented;
    for (size_t i = 0; i < edges.size(); ++i) {
        const OrientedEdge &edge = edges[against ? edges.size() - 1 - i : i];
        oriented.push_back(text_.add("ORIENTED_EDGE", no_name, derived, derived, Ref{edges_[edge.edge]},
                                     edge.along != against));
    }
    return text_.add("EDGE_LOOP", no_name, Refs{oriented});
}

int64_t TopologyWriter::vertex_loop(const Vector3 &at) {
    return text_.add("VERTEX_LOOP", no_name, Ref{vertex_at(at)});
}

void TopologyWriter::add_face(size_t index) {
    const model::ModelFace &face = model_.faces[index];
    std::vector<int64_t> loops;
    for (const std::vector<OrientedEdge> &edges : topology_.loops[index]) {
        loops.push_back(loop(edges, face.against));
    }
    for (const Vector3 &at : lone_vertices(face, on_shape(face))) {
        loops.push_back(vertex_loop(at));
    }
    std::vector<int64_t> bounds;
    bounds.reserve(loops.size());
    for (const int64_t number : loops) {
        bounds.push_back(
            text_.add(loops.size() == 1 ? "FACE_OUTER_BOUND" : "FACE_BOUND", no_name, Ref{number}, true));
    }
    const int64_t number = text_.reserve();
    text_.add_as(number, "ADVANCED_FACE", Text{stated_name(face.name, number)}, Refs{bounds},
                 Ref{surfaces_[index].number}, !face.against);
    faces_.push_back(number);
}

} // namespace nrb::io::step
