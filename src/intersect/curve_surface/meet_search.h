// SPDX-License-Identifier: MIT
// A subdivision search for the parts of a curve and a surface that come near each other.
#pragma once

#include "closest/pair/pair_cells.h"
#include "intersect/curve_surface/meet_judge.h"
#include "intersect/curve_surface/seams.h"

#include <deque>
#include <span>

namespace nrb::intersect {

// Looks at pairs of cells of the trees of both, down to parts for which charts, lower bounds or foot points
// decide. A search keeps its trees, so that a finer one continues where it ended.
class MeetSearch {
public:
    MeetSearch(const Spline &curve, const Spline &surface, const Seams &seams);

    // All parts within the tolerance, or within the noise, of each other.
    MeetCells find(double tolerance);
    // What is as near as rounding can tell, in the parts of some cells.
    MeetCells refine(std::span<const MeetCell> cells);

    // About half of the longest side of the common box of both.
    [[nodiscard]] double size() const noexcept { return frame_.unscaled(1); }
    // The uncertainty of a distance due to rounding.
    [[nodiscard]] double noise() const noexcept { return frame_.unscaled(framed_noise()); }

private:
    using PairCell = closest::PairCell;
    struct Pair {
        PairCell *curve, *surface;
    };

    MeetCells run();
    void look(const Pair &pair);
    void add(const Pair &pair);
    void add_unknown(const Pair &pair);
    void divide(const Pair &pair, bool curve_is_long);
    bool divide_one(const Pair &pair, bool of_curve);
    pieces::SlopedPiece sloped_arc(PairCell &cell);
    SlopedPatch sloped_patch(PairCell &cell);
    [[nodiscard]] double near() const noexcept { return std::max(tolerance_, framed_noise()); }
    [[nodiscard]] double framed_noise() const noexcept;

    pieces::Frame frame_;
    closest::PairCells curve_cells_, surface_cells_;
    const Seams &seams_;
    int degrees_;
    double tolerance_ = 0;
    std::vector<Pair> stack_;
    std::deque<pieces::Slopes> arc_slopes_; // indexed by the marks of cells
    std::deque<PatchSlopes> patch_slopes_;
    MeetJudge judge_;
    MeetCells result_;
};

} // namespace nrb::intersect
