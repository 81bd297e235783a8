// SPDX-License-Identifier: MIT
// Distances of some triangles of a mesh, which those around them count for.
#pragma once

#include "mesh/domain/triangle_proof.h"
#include "mesh/proof/mesh_bound.h"

#include <functional>
#include <span>
#include <vector>

namespace nrb::mesh {

// Goes on with the working memory of the parts before.
class PartProof {
public:
    using TriangleOf = std::function<SiteTriangle(size_t)>;
    // triangles: by their points, of which there are so many; wanted: those of all parts.
    PartProof(TriangleProof &proof, size_t points, std::span<const MeshTriangle> triangles,
              std::span<const int32_t> wanted, TriangleOf triangle_of);

    // With what moves corners; 0: no distance is enough. Neighbours in space are best near each other.
    void prove(std::span<const int32_t> wanted, double enough, std::vector<Distances> &out);

private:
    [[nodiscard]] int32_t local_point(int32_t point);
    void gather(std::span<const int32_t> wanted);
    void add_triangle(int32_t triangle);
    void set_offs();
    void bound();

    TriangleProof &proof_;
    std::span<const MeshTriangle> all_;
    PointFans fans_;
    TriangleOf triangle_of_;
    std::vector<int32_t> own_points_, own_triangles_; // their numbers here; -1: not here
    // Here.
    std::vector<int32_t> points_, triangles_; // their numbers in the mesh
    std::vector<MeshTriangle> meshed_;
    std::vector<TriangleBound> bounds_;
    // How far a mesh on the surface is from the one that there is, and from what that stands for: corners, and these with what is between sides
    // and curves of the border.
    struct Off {
        double moved = 0, over = 0;
        void add(const Off &other) noexcept;
    };
    std::vector<Off> offs_;       // of triangles
    std::vector<Off> point_offs_; // the most of those around
};

} // namespace nrb::mesh
