/* SPDX-License-Identifier: MIT */
/* Faces as bytes: where numbers stand, what comes back, and bytes that no face has. */
#include "faces.h"
#include "signed_bytes.h"

#include <math.h>

/* Where the parts of frame_face() begin, whose second loop is turned: three splines, each loop of one curve. */
enum { at_sizes = 64, at_face = 128, at_loops = 192, at_coedges = 256, at_places = 384, at_splines = 448 };
enum { loop_bytes = 16, coedge_bytes = 40 };

static Bytes bytes_of(const nurbs_face *face) {
    Bytes made;
    memset(&made, 0, sizeof made);
    CHECK_OK(nurbs_face_to_bytes(face, most_bytes, made.data, &made.size));
    CHECK(made.size >= 2 * header_bytes && made.size <= most_bytes);
    return made;
}

static nurbs *edge(double x0, double y0, double x1, double y1, double height) {
    static const int32_t degree = 1;
    static const int64_t count = 2;
    static const double knots[] = {0, 0, 1, 1};
    const double points[] = {x0, y0, height, x1, y1, height};
    SplineArgs a = {1, &degree, &count, knots, 4, 3, points, 0, 0, NULL, 0, 0};
    return make(a);
}

/* A triangle of the plane whose curves are made under edges at 2^-20 above it. */
static nurbs_face *lifted(void) {
    static const double height = 0x1p-20;
    nurbs *surface = plane(), *a = edge(0, 0, 1, 0, height), *b = edge(1, 0, 0, 2, height),
          *c = edge(0, 2, 0, 0, height);
    nurbs_face *face = NULL;
    const int64_t keys[] = {3, 0, 5};
    CHECK_OK(nurbs_face_create(surface, 1, SIZES(3), NULL, CURVES(a, b, c), keys, 0x1p-10, 0, NULL, &face));
    nurbs_destroy(surface);
    nurbs_destroy(a);
    nurbs_destroy(b);
    nurbs_destroy(c);
    if (face == NULL) {
        exit(2);
    }
    return face;
}

static void bytes_and_back(void) {
    nurbs_face *faces[] = {frame_face(), lifted()};
    for (int i = 0; i < 2; ++i) {
        const Bytes made = bytes_of(faces[i]);
        nurbs_face *again = NULL;
        int32_t kind = 0;
        CHECK_OK(nurbs_bytes_kind(made.data, made.size, &kind, NULL, NULL));
        CHECK_INT(kind, NURBS_BYTES_FACE);
        CHECK_OK(nurbs_face_from_bytes(made.data, made.size, &again));
        const Bytes same = bytes_of(again);
        CHECK_BITS(made.data, same.data, sizeof made.data);
        double area[2] = {-1, -2}, distance[2] = {-1, -2};
        int32_t proven = 0;
        CHECK_OK(nurbs_face_area(faces[i], 1e-6, &area[0], NULL));
        CHECK_OK(nurbs_face_area(again, 1e-6, &area[1], NULL));
        CHECK_DOUBLE(area[1], area[0]);
        CHECK_OK(nurbs_face_deviation(faces[i], 0, 0, &distance[0], NULL));
        CHECK_OK(nurbs_face_deviation(again, 0, 0, &distance[1], &proven));
        CHECK_DOUBLE(distance[1], distance[0]);
        CHECK_INT(proven, 1);
        nurbs_face_destroy(again);
        nurbs_face_destroy(faces[i]);
    }
}

/* The layout that the manual publishes. */
static void layout(void) {
    nurbs_face *face = frame_face();
    const Bytes made = bytes_of(face);
    CHECK_BITS(made.data, "\x89NUR\r\n\x1a\n\x01\0\0\0\x04\0\0\0", 16);
    static const int64_t sizes[] = {2, 2, 3};
    static const int64_t numbers[] = {0, 2, 0};
    for (int i = 0; i < 3; ++i) {
        CHECK_INT(number_from(made.data + at_sizes + 8 * i, 8), sizes[i]);
        CHECK_INT(number_from(made.data + at_face + 8 * i, 8), numbers[i]);
    }
    CHECK(number_from(made.data + at_face + 24, 8) == bits_of(1e-9));
    for (int i = 0; i < 2; ++i) { /* the hole was turned */
        CHECK_INT(number_from(made.data + at_loops + loop_bytes * i, 8), 1);
        CHECK_INT(number_from(made.data + at_loops + loop_bytes * i + 8, 8), i == 0);
        CHECK_INT(number_from(made.data + at_coedges + coedge_bytes * i, 8), i + 1);
        CHECK(number_from(made.data + at_coedges + coedge_bytes * i + 8, 8) == UINT64_MAX);
        CHECK_INT(number_from(made.data + at_coedges + coedge_bytes * i + 16, 8), 0);
        CHECK_INT(number_from(made.data + at_coedges + coedge_bytes * i + 24, 8), 0);
    }
    CHECK_INT(number_from(made.data + at_places, 8), at_splines);
    nurbs_face_destroy(face);
}

static void buffers(void) {
    nurbs_face *face = frame_face();
    Bytes made = bytes_of(face), again;
    int64_t size = -7;
    CHECK_OK(nurbs_face_to_bytes(face, 0, NULL, &size));
    CHECK_INT(size, made.size);
    FILL(again.data);
    size = -7;
    CHECK_FAILS(nurbs_face_to_bytes(NULL, 0, NULL, &size), NURBS_ERROR_NULL, "face");
    CHECK_FAILS(nurbs_face_to_bytes(face, -1, again.data, &size), NURBS_ERROR_COUNT, "cap = -1");
    CHECK_FAILS(nurbs_face_to_bytes(face, made.size - 1, again.data, &size), NURBS_ERROR_SIZE, "cap");
    CHECK_FAILS(nurbs_face_to_bytes(face, most_bytes, again.data, (int64_t *)(void *)again.data),
                NURBS_ERROR_OVERLAP, "bytes");
    CHECK_INT(size, -7);
    CHECK_UNTOUCHED(again.data);
    nurbs_face_destroy(face);
}

static void refused_bytes(void) {
    nurbs_face *whole = frame_face(), *face;
    nurbs *g;
    Bytes made = bytes_of(whole);
    for (int64_t size = 1; size < made.size; ++size) {
        CHECK_NO_FACE(face, nurbs_face_from_bytes(made.data, size, &face), NURBS_ERROR_TRUNCATED, "size = ");
    }
    for (int64_t i = 0; i < 8 * made.size; ++i) {
        const unsigned char bit = (unsigned char)(1 << i % 8);
        made.data[i / 8] ^= bit;
        face = NULL;
        const nurbs_status status = nurbs_face_from_bytes(made.data, made.size, &face);
        CHECK(face == NULL && status != NURBS_OK && (i < 8 * 24 || status == NURBS_ERROR_CHECKSUM));
        made.data[i / 8] ^= bit;
    }
    CHECK_NO_FACE(face, nurbs_face_from_bytes(NULL, 64, &face), NURBS_ERROR_NULL, "bytes");
    CHECK_NO_FACE(face, nurbs_face_from_bytes(made.data, -1, &face), NURBS_ERROR_COUNT, "size = -1");
    CHECK_FAILS(nurbs_face_from_bytes(made.data, made.size, NULL), NURBS_ERROR_NULL, "out");
    CHECK_NO_HANDLE(g, nurbs_from_bytes(made.data, made.size, &g), NURBS_ERROR_FORMAT,
                    "hold a face, expected a spline");
    nurbs_face_destroy(whole);
}

static void check_bad_number(int line, nurbs_face *whole, int place, uint64_t value, nurbs_status status,
                             const char *words) {
    nurbs_face *face = (nurbs_face *)(void *)check_before;
    Bytes made = bytes_of(whole);
    number_into(made.data + place, value, 8);
    sign(made.data, made.size);
    check_forget();
    check_refusal(__FILE__, line, nurbs_face_from_bytes(made.data, made.size, &face), status, words);
    check_true(__FILE__, line, face == NULL, "face == NULL");
    nurbs_face_destroy(whole);
}
#define BAD_NUMBER(place, value, status, words)                                                              \
    check_bad_number(__LINE__, frame_face(), place, (uint64_t)(value), NURBS_ERROR_##status, words)

/* Numbers of good bytes replaced by some that no face has. */
static void numbers_of_no_face(void) {
    BAD_NUMBER(at_sizes, -1, SYNTAX, "number of loops = -1");
    BAD_NUMBER(at_sizes, 1, SYNTAX, "number of loops 2, expected 0 to 1");
    BAD_NUMBER(at_sizes, 3, SYNTAX, "1 loops and 0 curves belong to no face");
    BAD_NUMBER(at_sizes + 8, INT64_MAX, SYNTAX, "number of curves = 9223372036854775807");
    BAD_NUMBER(at_sizes + 8, 1, SYNTAX, "");
    BAD_NUMBER(at_sizes + 8, 200, TRUNCATED, "200 numbers at byte 256");
    BAD_NUMBER(at_sizes + 16, 2, SYNTAX, "320 bytes behind the last part");
    BAD_NUMBER(at_face, 3, SYNTAX, "surface 3, expected 0 to 2");
    BAD_NUMBER(at_face, 1, AXES, "the surface of a face has 1 axes");
    BAD_NUMBER(at_face + 8, -1, SYNTAX, "number of loops -1");
    BAD_NUMBER(at_face + 16, 2, SYNTAX, "flags of a face 0x2, expected bits of 0x1");
    BAD_NUMBER(at_face + 24, bits_of(NAN), TOLERANCE, "tolerance = nan");
    BAD_NUMBER(at_face + 24, bits_of(-1), TOLERANCE, "tolerance = -1");
    BAD_NUMBER(at_loops, 0, SYNTAX, "number of curves of a loop 0, expected 1 to 2");
    BAD_NUMBER(at_loops, 3, SYNTAX, "number of curves of a loop 3, expected 1 to 2");
    BAD_NUMBER(at_loops + 8, 2, SYNTAX, "flags of a loop 0x2");
    BAD_NUMBER(at_coedges, 0, AXES, "a curve of a loop has 2 axes");
    BAD_NUMBER(at_coedges + 8, 3, SYNTAX, "edge 3, expected -1 to 2");
    BAD_NUMBER(at_coedges + 8, 1, DIMENSION, "an edge has dimension 2, expected 3");
    BAD_NUMBER(at_coedges + 16, INT64_MIN, SYNTAX, "key -9223372036854775808");
    BAD_NUMBER(at_coedges + 24, 4, SYNTAX, "flags of a curve 0x4");
    BAD_NUMBER(at_coedges + 24, 2, SYNTAX, "distance = 0 of a curve and an edge");
    BAD_NUMBER(at_coedges + 32, bits_of(1), SYNTAX, "distance = 1 of a curve and an edge");
    BAD_NUMBER(at_coedges + 32, bits_of(INFINITY), SYNTAX, "distance inf is not finite");
    BAD_NUMBER(at_places, 0, SYNTAX, "a record at byte 0, expected at byte 448");
}

/* The plane without a square. */
static nurbs_face *with_hole(void) {
    nurbs *surface = plane(), *hole = NULL, *outline = square(0.25, 0.5);
    nurbs_face *face = NULL;
    CHECK_OK(nurbs_reverse(outline, 0, 0, &hole));
    CHECK_OK(
        nurbs_face_create(surface, 1, SIZES(1), CURVES(hole), NULL, NULL, 0, NURBS_AS_ORIENTED, NULL, &face));
    nurbs_destroy(surface);
    nurbs_destroy(hole);
    nurbs_destroy(outline);
    if (face == NULL) {
        exit(2);
    }
    return face;
}

/* Distances smaller than what is proven, and a loop that would not have been turned. */
static void what_does_not_hold(void) {
    const int distance = at_coedges + 32, turned = at_loops + 8;
    check_bad_number(__LINE__, with_hole(), turned, 1, NURBS_ERROR_ORIENTATION,
                     "loop 0 is turned by the bytes");
    check_bad_number(__LINE__, lifted(), distance, bits_of(0x1p-21), NURBS_ERROR_SYNTAX,
                     "edge 0 of loop 0 is within 4.76837158203125e-07 of the surface by the bytes");
}

/* Faces of one machine are those of another: these bytes are written everywhere. */
static void same_on_every_machine(void) {
    nurbs_face *frame = frame_face(), *triangle = lifted();
    const Bytes made = bytes_of(frame), of_edges = bytes_of(triangle);
    CHECK(number_from(made.data + 24, 8) == UINT64_C(0x8130d9663a4b12f1));
    CHECK(number_from(of_edges.data + 24, 8) == UINT64_C(0xb9acb9c9190b2292));
    nurbs_face_destroy(frame);
    nurbs_face_destroy(triangle);
}

int main(void) {
    bytes_and_back();
    layout();
    buffers();
    refused_bytes();
    numbers_of_no_face();
    what_does_not_hold();
    same_on_every_machine();
    return check_summary("face_bytes");
}
