// SPDX-License-Identifier: MIT
#include "modify/deform/region.h"

#include "refine/knots/insert.h"

#include <algorithm>

namespace nrb::modify {

namespace {

// The ends of a range that are not knots yet.
std::vector<double> missing_ends(const KnotVector &axis, Interval range) {
    std::vector<double> missing;
    for (const double end : {range.lower, range.upper}) {
        if (end != axis.domain().upper && multiplicity(axis.knots(), end) == 0) {
            missing.push_back(end);
        }
    }
    return missing;
}

// The knots to insert so that each of `cells` equal parts of a range has a knot.
std::vector<double> filling(const KnotVector &axis, Interval range, int cells) {
    std::vector<double> knots;
    for (int i = 1; i < cells; ++i) {
        const double from = range.lower + (range.upper - range.lower) * (static_cast<double>(i) / cells);
        const double to = range.lower + (range.upper - range.lower) * (static_cast<double>(i + 1) / cells);
        const auto first = std::lower_bound(axis.knots().begin(), axis.knots().end(), from);
        const bool apart = range.lower < from && from < range.upper && (knots.empty() || knots.back() < from);
        if (apart && (first == axis.knots().end() || *first >= to)) {
            knots.push_back(from);
        }
    }
    return knots;
}

} // namespace

SplinePtr refined_to(const SplinePtr &spline, const Part &part, int cells_per_degree) {
    SplinePtr result = spline;
    for (int k = 0; k < spline->axes(); ++k) {
        const Interval range = part[static_cast<size_t>(k)];
        if (!same(spline->axis(k).domain(), range)) {
            result = refine::refine(result, k, missing_ends(result->axis(k), range));
            const int cells = cells_per_degree * (result->axis(k).degree() + 1);
            result = refine::refine(result, k, filling(result->axis(k), range, cells));
        }
    }
    return result;
}

bool inside(const KnotVector &axis, int64_t layer, Interval range) noexcept {
    const auto [lower, upper] = axis.domain();
    const bool open = !axis.periodic() || same(axis.domain(), range);
    return (axis[layer] >= range.lower || (open && range.lower == lower)) &&
           (axis[layer + axis.degree() + 1] <= range.upper || (open && range.upper == upper));
}

} // namespace nrb::modify
