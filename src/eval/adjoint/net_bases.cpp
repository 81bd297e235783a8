// SPDX-License-Identifier: MIT
// The kernel that computes the basis functions of a block of parameters for the gradients of a net.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "eval/adjoint/net_bases.cpp"
#include "base/dispatch.h"

#include <hwy/foreach_target.h>

#include "eval/adjoint/net_kernel.h"
#include "eval/kernels/axis-inl.h"

HWY_BEFORE_NAMESPACE();
namespace nrb::eval {
namespace HWY_NAMESPACE {

// At parameters where one function is 1 and all others are 0, replaces the computed values by these exact
// ones.
static HWY_NOINLINE void mend_alone(const AxisSource &source, const AxisPoint *points, int64_t count,
                                    int64_t size, double *values) {
    for (int64_t i = 0; i < count; ++i) {
        if (points[i].valid() && points[i].sole >= 0) {
            double *own = values + i * size;
            std::fill_n(own, source.degree + 1, 0.0);
            own[points[i].sole] = 1;
        }
    }
}

template <int kOrders>
HWY_INLINE bool axis_bases(const AxisSource &source, const double *params, int64_t stride, int64_t count,
                           AxisPoint *points, double *values) {
    return source.degree == 3
               ? axis_block<kOrders, 3>(source, kOrders - 1, params, stride, count, points, values)
               : axis_block<kOrders, -1>(source, kOrders - 1, params, stride, count, points, values);
}

bool find_bases(const NetJob &job, const ConstRecords &params) {
    bool special = false;
    for (int k = 0; k < job.axes; ++k) {
        const auto at = static_cast<size_t>(k);
        const AxisSource &source = job.sources[at];
        const double *first = params.data + k * params.component_stride;
        const auto bases = job.order == 0 ? &axis_bases<1> : &axis_bases<2>;
        if (bases(source, first, params.stride, params.count, job.points[at], job.values[at])) {
            mend_alone(source, job.points[at], params.count, source.values_size(job.order), job.values[at]);
            special = true;
        }
    }
    return special;
}

} // namespace HWY_NAMESPACE
} // namespace nrb::eval
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace nrb::eval {

NURBS_FORMS(find_bases);

bool find_net_bases(const NetJob &job, const ConstRecords &params) noexcept {
    return NURBS_BEST(find_bases)(job, params);
}

} // namespace nrb::eval
#endif
