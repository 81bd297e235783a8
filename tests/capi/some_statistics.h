/* SPDX-License-Identifier: MIT */
/* Statistics of a few data, and their bytes. */
#ifndef NURBS_TESTS_CAPI_SOME_STATISTICS_H
#define NURBS_TESTS_CAPI_SOME_STATISTICS_H

#include "fits.h"
#include "signed_bytes.h"

/* Cubics over the cells [0, 1), [1, 2), [2, 4] in the plane; values to 8, weights to 2. */
static inline nurbs_statistics *empty(void) {
    nurbs_statistics *s = NULL;
    CHECK_OK(nurbs_statistics_create(1, DEGREES(3), COUNTS(4), VALUES(0, 1, 2, 4), 4, 2, 8, 2, &s));
    return s;
}

static inline nurbs_data some_data(void) {
    static const double params[] = {0, 0.5, 2, 3, 4, 3.75};
    static const double values[][2] = {{1, 2}, {-8, 3}, {0.1, 0}, {0, 0}, {5, 8}, {1, 1}};
    static const double weights[] = {1, 2, 0.1, 1, 0.7, 0};
    nurbs_data data = data_of(1, 2, 6, params, values[0]);
    data.weights = weights;
    return data;
}

static inline nurbs_statistics *sum_of(const nurbs_statistics *s, nurbs_data data) {
    nurbs_statistics *out = NULL;
    CHECK_OK(nurbs_statistics_add(s, &data, &out));
    return out;
}

/* Those of data [first, end) alone. */
static inline nurbs_statistics *part(int64_t first, int64_t end) {
    nurbs_statistics *none = empty();
    nurbs_data data = some_data();
    data.n = end - first;
    data.params += first;
    data.values += 2 * first;
    data.weights += first;
    nurbs_statistics *out = sum_of(none, data);
    nurbs_statistics_destroy(none);
    return out;
}

static inline Bytes bytes_of(const nurbs_statistics *s) {
    Bytes made;
    memset(&made, 0, sizeof made);
    CHECK_OK(nurbs_statistics_to_bytes(s, most_bytes, made.data, &made.size));
    CHECK(made.size >= header_bytes && made.size <= most_bytes);
    return made;
}

static inline void check_same_statistics(const char *file, int line, const nurbs_statistics *a,
                                         const nurbs_statistics *b) {
    const Bytes x = bytes_of(a), y = bytes_of(b);
    check_integers(file, line, "size", x.size, y.size);
    check_bits(file, line, x.data, y.data, sizeof x.data);
}
#define CHECK_SAME(a, b) check_same_statistics(__FILE__, __LINE__, a, b)

static inline void check_size_of(const char *file, int line, const nurbs_statistics *s, int64_t count,
                                 int64_t cells, double weight) {
    int32_t axes = -1, dim = -1;
    int64_t made_count = -1, made_cells = -1;
    double made_weight = -1;
    CHECK_OK(nurbs_statistics_size(s, &axes, &dim, &made_count, &made_cells, &made_weight));
    check_integers(file, line, "axes", axes, 1);
    check_integers(file, line, "dim", dim, 2);
    check_integers(file, line, "count", made_count, count);
    check_integers(file, line, "cells", made_cells, cells);
    check_doubles(file, line, &made_weight, &weight, 1, 1e-15);
}
#define CHECK_SIZE(s, count, cells, weight) check_size_of(__FILE__, __LINE__, s, count, cells, weight)

#endif
