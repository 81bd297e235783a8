/* SPDX-License-Identifier: MIT */
/* nurbs_read() of STEP files. */
#include "check.h"

#include <math.h>
#include <stdint.h>

#define START                                                                                                \
    "ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\nDATA;\n"                          \
    "#1=CARTESIAN_POINT('',(1.,0.,0.));\n#2=AXIS2_PLACEMENT_3D('',#1,$,$);\n"
#define END "ENDSEC;\nEND-ISO-10303-21;\n"

/* A sphere as a face, a named circle, a block that is not read, and a unit. */
static const char good[] = START "#3=SPHERICAL_SURFACE('',#2,2.);\n#4=ADVANCED_FACE('',(),#3,.T.);\n"
                                 "#5=CIRCLE('\\X2\\03B1\\X0\\',#2,3.);\n#6=BLOCK('',#2,1.,1.,1.);\n"
                                 "#7=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.CENTI.,.METRE.));\n"
                                 "#8=(GLOBAL_UNIT_ASSIGNED_CONTEXT((#7))REPRESENTATION_CONTEXT('',''));\n"
                                 "#9=SHAPE_REPRESENTATION('',(#4,#5,#6),#8);\n" END;

static nurbs_list *list_of(const char *text, double unit) {
    nurbs_read_options options;
    nurbs_list *list = NULL;
    CHECK_OK(nurbs_read_options_init(&options, (int64_t)sizeof options));
    options.unit = unit;
    CHECK_OK(nurbs_read(text, (int64_t)strlen(text), &options, &list));
    if (list == NULL) {
        exit(2);
    }
    return list;
}

static void check_name(const nurbs_list *list, int64_t index, const char *expected) {
    char name[16];
    CHECK_OK(nurbs_list_name(list, index, name, (int64_t)sizeof name, NULL));
    CHECK(strcmp(name, expected) == 0);
}

static void check_point(const nurbs_list *list, int64_t index, double u, double v, double x) {
    nurbs *spline = NULL;
    const double params[2] = {u, v};
    double point[3] = {0, 0, 0};
    CHECK_OK(nurbs_list_get(list, index, &spline));
    CHECK_OK(nurbs_eval(spline, 1, params, 0, 0, point, 0, 0, 0));
    CHECK(fabs(point[0] - x) <= 1e-14 * fabs(x) && point[1] == 0 && point[2] == 0);
    nurbs_destroy(spline);
}

static void contents(void) {
    nurbs_list *list = list_of(good, 0);
    int64_t count = -1;
    double metres = -1;
    CHECK_OK(nurbs_list_count(list, &count));
    CHECK_INT(count, 2);
    check_name(list, 0, "#4");
    check_name(list, 1, "\xce\xb1");
    check_point(list, 0, 0, 0, 3);
    check_point(list, 1, 0, 0, 4);
    CHECK_OK(nurbs_list_unit(list, &metres));
    CHECK_DOUBLE(metres, 0.01);
    nurbs_list_destroy(list);
    list = list_of(good, 0.001);
    check_point(list, 0, 0, 0, 30);
    nurbs_list_destroy(list);
}

static void notes(void) {
    nurbs_list *list = list_of(good, 0);
    int64_t count = -1, line = -1;
    int32_t type = -1;
    nurbs_status reason = NURBS_OK;
    char text[80];
    CHECK_OK(nurbs_list_note_count(list, &count));
    CHECK_INT(count, 1);
    CHECK_OK(nurbs_list_note(list, 0, &type, &line, &reason, text, (int64_t)sizeof text, NULL));
    CHECK_INT(type, 0);
    CHECK_INT(line, 6);
    CHECK_INT(reason, NURBS_ERROR_UNSUPPORTED);
    CHECK(strcmp(text, "#6 BLOCK: does not become a spline in this version") == 0);
    nurbs_list_destroy(list);
}

static void refuse(const char *text, nurbs_status status, const char *words) {
    nurbs_list *list = (nurbs_list *)(void *)check_poison();
    CHECK_FAILS(nurbs_read(text, (int64_t)strlen(text), NULL, &list), status, words);
    CHECK(list == NULL);
}

static void broken_files(void) {
    refuse(START, NURBS_ERROR_TRUNCATED, "before END-ISO-10303-21");
    refuse(START "#3 CIRCLE();\n" END, NURBS_ERROR_SYNTAX, "line 8: found CIRCLE, expected '='");
    refuse("ISO-10303-21;HEADER;FILE_SCHEMA(('IFC2X3'));ENDSEC;DATA;" END, NURBS_ERROR_FORMAT, "IFC2X3");
}

static void unknown_unit(void) {
    const char *text = START END;
    nurbs_read_options options;
    nurbs_list *list = NULL;
    CHECK_OK(nurbs_read_options_init(&options, (int64_t)sizeof options));
    options.unit = 1;
    CHECK_FAILS(nurbs_read(text, (int64_t)strlen(text), &options, &list), NURBS_ERROR_OPTIONS,
                "the unit of the file is not known");
}

int main(void) {
    contents();
    notes();
    broken_files();
    unknown_unit();
    return check_summary("read_step");
}
