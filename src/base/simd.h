// SPDX-License-Identifier: MIT
// How the kernels use Google Highway. A file of kernels is compiled once for every instruction set, and the
// best one that the processor has is chosen at run time; see base/dispatch.h, and Highway's documentation on
// foreach_target.h.
//
// Few instruction sets are used. Vectors whose size is known only at run time (SVE, RISC-V) cannot hold four
// coordinates by name. NEON without double precision is left out, too. SSSE3 is no faster for this work than
// the portable code. SSE4 is faster, 1.2 times for curves and 1.8 times for surfaces, but only processors
// without AVX2 would run it, and it would be a twelfth of the library.
#pragma once

// Highway's assertions would need its library.
#define HWY_IS_DEBUG_BUILD 0
#include <hwy/base.h>

#if HWY_MAJOR > 1 || HWY_MINOR >= 1
#define NURBS_NEON HWY_NEON_WITHOUT_AES // what every 64-bit ARM has
#else
#define NURBS_NEON HWY_NEON
#endif
#if defined(NURBS_SANITIZED) // where compilers need minutes for each of them, two stand for all
#define NURBS_WIDE_TARGETS HWY_AVX2
#else
#define NURBS_WIDE_TARGETS (HWY_AVX3 | HWY_AVX2)
#endif
#define HWY_DISABLED_TARGETS (~(NURBS_WIDE_TARGETS | NURBS_NEON | HWY_EMU128 | HWY_SCALAR))
#if defined(__arm__)
#define HWY_COMPILE_ONLY_SCALAR
#endif
