/* SPDX-License-Identifier: MIT */
/* Distances of faces, and nearest points of models. */
#include "models.h"

/* Of the box the faces at z = 0 and at z = 3. */
static void bottom_and_top(nurbs_face **out) {
    nurbs_face *faces[6];
    box_faces(faces);
    for (int i = 2; i < 6; ++i) {
        nurbs_face_destroy(faces[i]);
    }
    out[0] = faces[0];
    out[1] = faces[1];
}

static void smallest(void) {
    nurbs_face *faces[2];
    bottom_and_top(faces);
    double low = -1, high = -1, a[2] = {-1, -1}, b[2] = {-1, -1};
    int32_t status = -1;
    CHECK_OK(nurbs_face_distance(faces[0], faces[1], 1e-9, &low, &high, a, b, &status));
    CHECK_NEAR(&high, VALUES(3), 1, 1e-9);
    CHECK(low <= high && low >= 3 - 1e-8);
    CHECK_INT(status, NURBS_CLOSEST_CERTIFIED);
    CHECK(a[0] >= 0 && a[0] <= 1 && b[1] >= 0 && b[1] <= 1);
    CHECK_OK(nurbs_face_distance(faces[0], faces[0], 0, &low, &high, NULL, NULL, NULL));
    CHECK(low == 0 && high <= 1e-15);
    CHECK_OK(nurbs_face_distance(faces[0], faces[1], 0, NULL, NULL, NULL, NULL, NULL));
    nurbs_call_options call;
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    call.work = 1;
    CHECK_OK(nurbs_face_distance_with(faces[0], faces[1], 1e-9, &low, &high, a, b, &status, &call));
    CHECK(low <= high && high >= 3 - 1e-12);
    CHECK_OK(nurbs_face_distance_with(faces[0], faces[1], 1e-9, &low, &high, a, b, &status, NULL));
    CHECK_INT(status, NURBS_CLOSEST_CERTIFIED);
    nurbs_face_destroy(faces[0]);
    nurbs_face_destroy(faces[1]);
}

static void largest(void) {
    nurbs_face *faces[2];
    bottom_and_top(faces);
    double low[2] = {-1, -1}, high[2] = {-1, -1}, a[2] = {-1, -1}, b[2] = {-1, -1};
    int32_t status = -1;
    CHECK_OK(nurbs_face_hausdorff_distance(faces[0], faces[1], 1e-3, low, high, a, b, &status));
    CHECK_NEAR(high, VALUES(3, 3), 2, 1e-3);
    CHECK(low[0] <= high[0] && low[1] <= high[1]);
    CHECK_INT(status, NURBS_CLOSEST_CERTIFIED);
    CHECK_OK(nurbs_face_hausdorff_distance(faces[0], faces[0], 0, low, high, NULL, NULL, NULL));
    CHECK_DOUBLES(high, VALUES(0, 0), 2);
    CHECK_OK(nurbs_face_hausdorff_distance(faces[0], faces[1], 1, NULL, NULL, NULL, NULL, NULL));
    nurbs_call_options call;
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    call.work = 1;
    CHECK_OK(nurbs_face_hausdorff_distance_with(faces[0], faces[1], 1e-3, low, high, a, b, &status, &call));
    CHECK(low[0] <= 3 + 1e-12 && high[0] >= 3 - 1e-12);
    CHECK_OK(nurbs_face_hausdorff_distance_with(faces[0], faces[1], 1, low, high, a, b, &status, NULL));
    nurbs_face_destroy(faces[0]);
    nurbs_face_destroy(faces[1]);
}

/* Corners of another dimension. */
static nurbs_face *in_the_plane(void) {
    nurbs *surface = NULL;
    CHECK_OK(nurbs_surface_plane(2, VALUES(0, 0), VALUES(1, 0), VALUES(0, 1), &surface));
    nurbs_face *face = NULL;
    CHECK_OK(nurbs_face_create(surface, 0, NULL, NULL, NULL, NULL, 1e-9, 0, NULL, &face));
    nurbs_destroy(surface);
    return face;
}

static void refused_distances(void) {
    nurbs_face *faces[2], *flat = in_the_plane();
    bottom_and_top(faces);
    double low[2], high[2], a[2], b[2];
    int32_t status[1];
    FILL(low);
    FILL(high);
    FILL(a);
    FILL(b);
    FILL(status);
    CHECK_FAILS(nurbs_face_distance(NULL, faces[1], 0, low, high, a, b, status), NURBS_ERROR_NULL,
                "a is NULL");
    CHECK_FAILS(nurbs_face_distance(faces[0], NULL, 0, low, high, a, b, status), NURBS_ERROR_NULL,
                "b is NULL");
    CHECK_FAILS(nurbs_face_distance(faces[0], faces[1], -1, low, high, a, b, status), NURBS_ERROR_TOLERANCE,
                "tolerance");
    CHECK_FAILS(nurbs_face_distance(faces[0], faces[1], 0, low, low, a, b, status), NURBS_ERROR_OVERLAP,
                "at_least|at_most");
    CHECK_FAILS(nurbs_face_distance(faces[0], flat, 0, low, high, a, b, status), NURBS_ERROR_INCOMPATIBLE,
                "dimension");
    CHECK_FAILS(nurbs_face_hausdorff_distance(NULL, faces[1], 0, low, high, a, b, status), NURBS_ERROR_NULL,
                "a is NULL");
    CHECK_FAILS(nurbs_face_hausdorff_distance(faces[0], NULL, 0, low, high, a, b, status), NURBS_ERROR_NULL,
                "b is NULL");
    CHECK_FAILS(nurbs_face_hausdorff_distance(faces[0], faces[1], NAN, low, high, a, b, status),
                NURBS_ERROR_TOLERANCE, "tolerance");
    CHECK_FAILS(nurbs_face_hausdorff_distance(faces[0], faces[1], 0, low, high, a, a + 1, status),
                NURBS_ERROR_OVERLAP, "params_a|params_b");
    CHECK_FAILS(nurbs_face_hausdorff_distance(flat, faces[1], 0, low, high, a, b, status),
                NURBS_ERROR_INCOMPATIBLE, "dimension");
    CHECK_UNTOUCHED(low);
    CHECK_UNTOUCHED(high);
    CHECK_UNTOUCHED(a);
    CHECK_UNTOUCHED(b);
    CHECK_UNTOUCHED(status);
    nurbs_face_destroy(faces[0]);
    nurbs_face_destroy(faces[1]);
    nurbs_face_destroy(flat);
}

/* Inside, over a face, beside an edge. */
static void of_a_model(void) {
    nurbs_model *model = box();
    const double from[] = {0.5, 0.75, 0.25, 0.5, 1, 5, 4, 1, 7};
    double uv[6], feet[9], distances[3];
    int32_t status[3];
    int64_t places[6];
    CHECK_OK(nurbs_model_closest_points(model, 3, from, 0, 0, 1e-9, uv, feet, distances, status, places));
    CHECK_NEAR(distances, VALUES(0.25, 2, 5), 3, 2e-9);
    CHECK_NEAR(feet, VALUES(0.5, 0.75, 0, 0.5, 1, 3, 1, 1, 3), 9, 1e-4);
    CHECK_INT(status[0], NURBS_CLOSEST_CERTIFIED);
    CHECK_INT(status[1], NURBS_CLOSEST_CERTIFIED);
    CHECK(status[2] & NURBS_CLOSEST_CERTIFIED);
    CHECK(places[0] == 0 && places[1] == 0 && places[2] == 1);
    const double apart[] = {0.5, 1, 0, 5};
    CHECK_OK(nurbs_model_closest_points(model, 1, apart, 0, 1, 1e-9, NULL, NULL, distances, NULL, NULL));
    CHECK_OK(nurbs_model_closest_points(model, 0, NULL, 0, 0, 0, NULL, NULL, NULL, NULL, NULL));
    nurbs_call_options call;
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    CHECK_OK(nurbs_model_closest_points_with(model, 3, from, 0, 0, 1e-9, uv, feet, distances, status, places,
                                             &call));
    CHECK_INT(status[1], NURBS_CLOSEST_CERTIFIED);
    call.work = 1;
    CHECK_OK(nurbs_model_closest_points_with(model, 3, from, 0, 0, 1e-9, uv, feet, distances, status, places,
                                             &call));
    CHECK_INT(status[2] & NURBS_CLOSEST_CERTIFIED, 0);
    nurbs_model_destroy(model);
    CHECK_OK(nurbs_model_create(0, NULL, 1, &model));
    CHECK_OK(nurbs_model_closest_points(model, 1, from, 0, 0, 0, uv, feet, distances, status, places));
    CHECK(isinf(distances[0]) && isnan(uv[0]) && isnan(feet[0]));
    CHECK_INT(status[0], NURBS_CLOSEST_CERTIFIED);
    CHECK(places[0] == -1 && places[1] == -1);
    nurbs_model_destroy(model);
}

static void refused_of_a_model(void) {
    nurbs_model *model = box();
    double from[] = {0.5, 0.25, 3, 1, 1, NAN}, uv[4], feet[6], t[2];
    int32_t status[2];
    int64_t places[4];
    FILL(uv);
    FILL(feet);
    FILL(t);
    FILL(status);
    FILL(places);
    CHECK_FAILS(nurbs_model_closest_points(NULL, 1, from, 0, 0, 0, uv, feet, t, status, places),
                NURBS_ERROR_NULL, "model is NULL");
    CHECK_FAILS(nurbs_model_closest_points(model, -1, from, 0, 0, 0, uv, feet, t, status, places),
                NURBS_ERROR_COUNT, "n = -1");
    CHECK_FAILS(nurbs_model_closest_points(model, 1, NULL, 0, 0, 0, uv, feet, t, status, places),
                NURBS_ERROR_NULL, "points");
    CHECK_FAILS(nurbs_model_closest_points(model, 2, from, 1, 0, 0, uv, feet, t, status, places),
                NURBS_ERROR_STRIDE, "point");
    CHECK_FAILS(nurbs_model_closest_points(model, 1, from, 0, 0, -1, uv, feet, t, status, places),
                NURBS_ERROR_TOLERANCE, "tolerance");
    CHECK_FAILS(nurbs_model_closest_points(model, 2, from, 0, 0, 0, uv, feet, t, status, places),
                NURBS_ERROR_POINT_NOT_FINITE, "points[1][2]");
    CHECK_FAILS(nurbs_model_closest_points(model, 1, from, 0, 0, 0, uv, feet, feet + 1, status, places),
                NURBS_ERROR_OVERLAP, "distances|feet");
    CHECK_UNTOUCHED(uv);
    CHECK_UNTOUCHED(feet);
    CHECK_UNTOUCHED(t);
    CHECK_UNTOUCHED(status);
    CHECK_UNTOUCHED(places);
    nurbs_model_destroy(model);
}

int main(void) {
    smallest();
    largest();
    refused_distances();
    of_a_model();
    refused_of_a_model();
    return check_summary("face_distance");
}
