/* SPDX-License-Identifier: MIT */
/* Meshes for several distances in one call: their order, equal distances, and what is refused. */
#include "models.h"

static nurbs_mesh_options usual_options(void) {
    nurbs_mesh_options options;
    CHECK_OK(nurbs_mesh_options_init(&options, sizeof options));
    return options;
}

static int64_t triangles_of(const nurbs_mesh *mesh) {
    int64_t triangles = -1;
    CHECK_OK(nurbs_mesh_counts(mesh, NULL, NULL, &triangles, NULL, NULL, NULL));
    return triangles;
}

static double bound_of(const nurbs_mesh *mesh) {
    double from_shape = -1, from_mesh = -1;
    int32_t reached = -1;
    CHECK_OK(nurbs_mesh_bound(mesh, &from_shape, &from_mesh, &reached));
    CHECK_INT(reached, 1);
    return from_shape > from_mesh ? from_shape : from_mesh;
}

static void destroy_all(int count, nurbs_mesh **meshes) {
    for (int i = 0; i < count; ++i) {
        nurbs_mesh_destroy(meshes[i]);
    }
}

static nurbs *ball(void) {
    nurbs *g = NULL;
    CHECK_OK(nurbs_surface_sphere(NULL, NULL, NULL, 1, NURBS_ARC_QUARTERS, &g));
    return g;
}

static nurbs_face *whole_face(const nurbs *g) {
    nurbs_face *face = NULL;
    CHECK_OK(nurbs_face_create(g, 0, NULL, NULL, NULL, NULL, 1e-9, 0, NULL, &face));
    return face;
}

/* In the order of the distances, whatever that is. */
static void each_within_its_distance(void) {
    nurbs *g = ball();
    nurbs_face *face = whole_face(g);
    nurbs_model *model = NULL;
    CHECK_OK(nurbs_model_create(1, (const nurbs_face *const *)&face, 0, &model));
    const double chords[] = {0.01, 0.1, 0.001, 0.01};
    const nurbs_mesh_options options = usual_options();
    nurbs_mesh *meshes[12];
    CHECK_OK(nurbs_mesh_surface_levels(g, 4, chords, NULL, meshes));
    CHECK_OK(nurbs_mesh_face_levels(face, 4, chords, &options, meshes + 4));
    CHECK_OK(nurbs_mesh_model_levels(model, 4, chords, &options, meshes + 8));
    for (int i = 0; i < 12; ++i) {
        CHECK(bound_of(meshes[i]) <= chords[i % 4]);
        if (i % 4 == 0) {
            CHECK(triangles_of(meshes[i + 1]) < triangles_of(meshes[i]));
            CHECK(triangles_of(meshes[i]) < triangles_of(meshes[i + 2]));
            CHECK_INT(triangles_of(meshes[i + 3]), triangles_of(meshes[i]));
        }
    }
    destroy_all(12, meshes);
    nurbs_model_destroy(model);
    nurbs_face_destroy(face);
    nurbs_destroy(g);
}

/* Limits besides the distance hold for all; those of distances in the options are not looked at. */
static void other_limits(void) {
    nurbs *g = ball();
    nurbs_mesh_options options = usual_options();
    nurbs_mesh *meshes[2], *alone = NULL;
    options.chord = -1;
    options.relative_chord = NAN;
    options.longest = 0.5;
    CHECK_OK(nurbs_mesh_surface_levels(g, 2, VALUES(INFINITY, 1), &options, meshes));
    options.chord = INFINITY;
    options.relative_chord = 0;
    CHECK_OK(nurbs_mesh_surface(g, &options, &alone));
    CHECK_INT(triangles_of(meshes[0]), triangles_of(alone));
    CHECK(triangles_of(meshes[1]) >= triangles_of(alone));
    destroy_all(2, meshes);
    nurbs_mesh_destroy(alone);
    CHECK_OK(nurbs_mesh_surface_levels(g, 0, NULL, NULL, NULL)); /* none */
    nurbs_destroy(g);
}

#define CHECK_NO_MESHES(call, status, words)                                                                 \
    do {                                                                                                     \
        meshes[0] = meshes[1] = (nurbs_mesh *)(void *)check_poison();                                        \
        CHECK_FAILS(call, status, words);                                                                    \
        check_true(__FILE__, __LINE__, meshes[0] == NULL && meshes[1] == NULL, "no meshes");                 \
    } while (0)

static void wrong_distances(void) {
    nurbs *g = plane();
    nurbs_mesh_options options = usual_options();
    nurbs_mesh *meshes[2];
    CHECK_NO_MESHES(nurbs_mesh_surface_levels(g, 2, VALUES(1, 0), NULL, meshes), NURBS_ERROR_TOLERANCE,
                    "chords[1] = 0");
    CHECK_NO_MESHES(nurbs_mesh_surface_levels(g, 2, VALUES(NAN, 1), NULL, meshes), NURBS_ERROR_TOLERANCE,
                    "chords[0] = nan");
    CHECK_NO_MESHES(nurbs_mesh_surface_levels(g, 2, VALUES(1, INFINITY), NULL, meshes), NURBS_ERROR_TOLERANCE,
                    "chords[1] = inf");
    CHECK_NO_MESHES(nurbs_mesh_surface_levels(g, 2, NULL, NULL, meshes), NURBS_ERROR_NULL, "chords");
    options.longest = -1;
    CHECK_NO_MESHES(nurbs_mesh_surface_levels(g, 2, VALUES(1, 2), &options, meshes), NURBS_ERROR_LENGTH,
                    "longest");
    options.longest = 0;
    options.angle = 4;
    CHECK_NO_MESHES(nurbs_mesh_surface_levels(g, 2, VALUES(1, 2), &options, meshes), NURBS_ERROR_ANGLE,
                    "angle");
    options.struct_size = 8;
    CHECK_NO_MESHES(nurbs_mesh_surface_levels(g, 2, VALUES(1, 2), &options, meshes), NURBS_ERROR_OPTIONS,
                    "struct_size");
    CHECK_FAILS(nurbs_mesh_surface_levels(g, -1, VALUES(1), NULL, meshes), NURBS_ERROR_COUNT, "count = -1");
    CHECK_FAILS(nurbs_mesh_surface_levels(g, 1, VALUES(1), NULL, NULL), NURBS_ERROR_NULL, "out");
    nurbs_destroy(g);
}

static void wrong_shapes(void) {
    nurbs *curve = make(arch());
    nurbs_mesh *meshes[2];
    CHECK_NO_MESHES(nurbs_mesh_surface_levels(NULL, 2, VALUES(1, 2), NULL, meshes), NURBS_ERROR_NULL,
                    "g is NULL");
    CHECK_NO_MESHES(nurbs_mesh_surface_levels(curve, 2, VALUES(1, 2), NULL, meshes), NURBS_ERROR_AXES, "");
    CHECK_NO_MESHES(nurbs_mesh_face_levels(NULL, 2, VALUES(1, 2), NULL, meshes), NURBS_ERROR_NULL, "face");
    CHECK_NO_MESHES(nurbs_mesh_model_levels(NULL, 2, VALUES(1, 2), NULL, meshes), NURBS_ERROR_NULL, "model");
    CHECK_FAILS(nurbs_mesh_face_levels(NULL, -2, NULL, NULL, NULL), NURBS_ERROR_COUNT, "count");
    CHECK_FAILS(nurbs_mesh_model_levels(NULL, 1, NULL, NULL, NULL), NURBS_ERROR_NULL, "out");
    nurbs_destroy(curve);
}

static int32_t stop(double done, void *user) {
    (void)done;
    (void)user;
    return 1;
}

/* What is ended gives no mesh, also none of those that are done. */
static void watched(void) {
    nurbs *g = ball();
    nurbs_face *face = whole_face(g);
    nurbs_model *model = box();
    nurbs_mesh *meshes[2];
    nurbs_call_options call;
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    call.progress = stop;
    CHECK_NO_MESHES(nurbs_mesh_surface_levels_with(g, 2, VALUES(1, 1e-8), NULL, &call, meshes),
                    NURBS_ERROR_CANCELLED, "");
    CHECK_NO_MESHES(nurbs_mesh_face_levels_with(face, 2, VALUES(1, 1e-8), NULL, &call, meshes),
                    NURBS_ERROR_CANCELLED, "");
    call.work = -1;
    CHECK_NO_MESHES(nurbs_mesh_model_levels_with(model, 2, VALUES(1, 1e-8), NULL, &call, meshes),
                    NURBS_ERROR_OPTIONS, "work");
    CHECK_OK(nurbs_mesh_model_levels_with(model, 2, VALUES(0.1, 1), NULL, NULL, meshes));
    CHECK(bound_of(meshes[0]) < 1e-9 && bound_of(meshes[1]) < 1e-9);
    destroy_all(2, meshes);
    nurbs_model_destroy(model);
    nurbs_face_destroy(face);
    nurbs_destroy(g);
}

int main(void) {
    each_within_its_distance();
    other_limits();
    wrong_distances();
    wrong_shapes();
    watched();
    return check_summary("mesh levels");
}
