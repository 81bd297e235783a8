/* SPDX-License-Identifier: MIT */
/* A small IGES file in memory: the arch of shapes.h as entity 126 in space, a second curve with a label, and
 * a point (116). */
#ifndef NURBS_TESTS_CAPI_IGES_TEXT_H
#define NURBS_TESTS_CAPI_IGES_TEXT_H

#include "check.h"

typedef struct IgesText {
    char bytes[8192];
    int size;
} IgesText;

static inline void iges_line(IgesText *t, const char *text, char section, int number) {
    t->size += snprintf(t->bytes + t->size, sizeof t->bytes - (size_t)t->size, "%-72.72s%c%7d\n", text,
                        section, number);
}

static inline void iges_directory(IgesText *t, int type, int data_line, int lines, const char *label,
                                  int number) {
    char text[96];
    snprintf(text, sizeof text, "%8d%8d%8d%8d%8d%8d%8d%8d%8s", type, data_line, 0, 1, 0, 0, 0, 0, "00000000");
    iges_line(t, text, 'D', number);
    snprintf(text, sizeof text, "%8d%8d%8d%8d%8d%8s%8s%8s%8s", type, 0, 0, lines, 0, "", "", label, "");
    iges_line(t, text, 'D', number + 1);
}

static inline void iges_data(IgesText *t, const char *data, int directory, int number) {
    char text[96];
    snprintf(text, sizeof text, "%-64.64s%8d", data, directory);
    iges_line(t, text, 'P', number);
}

static inline IgesText small_file(void) {
    IgesText t = {{0}, 0};
    iges_line(&t, "a file of the test programs", 'S', 1);
    iges_line(&t, "1H,,1H;,4Htest,8Htest.igs,4Hnone,4Hnone,32,38,6,308,15,4Htest,1.,2,2HMM,", 'G', 1);
    iges_line(&t, "1,0.01,15H20260101.000000,1.E-6,10.,2Hme,4Hhere,11,0,15H20260101.000000;", 'G', 2);
    iges_directory(&t, 126, 1, 2, "", 1);
    iges_directory(&t, 116, 3, 1, "", 3);
    iges_directory(&t, 126, 4, 1, "BOW", 5);
    iges_data(&t, "126,3,3,0,0,1,0,0,0,0,0,1,1,1,1,1,1,1,1,", 1, 1);
    iges_data(&t, "0,0,0,1,2,0,3,2,0,4,0,0,0,1;", 1, 2);
    iges_data(&t, "116,0,0,0,0;", 3, 3);
    iges_data(&t, "126,1,1,0,0,0,0,0,0,1,1,1,2,0,0,0,1,1,1,0,1;", 5, 4);
    iges_line(&t, "S      1G      2D      6P      4", 'T', 1);
    return t;
}

#endif
