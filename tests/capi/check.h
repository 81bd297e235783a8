/* SPDX-License-Identifier: MIT */
/* The checks that the C programs of this folder share. Every program includes this file first, so that
 * nurbs.h is compiled before anything else.
 *
 * Good inputs live in `static const` arrays, which the system keeps in read-only pages: a call that writes to
 * an input ends the program. Inputs with one bad element come from edited(), whose array is compared with a
 * copy after every call. */
#ifndef NURBS_TESTS_CAPI_CHECK_H
#define NURBS_TESTS_CAPI_CHECK_H

#include <nurbs/nurbs.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { check_scratch_size = 128, check_text_size = 1024 };

#ifdef __cplusplus
#define CHECK_STATE inline /* a C++ program may have several files */
#else
#define CHECK_STATE static
#endif

CHECK_STATE int check_failures;
CHECK_STATE double check_scratch[check_scratch_size], check_scratch_copy[check_scratch_size];
CHECK_STATE char check_before[check_text_size];

static inline int check_report(const char *file, int line, const char *what) {
    ++check_failures;
    fprintf(stderr, "%s:%d: %s", file, line, what);
    return 0;
}

static inline int check_summary(const char *name) {
    printf("%s: %d failures\n", name, check_failures);
    return check_failures == 0 ? 0 : 1;
}

/* Leaves in nurbs_last_error() a message that no other check expects, so that an old text cannot pass for a
 * new one. */
static inline void check_forget(void) {
    int64_t slots;
    (void)nurbs_derivative_slots(77, 0, &slots);
    (void)nurbs_last_error(check_before, check_text_size);
}

static inline void check_remember(void) {
    (void)nurbs_last_error(check_before, check_text_size);
}

static inline void check_inputs(const char *file, int line) {
    if (memcmp(check_scratch, check_scratch_copy, sizeof check_scratch) != 0) {
        check_report(file, line, "the call changed its input\n");
        memcpy(check_scratch_copy, check_scratch, sizeof check_scratch);
    }
}

/* `words` are separated by '|'; each has to occur in the text. */
static inline int check_words(const char *text, const char *words) {
    char word[check_text_size];
    while (*words != '\0') {
        size_t length = strcspn(words, "|");
        memcpy(word, words, length);
        word[length] = '\0';
        if (strstr(text, word) == NULL) {
            return 0;
        }
        words += length + (words[length] == '|');
    }
    return 1;
}

static inline void check_refusal(const char *file, int line, nurbs_status actual, nurbs_status expected,
                                 const char *words) {
    char text[check_text_size];
    int64_t length = nurbs_last_error(text, check_text_size);
    if (actual != expected) {
        check_report(file, line, "");
        fprintf(stderr, "status %s, expected %s; message: %s\n", nurbs_status_name(actual),
                nurbs_status_name(expected), text);
    } else if (strcmp(text, check_before) == 0 || length == 0) {
        check_report(file, line, "the failed call set no message\n");
    } else if (!check_words(text, words)) {
        check_report(file, line, "");
        fprintf(stderr, "message \"%s\" lacks a word of \"%s\"\n", text, words);
    }
    check_inputs(file, line);
}

static inline void check_success(const char *file, int line, const char *call, nurbs_status actual) {
    char text[check_text_size];
    (void)nurbs_last_error(text, check_text_size);
    if (actual != NURBS_OK) {
        check_report(file, line, "");
        fprintf(stderr, "%s: %s: %s\n", call, nurbs_status_name(actual), text);
    } else if (strcmp(text, check_before) != 0) {
        check_report(file, line, "a successful call changed the message\n");
    }
    check_inputs(file, line);
}

/* Equal values; NaN counts as equal to NaN. */
static inline void check_doubles(const char *file, int line, const double *actual, const double *expected,
                                 int64_t n, double bound) {
    for (int64_t i = 0; i < n; ++i) {
        int same = actual[i] == expected[i] || (isnan(actual[i]) && isnan(expected[i]));
        if (!same && !(fabs(actual[i] - expected[i]) <= bound)) {
            check_report(file, line, "");
            fprintf(stderr, "value %lld is %.17g, expected %.17g within %g\n", (long long)i, actual[i],
                    expected[i], bound);
        }
    }
}

static inline void check_integers(const char *file, int line, const char *what, int64_t actual,
                                  int64_t expected) {
    if (actual != expected) {
        check_report(file, line, "");
        fprintf(stderr, "%s is %lld, expected %lld\n", what, (long long)actual, (long long)expected);
    }
}

static inline void check_bits(const char *file, int line, const void *actual, const void *expected,
                              size_t bytes) {
    if (memcmp(actual, expected, bytes) != 0) {
        check_report(file, line, "the bits differ\n");
    }
}

static inline void check_untouched(const char *file, int line, const void *array, size_t bytes) {
    const unsigned char *p = (const unsigned char *)array;
    for (size_t i = 0; i < bytes; ++i) {
        if (p[i] != 0x5a) {
            check_report(file, line, "");
            fprintf(stderr, "byte %zu of an output was written\n", i);
            return;
        }
    }
}

/* `n` doubles with element `index` replaced. One such array exists at a time. */
static inline const double *edited(const double *array, int n, int index, double value) {
    memcpy(check_scratch, array, (size_t)n * sizeof *array);
    check_scratch[index] = value;
    memcpy(check_scratch_copy, check_scratch, sizeof check_scratch);
    return check_scratch;
}

static inline void check_true(const char *file, int line, int condition, const char *text) {
    if (!condition) {
        check_report(file, line, text);
        fputs(" is false\n", stderr);
    }
}

/* A pointer that a failing call has to replace by NULL. */
static inline nurbs *check_poison(void) {
    return (nurbs *)(void *)check_before;
}

#define CHECK(condition) check_true(__FILE__, __LINE__, (condition) ? 1 : 0, #condition)
#define CHECK_INT(actual, expected)                                                                          \
    check_integers(__FILE__, __LINE__, #actual, (int64_t)(actual), (int64_t)(expected))
#define CHECK_DOUBLES(actual, expected, n) check_doubles(__FILE__, __LINE__, actual, expected, n, 0.0)
#define CHECK_NEAR(actual, expected, n, bound) check_doubles(__FILE__, __LINE__, actual, expected, n, bound)
#define CHECK_BITS(actual, expected, bytes) check_bits(__FILE__, __LINE__, actual, expected, bytes)
#define CHECK_DOUBLE(actual, expected)                                                                       \
    do {                                                                                                     \
        double actual_ = (actual), expected_ = (expected);                                                   \
        check_doubles(__FILE__, __LINE__, &actual_, &expected_, 1, 0.0);                                     \
    } while (0)

#define CHECK_OK(call)                                                                                       \
    do {                                                                                                     \
        check_remember();                                                                                    \
        nurbs_status status_ = (call);                                                                       \
        check_success(__FILE__, __LINE__, #call, status_);                                                   \
    } while (0)

/* The call returns `status`, and its message holds every word of `words`. */
#define CHECK_FAILS(call, status, words)                                                                     \
    do {                                                                                                     \
        check_forget();                                                                                      \
        nurbs_status status_ = (call);                                                                       \
        check_refusal(__FILE__, __LINE__, status_, status, words);                                           \
    } while (0)

/* The same for a call whose last argument is `&out`, which becomes NULL. */
#define CHECK_NO_HANDLE(out, call, status, words)                                                            \
    do {                                                                                                     \
        (out) = check_poison();                                                                              \
        CHECK_FAILS(call, status, words);                                                                    \
        check_true(__FILE__, __LINE__, (out) == NULL, #out " == NULL");                                      \
    } while (0)

#define FILL(array) memset(array, 0x5a, sizeof(array))
#define CHECK_UNTOUCHED(array) check_untouched(__FILE__, __LINE__, array, sizeof(array))

#endif
