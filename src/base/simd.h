// SPDX-License-Identifier: MIT
// How the kernels use Google Highway. A file of kernels is compiled once for every instruction set, and the
// best one that the processor supports is chosen at run time; see base/dispatch.h, and Highway's
// documentation of foreach_target.h.
//
// Only a few instruction sets are used. Vectors whose size is known only at run time (SVE, RISC-V) cannot be
// assumed to hold four coordinates. NEON without double precision is left out, too. SSSE3 is no faster for
// this work than the portable code. SSE4 is faster, by a factor of 1.2 for curves and 1.8 for surfaces, but
// only processors without AVX2 would use it, and it would make up a twelfth of the library.
#pragma once

// Highway's assertions would need its library.
#define HWY_IS_DEBUG_BUILD 0
#include <hwy/base.h>

#if HWY_MAJOR > 1 || HWY_MINOR >= 1
#define NURBS_NEON HWY_NEON_WITHOUT_AES // supported by every 64-bit ARM
#else
#define NURBS_NEON HWY_NEON
#endif
#if defined(NURBS_SANITIZED) // each target takes minutes to compile here, so one stands for both
#define NURBS_WIDE_TARGETS HWY_AVX2
#else
#define NURBS_WIDE_TARGETS (HWY_AVX3 | HWY_AVX2)
#endif
#define HWY_DISABLED_TARGETS (~(NURBS_WIDE_TARGETS | NURBS_NEON | HWY_EMU128 | HWY_SCALAR))
#if defined(__arm__)
#define HWY_COMPILE_ONLY_SCALAR
#endif
