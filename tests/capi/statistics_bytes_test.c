/* SPDX-License-Identifier: MIT */
/* Statistics as bytes, and bytes that are none. */
#include "some_statistics.h"

static void bytes_and_back(void) {
    nurbs_statistics *all = part(0, 6), *copy = NULL;
    Bytes made = bytes_of(all), again;
    int64_t size = -1;
    CHECK_BITS(made.data, "\x89NUR\r\n\x1a\n\x01\0\0\0\x03\0\0\0", 16);
    CHECK_OK(nurbs_statistics_to_bytes(all, 0, NULL, &size));
    CHECK_INT(size, made.size);
    CHECK_OK(nurbs_statistics_to_bytes(all, 0, NULL, NULL));
    CHECK_OK(nurbs_statistics_to_bytes(all, most_bytes, NULL, &size)); /* bytes are not wanted */
    FILL(again.data);
    CHECK_OK(nurbs_statistics_to_bytes(all, made.size, again.data, NULL));
    CHECK_BITS(made.data, again.data, (size_t)size);
    check_untouched(__FILE__, __LINE__, again.data + size, most_bytes - (size_t)size);
    CHECK_OK(nurbs_statistics_from_bytes(made.data, made.size, &copy));
    CHECK_SAME(copy, all);
    CHECK_SIZE(copy, 5, 2, 4.8);
    sign(again.data, made.size);
    CHECK_BITS(made.data, again.data, (size_t)size);
    nurbs_statistics_destroy(copy);
    nurbs_statistics_destroy(all);
}

static void refused_buffers(void) {
    nurbs_statistics *all = part(0, 6);
    Bytes made;
    int64_t size = -7, needed = 0;
    CHECK_OK(nurbs_statistics_to_bytes(all, 0, NULL, &needed));
    FILL(made.data);
    CHECK_FAILS(nurbs_statistics_to_bytes(NULL, 0, NULL, &size), NURBS_ERROR_NULL, "statistics");
    CHECK_FAILS(nurbs_statistics_to_bytes(all, -1, made.data, &size), NURBS_ERROR_COUNT, "cap = -1");
    CHECK_FAILS(nurbs_statistics_to_bytes(all, needed - 1, made.data, &size), NURBS_ERROR_SIZE, "cap");
    CHECK_FAILS(nurbs_statistics_to_bytes(all, 1, made.data, &size), NURBS_ERROR_SIZE, "cap = 1");
    CHECK_FAILS(nurbs_statistics_to_bytes(all, most_bytes, made.data, (int64_t *)(void *)made.data),
                NURBS_ERROR_OVERLAP, "bytes");
    CHECK_INT(size, -7);
    CHECK_UNTOUCHED(made.data);
    nurbs_statistics_destroy(all);
}

/* Bytes that were cut off, added, or never were those of statistics. */
static void refused_bytes(void) {
    nurbs_statistics *all = part(0, 6), *s = NULL;
    Bytes made = bytes_of(all);
    for (int64_t size = 1; size < made.size; ++size) {
        CHECK_NO_STATISTICS(s, nurbs_statistics_from_bytes(made.data, size, &s), NURBS_ERROR_TRUNCATED,
                            "size = ");
    }
    CHECK_NO_STATISTICS(s, nurbs_statistics_from_bytes(made.data, 0, &s), NURBS_ERROR_TRUNCATED, "size = 0");
    CHECK_NO_STATISTICS(s, nurbs_statistics_from_bytes(NULL, 0, &s), NURBS_ERROR_TRUNCATED, "size = 0");
    CHECK_NO_STATISTICS(s, nurbs_statistics_from_bytes(NULL, made.size, &s), NURBS_ERROR_NULL, "bytes");
    CHECK_NO_STATISTICS(s, nurbs_statistics_from_bytes(made.data, -1, &s), NURBS_ERROR_COUNT, "size = -1");
    CHECK_FAILS(nurbs_statistics_from_bytes(made.data, made.size, NULL), NURBS_ERROR_NULL, "out");
    CHECK_NO_STATISTICS(s, nurbs_statistics_from_bytes(made.data, made.size + 8, &s), NURBS_ERROR_SYNTAX,
                        "size = ");
    CHECK_NO_STATISTICS(s, nurbs_statistics_from_bytes("NURBS", 5, &s), NURBS_ERROR_FORMAT, "begin");
    made.data[12] = 1; /* a spline */
    sign(made.data, made.size);
    CHECK_NO_STATISTICS(s, nurbs_statistics_from_bytes(made.data, made.size, &s), NURBS_ERROR_FORMAT,
                        "expected statistics");
    made.data[12] = 3;
    made.data[8] = 2;
    CHECK_NO_STATISTICS(s, nurbs_statistics_from_bytes(made.data, made.size, &s), NURBS_ERROR_VERSION, "2.0");
    made.data[8] = 0;
    made.data[9] = 1;
    CHECK_NO_STATISTICS(s, nurbs_statistics_from_bytes(made.data, made.size, &s), NURBS_ERROR_VERSION,
                        "256.0");
    nurbs_statistics_destroy(all);
}

/* No bit can change unnoticed. */
static void flipped_bits(void) {
    nurbs_statistics *all = part(0, 6), *s = NULL;
    Bytes made = bytes_of(all);
    for (int64_t i = 0; i < 8 * made.size; ++i) {
        const unsigned char bit = (unsigned char)(1 << i % 8);
        made.data[i / 8] ^= bit;
        const nurbs_status status = nurbs_statistics_from_bytes(made.data, made.size, &s);
        if (status == NURBS_OK || (i >= 8 * 24 && status != NURBS_ERROR_CHECKSUM)) {
            check_report(__FILE__, __LINE__, "");
            fprintf(stderr, "bit %d of byte %d: %s\n", (int)(i % 8), (int)(i / 8), nurbs_status_name(status));
        }
        nurbs_statistics_destroy(s);
        made.data[i / 8] ^= bit;
    }
    made.data[header_bytes + 3] ^= 0x55;
    CHECK_NO_STATISTICS(s, nurbs_statistics_from_bytes(made.data, made.size, &s), NURBS_ERROR_CHECKSUM,
                        "checksum");
    nurbs_statistics_destroy(all);
}

static void check_bad_number(int line, int place, uint64_t value, int size, nurbs_status status,
                             const char *words) {
    nurbs_statistics *all = part(0, 6), *out = (nurbs_statistics *)(void *)check_before;
    Bytes made = bytes_of(all);
    number_into(made.data + place, value, size);
    sign(made.data, made.size);
    check_forget();
    check_refusal(__FILE__, line, nurbs_statistics_from_bytes(made.data, made.size, &out), status, words);
    check_true(__FILE__, line, out == NULL, "out == NULL");
    nurbs_statistics_destroy(all);
}
#define BAD_NUMBER(place, value, size, status, words)                                                        \
    check_bad_number(__LINE__, place, (uint64_t)(value), size, status, words)

/* Numbers of good bytes replaced by some that no statistics have: header, sizes, breaks, cells, counts, sums. */
static void numbers_of_no_statistics(void) {
    enum { sizes = 64, breaks = 128, cells = 192, counts = 208, sums = 256, entries = 18 };
    BAD_NUMBER(32, 0, 4, NURBS_ERROR_SYNTAX, "axes = 0");
    BAD_NUMBER(32, 4, 4, NURBS_ERROR_SYNTAX, "axes = 4");
    BAD_NUMBER(36, -1, 4, NURBS_ERROR_SYNTAX, "dim = -1");
    BAD_NUMBER(36, 3, 4, NURBS_ERROR_SYNTAX, "number of sums");
    BAD_NUMBER(40, 2000, 4, NURBS_ERROR_SYNTAX, "values = 2000");
    BAD_NUMBER(44, -2000, 4, NURBS_ERROR_SYNTAX, "weights = -2000");
    BAD_NUMBER(sizes, 4, 8, NURBS_ERROR_SYNTAX, "number of cells = 4");
    BAD_NUMBER(sizes, -1, 8, NURBS_ERROR_SYNTAX, "number of cells = -1");
    BAD_NUMBER(sizes + 8, 17, 8, NURBS_ERROR_SYNTAX, "number of sums = 17");
    BAD_NUMBER(sizes + 16, 32, 8, NURBS_ERROR_SYNTAX, "degree = 32");
    BAD_NUMBER(sizes + 24, 1, 8, NURBS_ERROR_SYNTAX, "breaks = 1");
    BAD_NUMBER(sizes + 24, 1 << 20, 8, NURBS_ERROR_TRUNCATED, "1048576");
    BAD_NUMBER(breaks + 8, bits_of(3), 8, NURBS_ERROR_SYNTAX, "break 2 of axis 0");
    BAD_NUMBER(breaks + 16, bits_of(NAN), 8, NURBS_ERROR_SYNTAX, "break 2 of axis 0");
    BAD_NUMBER(breaks + 24, bits_of(INFINITY), 8, NURBS_ERROR_KNOT_NOT_FINITE, "inf");
    BAD_NUMBER(breaks, bits_of(-INFINITY), 8, NURBS_ERROR_KNOT_NOT_FINITE, "-inf");
    BAD_NUMBER(cells + 8, 0, 8, NURBS_ERROR_SYNTAX, "cell = 0");
    BAD_NUMBER(cells + 8, 3, 8, NURBS_ERROR_SYNTAX, "cell = 3");
    BAD_NUMBER(cells, -1, 8, NURBS_ERROR_SYNTAX, "cell = -1");
    BAD_NUMBER(counts, 0, 8, NURBS_ERROR_SYNTAX, "count = 0");
    BAD_NUMBER(counts + 8, -5, 8, NURBS_ERROR_SYNTAX, "count = -5");
    BAD_NUMBER(counts, INT64_MAX, 8, NURBS_ERROR_SYNTAX, "count"); /* more than there can be in all */
    BAD_NUMBER(sums + 24 * (entries - 1) + 16, INT64_MIN, 8, NURBS_ERROR_SYNTAX, "weight");
}

/* Forms whose cells nobody can count, and one of which a cell would fill any memory. */
static void extreme_forms(void) {
    enum { side = 1 << 18, start = 128 };
    const int64_t size = start + 3 * side * 8 + 8 * side;
    unsigned char *bytes = (unsigned char *)calloc(1, (size_t)size);
    nurbs_statistics *small = part(0, 0), *huge = NULL, *s = NULL;
    const Bytes made = bytes_of(small);
    memcpy(bytes, made.data, 32);
    number_into(bytes + 16, (uint64_t)size, 8);
    number_into(bytes + 32, 3, 4);
    number_into(bytes + 36, 1, 4);
    number_into(bytes + 72, 27 + 8 + 2, 8);
    for (int k = 0; k < 3; ++k) {
        number_into(bytes + 80 + 16 * k, 1, 8);
        number_into(bytes + 88 + 16 * k, side, 8);
        for (int i = 0; i < side; ++i) {
            number_into(bytes + start + 8 * (k * side + i), bits_of(i), 8);
        }
    }
    sign(bytes, size);
    CHECK_NO_STATISTICS(s, nurbs_statistics_from_bytes(bytes, size, &s), NURBS_ERROR_OVERFLOW, "cells");
    free(bytes);
    nurbs_statistics_destroy(small);
    CHECK_OK(nurbs_statistics_create(3, DEGREES(31, 31, 31), COUNTS(2, 2, 2), VALUES(0, 1, 0, 1, 0, 1), 6,
                                     INT32_MAX - 1, 1, 1, &huge));
    const Bytes few = bytes_of(huge);
    CHECK_OK(nurbs_statistics_from_bytes(few.data, few.size, &s));
    nurbs_statistics_destroy(huge);
    nurbs_statistics_destroy(s);
}

/* The checksum of statistics of 300 data, of degree 4 - axes on each axis. */
static uint64_t checksum_of_many(int32_t axes) {
    enum { n = 300, dim = 2, knots = 5 };
    static double params[3 * n], values[dim * n], weights[n], breaks[3 * knots];
    static unsigned char bytes[1 << 20];
    uint64_t state = 24, sum = 0;
    int64_t counts[3], size = 0;
    int32_t degrees[3];
    nurbs_statistics *none = NULL, *all = NULL;
    nurbs_data data;
    for (int32_t k = 0; k < axes; ++k) {
        counts[k] = knots;
        degrees[k] = 4 - axes;
        for (int i = 0; i < knots; ++i) {
            breaks[k * knots + i] = i * i / 7.0 * (k + 1);
        }
    }
    for (int i = 0; i < n; ++i) {
        for (int32_t k = 0; k < axes; ++k) {
            params[i * axes + k] = 16 / 7.0 * (k + 1) * next_number(&state);
        }
        values[dim * i] = 2 * next_number(&state) - 1;
        values[dim * i + 1] = next_number(&state);
        weights[i] = next_number(&state);
    }
    CHECK_OK(nurbs_data_init(&data, sizeof data));
    data.n = n;
    data.axes = axes;
    data.dim = dim;
    data.params = params;
    data.values = values;
    data.weights = weights;
    CHECK_OK(nurbs_statistics_create(axes, degrees, counts, breaks, axes * knots, dim, 1, 1, &none));
    CHECK_OK(nurbs_statistics_add(none, &data, &all));
    CHECK_OK(nurbs_statistics_to_bytes(all, sizeof bytes, bytes, &size));
    sum = number_from(bytes + 24, 8);
    nurbs_statistics_destroy(all);
    nurbs_statistics_destroy(none);
    return sum;
}

/* Chunks that were reduced on machines of any kind can be merged: each makes these bytes of these data. */
static void same_on_every_machine(void) {
    const uint64_t expected[3] = {UINT64_C(0xf4b6099c2116faba), UINT64_C(0x7c466d3bbb35b530),
                                  UINT64_C(0xd46663150d38ba6b)};
    for (int32_t axes = 1; axes <= 3; ++axes) {
        const uint64_t found = checksum_of_many(axes);
        if (found != expected[axes - 1]) {
            check_report(__FILE__, __LINE__, "other bytes than elsewhere\n");
            printf("%d axes: checksum 0x%llx\n", (int)axes, (unsigned long long)found);
        }
    }
}

int main(void) {
    bytes_and_back();
    same_on_every_machine();
    refused_buffers();
    refused_bytes();
    flipped_bits();
    numbers_of_no_statistics();
    extreme_forms();
    return check_summary("statistics_bytes");
}
