// SPDX-License-Identifier: MIT
// Stretches along which two curves run beside each other.
#pragma once

#include "intersect/pairs/links.h"

#include <optional>

namespace nrb::intersect {

// Parts one after the other on both curves, of no more than a period of each. The range of a begins in its domain;
// b runs from the first of its places to the second, which is below it where b runs against a.
struct Strand {
    std::vector<size_t> cells;
    Interval a;
    double from_b, to_b;
    // Beyond places where one of the curves all but stands still, and whether one turns back there.
    struct End {
        double a, b;
        bool turns_back = false;
    };
    End first, last;
};

// Of the cells of the kind `along`.
std::vector<Strand> strands_of(const Spline &a, const Spline &b, std::span<const NearCell> cells,
                               std::span<const Link> links);

// The knots of an axis in its domain, and those of the next period.
class Breaks {
public:
    explicit Breaks(const KnotVector &axis);
    [[nodiscard]] bool hold(double t) const noexcept;
    [[nodiscard]] bool hold_any_in(Interval range) const noexcept;
    [[nodiscard]] bool have_span_in(Interval range) const noexcept;

private:
    std::vector<double> knots_;
};

// A strand that holds a whole span of one of the curves, or begins and ends where one of them has a knot or an end, or
// turns back: polynomial pieces that agree on an interval agree until one of them ends. Others are none.
std::optional<Strand> overlap_of(const Breaks &on_a, const Breaks &on_b, const Strand &strand);

} // namespace nrb::intersect
