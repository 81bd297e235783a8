// SPDX-License-Identifier: MIT
// Reads the loops that bound a face.
#pragma once

#include "io/iges/geometry/geometry.h"
#include "io/iges/model/topology.h"

#include <vector>

namespace nrb::io::iges {

// A curve of a boundary in space: an edge that faces may share, or one of the face alone, in the direction of
// the boundary.
struct SpaceCurve {
    SplinePtr spline;
    model::CurveShapePtr shape; // null: only the spline is known
    int64_t edge = -1;          // index in the model; -1: belongs to the face alone
    bool against = false;       // whether it runs against the boundary
};

// One boundary in space and in the domain. Either may be missing, and they may be divided at different
// places.
struct LoopSource {
    std::vector<SpaceCurve> edges;
    std::vector<SplinePtr> curves; // in the parameters of the surface's shape; null: to be made from the edge
    bool domain_rules = false;     // whether the file prefers the curves in the domain

    [[nodiscard]] bool both() const noexcept { return !edges.empty() && !curves.empty(); }
};

// An edge of a list (504) in the model.
struct ListedEdge {
    SplinePtr spline; // null: could not be read
    int64_t index = -1;
};
using EdgeLists = std::map<int64_t, std::vector<ListedEdge>>;

// The functions throw Error if neither the curves in space nor those in the domain can be read:
// Status::syntax, unsupported.
class LoopReader {
public:
    LoopReader(Geometry &geometry, const TopologyEntities &topology, const Surface &surface) noexcept
        : geometry_(geometry), topology_(topology), surface_(surface) {}

    LoopSource curve_on_surface(int64_t pointer);
    LoopSource boundary(int64_t pointer);
    // A loop (508). Its vertices are poles, which have no curves.
    LoopSource loop(int64_t pointer, const EdgeLists &lists);
    // A closed curve that is given in space only.
    LoopSource closed_curve(int64_t pointer);
    // The vertices of the loops read so far.
    [[nodiscard]] const std::vector<Vector3> &poles() const noexcept { return poles_; }

private:
    template <class Edges, class Curves>
    LoopSource either(Edges &&edges, Curves &&curves);
    void add_edges(int64_t pointer, bool reversed, std::vector<SpaceCurve> &edges);
    void add_curves(const std::vector<int64_t> &pointers, std::vector<SplinePtr> &curves);
    void add_curves_of(const std::vector<EdgeReference> &references, std::vector<SplinePtr> &curves);
    void add_edge(const EdgeReference &reference, const EdgeLists &lists, std::vector<SpaceCurve> &edges);
    SplinePtr spline(const model::CurvePiece &piece);

    Geometry &geometry_;
    const TopologyEntities &topology_;
    const Surface &surface_;
    std::vector<Vector3> poles_;
};

} // namespace nrb::io::iges
