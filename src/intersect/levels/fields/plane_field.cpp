// SPDX-License-Identifier: MIT
#include "intersect/levels/fields/plane_field.h"

#include "base/numbers.h"
#include "base/watch.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

PlaneField::PlaneField(const pieces::PieceGrid &grid, const std::array<double, 3> &normal)
    : LevelField(grid), normal_(normal), work_(static_cast<size_t>(grid.shape().values())),
      patch_(work_.size()) {
    for (int k = 0; k < grid.shape().axes; ++k) {
        degrees_[static_cast<size_t>(grid.spline_axis(k))] = grid.shape().degree(k);
    }
    for (int64_t piece = 0; piece < grid.count(); ++piece) {
        const LevelNet net = distances(piece);
        count_work(8 * std::ssize(net.values));
        Interval range{infinity, -infinity};
        for (size_t i = 0; i < net.values.size(); ++i) {
            const double w = net.weight(i), room = 5 * absolute_noise();
            const bool certain = w > net.least_weight;
            range.lower = certain ? std::min(range.lower, (net.values[i] - room) / w) : -infinity;
            range.upper = certain ? std::max(range.upper, (net.values[i] + room) / w) : infinity;
        }
        ranges_.push_back(range);
    }
}

// Of records whose weights have no certain sign.
double PlaneField::absolute_noise() const noexcept {
    return grid().positive() ? 0 : 2 * grid().rounding().record;
}

// Differences from the level are rounded, and so are the means of a subdivision.
void PlaneField::set_level(double level, double error) noexcept {
    level_ = level;
    const double roundings = 24 + 4 * (degrees_[0] + degrees_[1]);
    noise_ = {1.01 * grid().moved() + error + roundings * eps * (grid().radius() + std::abs(level)),
              absolute_noise()};
    if (!grid().positive()) {
        noise_.absolute += std::abs(level) * 2 * grid().rounding().weight;
    }
}

bool PlaneField::may_vanish(int64_t piece) {
    const Interval range = ranges_[static_cast<size_t>(piece)];
    const double room = 4 * noise_.relative;
    return range.lower - room <= level_ && level_ <= range.upper + room;
}

LevelNet PlaneField::distances(int64_t piece) {
    LevelNet net;
    net.degrees = degrees_;
    net.least_weight = least_weight();
    grid().patch(piece, work_.data(), patch_.data());
    const auto lanes = static_cast<size_t>(grid().shape().lanes);
    for (size_t i = 0; i < patch_.size(); i += lanes) {
        net.values.push_back(normal_[0] * patch_[i] + normal_[1] * patch_[i + 1] +
                             normal_[2] * patch_[i + 2]);
        if (grid().shape().weighted) {
            net.weights.push_back(patch_[i + 3]);
        }
    }
    return net;
}

LevelNet PlaneField::net(int64_t piece) {
    LevelNet net = distances(piece);
    net.noise = noise_;
    for (size_t i = 0; i < net.values.size(); ++i) {
        net.values[i] -= level_ * net.weight(i);
    }
    return net;
}

} // namespace nrb::intersect
