// SPDX-License-Identifier: MIT
// Selects the form of a kernel that runs on this processor. Highway's headers compile each kernel once for
// every instruction set. The choice that Highway's library would make at run time is made here instead, so
// that programs need not load that library.
//
//     NURBS_FORMS(run_curve);                     at the end of the file, where HWY_ONCE holds
//     NURBS_BEST(run_curve)(job, params, out);
//
// Where the C library reports the features of the processor, it is the one asked, because it can be told to
// hide some of them: GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX512F.
//
// This header must precede Highway's own, because it sets the instruction sets they compile for.
#pragma once

#include "base/simd.h"

#include <atomic>
#include <cstdint>
#include <vector>

namespace nrb::inline base::dispatch {

// Index of a form in the table of a kernel, the best form first.
enum Form : int32_t { unknown = -1, avx512, avx2, baseline };

extern std::atomic<Form> best;
Form find_best() noexcept;

inline Form best_form() noexcept {
    const Form form = best.load(std::memory_order_relaxed);
    return form == unknown ? find_best() : form;
}

// For tests. offered_targets(): the Highway targets that the kernels are compiled for and this processor
// supports, the best first. choose(): makes all threads use one of them; 0 restores the best.
std::vector<int64_t> offered_targets();
void choose(int64_t target) noexcept;

} // namespace nrb::inline base::dispatch

#if HWY_ARCH_X86
#define NURBS_WIDE_FORMS(kernel) HWY_CHOOSE_AVX3(kernel), HWY_CHOOSE_AVX2(kernel)
#else
#define NURBS_WIDE_FORMS(kernel) nullptr, nullptr
#endif
#define NURBS_FORMS(kernel)                                                                                  \
    constexpr decltype(&HWY_STATIC_DISPATCH(kernel)) kernel##_forms[] = {NURBS_WIDE_FORMS(kernel),           \
                                                                         &HWY_STATIC_DISPATCH(kernel)}
#define NURBS_BEST(kernel) (*kernel##_forms[nrb::dispatch::best_form()])
