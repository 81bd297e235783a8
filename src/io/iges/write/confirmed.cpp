// SPDX-License-Identifier: MIT
#include "io/iges/write/confirmed.h"

#include "base/error.h"
#include "base/watch.h"
#include "io/iges/lines.h"
#include "io/iges/read_model.h"
#include "io/iges/types.h"
#include "io/written/edge_piece.h"
#include "spline/same_numbers.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace nrb::io::iges {
namespace {

// Reads a file back. A file that cannot be read confirms nothing.
model::Model read_again(const std::string &text) {
    try {
        return read_iges_model(text, {});
    } catch (const Error &) {
        return {};
    }
}

constexpr double rounding = 0x1p-48; // tolerance for knots that were transformed

// Equal up to a linear change of the parameter, which a straight line and the curves under it may undergo.
bool same_course(const Spline &a, const Spline &b) {
    if (same_numbers(a, b)) {
        return true;
    }
    const KnotVector &p = a.axis(0), &q = b.axis(0);
    const Interval from = p.domain(), to = q.domain();
    const auto share = [](Interval domain, double t) {
        return (t - domain.lower) / (domain.upper - domain.lower);
    };
    return p.degree() == q.degree() && p.periodic() == q.periodic() &&
           std::ranges::equal(a.points(), b.points()) && std::ranges::equal(a.weights(), b.weights()) &&
           std::ranges::equal(p.knots(), q.knots(), [&](double s, double t) {
               return std::abs(share(from, s) - share(to, t)) <= rounding;
           });
}

bool same_face(const face::Face &a, const face::Face &b) {
    return same_numbers(*a.surface(), *b.surface()) &&
           std::ranges::equal(a.loops(), b.loops(), [](const face::Loop &one, const face::Loop &other) {
               return std::ranges::equal(one, other, [](const face::Coedge &x, const face::Coedge &y) {
                   return same_course(*x.curve, *y.curve);
               });
           });
}

// The text that is written for a shape.
template <class Write>
std::string statement(const Write &write) {
    FileText text;
    GeometryWriter geometry(text, 1);
    write(geometry);
    return text.file(Parameters(data_columns));
}
std::string statement_of(const model::CurvePiece &piece) {
    return statement([&](GeometryWriter &geometry) { geometry.curve(piece); });
}
std::string statement_of(const model::SurfaceShape &surface) {
    return statement([&](GeometryWriter &geometry) { geometry.surface(surface); });
}

// The part of a curve between the vertices of an edge, if there is an entity for it.
std::optional<model::CurvePiece> statable_piece(const model::Edge &edge, const std::vector<Vector3> &vertices,
                                                double tolerance) {
    if (edge.shape == nullptr || edge.shape->kind == model::CurveKind::spline) {
        return std::nullopt;
    }
    const auto end = [&](size_t k) { return vertices[static_cast<size_t>(edge.vertices[k])]; };
    std::optional<model::CurvePiece> piece = piece_of_shape(edge, end(0), end(1), tolerance);
    return piece && statable(*piece) ? piece : std::nullopt;
}

// The piece that readers reconstruct, if it gives the same spline. They read a line as a spline, which is
// written as that line again.
std::optional<model::CurvePiece> read_piece(const model::CurvePiece &piece, const Spline &curve,
                                            const model::Edge &read, const std::vector<Vector3> &vertices,
                                            double tolerance) {
    if (is_line(piece)) {
        return same_course(*read.curve, curve) ? std::optional(piece) : std::nullopt;
    }
    return same_numbers(*read.curve, curve) ? statable_piece(read, vertices, tolerance) : std::nullopt;
}

} // namespace

StatedShapes statable_shapes(const model::Model &model, const Topology &topology, double tolerance) {
    StatedShapes stated{std::vector<std::optional<model::CurvePiece>>(topology.edges.size()),
                        std::vector<bool>(model.faces.size(), false)};
    for (size_t i = 0; i < topology.edges.size(); ++i) {
        stated.edges[i] = statable_piece(topology.edges[i], topology.vertices, tolerance);
    }
    for (size_t i = 0; i < model.faces.size(); ++i) {
        const model::SurfaceShapePtr &shape = model.faces[i].shape;
        stated.faces[i] = shape != nullptr && statable(*shape);
    }
    return stated;
}

void confirm_edges(const WriteEdges &write, const Topology &topology, double tolerance,
                   StatedShapes &stated) {
    constexpr int most_rounds = 4;
    bool settled = false;
    for (int round = 0; !settled && stated.any_edge(); ++round) {
        const Phase phase;
        const model::Model read = read_again(write(stated));
        const bool whole = read.edges.size() == topology.edges.size();
        settled = true;
        for (size_t i = 0; i < stated.edges.size(); ++i) {
            std::optional<model::CurvePiece> &piece = stated.edges[i];
            std::optional<model::CurvePiece> next;
            if (piece && whole) {
                next = read_piece(*piece, *topology.edges[i].curve, read.edges[i], read.vertices, tolerance);
            }
            const bool same = next && statement_of(*next) == statement_of(*piece);
            piece = same || round < most_rounds ? std::move(next) : std::nullopt;
            settled = settled && (same || !piece);
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
        stated.faces[i] = stated.faces[i] && found != faces.end() &&
                          same_face(*found->second->face, *model.faces[i].face) &&
                          statement_of(*found->second->shape) == statement_of(*model.faces[i].shape);
    }
}

} // namespace nrb::io::iges
