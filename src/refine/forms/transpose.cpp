// SPDX-License-Identifier: MIT
#include "refine/forms/transpose.h"

#include <algorithm>
#include <array>

namespace nrb::refine {

namespace {

void check_permutation(int axes, const int32_t *permutation) {
    for (int k = 0; k < axes; ++k) {
        if (permutation[k] < 0 || permutation[k] >= axes) {
            fail(Status::axis, "permutation[%d] = %d, expected 0 to %d", k, permutation[k], axes - 1);
        }
        for (int j = 0; j < k; ++j) {
            if (permutation[j] == permutation[k]) {
                fail(Status::axis, "permutation[%d] = %d is also permutation[%d]; expected each axis once", k,
                     permutation[k], j);
            }
        }
    }
}

// The control points in their new order: for each new axis, its count and the stride of its layers in the old
// net. Missing axes have one layer.
struct Order {
    std::array<int64_t, max_axes> counts;
    std::array<int64_t, max_axes> strides;
};

Order order_of(const Spline &spline, const int32_t *permutation) noexcept {
    std::array<int64_t, max_axes> strides{};
    int64_t stride = 1;
    for (int k = spline.axes(); k-- > 0;) {
        strides[static_cast<size_t>(k)] = stride;
        stride *= spline.count(k);
    }
    Order order{{1, 1, 1}, {0, 0, 0}};
    for (int k = 0; k < spline.axes(); ++k) {
        order.counts[static_cast<size_t>(k)] = spline.count(permutation[k]);
        order.strides[static_cast<size_t>(k)] = strides[static_cast<size_t>(permutation[k])];
    }
    return order;
}

// Each control point has `width` values.
std::vector<double> reordered(std::span<const double> values, int64_t width, const Order &order) {
    std::vector<double> result(values.size());
    auto target = result.begin();
    for (int64_t i = 0; i < order.counts[0] && !values.empty(); ++i) {
        for (int64_t j = 0; j < order.counts[1]; ++j) {
            for (int64_t k = 0; k < order.counts[2]; ++k) {
                const int64_t place = i * order.strides[0] + j * order.strides[1] + k * order.strides[2];
                target = std::copy_n(values.begin() + place * width, width, target);
            }
        }
    }
    return result;
}

} // namespace

SplinePtr transpose(const Spline &spline, const int32_t *permutation) {
    check_permutation(spline.axes(), permutation);
    const Order order = order_of(spline, permutation);
    Spline::Axes axes;
    for (int k = 0; k < spline.axes(); ++k) {
        axes.push_back(spline.knot_vectors()[static_cast<size_t>(permutation[k])]);
    }
    return std::make_shared<const Spline>(std::move(axes), spline.dim(), spline.form(),
                                          reordered(spline.points(), spline.stored_width(), order),
                                          reordered(spline.weights(), 1, order));
}

} // namespace nrb::refine
