// SPDX-License-Identifier: MIT
#include "numeric/solvers/sparse/grid_order.h"

#include <algorithm>

namespace nrb::inline numeric {

namespace {

using Index = std::array<int64_t, 3>;

class Dissection {
public:
    explicit Dissection(const std::array<GridAxis, 3> &axes) : axes_(axes) {
        Index end{};
        int64_t size = 1;
        for (size_t k = 0; k < end.size(); ++k) {
            end[k] = axes[k].count;
            size *= axes[k].count;
        }
        order_.reserve(static_cast<size_t>(size));
        open_rings(0, {}, end);
    }
    [[nodiscard]] std::vector<int64_t> take() noexcept { return std::move(order_); }

private:
    // Without its first layers, a periodic axis is an open one.
    void open_rings(size_t k, Index first, const Index &end) {
        if (k == axes_.size()) {
            return divide(first, end);
        }
        const int64_t cut = axes_[k].periodic ? std::min(axes_[k].reach, axes_[k].count) : 0;
        Index layers = end;
        layers[k] = cut;
        const Index start = first;
        first[k] = cut;
        open_rings(k + 1, first, end);
        append(start, layers);
    }

    void divide(const Index &first, const Index &end) {
        const size_t k = longest(first, end);
        const int64_t reach = std::max<int64_t>(axes_[k].reach, 1), length = end[k] - first[k];
        if (length < smallest * reach) {
            return append(first, end);
        }
        Index lower_end = end, upper_first = first, layers = first, layers_end = end;
        lower_end[k] = layers[k] = first[k] + (length - reach) / 2;
        upper_first[k] = layers_end[k] = lower_end[k] + reach;
        divide(first, lower_end);
        divide(upper_first, end);
        append(layers, layers_end);
    }

    // The axis along which the part is longest, in units of the reach.
    [[nodiscard]] size_t longest(const Index &first, const Index &end) const noexcept {
        size_t best = 0;
        for (size_t k = 1; k < first.size(); ++k) {
            const int64_t own = (end[k] - first[k]) * std::max<int64_t>(axes_[best].reach, 1);
            const int64_t other = (end[best] - first[best]) * std::max<int64_t>(axes_[k].reach, 1);
            best = own > other ? k : best;
        }
        return best;
    }

    void append(const Index &first, const Index &end) {
        for (int64_t i = first[0]; i < end[0]; ++i) {
            for (int64_t j = first[1]; j < end[1]; ++j) {
                for (int64_t k = first[2]; k < end[2]; ++k) {
                    order_.push_back((i * axes_[1].count + j) * axes_[2].count + k);
                }
            }
        }
    }

    static constexpr int64_t smallest = 4; // smaller parts are not divided; in units of the reach

    const std::array<GridAxis, 3> &axes_;
    std::vector<int64_t> order_;
};

} // namespace

std::vector<int64_t> grid_order(const std::array<GridAxis, 3> &axes) {
    return Dissection(axes).take();
}

} // namespace nrb::inline numeric
