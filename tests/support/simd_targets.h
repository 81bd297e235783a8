// The instruction sets that this machine offers to the kernels, and the choice of one of them.
#pragma once

#include "base/simd.h" // before Highway's headers: it says which instruction sets there are

#include <algorithm>
#include <hwy/targets.h>
#include <vector>

namespace targets {

// Highway's list leaves out the portable code where the processor offers more.
inline std::vector<int64_t> offered_targets() {
    std::vector<int64_t> targets = hwy::SupportedAndGeneratedTargets();
    if (std::find(targets.begin(), targets.end(), HWY_STATIC_TARGET) == targets.end()) {
        targets.push_back(HWY_STATIC_TARGET);
    }
    return targets;
}

// Lets the kernels run on one target; 0: on the best one, as outside the tests.
inline void choose(int64_t target) {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

// What rounds alike: on x86 the sets with fused multiplication, and those without; elsewhere each on its own.
inline int64_t rounding_class(int64_t target) {
#if HWY_ARCH_X86
    return target <= HWY_AVX2 ? HWY_AVX2 : HWY_STATIC_TARGET;
#else
    return target;
#endif
}

} // namespace targets
