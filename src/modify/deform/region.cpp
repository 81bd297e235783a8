#include "modify/deform/region.h"

#include "refine/insert.h"

#include <algorithm>

namespace nrb {

namespace {

bool whole(const KnotVector &axis, Interval range) noexcept {
    return range.lower == axis.domain().lower && range.upper == axis.domain().upper;
}

// Knots that are missing at the ends of a range.
std::vector<double> missing_ends(const KnotVector &axis, Interval range) {
    std::vector<double> missing;
    for (const double end : {range.lower, range.upper}) {
        if (end != axis.domain().upper && multiplicity(axis.knots(), end) == 0) {
            missing.push_back(end);
        }
    }
    return missing;
}

// Knots that cut every span of a range in equal parts, so that there are enough.
std::vector<double> dividing(const KnotVector &axis, int k, Interval range, int64_t enough) {
    const auto begins = [&](int64_t s) { return axis[s] >= range.lower && axis[s] < range.upper; };
    const auto indices = axis.spans().indices();
    const int64_t spans = std::count_if(indices.begin(), indices.end(), begins);
    std::vector<double> knots = uniform_new_knots(axis, k, (enough + spans - 1) / spans);
    std::erase_if(knots, [range](double t) { return !(range.lower < t && t < range.upper); });
    return knots;
}

} // namespace

SplinePtr refined_to(const SplinePtr &spline, const Region &region, int spans_per_degree) {
    SplinePtr result = spline;
    for (int k = 0; k < spline->axes(); ++k) {
        const Interval range = region[static_cast<size_t>(k)];
        if (!whole(spline->axis(k), range)) {
            result = refine(result, k, missing_ends(result->axis(k), range));
            const int64_t enough = int64_t{spans_per_degree} * (result->axis(k).degree() + 1);
            result = refine(result, k, dividing(result->axis(k), k, range, enough));
        }
    }
    return result;
}

bool inside(const KnotVector &axis, int64_t layer, Interval range) noexcept {
    const auto [lower, upper] = axis.domain();
    const bool open = !axis.periodic() || whole(axis, range);
    return (axis[layer] >= range.lower || (open && range.lower == lower)) &&
           (axis[layer + axis.degree() + 1] <= range.upper || (open && range.upper == upper));
}

} // namespace nrb
