// SPDX-License-Identifier: MIT
// A subdivision search for the parts of two curves that come near each other.
#pragma once

#include "closest/pair/pair_cells.h"
#include "intersect/pairs/judge.h"
#include "spline/spline.h"

#include <deque>
#include <span>

namespace nrb::intersect {

// Looks at pairs of cells of the trees of both curves, down to parts for which charts, lower bounds or
// matched points decide. A search keeps its trees, so that a finer one continues where it ended. Of a curve
// with itself it pairs later parts with earlier ones, except for parts that are proven to be simple.
class NearSearch {
public:
    NearSearch(const Spline &a, const Spline &b);
    explicit NearSearch(const Spline &curve);

    // All parts within the tolerance, or within the noise, of each other.
    NearCells find(double tolerance);
    // What is as near as rounding can tell, in the parts of some cells.
    NearCells refine(std::span<const NearCell> cells);

    // About half of the longest side of the common box of both curves.
    [[nodiscard]] double size() const noexcept { return frame_.unscaled(1); }
    // The uncertainty of a distance due to rounding.
    [[nodiscard]] double noise() const noexcept { return frame_.unscaled(framed_noise()); }

private:
    using PairCell = closest::PairCell;
    struct Pair {
        PairCell *a, *b;
    };
    // The parameters at which a curve jumps.
    using Jumps = std::vector<double>;

    NearCells run();
    void look(const Pair &pair);
    [[nodiscard]] bool is_apart(const Pair &pair) const noexcept;
    bool is_decided_by_order(const Pair &pair);
    bool is_simple(const Pair &pair);
    [[nodiscard]] bool is_seam(Interval a, Interval b) const noexcept;
    void add(const Pair &pair);
    void add_joined(const Pair &pair, NearCell::Kind kind);
    void add_unknown(const Pair &pair);
    void set_segments(const Pair &pair, NearCell &cell) const;
    void divide(const Pair &pair);
    bool divide(const Pair &pair, bool first);
    pieces::SlopedPiece sloped(PairCell &cell);
    [[nodiscard]] double near() const noexcept { return std::max(tolerance_, framed_noise()); }
    [[nodiscard]] double framed_noise() const noexcept;

    pieces::Frame frame_;
    closest::PairCells a_, b_;
    Interval domain_a_, domain_b_;
    Jumps jumps_a_, jumps_b_;
    int degrees_, dim_;
    bool with_itself_ = false, closed_ = false; // closed_: the curve ends where it begins
    double tolerance_ = 0;
    std::vector<Pair> stack_;
    std::vector<double> direction_;
    std::deque<pieces::Slopes> slopes_; // indexed by the marks of cells
    Judge judge_;
    NearCells result_;
};

} // namespace nrb::intersect
