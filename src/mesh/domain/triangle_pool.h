// SPDX-License-Identifier: MIT
// The triangles of a domain and their distances, kept from round to round.
#pragma once

#include "mesh/domain/triangle_proof.h"
#include "mesh/proof/mesh_bound.h"

#include <span>
#include <vector>

namespace nrb::mesh {

// Multiply-adds of a triangle, estimated.
constexpr int64_t work_of_triangle = 1400;

// Triangles that stay keep their numbers, and their distances where no triangle around them changed. The
// bounds of single triangles take much more memory than these: they are made part by part, for some thousand
// triangles at once, and once more for the triangles beside a part.
class TrianglePool {
public:
    struct Range {
        int32_t first = 0, count = 0;
    };

    // Reserves memory for so many more.
    void make_room(size_t count);
    // Adds a triangle: of a cell, or after begin_strip() of the strip. Ranges of triangles can be removed.
    void add(const SiteTriangle &triangle, const MeshTriangle &meshed);
    void remove(const Range &range);
    // Triangles of the strip come last: all that are added from here on belong to it, until it is dropped.
    void begin_strip() noexcept { strip_ = sites_.size(); }
    void drop_strip();
    [[nodiscard]] size_t strip() const noexcept { return strip_; }

    // Bounds the distances of all new triangles, and of all that have a point in common with new or removed
    // ones. points: how many there are; enough, allowed: as for PartProof::prove().
    void prove(TriangleProof &proof, size_t points, double enough, double allowed);

    // Numbers go up to size(); has() tells which of them are triangles.
    [[nodiscard]] size_t size() const noexcept { return sites_.size(); }
    [[nodiscard]] bool has(size_t i) const noexcept { return sites_[i].sites[0] >= 0; }
    [[nodiscard]] SiteTriangle operator[](size_t i) const noexcept;
    [[nodiscard]] const MeshTriangle &meshed(size_t i) const noexcept { return meshed_[i]; }
    // In units of the grid; they include what moves corners off the surface.
    [[nodiscard]] Distances distances(size_t i) const noexcept {
        return {static_cast<double>(distances_[i].from_shape), static_cast<double>(distances_[i].from_mesh)};
    }

private:
    struct CellSites {
        std::array<int32_t, 3> sites;
        int32_t cell;
    };
    // Of a triangle of the strip.
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
    std::vector<char> touched_; // points of triangles that were added or removed
    size_t strip_ = 0;
};

} // namespace nrb::mesh
