// SPDX-License-Identifier: MIT
// Bounds the distances of some triangles of a mesh, to which the triangles around them contribute.
#pragma once

#include "mesh/domain/triangle_proof.h"
#include "mesh/proof/mesh_bound.h"

#include <functional>
#include <span>
#include <vector>

namespace nrb::mesh {

// Works part by part, and uses its working memory again for each part.
class PartProof {
public:
    using TriangleOf = std::function<SiteTriangle(size_t)>;
    // triangles: of the whole mesh, by their points; points: how many there are; wanted: the triangles of all
    // parts; triangle_of: the sites of a triangle.
    PartProof(TriangleProof &proof, size_t points, std::span<const MeshTriangle> triangles,
              std::span<const int32_t> wanted, TriangleOf triangle_of);

    // Bounds the distances of the wanted triangles of a part, including what moves their corners off the
    // surface. Distances up to `enough` need no tighter bound; 0: all are bounded more tightly. What takes long
    // is done only for distances above `allowed`. It is fastest if triangles that are neighbours in space are near each other in the order.
    void prove(std::span<const int32_t> wanted, double enough, double allowed, std::vector<Distances> &out);

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
    std::vector<int32_t> own_points_, own_triangles_; // their numbers in the part; -1: not in it
    // The part: the wanted triangles and those around them.
    std::vector<int32_t> points_, triangles_; // numbers in the mesh
    std::vector<MeshTriangle> meshed_;
    std::vector<TriangleBound> bounds_;
    // Bounds hold for a mesh with its corners on the surface. moved: how far the actual mesh is from that
    // one, since its corners are moved off the surface; over: the same, plus what is between sides and curves
    // of the border.
    struct Off {
        double moved = 0, over = 0;
        void add(const Off &other) noexcept;
    };
    std::vector<Off> offs_;       // of triangles
    std::vector<Off> point_offs_; // of points: the maximum over the triangles around
};

} // namespace nrb::mesh
