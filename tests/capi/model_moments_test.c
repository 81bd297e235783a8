/* SPDX-License-Identifier: MIT */
/* Areas and volumes of models. */
#include "models.h"

static void a_box(void) {
    nurbs_model *model = box();
    double area = 0, volume = 0, centroid[3], inertia[9], openness = -1, error = -1;
    CHECK_OK(nurbs_model_area(model, 1e-12, &area, &error));
    CHECK_NEAR(&area, VALUES(22), 1, 1e-13);
    CHECK(error >= 0 && error < 1e-10);
    CHECK_OK(nurbs_model_volume(model, 1e-12, &volume, centroid, inertia, &openness, &error));
    CHECK_NEAR(&volume, VALUES(6), 1, 1e-13);
    CHECK_NEAR(centroid, VALUES(0.5, 1, 1.5), 3, 1e-14);
    CHECK_NEAR(inertia, VALUES(6.5, 0, 0, 0, 5, 0, 0, 0, 2.5), 9, 1e-12);
    CHECK(openness >= 0 && openness < 1e-13 && error >= 0 && error < 1e-11);
    CHECK_OK(nurbs_model_volume(model, 0, &volume, NULL, NULL, NULL, NULL));
    CHECK_NEAR(&volume, VALUES(6), 1, 1e-13);
    nurbs_model_destroy(model);
}

static void watched(void) {
    nurbs_model *model = box();
    double area = 0, volume = 0, centroid[3];
    nurbs_call_options call;
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    CHECK_OK(nurbs_model_area_with(model, 1e-9, &area, NULL, &call));
    CHECK_OK(nurbs_model_volume_with(model, 1e-9, &volume, centroid, NULL, NULL, NULL, NULL));
    CHECK(fabs(area - 22) < 1e-12 && fabs(volume - 6) < 1e-12 && fabs(centroid[2] - 1.5) < 1e-12);
    call.work = 10;
    CHECK_FAILS(nurbs_model_area_with(model, 1e-9, &area, NULL, &call), NURBS_ERROR_WORK, "work");
    CHECK_FAILS(nurbs_model_volume_with(model, 1e-9, &volume, NULL, NULL, NULL, NULL, &call),
                NURBS_ERROR_WORK, "work");
    call.struct_size = 1;
    CHECK_FAILS(nurbs_model_area_with(model, 1e-9, &area, NULL, &call), NURBS_ERROR_OPTIONS, "struct_size");
    CHECK_FAILS(nurbs_model_volume_with(model, 1e-9, &volume, NULL, NULL, NULL, NULL, &call),
                NURBS_ERROR_OPTIONS, "struct_size");
    nurbs_model_destroy(model);
}

static void refused(void) {
    nurbs_face *faces[6];
    box_faces(faces);
    nurbs_model *model = box(), *open = NULL, *none = NULL;
    CHECK_OK(nurbs_model_create(5, (const nurbs_face *const *)faces, 1, &open));
    CHECK_OK(nurbs_model_create(0, NULL, 1, &none));
    double a[2], b[12], c[9];
    FILL(a);
    FILL(b);
    FILL(c);
    CHECK_FAILS(nurbs_model_area(NULL, NAN, NULL, NULL), NURBS_ERROR_NULL, "model is NULL");
    CHECK_FAILS(nurbs_model_area(model, NAN, NULL, NULL), NURBS_ERROR_NULL, "area");
    CHECK_FAILS(nurbs_model_area(model, 1, a, a), NURBS_ERROR_OVERLAP, "area|error");
    CHECK_FAILS(nurbs_model_volume(NULL, NAN, NULL, NULL, NULL, NULL, NULL), NURBS_ERROR_NULL,
                "model is NULL");
    CHECK_FAILS(nurbs_model_volume(model, NAN, NULL, NULL, NULL, NULL, NULL), NURBS_ERROR_NULL, "volume");
    CHECK_FAILS(nurbs_model_volume(model, 1, a, b, b + 2, NULL, NULL), NURBS_ERROR_OVERLAP,
                "centroid|inertia");
    CHECK_FAILS(nurbs_model_volume(model, 1, a, NULL, NULL, a, NULL), NURBS_ERROR_OVERLAP, "volume|openness");
    const double bad[] = {-1, NAN};
    for (int i = 0; i < 2; ++i) {
        CHECK_FAILS(nurbs_model_area(model, bad[i], a, b), NURBS_ERROR_TOLERANCE, "relative_tolerance");
        CHECK_FAILS(nurbs_model_volume(model, bad[i], a, b, c, NULL, NULL), NURBS_ERROR_TOLERANCE,
                    "relative_tolerance");
    }
    CHECK_FAILS(nurbs_model_volume(open, 1e-9, a, b, c, NULL, NULL), NURBS_ERROR_GAP, "is used 1 times");
    CHECK_FAILS(nurbs_model_volume(none, 1e-9, a, b, c, NULL, NULL), NURBS_ERROR_LENGTH, "the volume is 0");
    CHECK_UNTOUCHED(a);
    CHECK_UNTOUCHED(b);
    CHECK_UNTOUCHED(c);
    nurbs_model_destroy(none);
    nurbs_model_destroy(open);
    nurbs_model_destroy(model);
    for (int i = 0; i < 6; ++i) {
        nurbs_face_destroy(faces[i]);
    }
}

int main(void) {
    a_box();
    watched();
    refused();
    return check_summary("model_moments");
}
