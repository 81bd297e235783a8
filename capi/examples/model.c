/* SPDX-License-Identifier: MIT */
/* Opens a STEP or IGES file, lists its faces with their areas, takes the first one apart, and writes a copy in
 * inches as IGES.
 * model.py does the same.
 * Compile: cc -std=c99 model.c $(pkg-config --cflags --libs nurbs) -o model */
#include <nurbs/nurbs.h>

#include <stdio.h>
#include <stdlib.h>

enum { NAME = 64, MOST = 64 };

static void check(nurbs_status status) {
    char message[512];
    if (status != NURBS_OK) {
        nurbs_last_error(message, (int64_t)sizeof message);
        fprintf(stderr, "model: %s: %s\n", nurbs_status_name(status), message);
        exit(EXIT_FAILURE);
    }
}

static nurbs_face *face_of(const nurbs_model *model, int64_t index) {
    nurbs_face *face = NULL;
    check(nurbs_model_face(model, index, NULL, NULL, NULL, NULL, &face));
    return face;
}

static void list_faces(const nurbs_model *model, int64_t count) {
    char name[NAME];
    int64_t i;
    for (i = 0; i < count; ++i) {
        nurbs_face *face = face_of(model, i);
        double area = 0;
        check(nurbs_model_face_name(model, i, name, NAME, NULL));
        check(nurbs_face_area(face, 1e-9, &area, NULL));
        printf("%s: area %.6f\n", name, area);
        nurbs_face_destroy(face);
    }
}

/* The faces that meet at an edge; a seam is twice in one of them. */
static void print_users(const nurbs_model *model, int64_t edge) {
    int64_t places[MOST][3], count = 0, i;
    char name[NAME];
    check(nurbs_model_edge_uses(model, edge, MOST, places[0], &count)); /* more would be an error */
    for (i = 0; i < count; ++i) {
        check(nurbs_model_face_name(model, places[i][0], name, NAME, NULL));
        printf("%s%s", i == 0 ? ", of " : " and ", name);
    }
    printf("\n");
}

static void print_edge(const nurbs_model *model, const nurbs_face *face, int64_t loop, int64_t index) {
    nurbs *curve = NULL;
    int64_t key = 0; /* the index of the edge + 1, negative if the loop runs against it */
    double length = 0;
    check(nurbs_face_edge(face, loop, index, &key, &curve));
    check(nurbs_curve_length(curve, NULL, 1e-9, &length, NULL));
    printf("loop %d, edge %d: length %.6f", (int)loop, (int)llabs(key), length);
    print_users(model, llabs(key) - 1);
    nurbs_destroy(curve);
}

static void take_apart(const nurbs_model *model, const nurbs_face *face) {
    int64_t sizes[MOST], loops = 0, loop, i;
    check(nurbs_face_loops(face, MOST, sizes, &loops));
    for (loop = 0; loop < loops; ++loop) {
        for (i = 0; i < sizes[loop]; ++i) {
            print_edge(model, face, loop, i);
        }
    }
}

static void write_copy(const nurbs_model *model, const char *path) {
    nurbs_write_options options;
    check(nurbs_write_options_init(&options, (int64_t)sizeof options));
    options.unit = 0.0254;
    check(nurbs_model_write_file(model, path, NURBS_FORMAT_IGES, &options));
}

int main(int argc, char **argv) {
    nurbs_model *model = NULL;
    nurbs_face *first;
    int64_t faces = 0, edges = 0, vertices = 0;
    if (argc != 2 && argc != 3) {
        fprintf(stderr, "usage: model FILE.step [COPY.igs]\n");
        return 2;
    }
    check(nurbs_read_model_file(argv[1], NULL, &model));
    check(nurbs_model_counts(model, NULL, NULL, &faces, &edges, &vertices));
    printf("%d faces, %d edges, %d vertices\n", (int)faces, (int)edges, (int)vertices);
    list_faces(model, faces);
    first = face_of(model, 0);
    take_apart(model, first);
    nurbs_face_destroy(first);
    if (argc == 3) {
        write_copy(model, argv[2]);
    }
    nurbs_model_destroy(model);
    return 0;
}
