// SPDX-License-Identifier: MIT
#include "fit/offset/patch_axis.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace nrb::fit {

namespace {

constexpr int most_parts = 8; // of a patch in one round

} // namespace

PatchAxis patch_axis(const KnotVector &axis) {
    PatchAxis made;
    const Interval domain = axis.domain();
    for (const KnotGroup &group : distinct_knots(axis.knots())) {
        if (domain.lower <= group.knot && group.knot <= domain.upper) {
            made.breaks.push_back(group.knot);
            made.smooth.push_back(axis.degree() - group.multiplicity >= 2);
        }
    }
    made.smooth.front() = made.smooth.back() = false;
    return made;
}

KnotVectorPtr knots_of(const PatchAxis &axis) {
    std::vector<double> knots{axis.breaks.front()};
    for (size_t i = 0; i < axis.breaks.size(); ++i) {
        knots.insert(knots.end(), axis.smooth[i] ? 2 : 3, axis.breaks[i]);
    }
    knots.push_back(axis.breaks.back());
    return make_knot_vector(3, std::move(knots));
}

int parts_for(double bound, double tolerance) noexcept {
    const double parts = std::isfinite(bound) ? std::ceil(1.1 * std::pow(bound / tolerance, 0.25)) : 2;
    return static_cast<int>(std::clamp(parts, 2.0, double{most_parts}));
}

PatchAxis cut(const PatchAxis &axis, const std::vector<int> &parts) {
    PatchAxis made;
    for (size_t i = 0; i < parts.size(); ++i) {
        for (int part = 0; part < parts[i]; ++part) {
            const double place = double{1} * part / parts[i];
            made.breaks.push_back(axis.breaks[i] * (1 - place) + axis.breaks[i + 1] * place);
            made.smooth.push_back(part > 0 || axis.smooth[i]);
        }
    }
    made.breaks.push_back(axis.breaks.back());
    made.smooth.push_back(false);
    return made;
}

bool rising(const PatchAxis &axis) noexcept {
    return std::is_sorted(axis.breaks.begin(), axis.breaks.end(), std::less_equal<>());
}

} // namespace nrb::fit
