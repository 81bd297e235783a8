#include "reduce/knot_clusters.h"

#include "base/error.h"
#include "refine/period.h"

#include <algorithm>

namespace nrb {

std::vector<KnotCount> counted(std::span<const double> sorted) {
    std::vector<KnotCount> counts;
    for (const double knot : sorted) {
        if (counts.empty() || counts.back().knot != knot) {
            counts.push_back({knot, 0});
        }
        ++counts.back().times;
    }
    return counts;
}

KnotClusters::KnotClusters(std::span<const KnotCount> knots, Interval domain, double width) {
    int64_t most = 0;
    bool open = false; // whether the last cluster takes more knots
    for (const auto &[knot, times] : knots) {
        if (std::abs(knot - domain.lower) <= width || std::abs(knot - domain.upper) <= width) {
            const bool lower = std::abs(knot - domain.lower) <= width;
            clusters_.push_back({knot, knot, lower ? domain.lower : domain.upper});
            open = false;
        } else if (knot < domain.lower || knot > domain.upper || !open ||
                   knot - clusters_.back().first > width) {
            clusters_.push_back({knot, knot, knot});
            open = knot > domain.lower && knot < domain.upper;
            most = times;
        } else {
            clusters_.back().last = knot;
            if (times > most) {
                clusters_.back().value = knot;
                most = times;
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
            fail(NURBS_ERROR_MULTIPLICITY,
                 "%sknots within the tolerance of %s on axis %d would become one that occurs more than %zu "
                 "times, "
                 "which degree %d does not allow",
                 owner, Number(knots[i]).text, k, limit, degree);
        }
    }
}

} // namespace

KnotVectorPtr moved_axis(const KnotVectorPtr &axis, const KnotClusters &clusters, int k, const char *owner) {
    const auto p = static_cast<size_t>(axis->degree());
    const auto count = static_cast<size_t>(axis->count());
    std::vector<double> knots(axis->knots().begin(), axis->knots().end());
    const size_t first = axis->periodic() ? p : 0, end = axis->periodic() ? count + 1 : knots.size();
    bool same = true;
    for (size_t i = first; i < end; ++i) {
        knots[i] = clusters(knots[i]);
        same = same && knots[i] == (*axis)[static_cast<int64_t>(i)];
    }
    if (same) {
        return axis;
    }
    if (axis->periodic()) {
        continue_knots(knots, p, count, count - p);
    }
    check_multiplicities(axis->degree(), knots, k, owner);
    return make_knot_vector(axis->degree(), std::move(knots), axis->periodic(), k);
}

} // namespace nrb
