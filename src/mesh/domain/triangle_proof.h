// SPDX-License-Identifier: MIT
// Bounds how far triangles of a domain are from the surface, each by itself.
#pragma once

#include "mesh/cells/piece_bound.h"
#include "mesh/domain/border_strip.h"

#include <map>
#include <unordered_map>

namespace nrb::mesh {

// A triangle of a cell, or of the strip along the border, where its sides may be segments of the border.
struct SiteTriangle {
    std::array<int32_t, 3> sites;
    int32_t cell = -1;                         // -1: of the strip
    std::array<int32_t, 3> border{-1, -1, -1}; // segments on the sides opposite the sites, -1: none
    std::array<bool, 3> fixed{};               // sides that may not be divided
};

struct ProvenTriangle {
    TriangleBound bound;
    // What comes on top of the bound. moved: by how much the surface has to be moved to pass through the
    // corners; over: the same, and how far what is between sides and curves of the border is from the surface
    // over these sides.
    double moved = 0;
    double over = 0;
};

class TriangleProof {
public:
    // `chord`: distances within it need no tighter bound.
    TriangleProof(const MeshDomain &domain, const CellGrid &cells, const Sites &sites, double chord);

    // Whether bounds of triangles of cells are kept. It pays where most of them are asked for again.
    void keep(bool all) noexcept { keeps_ = all; }
    // In units of the grid. Bounds of triangles of the strip are kept, since most of these stay from one
    // round to the next.
    [[nodiscard]] ProvenTriangle of(const SiteTriangle &triangle);
    // Takes over a border whose segments have new numbers. The bounds of triangles at segments that did not
    // change stay known.
    void take_border();

private:
    using Key = std::array<int32_t, 6>;
    // The ends of a segment, and the step to its curve, bit for bit.
    using SegmentKey = std::array<uint64_t, 7>;
    struct Hash {
        size_t operator()(const Key &key) const noexcept;
    };
    // The corners of a triangle in the frame of the grid, and its bounding box in the domain.
    struct Placed {
        std::array<TriangleCorner, 3> corners;
        Rectangle part;
        double moved = 0; // how far corners are off the surface at most
    };
    [[nodiscard]] Placed placed(const SiteTriangle &triangle) const;
    [[nodiscard]] ProvenTriangle in_cell(const SiteTriangle &triangle);
    [[nodiscard]] ProvenTriangle known_in_cell(const SiteTriangle &triangle);
    [[nodiscard]] ProvenTriangle in_strip(const SiteTriangle &triangle);
    // For each side, how far in space places between it and its curve of the border are from it.
    using Moves = std::array<double, 3>;
    [[nodiscard]] TriangleBound over_cells(const Placed &placed, int32_t block, const SiteTriangle &triangle,
                                           Moves &moves) const;
    // most: no step counts for more than so many sides of the cell along an axis.
    [[nodiscard]] Moves moves_over(const SiteTriangle &triangle, const HessianBox &box, const Rectangle &cell,
                                   double most = infinity) const;
    [[nodiscard]] std::vector<Interval> in_blocks(const Rectangle &part, size_t k) const;
    [[nodiscard]] Moves moves_in_blocks(const SiteTriangle &triangle, const Rectangle &part);
    [[nodiscard]] std::array<double, 3> shares_of_step(const SiteTriangle &triangle, const Placed &placed,
                                                       size_t side) const noexcept;
    [[nodiscard]] static double moved_between(const Placed &placed, const TriangleBound &bound) noexcept;
    [[nodiscard]] double moved_beyond(const Rectangle &part, const Rectangle &block) const noexcept;
    // one_block: whether the curves of the border stay in the block of the triangle.
    void set_edge(const SiteTriangle &triangle, const Placed &placed, const Moves &moves, bool one_block,
                  TriangleBound &bound) const noexcept;
    void widen(const SiteTriangle &triangle, Rectangle &part) const noexcept;

    const MeshDomain &domain_;
    const CellGrid &cells_;
    const Sites &sites_;
    const pieces::PieceGrid &grid_;
    double chord_;
    CellNets nets_;
    PieceBound by_pieces_;
    std::unordered_map<Key, ProvenTriangle, Hash> known_;
    // Bounds of triangles of cells, which the next round asks for again: nearly all of a small mesh. If the cell of a
    // triangle was divided, they are no longer the best. kept_at_: the number of the bound for each value of a hash of
    // the sites, -1: none.
    struct Kept {
        std::array<int32_t, 3> sites{-1, -1, -1};
        Rectangle cell;
        ProvenTriangle proven;
    };
    std::vector<Kept> kept_;
    std::vector<int32_t> kept_at_;
    bool keeps_ = false;
    std::map<SegmentKey, int32_t> numbers_; // of all segments that there ever were
    std::vector<int32_t> own_numbers_;      // of the segments of the present border
};

} // namespace nrb::mesh
