// SPDX-License-Identifier: MIT
#include "base/dispatch.h"

#include <hwy/targets.h>

#if HWY_ARCH_X86 && __has_include(<sys/platform/x86.h>)
#if defined(__clang__) // its stdbool.h does not define _Bool in standard C++
#define _Bool bool     // NOLINT: the name of the C header
#endif
#include <sys/platform/x86.h>
#undef _Bool
#define NURBS_HAS(glibc, gcc) CPU_FEATURE_ACTIVE(glibc)
#else
#define NURBS_HAS(glibc, gcc) __builtin_cpu_supports(gcc)
#endif

namespace nrb::inline base::dispatch {

namespace {

// The features that Highway lets the compiler use for a target. Half precision and AES are not tested: every
// processor with AVX2 has them, and no kernel uses them.
#if HWY_ARCH_X86
bool has_avx2() noexcept {
    return NURBS_HAS(AVX2, "avx2") && NURBS_HAS(FMA, "fma") && NURBS_HAS(BMI1, "bmi") &&
           NURBS_HAS(BMI2, "bmi2");
}

bool has_avx512() noexcept {
    return has_avx2() && NURBS_HAS(AVX512F, "avx512f") && NURBS_HAS(AVX512VL, "avx512vl") &&
           NURBS_HAS(AVX512DQ, "avx512dq") && NURBS_HAS(AVX512BW, "avx512bw");
}
#endif

// HWY_TARGETS holds the targets that the kernels are compiled for; HWY_STATIC_TARGET is the one that every
// processor of the build supports, so it needs no test.
bool offers(Form form) noexcept {
#if HWY_ARCH_X86
    switch (form) {
    case avx512:
        return (HWY_TARGETS & HWY_AVX3) != 0 && HWY_STATIC_TARGET != HWY_AVX3 && has_avx512();
    case avx2:
        return (HWY_TARGETS & HWY_AVX2) != 0 && HWY_STATIC_TARGET != HWY_AVX2 && has_avx2();
    default:
        break;
    }
#endif
    return form == baseline;
}

int64_t target_of(Form form) noexcept {
    switch (form) {
    case avx512:
        return HWY_AVX3;
    case avx2:
        return HWY_AVX2;
    default:
        return HWY_STATIC_TARGET;
    }
}

constexpr Form all_forms[] = {avx512, avx2, baseline};

} // namespace

std::atomic<Form> best = unknown;

Form find_best() noexcept {
    Form form = avx512;
    while (!offers(form)) {
        form = static_cast<Form>(form + 1);
    }
    best.store(form, std::memory_order_relaxed);
    return form;
}

std::vector<int64_t> offered_targets() {
    std::vector<int64_t> targets;
    for (const Form form : all_forms) {
        if (offers(form)) {
            targets.push_back(target_of(form));
        }
    }
    return targets;
}

void choose(int64_t target) noexcept {
    Form form = unknown;
    for (const Form other : all_forms) {
        if (offers(other) && target_of(other) == target) {
            form = other;
        }
    }
    best.store(form, std::memory_order_relaxed);
}

} // namespace nrb::inline base::dispatch
