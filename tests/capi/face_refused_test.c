/* SPDX-License-Identifier: MIT */
/* Faces that cannot be, and questions that cannot be asked of them: each refused by its name. */
#include "faces.h"

static nurbs *surface_, *outline_, *hole_;
static nurbs_face *face_, *out_;

static const double *const nowhere = NULL;

/* With one loop of one curve. */
static nurbs_status create_one(const nurbs *curve, double tolerance) {
    return nurbs_face_create(surface_, 1, SIZES(1), &curve, NULL, NULL, tolerance, 0, NULL, &out_);
}

static void missing_arguments(void) {
    CHECK_FAILS(nurbs_face_create(surface_, 1, SIZES(1), CURVES(outline_), NULL, NULL, NAN, 0, NULL, NULL),
                NURBS_ERROR_NULL, "out");
    CHECK_NO_FACE(out_, nurbs_face_create(NULL, -1, NULL, NULL, NULL, NULL, NAN, 99, NULL, &out_),
                  NURBS_ERROR_NULL, "surface");
    CHECK_NO_FACE(out_,
                  nurbs_face_create(surface_, 1, NULL, CURVES(outline_), NULL, NULL, NAN, 99, NULL, &out_),
                  NURBS_ERROR_NULL, "sizes");
    CHECK_NO_FACE(out_, nurbs_face_create(surface_, 1, SIZES(1), NULL, NULL, NULL, 1, 0, NULL, &out_),
                  NURBS_ERROR_NULL, "curves[0]|edges[0]");
    CHECK_NO_FACE(out_,
                  nurbs_face_create(surface_, 1, SIZES(2), CURVES(outline_, NULL), CURVES(NULL, NULL), NULL,
                                    1, 0, NULL, &out_),
                  NURBS_ERROR_NULL, "curves[1]|edges[1]");
}

static void wrong_numbers(void) {
    const nurbs *both[] = {outline_, hole_};
    CHECK_NO_FACE(out_, nurbs_face_create(surface_, -1, SIZES(1), both, NULL, NULL, 1, 0, NULL, &out_),
                  NURBS_ERROR_COUNT, "loops|-1");
    CHECK_NO_FACE(out_, nurbs_face_create(surface_, 2, SIZES(1, 0), both, NULL, NULL, 1, 0, NULL, &out_),
                  NURBS_ERROR_COUNT, "sizes[1] = 0");
    CHECK_NO_FACE(out_, nurbs_face_create(surface_, 2, SIZES(1, -3), both, NULL, NULL, 1, 0, NULL, &out_),
                  NURBS_ERROR_COUNT, "sizes[1] = -3");
    CHECK_NO_FACE(out_, nurbs_face_create(surface_, INT64_MAX, SIZES(1), both, NULL, NULL, 1, 0, NULL, &out_),
                  NURBS_ERROR_OVERFLOW, "sizes");
    CHECK_NO_FACE(out_,
                  nurbs_face_create(surface_, 2, SIZES(1, INT64_MAX), both, NULL, NULL, 1, 0, NULL, &out_),
                  NURBS_ERROR_OVERFLOW, "");
    CHECK_NO_FACE(
        out_, nurbs_face_create(surface_, 2, SIZES(1, 1), both, NULL, SIZES(1, INT64_MIN), 1, 0, NULL, &out_),
        NURBS_ERROR_OVERFLOW, "keys[1]|-9223372036854775808");
    CHECK_OK(nurbs_face_create(surface_, 2, SIZES(1, 1), both, NULL, SIZES(INT64_MAX, -INT64_MAX), 1, 0, NULL,
                               &out_));
    int64_t key = 0;
    nurbs *edge = NULL;
    CHECK_OK(nurbs_face_edge(out_, 1, 0, &key, &edge)); /* the hole was turned */
    CHECK_INT(key, INT64_MAX);
    nurbs_destroy(edge);
    nurbs_face_destroy(out_);
    const double bad[] = {NAN, -1, -INFINITY, INFINITY};
    for (int i = 0; i < 3; ++i) {
        CHECK_NO_FACE(out_, create_one(outline_, bad[i]), NURBS_ERROR_TOLERANCE, "tolerance");
    }
    CHECK_NO_FACE(out_,
                  nurbs_face_create(surface_, 1, SIZES(1), both, NULL, NULL, 1, NURBS_CLAMP, NULL, &out_),
                  NURBS_ERROR_FLAGS, "flags");
    union {
        int64_t sizes[2];
        double gaps[2];
    } shared = {{1, 1}};
    CHECK_NO_FACE(out_,
                  nurbs_face_create(surface_, 2, shared.sizes, both, NULL, NULL, 1, 0, shared.gaps, &out_),
                  NURBS_ERROR_OVERLAP, "gaps|sizes");
    CHECK_NO_FACE(
        out_, nurbs_face_create(surface_, 2, SIZES(1, 1), both, NULL, shared.sizes, 1, 0, shared.gaps, &out_),
        NURBS_ERROR_OVERLAP, "gaps|keys");
}

static void wrong_splines(void) {
    nurbs *space = make(twist()), *solid = NULL;
    CHECK_OK(nurbs_extrude(surface_, VALUES(0, 0, 1), &solid));
    CHECK_NO_FACE(out_, nurbs_face_create(space, 0, NULL, NULL, NULL, NULL, 1, 0, NULL, &out_),
                  NURBS_ERROR_AXES, "surface");
    CHECK_NO_FACE(out_, nurbs_face_create(solid, 0, NULL, NULL, NULL, NULL, 1, 0, NULL, &out_),
                  NURBS_ERROR_AXES, "surface");
    CHECK_NO_FACE(out_, create_one(surface_, 1), NURBS_ERROR_AXES, "curves[0]");
    CHECK_NO_FACE(out_, create_one(space, 1), NURBS_ERROR_DIMENSION, "curves[0]|3");
    CHECK_NO_FACE(out_,
                  nurbs_face_create(surface_, 1, SIZES(2), CURVES(outline_, outline_),
                                    CURVES(space, outline_), NULL, 1, 0, NULL, &out_),
                  NURBS_ERROR_DIMENSION, "edges[1]|2");
    CHECK_NO_FACE(out_,
                  nurbs_face_create(surface_, 1, SIZES(1), NULL, CURVES(surface_), NULL, 1, 0, NULL, &out_),
                  NURBS_ERROR_AXES, "edges[0]");
    nurbs_destroy(space);
    nurbs_destroy(solid);
}

/* Weights that are not positive have no hull. */
static void wrong_weights(void) {
    static const int32_t degree = 2;
    static const int64_t count = 3;
    static const double knots[] = {0, 0, 0, 1, 1, 1}, places[] = {0.25, 0.25, 0.75, 0.75, 0.25, 0.25};
    SplineArgs a = {1, &degree, &count, knots, 6, 2, places, 0, 0, NULL, 0, 0};
    a.weights = VALUES(1, 0, 1);
    nurbs *zero = make(a), *negative = NULL;
    const double records[] = {0.25, 0.25, 1, -0.25, -0.25, -0.25, 0.25, 0.25, 1};
    CHECK_OK(nurbs_create_homogeneous(1, &degree, &count, knots, 6, 2, records, 0, 0, 0, &negative));
    CHECK_NO_FACE(out_, create_one(zero, 1), NURBS_ERROR_WEIGHT_SIGN, "curve 0 of loop 0|weight 0");
    CHECK_NO_FACE(out_, create_one(negative, 1), NURBS_ERROR_WEIGHT_SIGN, "curve 0 of loop 0|-0.25");
    nurbs_destroy(zero);
    nurbs_destroy(negative);
}

static void wrong_loops(void) {
    nurbs *open = segment(0.25, 0.25, 0.75, 0.5), *outside = square(0.5, 1.25);
    double gap[2] = {7, 7};
    CHECK_NO_FACE(out_, create_one(open, 0), NURBS_ERROR_GAP, "loop 0|tolerance 0");
    CHECK_NO_FACE(
        out_,
        nurbs_face_create(surface_, 2, SIZES(1, 1), CURVES(outline_, open), NULL, NULL, 0.5, 0, gap, &out_),
        NURBS_ERROR_GAP, "loop 1");
    CHECK(gap[0] == 0 && fabs(gap[1] - 1.25) <= 1e-15);
    CHECK_NO_FACE(out_, create_one(outside, 1e-6), NURBS_ERROR_OUTSIDE_DOMAIN, "loop 0|1.25|axis");
    /* A segment there and back encloses nothing. */
    CHECK_NO_FACE(
        out_,
        nurbs_face_create(surface_, 1, SIZES(1), CURVES(open), NULL, NULL, 0, NURBS_KEEP_GAPS, NULL, &out_),
        NURBS_ERROR_ORIENTATION, "loop 0");
    /* The inside of both, as they run, would be what is left of one and right of the other. */
    CHECK_NO_FACE(out_,
                  nurbs_face_create(surface_, 2, SIZES(1, 1), CURVES(outline_, hole_), NULL, NULL, 0,
                                    NURBS_AS_ORIENTED, NULL, &out_),
                  NURBS_ERROR_ORIENTATION, "loop 1");
    nurbs_destroy(open);
    nurbs_destroy(outside);
}

static void edges_off_the_surface(void) {
    static const int32_t degree = 1;
    static const int64_t count = 4;
    static const double knots[] = {0, 0, 1, 2, 3, 3};
    static const double places[] = {0.5, 0.5, 0, 1, 0.5, 0.25, 0.5, 1, 0, 0.5, 0.5, 0};
    SplineArgs a = {1, &degree, &count, knots, 6, 3, places, 0, 0, NULL, 0, 0};
    nurbs *edge = make(a);
    CHECK_NO_FACE(out_,
                  nurbs_face_create(surface_, 1, SIZES(1), NULL, CURVES(edge), NULL, 0.125, 0, NULL, &out_),
                  NURBS_ERROR_GAP, "edge 0 of loop 0");
    nurbs_destroy(edge);
}

/* nurbs_face_surface(), _loops(), _curve(), _edge(), _deviation(), _tolerance(), _clone(). */
static void parts(void) {
    nurbs *g = NULL;
    int64_t key = 0, sizes[1] = {7}, count = 7;
    double number = 7;
    CHECK_NO_FACE(out_, nurbs_face_clone(NULL, &out_), NURBS_ERROR_NULL, "face");
    CHECK_FAILS(nurbs_face_clone(face_, NULL), NURBS_ERROR_NULL, "out");
    CHECK_NO_HANDLE(g, nurbs_face_surface(NULL, &g), NURBS_ERROR_NULL, "face");
    CHECK_FAILS(nurbs_face_surface(face_, NULL), NURBS_ERROR_NULL, "out");
    CHECK_FAILS(nurbs_face_loops(NULL, 0, NULL, &count), NURBS_ERROR_NULL, "face");
    CHECK_FAILS(nurbs_face_loops(face_, 1, NULL, &count), NURBS_ERROR_NULL, "sizes");
    CHECK_FAILS(nurbs_face_loops(face_, 1, sizes, &count), NURBS_ERROR_SIZE, "cap = 1|2");
    CHECK_FAILS(nurbs_face_loops(face_, -1, sizes, &count), NURBS_ERROR_COUNT, "cap|-1");
    int64_t both[2];
    CHECK_FAILS(nurbs_face_loops(face_, 2, both, both + 1), NURBS_ERROR_OVERLAP, "sizes|count");
    CHECK_INT(count, 7);
    int64_t three[3]; /* of which the last one is not overwritten */
    CHECK_OK(nurbs_face_loops(face_, INT64_MAX / 8, three, three + 2));
    CHECK_INT(three[2], 2);
    CHECK_NO_HANDLE(g, nurbs_face_curve(NULL, 0, 0, &g), NURBS_ERROR_NULL, "face");
    CHECK_FAILS(nurbs_face_curve(face_, 9, 0, NULL), NURBS_ERROR_NULL, "out");
    CHECK_NO_HANDLE(g, nurbs_face_curve(face_, 2, 0, &g), NURBS_ERROR_INDEX, "loop = 2|2 loops");
    CHECK_NO_HANDLE(g, nurbs_face_curve(face_, -1, 0, &g), NURBS_ERROR_INDEX, "loop = -1");
    CHECK_NO_HANDLE(g, nurbs_face_curve(face_, 1, 1, &g), NURBS_ERROR_INDEX, "index = 1|1 curves of loop 1");
    CHECK_NO_HANDLE(g, nurbs_face_curve(face_, 1, INT64_MIN, &g), NURBS_ERROR_INDEX, "index = -9");
    CHECK_NO_HANDLE(g, nurbs_face_edge(NULL, 0, 0, &key, &g), NURBS_ERROR_NULL, "face");
    CHECK_FAILS(nurbs_face_edge(face_, 0, 0, &key, NULL), NURBS_ERROR_NULL, "out");
    CHECK_NO_HANDLE(g, nurbs_face_edge(face_, 7, 0, &key, &g), NURBS_ERROR_INDEX, "loop = 7");
    CHECK_FAILS(nurbs_face_deviation(NULL, 0, 0, &number, NULL), NURBS_ERROR_NULL, "face");
    CHECK_FAILS(nurbs_face_deviation(face_, 9, 0, NULL, NULL), NURBS_ERROR_NULL, "distance");
    CHECK_FAILS(nurbs_face_deviation(face_, 0, 9, &number, NULL), NURBS_ERROR_INDEX, "index = 9");
    CHECK_FAILS(nurbs_face_deviation(face_, 0, 0, &number, (int32_t *)(void *)&number), NURBS_ERROR_OVERLAP,
                "distance|proven");
    CHECK_FAILS(nurbs_face_tolerance(NULL, &number), NURBS_ERROR_NULL, "face");
    CHECK_FAILS(nurbs_face_tolerance(face_, NULL), NURBS_ERROR_NULL, "tolerance");
    CHECK_DOUBLE(number, 7);
}

static void sides(void) {
    const double at[] = {0.5, 0.5, 0.25, 0.25};
    int32_t found[2];
    FILL(found);
    CHECK_FAILS(nurbs_face_classify(NULL, 1, nowhere, 0, 0, NAN, NULL), NURBS_ERROR_NULL, "face");
    CHECK_FAILS(nurbs_face_classify(face_, 1, NULL, 0, 0, NAN, found), NURBS_ERROR_NULL, "params");
    CHECK_FAILS(nurbs_face_classify(face_, 1, at, 0, 0, NAN, NULL), NURBS_ERROR_NULL, "sides");
    CHECK_FAILS(nurbs_face_classify(face_, -1, at, 0, 0, 0, found), NURBS_ERROR_COUNT, "-1");
    CHECK_FAILS(nurbs_face_classify(face_, INT64_MAX, at, 0, 0, 0, found), NURBS_ERROR_OVERFLOW, "params");
    CHECK_FAILS(nurbs_face_classify(face_, 2, at, -2, 0, 0, found), NURBS_ERROR_STRIDE, "param");
    CHECK_FAILS(nurbs_face_classify(face_, 2, at, 0, -1, 0, found), NURBS_ERROR_STRIDE, "param");
    CHECK_FAILS(nurbs_face_classify(face_, 2, at, 0, 0, -1, found), NURBS_ERROR_TOLERANCE, "tolerance");
    CHECK_FAILS(nurbs_face_classify(face_, 2, at, 0, 0, NAN, found), NURBS_ERROR_TOLERANCE, "tolerance");
    CHECK_FAILS(nurbs_face_classify(face_, 2, edited(at, 4, 3, NAN), 0, 0, 0, found),
                NURBS_ERROR_PARAMETER_NOT_FINITE, "params[1]|axis 1");
    CHECK_FAILS(nurbs_face_classify(face_, 2, edited(at, 4, 0, INFINITY), 0, 0, 0, found),
                NURBS_ERROR_PARAMETER_NOT_FINITE, "params[0]|axis 0");
    CHECK_UNTOUCHED(found);
    double shared[2] = {0.5, 0.5};
    CHECK_FAILS(nurbs_face_classify(face_, 1, shared, 0, 0, 0, (int32_t *)(void *)shared),
                NURBS_ERROR_OVERLAP, "sides|params");
}

static void measures(void) {
    double a[9], b[9], c[9];
    FILL(a);
    FILL(b);
    FILL(c);
    CHECK_FAILS(nurbs_face_area(NULL, NAN, a, NULL), NURBS_ERROR_NULL, "face");
    CHECK_FAILS(nurbs_face_area(face_, NAN, NULL, NULL), NURBS_ERROR_NULL, "area");
    CHECK_FAILS(nurbs_face_area(face_, 1, a, a), NURBS_ERROR_OVERLAP, "area|error");
    CHECK_FAILS(nurbs_face_moments(NULL, NAN, a, NULL, NULL, NULL), NURBS_ERROR_NULL, "face");
    CHECK_FAILS(nurbs_face_moments(face_, NAN, NULL, NULL, NULL, NULL), NURBS_ERROR_NULL, "content");
    CHECK_FAILS(nurbs_face_moments(face_, 1, a, b, b + 2, NULL), NURBS_ERROR_OVERLAP, "centroid|inertia");
    CHECK_FAILS(nurbs_face_box(NULL, NAN, a, b, NULL), NURBS_ERROR_NULL, "face");
    CHECK_FAILS(nurbs_face_box(face_, NAN, NULL, b, NULL), NURBS_ERROR_NULL, "lower");
    CHECK_FAILS(nurbs_face_box(face_, NAN, a, NULL, NULL), NURBS_ERROR_NULL, "upper");
    CHECK_FAILS(nurbs_face_box(face_, 1, a, a + 2, NULL), NURBS_ERROR_OVERLAP, "lower|upper");
    CHECK_FAILS(nurbs_face_box(face_, 1, a, b, b), NURBS_ERROR_OVERLAP, "upper|gap");
    const double bad[] = {NAN, -1, -INFINITY};
    for (int i = 0; i < 3; ++i) {
        CHECK_FAILS(nurbs_face_area(face_, bad[i], a, b), NURBS_ERROR_TOLERANCE, "relative_tolerance");
        CHECK_FAILS(nurbs_face_moments(face_, bad[i], a, b, c, NULL), NURBS_ERROR_TOLERANCE,
                    "relative_tolerance");
        CHECK_FAILS(nurbs_face_box(face_, bad[i], a, b, c), NURBS_ERROR_TOLERANCE, "tolerance");
    }
    CHECK_UNTOUCHED(a);
    CHECK_UNTOUCHED(b);
    CHECK_UNTOUCHED(c);
}

int main(void) {
    surface_ = plane();
    outline_ = square(0.125, 0.875);
    hole_ = square(0.25, 0.5);
    face_ = frame_face();
    missing_arguments();
    wrong_numbers();
    wrong_splines();
    wrong_weights();
    wrong_loops();
    edges_off_the_surface();
    parts();
    sides();
    measures();
    nurbs_destroy(surface_);
    nurbs_destroy(outline_);
    nurbs_destroy(hole_);
    nurbs_face_destroy(face_);
    return check_summary("face_refused");
}
