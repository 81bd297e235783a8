// SPDX-License-Identifier: MIT
// The triangles of a domain, round by round.
#pragma once

#include "mesh/domain/triangle_proof.h"
#include "mesh/proof/mesh_bound.h"

#include <span>
#include <vector>

namespace nrb::mesh {

// Those that stay keep their places, and their distances where none around them changed. Bounds of single triangles take much more room
// than these: they are made part by part, for some thousand triangles at once, and again for those beside a part.
// Multiply-adds of a triangle, estimated.
constexpr int64_t work_of_triangle = 1400;

class TrianglePool {
public:
    struct Range {
        int32_t first = 0, count = 0;
    };

    // For so many more.
    void make_room(size_t count);
    // Those of cells, which can be removed later.
    void add(const SiteTriangle &triangle, const MeshTriangle &meshed);
    void remove(const Range &range);
    // The strip is behind all others: what is added from here on is of it, until it is dropped.
    void begin_strip() noexcept { strip_ = sites_.size(); }
    void drop_strip();
    [[nodiscard]] size_t strip() const noexcept { return strip_; }

    // Of all that are new, and of those beside them. points: how many there are; enough: what is not more is not looked at more closely.
    void prove(TriangleProof &proof, size_t points, double enough);

    // The numbers of those that are there.
    [[nodiscard]] size_t size() const noexcept { return sites_.size(); }
    [[nodiscard]] bool has(size_t i) const noexcept { return sites_[i].sites[0] >= 0; }
    [[nodiscard]] SiteTriangle operator[](size_t i) const noexcept;
    [[nodiscard]] const MeshTriangle &meshed(size_t i) const noexcept { return meshed_[i]; }
    // In units of the grid, with what moves corners.
    [[nodiscard]] Distances distances(size_t i) const noexcept {
        return {static_cast<double>(distances_[i].from_shape), static_cast<double>(distances_[i].from_mesh)};
    }

private:
    struct CellSites {
        std::array<int32_t, 3> sites;
        int32_t cell;
    };
    // Of triangles of the strip.
    struct Borders {
        std::array<int32_t, 3> border;
        std::array<bool, 3> fixed;
    };
    // Rounded upwards.
    struct Rounded {
        float from_shape = 0, from_mesh = 0;
    };
    void touch(size_t i);
    [[nodiscard]] std::vector<int32_t> beside_touched(size_t points);

    std::vector<CellSites> sites_;
    std::vector<Borders> borders_;
    std::vector<MeshTriangle> meshed_;
    std::vector<Rounded> distances_;
    std::vector<char> touched_; // points
    size_t strip_ = 0;
};

} // namespace nrb::mesh
