// SPDX-License-Identifier: MIT
#include "fit/offset/patch_axis.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace nrb::fit {

namespace {

constexpr int most_parts = 8; // of a patch in one round
constexpr int most_smooth = 2;

Layer layer_at(size_t site, double x, double y) noexcept {
    return {site, {1, (x + y) / 5, x * y / 10}};
}

} // namespace

PatchAxis patch_axis(const KnotVector &axis) {
    PatchAxis made;
    const Interval domain = axis.domain();
    for (const KnotGroup &group : distinct_knots(axis.knots())) {
        if (domain.lower <= group.knot && group.knot <= domain.upper) {
            made.breaks.push_back(group.knot);
            made.smooth.push_back(std::clamp(axis.degree() - group.multiplicity - 1, 0, most_smooth));
        }
    }
    made.smooth.front() = made.smooth.back() = 0;
    return made;
}

KnotVectorPtr knots_of(const PatchAxis &axis) {
    std::vector<double> knots{axis.breaks.front()};
    for (size_t i = 0; i < axis.breaks.size(); ++i) {
        knots.insert(knots.end(), static_cast<size_t>(patch_degree - axis.smooth[i]), axis.breaks[i]);
    }
    knots.push_back(axis.breaks.back());
    return make_knot_vector(patch_degree, std::move(knots));
}

std::vector<Site> sites_of(const PatchAxis &axis) {
    std::vector<Site> sites;
    for (size_t i = 0; i < axis.breaks.size(); ++i) {
        const bool two = !axis.is_end(i) && axis.smooth[i] < most_smooth;
        if (two || i + 1 == axis.breaks.size()) {
            sites.push_back({i, true});
        }
        if (two || i + 1 < axis.breaks.size()) {
            sites.push_back({i, false});
        }
    }
    return sites;
}

std::vector<Layer> layers_of(const PatchAxis &axis) {
    std::vector<Layer> layers;
    const std::vector<Site> sites = sites_of(axis);
    for (size_t s = 0; s < sites.size(); ++s) {
        const auto [i, left] = sites[s];
        const double below = i > 0 ? axis.breaks[i - 1] - axis.breaks[i] : 0,
                     above = i + 1 < axis.breaks.size() ? axis.breaks[i + 1] - axis.breaks[i] : 0;
        if (!axis.is_end(i) && axis.smooth[i] == most_smooth) {
            layers.insert(layers.end(),
                          {layer_at(s, below, below), layer_at(s, below, above), layer_at(s, above, above)});
        } else if (left) {
            layers.insert(layers.end(), {layer_at(s, below, below), layer_at(s, below, 0)});
            if (axis.is_end(i)) {
                layers.push_back(layer_at(s, 0, 0));
            }
        } else {
            if (axis.smooth[i] == 0) {
                layers.push_back(layer_at(s, 0, 0));
            }
            layers.insert(layers.end(), {layer_at(s, above, 0), layer_at(s, above, above)});
        }
    }
    return layers;
}

int parts_for(double bound, double tolerance) noexcept {
    const double parts = std::isfinite(bound) ? std::ceil(1.1 * std::pow(bound / tolerance, 1.0 / 6)) : 2;
    return static_cast<int>(std::clamp(bound <= tolerance ? 1 : parts, 1.0, double{most_parts}));
}

PatchAxis cut(const PatchAxis &axis, const std::vector<int> &parts) {
    PatchAxis made;
    for (size_t i = 0; i < parts.size(); ++i) {
        for (int part = 0; part < parts[i]; ++part) {
            const double place = double{1} * part / parts[i];
            made.breaks.push_back(axis.breaks[i] * (1 - place) + axis.breaks[i + 1] * place);
            made.smooth.push_back(part > 0 ? most_smooth : axis.smooth[i]);
        }
    }
    made.breaks.push_back(axis.breaks.back());
    made.smooth.push_back(0);
    return made;
}

bool rising(const PatchAxis &axis) noexcept {
    return std::is_sorted(axis.breaks.begin(), axis.breaks.end(), std::less_equal<>());
}

} // namespace nrb::fit
