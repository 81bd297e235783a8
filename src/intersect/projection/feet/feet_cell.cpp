// SPDX-License-Identifier: MIT
#include "intersect/projection/feet/feet_cell.h"

#include "base/scratch.h"
#include "base/watch.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

AxisLayers layers_along(size_t axis, const FeetNet &net) noexcept {
    const auto wide = static_cast<int64_t>(net.width);
    return axis == 0 ? AxisLayers{1, net.degrees[0], (net.degrees[1] + 1) * wide}
                     : AxisLayers{net.degrees[0] + 1, net.degrees[1], wide};
}

} // namespace

double FeetCell::side(size_t axis, size_t end) const noexcept {
    const double shift = is_border(axis, end) ? piece().shifts[axis][end] : piece().shift[axis];
    return static_cast<double>(end) + shift / length_[axis];
}

double FeetCell::room(size_t axis, size_t end) const noexcept {
    constexpr double most = widening / 2;
    const double own = piece().poles[axis][end] ? room_along_sides : piece().rooms[axis][end];
    return is_border(axis, end) ? std::min(own / length_[axis], most) : 0;
}

Interval FeetCell::range(size_t axis) const noexcept {
    const Interval &all = piece().range[axis];
    const auto parameter = [&](double place) {
        return place == 1 ? all.upper
                          : std::clamp(all.lower * (1 - place) + all.upper * place, all.lower, all.upper);
    };
    return {parameter(lower_[axis]), parameter(upper_[axis])};
}

const std::vector<double> &FeetCell::wide() {
    if (!wide_.empty()) {
        return wide_;
    }
    const size_t n = net_->values.size(), coefficients = net_->coefficients(), width = net_->width;
    wide_.resize(n);
    Scratch scratch(2 * n);
    double *const half = scratch.take(n), *const both = scratch.take(n);
    const auto matrix = [&](size_t k) {
        const double room = widening * length_[k];
        return part_matrix(net_->degrees[k], lower_[k] - room, upper_[k] + room);
    };
    apply_along(matrix(0), layers_along(0, *net_), net_->values.data(), half);
    apply_along(matrix(1), layers_along(1, *net_), half, both);
    for (size_t i = 0; i < coefficients; ++i) {
        for (size_t c = 0; c < width; ++c) {
            wide_[c * coefficients + i] = both[i * width + c];
        }
    }
    count_work(static_cast<int64_t>(n) * (net_->degrees[0] + net_->degrees[1] + 6));
    return wide_;
}

// At a distance x outside of [0, 1] the sum of the magnitudes of the Bernstein functions is (1 + 2 x)^degree.
double FeetCell::amplified() const noexcept {
    double factor = 1;
    for (size_t k = 0; k < 2; ++k) {
        const double room = widening * length_[k],
                     beyond = std::max({room - lower_[k], upper_[k] + room - 1, 0.0});
        factor *= std::pow(1 + 2 * beyond, net_->degrees[k]);
    }
    return factor;
}

bool FeetCell::split(size_t axis, std::deque<FeetCell> &all) {
    if (halves_[0] != nullptr) {
        return true;
    }
    if (net_->degrees[axis] == 0) {
        axis = 1 - axis;
    }
    if (net_->degrees[axis] == 0 || length_[axis] <= least_length_of_parts) {
        return false;
    }
    const double between = lower_[axis] + place_of_halves * length_[axis];
    for (size_t end = 0; end < 2; ++end) {
        FeetCell &part = all.emplace_back(*net_);
        part.lower_ = lower_;
        part.upper_ = upper_;
        part.length_ = length_;
        (end == 0 ? part.upper_ : part.lower_)[axis] = between;
        part.length_[axis] = part.upper_[axis] - part.lower_[axis];
        part.halvings_ = halvings_ + 1;
        halves_[end] = &part;
    }
    return true;
}

} // namespace nrb::intersect
