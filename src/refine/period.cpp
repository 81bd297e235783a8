#include "refine/period.h"

#include "base/error.h"

#include <algorithm>
#include <cmath>

namespace nrb {

std::vector<double> extended_knots(const KnotVector &axis, int64_t lead) {
    const std::span<const double> stored = axis.knots();
    const auto first = static_cast<size_t>(lead);
    const auto step = static_cast<size_t>(axis.distinct_layers());
    const double period = axis.domain().upper - axis.domain().lower;
    const size_t end = first + stored.size();
    std::vector<double> knots(stored.size() + 2 * first);
    std::copy(stored.begin(), stored.end(), knots.begin() + lead);
    for (size_t i = first; i-- > 0;) {
        const bool repeated = knots[i + step] == knots[i + step + 1];
        knots[i] = repeated ? knots[i + 1] : std::min(knots[i + step] - period, knots[i + 1]);
    }
    for (size_t i = end; i < knots.size(); ++i) {
        const bool repeated = knots[i - step] == knots[i - step - 1];
        knots[i] = repeated ? knots[i - 1] : std::max(knots[i - step] + period, knots[i - 1]);
    }
    if (!std::isfinite(knots.back() - knots.front())) {
        fail(NURBS_ERROR_NOT_REPRESENTABLE, "knots: those of the periods beside the domain overflow");
    }
    return knots;
}

} // namespace nrb
