// SPDX-License-Identifier: MIT
#include "intersect/extrema/constant_layers.h"

#include <algorithm>

namespace nrb::intersect {

namespace {

// The multiplicity of the knot at an end of a span; the degree at most.
int copies(const KnotVector &axis, int64_t span, bool upper) noexcept {
    const int64_t first = upper ? span + 1 : span, step = upper ? 1 : -1;
    int count = 0;
    for (int64_t i = first; count < axis.degree() && axis[i] == axis[first]; i += step) {
        ++count;
    }
    return count;
}

// The control points that are active on a span, or at an end of it, by their position along each axis.
class Window {
public:
    Window(const Spline &spline, const std::array<int64_t, max_axes> &spans, const Sides &sides)
        : spline_(spline) {
        for (int k = 0; k < spline.axes(); ++k) {
            const auto at = static_cast<size_t>(k);
            const int p = spline.axis(k).degree();
            const bool upper = sides[at] == Side::upper;
            const int fixed = sides[at] == Side::none ? 0 : copies(spline.axis(k), spans[at], upper);
            sizes_[at] = p + 1 - fixed;
            first_[at] = spans[at] - p + (upper ? fixed : 0);
            counts_[at] = spline.count(k);
        }
    }
    // Whether all control points of a layer have a value.
    [[nodiscard]] bool is(int axis, int layer, double value) const noexcept {
        std::array<int, max_axes> from{}, to = sizes_;
        from[static_cast<size_t>(axis)] = layer;
        to[static_cast<size_t>(axis)] = layer + 1;
        for (int i = from[0]; i < to[0]; ++i) {
            for (int j = from[1]; j < to[1]; ++j) {
                for (int l = from[2]; l < to[2]; ++l) {
                    if (at({i, j, l}) != value) {
                        return false;
                    }
                }
            }
        }
        return true;
    }
    [[nodiscard]] double at(const std::array<int, max_axes> &i) const noexcept {
        const int64_t index =
            ((first_[0] + i[0]) * counts_[1] + first_[1] + i[1]) * counts_[2] + first_[2] + i[2];
        return spline_.points()[static_cast<size_t>(index)];
    }

private:
    const Spline &spline_;
    std::array<int, max_axes> sizes_{1, 1, 1};
    std::array<int64_t, max_axes> first_{}, counts_{1, 1, 1};
};

} // namespace

// Let the knot at an end of the span have m copies. Number the p + 1 active control points, and their basis
// functions, i = 0, ..., p from there, and let the first q control points have the value c. The functions
// that do not vanish at the knot are those with i <= p - m. Let q > p - m. Setting all control points before
// the active ones to c does not change the spline on the span, and makes it c just beyond the knot. The
// functions with i >= q vanish to the order i at the knot, so f - c vanishes to the order q there.
ConstantLayers constant_layers(const Spline &spline, const std::array<int64_t, max_axes> &spans,
                               const Sides &sides) {
    ConstantLayers result;
    if (spline.form() == Form::homogeneous) {
        return result;
    }
    const Window window(spline, spans, sides);
    for (int k = 0; k < spline.axes(); ++k) {
        const auto at = static_cast<size_t>(k);
        if (sides[at] != Side::none) {
            continue;
        }
        const int p = spline.axis(k).degree();
        for (const bool upper : {false, true}) {
            std::array<int, max_axes> corner{};
            corner[at] = upper ? p : 0;
            const double value = window.at(corner);
            int q = 0;
            while (q <= p && window.is(k, upper ? p - q : q, value)) {
                ++q;
            }
            result.all = q == p + 1;
            result.value = value;
            result.layers[at][upper ? 1 : 0] = q > p - copies(spline.axis(k), spans[at], upper) ? q : 0;
        }
    }
    return result;
}

void set_zero(RoundedPolynomial &f, int axis, bool upper, int layers) noexcept {
    const AxisLayers net = f.shape.along(axis);
    for (int64_t o = 0; o < net.outer; ++o) {
        for (int layer = 0; layer < std::min(layers, net.degree + 1); ++layer) {
            for (int64_t i = 0; i < net.inner; ++i) {
                const auto at = static_cast<size_t>(net.at(o, upper ? net.degree - layer : layer, i));
                f.values[at] = f.errors[at] = 0;
            }
        }
    }
}

} // namespace nrb::intersect
