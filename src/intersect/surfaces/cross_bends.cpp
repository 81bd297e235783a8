// SPDX-License-Identifier: MIT
#include "base/numbers.h"
#include "base/watch.h"
#include "intersect/surfaces/cross_cell.h"
#include "numeric/norm.h"
#include "pieces/tree/patch_kernel.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

constexpr size_t record_width = 4; // x w, y w, z w, w

// A net of (w v . (S - centre), w): [counts[0]][counts[1]].
struct PlaneNet {
    std::array<int, 2> counts{};
    std::vector<std::array<double, 2>> values;

    [[nodiscard]] PlaneNet derivative(size_t axis, double factor) const {
        PlaneNet result{counts, {}};
        --result.counts[axis];
        const auto inner = static_cast<size_t>(counts[1]), step = axis == 0 ? inner : 1;
        for (size_t i = 0; i < static_cast<size_t>(result.counts[0]); ++i) {
            for (size_t j = 0; j < static_cast<size_t>(result.counts[1]); ++j) {
                const auto &a = values[i * inner + j], &b = values[i * inner + j + step];
                result.values.push_back({factor * (b[0] - a[0]), factor * (b[1] - a[1])});
            }
        }
        return result;
    }
    [[nodiscard]] Interval range(size_t value, double room) const noexcept {
        Interval all{infinity, -infinity};
        for (const auto &own : values) {
            all = {std::min(all.lower, own[value]), std::max(all.upper, own[value])};
        }
        return values.empty() ? Interval{0, 0} : Interval{all.lower - room, all.upper + room};
    }
};

Interval product(const Interval &a, const Interval &b) noexcept {
    const auto [least, most] =
        std::minmax({a.lower * b.lower, a.lower * b.upper, a.upper * b.lower, a.upper * b.upper});
    return {least, most};
}

} // namespace

// S_kl = (A_kl - w_kl (S - centre) - w_k S_l - w_l S_k) / w with A = w (S - centre).
CrossBends CrossCell::bends_along(const Vector3 &vector) const {
    const auto [p, q] = piece_->degrees;
    PlaneNet net{{p + 1, q + 1}, {}};
    std::vector<double> wide(records_.size()), half(records_.size());
    widen(records_.data(), half.data(), wide.data());
    double largest_weight = 0;
    for (size_t i = 0; i < wide.size(); i += record_width) {
        const double w = wide[i + 3];
        largest_weight = std::max(largest_weight, w);
        net.values.push_back({vector.x * (wide[i] - w * centre_.x) +
                                  vector.y * (wide[i + 1] - w * centre_.y) +
                                  vector.z * (wide[i + 2] - w * centre_.z),
                              w});
    }
    count_work(30 * std::ssize(net.values));
    const double wider = 1 + 2 * widening;
    const std::array<double, 2> factors{p / wider, q / wider};
    const std::array<PlaneNet, 2> first{net.derivative(0, factors[0]), net.derivative(1, factors[1])};
    const double room = 16 * (factors[0] + factors[1] + 1) * (factors[0] + factors[1] + 1) * largest_weight *
                        (error_ + 8 * eps * reach_) * std::pow(wider, p + q);
    const double room_of_weight = room / std::max(piece_->piece.reach(), eps);
    CrossBends result{along(vector), {}};
    for (size_t d = 0; d < 3; ++d) {
        const size_t k = d == 2 ? 1 : 0, l = d == 0 ? 0 : 1;
        const PlaneNet second =
            first[k].derivative(l, l == k ? std::max(factors[l] - 1 / wider, 0.0) : factors[l]);
        const Interval turn_k = first[k].range(1, room_of_weight), turn_l = first[l].range(1, room_of_weight);
        Interval sum = second.range(0, room);
        for (const Interval &less :
             {product(second.range(1, room_of_weight), result.extents.points),
              product(turn_k, result.extents.slopes[l]), product(turn_l, result.extents.slopes[k])}) {
            sum = {sum.lower - less.upper, sum.upper - less.lower};
        }
        result.bends[d] = product(sum, {1 / weights_.upper, 1 / weights_.lower});
    }
    return result;
}

} // namespace nrb::intersect
