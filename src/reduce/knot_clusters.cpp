// SPDX-License-Identifier: MIT
#include "reduce/knot_clusters.h"

#include "base/error.h"
#include "refine/periodic/period.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace nrb::reduce {

KnotClusters::KnotClusters(std::span<const KnotGroup> knots, Interval domain, double width) {
    // A fraction of a subnormal length may round up to the whole length.
    width = std::min(width, std::nextafter(domain.upper - domain.lower, 0.0));
    int most = 0;
    bool open = false; // whether the last cluster can take more knots
    for (const auto &[knot, multiplicity] : knots) {
        if (std::abs(knot - domain.lower) <= width || std::abs(knot - domain.upper) <= width) {
            const bool lower = std::abs(knot - domain.lower) <= width;
            clusters_.push_back({knot, knot, lower ? domain.lower : domain.upper});
            open = false;
        } else if (knot < domain.lower || knot > domain.upper || !open ||
                   knot - clusters_.back().first > width) {
            clusters_.push_back({knot, knot, knot});
            open = knot > domain.lower && knot < domain.upper;
            most = multiplicity;
        } else {
            clusters_.back().last = knot;
            if (multiplicity > most) {
                clusters_.back().value = knot;
                most = multiplicity;
            }
        }
    }
}

double KnotClusters::operator()(double knot) const noexcept {
    const auto found = std::partition_point(clusters_.begin(), clusters_.end(),
                                            [knot](const Cluster &cluster) { return cluster.last < knot; });
    return found->value;
}

namespace {

void check_multiplicities(int degree, std::span<const double> knots, int k, const char *owner) {
    const auto limit = static_cast<size_t>(degree) + 1;
    for (size_t i = 0; i + limit < knots.size(); ++i) {
        if (knots[i] == knots[i + limit]) {
            fail(Status::multiplicity,
                 "%sknots within the tolerance of %s on axis %d would become one that occurs more than %zu "
                 "times, "
                 "which degree %d does not allow",
                 owner, Number(knots[i]).text, k, limit, degree);
        }
    }
}

// The knots of a non-periodic axis, and which of the old layers belong to them.
struct Kept {
    std::vector<double> knots;
    std::vector<int64_t> layers;
};

// Removes the copies of an end beyond degree + 1, and as many layers.
void drop_excess(int degree, double end, Kept &kept) {
    const auto [first, last] = std::equal_range(kept.knots.begin(), kept.knots.end(), end);
    const int64_t excess = (last - first) - (degree + 1);
    if (excess > 0) {
        const int64_t start = first - kept.knots.begin();
        const int64_t stays = degree == 0 ? 0 : start == 0 ? 1 : last == kept.knots.end() ? -1 : 0;
        const auto gone = kept.layers.begin() + start + stays;
        kept.layers.erase(gone, gone + excess);
        kept.knots.erase(first, first + excess);
    }
}

} // namespace

refine::AxisTable moved_axis(const KnotVectorPtr &axis, const KnotClusters &clusters, int k,
                             const char *owner) {
    const auto p = static_cast<size_t>(axis->degree());
    const auto count = static_cast<size_t>(axis->count());
    Kept kept{{axis->knots().begin(), axis->knots().end()}, std::vector<int64_t>(count)};
    std::iota(kept.layers.begin(), kept.layers.end(), int64_t{0});
    std::vector<double> &knots = kept.knots;
    const size_t first = axis->periodic() ? p : 0, end = axis->periodic() ? count + 1 : knots.size();
    std::transform(knots.begin() + static_cast<std::ptrdiff_t>(first),
                   knots.begin() + static_cast<std::ptrdiff_t>(end),
                   knots.begin() + static_cast<std::ptrdiff_t>(first), clusters);
    refine::AxisTable made{axis, {}};
    if (!std::equal(knots.begin(), knots.end(), axis->knots().begin())) {
        if (axis->periodic()) {
            refine::continue_knots(knots, p, count, count - p);
        } else {
            drop_excess(axis->degree(), axis->domain().lower, kept);
            drop_excess(axis->degree(), axis->domain().upper, kept);
        }
        check_multiplicities(axis->degree(), knots, k, owner);
        made.axis = make_knot_vector(axis->degree(), std::move(knots), axis->periodic(), k);
    }
    std::for_each(kept.layers.begin(), kept.layers.end(), [&](int64_t i) { made.table.add_copy(i); });
    return made;
}

} // namespace nrb::reduce
