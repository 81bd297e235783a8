#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "spline/short_layers.cpp"
#include "base/simd.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "spline/short_layers.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace nrb {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Lanes = hn::CappedTag<double, 4>;
inline constexpr int lanes = static_cast<int>(hn::MaxLanes(Lanes()));
inline constexpr int parts = 4 / lanes;

struct Sum {
    hn::Vec<Lanes> values[parts];

    HWY_INLINE Sum(const double *coefficients, int size, const double *layers, int64_t width) {
        const Lanes d;
        auto factor = hn::Set(d, coefficients[0]);
        for (int part = 0; part < parts; ++part) {
            values[part] = hn::Mul(factor, hn::LoadU(d, layers + part * lanes));
        }
        for (int i = 1; i < size; ++i) {
            layers += width;
            factor = hn::Set(d, coefficients[i]);
            for (int part = 0; part < parts; ++part) {
                values[part] = hn::Add(values[part], hn::Mul(factor, hn::LoadU(d, layers + part * lanes)));
            }
        }
    }
    HWY_INLINE void store(double *out) const {
        for (int part = 0; part < parts; ++part) {
            hn::StoreU(values[part], Lanes(), out + part * lanes);
        }
    }
    HWY_INLINE void divide_by(double weight) {
        const auto divisor = hn::Set(Lanes(), weight);
        for (int part = 0; part < parts; ++part) {
            values[part] = hn::Div(values[part], divisor);
        }
    }
    [[nodiscard]] HWY_INLINE double component(int c) const {
        HWY_ALIGN double all[4];
        store(all);
        return all[c];
    }
};

// What is written behind a row is overwritten by the next one.
void combine_plain(const LayerTable &table, const double *layers, int width, double *HWY_RESTRICT out) {
    for (int64_t r = 0; r < table.rows(); ++r, out += width) {
        const LayerTable::Row &row = table.row(r);
        const double *from = layers + row.first * width;
        if (row.size == 0) {
            std::copy_n(from, width, out);
        } else {
            Sum(table.coefficients(row), row.size, from, width).store(out);
        }
    }
}

template <int kDim>
bool combine_rational(const LayerTable &table, const ShortNet &net, double *HWY_RESTRICT points,
                      double *HWY_RESTRICT weights) {
    bool weighted = true;
    for (int64_t r = 0; r < table.rows(); ++r, points += kDim) {
        const LayerTable::Row &row = table.row(r);
        if (row.size == 0) {
            std::copy_n(net.points + row.first * kDim, kDim, points);
            weights[r] = net.weights[row.first];
            continue;
        }
        Sum sum(table.coefficients(row), row.size, net.records + row.first * (kDim + 1), kDim + 1);
        weights[r] = sum.component(kDim);
        weighted = weighted && weights[r] != 0;
        sum.divide_by(weights[r]);
        sum.store(points);
    }
    return weighted;
}

bool combine_quotients(const LayerTable &table, const ShortNet &net, double *points, double *weights) {
    switch (net.dim) {
    case 1:
        return combine_rational<1>(table, net, points, weights);
    case 2:
        return combine_rational<2>(table, net, points, weights);
    default:
        return combine_rational<3>(table, net, points, weights);
    }
}

} // namespace HWY_NAMESPACE
} // namespace nrb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace nrb {

HWY_EXPORT(combine_plain);
HWY_EXPORT(combine_quotients);

void combine_short(const LayerTable &table, const double *layers, int width, double *out) noexcept {
    HWY_DYNAMIC_DISPATCH(combine_plain)(table, layers, width, out);
}

bool combine_short(const LayerTable &table, const ShortNet &net, double *points, double *weights) noexcept {
    return HWY_DYNAMIC_DISPATCH(combine_quotients)(table, net, points, weights);
}

} // namespace nrb
#endif
