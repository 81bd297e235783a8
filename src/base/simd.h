// SPDX-License-Identifier: MIT
// How the kernels use Google Highway. A file of kernels is compiled once for every instruction set, and the
// best one that the processor has is chosen at run time; see Highway's documentation on dynamic dispatch.
//
// Some instruction sets are left out. Vectors whose size is known only at run time (SVE, RISC-V) cannot hold
// four coordinates by name. NEON without double precision is left out, too. SSSE3 is no faster for this work
// than the portable code. SSE4 is faster, 1.2 times for curves and 1.8 times for surfaces, but only
// processors without AVX2 would run it, and it would be a twelfth of the library.
#pragma once

#define NURBS_UNUSED_TARGETS                                                                                 \
    (HWY_SSSE3 | HWY_SSE4 | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#if defined(NURBS_SANITIZED) // where compilers need minutes for each of them, two stand for all
#define HWY_DISABLED_TARGETS (NURBS_UNUSED_TARGETS | HWY_AVX3 | HWY_AVX3_DL)
#else
#define HWY_DISABLED_TARGETS NURBS_UNUSED_TARGETS
#endif
#if defined(__arm__)
#define HWY_COMPILE_ONLY_SCALAR
#endif
