// SPDX-License-Identifier: MIT
// The zeros of a function over all pieces of a surface.
#pragma once

#include "intersect/levels/fields/level_field.h"
#include "intersect/levels/fields/surface_borders.h"
#include "intersect/levels/trace/level_boxes.h"

#include <map>
#include <tuple>

namespace nrb::intersect {

// Signs at the corners of pieces and roots on their edges are made once, for all pieces that have them: so arcs of
// neighbours end in the same roots. Pieces are neighbours across seams too, but not across jumps of the surface, nor where f
// jumps: there the roots of both differ, as functions of derivatives do at creases.
class LevelTrace {
public:
    // tolerance: in space, in the frame.
    LevelTrace(LevelField &field, const SurfaceBorders &borders, double tolerance);

    void add(int64_t piece);
    [[nodiscard]] LevelPieces take();

private:
    // Breaks along an axis; those across which the surface does not go on are two lines.
    using Line = int64_t;
    using Corner = std::pair<Line, Line>;
    using EdgeKey =
        std::tuple<size_t, Line, int64_t>; // across which axis, where on it, the index along the other one

    // Of a piece, seen from it.
    struct Side {
        int64_t piece;
        size_t axis;
        int end;
    };
    struct SharedEdge {
        Side side; // of the first piece that has it
        std::vector<EdgeRoot> roots;
        bool again = false; // another one has it too
    };

    [[nodiscard]] std::array<Line, 2> lines(int64_t piece, size_t axis) const;
    LevelBorder border(int64_t piece, const PieceDomain &domain, const LevelNet &net);
    bool corner(const Corner &at, const LevelNet &net, size_t row, size_t column);
    std::vector<EdgeRoot> edge(const Side &side, const PieceDomain &domain, const LevelNet &net,
                               LevelBorder &border);
    std::vector<EdgeRoot> add_roots(const Side &side, const PieceDomain &domain,
                                    const std::vector<double> &places);
    void end_at(const std::vector<EdgeRoot> &roots);
    void end_at_jump(const SharedEdge &edge);

    LevelField &field_;
    const SurfaceBorders &borders_;
    double near_;
    std::map<Corner, bool> corners_;
    std::map<EdgeKey, SharedEdge> edges_;
    LevelPieces found_;
};

PieceDomain domain_of(const pieces::PieceGrid &grid, int64_t piece);

} // namespace nrb::intersect
