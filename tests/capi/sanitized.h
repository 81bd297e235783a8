/* SPDX-License-Identifier: MIT */
// Whether a sanitizer has malloc for itself.
#ifndef NURBS_TESTS_CAPI_SANITIZED_H
#define NURBS_TESTS_CAPI_SANITIZED_H

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define ALLOCATIONS_BELONG_TO_A_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
#define ALLOCATIONS_BELONG_TO_A_SANITIZER 1
#endif
#endif

#ifdef ALLOCATIONS_BELONG_TO_A_SANITIZER
constexpr bool allocations_belong_to_a_sanitizer = true;
#else
constexpr bool allocations_belong_to_a_sanitizer = false;
#endif

#endif
