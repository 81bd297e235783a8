/* SPDX-License-Identifier: MIT */
/* Regions of the plane, and faces that curves divide: how many faces, edges and vertices, what is inside, what is refused. */
#include "models.h"

static const double pi_ = 3.14159265358979323846;

static nurbs *rectangle(double left, double low, double right, double high) {
    const double places[] = {left, low, right, low, right, high, left, high, left, low};
    return polyline(5, places);
}

static nurbs_model *region(int64_t count, nurbs **curves, int32_t rule) {
    nurbs_model *model = NULL;
    CHECK_OK(nurbs_region_create(count, (const nurbs *const *)curves, rule, 0, &model));
    for (int64_t i = 0; i < count; ++i) {
        nurbs_destroy(curves[i]);
    }
    return model;
}

static nurbs_face *face_at(const nurbs_model *model, int64_t index) {
    nurbs_face *face = NULL;
    CHECK_OK(nurbs_model_face(model, index, NULL, NULL, NULL, NULL, &face));
    return face;
}

/* The only face of the region of one curve. */
static nurbs_face *face_inside(nurbs *curve) {
    nurbs_model *model = region(1, &curve, NURBS_FILL_NON_ZERO);
    nurbs_face *face = face_at(model, 0);
    nurbs_model_destroy(model);
    return face;
}

/* Destroys the model. */
static void check_model(nurbs_model *model, int64_t faces, int64_t edges, int64_t vertices, double area) {
    int64_t n[3] = {-1, -1, -1};
    double sum = 0;
    CHECK_OK(nurbs_model_counts(model, NULL, NULL, &n[0], &n[1], &n[2]));
    CHECK_INT(n[0], faces);
    CHECK_INT(n[1], edges);
    CHECK_INT(n[2], vertices);
    for (int64_t i = 0; i < n[0]; ++i) {
        nurbs_face *face = face_at(model, i);
        double own = 0;
        CHECK_OK(nurbs_face_area(face, 1e-12, &own, NULL));
        sum += own;
        nurbs_face_destroy(face);
    }
    CHECK_NEAR(&sum, &area, 1, 1e-10);
    nurbs_model_destroy(model);
}

static nurbs_model *combined(int32_t rule, const nurbs_face *a, const nurbs_face *b) {
    nurbs_model *model = NULL;
    CHECK_OK(nurbs_region_combine(rule, 1, &a, b == NULL ? 0 : 1, &b, 0, &model));
    return model;
}

/* A square in a square in a square, all running the same way. */
static void rules_of_filling(void) {
    const double areas[] = {36, 36 - 16 + 4, 36};
    const int64_t faces[] = {1, 2, 1}, edges[] = {1, 3, 1};
    for (int32_t rule = 1; rule <= 3; ++rule) {
        nurbs *curves[] = {rectangle(0, 0, 6, 6), rectangle(1, 1, 5, 5), rectangle(2, 2, 4, 4)};
        check_model(region(3, curves, rule), faces[rule - 1], edges[rule - 1], edges[rule - 1],
                    areas[rule - 1]);
    }
    nurbs *backwards[] = {rectangle(6, 0, 0, 6)};
    check_model(region(1, backwards, NURBS_FILL_POSITIVE), 0, 0, 0, 0);
    nurbs *again[] = {rectangle(6, 0, 0, 6)};
    check_model(region(1, again, NURBS_FILL_NON_ZERO), 1, 1, 1, 36);
    check_model(region(0, NULL, NURBS_FILL_NON_ZERO), 0, 0, 0, 0);
}

/* Curves one after the other, and a curve that crosses itself. */
static void loops_of_curves(void) {
    nurbs *parts[] = {segment(0, 0, 4, 0), segment(4, 0, 0, 3), segment(0, 3, 0, 0),
                      circle_in_domain(9, 9, 1)};
    check_model(region(4, parts, NURBS_FILL_NON_ZERO), 2, 4, 4, 6 + pi_);
    const double bow[] = {0, 0, 2, 2, 2, 0, 0, 2, 0, 0};
    nurbs *crossing[] = {polyline(5, bow)};
    check_model(region(1, crossing, NURBS_FILL_NON_ZERO), 2, 3, 2, 2);
}

static void borders_in_common(void) {
    nurbs_face *left = face_inside(rectangle(0, 0, 2, 2)), *right = face_inside(rectangle(2, 1, 4, 3)),
               *same = face_inside(rectangle(2, 2, 0, 0)), *corner = face_inside(rectangle(2, 2, 3, 3));
    check_model(combined(NURBS_REGION_UNION, left, right), 1, 3, 3, 8);
    check_model(combined(NURBS_REGION_INTERSECTION, left, right), 0, 0, 0, 0);
    check_model(combined(NURBS_REGION_DIFFERENCE, left, right), 1, 1, 1, 4);
    check_model(combined(NURBS_REGION_UNION, left, same), 1, 1, 1, 4);
    check_model(combined(NURBS_REGION_INTERSECTION, left, same), 1, 1, 1, 4);
    check_model(combined(NURBS_REGION_DIFFERENCE, left, same), 0, 0, 0, 0);
    check_model(combined(NURBS_REGION_EITHER, left, same), 0, 0, 0, 0);
    check_model(combined(NURBS_REGION_UNION, left, corner), 2, 2, 2, 5);
    check_model(combined(NURBS_REGION_UNION, left, NULL), 1, 1, 1, 4);
    nurbs_face_destroy(left);
    nurbs_face_destroy(right);
    nurbs_face_destroy(same);
    nurbs_face_destroy(corner);
}

/* Circles that touch from outside, and from inside; a hole that touches the border. */
static void circles_that_touch(void) {
    nurbs_face *big = face_inside(circle_in_domain(0, 0, 2)),
               *beside = face_inside(circle_in_domain(3, 0, 1)),
               *inside = face_inside(circle_in_domain(1, 0, 1));
    check_model(combined(NURBS_REGION_INTERSECTION, big, beside), 0, 0, 0, 0);
    check_model(combined(NURBS_REGION_UNION, big, beside), 2, 2, 2, 5 * pi_);
    check_model(combined(NURBS_REGION_DIFFERENCE, big, inside), 1, 2, 1, 3 * pi_);
    check_model(combined(NURBS_REGION_UNION, big, inside), 1, 1, 1, 4 * pi_);
    nurbs_face_destroy(big);
    nurbs_face_destroy(beside);
    nurbs_face_destroy(inside);
}

/* Of the plane (2 u, 3 v, 0). */
static void a_face_is_divided(void) {
    nurbs *surface = plane(), *across = segment(0, 0.5, 1, 0.5), *ends = segment(0.25, 0.75, 0.25, 2),
          *within = circle_in_domain(0.75, 0.25, 0.125), *outside = segment(0, 2, 1, 2);
    nurbs_face *face = NULL;
    nurbs_model *model = NULL;
    CHECK_OK(nurbs_face_create(surface, 0, NULL, NULL, NULL, NULL, 1e-9, 0, NULL, &face));
    const nurbs *curves[] = {across, ends, within, outside};
    CHECK_OK(nurbs_face_split(face, 0, NULL, 0, &model));
    check_model(model, 1, 4, 4, 6);
    CHECK_OK(nurbs_face_split(face, 1, curves, 0, &model));
    check_model(model, 2, 7, 6, 6);
    CHECK_OK(nurbs_face_split(face, 1, curves + 1, 0, &model));
    check_model(model, 1, 4, 4, 6);
    CHECK_OK(nurbs_face_split(face, 4, curves, 0, &model));
    check_model(model, 3, 8, 7, 6);
    nurbs_face_destroy(face);
    nurbs_destroy(surface);
    nurbs_destroy(across);
    nurbs_destroy(ends);
    nurbs_destroy(within);
    nurbs_destroy(outside);
}

static void what_is_refused(void) {
    nurbs_model *out = NULL;
    nurbs *good = square(0, 1), *open = segment(0, 0, 1, 0), *point = polyline(2, VALUES(1, 1, 1, 1)),
          *surface = plane(), *space = box_edge(0, 1);
    nurbs_face *face = face_of(surface, 1, CURVES(good)), *other = face_inside(square(0, 1));
    const nurbs_face *faces[] = {face, other, NULL};
    const nurbs *curves[] = {good, NULL};
    CHECK_FAILS(nurbs_region_create(1, CURVES(good), 1, 0, NULL), NURBS_ERROR_NULL, "out");
    CHECK_FAILS(nurbs_region_create(1, NULL, 1, 0, &out), NURBS_ERROR_NULL, "curves");
    CHECK_FAILS(nurbs_region_create(2, curves, 1, 0, &out), NURBS_ERROR_NULL, "curves[1]");
    CHECK_FAILS(nurbs_region_create(-1, curves, 1, 0, &out), NURBS_ERROR_COUNT, "count = -1");
    CHECK_FAILS(nurbs_region_create(INT64_MAX, curves, 1, 0, &out), NURBS_ERROR_OVERFLOW, "curves");
    CHECK_FAILS(nurbs_region_create(1, CURVES(good), 0, 0, &out), NURBS_ERROR_RULE, "rule = 0|NURBS_FILL_");
    CHECK_FAILS(nurbs_region_create(1, CURVES(good), 4, 0, &out), NURBS_ERROR_RULE, "rule = 4");
    CHECK_FAILS(nurbs_region_create(1, CURVES(good), 1, -1, &out), NURBS_ERROR_TOLERANCE, "tolerance = -1");
    CHECK_FAILS(nurbs_region_create(1, CURVES(good), 1, NAN, &out), NURBS_ERROR_TOLERANCE, "tolerance");
    CHECK_FAILS(nurbs_region_create(1, CURVES(good), 1, INFINITY, &out), NURBS_ERROR_TOLERANCE, "finite");
    CHECK_FAILS(nurbs_region_create(1, CURVES(surface), 1, 0, &out), NURBS_ERROR_AXES, "curves[0]");
    CHECK_FAILS(nurbs_region_create(1, CURVES(space), 1, 0, &out), NURBS_ERROR_DIMENSION, "curves[0]");
    CHECK_FAILS(nurbs_region_create(2, CURVES(good, open), 1, 0, &out), NURBS_ERROR_GAP, "curves[1]|1");
    CHECK_FAILS(nurbs_region_create(2, CURVES(open, good), 1, 0, &out), NURBS_ERROR_GAP,
                "curves[1]|curves[0]");
    CHECK_OK(nurbs_region_create(1, CURVES(point), 1, 0, &out));
    check_model(out, 0, 0, 0, 0);
    out = NULL;
    CHECK_FAILS(nurbs_region_combine(0, 1, faces, 0, NULL, 0, &out), NURBS_ERROR_RULE, "NURBS_REGION_");
    CHECK_FAILS(nurbs_region_combine(1, 3, faces, 0, NULL, 0, &out), NURBS_ERROR_NULL, "a[2]");
    CHECK_FAILS(nurbs_region_combine(1, 0, NULL, 1, NULL, 0, &out), NURBS_ERROR_NULL, "b is NULL");
    CHECK_FAILS(nurbs_region_combine(1, -1, faces, 0, NULL, 0, &out), NURBS_ERROR_COUNT, "count_a");
    CHECK_FAILS(nurbs_region_combine(1, 0, faces, -1, NULL, 0, &out), NURBS_ERROR_COUNT, "count_b");
    CHECK_FAILS(nurbs_region_combine(1, 1, faces, 1, faces + 1, 0, &out), NURBS_ERROR_INCOMPATIBLE, "b[0]");
    CHECK_FAILS(nurbs_region_combine(1, 1, faces, 0, NULL, -1, &out), NURBS_ERROR_TOLERANCE, "tolerance");
    CHECK_FAILS(nurbs_region_combine(1, 1, faces, 0, NULL, 0, NULL), NURBS_ERROR_NULL, "out");
    CHECK_FAILS(nurbs_face_split(NULL, 1, CURVES(open), 0, &out), NURBS_ERROR_NULL, "face");
    CHECK_FAILS(nurbs_face_split(face, 1, NULL, 0, &out), NURBS_ERROR_NULL, "curves");
    CHECK_FAILS(nurbs_face_split(face, 1, CURVES(space), 0, &out), NURBS_ERROR_DIMENSION, "curves[0]");
    CHECK_FAILS(nurbs_face_split(face, 1, CURVES(open), NAN, &out), NURBS_ERROR_TOLERANCE, "tolerance");
    CHECK_FAILS(nurbs_face_split(face, 1, CURVES(open), 0, NULL), NURBS_ERROR_NULL, "out");
    CHECK_INT(out == NULL, 1);
    nurbs_face_destroy(face);
    nurbs_face_destroy(other);
    nurbs_destroy(good);
    nurbs_destroy(open);
    nurbs_destroy(point);
    nurbs_destroy(surface);
    nurbs_destroy(space);
}

static void check_split(const nurbs_face *face, nurbs *curve, int64_t faces, int64_t edges, int64_t vertices,
                        double area) {
    nurbs_model *model = NULL;
    CHECK_OK(nurbs_face_split(face, 1, CURVES(curve), 0, &model));
    check_model(model, faces, edges, vertices, area);
    nurbs_destroy(curve);
}

/* Around, over the seam and up. */
static void a_cylinder_is_divided(void) {
    nurbs *cylinder = NULL;
    nurbs_face *face = NULL;
    CHECK_OK(nurbs_surface_cylinder(VALUES(0, 0, 0), VALUES(0, 0, 1), VALUES(1, 0, 0), 1, 2, 0, 2 * pi_,
                                    NURBS_ARC_QUARTERS, &cylinder));
    CHECK_OK(nurbs_face_create(cylinder, 0, NULL, NULL, NULL, NULL, 1e-9, 0, NULL, &face));
    double u[2];
    CHECK_OK(nurbs_domain(cylinder, 0, u));
    const double area = 4 * pi_, period = u[1] - u[0];
    check_split(face, segment(u[0] + 0.2, 0.5, u[1] + 0.2, 0.5), 2, 3, 3, area);
    check_split(face, segment(u[0] + 0.2, 0.5, u[1], 0.5), 1, 2, 2, area);
    check_split(face, segment(u[0] + 0.2, 0, u[0] + 3 * period, 1), 1, 2, 2, area);
    check_split(face, circle_in_domain(u[1], 0.5, 0.2), 2, 3, 3, area);
    nurbs_face_destroy(face);
    nurbs_destroy(cylinder);
}

/* By the equator, a meridian circle in two halves, and the spiral between the poles. */
static void a_sphere_is_divided(void) {
    nurbs *sphere = NULL;
    nurbs_face *face = NULL;
    nurbs_model *model = NULL;
    CHECK_OK(nurbs_surface_sphere(NULL, NULL, NULL, 1, NURBS_ARC_QUARTERS, &sphere));
    CHECK_OK(nurbs_face_create(sphere, 0, NULL, NULL, NULL, NULL, 1e-9, 0, NULL, &face));
    double u[2], v[2];
    CHECK_OK(nurbs_domain(sphere, 0, u));
    CHECK_OK(nurbs_domain(sphere, 1, v));
    const double half = (u[1] - u[0]) / 2, middle = (v[0] + v[1]) / 2;
    check_split(face, segment(u[0], middle, u[1], middle), 2, 1, 1, 4 * pi_);
    check_split(face, segment(u[0], v[0], u[0] + 2 * half, v[1]), 1, 0, 0, 4 * pi_);
    nurbs *first = segment(u[0], v[0], u[0], v[1]), *second = segment(u[0] + half, v[0], u[0] + half, v[1]);
    CHECK_OK(nurbs_face_split(face, 2, CURVES(first, second), 0, &model));
    nurbs_face *parts[] = {face_at(model, 0), face_at(model, 1)};
    check_model(model, 2, 2, 2, 4 * pi_);
    CHECK_OK(
        nurbs_region_combine(NURBS_REGION_UNION, 2, (const nurbs_face *const *)parts, 0, NULL, 0, &model));
    check_model(model, 1, 0, 0, 4 * pi_);
    nurbs_face_destroy(parts[0]);
    nurbs_face_destroy(parts[1]);
    nurbs_face_destroy(face);
    nurbs_destroy(first);
    nurbs_destroy(second);
    nurbs_destroy(sphere);
}

static void check_trim(const nurbs_face *face, const nurbs *surface, int32_t side, int64_t faces,
                       double area) {
    nurbs_model *model = NULL;
    int64_t count = -1;
    double sum = 0;
    CHECK_OK(nurbs_face_trim(face, surface, side, 1e-9, &model));
    CHECK_OK(nurbs_model_counts(model, NULL, NULL, &count, NULL, NULL));
    CHECK_INT(count, faces);
    for (int64_t i = 0; i < count; ++i) {
        nurbs_face *part = face_at(model, i);
        double own = 0;
        CHECK_OK(nurbs_face_area(part, 1e-9, &own, NULL));
        sum += own;
        nurbs_face_destroy(part);
    }
    CHECK_NEAR(&sum, &area, 1, 1e-6);
    nurbs_model_destroy(model);
}

static nurbs *level_plane(double height, double half) {
    nurbs *surface = NULL;
    CHECK_OK(nurbs_surface_plane(3, VALUES(-half, -half, height), VALUES(2 * half, 0, 0),
                                 VALUES(0, 2 * half, 0), &surface));
    return surface;
}

/* A sphere by planes: through it, above it, and one that ends inside. */
static void faces_trimmed_by_surfaces(void) {
    nurbs *sphere = NULL, *across = level_plane(0.5, 2), *above = level_plane(1.5, 2),
          *short_one = level_plane(0.5, 0.75), *curve = segment(0, 0, 1, 1), *flat = plane();
    nurbs_face *face = NULL, *plain = NULL;
    nurbs_model *out = NULL;
    CHECK_OK(nurbs_surface_sphere(NULL, NULL, NULL, 1, NURBS_ARC_QUARTERS, &sphere));
    CHECK_OK(nurbs_face_create(sphere, 0, NULL, NULL, NULL, NULL, 1e-9, 0, NULL, &face));
    CHECK_OK(nurbs_face_create(flat, 0, NULL, NULL, NULL, NULL, 1e-9, 0, NULL, &plain));
    check_trim(face, across, NURBS_TRIM_FRONT, 1, pi_);
    check_trim(face, across, NURBS_TRIM_BACK, 1, 3 * pi_);
    check_trim(face, above, NURBS_TRIM_FRONT, 0, 0);
    check_trim(face, above, NURBS_TRIM_BACK, 1, 4 * pi_);
    CHECK_FAILS(nurbs_face_trim(face, short_one, NURBS_TRIM_FRONT, 1e-9, &out), NURBS_ERROR_INCOMPATIBLE,
                "ends inside");
    CHECK_FAILS(nurbs_face_trim(plain, flat, NURBS_TRIM_FRONT, 1e-9, &out), NURBS_ERROR_NOT_CONVERGED,
                "undecided");
    CHECK_FAILS(nurbs_face_trim(NULL, across, 1, 1e-9, &out), NURBS_ERROR_NULL, "face");
    CHECK_FAILS(nurbs_face_trim(face, NULL, 1, 1e-9, &out), NURBS_ERROR_NULL, "surface");
    CHECK_FAILS(nurbs_face_trim(face, curve, 1, 1e-9, &out), NURBS_ERROR_AXES, "surface");
    CHECK_FAILS(nurbs_face_trim(face, across, 0, 1e-9, &out), NURBS_ERROR_RULE, "side = 0|NURBS_TRIM_");
    CHECK_FAILS(nurbs_face_trim(face, across, 1, 0, &out), NURBS_ERROR_TOLERANCE, "tolerance = 0");
    CHECK_FAILS(nurbs_face_trim(face, across, 1, INFINITY, &out), NURBS_ERROR_TOLERANCE, "tolerance");
    CHECK_FAILS(nurbs_face_trim(face, across, 1, 1e-9, NULL), NURBS_ERROR_NULL, "out");
    CHECK_INT(out == NULL, 1);
    nurbs_face_destroy(face);
    nurbs_face_destroy(plain);
    nurbs_destroy(sphere);
    nurbs_destroy(across);
    nurbs_destroy(above);
    nurbs_destroy(short_one);
    nurbs_destroy(curve);
    nurbs_destroy(flat);
}

/* A curve that runs back over itself bounds nothing, alone and across a square. */
static void curves_that_turn_back(void) {
    const double tips[][8] = {
        {0, 0, 1, 0, 0, 0, 0, 0}, {0, 0, 2, 1, 1, 0.5, 0, 0}, {0, 0, 3, 0, -1, 0, 0, 0}};
    for (int i = 0; i < 3; ++i) {
        nurbs *fold = NULL;
        const int32_t degree = i == 0 ? 2 : 3;
        CHECK_OK(nurbs_create_bezier(1, &degree, 2, tips[i], 0, 0, NULL, 0, &fold));
        nurbs_model *model = NULL;
        nurbs *square_there = rectangle(-1, -1, 0.5, 2);
        CHECK_OK(nurbs_region_create(1, CURVES(fold), NURBS_FILL_NON_ZERO, 0, &model));
        check_model(model, 0, 0, 0, 0);
        CHECK_OK(nurbs_region_create(2, CURVES(fold, square_there), NURBS_FILL_EVEN_ODD, 0, &model));
        check_model(model, 1, 1, 1, 4.5);
        nurbs_destroy(fold);
        nurbs_destroy(square_there);
    }
}

/* Regions whose areas no double holds are refused, others are regions. */
static void sizes_of_regions(void) {
    const double sizes[] = {1e-300, 1e-100, 1e100, 1e200};
    for (int i = 0; i < 4; ++i) {
        nurbs *outline = rectangle(0, 0, sizes[i], sizes[i]);
        nurbs_model *model = NULL;
        if (i == 0 || i == 3) {
            CHECK_FAILS(nurbs_region_create(1, CURVES(outline), 1, 0, &model), NURBS_ERROR_NOT_REPRESENTABLE,
                        "wide");
        } else {
            int64_t faces = -1;
            CHECK_OK(nurbs_region_create(1, CURVES(outline), 1, 0, &model));
            CHECK_OK(nurbs_model_counts(model, NULL, NULL, &faces, NULL, NULL));
            CHECK_INT(faces, 1);
            nurbs_model_destroy(model);
        }
        nurbs_destroy(outline);
    }
}

/* A face is never lost without a word. */
static void faces_smaller_than_the_tolerance(void) {
    nurbs *surface = plane(), *loop = square(0, 1);
    nurbs_face *face = NULL;
    nurbs_model *out = NULL;
    CHECK_OK(nurbs_face_create(surface, 0, NULL, NULL, NULL, NULL, 1e-9, 0, NULL, &face));
    CHECK_FAILS(nurbs_face_split(face, 1, CURVES(loop), 100, &out), NURBS_ERROR_NOT_CONVERGED, "tolerance");
    CHECK_INT(out == NULL, 1);
    nurbs_face_destroy(face);
    nurbs_destroy(surface);
    nurbs_destroy(loop);
}

static void watched_calls(void) {
    nurbs_call_options call;
    nurbs_model *out = NULL;
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    call.work = -1;
    CHECK_FAILS(nurbs_region_create_with(0, NULL, 1, 0, &call, &out), NURBS_ERROR_OPTIONS, "work");
    CHECK_FAILS(nurbs_region_combine_with(1, 0, NULL, 0, NULL, 0, &call, &out), NURBS_ERROR_OPTIONS, "work");
    CHECK_FAILS(nurbs_face_split_with(NULL, 0, NULL, 0, &call, &out), NURBS_ERROR_OPTIONS, "work");
    CHECK_FAILS(nurbs_face_trim_with(NULL, NULL, 1, 1, &call, &out), NURBS_ERROR_OPTIONS, "work");
}

int main(void) {
    watched_calls();
    rules_of_filling();
    loops_of_curves();
    borders_in_common();
    circles_that_touch();
    a_face_is_divided();
    what_is_refused();
    a_cylinder_is_divided();
    a_sphere_is_divided();
    faces_trimmed_by_surfaces();
    curves_that_turn_back();
    sizes_of_regions();
    faces_smaller_than_the_tolerance();
    return check_summary("regions_test");
}
