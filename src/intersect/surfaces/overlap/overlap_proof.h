// SPDX-License-Identifier: MIT
// Proofs that two surfaces coincide within a tolerance in the regions that edges bound.
#pragma once

#include "intersect/surfaces/cross_search.h"
#include "intersect/surfaces/overlap/overlap_loops.h"
#include "intersect/surfaces/overlap/overlap_map.h"

#include <map>

namespace nrb::intersect {

// Subdivision of the domain of the first surface. A part is done if no edge runs through it and its middle is
// outside of all regions; or if it lies along pieces of the other surface (OverlapMap); or if it is small,
// and its middle or an edge in it is near the other surface. Where an edge runs through a part, the other
// surface may end: its pieces are then continued as polynomials.
class OverlapProof {
public:
    // near: the tolerance within which the surfaces coincide, in the frame.
    OverlapProof(const OverlapGround &ground, const OverlapEdges &edges, const OverlapRegions &regions,
                 double near);

    // Whether all that is on the left of edges is proven to lie along the other surface.
    [[nodiscard]] bool prove();
    // Whether all that the parts over these ranges have in common is in proven regions.
    [[nodiscard]] bool covers(const std::array<Interval, 4> &ranges);
    // Whether the part of the first surface has places in a region and lies along that of the other one.
    [[nodiscard]] bool is_along(const std::array<Interval, 4> &ranges);

private:
    using Index = pieces::PieceGrid::Index;
    struct Part {
        const CrossPiece *piece = nullptr;
        PlaceBox places{};
    };
    struct Proven {
        PlaceBox part; // of the first surface
        const CrossPiece *piece;
        PlaceBox with;
    };
    enum class State { done, halve, failed };

    using SegmentPlaces = std::array<std::array<std::array<double, 2>, 4>, 2>; // control points on both
    void add_edge_parts(const SegmentPlaces &on);
    [[nodiscard]] static std::array<double, 2> parameters(const Part &part, double u, double v) noexcept;
    State look(const Part &part);
    State look_along(const Part &part, const std::array<double, 2> &beside, bool inside);
    bool lies_along(const Part &part, const CrossPiece &other, const std::array<double, 2> &start);
    bool lies_along_neighbours(const Part &part, const CrossPiece &other, bool inside);
    using Beyond = std::array<std::array<bool, 3>, 2>;
    [[nodiscard]] Beyond beyond_of(const CrossPiece &piece);
    bool lies_along_neighbour(const Part &part, const CrossPiece &next, const std::array<double, 2> &start,
                              const std::array<int, 2> &step, const Beyond &told, bool inside);
    [[nodiscard]] std::optional<const CrossPiece *> neighbour(const CrossPiece &piece,
                                                              const std::array<int, 2> &step) const;
    [[nodiscard]] std::optional<std::array<double, 2>> edge_in(const Part &part) const;
    [[nodiscard]] bool is_inside(const Part &part) const;
    bool is_known(const Part &a, const Part &b) const;
    OverlapMap::Verdict look(const Part &a, const Part &b);
    [[nodiscard]] bool meets_region(const Part &part) const;
    [[nodiscard]] bool is_beside_region(const Part &part) const;
    bool is_told(const Part &a, const Part &b, OverlapMap::Verdict verdict);
    [[nodiscard]] bool is_loose(const std::array<Interval, 4> &ranges) const;
    [[nodiscard]] std::optional<Part> part_of(size_t surface, const Interval *ranges) const;

    const OverlapGround &ground_;
    const OverlapEdges &edges_;
    const OverlapRegions &regions_;
    double near_;
    OverlapMap map_;
    struct EdgePart {
        PlaceBox on;                  // its box in the parameters of the first surface
        std::array<double, 2> at;     // its middle there
        std::array<double, 2> beside; // the same on the other surface
    };
    std::vector<EdgePart> edge_parts_;
    std::map<const CrossPiece *, std::vector<Proven>> proven_;
    std::map<const CrossPiece *, std::vector<PlaceBox>> inside_; // proven parts without edges, in regions
    int left_; // number of calls of map_.look() that are left
};

} // namespace nrb::intersect
