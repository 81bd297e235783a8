/* SPDX-License-Identifier: MIT */
/* Models that cannot be, and questions that cannot be asked of them: each refused by its name. */
#include "models.h"

#include <stddef.h>

static nurbs_model *model_, *out_;
static nurbs_face *face_;
static nurbs *spline_;
static char buf_[8];

#define BYTES half_ball, (int64_t)(sizeof half_ball - 1)

static void missing_arguments(void) {
    CHECK_FAILS(nurbs_read_model(BYTES, NULL, NULL), NURBS_ERROR_NULL, "out");
    CHECK_FAILS(nurbs_read_model_file("a", NULL, NULL), NURBS_ERROR_NULL, "out");
    CHECK_FAILS(nurbs_read_model_with(BYTES, NULL, NULL, NULL), NURBS_ERROR_NULL, "out");
    CHECK_FAILS(nurbs_read_model_file_with("a", NULL, NULL, NULL), NURBS_ERROR_NULL, "out");
    CHECK_FAILS(nurbs_model_create(0, NULL, 0, NULL), NURBS_ERROR_NULL, "out");
    CHECK_FAILS(nurbs_model_clone(model_, NULL), NURBS_ERROR_NULL, "out");
    CHECK_FAILS(nurbs_model_face(model_, 99, NULL, NULL, NULL, NULL, NULL), NURBS_ERROR_NULL, "out");
    CHECK_FAILS(nurbs_model_edge(model_, 99, NULL, NULL, NULL, NULL), NURBS_ERROR_NULL, "out");
    CHECK_FAILS(nurbs_model_splines(model_, NULL), NURBS_ERROR_NULL, "out");
    CHECK_FAILS(nurbs_model_vertex(model_, 99, NULL), NURBS_ERROR_NULL, "point");
    CHECK_FAILS(nurbs_model_edge_uses(model_, 99, 1, NULL, NULL), NURBS_ERROR_NULL, "places");
    CHECK_FAILS(nurbs_model_face_layers(model_, 99, 1, NULL, NULL), NURBS_ERROR_NULL, "layers");
    CHECK_FAILS(nurbs_model_spline_layers(model_, 99, 1, NULL, NULL), NURBS_ERROR_NULL, "layers");
    CHECK_FAILS(nurbs_model_layer_count(model_, NULL), NURBS_ERROR_NULL, "count");
    CHECK_NO_MODEL(out_, nurbs_read_model(NULL, 5, NULL, &out_), NURBS_ERROR_NULL, "bytes");
    CHECK_NO_MODEL(out_, nurbs_read_model_file(NULL, NULL, &out_), NURBS_ERROR_NULL, "path");
    CHECK_NO_MODEL(out_, nurbs_model_create(1, NULL, NAN, &out_), NURBS_ERROR_NULL, "faces");
    const nurbs_face *faces[] = {face_, NULL};
    CHECK_NO_MODEL(out_, nurbs_model_create(2, faces, 1, &out_), NURBS_ERROR_NULL, "faces[1]");
}

/* Instead of a model. */
static void missing_models(void) {
    double values[12];
    int64_t counts[4];
    nurbs_list *list = NULL;
    CHECK_NO_MODEL(out_, nurbs_model_clone(NULL, &out_), NURBS_ERROR_NULL, "model");
    CHECK_FAILS(nurbs_model_counts(NULL, counts, counts, NULL, NULL, NULL), NURBS_ERROR_NULL, "model");
    CHECK_FAILS(nurbs_model_face(NULL, 99, NULL, NULL, NULL, NULL, &face_), NURBS_ERROR_NULL, "model");
    CHECK(face_ == NULL);
    CHECK_FAILS(nurbs_model_face_name(NULL, 99, NULL, 5, NULL), NURBS_ERROR_NULL, "model");
    CHECK_FAILS(nurbs_model_edge(NULL, 99, NULL, NULL, NULL, &spline_), NURBS_ERROR_NULL, "model");
    CHECK_FAILS(nurbs_model_edge_uses(NULL, 99, -1, NULL, NULL), NURBS_ERROR_NULL, "model");
    CHECK_FAILS(nurbs_model_vertex(NULL, 99, values), NURBS_ERROR_NULL, "model");
    CHECK_FAILS(nurbs_model_part(NULL, 99, NULL, -1, NULL), NURBS_ERROR_NULL, "model");
    CHECK_FAILS(nurbs_model_layer(NULL, 99, NULL, -1, NULL), NURBS_ERROR_NULL, "model");
    CHECK_FAILS(nurbs_model_layer_count(NULL, NULL), NURBS_ERROR_NULL, "model");
    CHECK_FAILS(nurbs_model_face_solid(NULL, 99, counts, NULL), NURBS_ERROR_NULL, "model");
    CHECK_FAILS(nurbs_model_face_layers(NULL, 99, -1, NULL, NULL), NURBS_ERROR_NULL, "model");
    CHECK_FAILS(nurbs_model_spline_layers(NULL, 99, -1, NULL, NULL), NURBS_ERROR_NULL, "model");
    CHECK_FAILS(nurbs_model_use(NULL, 99, counts, counts, values), NURBS_ERROR_NULL, "model");
    CHECK_FAILS(nurbs_model_splines(NULL, &list), NURBS_ERROR_NULL, "model");
    CHECK(list == NULL);
}

static void wrong_indices(void) {
    double values[12];
    int64_t places[6];
    const int64_t wrong[] = {-1, INT64_MIN, INT64_MAX, 12};
    for (int i = 0; i < 4; ++i) {
        const int64_t index = wrong[i];
        CHECK_FAILS(nurbs_model_face(model_, index, NULL, NULL, NULL, NULL, &face_), NURBS_ERROR_INDEX,
                    "index = |6 faces");
        CHECK(face_ == NULL);
        CHECK_FAILS(nurbs_model_face_name(model_, index, buf_, 8, NULL), NURBS_ERROR_INDEX,
                    "index = |6 faces");
        CHECK_FAILS(nurbs_model_edge(model_, index, NULL, NULL, NULL, &spline_), NURBS_ERROR_INDEX,
                    "index = |12 edges");
        CHECK_FAILS(nurbs_model_edge_uses(model_, index, 2, places, NULL), NURBS_ERROR_INDEX,
                    "index = |12 edges");
        CHECK_FAILS(nurbs_model_vertex(model_, index, values), NURBS_ERROR_INDEX, "index = |8 vertices");
        CHECK_FAILS(nurbs_model_face_solid(model_, index, places, NULL), NURBS_ERROR_INDEX,
                    "index = |6 faces");
        CHECK_FAILS(nurbs_model_face_layers(model_, index, 2, places, NULL), NURBS_ERROR_INDEX,
                    "index = |6 faces");
        CHECK_FAILS(nurbs_model_spline_layers(model_, index, 2, places, NULL), NURBS_ERROR_INDEX,
                    "index = |0 splines");
        CHECK_FAILS(nurbs_model_layer(model_, index, buf_, 8, NULL), NURBS_ERROR_INDEX, "index = |0 layers");
        CHECK_FAILS(nurbs_model_part(model_, index, buf_, 8, NULL), NURBS_ERROR_INDEX, "index = |1 parts");
        CHECK_FAILS(nurbs_model_use(model_, index, NULL, NULL, NULL), NURBS_ERROR_INDEX, "index = |1 uses");
    }
    CHECK_FAILS(nurbs_model_vertex(model_, 8, values), NURBS_ERROR_INDEX, "index = 8|8 vertices");
}

static void wrong_sizes(void) {
    int64_t places[6] = {7, 7, 7, 7, 7, 7};
    CHECK_FAILS(nurbs_model_edge_uses(model_, 0, -1, places, NULL), NURBS_ERROR_COUNT, "cap = -1");
    CHECK_FAILS(nurbs_model_face_layers(model_, 0, -1, places, NULL), NURBS_ERROR_COUNT, "cap = -1");
    CHECK_FAILS(nurbs_model_edge_uses(model_, 0, 1, places, NULL), NURBS_ERROR_SIZE, "cap = 1|2");
    CHECK_INT(places[0], 7);
    CHECK_FAILS(nurbs_model_face_name(model_, 0, buf_, -1, NULL), NURBS_ERROR_COUNT, "cap");
    CHECK_FAILS(nurbs_model_face_name(model_, 0, NULL, 8, NULL), NURBS_ERROR_NULL, "buf");
    CHECK_FAILS(nurbs_model_part(model_, 0, buf_, -1, NULL), NURBS_ERROR_COUNT, "cap");
    CHECK_FAILS(nurbs_model_part(model_, 0, NULL, 8, NULL), NURBS_ERROR_NULL, "buf");
    CHECK_NO_MODEL(out_, nurbs_model_create(-1, NULL, 0, &out_), NURBS_ERROR_COUNT, "count = -1");
    CHECK_NO_MODEL(out_, nurbs_model_create(INT64_MAX, NULL, 0, &out_), NURBS_ERROR_OVERFLOW, "faces");
    CHECK_NO_MODEL(out_, nurbs_read_model(half_ball, -1, NULL, &out_), NURBS_ERROR_COUNT, "size");
}

/* Two results in one place. */
static void overlapping_outputs(void) {
    int64_t n[6];
    int32_t k[2];
    double colour[12];
    CHECK_FAILS(nurbs_model_counts(model_, n, n, NULL, NULL, NULL), NURBS_ERROR_OVERLAP, "parts|uses");
    CHECK_FAILS(nurbs_model_counts(model_, NULL, NULL, n, n + 1, n), NURBS_ERROR_OVERLAP, "faces|vertices");
    CHECK_FAILS(nurbs_model_face(model_, 0, NULL, k, k, colour, &face_), NURBS_ERROR_OVERLAP,
                "shape|against");
    CHECK(face_ == NULL);
    CHECK_FAILS(nurbs_model_edge(model_, 0, n, n, k, &spline_), NURBS_ERROR_OVERLAP, "part|end_vertices");
    CHECK_FAILS(nurbs_model_edge_uses(model_, 0, 2, n, n + 5), NURBS_ERROR_OVERLAP, "places|count");
    CHECK_FAILS(nurbs_model_use(model_, 0, n, n, colour), NURBS_ERROR_OVERLAP, "parent|part");
    CHECK_FAILS(nurbs_model_face_solid(model_, 0, n, (int32_t *)n), NURBS_ERROR_OVERLAP, "solid|in_void");
}

static void wrong_faces_and_units(void) {
    nurbs_face *flat = NULL;
    nurbs *surface = NULL;
    CHECK_OK(nurbs_surface_plane(2, VALUES(0, 0), VALUES(1, 0), VALUES(0, 1), &surface));
    CHECK_OK(nurbs_face_create(surface, 0, NULL, NULL, NULL, NULL, 0, 0, NULL, &flat));
    const nurbs_face *faces[] = {face_, flat};
    CHECK_NO_MODEL(out_, nurbs_model_create(2, faces, 1, &out_), NURBS_ERROR_DIMENSION,
                   "faces[1]|dimension 2");
    const double units[] = {NAN, -1, INFINITY};
    for (int i = 0; i < 3; ++i) {
        CHECK_NO_MODEL(out_, nurbs_model_create(1, faces, units[i], &out_), NURBS_ERROR_FACTOR, "metres = ");
    }
    nurbs_face_destroy(flat);
    nurbs_destroy(surface);
}

static nurbs_status reading(const char *text) {
    return nurbs_read_model(text, (int64_t)strlen(text), NULL, &out_);
}

static int32_t go_on(double done, void *user) {
    (void)done;
    (void)user;
    return 0;
}

static void files(void) {
    static const char iges[] =
        "a file                                                                  S      1\n";
    static const char compressed[] =
        "                                                                        C      1\n";
    CHECK_NO_MODEL(out_, reading("solid"), NURBS_ERROR_FORMAT, "");
    CHECK_NO_MODEL(out_, reading(iges), NURBS_ERROR_TRUNCATED, "");
    CHECK_NO_MODEL(out_, reading(compressed), NURBS_ERROR_FORMAT, "compressed IGES file|faces are not read");
    CHECK_NO_MODEL(out_, reading(HALF_BALL_START), NURBS_ERROR_TRUNCATED, "before END-ISO-10303-21");
    CHECK_NO_MODEL(out_, reading(HALF_BALL_START "#99 PLANE();\n" STEP_END), NURBS_ERROR_SYNTAX,
                   "found PLANE");
    CHECK_NO_MODEL(out_, nurbs_read_model_file("no such file", NULL, &out_), NURBS_ERROR_FILE,
                   "no such file");
    nurbs_read_options options;
    CHECK_OK(nurbs_read_options_init(&options, (int64_t)sizeof options));
    options.max_bytes = 10;
    CHECK_NO_MODEL(out_, nurbs_read_model(BYTES, &options, &out_), NURBS_ERROR_TOO_LARGE, "10");
    options.max_bytes = 1000000;
    options.unit = -1;
    CHECK_NO_MODEL(out_, nurbs_read_model(BYTES, &options, &out_), NURBS_ERROR_OPTIONS, "unit");
    options.unit = 0;
    options.tolerance = -1;
    CHECK_NO_MODEL(out_, nurbs_read_model(BYTES, &options, &out_), NURBS_ERROR_OPTIONS, "tolerance = -1");
    options.tolerance = HUGE_VAL;
    CHECK_NO_MODEL(out_, nurbs_read_model(BYTES, &options, &out_), NURBS_ERROR_OPTIONS, "tolerance = inf");
    options.struct_size =
        (int64_t)offsetof(nurbs_read_options, tolerance); /* as programs of version 1.0 know it */
    CHECK_OK(nurbs_read_model(BYTES, &options, &out_));
    nurbs_model_destroy(out_);
    nurbs_call_options call;
    CHECK_OK(nurbs_call_options_init(&call, (int64_t)sizeof call));
    call.progress = go_on;
    CHECK_OK(nurbs_read_model_with(BYTES, NULL, &call, &out_));
    nurbs_model_destroy(out_);
    call.work = 1;
    CHECK_NO_MODEL(out_, nurbs_read_model_with(BYTES, NULL, &call, &out_), NURBS_ERROR_WORK, "");
    call.work = -1;
    CHECK_NO_MODEL(out_, nurbs_read_model_with(BYTES, NULL, &call, &out_), NURBS_ERROR_OPTIONS, "work");
}

int main(void) {
    model_ = box();
    CHECK_OK(nurbs_model_face(model_, 0, NULL, NULL, NULL, NULL, &face_));
    missing_arguments();
    wrong_faces_and_units();
    nurbs_face_destroy(face_);
    missing_models();
    wrong_indices();
    wrong_sizes();
    overlapping_outputs();
    files();
    nurbs_model_destroy(model_);
    return check_summary("model_refused");
}
