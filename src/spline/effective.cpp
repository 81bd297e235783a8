// SPDX-License-Identifier: MIT
// Spline::effective(): control points without influence on the domain replaced by others.
#include "base/numbers.h"
#include "spline/spline.h"

#include <algorithm>
#include <array>

namespace nrb::inline spline {

namespace {

// The block of control points whose functions do not vanish on the domain.
class ActiveBlock {
public:
    explicit ActiveBlock(const Spline &spline) noexcept : axes_(spline.axes()) {
        for (int k = 0; k < axes_; ++k) {
            counts_[static_cast<size_t>(k)] = spline.count(k);
            layers_[static_cast<size_t>(k)] = spline.axis(k).active_layers();
        }
    }

    // The control point of the block nearest to control point i in the net.
    [[nodiscard]] int64_t nearest(int64_t i) const noexcept {
        int64_t result = 0, stride = 1;
        for (auto k = static_cast<size_t>(axes_); k-- > 0; i /= counts_[k], stride *= counts_[k]) {
            result += stride * std::clamp(i % counts_[k], layers_[k].first, layers_[k].end - 1);
        }
        return result;
    }

    // Calls visit(first control point, count) for the rows of the block along the last axis.
    template <class Visit>
    void for_each_row(Visit &&visit) const {
        const auto last = static_cast<size_t>(axes_ - 1);
        std::array<int64_t, max_axes> counts{1, 1, 1};
        std::array<KnotVector::Layers, max_axes> layers{{{0, 1}, {0, 1}, {0, 1}}};
        for (size_t k = 0; k <= last; ++k) {
            counts[max_axes - 1 - last + k] = counts_[k];
            layers[max_axes - 1 - last + k] = layers_[k];
        }
        for (int64_t i = layers[0].first; i < layers[0].end; ++i) {
            for (int64_t j = layers[1].first; j < layers[1].end; ++j) {
                visit((i * counts[1] + j) * counts[2] + layers[2].first, layers[2].end - layers[2].first);
            }
        }
    }

private:
    int axes_;
    std::array<int64_t, max_axes> counts_{};
    std::array<KnotVector::Layers, max_axes> layers_{};
};

} // namespace

Spline::WeightRange Spline::active_weight_range() const noexcept {
    WeightRange range{infinity, -infinity};
    ActiveBlock(*this).for_each_row([&](int64_t first, int64_t count) {
        const WeightRange row = weight_range(first, count);
        range = {std::min(range.smallest, row.smallest), std::max(range.largest, row.largest)};
    });
    return range;
}

const Spline &Spline::effective() const {
    return inert_ ? *effective_.get([this] { return without_inert_points(); }) : *this;
}

// A control point outside the active block is replaced by the nearest one inside. In Form::rational, a
// control point of weight 0 keeps its weight and gets the position of the first one whose weight is not 0.
// Both rules treat all copies of a layer of a periodic axis alike, so these stay copies.
SplinePtr Spline::without_inert_points() const {
    const ActiveBlock block(*this);
    const auto weightless = [&](int64_t i) { return form_ == Form::rational && weight(i) == 0; };
    int64_t placed = 0;
    while (placed + 1 < point_count() && weightless(block.nearest(placed))) {
        ++placed;
    }
    placed = block.nearest(placed);
    std::vector<double> points, weights;
    points.reserve(points_.size());
    for (int64_t i = 0; i < point_count(); ++i) {
        const int64_t nearest = block.nearest(i);
        const int64_t place = weightless(nearest) ? placed : nearest;
        const auto from = points_.begin() + static_cast<std::ptrdiff_t>(place) * stored_width();
        points.insert(points.end(), from, from + stored_width());
        if (form_ == Form::rational) {
            weights.push_back(weight(nearest));
        }
    }
    auto result = std::make_shared<Spline>(axes_, dim_, form_, std::move(points), std::move(weights));
    result->inert_ = false;
    return result;
}

} // namespace nrb::inline spline
