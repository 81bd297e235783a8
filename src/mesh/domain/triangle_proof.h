// SPDX-License-Identifier: MIT
// How far triangles of a domain are from the surface, each by itself.
#pragma once

#include "mesh/cells/piece_bound.h"
#include "mesh/domain/border_strip.h"

#include <map>
#include <unordered_map>

namespace nrb::mesh {

// A triangle in a cell, or in the strip along the border, where sides may be segments of this.
struct SiteTriangle {
    std::array<int32_t, 3> sites;
    int32_t cell = -1;
    std::array<int32_t, 3> border{-1, -1, -1};
    std::array<bool, 3> fixed{};
};

struct ProvenTriangle {
    TriangleBound bound;
    double moved = 0; // besides: by how much the surface is moved so that it has the corners
    double over = 0;  // and what is between sides and curves of the border from that over the sides
};

class TriangleProof {
public:
    // `chord`: what is within it needs no better proof.
    TriangleProof(const MeshDomain &domain, const CellGrid &cells, const Sites &sites, double chord);

    // Bounds of the strip are kept: most triangles stay from one round to the next. In units of the grid.
    [[nodiscard]] ProvenTriangle of(const SiteTriangle &triangle);
    // Where segments of the border have new numbers: what is known of those that stayed stays known.
    void take_border();

private:
    using Key = std::array<int32_t, 6>;
    using SegmentKey = std::array<uint64_t, 7>; // its ends, and what is between it and its curve, bit for bit
    struct Hash {
        size_t operator()(const Key &key) const noexcept;
    };
    // A triangle with the part of the domain around it.
    struct Placed {
        std::array<TriangleCorner, 3> corners;
        Rectangle part;
        double moved = 0; // the most of its corners
    };
    [[nodiscard]] Placed placed(const SiteTriangle &triangle) const;
    [[nodiscard]] ProvenTriangle in_cell(const SiteTriangle &triangle);
    [[nodiscard]] ProvenTriangle in_strip(const SiteTriangle &triangle);
    using Moves = std::array<double, 3>; // of places between sides and curves of the border, from these sides
    [[nodiscard]] TriangleBound over_cells(const Placed &placed, int32_t block, const SiteTriangle &triangle,
                                           Moves &moves) const;
    // Ways are counted up to so many sides of the cell.
    [[nodiscard]] Moves moves_over(const SiteTriangle &triangle, const HessianBox &box, const Rectangle &cell,
                                   double most = infinity) const;
    [[nodiscard]] std::vector<Interval> in_blocks(const Rectangle &part, size_t k) const;
    [[nodiscard]] Moves moves_in_blocks(const SiteTriangle &triangle, const Rectangle &part);
    [[nodiscard]] std::array<double, 3> shares_of_step(const SiteTriangle &triangle, const Placed &placed,
                                                       size_t side) const noexcept;
    [[nodiscard]] static double moved_between(const Placed &placed, const TriangleBound &bound) noexcept;
    [[nodiscard]] double moved_beyond(const Rectangle &part, const Rectangle &block) const noexcept;
    // one_block: whether curves of the border stay in that of the triangle.
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
    std::map<SegmentKey, int32_t> numbers_; // of all segments that there were
    std::vector<int32_t> own_numbers_;      // of those of the border
};

} // namespace nrb::mesh
