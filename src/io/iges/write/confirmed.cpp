// SPDX-License-Identifier: MIT
#include "io/iges/write/confirmed.h"

#include "base/error.h"
#include "io/iges/read_model.h"
#include "io/iges/types.h"
#include "io/written/edge_piece.h"
#include "spline/same_numbers.h"

#include <algorithm>
#include <unordered_map>

namespace nrb::io::iges {
namespace {

// A file that cannot be read confirms nothing.
model::Model read_again(const std::string &text) {
    try {
        return read_iges_model(text, {});
    } catch (const Error &) {
        return {};
    }
}

bool same_loops(const face::Face &a, const face::Face &b) {
    return std::ranges::equal(a.loops(), b.loops(), [](const face::Loop &one, const face::Loop &other) {
        return std::ranges::equal(one, other, [](const face::Coedge &x, const face::Coedge &y) {
            return same_numbers(*x.curve, *y.curve);
        });
    });
}

bool same_face(const face::Face &a, const face::Face &b) {
    return same_numbers(*a.surface(), *b.surface()) && same_loops(a, b);
}

} // namespace

StatedShapes statable_shapes(const model::Model &model, const Topology &topology, double tolerance) {
    StatedShapes stated{std::vector<std::optional<model::CurvePiece>>(topology.edges.size()),
                        std::vector<bool>(model.faces.size(), false)};
    for (size_t i = 0; i < topology.edges.size(); ++i) {
        const model::Edge &edge = topology.edges[i];
        if (edge.shape == nullptr || edge.shape->kind == model::CurveKind::spline) {
            continue;
        }
        const auto end = [&](size_t k) { return topology.vertices[static_cast<size_t>(edge.vertices[k])]; };
        std::optional<model::CurvePiece> piece = piece_of_shape(edge, end(0), end(1), tolerance);
        if (piece && statable(*piece)) {
            stated.edges[i] = std::move(piece);
        }
    }
    for (size_t i = 0; i < model.faces.size(); ++i) {
        const model::SurfaceShapePtr &shape = model.faces[i].shape;
        stated.faces[i] = shape != nullptr && statable(*shape);
    }
    return stated;
}

void confirm_edges(const std::string &text, const Topology &topology, StatedShapes &stated) {
    const model::Model read = read_again(text);
    const bool whole = read.edges.size() == topology.edges.size();
    for (size_t i = 0; i < stated.edges.size(); ++i) {
        if (!whole || !same_numbers(*read.edges[i].curve, *topology.edges[i].curve)) {
            stated.edges[i].reset();
        }
    }
}

void confirm_faces(const std::string &text, const model::Model &model, const std::vector<int64_t> &pointers,
                   StatedShapes &stated) {
    const model::Model read = read_again(text);
    std::unordered_map<std::string, const model::ModelFace *> faces;
    for (const model::ModelFace &face : read.faces) {
        faces.emplace(face.name, &face);
    }
    for (size_t i = 0; i < pointers.size(); ++i) {
        const auto found = faces.find(usual_name(face_type, pointers[i]));
        stated.faces[i] =
            stated.faces[i] && found != faces.end() && same_face(*found->second->face, *model.faces[i].face);
    }
}

} // namespace nrb::io::iges
