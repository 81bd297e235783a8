// SPDX-License-Identifier: MIT
#include "fit/mixed_derivatives.h"

#include <algorithm>
#include <cmath>

namespace nrb::fit {

namespace {

// Finite difference weights: the factors of the values at the nodes in derivative `order` at t of the
// polynomial through them (B. Fornberg, "Generation of finite difference formulas on arbitrarily spaced
// grids", Math. Comp. 51 (1988)).
std::vector<double> derivative_weights(const std::vector<double> &nodes, double t, int order) {
    const auto orders = static_cast<size_t>(order) + 1;
    std::vector<double> weights(nodes.size() * orders, 0.0); // [nodes][orders]
    weights[0] = 1;
    double before = 1;
    for (size_t n = 1; n < nodes.size(); ++n) {
        double product = 1;
        double *const own = weights.data() + n * orders, *const previous = own - orders;
        for (size_t j = 0; j < n; ++j) {
            const double step = nodes[n] - nodes[j];
            product *= step;
            double *const other = weights.data() + j * orders;
            if (j == n - 1) {
                for (size_t m = orders; m-- > 0;) {
                    const double lower = m > 0 ? static_cast<double>(m) * previous[m - 1] : 0;
                    own[m] = before / product * (lower - (nodes[n - 1] - t) * previous[m]);
                }
            }
            for (size_t m = orders; m-- > 0;) {
                const double lower = m > 0 ? static_cast<double>(m) * other[m - 1] : 0;
                other[m] = ((nodes[n] - t) * other[m] - lower) / step;
            }
        }
        before = product;
    }
    std::vector<double> result;
    for (size_t j = 0; j < nodes.size(); ++j) {
        result.push_back(weights[j * orders + static_cast<size_t>(order)]);
    }
    return result;
}

// A layer of derivatives as a linear combination of layers of values.
struct Difference {
    std::vector<int64_t> layers;
    std::vector<double> weights;
};

Difference difference_for(const AxisLayers &axis, int degree, int64_t layer) {
    Difference result;
    const bool start = axis.param(layer) == axis.params.front();
    std::vector<double> nodes;
    for (int64_t j = 0; j < axis.count() && std::ssize(nodes) <= degree; ++j) {
        const int64_t i = start ? j : axis.count() - 1 - j;
        if (axis.order(i) == 0) {
            nodes.push_back(axis.param(i));
            result.layers.push_back(i);
        }
    }
    result.weights = derivative_weights(nodes, axis.param(layer), axis.order(layer));
    return result;
}

class MixedEstimates {
public:
    MixedEstimates(const std::vector<AxisLayers> &axes, const std::vector<int> &degrees, PointGrid &grid)
        : axes_(axes), degrees_(degrees), grid_(grid), place_(axes.size()) {}

    // Mixed derivatives along two axes first, because those along three are estimated from them.
    void run() {
        for (int along = 2; along <= static_cast<int>(axes_.size()); ++along) {
            visit(0, 0, along);
        }
    }

private:
    void visit(size_t k, int so_far, int along) {
        if (k == axes_.size()) {
            if (so_far == along) {
                estimate(along);
            }
            return;
        }
        for (place_[k] = 0; place_[k] < axes_[k].count(); ++place_[k]) {
            const int with = so_far + (axes_[k].order(place_[k]) > 0 ? 1 : 0);
            if (with + static_cast<int>(axes_.size() - k) - 1 >= along) {
                visit(k + 1, with, along);
            }
        }
    }

    [[nodiscard]] double *point() noexcept {
        int64_t index = 0;
        for (size_t k = 0; k < place_.size(); ++k) {
            index = index * axes_[k].count() + place_[k];
        }
        return grid_.points.data() + index * grid_.dim;
    }

    void estimate(int along) {
        double *const own = point();
        for (int c = 0; c < grid_.dim; ++c) {
            if (std::isnan(own[c])) {
                double sum = 0;
                for (size_t k = 0; k < axes_.size(); ++k) {
                    sum += axes_[k].order(place_[k]) > 0 ? estimate_along(k, c) : 0;
                }
                own[c] = sum / along;
            }
        }
    }

    [[nodiscard]] double estimate_along(size_t k, int component) {
        const int64_t layer = place_[k];
        const Difference difference = difference_for(axes_[k], degrees_[k], layer);
        double sum = 0;
        for (size_t j = 0; j < difference.layers.size(); ++j) {
            place_[k] = difference.layers[j];
            sum += difference.weights[j] * point()[component];
        }
        place_[k] = layer;
        return sum;
    }

    const std::vector<AxisLayers> &axes_;
    const std::vector<int> &degrees_;
    PointGrid &grid_;
    std::vector<int64_t> place_;
};

} // namespace

bool is_mixed(const std::vector<AxisLayers> &axes, const std::vector<int64_t> &place) noexcept {
    int along = 0;
    for (size_t k = 0; k < axes.size(); ++k) {
        along += axes[k].order(place[k]) > 0 ? 1 : 0;
    }
    return along > 1;
}

void estimate_mixed(const std::vector<AxisLayers> &axes, const std::vector<int> &degrees, PointGrid &grid) {
    MixedEstimates(axes, degrees, grid).run();
}

} // namespace nrb::fit
