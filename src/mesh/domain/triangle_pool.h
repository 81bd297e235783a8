// SPDX-License-Identifier: MIT
// The triangles of a domain, round by round.
#pragma once

#include "mesh/domain/triangle_proof.h"
#include "mesh/proof/mesh_bound.h"

#include <span>
#include <vector>

namespace nrb::mesh {

// Those that stay keep their places and their bounds, and their distances where none around them changed.
class TrianglePool {
public:
    struct Range {
        size_t first = 0, count = 0;
    };

    // Those of cells, which can be removed later.
    void add(const SiteTriangle &triangle, const MeshTriangle &meshed);
    void remove(const Range &range);
    // The strip is behind all others: what is added from here on is of it, until it is dropped.
    void begin_strip() noexcept { strip_ = triangles_.size(); }
    void drop_strip();

    // Of all that are new, and of those beside them. points: how many there are.
    void prove(TriangleProof &proof, size_t points);

    // The numbers of those that are there.
    [[nodiscard]] size_t size() const noexcept { return triangles_.size(); }
    [[nodiscard]] bool has(size_t i) const noexcept { return triangles_[i].sites[0] >= 0; }
    [[nodiscard]] const SiteTriangle &operator[](size_t i) const noexcept { return triangles_[i]; }
    [[nodiscard]] const MeshTriangle &meshed(size_t i) const noexcept { return meshed_[i]; }
    // In units of the grid, with what moves corners.
    [[nodiscard]] const Distances &distances(size_t i) const noexcept { return distances_[i]; }

private:
    void touch(size_t i);
    void prove_new(TriangleProof &proof);
    [[nodiscard]] std::vector<char> beside_touched(size_t points) const;
    [[nodiscard]] std::vector<double> overs_around(size_t points) const;

    std::vector<SiteTriangle> triangles_;
    std::vector<MeshTriangle> meshed_;
    std::vector<TriangleBound> bounds_;
    std::vector<double> overs_; // -1: not proven yet
    std::vector<Distances> distances_;
    std::vector<int32_t> touched_; // points
    size_t strip_ = 0;
};

} // namespace nrb::mesh
