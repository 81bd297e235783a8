// SPDX-License-Identifier: MIT
// Strands: stretches along which two curves run side by side.
#pragma once

#include "intersect/pairs/links.h"

#include <optional>

namespace nrb::intersect {

// Consecutive parts on both curves, of no more than a period of each. The range of a begins in its domain. b
// runs from from_b to to_b, which is the lower one if it runs against a.
struct Strand {
    std::vector<size_t> cells;
    Interval a;
    double from_b, to_b;
    // Ends that include places where one of the curves almost stands still, and whether one turns back there.
    struct End {
        double a, b;
        bool turns_back = false;
    };
    End first, last;
};

// The strands of the cells of kind `along`.
std::vector<Strand> strands_of(const Spline &a, const Spline &b, std::span<const NearCell> cells,
                               std::span<const Link> links);

// The knots of an axis in its domain, and for a periodic axis those of the next period.
class Breaks {
public:
    explicit Breaks(const KnotVector &axis);
    [[nodiscard]] bool hold(double t) const noexcept;
    [[nodiscard]] bool hold_any_in(Interval range) const noexcept;
    [[nodiscard]] bool have_span_in(Interval range) const noexcept;

private:
    std::vector<double> knots_;
};

// The overlap that a strand is, with its ends extended if necessary: it holds a whole span of one of the
// curves, or it begins and ends where one of them has a knot or an end, or turns back. None for other
// strands: polynomial pieces that agree on an interval agree until one of them ends.
std::optional<Strand> overlap_of(const Breaks &on_a, const Breaks &on_b, const Strand &given);

} // namespace nrb::intersect
