/* SPDX-License-Identifier: MIT */
/* Trimmed faces: made of curves, of edges and of both; what they are made of, and what is asked of them. */
#include "faces.h"

static void whole_surfaces(void) {
    nurbs *surface = plane(), *same = NULL;
    nurbs_face *face = NULL;
    CHECK_OK(nurbs_face_create(surface, 0, NULL, NULL, NULL, NULL, 0.25, 0, NULL, &face));
    int64_t sizes[2], count = 0;
    double tolerance = 0, area = 0, error = -1;
    CHECK_OK(nurbs_face_loops(face, 2, sizes, &count));
    CHECK_INT(count, 1);
    CHECK_INT(sizes[0], 4);
    CHECK_OK(nurbs_face_tolerance(face, &tolerance));
    CHECK_DOUBLE(tolerance, 0.25);
    CHECK_OK(nurbs_face_area(face, 1e-12, &area, &error));
    CHECK_NEAR(&area, VALUES(6), 1, 6e-12);
    CHECK(error >= 0 && error <= 6e-12);
    CHECK_OK(nurbs_face_surface(face, &same));
    double points[2][12];
    CHECK_OK(nurbs_points(surface, 4, points[0], 0, 0));
    CHECK_OK(nurbs_points(same, 4, points[1], 0, 0));
    CHECK_BITS(points[0], points[1], sizeof points[0]);
    nurbs_destroy(surface);
    nurbs_destroy(same);
    nurbs_face_destroy(face);
    nurbs_face_destroy(NULL);
}

/* Outer loops and holes are told apart; the curves are given back with the inside to their left. */
static void loops_are_turned(void) {
    nurbs_face *face = frame_face();
    int64_t sizes[3] = {7, 7, 7}, count = 0;
    CHECK_OK(nurbs_face_loops(face, 0, NULL, &count));
    CHECK_INT(count, 2);
    CHECK_OK(nurbs_face_loops(face, 3, sizes, NULL));
    CHECK_INT(sizes[0], 1);
    CHECK_INT(sizes[1], 1);
    CHECK_INT(sizes[2], 7);
    nurbs *hole = NULL, *outline = NULL;
    CHECK_OK(nurbs_face_curve(face, 0, 0, &hole));
    CHECK_OK(nurbs_face_curve(face, 1, 0, &outline));
    double points[10];
    CHECK_OK(nurbs_points(hole, 5, points, 0, 0));
    CHECK_DOUBLES(points, VALUES(0.25, 0.25, 0.25, 0.5, 0.5, 0.5, 0.5, 0.25, 0.25, 0.25), 10);
    CHECK_OK(nurbs_points(outline, 5, points, 0, 0));
    CHECK_DOUBLES(points, VALUES(0.125, 0.125, 0.875, 0.125, 0.875, 0.875, 0.125, 0.875, 0.125, 0.125), 10);
    nurbs_destroy(hole);
    nurbs_destroy(outline);
    nurbs_face_destroy(face);
}

static void sides(void) {
    nurbs_face *face = frame_face(), *clone = NULL;
    const double at[] = {0.75, 0.75, 0.375, 0.375, 0.25, 0.375, 0, 0.5, -3, 0.5, 0.875, 0.875};
    const int32_t expected[] = {1, -1, 0, -1, -1, 0};
    int32_t found[6];
    CHECK_OK(nurbs_face_classify(face, 6, at, 0, 0, 0, found));
    CHECK_BITS(found, expected, sizeof found);
    /* Components apart from each other, and strides between places. */
    const double u[] = {0.75, 9, 0.375, 9, 0.25, 9, 0.75, 9, 0.375, 9, 0.375};
    CHECK_OK(nurbs_face_classify(face, 3, u, 2, 6, 0, found));
    CHECK_BITS(found, expected, 3 * sizeof *found);
    /* 0.01 of v are 0.03 in space, of u 0.02. */
    const double near[] = {0.5, 0.865, 0.865, 0.75, 0.885, 0.75};
    CHECK_OK(nurbs_face_classify(face, 3, near, 0, 0, 0.025, found));
    CHECK_INT(found[0], 1);
    CHECK_INT(found[1], 0);
    CHECK_INT(found[2], 0);
    CHECK_OK(nurbs_face_clone(face, &clone));
    nurbs_face_destroy(face);
    CHECK_OK(nurbs_face_classify(clone, 6, at, 0, 0, 0, found));
    CHECK_BITS(found, expected, sizeof found);
    CHECK_OK(nurbs_face_classify(clone, 0, NULL, 0, 0, 0, NULL));
    nurbs_face_destroy(clone);
}

static void areas_and_boxes(void) {
    nurbs_face *face = frame_face();
    double area = 0, content = 0, centroid[3], inertia[9], error = 0, lower[3], upper[3], gap = -1;
    const double outer = 1.5 * 2.25, inner = 0.5 * 0.75;
    CHECK_OK(nurbs_face_area(face, 1e-12, &area, NULL));
    CHECK_NEAR(&area, VALUES(outer - inner), 1, 1e-11);
    CHECK_OK(nurbs_face_moments(face, 1e-12, &content, centroid, inertia, &error));
    CHECK_NEAR(&content, &area, 1, 1e-11);
    const double x = (outer * 1 - inner * 0.75) / area, y = (outer * 1.5 - inner * 1.125) / area;
    CHECK_NEAR(centroid, VALUES(x, y, 0), 3, 1e-11);
    CHECK(inertia[8] > 0 && fabs(inertia[0] + inertia[4] - inertia[8]) <= 1e-11);
    CHECK_OK(nurbs_face_moments(face, 1e-12, &content, NULL, NULL, NULL));
    CHECK_OK(nurbs_face_box(face, 1e-6, lower, upper, &gap));
    CHECK_NEAR(lower, VALUES(0.25, 0.375, 0), 3, 1e-6);
    CHECK_NEAR(upper, VALUES(1.75, 2.625, 0), 3, 1e-6);
    CHECK(gap >= 0 && gap <= 1e-6 + 1e-13);
    CHECK_OK(nurbs_face_box(face, 0, lower, upper, NULL));
    CHECK_NEAR(upper, VALUES(1.75, 2.625, 0), 3, 1e-12);
    nurbs_face_destroy(face);
}

/* Edges that are given are given back as they are, with their numbers; others are made. */
static void edges(void) {
    nurbs *surface = plane(), *south = segment(0, 0, 1, 0), *east = segment(1, 0, 1, 1);
    static const int32_t degree = 1;
    static const int64_t two = 2;
    static const double knots[] = {0, 0, 1, 1}, places[] = {0, 0, 0, 2, 3, 0};
    SplineArgs a = {1, &degree, &two, knots, 4, 3, places, 0, 0, NULL, 0, 0};
    nurbs *diagonal = make(a), *edge = NULL, *curve = NULL;
    nurbs_face *face = NULL;
    double gap = -1, distance = -1, points[6];
    int64_t key = 0;
    int32_t proven = 0, degree_of_edge = 0;
    CHECK_OK(nurbs_face_create(surface, 1, SIZES(3), CURVES(south, east, NULL), CURVES(NULL, NULL, diagonal),
                               SIZES(5, -6, -7), 1e-9, 0, &gap, &face));
    CHECK(gap >= 0 && gap <= 1e-9);
    CHECK_OK(nurbs_face_edge(face, 0, 2, &key, &edge));
    CHECK_INT(key, -7);
    CHECK_OK(nurbs_points(edge, 2, points, 0, 0));
    CHECK_DOUBLES(points, places, 6);
    nurbs_destroy(edge);
    CHECK_OK(nurbs_face_edge(face, 0, 1, &key, &edge));
    CHECK_INT(key, -6);
    double end[3];
    CHECK_OK(nurbs_eval(edge, 1, VALUES(-1), 0, 0, end, 0, 0, 0)); /* against the curve, t -> -t */
    CHECK_NEAR(end, VALUES(2, 3, 0), 3, 1e-12);
    nurbs_destroy(edge);
    CHECK_OK(nurbs_face_edge(face, 0, 0, NULL,
                             &edge)); /* of a plane: of the degree of the curve, from corner to corner */
    CHECK_OK(nurbs_degree(edge, 0, &degree_of_edge));
    CHECK_INT(degree_of_edge, 1);
    CHECK_OK(nurbs_points(edge, 2, points, 0, 0));
    CHECK_DOUBLES(points, VALUES(0, 0, 0, 2, 0, 0), 6);
    nurbs_destroy(edge);
    CHECK_OK(nurbs_face_curve(face, 0, 2, &curve));
    CHECK_OK(nurbs_eval(curve, 1, VALUES(-1), 0, 0, end, 0, 0, 0));
    CHECK_NEAR(end, VALUES(1, 1), 2, 1e-12);
    nurbs_destroy(curve);
    for (int64_t i = 0; i < 3; ++i) {
        CHECK_OK(nurbs_face_deviation(face, 0, i, &distance, &proven));
        CHECK(distance >= 0 && distance <= 1e-9 && proven == 1);
    }
    CHECK_OK(nurbs_face_deviation(face, 0, 0, &distance, NULL));
    nurbs_face_destroy(face);
    nurbs *const made[] = {surface, south, east, diagonal};
    for (size_t i = 0; i < sizeof made / sizeof *made; ++i) {
        nurbs_destroy(made[i]);
    }
}

/* Segments close what is left open, if that is wished; gaps are told in any case. */
static void gaps(void) {
    nurbs *surface = plane(), *south = segment(0, 0, 1, 0), *east = segment(1, 0.125, 1, 1);
    nurbs *back = segment(1, 1, 0, 0), *circle = circle_in_domain(0.75, 0.25, 0.125);
    nurbs_face *face = NULL;
    double found[2] = {7, 7}, area = 0;
    const nurbs *curves[] = {south, east, back, circle};
    CHECK_NO_FACE(face, nurbs_face_create(surface, 1, SIZES(3), curves, NULL, NULL, 0.25, 0, found, &face),
                  NURBS_ERROR_GAP, "loop 0|0.375|0.25");
    CHECK_DOUBLES(found, VALUES(0.375, 7), 2);
    CHECK_OK(
        nurbs_face_create(surface, 1, SIZES(3), curves, NULL, NULL, 0.25, NURBS_KEEP_GAPS, found, &face));
    CHECK_DOUBLES(found, VALUES(0.375, 7), 2);
    CHECK_OK(nurbs_face_area(face, 1e-12, &area, NULL));
    CHECK_NEAR(&area, VALUES(3), 1, 1e-11);
    nurbs_face_destroy(face);
    CHECK_OK(nurbs_face_create(surface, 1, SIZES(3), curves, NULL, NULL, 0.375, 0, NULL, &face));
    nurbs_face_destroy(face);
    nurbs *const made[] = {surface, south, east, back, circle};
    for (size_t i = 0; i < sizeof made / sizeof *made; ++i) {
        nurbs_destroy(made[i]);
    }
}

/* As the loops run: what is outside of a clockwise loop is inside. */
static void as_oriented(void) {
    nurbs *surface = plane(), *circle = circle_in_domain(0.5, 0.5, 0.25), *hole = NULL;
    nurbs_face *face = NULL;
    CHECK_OK(nurbs_reverse(circle, 0, 0, &hole));
    int32_t side = 0;
    for (int turned = 0; turned < 2; ++turned) {
        const uint32_t flags = turned ? NURBS_AS_ORIENTED : 0;
        CHECK_OK(nurbs_face_create(surface, 1, SIZES(1), CURVES(hole), NULL, NULL, 1e-9, flags, NULL, &face));
        CHECK_OK(nurbs_face_classify(face, 1, VALUES(0.5, 0.5), 0, 0, 0, &side));
        CHECK_INT(side, turned ? -1 : 1);
        nurbs_face_destroy(face);
    }
    nurbs_destroy(surface);
    nurbs_destroy(circle);
    nurbs_destroy(hole);
}

/* The forms that can be ended give the same. */
static int32_t ended(double done, void *user) {
    (void)done;
    return *(const int32_t *)user;
}

static void watched(void) {
    nurbs_call_options call;
    int32_t wish = 0;
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    call.progress = ended;
    call.user = &wish;
    nurbs *surface = plane(), *outline = square(0.125, 0.875);
    nurbs_face *face = NULL;
    double gap = -1, a[2] = {0, 0}, centroid[3], inertia[9], lower[3], upper[3];
    int32_t side = 0;
    CHECK_OK(nurbs_face_create_with(surface, 1, SIZES(1), CURVES(outline), NULL, NULL, 1e-9, 0, &gap, &call,
                                    &face));
    CHECK_OK(nurbs_face_classify_with(face, 1, VALUES(0.5, 0.5), 0, 0, 0, &side, &call));
    CHECK_INT(side, 1);
    CHECK_OK(nurbs_face_area_with(face, 1e-9, a, NULL, NULL));
    CHECK_OK(nurbs_face_moments_with(face, 1e-9, a + 1, centroid, inertia, NULL, &call));
    CHECK_DOUBLE(a[0], a[1]);
    CHECK_OK(nurbs_face_box_with(face, 1e-9, lower, upper, &gap, &call));
    int64_t count = -1;
    CHECK_OK(nurbs_face_quadrature_with(face, 2, 0, NULL, NULL, NULL, &count, &call));
    CHECK(count > 0 && count % 4 == 0);
    call.struct_size = -1;
    CHECK_FAILS(nurbs_face_quadrature_with(face, 2, 0, NULL, NULL, NULL, &count, &call), NURBS_ERROR_OPTIONS,
                "struct_size");
    CHECK_FAILS(nurbs_face_area_with(face, 1e-9, a, NULL, &call), NURBS_ERROR_OPTIONS, "struct_size");
    CHECK_FAILS(nurbs_face_box_with(face, 1e-9, lower, upper, NULL, &call), NURBS_ERROR_OPTIONS,
                "struct_size");
    CHECK_FAILS(nurbs_face_moments_with(face, 1e-9, a, NULL, NULL, NULL, &call), NURBS_ERROR_OPTIONS,
                "struct_size");
    CHECK_FAILS(nurbs_face_classify_with(face, 1, VALUES(0.5, 0.5), 0, 0, 0, &side, &call),
                NURBS_ERROR_OPTIONS, "struct_size");
    nurbs_face_destroy(face);
    CHECK_NO_FACE(face,
                  nurbs_face_create_with(surface, 1, SIZES(1), CURVES(outline), NULL, NULL, 1e-9, 0, NULL,
                                         &call, &face),
                  NURBS_ERROR_OPTIONS, "struct_size");
    nurbs_destroy(surface);
    nurbs_destroy(outline);
}

/* A square with sides along the axes: one cell, or a few, and a sum that is exact. */
static void quadrature(void) {
    nurbs *surface = plane(), *outline = square(0.125, 0.875);
    nurbs_face *face = NULL;
    double params[2 * 64], weights[64], measures[64], area = 0, sum = 0, parameters = 0;
    int64_t count = -1;
    CHECK_OK(nurbs_face_create(surface, 1, SIZES(1), CURVES(outline), NULL, NULL, 1e-9, 0, NULL, &face));
    CHECK_OK(nurbs_face_quadrature(face, 0, 64, params, weights, measures, &count));
    CHECK_OK(nurbs_face_area(face, 1e-12, &area, NULL));
    for (int i = 0; i < count; ++i) {
        CHECK(params[2 * i] > 0.125 && params[2 * i] < 0.875 && weights[i] >= 0);
        parameters += weights[i];
        sum += measures[i];
    }
    CHECK(fabs(parameters - 0.5625) < 1e-14 && fabs(sum - area) < 1e-13 * area);
    FILL(params);
    FILL(weights);
    CHECK_FAILS(nurbs_face_quadrature(NULL, -1, -1, params, weights, NULL, NULL), NURBS_ERROR_NULL, "face");
    CHECK_FAILS(nurbs_face_quadrature(face, -1, 64, params, weights, NULL, NULL), NURBS_ERROR_COUNT,
                "nodes = -1");
    CHECK_FAILS(nurbs_face_quadrature(face, 65, 64, params, weights, NULL, NULL), NURBS_ERROR_COUNT,
                "nodes = 65");
    CHECK_FAILS(nurbs_face_quadrature(face, 0, -1, params, weights, NULL, NULL), NURBS_ERROR_COUNT,
                "cap = -1");
    CHECK_FAILS(nurbs_face_quadrature(face, 0, 1, params, weights, NULL, NULL), NURBS_ERROR_SIZE, "cap = 1");
    CHECK_FAILS(nurbs_face_quadrature(face, 0, 64, params, params, NULL, NULL), NURBS_ERROR_OVERLAP,
                "weights|params");
    CHECK_UNTOUCHED(params);
    CHECK_UNTOUCHED(weights);
    nurbs_face_destroy(face);
    nurbs_destroy(surface);
    nurbs_destroy(outline);
}

int main(void) {
    quadrature();
    whole_surfaces();
    loops_are_turned();
    sides();
    areas_and_boxes();
    edges();
    gaps();
    as_oriented();
    watched();
    return check_summary("face");
}
