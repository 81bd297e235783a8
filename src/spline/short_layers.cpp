// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "spline/short_layers.cpp"
#include "base/dispatch.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "spline/short_layers.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace nrb::inline spline {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Lanes = hn::CappedTag<double, 4>;
inline constexpr auto lanes = static_cast<int64_t>(hn::MaxLanes(Lanes()));
inline constexpr int64_t parts = 4 / lanes;

struct Sum {
    hn::Vec<Lanes> values[parts];

    HWY_INLINE Sum(const double *coefficients, int size, const double *layers, int64_t width) {
        const auto factor = hn::Set(Lanes(), coefficients[0]);
        for (int64_t part = 0; part < parts; ++part) {
            values[part] = hn::Mul(factor, hn::LoadU(Lanes(), layers + part * lanes));
        }
        int i = 1;
        for (; i + 2 < size; i += 3) { // as in cubics
            add(coefficients[i], layers + i * width);
            add(coefficients[i + 1], layers + (i + 1) * width);
            add(coefficients[i + 2], layers + (i + 2) * width);
        }
        for (; i < size; ++i) {
            add(coefficients[i], layers + i * width);
        }
    }
    HWY_INLINE void add(double coefficient, const double *layer) {
        const auto factor = hn::Set(Lanes(), coefficient);
        for (int64_t part = 0; part < parts; ++part) {
            values[part] = hn::Add(values[part], hn::Mul(factor, hn::LoadU(Lanes(), layer + part * lanes)));
        }
    }
    HWY_INLINE void store(double *out) const {
        for (int64_t part = 0; part < parts; ++part) {
            hn::StoreU(values[part], Lanes(), out + part * lanes);
        }
    }
    HWY_INLINE void divide_by(double weight) {
        const auto divisor = hn::Set(Lanes(), weight);
        for (int64_t part = 0; part < parts; ++part) {
            values[part] = hn::Div(values[part], divisor);
        }
    }
    [[nodiscard]] HWY_INLINE double component(int c) const {
        HWY_ALIGN double all[4];
        store(all);
        return all[c];
    }
};

// Stores whole vectors: what is written beyond the end of a row is overwritten by the next one.
void combine_plain(const LayerRows &rows, const double *layers, int width, double *HWY_RESTRICT out) {
    const double *coefficients = rows.coefficients;
    for (const LayerTable::Row &row : rows.rows) {
        const double *from = layers + row.first * width;
        if (row.size == 0) {
            std::copy_n(from, width, out);
        } else {
            Sum(coefficients + row.offset, row.size, from, width).store(out);
        }
        out += width;
    }
}

template <int kDim>
bool combine_rational(const LayerRows &rows, const ShortNet &net, double *HWY_RESTRICT points,
                      double *HWY_RESTRICT weights) {
    const ShortNet from = net; // kept in registers, as are the coefficients
    const double *coefficients = rows.coefficients;
    const LayerTable::Row *last = nullptr;
    auto least = hn::Set(Lanes(), 1.0); // least |component| of the sums, at most 1
    for (const LayerTable::Row &row : rows.rows) {
        if (row.size == 0) {
            std::copy_n(from.points + row.first * kDim, kDim, points);
            *weights = from.weights[row.first];
        } else if (last != nullptr && row.repeats(*last)) {
            std::copy_n(points - kDim, kDim, points);
            *weights = weights[-1];
        } else {
            Sum sum(coefficients + row.offset, row.size, from.records + row.first * (kDim + 1), kDim + 1);
            *weights = sum.component(kDim);
            least = hn::Min(least, hn::Abs(sum.values[kDim / lanes]));
            sum.divide_by(*weights);
            sum.store(points);
        }
        last = &row;
        points += kDim;
        ++weights;
    }
    HWY_ALIGN double magnitudes[lanes];
    hn::Store(least, Lanes(), magnitudes);
    return magnitudes[kDim % lanes] != 0;
}

bool combine_quotients(const LayerRows &rows, const ShortNet &net, double *points, double *weights) {
    switch (net.dim) {
    case 1:
        return combine_rational<1>(rows, net, points, weights);
    case 2:
        return combine_rational<2>(rows, net, points, weights);
    default:
        return combine_rational<3>(rows, net, points, weights);
    }
}

} // namespace HWY_NAMESPACE
} // namespace nrb::inline spline
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace nrb::inline spline {

NURBS_FORMS(combine_plain);
NURBS_FORMS(combine_quotients);

void combine_short(const LayerRows &rows, const double *layers, int width, double *out) noexcept {
    NURBS_BEST(combine_plain)(rows, layers, width, out);
}

bool combine_short(const LayerRows &rows, const ShortNet &net, double *points, double *weights) noexcept {
    return NURBS_BEST(combine_quotients)(rows, net, points, weights);
}

} // namespace nrb::inline spline
#endif
