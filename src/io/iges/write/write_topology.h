// SPDX-License-Identifier: MIT
// Writes vertices, edges and faces.
#pragma once

#include "base/watch.h"
#include "io/iges/write/write_geometry.h"
#include "io/iges/write/write_levels.h"
#include "io/written/topology.h"

#include <map>
#include <optional>
#include <vector>

namespace nrb::io::iges {

// The edges and faces that are written with a shape instead of their spline.
struct StatedShapes {
    std::vector<std::optional<model::CurvePiece>> edges; // by edge of the topology
    std::vector<bool> faces; // by face of the model: whether with the shape of the surface

    [[nodiscard]] bool any_edge() const noexcept;
    [[nodiscard]] bool any_face() const noexcept;
};

class TopologyWriter {
public:
    // resolution: that of the file, in units of the model.
    TopologyWriter(GeometryWriter &geometry, LevelWriter &levels, const model::Model &model,
                   const Topology &topology, const StatedShapes &stated, double resolution);

    // Writes one list of vertices, one of edges, and the faces in the order of the model.
    void run();

    // The pointers of the faces, which are consecutive.
    [[nodiscard]] const std::vector<int64_t> &faces() const noexcept { return faces_; }

private:
    void add_vertices();
    void add_edges(Steps &steps);
    [[nodiscard]] int64_t edge_curve(size_t index);
    int64_t surface(size_t index);
    int64_t parameter_curve(size_t index, const OrientedEdge &edge);
    int64_t loop(size_t face, size_t index);
    int64_t vertex_loop(int64_t vertex);
    int64_t colour(const std::array<double, 3> &rgb);
    void add_face(size_t index);

    GeometryWriter &geometry_;
    FileText &text_;
    LevelWriter &levels_;
    const model::Model &model_;
    const Topology &topology_;
    const StatedShapes &stated_;
    double resolution_;
    int64_t vertex_list_ = 0, edge_list_ = 0;
    std::vector<std::vector<int64_t>> lone_vertices_; // of faces, numbered from 1
    std::map<const void *, int64_t> surfaces_;
    std::map<std::array<double, 3>, int64_t> colours_;
    std::vector<int64_t> faces_;
};

} // namespace nrb::io::iges
