// SPDX-License-Identifier: MIT
// Vertices, edges and faces as they are written.
#pragma once

#include "io/step/write/write_geometry.h"
#include "io/written/topology.h"

#include <functional>
#include <map>
#include <vector>

namespace nrb::io::step {

class TopologyWriter {
public:
    // tolerances: of each part, in units of the model.
    TopologyWriter(GeometryWriter &geometry, const model::Model &model, const Topology &topology,
                   const std::vector<double> &tolerances);

    // Surfaces, edges, then faces, each in the order of the model. Throws what check_writable() does, naming the face.
    void run();

    // The numbers of the instances.
    [[nodiscard]] const std::vector<int64_t> &edges() const noexcept { return edges_; }
    [[nodiscard]] const std::vector<int64_t> &faces() const noexcept { return faces_; }

private:
    void add_surface(const model::ModelFace &face);
    [[nodiscard]] std::vector<std::vector<model::EdgeUse>> uses_of_edges() const;
    void add_edge(size_t index, const std::vector<model::EdgeUse> &uses);
    int64_t with_parameter_curves(int64_t curve, const model::CurvePiece &piece,
                                  const std::vector<model::EdgeUse> &uses);
    int64_t vertex(int64_t index);
    int64_t vertex_at(const Vector3 &at);
    void add_face(size_t index);
    [[nodiscard]] int64_t loop(const std::vector<OrientedEdge> &edges, bool against);
    int64_t vertex_loop(const Vector3 &at);

    GeometryWriter &geometry_;
    ExchangeText &text_;
    const model::Model &model_;
    const Topology &topology_;
    const std::vector<double> &tolerances_;
    struct WrittenSurface {
        int64_t number = 0;
        bool spline = false;
    };
    std::map<const void *, WrittenSurface> known_;
    std::vector<WrittenSurface> surfaces_; // of faces
    std::vector<int64_t> vertices_;        // 0: not written yet
    std::vector<int64_t> edges_;
    std::vector<int64_t> faces_;
};

} // namespace nrb::io::step
