/* SPDX-License-Identifier: MIT */
/* Models for the tests of them: the box [0, 1] x [0, 2] x [0, 3], and a STEP file. */
#ifndef NURBS_TESTS_CAPI_MODELS_H
#define NURBS_TESTS_CAPI_MODELS_H

#include "faces.h"

/* Corner c of the box is at its upper end along x, y, z where bit 0, 1, 2 of c is set. */
static inline double corner(int c, int axis) {
    return c >> axis & 1 ? axis + 1.0 : 0.0;
}

/* The edges along x have the keys 1 to 4, those along y 5 to 8, those along z 9 to 12; against its axis one is
 * negative. */
static inline int64_t edge_key(int from, int to) {
    const int axis = (from ^ to) == 1 ? 0 : (from ^ to) == 2 ? 1 : 2;
    const int low = from < to ? from : to;
    const int place = axis == 0 ? low >> 1 : axis == 1 ? (low & 1) | (low >> 2) << 1 : low & 3;
    const int64_t key = 1 + 4 * axis + place;
    return from < to ? key : -key;
}

/* Every edge along its axis. */
static inline nurbs *box_edge(int from, int to) {
    static const int32_t degree = 1;
    static const int64_t count = 2;
    static const double knots[] = {0, 0, 1, 1};
    const int low = from < to ? from : to, high = from < to ? to : from;
    double points[6];
    for (int axis = 0; axis < 3; ++axis) {
        points[axis] = corner(low, axis);
        points[3 + axis] = corner(high, axis);
    }
    SplineArgs a = {1, &degree, &count, knots, 4, 3, points, 0, 0, NULL, 0, 0};
    return make(a);
}

/* The face of a plane through four corners, whose edges have the keys above. */
static inline nurbs_face *box_face(const int *at) {
    double origin[3], u[3], v[3];
    for (int axis = 0; axis < 3; ++axis) {
        origin[axis] = corner(at[0], axis);
        u[axis] = corner(at[1], axis) - origin[axis];
        v[axis] = corner(at[3], axis) - origin[axis];
    }
    nurbs *surface = NULL, *edges[4];
    int64_t keys[4];
    CHECK_OK(nurbs_surface_plane(3, origin, u, v, &surface));
    for (int i = 0; i < 4; ++i) {
        edges[i] = box_edge(at[i], at[(i + 1) % 4]);
        keys[i] = edge_key(at[i], at[(i + 1) % 4]);
    }
    nurbs_face *face = NULL;
    CHECK_OK(nurbs_face_create(surface, 1, SIZES(4), NULL, CURVES(edges[0], edges[1], edges[2], edges[3]),
                               keys, 1e-9, 0, NULL, &face));
    nurbs_destroy(surface);
    for (int i = 0; i < 4; ++i) {
        nurbs_destroy(edges[i]);
    }
    return face;
}

static inline void box_faces(nurbs_face **faces) {
    static const int at[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                 {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (int i = 0; i < 6; ++i) {
        faces[i] = box_face(at[i]);
    }
}

static inline nurbs_model *box(void) {
    nurbs_face *faces[6];
    box_faces(faces);
    nurbs_model *model = NULL;
    CHECK_OK(nurbs_model_create(6, (const nurbs_face *const *)faces, 0.001, &model));
    for (int i = 0; i < 6; ++i) {
        nurbs_face_destroy(faces[i]);
    }
    if (model == NULL) {
        exit(2);
    }
    return model;
}

/* A disk of radius 1 and the half ball over it, which share their circle, in centimetres. */
#define HALF_BALL_START                                                                                      \
    "ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\nDATA;\n"                          \
    "#1=CARTESIAN_POINT('',(0.,0.,0.));\n#2=DIRECTION('',(0.,0.,1.));\n#3=DIRECTION('',(1.,0.,0.));\n"       \
    "#4=AXIS2_PLACEMENT_3D('',#1,#2,#3);\n#5=CARTESIAN_POINT('',(1.,0.,0.));\n#6=VERTEX_POINT('',#5);\n"     \
    "#7=CIRCLE('',#4,1.);\n#8=EDGE_CURVE('',#6,#6,#7,.T.);\n#9=PLANE('',#4);\n"                              \
    "#10=SPHERICAL_SURFACE('',#4,1.);\n#11=ORIENTED_EDGE('',*,*,#8,.F.);\n#12=EDGE_LOOP('',(#11));\n"        \
    "#13=FACE_OUTER_BOUND('',#12,.T.);\n#14=ADVANCED_FACE('disk',(#13),#9,.F.);\n"                           \
    "#15=ORIENTED_EDGE('',*,*,#8,.T.);\n#16=EDGE_LOOP('',(#15));\n#17=FACE_OUTER_BOUND('',#16,.T.);\n"       \
    "#18=ADVANCED_FACE('',(#17),#10,.T.);\n#19=CLOSED_SHELL('',(#14,#18));\n"                                \
    "#20=MANIFOLD_SOLID_BREP('',#19);\n#21=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.CENTI.,.METRE.));\n"          \
    "#22=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#21))"                            \
    "REPRESENTATION_CONTEXT('',''));\n#23=SHAPE_REPRESENTATION('',(#20),#22);\n"
#define STEP_END "ENDSEC;\nEND-ISO-10303-21;\n"
static const char half_ball[] = HALF_BALL_START STEP_END;

/* The same as CHECK_NO_HANDLE for models. */
#define CHECK_NO_MODEL(out, call, status, words)                                                             \
    do {                                                                                                     \
        (out) = (nurbs_model *)(void *)check_poison();                                                       \
        CHECK_FAILS(call, status, words);                                                                    \
        check_true(__FILE__, __LINE__, (out) == NULL, #out " == NULL");                                      \
    } while (0)

#endif
