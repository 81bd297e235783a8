// SPDX-License-Identifier: MIT
// Which form of a kernel runs. Highway's headers make a form of each kernel for every instruction set; what its
// library would choose is chosen here, so that programs need not load that library.
//
//     NURBS_FORMS(run_curve);                     at the end of the file, where HWY_ONCE holds
//     NURBS_BEST(run_curve)(job, params, out);
//
// A processor's features are asked of the C library where it tells them, so that it can be told to hide some:
// GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX512F.
//
// This comes before Highway's own headers, because it says which instruction sets there are.
#pragma once

#include "base/simd.h"

#include <atomic>
#include <cstdint>
#include <vector>

namespace nrb::inline base::dispatch {

// Where the forms of a kernel stand in its table, the best one first.
enum Form : int32_t { unknown = -1, avx512, avx2, baseline };

extern std::atomic<Form> best;
Form find_best() noexcept;

inline Form best_form() noexcept {
    const Form form = best.load(std::memory_order_relaxed);
    return form == unknown ? find_best() : form;
}

// For tests. The targets of Highway that the kernels are made for and this processor has, the best one first; and
// the choice of one of them for all threads, or of the best one again by 0.
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
