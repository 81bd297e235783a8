// SPDX-License-Identifier: MIT
#include "fit/least_squares/stencil_pattern.h"

#include "numeric/solvers/sparse/grid_order.h"

#include <algorithm>

namespace nrb::fit {

StencilPattern::StencilPattern(const std::vector<KnotVectorPtr> &axes, const Index &least_reach)
    : axes_(static_cast<int>(axes.size())) {
    int64_t all = 1;
    for (size_t k = 0; k < axes.size(); ++k) {
        counts_[k] = axes[k]->distinct_layers();
        reach_[k] = std::max<int64_t>(axes[k]->degree(), least_reach[k]);
        periodic_[k] = axes[k]->periodic();
        all *= 2 * reach_[k] + 1;
    }
    offsets_ = all / 2 + 1; // offset 0 and those after it
}

int64_t StencilPattern::unknown(const Index &layer) const noexcept {
    int64_t number = 0;
    for (size_t k = 0; k < layer.size(); ++k) {
        number = number * counts_[k] + (periodic_[k] ? layer[k] % counts_[k] : layer[k]);
    }
    return number;
}

int64_t StencilPattern::step(const Index &first, const Index &second) const noexcept {
    int64_t step = 0;
    for (size_t k = 0; k < first.size(); ++k) {
        step = step * (2 * reach_[k] + 1) + second[k] - first[k];
    }
    return step;
}

int64_t StencilPattern::neighbour(const Index &own, const Index &offset) const noexcept {
    int64_t number = 0;
    for (size_t k = 0; k < own.size(); ++k) {
        int64_t layer = own[k] + offset[k];
        if (periodic_[k]) {
            layer = (layer % counts_[k] + counts_[k]) % counts_[k];
        }
        if (layer < 0 || layer >= counts_[k]) {
            return -1;
        }
        number = number * counts_[k] + layer;
    }
    return number;
}

void StencilPattern::advance(Index &offset) const noexcept {
    for (size_t k = offset.size(); k-- > 0;) {
        if (++offset[k] <= reach_[k]) {
            return;
        }
        offset[k] = -reach_[k];
    }
}

std::vector<int64_t> StencilPattern::elimination_order() const {
    std::array<GridAxis, max_axes> axes;
    for (size_t k = 0; k < axes.size(); ++k) {
        axes[k] = {counts_[k], reach_[k], periodic_[k]};
    }
    return grid_order(axes);
}

} // namespace nrb::fit
