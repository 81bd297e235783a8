/* SPDX-License-Identifier: MIT */
/* Models: of faces that share edges, and of a STEP file; what they hold is given back. */
#include "models.h"

static void counts_are(const nurbs_model *model, int64_t faces, int64_t edges, int64_t vertices) {
    int64_t found[5] = {-1, -1, -1, -1, -1};
    CHECK_OK(nurbs_model_counts(model, &found[0], &found[1], &found[2], &found[3], &found[4]));
    CHECK_INT(found[0], 1);
    CHECK_INT(found[1], 1);
    CHECK_INT(found[2], faces);
    CHECK_INT(found[3], edges);
    CHECK_INT(found[4], vertices);
    CHECK_OK(nurbs_model_counts(model, NULL, NULL, NULL, NULL, NULL));
}

static void name_is(const nurbs_model *model, int64_t index, const char *expected) {
    char name[8] = "";
    int64_t length = -1;
    CHECK_OK(nurbs_model_face_name(model, index, name, (int64_t)sizeof name, &length));
    CHECK(strcmp(name, expected) == 0);
    CHECK_INT(length, (int64_t)strlen(expected));
    CHECK_OK(nurbs_model_face_name(model, index, NULL, 0, &length));
    CHECK_INT(length, (int64_t)strlen(expected));
    CHECK_OK(nurbs_model_face_name(model, index, name, 2, NULL));
    CHECK(name[0] == expected[0] && name[1] == '\0');
}

/* From a corner to one that comes after it, along the axis of its key. */
static void edge_joins_its_vertices(const nurbs_model *model, int64_t index) {
    nurbs *edge = NULL;
    int64_t part = -1, ends[2] = {-1, -1};
    int32_t shape = -1;
    CHECK_OK(nurbs_model_edge(model, index, &part, ends, &shape, &edge));
    CHECK_INT(part, 0);
    CHECK_INT(shape, NURBS_SHAPE_NONE);
    double points[6], places[6];
    CHECK_OK(nurbs_points(edge, 2, points, 0, 0));
    CHECK_OK(nurbs_model_vertex(model, ends[0], places));
    CHECK_OK(nurbs_model_vertex(model, ends[1], places + 3));
    CHECK_BITS(points, places, sizeof points);
    nurbs_destroy(edge);
}

/* Once in each of two faces, along the one and against the other, as the normals of all point outwards. */
static void edge_is_used_twice(const nurbs_model *model, int64_t index) {
    int64_t count = -1, places[2][3], keys[2] = {0, 0};
    CHECK_OK(nurbs_model_edge_uses(model, index, 0, NULL, &count));
    CHECK_INT(count, 2);
    CHECK_OK(nurbs_model_edge_uses(model, index, 2, places[0], NULL));
    CHECK(places[0][0] < places[1][0]);
    for (int i = 0; i < 2; ++i) {
        nurbs_face *face = NULL;
        nurbs *edges[2] = {NULL, NULL};
        CHECK_OK(nurbs_model_face(model, places[i][0], NULL, NULL, NULL, NULL, &face));
        CHECK_OK(nurbs_face_edge(face, places[i][1], places[i][2], &keys[i], &edges[0]));
        CHECK_OK(nurbs_model_edge(model, index, NULL, NULL, NULL, &edges[1]));
        double points[2][6];
        CHECK_OK(nurbs_points(edges[0], 2, points[0], 0, 0));
        CHECK_OK(nurbs_points(edges[1], 2, points[1], 0, 0));
        CHECK_BITS(points[0], points[1], sizeof points[0]);
        nurbs_destroy(edges[0]);
        nurbs_destroy(edges[1]);
        nurbs_face_destroy(face);
    }
    CHECK(keys[0] != 0 && keys[0] == -keys[1]);
}

static void faces_of_a_box(void) {
    static const double areas[] = {2, 2, 3, 3, 6, 6};
    nurbs_model *model = box(), *clone = NULL;
    counts_are(model, 6, 12, 8);
    CHECK_OK(nurbs_model_clone(model, &clone));
    nurbs_model_destroy(model);
    for (int64_t i = 0; i < 6; ++i) {
        int64_t part = -1;
        int32_t shape = -1, against = -1;
        double colour[3] = {0, 0, 0}, area = 0;
        nurbs_face *face = NULL;
        CHECK_OK(nurbs_model_face(clone, i, &part, &shape, &against, colour, &face));
        CHECK_INT(part, 0);
        CHECK_INT(shape, NURBS_SHAPE_NONE);
        CHECK_INT(against, 0);
        CHECK_DOUBLES(colour, VALUES(NAN, NAN, NAN), 3);
        CHECK_OK(nurbs_face_area(face, 1e-12, &area, NULL));
        CHECK_NEAR(&area, areas + i, 1, 6e-12);
        name_is(clone, i, ((const char *[]){"0", "1", "2", "3", "4", "5"})[i]);
        nurbs_face_destroy(face);
    }
    for (int64_t i = 0; i < 12; ++i) {
        edge_joins_its_vertices(clone, i);
        edge_is_used_twice(clone, i);
    }
    nurbs_model_destroy(clone);
    nurbs_model_destroy(NULL);
}

/* What was given is what comes back, bit for bit. */
static void faces_come_back(void) {
    nurbs_face *faces[6], *same = NULL;
    box_faces(faces);
    nurbs_model *model = box();
    for (int i = 0; i < 6; ++i) {
        CHECK_OK(nurbs_model_face(model, i, NULL, NULL, NULL, NULL, &same));
        for (int64_t k = 0; k < 4; ++k) {
            nurbs *curves[2] = {NULL, NULL};
            double points[2][4];
            for (int j = 0; j < 2; ++j) {
                CHECK_OK(nurbs_face_curve(j == 0 ? faces[i] : same, 0, k, &curves[j]));
                CHECK_OK(nurbs_points(curves[j], 2, points[j], 0, 0));
                nurbs_destroy(curves[j]);
            }
            CHECK_BITS(points[0], points[1], sizeof points[0]);
        }
        nurbs_face_destroy(same);
        nurbs_face_destroy(faces[i]);
    }
    nurbs_model_destroy(model);
}

static void one_part(void) {
    nurbs_model *model = box();
    char name[4] = "no";
    int64_t length = -1, parent = 7, part = 7;
    double placement[12];
    CHECK_OK(nurbs_model_part(model, 0, name, (int64_t)sizeof name, &length));
    CHECK(name[0] == '\0' && length == 0);
    CHECK_OK(nurbs_model_use(model, 0, &parent, &part, placement));
    CHECK_INT(parent, -1);
    CHECK_INT(part, 0);
    CHECK_DOUBLES(placement, VALUES(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0), 12);
    CHECK_OK(nurbs_model_use(model, 0, NULL, NULL, NULL));
    nurbs_list *list = NULL;
    double metres = 0;
    CHECK_OK(nurbs_model_splines(model, &list));
    nurbs_model_destroy(model);
    CHECK_OK(nurbs_list_count(list, &length));
    CHECK_INT(length, 0);
    CHECK_OK(nurbs_list_unit(list, &metres));
    CHECK_DOUBLE(metres, 0.001);
    nurbs_list_destroy(list);
}

/* Without keys every face has edges of its own, whose ends meet all the same. */
static void edges_without_keys(void) {
    nurbs_face *frame = frame_face();
    const nurbs_face *faces[] = {frame, frame};
    nurbs_model *model = NULL;
    int64_t count = 0, places[3];
    CHECK_OK(nurbs_model_create(2, faces, 0, &model));
    nurbs_face_destroy(frame);
    counts_are(model, 2, 4, 2);
    for (int64_t i = 0; i < 4; ++i) {
        CHECK_OK(nurbs_model_edge_uses(model, i, 1, places, &count));
        CHECK_INT(count, 1);
        CHECK_INT(places[0], i / 2);
        CHECK_INT(places[1], i % 2);
        CHECK_INT(places[2], 0);
    }
    nurbs_model_destroy(model);
    CHECK_OK(nurbs_model_create(0, NULL, 0, &model));
    counts_are(model, 0, 0, 0);
    nurbs_model_destroy(model);
}

/* Keys that are equal by chance join no edges. */
static void equal_keys_of_other_edges(void) {
    nurbs *surface = plane(), *curves[] = {square(0.125, 0.875), square(0.25, 0.5)};
    nurbs_face *faces[2] = {NULL, NULL};
    for (int i = 0; i < 2; ++i) {
        CHECK_OK(nurbs_face_create(surface, 1, SIZES(1), CURVES(curves[i]), NULL, SIZES(7), 1e-6, 0, NULL,
                                   &faces[i]));
        nurbs_destroy(curves[i]);
    }
    nurbs_destroy(surface);
    const nurbs_face *given[] = {faces[0], faces[1], faces[0], faces[1]};
    nurbs_model *model = NULL;
    nurbs_list *list = NULL;
    int64_t count = 0;
    int32_t reason = 0;
    char text[200] = "";
    CHECK_OK(nurbs_model_create(4, given, 0, &model));
    nurbs_face_destroy(faces[0]);
    nurbs_face_destroy(faces[1]);
    counts_are(model, 4, 2, 2);
    for (int64_t i = 0; i < 2; ++i) {
        CHECK_OK(nurbs_model_edge_uses(model, i, 0, NULL, &count));
        CHECK_INT(count, 2);
    }
    CHECK_OK(nurbs_model_splines(model, &list));
    nurbs_model_destroy(model);
    CHECK_OK(nurbs_list_note_count(list, &count));
    CHECK_INT(count, 1);
    CHECK_OK(nurbs_list_note(list, 0, NULL, NULL, &reason, text, (int64_t)sizeof text, NULL));
    CHECK_INT(reason, NURBS_ERROR_GAP);
    const char *words = "curve 0 of loop 0 of face 1 has the key 7 of curve 0 of loop 0 of face 0 but is ";
    const char *place = strstr(text, words);
    CHECK(place != NULL);
    if (place != NULL) { /* of a place of the larger square; of its farthest corner hypot(0.75, 1.125) */
        const double apart = strtod(place + strlen(words), NULL);
        CHECK(apart > 1e-6 && apart <= 1.3522);
    }
    nurbs_list_destroy(list);
}

/* Of several edges with the key, the note is about the nearest one. */
static void equal_keys_of_near_edges(void) {
    nurbs *surface = plane(), *curves[] = {square(0.125, 0.875), square(0.25, 0.5), square(0.25, 0.501)};
    nurbs_face *faces[3] = {NULL, NULL, NULL};
    for (int i = 0; i < 3; ++i) {
        CHECK_OK(nurbs_face_create(surface, 1, SIZES(1), CURVES(curves[i]), NULL, SIZES(7), 1e-6, 0, NULL,
                                   &faces[i]));
        nurbs_destroy(curves[i]);
    }
    nurbs_destroy(surface);
    nurbs_model *model = NULL;
    nurbs_list *list = NULL;
    int64_t count = 0;
    char text[200] = "";
    CHECK_OK(nurbs_model_create(3, (const nurbs_face *const *)faces, 0, &model));
    for (int i = 0; i < 3; ++i) {
        nurbs_face_destroy(faces[i]);
    }
    CHECK_OK(nurbs_model_splines(model, &list));
    nurbs_model_destroy(model);
    CHECK_OK(nurbs_list_note_count(list, &count));
    CHECK_INT(count, 2);
    CHECK_OK(nurbs_list_note(list, 1, NULL, NULL, NULL, text, (int64_t)sizeof text, NULL));
    CHECK(strstr(text, "of face 2 has the key 7 of curve 0 of loop 0 of face 1 but is ") != NULL);
    nurbs_list_destroy(list);
}

/* In models of files the key is the index of the edge + 1. Both loops run along the circle, for the disk is against
 * its plane. */
static void keys_name_edges(const nurbs_model *model) {
    int64_t count = 0, places[2][3];
    CHECK_OK(nurbs_model_edge_uses(model, 0, 2, places[0], &count));
    CHECK_INT(count, 2);
    for (int i = 0; i < 2; ++i) {
        nurbs_face *face = NULL;
        nurbs *edge = NULL;
        int64_t key = 0;
        CHECK_OK(nurbs_model_face(model, places[i][0], NULL, NULL, NULL, NULL, &face));
        CHECK_OK(nurbs_face_edge(face, places[i][1], places[i][2], &key, &edge));
        CHECK_INT(key, 1);
        nurbs_destroy(edge);
        nurbs_face_destroy(face);
    }
}

/* Faces have the tolerance that is asked for, in the unit of the result. */
static void tolerances(void) {
    nurbs_read_options options;
    CHECK_OK(nurbs_read_options_init(&options, (int64_t)sizeof options));
    options.unit = 0.001;
    for (int i = 0; i < 2; ++i) {
        nurbs_model *model = NULL;
        nurbs_face *face = NULL;
        double tolerance = -1;
        options.tolerance = i == 0 ? 0 : 0.25;
        CHECK_OK(nurbs_read_model(half_ball, (int64_t)strlen(half_ball), &options, &model));
        CHECK_OK(nurbs_model_face(model, 1, NULL, NULL, NULL, NULL, &face));
        CHECK_OK(nurbs_face_tolerance(face, &tolerance));
        CHECK_DOUBLE(tolerance, i == 0 ? 1e-7 : 0.25);
        nurbs_face_destroy(face);
        nurbs_model_destroy(model);
    }
}

/* The same from memory and from a path, in the unit of the file and in another one. */
static void files(const char *path) {
    nurbs_read_options options;
    CHECK_OK(nurbs_read_options_init(&options, (int64_t)sizeof options));
    options.unit = 0.001;
    for (int i = 0; i < 3; ++i) {
        static const double pi = 3.14159265358979323846;
        nurbs_model *model = NULL;
        CHECK_OK(
            i < 2 ? nurbs_read_model(half_ball, (int64_t)strlen(half_ball), i == 0 ? NULL : &options, &model)
                  : nurbs_read_model_file(path, &options, &model));
        const double radius = i == 0 ? 1 : 10, areas[] = {pi * radius * radius, 2 * pi * radius * radius};
        const int32_t shapes[] = {NURBS_SHAPE_PLANE, NURBS_SHAPE_SPHERE}, against[] = {1, 0};
        counts_are(model, 2, 1, 1);
        name_is(model, 0, "disk");
        name_is(model, 1, "#18");
        for (int64_t f = 0; f < 2; ++f) {
            nurbs_face *face = NULL;
            int32_t shape = -1, turned = -1;
            double area = 0;
            CHECK_OK(nurbs_model_face(model, f, NULL, &shape, &turned, NULL, &face));
            CHECK_INT(shape, shapes[f]);
            CHECK_INT(turned, against[f]);
            CHECK_OK(nurbs_face_area(face, 1e-12, &area, NULL));
            CHECK_NEAR(&area, areas + f, 1, 1e-10 * areas[f]);
            nurbs_face_destroy(face);
        }
        int64_t ends[2] = {-1, -1};
        int32_t shape = -1;
        nurbs *circle = NULL;
        double point[3];
        CHECK_OK(nurbs_model_edge(model, 0, NULL, ends, &shape, &circle));
        CHECK_INT(shape, NURBS_SHAPE_CIRCLE);
        CHECK_INT(ends[0], 0);
        CHECK_INT(ends[1], 0);
        CHECK_OK(nurbs_model_vertex(model, 0, point));
        CHECK_DOUBLES(point, VALUES(radius, 0, 0), 3);
        nurbs_destroy(circle);
        keys_name_edges(model);
        nurbs_model_destroy(model);
    }
}

static int64_t layers_of(const nurbs_model *model, int64_t face, int64_t spline, int64_t *layers) {
    int64_t count = -1, same = -1;
    if (face >= 0) {
        CHECK_OK(nurbs_model_face_layers(model, face, 0, NULL, &count));
        CHECK_OK(nurbs_model_face_layers(model, face, layers == NULL ? 0 : 2, layers, &same));
    } else {
        CHECK_OK(nurbs_model_spline_layers(model, spline, 0, NULL, &count));
        CHECK_OK(nurbs_model_spline_layers(model, spline, 2, layers, &same));
    }
    CHECK_INT(same, count);
    return count;
}

static void layer_is(const nurbs_model *model, int64_t index, const char *expected) {
    char name[16] = "";
    int64_t length = -1;
    CHECK_OK(nurbs_model_layer(model, index, name, (int64_t)sizeof name, &length));
    CHECK(strcmp(name, expected) == 0);
    CHECK_INT(length, (int64_t)strlen(expected));
}

static const char layered[] =
    HALF_BALL_START "#30=POLYLINE('',(#1,#5));\n#31=PRESENTATION_LAYER_ASSIGNMENT('void','',(#21));\n"
                    "#32=PRESENTATION_LAYER_ASSIGNMENT('all','',(#20,#30));\n"
                    "#33=PRESENTATION_LAYER_ASSIGNMENT('disks','',(#14));\n" STEP_END;

/* Of a solid for all of its faces, and through both formats. */
static void layers_and_solids(void) {
    static char text[65536];
    nurbs_model *model = NULL;
    CHECK_OK(nurbs_read_model(layered, (int64_t)sizeof layered - 1, NULL, &model));
    for (int32_t format = 0; format <= NURBS_FORMAT_IGES; ++format) {
        if (format > 0) {
            int64_t size = 0;
            CHECK_OK(nurbs_model_write(model, format, NULL, (int64_t)sizeof text, text, &size));
            nurbs_model_destroy(model);
            CHECK_OK(nurbs_read_model(text, size, NULL, &model));
        }
        int64_t count = -1, layers[2] = {-1, -1}, solid = -2;
        int32_t in_void = -1;
        CHECK_OK(nurbs_model_layer_count(model, &count));
        CHECK_INT(count, 2);
        layer_is(model, 0, "all");
        layer_is(model, 1, "disks");
        CHECK_INT(layers_of(model, 0, -1, layers), 2);
        CHECK(layers[0] == 0 && layers[1] == 1);
        CHECK_FAILS(nurbs_model_face_layers(model, 0, 1, layers, NULL), NURBS_ERROR_SIZE, "cap = 1|2");
        CHECK_FAILS(nurbs_model_face_layers(model, 0, 2, layers, layers + 1), NURBS_ERROR_OVERLAP,
                    "layers|count");
        CHECK_INT(layers_of(model, 1, -1, layers), 1);
        CHECK_INT(layers[0], 0);
        CHECK_INT(layers_of(model, -1, 0, layers), 1);
        CHECK_INT(layers[0], 0);
        for (int64_t face = 0; face < 2; ++face) {
            CHECK_OK(nurbs_model_face_solid(model, face, &solid, &in_void));
            CHECK_INT(solid, 0);
            CHECK_INT(in_void, 0);
        }
    }
    nurbs_model_destroy(model);
    model = box();
    int64_t solid = -2;
    CHECK_OK(nurbs_model_face_solid(model, 0, &solid, NULL));
    CHECK_INT(solid, -1);
    CHECK_INT(layers_of(model, 0, -1, NULL), 0);
    nurbs_model_destroy(model);
}

int main(void) {
    static const char path[] = "model_test.step";
    FILE *file = fopen(path, "wb");
    CHECK(file != NULL && fwrite(half_ball, 1, strlen(half_ball), file) == strlen(half_ball));
    if (file != NULL) {
        (void)fclose(file);
    }
    faces_of_a_box();
    faces_come_back();
    one_part();
    edges_without_keys();
    equal_keys_of_other_edges();
    equal_keys_of_near_edges();
    tolerances();
    files(path);
    (void)remove(path);
    layers_and_solids();
    return check_summary("model");
}
