// SPDX-License-Identifier: MIT
#include "io/written/topology.h"

#include "eval/curve_point.h"
#include "face/closing_segments.h"
#include "face/deviation.h"
#include "spline/part.h"

#include <array>
#include <map>

namespace nrb::io {
namespace {

Vector3 at_share(const Spline &curve, double share) {
    double x[3];
    eval::curve_point(curve, parameter_in(curve.axis(0).domain(), share), share == 1, x);
    return {x[0], x[1], x[2]};
}

// Whether a curve in the domain of a face runs in the direction of an edge instead of against it, judged by
// the distances of points at some parameters of both.
bool runs_along(const face::Face &face, const Spline &curve, const Spline &edge) {
    double along = 0, against = 0;
    for (const double share : {0.0, 0.2, 0.4, 0.7, 1.0}) {
        const double t = parameter_in(curve.axis(0).domain(), share);
        face::Point2 place;
        eval::curve_point(curve, t, false, place.data());
        const std::vector<double> x = face::point_at(*face.surface(), face.covering().in_domain(place));
        const Vector3 at{x[0], x[1], x[2]};
        along += nrb::length(at - at_share(edge, share));
        against += nrb::length(at - at_share(edge, 1 - share));
    }
    return along <= against;
}

class TopologyMaker {
public:
    explicit TopologyMaker(const model::Model &model) : model_(model) {
        result_.edges = model.edges;
        result_.vertices = model.vertices;
        for (int64_t i = 0; const Vector3 &at : model.vertices) {
            vertices_.try_emplace({at.x, at.y, at.z}, i++);
        }
    }

    Topology run() {
        for (const model::ModelFace &face : model_.faces) {
            auto &loops = result_.loops.emplace_back();
            for (const face::Loop &loop : face.face->loops()) {
                loops.emplace_back(loop.size(), OrientedEdge{none, true, nullptr});
            }
        }
        for (size_t e = 0; e < model_.edges.size(); ++e) {
            for (const model::EdgeUse &use : model_.edges[e].uses) {
                at(use).edge = e;
            }
        }
        for (size_t f = 0; f < model_.faces.size(); ++f) {
            orient(f);
        }
        for (model::Edge &edge : result_.edges) {
            end(edge);
        }
        for (size_t f = 0; f < model_.faces.size(); ++f) {
            close(f);
        }
        return std::move(result_);
    }

private:
    static constexpr size_t none = ~size_t{0};

    OrientedEdge &at(const model::EdgeUse &use) {
        return result_.loops[static_cast<size_t>(use.face)][static_cast<size_t>(use.loop)]
                            [static_cast<size_t>(use.index)];
    }
    void orient(size_t f) {
        const face::Face &face = *model_.faces[f].face;
        for (size_t i = 0; i < face.loops().size(); ++i) {
            for (size_t j = 0; j < face.loops()[i].size(); ++j) {
                const face::Coedge &coedge = face.loops()[i][j];
                OrientedEdge &made = result_.loops[f][i][j];
                made.curve = coedge.curve;
                if (made.edge == none) {
                    made.edge = result_.edges.size();
                    result_.edges.push_back({face::edge_of(face, coedge), nullptr});
                    result_.edges.back().part = model_.faces[f].part;
                    made.along = !coedge.against;
                    continue;
                }
                const SplinePtr &curve = result_.edges[made.edge].curve;
                made.along = curve == coedge.edge ? !coedge.against : runs_along(face, *coedge.curve, *curve);
            }
        }
    }
    // Closes the gaps of loops. Where consecutive edges meet at the same vertex there is no gap, wherever
    // their curves in the domain end.
    void close(size_t f) {
        const face::Face &face = *model_.faces[f].face;
        for (size_t i = 0; i < face.loops().size(); ++i) {
            const std::vector<SplinePtr> segments = face::closing_segments(face, face.loops()[i]);
            std::vector<OrientedEdge> &loop = result_.loops[f][i], closed;
            for (size_t j = 0; j < loop.size(); ++j) {
                closed.push_back(loop[j]);
                const int64_t from = vertex_of(loop[j], true),
                              to = vertex_of(loop[(j + 1) % loop.size()], false);
                if (segments[j] != nullptr && from != to) {
                    closed.push_back({result_.edges.size(), true, segments[j]});
                    result_.edges.push_back({face::edge_of(face, {segments[j], nullptr}),
                                             nullptr,
                                             {from, to},
                                             {},
                                             model_.faces[f].part});
                }
            }
            loop = std::move(closed);
        }
    }
    // The vertex at which the loop leaves an edge (`last`) or comes to it.
    [[nodiscard]] int64_t vertex_of(const OrientedEdge &oriented, bool last) const {
        return result_.edges[oriented.edge].vertices[oriented.along == last ? 1 : 0];
    }
    // Gives an edge the vertices that it lacks. Ends at equal points share a vertex.
    void end(model::Edge &edge) {
        for (const size_t upper : {0U, 1U}) {
            if (edge.vertices[upper] >= 0) {
                continue;
            }
            const Vector3 x = at_share(*edge.curve, static_cast<double>(upper));
            const auto [known, fresh] = vertices_.try_emplace({x.x, x.y, x.z}, std::ssize(result_.vertices));
            if (fresh) {
                result_.vertices.push_back(x);
            }
            edge.vertices[upper] = known->second;
        }
    }

    const model::Model &model_;
    Topology result_;
    std::map<std::array<double, 3>, int64_t> vertices_;
};

} // namespace

Topology topology_of(const model::Model &model) {
    return TopologyMaker(model).run();
}

} // namespace nrb::io
