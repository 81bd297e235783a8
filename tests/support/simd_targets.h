// The instruction sets that this machine offers to the kernels.
#pragma once

#include "base/dispatch.h" // before Highway's headers: it says which instruction sets there are

#include <hwy/targets.h>

namespace targets {

using nrb::dispatch::choose;
using nrb::dispatch::offered_targets;

// What rounds alike: on x86 the sets with fused multiplication, and those without; elsewhere each on its own.
inline int64_t rounding_class(int64_t target) {
#if HWY_ARCH_X86
    return target <= HWY_AVX2 ? HWY_AVX2 : HWY_STATIC_TARGET;
#else
    return target;
#endif
}

} // namespace targets
