// SPDX-License-Identifier: MIT
// How far triangles of a domain are from the surface, each by itself.
#pragma once

#include "mesh/cells/piece_bound.h"
#include "mesh/domain/border_strip.h"

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
    double over =
        0; // besides: how far the corners, and what is between sides and curves of the border, are from the surface over it
};

class TriangleProof {
public:
    // `chord`: what is within it needs no better proof.
    TriangleProof(const MeshDomain &domain, const CellGrid &cells, const Sites &sites, double chord);

    // Distances that are enough; 0: the best that there are.
    void set_enough(double enough) noexcept { enough_ = enough; }
    [[nodiscard]] double enough() const noexcept { return enough_; }
    // Whether coarse bounds are worth a try: they were enough for half of the last triangles.
    [[nodiscard]] bool try_coarse() const noexcept { return enough_ > 0 && coarse_pays_; }
    void set_coarse_pays(bool pays) noexcept { coarse_pays_ = pays; }
    // Bounds of the strip are kept: most triangles stay from one round to the next. In units of the grid.
    [[nodiscard]] ProvenTriangle of(const SiteTriangle &triangle, Effort effort);

private:
    using Key = std::array<int32_t, 6>;
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
    [[nodiscard]] ProvenTriangle in_cell(const SiteTriangle &triangle, Effort effort);
    [[nodiscard]] ProvenTriangle in_strip(const SiteTriangle &triangle);
    [[nodiscard]] TriangleBound over_cells(const Placed &placed, int32_t block, const SiteTriangle &triangle,
                                           double &over) const;
    [[nodiscard]] double moves_over(const SiteTriangle &triangle, const HessianBox &box,
                                    const Rectangle &cell) const;
    [[nodiscard]] Interval beyond(const Rectangle &part, const Rectangle &block, size_t k, bool above) const;
    [[nodiscard]] double moves_beyond(const SiteTriangle &triangle, const Rectangle &part,
                                      const Rectangle &block);
    void widen(const SiteTriangle &triangle, Rectangle &part) const noexcept;

    const MeshDomain &domain_;
    const CellGrid &cells_;
    const Sites &sites_;
    const pieces::PieceGrid &grid_;
    double chord_, enough_ = 0;
    bool coarse_pays_ = true;
    CellNets nets_;
    PieceBound by_pieces_;
    std::unordered_map<Key, ProvenTriangle, Hash> known_;
};

} // namespace nrb::mesh
