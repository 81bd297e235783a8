/* SPDX-License-Identifier: MIT */
/* Models as bytes: where numbers stand, what comes back, and bytes that no model has. */
#include "models.h"
#include "signed_bytes.h"

#include <math.h>

/* Where the parts of the model of half_ball begin: one part and one use of it, two faces of one loop of one curve, one edge, one
 * vertex, the shapes of a circle, a plane and a sphere, four texts, five splines. */
enum {
    at_sizes = 64,
    at_metres = 192,
    at_uses = 256,
    at_attributes = 384,
    at_layer_counts = 512,
    at_faces = 576,
    at_loops = 640,
    at_coedges = 704,
    at_coedge_edges = 832,
    at_edges = 896,
    at_vertices = 960,
    at_curves = 1024,
    at_surfaces = 1344,
    at_ends = 2048,
    at_texts = 2112,
    at_places = 2176,
    at_splines = 2240
};
enum { attribute_bytes = 56, surface_bytes = 336 };

static nurbs_model *from_file(void) {
    nurbs_model *model = NULL;
    CHECK_OK(nurbs_read_model(half_ball, sizeof half_ball - 1, NULL, &model));
    if (model == NULL) {
        exit(2);
    }
    return model;
}

/* Two sides of the box, which share an edge. */
static nurbs_model *two_sides(void) {
    static const int at[2][4] = {{0, 2, 3, 1}, {0, 1, 5, 4}};
    nurbs_face *faces[] = {box_face(at[0]), box_face(at[1])};
    nurbs_model *model = NULL;
    CHECK_OK(nurbs_model_create(2, (const nurbs_face *const *)faces, 0.001, &model));
    nurbs_face_destroy(faces[0]);
    nurbs_face_destroy(faces[1]);
    if (model == NULL) {
        exit(2);
    }
    return model;
}

static Bytes bytes_of(const nurbs_model *model) {
    Bytes made;
    memset(&made, 0, sizeof made);
    CHECK_OK(nurbs_model_to_bytes(model, most_bytes, made.data, &made.size));
    CHECK(made.size >= 2 * header_bytes && made.size <= most_bytes);
    return made;
}

static void check_half_ball(const nurbs_model *model) {
    char name[16] = "?";
    int32_t shape = -1, against = -1;
    int64_t counts[5] = {-1, -1, -1, -1, -1}, uses = 0;
    double colour[3] = {0, 0, 0};
    nurbs_face *face = NULL;
    nurbs *edge = NULL;
    CHECK_OK(nurbs_model_counts(model, &counts[0], &counts[1], &counts[2], &counts[3], &counts[4]));
    for (int i = 0; i < 5; ++i) {
        CHECK_INT(counts[i], i == 2 ? 2 : 1);
    }
    CHECK_OK(nurbs_model_face_name(model, 0, name, sizeof name, NULL));
    CHECK(strcmp(name, "disk") == 0);
    CHECK_OK(nurbs_model_face(model, 0, NULL, &shape, &against, colour, &face));
    CHECK_INT(shape, NURBS_SHAPE_PLANE);
    CHECK_INT(against, 1);
    CHECK(isnan(colour[0]) && isnan(colour[1]) && isnan(colour[2]));
    CHECK_OK(nurbs_model_edge(model, 0, NULL, NULL, &shape, &edge));
    CHECK_INT(shape, NURBS_SHAPE_CIRCLE);
    CHECK_OK(nurbs_model_edge_uses(model, 0, 0, NULL, &uses));
    CHECK_INT(uses, 2);
    nurbs_face_destroy(face);
    nurbs_destroy(edge);
}

static void bytes_and_back(void) {
    nurbs_model *models[] = {from_file(), two_sides(), NULL};
    CHECK_OK(nurbs_model_create(0, NULL, 0, &models[2]));
    for (int i = 0; i < 3; ++i) {
        const Bytes made = bytes_of(models[i]);
        nurbs_model *again = NULL;
        int32_t kind = 0;
        CHECK_OK(nurbs_bytes_kind(made.data, made.size, &kind, NULL, NULL));
        CHECK_INT(kind, NURBS_BYTES_MODEL);
        CHECK_OK(nurbs_model_from_bytes(made.data, made.size, &again));
        const Bytes same = bytes_of(again);
        CHECK_BITS(made.data, same.data, sizeof made.data);
        if (i == 0) {
            check_half_ball(models[i]);
            check_half_ball(again);
        }
        nurbs_model_destroy(again);
        nurbs_model_destroy(models[i]);
    }
}

static void check_numbers(int line, const unsigned char *bytes, int count, const int64_t *expected) {
    for (int i = 0; i < count; ++i) {
        check_true(__FILE__, line, (int64_t)number_from(bytes + 8 * i, 8) == expected[i],
                   "numbers as laid out");
    }
}
#define NUMBERS(place, count, ...)                                                                           \
    check_numbers(__LINE__, made.data + (place), count, (const int64_t[]){__VA_ARGS__})

/* The layout that the manual publishes. */
static void layout(void) {
    nurbs_model *model = from_file();
    const Bytes made = bytes_of(model);
    CHECK_BITS(made.data, "\x89NUR\r\n\x1a\n\x01\0\0\0\x05\0\0\0", 16);
    NUMBERS(at_sizes, 16, 0, 0, 1, 1, 2, 2, 2, 1, 1, 0, 1, 2, 7, 5, 0, 0);
    CHECK(number_from(made.data + at_metres, 8) == bits_of(0.01));
    NUMBERS(at_uses, 3, -1, 0, (int64_t)bits_of(1));
    NUMBERS(at_attributes, 7, 0, 0, 1, 0, 0, 0, 0);
    NUMBERS(at_attributes + attribute_bytes, 7, 1, 0, 0, 0, 0, 0, 0);
    NUMBERS(at_faces, 3, 0, 1, 0);
    NUMBERS(at_loops, 4, 1, 0, 1, 0);
    NUMBERS(at_coedges, 10, 1, 2, 1, 2, 0, 4, 2, 1, 0, 0); /* under the plane it is proven */
    NUMBERS(at_coedge_edges, 2, 0, 0);
    NUMBERS(at_edges, 5, 2, 0, 0, 0, 0);
    NUMBERS(at_vertices, 3, (int64_t)bits_of(1), 0, 0);
    NUMBERS(at_curves, 4, 1, 3, -1, 0);
    NUMBERS(at_surfaces, 5, 0, -1, -1, -1, 0);
    NUMBERS(at_surfaces + surface_bytes, 5, 3, -1, -1, -1, 0);
    CHECK(number_from(made.data + at_surfaces + surface_bytes + 8 * 32, 8) == bits_of(1)); /* the radius */
    NUMBERS(at_ends, 4, 0, 0, 4, 7);
    CHECK_BITS(made.data + at_texts, "disk#18", 7);
    NUMBERS(at_places, 1, at_splines);
    nurbs_model_destroy(model);
}

static void buffers(void) {
    nurbs_model *model = two_sides();
    Bytes made = bytes_of(model), again;
    int64_t size = -7;
    CHECK_OK(nurbs_model_to_bytes(model, 0, NULL, &size));
    CHECK_INT(size, made.size);
    FILL(again.data);
    size = -7;
    CHECK_FAILS(nurbs_model_to_bytes(NULL, 0, NULL, &size), NURBS_ERROR_NULL, "model");
    CHECK_FAILS(nurbs_model_to_bytes(model, -1, again.data, &size), NURBS_ERROR_COUNT, "cap = -1");
    CHECK_FAILS(nurbs_model_to_bytes(model, made.size - 1, again.data, &size), NURBS_ERROR_SIZE, "cap");
    CHECK_FAILS(nurbs_model_to_bytes(model, most_bytes, again.data, (int64_t *)(void *)again.data),
                NURBS_ERROR_OVERLAP, "bytes");
    CHECK_INT(size, -7);
    CHECK_UNTOUCHED(again.data);
    nurbs_model_destroy(model);
}

static void refused_bytes(void) {
    nurbs_model *whole = from_file(), *model;
    nurbs_face *face;
    Bytes made = bytes_of(whole);
    for (int64_t size = 1; size < made.size; ++size) {
        CHECK_NO_MODEL(model, nurbs_model_from_bytes(made.data, size, &model), NURBS_ERROR_TRUNCATED,
                       "size = ");
    }
    for (int64_t i = 0; i < 8 * made.size; ++i) {
        const unsigned char bit = (unsigned char)(1 << i % 8);
        made.data[i / 8] ^= bit;
        model = NULL;
        const nurbs_status status = nurbs_model_from_bytes(made.data, made.size, &model);
        CHECK(model == NULL && status != NURBS_OK && (i < 8 * 24 || status == NURBS_ERROR_CHECKSUM));
        made.data[i / 8] ^= bit;
    }
    CHECK_NO_MODEL(model, nurbs_model_from_bytes(NULL, 64, &model), NURBS_ERROR_NULL, "bytes");
    CHECK_NO_MODEL(model, nurbs_model_from_bytes(made.data, -1, &model), NURBS_ERROR_COUNT, "size = -1");
    CHECK_FAILS(nurbs_model_from_bytes(made.data, made.size, NULL), NURBS_ERROR_NULL, "out");
    CHECK_NO_FACE(face, nurbs_face_from_bytes(made.data, made.size, &face), NURBS_ERROR_FORMAT,
                  "hold a model, expected a face");
    nurbs_model_destroy(whole);
}

static void check_bad_number(int line, int place, uint64_t value, nurbs_status status, const char *words) {
    nurbs_model *whole = from_file(), *model = (nurbs_model *)(void *)check_before;
    Bytes made = bytes_of(whole);
    number_into(made.data + place, value, 8);
    sign(made.data, made.size);
    check_forget();
    check_refusal(__FILE__, line, nurbs_model_from_bytes(made.data, made.size, &model), status, words);
    check_true(__FILE__, line, model == NULL, "model == NULL");
    nurbs_model_destroy(whole);
}
#define BAD_NUMBER(place, value, status, words)                                                              \
    check_bad_number(__LINE__, place, (uint64_t)(value), NURBS_ERROR_##status, words)

/* Numbers of good bytes replaced by some that no model has. */
static void numbers_of_no_model(void) {
    BAD_NUMBER(at_sizes, -1, SYNTAX, "number of splines by name = -1");
    BAD_NUMBER(at_sizes + 8, -1, SYNTAX, "number of notes = -1");
    BAD_NUMBER(at_sizes + 16, 0, SYNTAX, "texts");
    BAD_NUMBER(at_sizes + 24, INT64_MAX, SYNTAX, "number of uses = 9223372036854775807");
    BAD_NUMBER(at_sizes + 32, 5000, TRUNCATED, "5000 numbers");
    BAD_NUMBER(at_sizes + 64, -1, SYNTAX, "number of vertices = -1");
    BAD_NUMBER(at_sizes + 96, 8, SYNTAX, "the texts end at byte 7, expected 8");
    BAD_NUMBER(at_metres, bits_of(-1), FACTOR, "metres = -1");
    BAD_NUMBER(at_uses, -2, SYNTAX, "the parent of a use -2, expected -1 to 0");
    BAD_NUMBER(at_uses, 0, SYNTAX, "part 0 is placed in part 0, which is in it");
    BAD_NUMBER(at_uses + 8, 1, SYNTAX, "the part of a use 1, expected 0 to 0");
    BAD_NUMBER(at_uses + 16, bits_of(NAN), SYNTAX, "a number of a placement nan");
    BAD_NUMBER(at_attributes, 2, SYNTAX, "the shape of a face 2, expected -1 to 1");
    BAD_NUMBER(at_attributes + 8, -1, SYNTAX, "the part of a face -1");
    BAD_NUMBER(at_attributes + 16, 8, SYNTAX, "flags of a face 0x8");
    BAD_NUMBER(at_attributes + 48, 2, SYNTAX, "the solid of a face 2, expected -1 to 1");
    BAD_NUMBER(at_attributes + 48, -2, SYNTAX, "the solid of a face -2, expected -1 to 1");
    BAD_NUMBER(at_attributes + 24, bits_of(2), SYNTAX, "a colour 2, expected 0 to 1");
    BAD_NUMBER(at_layer_counts, 1, SYNTAX, "a number of layers 1, expected 0 to 0");
    BAD_NUMBER(at_faces, 1, AXES, "face 0: the surface of a face has 1 axes");
    BAD_NUMBER(at_coedges + 40, 7, SYNTAX, "face 1: curve 7, expected 0 to 4");
    BAD_NUMBER(at_coedge_edges, 1, SYNTAX, "the edge of a curve 1, expected -1 to 0");
    BAD_NUMBER(at_edges, 5, SYNTAX, "the curve of an edge 5, expected 0 to 4");
    BAD_NUMBER(at_edges, 0, AXES, "the curve of an edge has 2 axes");
    BAD_NUMBER(at_edges, 1, DIMENSION, "the curve of an edge has dimension 2, expected 3");
    BAD_NUMBER(at_edges + 8, 1, SYNTAX, "the shape of an edge 1");
    BAD_NUMBER(at_edges + 16, 1, SYNTAX, "the vertex of an edge 1, expected -1 to 0");
    BAD_NUMBER(at_edges + 32, 1, SYNTAX, "the part of an edge 1");
    BAD_NUMBER(at_vertices, bits_of(INFINITY), SYNTAX, "a coordinate of a vertex inf");
}

/* The same of shapes. */
static void numbers_of_no_shape(void) {
    enum {
        place = 32,
        vector_x = place + 24,
        given_axis = place + 168,
        given_x = place + 192,
        size = place + 216,
        place_of_surface = 40
    };
    const int sphere = at_surfaces + surface_bytes;
    BAD_NUMBER(at_curves, 8, SYNTAX, "the kind of a shape 8, expected 0 to 7");
    BAD_NUMBER(at_curves, 5, SYNTAX, "the spline of a shape -1, expected 0 to 4");
    BAD_NUMBER(at_curves, 6, SYNTAX, "the number of pieces of a shape 0, expected 1 to 1");
    BAD_NUMBER(at_curves + 8, 4, SYNTAX, "the dimension of a shape 4, expected 2 to 3");
    BAD_NUMBER(at_curves + 16, 2, SYNTAX, "the spline of a shape 2, expected -1 to -1");
    BAD_NUMBER(at_curves + 24, 1, SYNTAX, "the number of pieces of a shape 1, expected 0 to 0");
    BAD_NUMBER(at_curves + vector_x, bits_of(2), DIRECTION, "the axes of a shape");
    BAD_NUMBER(at_curves + vector_x, bits_of(NAN), SYNTAX, "a coordinate of the place of a shape nan");
    BAD_NUMBER(at_curves + given_axis, bits_of(2), DIRECTION, "a direction given for an axis of a shape");
    BAD_NUMBER(at_curves + given_axis, bits_of(INFINITY), SYNTAX, "a coordinate of the place of a shape inf");
    BAD_NUMBER(at_curves + given_x + 8, bits_of(-1), DIRECTION, "a direction given for an axis of a shape");
    BAD_NUMBER(at_curves + size, bits_of(0), LENGTH, "the size 0 of a shape");
    BAD_NUMBER(sphere, 10, SYNTAX, "the kind of a shape 10, expected 0 to 9");
    BAD_NUMBER(sphere, 5, SYNTAX, "the curve of a shape -1, expected 0 to 0");
    BAD_NUMBER(sphere, 7, SYNTAX, "the basis of a shape -1, expected 0 to 0");
    BAD_NUMBER(sphere, 4, LENGTH, "the size 0 of a shape");
    BAD_NUMBER(sphere + 32, 4, SYNTAX, "flags of a shape 0x4");
    BAD_NUMBER(sphere + place_of_surface + 216, bits_of(-1), LENGTH, "the size -1 of a shape");
    BAD_NUMBER(sphere + place_of_surface + 144, bits_of(1), DIRECTION, "what rounding left out");
}

/* Models of one machine are those of another: these bytes are written everywhere. */
static void same_on_every_machine(void) {
    nurbs_model *model = two_sides();
    const Bytes made = bytes_of(model);
    CHECK(number_from(made.data + 24, 8) == UINT64_C(0x8282d23a995019fd));
    nurbs_model_destroy(model);
}

int main(void) {
    bytes_and_back();
    layout();
    buffers();
    refused_bytes();
    numbers_of_no_model();
    numbers_of_no_shape();
    same_on_every_machine();
    return check_summary("model_bytes");
}
