/* SPDX-License-Identifier: MIT */
/* Models of IGES files: a plate with a hole as a trimmed surface, in a subfigure that is used twice. */
#include "iges_text.h"
#include "models.h"

static const char bilinear[] = "128,1,1,1,1,0,0,1,0,0,0,0,1,1,0,0,1,1,1,1,1,1,";

/* [0, 4]^2 without [1, 3] x [1, 2], in a subfigure with two instances, and a face of no surface. */
static IgesText plate(void) {
    IgesText t = {{0}, 0};
    iges_line(&t, "a plate", 'S', 1);
    iges_line(&t, "1H,,1H;,4Htest,8Htest.igs,4Hnone,4Hnone,32,38,6,308,15,4Htest,1.,2,2HMM,", 'G', 1);
    iges_line(&t, "1,0.01,15H20260101.000000,1.E-6,10.,2Hme,4Hhere,11,0,15H20260101.000000;", 'G', 2);
    iges_directory(&t, 128, 1, 2, "", 1);
    iges_directory(&t, 126, 3, 2, "", 3);
    iges_directory(&t, 142, 5, 1, "", 5);
    iges_directory(&t, 144, 6, 1, "PLATE", 7);
    iges_directory(&t, 308, 7, 1, "", 9);
    iges_directory(&t, 408, 8, 1, "", 11);
    iges_directory(&t, 408, 9, 1, "", 13);
    iges_directory(&t, 144, 10, 1, "", 15);
    iges_data(&t, bilinear, 1, 1);
    iges_data(&t, "0,0,0,4,0,0,0,4,0,4,4,0,0,1,0,1;", 1, 2);
    iges_data(&t, "126,4,1,0,1,1,0,0,0,1,2,3,4,4,1,1,1,1,1,", 3, 3);
    iges_data(&t, "1,1,0,3,1,0,3,2,0,1,2,0,1,1,0,0,4,0,0,1;", 3, 4);
    iges_data(&t, "142,0,1,0,3,2;", 5, 5);
    iges_data(&t, "144,1,0,1,0,5;", 7, 6);
    iges_data(&t, "308,0,4Hpart,1,7;", 9, 7);
    iges_data(&t, "408,9,1.,2.,3.;", 11, 8);
    iges_data(&t, "408,9,0.,0.,0.,2.;", 13, 9);
    iges_data(&t, "144,999,0,0,0;", 15, 10);
    iges_line(&t, "S      1G      2D     16P     10", 'T', 1);
    return t;
}

static nurbs_model *read_plate(double unit) {
    const IgesText t = plate();
    nurbs_read_options options;
    nurbs_model *model = NULL;
    CHECK_OK(nurbs_read_options_init(&options, (int64_t)sizeof options));
    options.unit = unit;
    CHECK_OK(nurbs_read_model(t.bytes, t.size, &options, &model));
    return model;
}

static void face_with_a_hole(void) {
    for (int i = 0; i < 2; ++i) {
        nurbs_model *model = read_plate(i == 0 ? 0 : 1);
        const double scale = i == 0 ? 1 : 1e-3, area = 14 * scale * scale;
        int64_t counts[5] = {0}, part = -1, sizes[2] = {0};
        int32_t shape = -1, against = -1;
        double found = 0;
        nurbs_face *face = NULL;
        CHECK_OK(nurbs_model_counts(model, &counts[0], &counts[1], &counts[2], &counts[3], &counts[4]));
        CHECK_INT(counts[0], 2);
        CHECK_INT(counts[1], 3);
        CHECK_INT(counts[2], 1);
        CHECK_OK(nurbs_model_face(model, 0, &part, &shape, &against, NULL, &face));
        CHECK_INT(part, 1);
        CHECK_INT(shape, NURBS_SHAPE_NONE);
        CHECK_INT(against, 0);
        CHECK_OK(nurbs_face_area(face, 1e-10, &found, NULL));
        CHECK_NEAR(&found, &area, 1, 1e-10 * area);
        CHECK_OK(nurbs_face_loops(face, 2, sizes, NULL));
        CHECK_INT(sizes[0], 4);
        nurbs_face_destroy(face);
        nurbs_model_destroy(model);
    }
}

static void names_and_places(void) {
    nurbs_model *model = read_plate(1);
    char name[8] = "";
    int64_t parent = -7, part = -7;
    double placement[12];
    CHECK_OK(nurbs_model_face_name(model, 0, name, (int64_t)sizeof name, NULL));
    CHECK(strcmp(name, "PLATE") == 0);
    CHECK_OK(nurbs_model_part(model, 1, name, (int64_t)sizeof name, NULL));
    CHECK(strcmp(name, "part") == 0);
    CHECK_OK(nurbs_model_use(model, 0, &parent, &part, placement));
    CHECK_INT(parent, 0);
    CHECK_INT(part, 1);
    CHECK_DOUBLES(placement, VALUES(1, 0, 0, 1e-3, 0, 1, 0, 2e-3, 0, 0, 1, 3e-3), 12);
    CHECK_OK(nurbs_model_use(model, 1, &parent, &part, placement));
    CHECK_DOUBLES(placement, VALUES(2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0), 12);
    nurbs_model_destroy(model);
}

static void what_is_wrong_is_noted(void) {
    nurbs_model *model = read_plate(0);
    nurbs_list *list = NULL;
    int64_t count = -1, line = -1;
    int32_t type = -1, reason = -1;
    CHECK_OK(nurbs_model_splines(model, &list));
    CHECK_OK(nurbs_list_note_count(list, &count));
    CHECK_INT(count, 1);
    CHECK_OK(nurbs_list_note(list, 0, &type, &line, &reason, NULL, 0, NULL));
    CHECK_INT(type, 144);
    CHECK_INT(line, 15);
    CHECK_INT(reason, NURBS_ERROR_SYNTAX);
    nurbs_list_destroy(list);
    nurbs_model_destroy(model);
}

int main(void) {
    face_with_a_hole();
    names_and_places();
    what_is_wrong_is_noted();
    return check_summary("model_iges");
}
