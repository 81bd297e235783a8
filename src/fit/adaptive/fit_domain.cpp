// SPDX-License-Identifier: MIT
#include "fit/adaptive/fit_domain.h"

#include "basis/generators.h"

namespace nrb::fit {

KnotVectorPtr axis_over(const FitDomain &domain, size_t k, const std::vector<Break> &inner) {
    const int p = domain.degrees[k];
    const auto [lower, upper] = domain.domains[k];
    if (domain.periodic[k]) {
        std::vector<double> breaks{lower};
        std::vector<int32_t> multiplicities{domain.seams[k]};
        int64_t count = 2 * p + 1 + domain.seams[k];
        for (const Break &knot : inner) {
            breaks.push_back(knot.param);
            multiplicities.push_back(knot.multiplicity);
            count += knot.multiplicity;
        }
        breaks.push_back(upper);
        multiplicities.push_back(domain.seams[k]);
        std::vector<double> knots(static_cast<size_t>(count));
        periodic_knots(p, breaks, multiplicities.data(), knots);
        return make_knot_vector(p, std::move(knots), true, static_cast<int>(k));
    }
    std::vector<double> knots(static_cast<size_t>(p) + 1, lower);
    for (const Break &knot : inner) {
        knots.insert(knots.end(), static_cast<size_t>(knot.multiplicity), knot.param);
    }
    knots.insert(knots.end(), static_cast<size_t>(p) + 1, upper);
    return make_knot_vector(p, std::move(knots), false, static_cast<int>(k));
}

std::vector<KnotVectorPtr> simplest_axes(const FitDomain &domain) {
    std::vector<KnotVectorPtr> axes;
    for (size_t k = 0; k < domain.degrees.size(); ++k) {
        axes.push_back(axis_over(domain, k, {}));
    }
    return axes;
}

} // namespace nrb::fit
