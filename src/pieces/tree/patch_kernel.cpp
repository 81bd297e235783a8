// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pieces/tree/patch_kernel.cpp"
#include "base/dispatch.h"

#include <hwy/foreach_target.h>

#include "pieces/tree/patch_kernel.h"

#include "bernstein/de_casteljau.h"
#include "eval/kernels/contraction.h"
#include "numeric/binomial.h"

#include <algorithm>
#include <limits>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace nrb::pieces {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Four = hn::CappedTag<double, 4>;
inline constexpr int four_lanes = static_cast<int>(hn::MaxLanes(Four()));

void shift(const PatchShape &shape, const double *HWY_RESTRICT patch, const double *HWY_RESTRICT x,
           double *HWY_RESTRICT out) {
    const Four d;
    const int64_t count = shape.coefficients();
    for (int64_t i = 0; i < count; ++i, patch += shape.lanes, out += shape.lanes) {
        const auto w = hn::Set(d, patch[shape.dim]);
        for (int l = 0; l < shape.lanes; l += four_lanes) {
            hn::StoreU(hn::NegMulAdd(w, hn::LoadU(d, x + l), hn::LoadU(d, patch + l)), d, out + l);
        }
    }
}

// out[l] = sum of factors[i] * rows[i * stride + l], l < length, a multiple of 4.
template <int kRows>
HWY_INLINE void combine_rows(const double *HWY_RESTRICT factors, int n, const double *HWY_RESTRICT rows,
                             int64_t stride, int64_t length, double *HWY_RESTRICT out) {
    const Four d;
    const int count = kRows > 0 ? kRows : n;
    for (int64_t l = 0; l < length; l += four_lanes) {
        const double *from = rows + l;
        auto sum = hn::Mul(hn::Set(d, factors[0]), hn::LoadU(d, from));
        for (int i = 1; i < count; ++i) {
            from += stride;
            sum = hn::MulAdd(hn::Set(d, factors[i]), hn::LoadU(d, from), sum);
        }
        hn::StoreU(sum, d, out + l);
    }
}

HWY_INLINE void combine(const double *factors, int n, const double *rows, int64_t stride, int64_t length,
                        double *out) {
    switch (n) {
    case 3:
        return combine_rows<3>(factors, n, rows, stride, length, out);
    case 4:
        return combine_rows<4>(factors, n, rows, stride, length, out);
    default:
        return combine_rows<-1>(factors, n, rows, stride, length, out);
    }
}

inline constexpr int most_rows = max_degree + 1;

void evaluate(const PatchShape &shape, const double *HWY_RESTRICT patch, const AxisValues &at, int order,
              double *HWY_RESTRICT work, double *HWY_RESTRICT out) {
    int64_t length = shape.values();
    if (shape.axes == 0) {
        std::copy_n(patch, length, out);
        return;
    }
    const double *from = patch;
    for (int k = 0; k < shape.axes; ++k) {
        const int n = shape.degree(k) + 1;
        double functions[3][most_rows];
        bernstein_functions(n - 1, at[static_cast<size_t>(k)], order, most_rows, functions[0]);
        const int64_t whole = length;
        length /= n;
        double *to = k + 1 == shape.axes ? out : work;
        eval::for_each_step(k, order, [&](int64_t source, int a, int64_t target) {
            combine(functions[a], n, from + source * whole, length, length, to + target * length);
        });
        from = to;
        work += eval::slot_count(k + 1, order) * length;
    }
}

void apply(const PatchShape &shape, int axis, const double *matrix, const double *HWY_RESTRICT patch,
           double *HWY_RESTRICT out) {
    const int n = shape.degree(axis) + 1;
    int64_t outer = 1, inner = shape.lanes;
    for (int k = 0; k < shape.axes; ++k) {
        (k < axis ? outer : inner) *= k == axis ? 1 : shape.degree(k) + 1;
    }
    for (int64_t o = 0; o < outer; ++o, patch += n * inner) {
        for (int i = 0; i < n; ++i, out += inner) {
            combine(matrix + i * n, n, patch, inner, inner, out);
        }
    }
}

// The same along the first axis of a part of a larger net, whose rows lie apart.
void gather(const NetPart &net, int n, const double *matrix, double *HWY_RESTRICT out) {
    for (int i = 0; i < n; ++i) {
        for (int64_t m = 0; m < net.middle; ++m, out += net.run) {
            combine(matrix + i * n, n, net.first + m * net.middle_stride, net.stride, net.run, out);
        }
    }
}

// Sums of the products of coefficients, coordinate by coordinate; each pair is taken once.
template <int kVectors>
HWY_INLINE void add_products(const PatchShape &shape, const SquareTables &tables, const double *scaled,
                             double *sums) {
    const Four d;
    const auto count = static_cast<int>(shape.coefficients());
    const int vectors = kVectors > 0 ? kVectors : shape.lanes / four_lanes;
    for (int a = 0; a < count; ++a) {
        const double *left = scaled + static_cast<int64_t>(a) * shape.lanes;
        double *row = sums + static_cast<int64_t>(tables.offsets[a]) * shape.lanes;
        for (int v = 0; v < vectors; ++v) {
            const auto once = hn::LoadU(d, left + v * four_lanes);
            const auto twice = hn::Add(once, once);
            double *place = row + static_cast<int64_t>(tables.offsets[a]) * shape.lanes + v * four_lanes;
            hn::StoreU(hn::MulAdd(once, once, hn::LoadU(d, place)), d, place);
            const double *right = left + v * four_lanes;
            for (int b = a + 1; b < count; ++b) {
                right += shape.lanes;
                double *target = row + static_cast<int64_t>(tables.offsets[b]) * shape.lanes + v * four_lanes;
                hn::StoreU(hn::MulAdd(twice, hn::LoadU(d, right), hn::LoadU(d, target)), d, target);
            }
        }
    }
}

void square(const PatchShape &shape, const SquareTables &tables, const double *HWY_RESTRICT patch,
            double *HWY_RESTRICT work, double *HWY_RESTRICT squares, double *HWY_RESTRICT weights) {
    const Four d;
    const int64_t count = shape.coefficients(), products = shape.products();
    double *scaled = work, *sums = work + shape.values();
    for (int64_t i = 0; i < count; ++i) {
        const auto factor = hn::Set(d, tables.binomials[i]);
        for (int l = 0; l < shape.lanes; l += four_lanes) {
            const int64_t at = i * shape.lanes + l;
            hn::StoreU(hn::Mul(factor, hn::LoadU(d, patch + at)), d, scaled + at);
        }
    }
    std::fill_n(sums, products * shape.lanes, 0.0);
    if (shape.lanes == four_lanes) {
        add_products<1>(shape, tables, scaled, sums);
    } else {
        add_products<-1>(shape, tables, scaled, sums);
    }
    for (int64_t i = 0; i < products; ++i, sums += shape.lanes) {
        double total = sums[0];
        for (int c = 1; c < shape.dim; ++c) {
            total += sums[c];
        }
        squares[i] = total * tables.inverses[i];
        if (shape.weighted) {
            weights[i] = sums[shape.dim] * tables.inverses[i];
        }
    }
}

double gap(int64_t count, const double *HWY_RESTRICT squares, const double *HWY_RESTRICT weights, double sign,
           double rho2, double margin, double *HWY_RESTRICT out) {
    const Four d;
    const auto factor = hn::Set(d, sign), square = hn::Set(d, rho2), less = hn::Set(d, margin);
    auto least = hn::Set(d, std::numeric_limits<double>::infinity());
    int64_t i = 0;
    for (; i + four_lanes <= count; i += four_lanes) {
        const auto w = weights != nullptr ? hn::LoadU(d, weights + i) : hn::Set(d, 1.0);
        const auto value = hn::Mul(factor, hn::NegMulAdd(square, w, hn::LoadU(d, squares + i)));
        hn::StoreU(value, d, out + i);
        least = hn::Min(least, hn::NegMulAdd(less, w, value));
    }
    double result = hn::GetLane(hn::MinOfLanes(d, least));
    for (; i < count; ++i) {
        const double w = weights != nullptr ? weights[i] : 1.0;
        out[i] = sign * (squares[i] - rho2 * w);
        result = std::min(result, out[i] - margin * w);
    }
    return result;
}

} // namespace HWY_NAMESPACE
} // namespace nrb::pieces
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace nrb::pieces {

NURBS_FORMS(shift);
NURBS_FORMS(evaluate);
NURBS_FORMS(apply);
NURBS_FORMS(gather);
NURBS_FORMS(square);
NURBS_FORMS(gap);

void shift_patch(const PatchShape &shape, const double *patch, const double *x, double *out) noexcept {
    NURBS_BEST(shift)(shape, patch, x, out);
}

void evaluate_patch(const PatchShape &shape, const double *patch, const AxisValues &at, int order,
                    double *work, double *out) noexcept {
    NURBS_BEST(evaluate)(shape, patch, at, order, work, out);
}

int64_t evaluation_work(const PatchShape &shape) noexcept {
    int64_t length = shape.values(), work = 0;
    for (int k = 0; k + 1 < shape.axes; ++k) {
        length /= shape.degree(k) + 1;
        work += eval::slot_count(k + 1, 2) * length;
    }
    return work;
}

// Row i holds the blossom at degree - i times lower and i times upper, in terms of the coefficients.
void part_matrix(int degree, double lower, double upper, double *matrix) noexcept {
    const int n = degree + 1;
    for (int i = 0; i < n; ++i) {
        double *row = matrix + i * n;
        std::fill_n(row, n, 0.0);
        row[0] = 1;
        for (int step = 1; step <= degree; ++step) {
            const double t = step <= i ? upper : lower;
            row[step] = t * row[step - 1];
            for (int j = step - 1; j > 0; --j) {
                row[j] = (1 - t) * row[j] + t * row[j - 1];
            }
            row[0] *= 1 - t;
        }
    }
}

void apply_matrix(const PatchShape &shape, int axis, const double *matrix, const double *patch,
                  double *out) noexcept {
    NURBS_BEST(apply)(shape, axis, matrix, patch, out);
}

void apply_to_part(const NetPart &net, int n, const double *matrix, double *out) noexcept {
    NURBS_BEST(gather)(net, n, matrix, out);
}

int64_t product_work(const PatchShape &shape) noexcept {
    return shape.values() + shape.products() * shape.lanes;
}

void square_patch(const PatchShape &shape, const SquareTables &tables, const double *patch, double *work,
                  double *squares, double *weights) noexcept {
    NURBS_BEST(square)(shape, tables, patch, work, squares, weights);
}

double gap_coefficients(int64_t count, const double *squares, const double *weights, double sign, double rho2,
                        double margin, double *out) noexcept {
    return NURBS_BEST(gap)(count, squares, weights, sign, rho2, margin, out);
}

} // namespace nrb::pieces
#endif
