// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "numeric/solvers/sparse/dense_product.cpp"
#include "base/dispatch.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "base/watch.h"
#include "numeric/solvers/sparse/dense_product.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#ifndef NURBS_DENSE_PRODUCT_GROUP
#define NURBS_DENSE_PRODUCT_GROUP
namespace nrb::inline numeric {

// Number of columns of c computed together; the elements of b that belong to them are stored side by side.
inline constexpr int64_t product_group = 4;

} // namespace nrb::inline numeric
#endif

HWY_BEFORE_NAMESPACE();
namespace nrb::inline numeric {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using ProductLanes = hn::ScalableTag<double>;
using ProductVector = hn::Vec<ProductLanes>;

// A tile of `vectors` vectors of rows by a group of columns, kept in registers.
template <int vectors, int64_t columns>
HWY_INLINE void product_tile(const ColumnMajor<double> &c, const ColumnMajor<const double> &a,
                             const double *b, int64_t row, int64_t column) {
    const ProductLanes d;
    const size_t lanes = hn::Lanes(d);
    ProductVector sums[columns][vectors];
    double *const target = c.values + column * c.stride + row;
    for (int64_t j = 0; j < columns; ++j) {
        for (size_t v = 0; v < vectors; ++v) {
            sums[j][v] = hn::LoadU(d, target + j * c.stride + v * lanes);
        }
    }
    const double *from = a.values + row;
    for (int64_t p = 0; p < a.columns; ++p, from += a.stride, b += product_group) {
        ProductVector own[vectors];
        for (size_t v = 0; v < vectors; ++v) {
            own[v] = hn::LoadU(d, from + v * lanes);
        }
        for (int64_t j = 0; j < columns; ++j) {
            const ProductVector factor = hn::Set(d, b[j]);
            for (size_t v = 0; v < vectors; ++v) {
                sums[j][v] = hn::Sub(sums[j][v], hn::Mul(own[v], factor));
            }
        }
    }
    for (int64_t j = 0; j < columns; ++j) {
        for (size_t v = 0; v < vectors; ++v) {
            hn::StoreU(sums[j][v], d, target + j * c.stride + v * lanes);
        }
    }
}

// For the rows that do not fill a vector.
HWY_INLINE void product_element(const ColumnMajor<double> &c, const ColumnMajor<const double> &a,
                                const double *b, int64_t row, int64_t column) {
    double sum = c.values[column * c.stride + row];
    for (int64_t p = 0; p < a.columns; ++p) {
        sum -= a.values[p * a.stride + row] * b[p * product_group];
    }
    c.values[column * c.stride + row] = sum;
}

template <int vectors>
HWY_INLINE void product_rows(const ColumnMajor<double> &c, const ColumnMajor<const double> &a,
                             const double *packed, int64_t row, int64_t columns) {
    int64_t j = 0;
    for (; j + product_group <= columns; j += product_group) {
        product_tile<vectors, product_group>(c, a, packed + j * a.columns, row, j);
    }
    switch (const double *const b = packed + j * a.columns; columns - j) {
    case 3:
        return product_tile<vectors, 3>(c, a, b, row, j);
    case 2:
        return product_tile<vectors, 2>(c, a, b, row, j);
    case 1:
        return product_tile<vectors, 1>(c, a, b, row, j);
    default:
        return;
    }
}

void subtract_packed(const ColumnMajor<double> &c, const ColumnMajor<const double> &a, const double *packed,
                     bool lower) {
    constexpr int wide = 3;
    const auto lanes = static_cast<int64_t>(hn::Lanes(ProductLanes()));
    const auto columns = [&](int64_t end) { return lower ? std::min(c.columns, end) : c.columns; };
    int64_t row = 0;
    for (; row + wide * lanes <= c.rows; row += wide * lanes) {
        product_rows<wide>(c, a, packed, row, columns(row + wide * lanes));
    }
    for (; row + lanes <= c.rows; row += lanes) {
        product_rows<1>(c, a, packed, row, columns(row + lanes));
    }
    for (; row < c.rows; ++row) {
        for (int64_t j = 0; j < columns(row + 1); ++j) {
            product_element(c, a, packed + j / product_group * product_group * a.columns + j % product_group,
                            row, j);
        }
    }
}

} // namespace HWY_NAMESPACE
} // namespace nrb::inline numeric
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace nrb::inline numeric {

namespace {

// Packs b into groups of columns of c, each [depth][product_group].
void pack(const ColumnMajor<const double> &b, std::vector<double> &packed) {
    packed.assign(
        static_cast<size_t>((b.rows + product_group - 1) / product_group * product_group * b.columns), 0.0);
    for (int64_t first = 0; first < b.rows; first += product_group) {
        double *to = packed.data() + first * b.columns;
        const int64_t some = std::min(product_group, b.rows - first);
        for (int64_t p = 0; p < b.columns; ++p, to += product_group) {
            std::copy_n(b.values + p * b.stride + first, some, to);
        }
    }
}

} // namespace

NURBS_FORMS(subtract_packed);

void subtract_product(const ColumnMajor<double> &c, const ColumnMajor<const double> &a,
                      const ColumnMajor<const double> &b, bool lower) {
    constexpr int64_t deepest = 64; // the depth of a block that stays in the cache
    std::vector<double> packed;
    for (int64_t first = 0; first < a.columns; first += deepest) {
        const int64_t depth = std::min(deepest, a.columns - first);
        pack({b.values + first * b.stride, b.rows, depth, b.stride}, packed);
        NURBS_BEST(subtract_packed)
        (c, {a.values + first * a.stride, a.rows, depth, a.stride}, packed.data(), lower);
        count_work(c.rows * c.columns * depth / (lower ? 2 : 1));
    }
}

} // namespace nrb::inline numeric
#endif
