// SPDX-License-Identifier: MIT
// The kernel that checks whether packed parameters lie in their domains.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "eval/kernels/domain_kernel.cpp"
#include "base/dispatch.h"

#include <hwy/foreach_target.h>

#include "eval/parameters.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace nrb::eval {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// The parameters of the axes alternate, and a vector may begin with any axis. So there are `axes`
// arrangements of the bounds in a vector, which repeat after lanes * axes parameters.
bool packed_inside(const double *params, int64_t count, int axes, const Interval *domains) {
    const hn::CappedTag<double, 8> d;
    const auto lanes = static_cast<int>(hn::Lanes(d));
    HWY_ALIGN double lower[8 * max_axes];
    HWY_ALIGN double upper[8 * max_axes];
    for (int i = 0; i < lanes * axes; ++i) {
        lower[i] = domains[i % axes].lower;
        upper[i] = domains[i % axes].upper;
    }
    auto inside = hn::Eq(hn::Zero(d), hn::Zero(d));
    int64_t i = 0;
    for (; i + lanes * axes <= count; i += lanes * axes) {
        for (int k = 0; k < axes; ++k) {
            const auto t = hn::LoadU(d, params + i + k * lanes);
            const auto both =
                hn::And(hn::Ge(t, hn::Load(d, lower + k * lanes)), hn::Le(t, hn::Load(d, upper + k * lanes)));
            inside = hn::And(inside, both);
        }
    }
    bool all = hn::AllTrue(d, inside);
    for (; i < count; ++i) {
        const Interval &domain = domains[i % axes];
        all = all && params[i] >= domain.lower && params[i] <= domain.upper;
    }
    return all;
}

} // namespace HWY_NAMESPACE
} // namespace nrb::eval
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace nrb::eval {

NURBS_FORMS(packed_inside);

bool all_inside(const double *params, int64_t count, int axes, const Interval *domains) noexcept {
    return NURBS_BEST(packed_inside)(params, count, axes, domains);
}

} // namespace nrb::eval
#endif
