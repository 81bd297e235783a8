/* SPDX-License-Identifier: MIT */
/* Splines as bytes, and bytes that are none. */
#include "shapes.h"
#include "signed_bytes.h"

#include <float.h>
#include <math.h>

enum { at_axes = 64, at_points_place = 112, at_weights_place = 120, at_knots = 128 };

static Bytes bytes_of(const nurbs *g) {
    Bytes made;
    memset(&made, 0, sizeof made);
    CHECK_OK(nurbs_to_bytes(g, most_bytes, made.data, &made.size));
    CHECK(made.size >= at_knots && made.size <= most_bytes);
    return made;
}

static Bytes bytes_of_shape(SplineArgs shape) {
    nurbs *g = make(shape);
    Bytes made = bytes_of(g);
    nurbs_destroy(g);
    return made;
}

/* Half a circle, with a point at infinity. */
static nurbs *homogeneous(void) {
    static const double points[] = {1, 0, 1, 0, 1, 0, -1, 0, 1};
    const int32_t degree = 2;
    const int64_t count = 3;
    nurbs *g = NULL;
    CHECK_OK(nurbs_create_homogeneous(1, &degree, &count, (const double[]){0, 0, 0, 1, 1, 1}, 6, 2, points, 0,
                                      0, 0, &g));
    return g;
}

/* Two handles whose bytes are the same. */
static void check_same(int line, const nurbs *a, const nurbs *b) {
    const Bytes x = bytes_of(a), y = bytes_of(b);
    check_integers(__FILE__, line, "size", x.size, y.size);
    check_bits(__FILE__, line, x.data, y.data, sizeof x.data);
}

static void round_trip(int line, nurbs *g) {
    Bytes made = bytes_of(g), again;
    nurbs *copy = NULL;
    CHECK_OK(nurbs_from_bytes(made.data, made.size, &copy));
    check_same(line, copy, g);
    again = made;
    sign(again.data, again.size);
    check_bits(__FILE__, line, made.data, again.data, (size_t)made.size);
    nurbs_destroy(copy);
    nurbs_destroy(g);
}

static void all_forms(void) {
    round_trip(__LINE__, make(arch()));
    round_trip(__LINE__, make(circle()));
    round_trip(__LINE__, make(loop()));
    round_trip(__LINE__, make(stairs()));
    round_trip(__LINE__, make(trough()));
    round_trip(__LINE__, make(cube()));
    round_trip(__LINE__, homogeneous());
}

/* What stands where, by the layout that nurbs.h publishes. */
static void layout(void) {
    const Bytes made = bytes_of_shape(circle());
    const SplineArgs c = circle();
    CHECK_INT(made.size, 128 + 128 + 192 + 72);
    CHECK_BITS(made.data, "\x89NUR\r\n\x1a\n\x01\0\0\0\x01\0\0\0", 16);
    CHECK_INT(number_from(made.data + 16, 8), made.size);
    CHECK_INT(number_from(made.data + 32, 4), 1);
    CHECK_INT(number_from(made.data + 36, 4), 2);
    CHECK_INT(number_from(made.data + 40, 4), 1);
    CHECK_INT(number_from(made.data + at_axes, 8), 9);
    CHECK_INT(number_from(made.data + at_axes + 8, 4), 2);
    CHECK_INT(number_from(made.data + at_axes + 12, 4), 0);
    const uint64_t points = number_from(made.data + at_points_place, 8);
    const uint64_t weights = number_from(made.data + at_weights_place, 8);
    CHECK_INT(points, 256);
    CHECK_INT(weights, 448);
    for (int i = 0; i < 12; ++i) {
        CHECK(number_from(made.data + at_knots + 8 * i, 8) == bits_of(c.knots[i]));
    }
    for (int i = 0; i < 18; ++i) {
        CHECK(number_from(made.data + points + 8 * (size_t)i, 8) == bits_of(c.points[i]));
    }
    for (int i = 0; i < 9; ++i) {
        CHECK(number_from(made.data + weights + 8 * (size_t)i, 8) == bits_of(c.weights[i]));
    }
    const Bytes periodic = bytes_of_shape(loop());
    CHECK_INT(number_from(periodic.data + at_axes + 12, 4), 1);
    CHECK_INT(number_from(periodic.data + at_weights_place, 8), 0);
    CHECK_INT(number_from(periodic.data + 40, 4), 0);
    nurbs *g = homogeneous();
    const Bytes infinite = bytes_of(g);
    CHECK_INT(number_from(infinite.data + 40, 4), 2);
    nurbs_destroy(g);
}

/* Zeros with a sign, denormal numbers, and the largest and smallest there are. */
static void every_bit(void) {
    static const double knots[] = {-0.0, 0, 0x1p-1074, 0x1p-1074},
                        points[] = {-0.0, 0x1p-1074, -DBL_MAX, DBL_MIN / 3};
    const int32_t degree = 1;
    const int64_t count = 2;
    nurbs *g = NULL, *copy = NULL;
    CHECK_OK(nurbs_create(1, &degree, &count, knots, 4, 2, points, 0, 0, NULL, 0, 0, &g));
    const Bytes made = bytes_of(g);
    CHECK_OK(nurbs_from_bytes(made.data, made.size, &copy));
    CHECK_KNOTS(copy, 0, knots);
    CHECK_POINTS(copy, points);
    nurbs_destroy(g);
    nurbs_destroy(copy);
}

static void buffers(void) {
    nurbs *g = make(trough());
    Bytes made = bytes_of(g), again;
    int64_t size = -7;
    CHECK_OK(nurbs_to_bytes(g, 0, NULL, &size));
    CHECK_INT(size, made.size);
    CHECK_OK(nurbs_to_bytes(g, 0, NULL, NULL));
    CHECK_OK(nurbs_to_bytes(g, most_bytes, NULL, &size)); /* bytes are not wanted */
    FILL(again.data);
    CHECK_OK(nurbs_to_bytes(g, made.size, again.data, NULL));
    CHECK_BITS(made.data, again.data, (size_t)size);
    check_untouched(__FILE__, __LINE__, again.data + size, most_bytes - (size_t)size);
    struct {
        unsigned char data[most_bytes];
        int64_t size;
    } longer; /* no more is written than there is, whatever the cap */
    CHECK_OK(nurbs_to_bytes(g, INT64_MAX, longer.data, &longer.size));
    CHECK_INT(longer.size, made.size);
    FILL(again.data);
    size = -7;
    CHECK_FAILS(nurbs_to_bytes(NULL, 0, NULL, &size), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_to_bytes(g, -1, again.data, &size), NURBS_ERROR_COUNT, "cap = -1");
    CHECK_FAILS(nurbs_to_bytes(g, made.size - 1, again.data, &size), NURBS_ERROR_SIZE, "cap");
    CHECK_FAILS(nurbs_to_bytes(g, most_bytes, again.data, (int64_t *)(void *)again.data), NURBS_ERROR_OVERLAP,
                "bytes");
    CHECK_INT(size, -7);
    CHECK_UNTOUCHED(again.data);
    nurbs_destroy(g);
}

static void refused_bytes(void) {
    Bytes made = bytes_of_shape(circle());
    nurbs *g;
    for (int64_t size = 1; size < made.size; ++size) {
        CHECK_NO_HANDLE(g, nurbs_from_bytes(made.data, size, &g), NURBS_ERROR_TRUNCATED, "size = ");
    }
    CHECK_NO_HANDLE(g, nurbs_from_bytes(NULL, 0, &g), NURBS_ERROR_TRUNCATED, "size = 0");
    CHECK_NO_HANDLE(g, nurbs_from_bytes(NULL, made.size, &g), NURBS_ERROR_NULL, "bytes");
    CHECK_NO_HANDLE(g, nurbs_from_bytes(made.data, -1, &g), NURBS_ERROR_COUNT, "size = -1");
    CHECK_FAILS(nurbs_from_bytes(made.data, made.size, NULL), NURBS_ERROR_NULL, "out");
    CHECK_NO_HANDLE(g, nurbs_from_bytes(made.data, made.size + 8, &g), NURBS_ERROR_SYNTAX, "size = ");
    CHECK_NO_HANDLE(g, nurbs_from_bytes("NURBS", 5, &g), NURBS_ERROR_FORMAT, "begin");
    number_into(made.data + 12, NURBS_BYTES_STATISTICS, 4);
    sign(made.data, made.size);
    CHECK_NO_HANDLE(g, nurbs_from_bytes(made.data, made.size, &g), NURBS_ERROR_FORMAT,
                    "hold statistics, expected a spline");
    number_into(made.data + 12, 99, 4); // of a later library
    sign(made.data, made.size);
    CHECK_NO_HANDLE(g, nurbs_from_bytes(made.data, made.size, &g), NURBS_ERROR_FORMAT,
                    "hold a handle of kind 99, expected a spline");
    number_into(made.data + 12, NURBS_BYTES_SPLINE, 4);
    made.data[8] = 2;
    CHECK_NO_HANDLE(g, nurbs_from_bytes(made.data, made.size, &g), NURBS_ERROR_VERSION, "2.0");
}

/* No bit can change unnoticed. */
static void flipped_bits(SplineArgs shape) {
    Bytes made = bytes_of_shape(shape);
    for (int64_t i = 0; i < 8 * made.size; ++i) {
        nurbs *g = NULL;
        const unsigned char bit = (unsigned char)(1 << i % 8);
        made.data[i / 8] ^= bit;
        const nurbs_status status = nurbs_from_bytes(made.data, made.size, &g);
        if (status == NURBS_OK || g != NULL || (i >= 8 * 24 && status != NURBS_ERROR_CHECKSUM)) {
            check_report(__FILE__, __LINE__, "");
            fprintf(stderr, "bit %d of byte %d: %s\n", (int)(i % 8), (int)(i / 8), nurbs_status_name(status));
        }
        nurbs_destroy(g);
        made.data[i / 8] ^= bit;
    }
}

static void check_bad_number(int line, SplineArgs shape, int place, uint64_t value, int size,
                             nurbs_status status, const char *words) {
    nurbs *g = check_poison();
    Bytes made = bytes_of_shape(shape);
    number_into(made.data + place, value, size);
    sign(made.data, made.size);
    check_forget();
    check_refusal(__FILE__, line, nurbs_from_bytes(made.data, made.size, &g), status, words);
    check_true(__FILE__, line, g == NULL, "g == NULL");
}
#define BAD_NUMBER(shape, place, value, size, status, words)                                                 \
    check_bad_number(__LINE__, shape, place, (uint64_t)(value), size, NURBS_ERROR_##status, words)

/* Values of good bytes replaced by some that nurbs_create() refuses: the same statuses. */
static void values_of_no_spline(void) {
    enum { points = 256, weights = 448, knots_of_axis_1 = at_knots + 48 };
    BAD_NUMBER(circle(), 32, 0, 4, AXES, "axes = 0");
    BAD_NUMBER(circle(), 32, 4, 4, AXES, "axes = 4");
    BAD_NUMBER(circle(), 36, 0, 4, DIMENSION, "dim = 0");
    BAD_NUMBER(circle(), 36, INT32_MAX, 4, DIMENSION, "dim = 2147483647");
    BAD_NUMBER(circle(), 36, 3, 4, SYNTAX, "weights at byte 448|512");
    BAD_NUMBER(arch(), 36, 3, 4, TRUNCATED, "12 numbers");
    BAD_NUMBER(circle(), 36, 1, 4, SYNTAX, "weights at byte 448|384");
    BAD_NUMBER(circle(), 40, 3, 4, SYNTAX, "form = 3");
    BAD_NUMBER(circle(), 40, -1, 4, SYNTAX, "form = -1");
    BAD_NUMBER(circle(), 40, 0, 4, SYNTAX, "weights at byte 448");
    BAD_NUMBER(loop(), 40, 1, 4, SYNTAX, "weights at byte 0");
    BAD_NUMBER(circle(), at_axes, 0, 8, COUNT, "counts[0] = 0");
    BAD_NUMBER(circle(), at_axes, -1, 8, COUNT, "counts[0] = -1");
    BAD_NUMBER(circle(), at_axes, 2, 8, TOO_FEW_POINTS, "counts[0] = 2");
    BAD_NUMBER(circle(), at_axes, INT64_MAX, 8, OVERFLOW, "points");
    BAD_NUMBER(circle(), at_axes, 1 << 20, 8, TRUNCATED, "1048579 numbers");
    BAD_NUMBER(circle(), at_axes + 8, 32, 4, DEGREE, "degrees[0] = 32");
    BAD_NUMBER(circle(), at_axes + 8, -1, 4, DEGREE, "degrees[0] = -1");
    BAD_NUMBER(circle(), at_axes + 12, 2, 4, FLAGS, "flags[0] = 0x2");
    BAD_NUMBER(trough(), at_axes + 16 + 12, 3, 4, FLAGS, "flags[1] = 0x3");
    BAD_NUMBER(circle(), at_axes + 12, 1, 4, PERIODIC_KNOTS, "knots[7");
    BAD_NUMBER(circle(), at_points_place, 320, 8, SYNTAX, "points at byte 320, expected at byte 256");
    BAD_NUMBER(circle(), at_weights_place, 0, 8, SYNTAX, "weights at byte 0, expected at byte 448");
    BAD_NUMBER(circle(), at_knots + 8, bits_of(NAN), 8, KNOT_NOT_FINITE, "knots[1] = nan");
    BAD_NUMBER(trough(), knots_of_axis_1 + 16, bits_of(-1), 8, KNOTS_DECREASING, "knots[8] = -1 on axis 1");
    BAD_NUMBER(circle(), points + 24, bits_of(INFINITY), 8, POINT_NOT_FINITE, "points[1][1] = inf");
    BAD_NUMBER(circle(), weights + 16, bits_of(-1), 8, WEIGHT_NEGATIVE, "weights[2] = -1");
    BAD_NUMBER(circle(), weights + 16, bits_of(NAN), 8, WEIGHT_NOT_FINITE, "weights[2] = nan");
    BAD_NUMBER(circle(), weights, bits_of(0), 8, WEIGHTS_VANISH, "(0)");
    BAD_NUMBER(loop(), points + 8, bits_of(-1), 8, PERIODIC_POINTS, "points[4] = 1 differs");
}

/* Bytes behind the last part belong to a later minor version, or to nobody. */
static void bytes_behind(void) {
    Bytes made = bytes_of_shape(arch());
    nurbs *g = NULL, *same = make(arch());
    made.size += 8;
    number_into(made.data + 16, (uint64_t)made.size, 8);
    sign(made.data, made.size);
    CHECK_NO_HANDLE(g, nurbs_from_bytes(made.data, made.size, &g), NURBS_ERROR_SYNTAX, "8 bytes behind");
    made.data[10] = 1;
    sign(made.data, made.size);
    CHECK_OK(nurbs_from_bytes(made.data, made.size, &g));
    check_same(__LINE__, g, same);
    nurbs_destroy(g);
    nurbs_destroy(same);
}

static void kinds(void) {
    Bytes made = bytes_of_shape(arch());
    int32_t kind = -1, major = -1, minor = -1;
    CHECK_OK(nurbs_bytes_kind(made.data, header_bytes, &kind, &major, &minor));
    CHECK_INT(kind, NURBS_BYTES_SPLINE);
    CHECK_INT(major, 1);
    CHECK_INT(minor, 0);
    CHECK_OK(nurbs_bytes_kind(made.data, made.size, NULL, NULL, NULL));
    made.data[8] = 7; /* a later version, not signed */
    made.data[10] = 3;
    made.data[12] = 99;
    CHECK_OK(nurbs_bytes_kind(made.data, made.size, &kind, &major, &minor));
    CHECK_INT(kind, 99);
    CHECK_INT(major, 7);
    CHECK_INT(minor, 3);
    CHECK_FAILS(nurbs_bytes_kind(made.data, made.size, &kind, &kind, &minor), NURBS_ERROR_OVERLAP,
                "major|kind");
    CHECK_FAILS(nurbs_bytes_kind(made.data, 63, &kind, NULL, NULL), NURBS_ERROR_TRUNCATED, "size = 63");
    CHECK_FAILS(nurbs_bytes_kind(NULL, 64, &kind, NULL, NULL), NURBS_ERROR_NULL, "bytes");
    CHECK_FAILS(nurbs_bytes_kind(made.data, -1, &kind, NULL, NULL), NURBS_ERROR_COUNT, "size = -1");
    made.data[4] = '\n'; /* as a transfer in text mode does */
    CHECK_FAILS(nurbs_bytes_kind(made.data, made.size, &kind, NULL, NULL), NURBS_ERROR_FORMAT, "begin");
    CHECK_INT(kind, 99);
}

/* The checksum of a spline of many numbers, in each of the three forms. */
static uint64_t checksum_of_many(int form, int32_t axes) {
    enum { n = 5, degree = 2, dim = 2 };
    static double knots[3 * (n + degree + 1)], points[n * n * n * (dim + 1)], weights[n * n * n];
    uint64_t state = 7;
    const int32_t degrees[3] = {degree, degree, degree};
    const int64_t counts[3] = {n, n, n};
    nurbs *g = NULL;
    for (int32_t k = 0; k < axes; ++k) {
        for (int i = 0; i < n + degree + 1; ++i) {
            knots[k * (n + degree + 1) + i] = i * i / 7.0 * (k + 1);
        }
    }
    for (int i = 0; i < n * n * n * (dim + 1); ++i) {
        points[i] = next_number(&state) - 0.25;
    }
    for (int i = 0; i < n * n * n; ++i) {
        weights[i] = next_number(&state);
    }
    if (form == 2) {
        CHECK_OK(nurbs_create_homogeneous(axes, degrees, counts, knots, axes * (n + degree + 1), dim, points,
                                          0, 0, 0, &g));
    } else {
        CHECK_OK(nurbs_create(axes, degrees, counts, knots, axes * (n + degree + 1), dim, points, 0, 0,
                              form == 1 ? weights : NULL, 0, 0, &g));
    }
    const Bytes made = bytes_of(g);
    nurbs_destroy(g);
    return number_from(made.data + 24, 8);
}

/* Bytes of another machine are read, and hashes of bytes are hashes of splines: each makes these. */
static void same_on_every_machine(void) {
    const uint64_t expected[3][3] = {
        {UINT64_C(0x74b66b15e23b0a0c), UINT64_C(0xad04876bfa66c60f), UINT64_C(0xb1d98da8beea3200)},
        {UINT64_C(0xa499f42e6b6a1873), UINT64_C(0xd912e8dd17da7d1c), UINT64_C(0xff62bec40bd36e92)},
        {UINT64_C(0x366e5c5540f580ad), UINT64_C(0x0387d1da3437ef90), UINT64_C(0xaf5a73a80b6928da)}};
    for (int form = 0; form < 3; ++form) {
        for (int32_t axes = 1; axes <= 3; ++axes) {
            const uint64_t found = checksum_of_many(form, axes);
            if (found != expected[form][axes - 1]) {
                check_report(__FILE__, __LINE__, "other bytes than elsewhere\n");
                printf("form %d, %d axes: checksum 0x%llx\n", form, (int)axes, (unsigned long long)found);
            }
        }
    }
}

int main(void) {
    all_forms();
    layout();
    every_bit();
    buffers();
    refused_bytes();
    flipped_bits(circle());
    flipped_bits(trough());
    values_of_no_spline();
    bytes_behind();
    kinds();
    same_on_every_machine();
    return check_summary("spline_bytes");
}
