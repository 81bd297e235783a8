/* SPDX-License-Identifier: MIT */
/* nurbs_cloud_start() and nurbs_fit_cloud(): what they find, what they tell, and what they refuse. */
#include "fits.h"

enum { rim = 400 };

typedef struct CloudArgs {
    const nurbs *start;
    int64_t n;
    const double *points;
    int64_t point_stride, point_component_stride;
    const double *weights;
    int64_t weight_stride;
    nurbs_cloud_options options;
    nurbs_cloud_report report;
} CloudArgs;

static nurbs_cloud_report unwritten_cloud(void) {
    nurbs_cloud_report report;
    memset(&report, 0x5a, sizeof report);
    report.struct_size = sizeof report;
    return report;
}

static CloudArgs cloud_args(const nurbs *start, int64_t n, const double *points) {
    CloudArgs a;
    memset(&a, 0, sizeof a);
    a.start = start;
    a.n = n;
    a.points = points;
    CHECK_OK(nurbs_cloud_options_init(&a.options, sizeof a.options));
    a.report = unwritten_cloud();
    return a;
}

static nurbs_status fit_of_cloud(CloudArgs *a, const nurbs_call_options *call, nurbs **out) {
    return nurbs_fit_cloud_with(a->start, a->n, a->points, a->point_stride, a->point_component_stride,
                                a->weights, a->weight_stride, &a->options, &a->report, call, out);
}

static nurbs *fitted_cloud(CloudArgs *a) {
    nurbs *out = NULL;
    CHECK_OK(fit_of_cloud(a, NULL, &out));
    return out;
}

/* --- Starts --- */

typedef struct StartArgs {
    int32_t axes;
    const int32_t *degrees;
    const int64_t *counts;
    const double *knots;
    int64_t knot_count, n;
    int32_t dim;
    const double *points;
    int64_t point_stride, point_component_stride;
    uint32_t flags;
} StartArgs;

static nurbs_status start_of(const StartArgs *a, nurbs **out) {
    return nurbs_cloud_start(a->axes, a->degrees, a->counts, a->knots, a->knot_count, a->n, a->dim, a->points,
                             a->point_stride, a->point_component_stride, a->flags, out);
}

static nurbs *started(StartArgs a) {
    nurbs *out = NULL;
    CHECK_OK(start_of(&a, &out));
    return out;
}

static const double even_knots[] = {0, 0, 0, 0, 1, 2, 2, 2, 2}, line_points[] = {4, 1, 0, 1, 1, 1, 3, 1};

/* A cubic of five control points. */
static StartArgs curve_start(int64_t n, int32_t dim, const double *points) {
    static const int32_t cubic[] = {3, 3};
    static const int64_t five[] = {5, 5};
    const StartArgs a = {1, cubic, five, even_knots, 9, n, dim, points, 0, 0, 0};
    return a;
}

/* Over twelve even spans. */
static StartArgs ring_start(int64_t n, const double *points) {
    static double knots[19];
    static const int64_t fifteen = 15;
    for (int i = 0; i < 19; ++i) {
        knots[i] = i;
    }
    StartArgs a = curve_start(n, 2, points);
    a.counts = &fifteen;
    a.knots = knots;
    a.knot_count = 19;
    a.flags = NURBS_PERIODIC;
    return a;
}

static void a_line(void) {
    nurbs *g = started(curve_start(4, 2, line_points));
    double at[2];
    for (int i = 0; i <= 8; ++i) {
        CHECK_OK(nurbs_eval(g, 1, VALUES(i / 4.0), 0, 0, at, 0, 0, 0));
        CHECK_NEAR(at, VALUES(i / 2.0, 1), 2, 1e-15);
    }
    nurbs_destroy(g);
}

static void fill_rim(double a, double b, double *points) {
    for (int i = 0; i < rim; ++i) {
        const double angle = 2 * 3.14159265358979323846 * i / rim;
        points[2 * i] = 10 + a * cos(angle);
        points[2 * i + 1] = 20 + b * sin(angle);
    }
}

static void an_ellipse(void) {
    double points[2 * rim], distance[1];
    fill_rim(3, 2, points);
    nurbs *g = started(ring_start(rim, points));
    for (int i = 0; i < rim; ++i) { /* the curve is less than its polygon: cos(30 degrees) makes a ninth */
        CHECK_OK(nurbs_closest_points(g, 1, points + 2 * i, 0, 0, NULL, 0, 0, NULL, 0, 0, NULL, 0, 0,
                                      distance, 0, NULL, 0));
        CHECK(distance[0] < 0.4);
    }
    nurbs_destroy(g);
}

/* Around the third direction, since the points are equally far from no other. */
static void a_cylinder(void) {
    static double knots[19 + 9], points[3 * rim];
    static const int64_t counts[] = {15, 5};
    for (int i = 0; i < rim; ++i) {
        points[3 * i] = cos(0.1 * i);
        points[3 * i + 1] = 9 * (i % 20) / 19.0;
        points[3 * i + 2] = sin(0.1 * i);
    }
    StartArgs a = ring_start(rim, points);
    memcpy(knots, a.knots, 19 * sizeof *knots);
    memcpy(knots + 19, even_knots, sizeof even_knots);
    a.axes = 2;
    a.counts = counts;
    a.knots = knots;
    a.knot_count = 28;
    a.dim = 3;
    nurbs *g = started(a);
    double at[3];
    for (int i = 0; i < 12; ++i) {
        CHECK_OK(nurbs_eval(g, 1, VALUES(3 + i, i / 6.0), 0, 0, at, 0, 0, 0));
        CHECK(fabs(at[0] * at[0] + at[2] * at[2] - 1) < 0.25);
        CHECK(at[1] > -0.3 && at[1] < 9.3);
    }
    nurbs_destroy(g);
    a.flags = NURBS_ON_AXIS(1, NURBS_PERIODIC);
    nurbs *out = NULL;
    CHECK_NO_HANDLE(out, start_of(&a, &out), NURBS_ERROR_PERIODIC_KNOTS, "axis 1");
}

#define START_FAILS(change, status, words)                                                                   \
    do {                                                                                                     \
        StartArgs a = curve_start(4, 2, line_points);                                                        \
        change;                                                                                              \
        nurbs *out_ = NULL;                                                                                  \
        CHECK_NO_HANDLE(out_, start_of(&a, &out_), status, words);                                           \
    } while (0)

static void refused_starts(void) {
    StartArgs good = curve_start(4, 2, line_points);
    CHECK_FAILS(start_of(&good, NULL), NURBS_ERROR_NULL, "out");
    START_FAILS(a.axes = 0, NURBS_ERROR_AXES, "axes = 0");
    START_FAILS(a.axes = 4, NURBS_ERROR_AXES, "axes = 4");
    START_FAILS(a.degrees = NULL, NURBS_ERROR_NULL, "degrees");
    START_FAILS(a.degrees = DEGREES(32), NURBS_ERROR_DEGREE, "degrees[0] = 32");
    START_FAILS(a.counts = NULL, NURBS_ERROR_NULL, "counts");
    START_FAILS(a.counts = COUNTS(3), NURBS_ERROR_TOO_FEW_POINTS, "counts[0] = 3|4");
    START_FAILS(a.knots = NULL, NURBS_ERROR_NULL, "knots");
    START_FAILS(a.knot_count = 8, NURBS_ERROR_SIZE, "knot_count = 8|9");
    START_FAILS(a.knots = VALUES(0, 0, 0, 0, NAN, 2, 2, 2, 2), NURBS_ERROR_KNOT_NOT_FINITE, "knots[4]|nan");
    START_FAILS(a.n = 0, NURBS_ERROR_COUNT, "n = 0|1");
    START_FAILS(a.n = -3, NURBS_ERROR_COUNT, "n = -3");
    START_FAILS(a.dim = 0, NURBS_ERROR_DIMENSION, "dim = 0");
    START_FAILS(a.dim = 1, NURBS_ERROR_DIMENSION, "dim = 1|more than 1");
    START_FAILS(a.points = NULL, NURBS_ERROR_NULL, "points");
    START_FAILS(a.points = VALUES(0, 0, 1, 1, 2, INFINITY, 3, 3), NURBS_ERROR_POINT_NOT_FINITE,
                "points[2][1]|inf");
    START_FAILS(a.point_stride = -1, NURBS_ERROR_STRIDE, "points|stride = -1");
    START_FAILS(a.flags = 4, NURBS_ERROR_FLAGS, "flags = 0x4");
    START_FAILS(a.flags = NURBS_PERIODIC, NURBS_ERROR_PERIODIC_KNOTS, "axis 0");
    static const double loops[] = {0, 1, 2, 3, 4, 5, 6, 0, 1, 2, 3, 4, 5, 6};
    StartArgs torus = {2,
                       DEGREES(1, 1),
                       COUNTS(5, 5),
                       loops,
                       14,
                       3,
                       3,
                       VALUES(0, 0, 0, 1, 1, 1, 2, 3, 4),
                       0,
                       0,
                       NURBS_ON_ALL_AXES(2, NURBS_PERIODIC)};
    nurbs *out = NULL;
    CHECK_NO_HANDLE(out, start_of(&torus, &out), NURBS_ERROR_FLAGS, "2 periodic axes of 2");
}

/* --- Fits --- */

/* The report agrees with the distances of the result. */
static void check_cloud_report(const CloudArgs *a, const nurbs *g) {
    double largest = 0, squares = 0, weight = 0, at = -1;
    int64_t boundary = 0, count = 0;
    for (int64_t i = 0; i < a->n; ++i) {
        const double w = a->weights == NULL ? 1 : a->weights[i];
        double distance = 0;
        int32_t status = 0;
        if (w == 0) {
            continue;
        }
        CHECK_OK(nurbs_closest_points(g, 1, a->points + 2 * i, 0, 0, NULL, 0, 0, NULL, 0, 0, NULL, 0, 0,
                                      &distance, 0, &status, 0));
        at = i == a->report.largest_index ? distance : at;
        largest = fmax(largest, distance);
        squares += w * distance * distance;
        weight += w;
        boundary += (status & NURBS_CLOSEST_BOUNDARY) != 0;
        ++count;
    }
    CHECK_INT(a->report.data_count, count);
    CHECK_NEAR(&a->report.weight, &weight, 1, 1e-12 * weight);
    CHECK_NEAR(&a->report.squares, &squares, 1, 1e-9 * squares + 1e-25);
    CHECK_NEAR(&a->report.rms, VALUES(sqrt(squares / weight)), 1, 1e-9 * largest + 1e-13);
    CHECK_NEAR(&a->report.largest, &largest, 1, 2 * a->report.noise);
    CHECK(a->report.noise > 0 && a->report.noise < 1e-9);
    CHECK_INT(a->report.boundary, boundary);
    CHECK_INT(a->report.uncertified, 0);
    CHECK_NEAR(&at, &largest, 1, 2 * a->report.noise);
}

static void a_ring(void) {
    double points[2 * rim];
    fill_rim(3, 2, points);
    nurbs *start = started(ring_start(rim, points));
    CloudArgs a = cloud_args(start, rim, points);
    nurbs *g = fitted_cloud(&a);
    CHECK(a.report.largest < 5e-3);
    CHECK(a.report.lambda > 0);
    CHECK_INT(a.report.bits, 0);
    check_cloud_report(&a, g);
    int32_t periodic = 0;
    CHECK_OK(nurbs_detect_periodic(g, 0, &periodic));
    CHECK_INT(periodic, 1);
    nurbs_destroy(g);
    nurbs_destroy(start);
}

/* What they are does not count, and neither does the order of the others. */
static void points_without_weight(void) {
    const double points[] = {0, 0, 1, 1, 2, 1, NAN, INFINITY, 3, 0, 4, 1, 5, 3},
                 turned[] = {5, 3, 4, 1, 3, 0, 2, 1, 1, 1, 0, 0};
    const double weights[] = {1, 2, 1, 0, 1, 1, 2}, turned_weights[] = {2, 1, 1, 1, 2, 1};
    nurbs *start = started(curve_start(6, 2, turned));
    CloudArgs a = cloud_args(start, 7, points), b = cloud_args(start, 6, turned);
    a.weights = weights;
    b.weights = turned_weights;
    nurbs *g = fitted_cloud(&a), *same = fitted_cloud(&b);
    double values[10], others[10];
    CHECK_INT(few_points(__FILE__, __LINE__, g, values), 10);
    CHECK_INT(few_points(__FILE__, __LINE__, same, others), 10);
    CHECK_BITS(values, others, sizeof values);
    check_cloud_report(&a, g);
    CHECK(a.report.squares == b.report.squares && a.report.largest == b.report.largest);
    nurbs_destroy(g);
    nurbs_destroy(same);
    nurbs_destroy(start);
}

/* With NULL for what may be left out. */
static void with_defaults(void) {
    nurbs *start = started(curve_start(4, 2, line_points)), *g = NULL, *same = NULL;
    const double points[] = {0, 0, 1, 1, 2, 1, 4, 0};
    CloudArgs a = cloud_args(start, 4, points);
    double values[10], others[10];
    same = fitted_cloud(&a);
    CHECK_OK(nurbs_fit_cloud(start, 4, points, 0, 0, NULL, 0, NULL, NULL, &g));
    CHECK_INT(few_points(__FILE__, __LINE__, g, values), few_points(__FILE__, __LINE__, same, others));
    CHECK_BITS(values, others, sizeof values);
    nurbs_destroy(g);
    nurbs_destroy(same);
    nurbs_destroy(start);
}

/* Fewer points than control points, on a line, and all in one place. */
static void little_to_go_by(void) {
    static const double one[] = {3, 3, 3, 3, 3, 3}, line[] = {0, 0, 1, 2, 3, 6, 7, 14};
    nurbs *start = started(curve_start(4, 2, line)), *bent = make(arch());
    nurbs *const starts[] = {start, bent};
    for (int s = 0; s < 2; ++s) {
        const double *const clouds[] = {one, line, VALUES(0, 0, 1, 1, 5, 0)};
        const int64_t counts[] = {3, 4, 3};
        for (int c = 0; c < 3; ++c) {
            CloudArgs a = cloud_args(starts[s], counts[c], clouds[c]);
            nurbs *g = fitted_cloud(&a);
            check_cloud_report(&a, g);
            CHECK(a.report.largest < (c == 2 ? 0.1 : 1e-6));
            nurbs_destroy(g);
        }
    }
    nurbs_destroy(start);
    nurbs_destroy(bent);
}

static void rounds_end(void) {
    double points[2 * rim];
    fill_rim(3, 1, points);
    nurbs *start = started(ring_start(rim, points));
    CloudArgs a = cloud_args(start, rim, points);
    a.options.rounds = 2;
    nurbs *g = fitted_cloud(&a);
    CHECK_INT(a.report.rounds, 2);
    CHECK_INT(a.report.bits, NURBS_CLOUD_NOT_CONVERGED);
    check_cloud_report(&a, g);
    nurbs_destroy(g);
    nurbs_destroy(start);
}

/* A large factor of the penalty makes a line of it. */
static void a_factor(void) {
    static const double points[] = {0, 0, 1, 1, 2, 1, 3, 0, 4, 0.5, 5, 1, 6, 0, 7, 1};
    nurbs *start = started(curve_start(8, 2, points));
    CloudArgs a = cloud_args(start, 8, points);
    a.options.lambda = 1e6;
    nurbs *g = fitted_cloud(&a);
    double bend[6];
    CHECK(a.report.lambda == 1e6);
    CHECK_OK(nurbs_eval_derivs(g, 2, 1, VALUES(1), 0, 0, bend, 0, 0, 0));
    CHECK(fabs(bend[4]) < 1e-5 && fabs(bend[5]) < 1e-5);
    nurbs_destroy(g);
    nurbs_destroy(start);
}

/* A start that meets all points is not the minimum with a penalty. */
static void a_factor_for_an_exact_start(void) {
    static const double points[] = {0, 0, 1, 1, 2, 0, 3, 2};
    nurbs *start = NULL;
    CHECK_OK(nurbs_create(1, DEGREES(1), COUNTS(4), VALUES(0, 0, 1, 2, 3, 3), 6, 2, points, 0, 0, NULL, 0, 0,
                          &start));
    CloudArgs a = cloud_args(start, 4, points);
    a.options.penalty_order = 1;
    a.options.lambda = 0.1;
    nurbs *g = fitted_cloud(&a);
    CHECK(a.report.squares > 1e-6 && a.report.rounds > 1);
    CHECK_DOUBLE(a.report.lambda, 0.1);
    nurbs_destroy(g);
    a.options.lambda = 0;
    g = fitted_cloud(&a);
    CHECK_DOUBLE(a.report.lambda, 0);
    CHECK(a.report.squares < 1e-20);
    nurbs_destroy(g);
    nurbs_destroy(start);
}

/* --- What is refused --- */

#define CLOUD_FAILS(change, status, words)                                                                   \
    do {                                                                                                     \
        CloudArgs a = cloud_args(start, 4, line_points);                                                     \
        change;                                                                                              \
        const CloudArgs before = a;                                                                          \
        nurbs *out_ = NULL;                                                                                  \
        CHECK_NO_HANDLE(out_, fit_of_cloud(&a, NULL, &out_), status, words);                                 \
        CHECK(memcmp(&a, &before, sizeof a) == 0);                                                           \
    } while (0)

static void refused(const nurbs *start) {
    nurbs *rational = make(circle()), *flat = make(hill());
    CHECK_FAILS(nurbs_fit_cloud(start, 4, line_points, 0, 0, NULL, 0, NULL, NULL, NULL), NURBS_ERROR_NULL,
                "out");
    CLOUD_FAILS(a.start = NULL, NURBS_ERROR_NULL, "g");
    CLOUD_FAILS(a.start = rational, NURBS_ERROR_RATIONAL, "rational");
    CLOUD_FAILS(a.start = flat, NURBS_ERROR_DIMENSION, "dim = 1|more than 1");
    CLOUD_FAILS(a.n = 0, NURBS_ERROR_COUNT, "n = 0|1");
    CLOUD_FAILS(a.n = -1, NURBS_ERROR_COUNT, "n = -1");
    CLOUD_FAILS(a.n = INT64_C(1) << 53, NURBS_ERROR_OVERFLOW, "points");
    CLOUD_FAILS(a.points = NULL, NURBS_ERROR_NULL, "points");
    CLOUD_FAILS(a.point_stride = -2, NURBS_ERROR_STRIDE, "points|stride = -2");
    CLOUD_FAILS(a.points = VALUES(0, 0, 1, NAN, 2, 2, 3, 3), NURBS_ERROR_POINT_NOT_FINITE,
                "points[1][1]|nan");
    CLOUD_FAILS(a.points = VALUES(0, 0, 1, 1, -INFINITY, 2, 3, 3), NURBS_ERROR_POINT_NOT_FINITE,
                "points[2][0]|-inf");
    CLOUD_FAILS(a.weights = VALUES(1, NAN, 1, 1), NURBS_ERROR_WEIGHT_NOT_FINITE, "weights[1]|nan");
    CLOUD_FAILS(a.weights = VALUES(1, 1, 1, -0.5), NURBS_ERROR_WEIGHT_NEGATIVE, "weights[3] = -0.5");
    CLOUD_FAILS(a.weights = VALUES(0, 0, 0, 0), NURBS_ERROR_COUNT, "no point counts");
    CLOUD_FAILS((a.weights = VALUES(1, 1, 1, 1), a.weight_stride = -1), NURBS_ERROR_STRIDE, "weights|-1");
    CLOUD_FAILS(a.options.struct_size = 8, NURBS_ERROR_OPTIONS, "options|struct_size = 8");
    CLOUD_FAILS(a.options.penalty_order = 0, NURBS_ERROR_ORDER, "penalty_order = 0");
    CLOUD_FAILS(a.options.rounds = 0, NURBS_ERROR_COUNT, "rounds = 0|1");
    CLOUD_FAILS(a.options.lambda = NAN, NURBS_ERROR_FACTOR, "lambda|nan");
    CLOUD_FAILS(a.options.first_lambda = INFINITY, NURBS_ERROR_FACTOR, "first_lambda|inf");
    CLOUD_FAILS(a.options.tolerance = -1, NURBS_ERROR_TOLERANCE, "tolerance = -1");
    CLOUD_FAILS(a.options.tolerance = NAN, NURBS_ERROR_TOLERANCE, "tolerance|nan");
    CLOUD_FAILS(a.report.struct_size = 8, NURBS_ERROR_OPTIONS, "report|struct_size = 8");
    CHECK_FAILS(nurbs_cloud_options_init(NULL, sizeof(nurbs_cloud_options)), NURBS_ERROR_NULL, "options");
    nurbs_cloud_options options;
    CHECK_FAILS(nurbs_cloud_options_init(&options, 4), NURBS_ERROR_OPTIONS, "struct_size = 4");
    nurbs_destroy(rational);
    nurbs_destroy(flat);
}

static void watched(void) {
    enum { many = 40000 };
    double *points = (double *)malloc(2 * many * sizeof(double));
    for (int i = 0; i < many; ++i) {
        points[2 * i] = cos(1e-3 * i) + 1e-2 * (i * 7919 % 1000) / 1000;
        points[2 * i + 1] = sin(1e-3 * i);
    }
    nurbs *start = started(ring_start(many, points)), *g = NULL;
    FitWatcher w = {0, 0, 0, 0};
    nurbs_call_options call = watched_by(&w, 0);
    CloudArgs a = cloud_args(start, many, points), b = a;
    nurbs *plain = fitted_cloud(&a);
    CHECK_OK(fit_of_cloud(&b, &call, &g));
    CHECK(w.calls > 0 && w.wrong == 0);
    CHECK(a.report.squares == b.report.squares && a.report.rounds == b.report.rounds);
    nurbs_destroy(plain);
    nurbs_destroy(g);
    b.report = unwritten_cloud();
    const nurbs_cloud_report before = b.report;
    w = (FitWatcher){0, 0, 1, 0};
    CHECK_NO_HANDLE(g, fit_of_cloud(&b, &call, &g), NURBS_ERROR_CANCELLED, "progress|1");
    CHECK_INT(w.calls, 1);
    for (int64_t work = 100; work < 100000000; work *= 60) {
        call = watched_by(NULL, work);
        CHECK_NO_HANDLE(g, fit_of_cloud(&b, &call, &g), NURBS_ERROR_WORK, "work");
    }
    CHECK(memcmp(&before, &b.report, sizeof before) == 0);
    nurbs_destroy(start);
    free(points);
}

int main(void) {
    a_line();
    an_ellipse();
    a_cylinder();
    refused_starts();
    a_ring();
    points_without_weight();
    with_defaults();
    little_to_go_by();
    rounds_end();
    a_factor();
    a_factor_for_an_exact_start();
    nurbs *start = started(curve_start(4, 2, line_points));
    refused(start);
    nurbs_destroy(start);
    watched();
    return check_summary("cloud");
}
