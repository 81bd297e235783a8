#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "query/measure/speed_kernel.cpp"
#include "base/simd.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "query/measure/speed_kernel.h"

HWY_BEFORE_NAMESPACE();
namespace nrb {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Wide = hn::CappedTag<double, 8>;

HWY_INLINE hn::Vec<Wide> polynomial(const double *HWY_RESTRICT row, const double *HWY_RESTRICT basis,
                                    int degree) {
    const Wide d;
    auto sum = hn::Mul(hn::Set(d, row[0]), hn::LoadU(d, basis));
    for (int i = 1; i <= degree; ++i) {
        sum = hn::MulAdd(hn::Set(d, row[i]), hn::LoadU(d, basis + i * rule_capacity), sum);
    }
    return sum;
}

void speeds(const SpeedForm &form, const double *net, int first, int count, double *out) {
    const Wide d;
    const int degree = form.degree;
    for (int node = first; node < first + count; node += static_cast<int>(hn::Lanes(d))) {
        auto square = hn::Zero(d);
        const double *row = net;
        for (int c = 0; c < form.dim; ++c, row += degree + 1) {
            const auto x = polynomial(row, form.basis + node, degree);
            square = hn::MulAdd(x, x, square);
        }
        auto speed = hn::Sqrt(square);
        if (form.weight_degree >= 0) {
            const auto w = polynomial(row, form.weight_basis + node, form.weight_degree);
            speed = hn::Div(speed, hn::Mul(w, w));
        }
        hn::StoreU(speed, d, out + node);
    }
}

void rule_sums(const double *const *rows, const double *values, int count, double *sums) {
    const Wide d;
    for (int row = 0; row < 7; ++row) {
        auto sum = hn::Zero(d);
        for (int i = 0; i < count; i += static_cast<int>(hn::Lanes(d))) {
            sum = hn::MulAdd(hn::LoadU(d, rows[row] + i), hn::LoadU(d, values + i), sum);
        }
        sums[row] = hn::GetLane(hn::SumOfLanes(d, sum));
    }
}

} // namespace HWY_NAMESPACE
} // namespace nrb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace nrb {

HWY_EXPORT(speeds);

void speeds(const SpeedForm &form, const double *net, int first, int count, double *out) noexcept {
    HWY_DYNAMIC_DISPATCH(speeds)(form, net, first, count, out);
}

HWY_EXPORT(rule_sums);

void rule_sums(const double *const *rows, const double *values, int count, double *sums) noexcept {
    HWY_DYNAMIC_DISPATCH(rule_sums)(rows, values, count, sums);
}

} // namespace nrb
#endif
