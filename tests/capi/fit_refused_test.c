/* SPDX-License-Identifier: MIT */
/* What nurbs_fit_points() and nurbs_fit() refuse, and their structs. */
#include "fits.h"

#define POINTS_FAIL(change, status, words)                                                                   \
    do {                                                                                                     \
        FitArgs a = line();                                                                                  \
        change;                                                                                              \
        check_fit_fails(__FILE__, __LINE__, a, NULL, status, words);                                         \
    } while (0)
/* And so does nurbs_fit(). */
#define BOTH_FAIL(change, status, words)                                                                     \
    do {                                                                                                     \
        FitArgs a = line();                                                                                  \
        change;                                                                                              \
        check_fit_fails(__FILE__, __LINE__, a, NULL, status, words);                                         \
        check_fit_fails(__FILE__, __LINE__, a, shared, status, words);                                       \
    } while (0)

static void refused_data(void) {
    POINTS_FAIL(a.without_data = 1, NURBS_ERROR_NULL, "data");
    POINTS_FAIL(a.data.struct_size = 8, NURBS_ERROR_OPTIONS, "data|struct_size = 8|96");
    POINTS_FAIL(a.data.struct_size = 5000, NURBS_ERROR_OPTIONS, "data|struct_size = 5000|4096");
    POINTS_FAIL(a.data.struct_size = -1, NURBS_ERROR_OPTIONS, "data|struct_size = -1");
    POINTS_FAIL(a.data.reserved = 3, NURBS_ERROR_OPTIONS, "data|reserved = 3");
    POINTS_FAIL(a.data.n = -1, NURBS_ERROR_COUNT, "n = -1");
    POINTS_FAIL(a.data.axes = 0, NURBS_ERROR_AXES, "axes = 0");
    POINTS_FAIL(a.data.axes = 4, NURBS_ERROR_AXES, "axes = 4");
    POINTS_FAIL(a.data.dim = 0, NURBS_ERROR_DIMENSION, "dim = 0");
    POINTS_FAIL(a.data.dim = INT32_MAX, NURBS_ERROR_DIMENSION, "dim = 2147483647");
    POINTS_FAIL(a.data.params = NULL, NURBS_ERROR_NULL, "params");
    POINTS_FAIL(a.data.values = NULL, NURBS_ERROR_NULL, "values");
    POINTS_FAIL(a.data.param_stride = -1, NURBS_ERROR_STRIDE, "params|stride = -1");
    POINTS_FAIL(a.data.param_component_stride = -2, NURBS_ERROR_STRIDE, "params|stride = -2");
    POINTS_FAIL(a.data.value_stride = -3, NURBS_ERROR_STRIDE, "values|stride = -3");
    POINTS_FAIL(a.data.value_component_stride = -4, NURBS_ERROR_STRIDE, "values|stride = -4");
    POINTS_FAIL((a.data.weights = VALUES(1, 1, 1), a.data.weight_stride = -5), NURBS_ERROR_STRIDE,
                "weights|stride = -5");
    POINTS_FAIL((a.data.dim = 2, a.data.value_stride = 1), NURBS_ERROR_STRIDE, "values|overlap");
    POINTS_FAIL(a.data.n = INT64_C(1) << 53, NURBS_ERROR_OVERFLOW, "params");
    POINTS_FAIL(a.data.value_stride = INT64_MAX / 2, NURBS_ERROR_OVERFLOW, "values");
}

static void refused_flags(void) {
    POINTS_FAIL(a.data.flags = 0x20, NURBS_ERROR_FLAGS, "flags = 0x20|axis 0");
    POINTS_FAIL(a.data.flags = NURBS_ON_AXIS(1, NURBS_CLAMP), NURBS_ERROR_FLAGS, "0x200|1 axes");
    POINTS_FAIL(a.data.flags = NURBS_ACCUMULATE, NURBS_ERROR_FLAGS, "0x1000000");
    POINTS_FAIL(a.data.flags = NURBS_EXTRAPOLATE, NURBS_ERROR_FLAGS, "flags = 0x4|extrapolate");
    POINTS_FAIL(a.data.flags = NURBS_CLAMP | NURBS_WRAP, NURBS_ERROR_FLAGS, "exclude");
}

static void refused_numbers(void) {
    POINTS_FAIL(a.data.params = VALUES(0, NAN, 2), NURBS_ERROR_PARAMETER_NOT_FINITE, "params[1]|nan");
    POINTS_FAIL(a.data.params = VALUES(0, 1, INFINITY), NURBS_ERROR_PARAMETER_NOT_FINITE, "params[2]|inf");
    POINTS_FAIL(a.data.params = VALUES(0, 1, 2.5), NURBS_ERROR_OUTSIDE_DOMAIN, "params[2]|2.5|[0, 2]");
    POINTS_FAIL(a.data.values = VALUES(0, NAN, 1), NURBS_ERROR_POINT_NOT_FINITE, "values[1][0]|nan");
    POINTS_FAIL(a.data.values = VALUES(-INFINITY, 1, 1), NURBS_ERROR_POINT_NOT_FINITE, "values[0][0]|-inf");
    POINTS_FAIL(a.data.weights = VALUES(1, INFINITY, 1), NURBS_ERROR_WEIGHT_NOT_FINITE, "weights[1]|inf");
    POINTS_FAIL(a.data.weights = VALUES(NAN, 1, 1), NURBS_ERROR_WEIGHT_NOT_FINITE, "weights[0]|nan");
    POINTS_FAIL(a.data.weights = VALUES(1, 1, -0.5), NURBS_ERROR_WEIGHT_NEGATIVE, "weights[2] = -0.5");
    POINTS_FAIL(a.data.weights = VALUES(0, 1, 0), NURBS_ERROR_RANK, "control point");
    POINTS_FAIL(a.data.n = 0, NURBS_ERROR_RANK, "control point 0|[0, 2]");
    POINTS_FAIL(a.data.params = VALUES(1, 1, 1), NURBS_ERROR_RANK, "control point");
}

static void refused_knots(const nurbs_statistics *shared) {
    BOTH_FAIL(a.degrees = NULL, NURBS_ERROR_NULL, "degrees");
    BOTH_FAIL(a.counts = NULL, NURBS_ERROR_NULL, "counts");
    BOTH_FAIL(a.knots = NULL, NURBS_ERROR_NULL, "knots");
    BOTH_FAIL(a.degrees = DEGREES(-1), NURBS_ERROR_DEGREE, "degrees[0] = -1");
    BOTH_FAIL(a.degrees = DEGREES(32), NURBS_ERROR_DEGREE, "degrees[0] = 32");
    BOTH_FAIL(a.counts = COUNTS(-1), NURBS_ERROR_COUNT, "counts[0] = -1");
    BOTH_FAIL(a.counts = COUNTS(1), NURBS_ERROR_TOO_FEW_POINTS, "counts[0] = 1|2");
    BOTH_FAIL(a.counts = COUNTS(INT64_MAX), NURBS_ERROR_OVERFLOW, "knots");
    BOTH_FAIL(a.knot_count = 5, NURBS_ERROR_SIZE, "knot_count = 5|4");
    BOTH_FAIL(a.flags = 2, NURBS_ERROR_FLAGS, "flags = 0x2");
    BOTH_FAIL(a.flags = NURBS_ON_AXIS(1, NURBS_PERIODIC), NURBS_ERROR_FLAGS, "0x100|1 axes");
    BOTH_FAIL(a.knots = VALUES(0, 0, NAN, 2), NURBS_ERROR_KNOT_NOT_FINITE, "knots[2]|nan");
    BOTH_FAIL(a.knots = VALUES(0, 1, 0, 2), NURBS_ERROR_KNOTS_DECREASING, "knots[2] = 0|knots[1] = 1");
    BOTH_FAIL((a.counts = COUNTS(3), a.knot_count = 5, a.knots = VALUES(0, 0, 0, 2, 2)),
              NURBS_ERROR_END_MULTIPLICITY, "knot|2");
    BOTH_FAIL((a.counts = COUNTS(5), a.knot_count = 7, a.knots = VALUES(0, 0, 1, 1, 1, 2, 2)),
              NURBS_ERROR_MULTIPLICITY, "1|2");
    BOTH_FAIL(a.knots = VALUES(-1, 0, 0, 2), NURBS_ERROR_EMPTY_DOMAIN, "0");
    BOTH_FAIL((a.flags = NURBS_PERIODIC, a.counts = COUNTS(3), a.knot_count = 5,
               a.knots = VALUES(-1, 0, 1, 2, 3.5)),
              NURBS_ERROR_PERIODIC_KNOTS, "knots");
    CHECK_FAILS(nurbs_fit_points(NULL, NULL, NULL, NULL, 0, 0, NULL, NULL, NULL), NURBS_ERROR_NULL, "out");
    CHECK_FAILS(nurbs_fit(shared, NULL, NULL, NULL, 0, 0, NULL, NULL, NULL), NURBS_ERROR_NULL, "out");
}

static void refused_options(const nurbs_statistics *shared) {
    BOTH_FAIL(a.options.struct_size = 0, NURBS_ERROR_OPTIONS, "options|struct_size = 0|112");
    BOTH_FAIL(a.options.struct_size = 4097, NURBS_ERROR_OPTIONS, "options|struct_size = 4097");
    BOTH_FAIL(a.options.smoothing = 5, NURBS_ERROR_RULE, "smoothing = 5");
    BOTH_FAIL(a.options.smoothing = -1, NURBS_ERROR_RULE, "smoothing = -1");
    BOTH_FAIL(a.options.penalty_order = 0, NURBS_ERROR_ORDER, "penalty_order = 0");
    BOTH_FAIL(a.options.smoothing = NURBS_SMOOTHING_GCV, NURBS_ERROR_ORDER, "penalty_order = 2|1");
    BOTH_FAIL(a.options.lambda = -1, NURBS_ERROR_FACTOR, "lambda = -1");
    BOTH_FAIL(a.options.lambda = INFINITY, NURBS_ERROR_FACTOR, "lambda = inf");
    BOTH_FAIL(a.options.target = -2, NURBS_ERROR_FACTOR, "target = -2");
    BOTH_FAIL(a.options.target = NAN, NURBS_ERROR_FACTOR, "target|nan");
    BOTH_FAIL(a.options.regularize = 2, NURBS_ERROR_OPTIONS, "regularize = 2");
    BOTH_FAIL(a.options.regularize = -1, NURBS_ERROR_OPTIONS, "regularize = -1");
    BOTH_FAIL(a.options.reserved = 1, NURBS_ERROR_OPTIONS, "options|reserved = 1");
    BOTH_FAIL(a.report.struct_size = 8, NURBS_ERROR_OPTIONS, "report|struct_size = 8|104");
    BOTH_FAIL(a.report.struct_size = 1 << 20, NURBS_ERROR_OPTIONS, "report|struct_size = 1048576");
}

#define CONDITIONS(many, at, order, target)                                                                  \
    (a.options.conditions = (many), a.options.condition_params = (at), a.options.condition_orders = (order), \
     a.options.condition_targets = (target))

static void refused_conditions(const nurbs_statistics *shared) {
    const double *two = VALUES(0, 1);
    BOTH_FAIL(CONDITIONS(-1, two, NULL, two), NURBS_ERROR_COUNT, "conditions = -1");
    BOTH_FAIL(CONDITIONS(1, NULL, NULL, two), NURBS_ERROR_NULL, "condition_params");
    BOTH_FAIL(CONDITIONS(1, two, NULL, NULL), NURBS_ERROR_NULL, "condition_targets");
    BOTH_FAIL(CONDITIONS(2, VALUES(0, NAN), NULL, two), NURBS_ERROR_PARAMETER_NOT_FINITE,
              "condition_params[1][0]|nan");
    BOTH_FAIL(CONDITIONS(2, VALUES(0, 3), NULL, two), NURBS_ERROR_OUTSIDE_DOMAIN,
              "condition_params[1][0] = 3|[0, 2]");
    BOTH_FAIL(CONDITIONS(2, two, DEGREES(0, 2), two), NURBS_ERROR_ORDER, "condition_orders[1][0] = 2|1");
    BOTH_FAIL(CONDITIONS(2, two, DEGREES(-1, 0), two), NURBS_ERROR_ORDER, "condition_orders[0][0] = -1");
    BOTH_FAIL(CONDITIONS(2, two, NULL, VALUES(0, INFINITY)), NURBS_ERROR_POINT_NOT_FINITE,
              "condition_targets[1][0]|inf");
    BOTH_FAIL(CONDITIONS(2, VALUES(1, 1), NULL, VALUES(1, 1.5)), NURBS_ERROR_CONTRADICTION, "conditions[1]");
    BOTH_FAIL(CONDITIONS(3, VALUES(0, 1, 2), NULL, VALUES(0, 1, 3)), NURBS_ERROR_CONTRADICTION,
              "conditions[2]");
}

/* Structs of newer headers: what this library does not know has to be 0. */
static void newer_structs(void) {
    struct {
        nurbs_data known;
        int64_t more;
    } data;
    struct {
        nurbs_fit_options known;
        int64_t more;
    } options;
    FitArgs a = line();
    nurbs *g = NULL;
    memset(&data, 0, sizeof data);
    memset(&options, 0, sizeof options);
    data.known = a.data;
    data.known.struct_size = sizeof data;
    options.known = a.options;
    options.known.struct_size = sizeof options;
    CHECK_OK(nurbs_fit_points(&data.known, a.degrees, a.counts, a.knots, 4, 0, &options.known, NULL, &g));
    CHECK_POINTS_NEAR(g, VALUES(1 / 6.0, 7 / 6.0), 1e-15);
    nurbs_destroy(g);
    options.more = 1;
    CHECK_NO_HANDLE(
        g, nurbs_fit_points(&data.known, a.degrees, a.counts, a.knots, 4, 0, &options.known, NULL, &g),
        NURBS_ERROR_OPTIONS, "options|unknown");
    data.more = 1;
    CHECK_NO_HANDLE(g, nurbs_fit_points(&data.known, a.degrees, a.counts, a.knots, 4, 0, NULL, NULL, &g),
                    NURBS_ERROR_OPTIONS, "data|unknown");
}

static void structs(void) {
    nurbs_data data;
    nurbs_fit_options options;
    CHECK_FAILS(nurbs_data_init(NULL, sizeof data), NURBS_ERROR_NULL, "data");
    CHECK_FAILS(nurbs_data_init(&data, 8), NURBS_ERROR_OPTIONS, "struct_size = 8");
    CHECK_FAILS(nurbs_data_init(&data, 4097), NURBS_ERROR_OPTIONS, "struct_size = 4097");
    CHECK_FAILS(nurbs_fit_options_init(NULL, sizeof options), NURBS_ERROR_NULL, "options");
    CHECK_FAILS(nurbs_fit_options_init(&options, -8), NURBS_ERROR_OPTIONS, "struct_size = -8");
    memset(&data, 0x5a, sizeof data);
    memset(&options, 0x5a, sizeof options);
    CHECK_OK(nurbs_data_init(&data, sizeof data));
    CHECK_OK(nurbs_fit_options_init(&options, sizeof options));
    CHECK(data.n == 0 && data.axes == 0 && data.dim == 0 && data.params == NULL && data.values == NULL);
    CHECK(data.weights == NULL && data.weight_stride == 0 && data.flags == 0 && data.reserved == 0);
    CHECK(options.smoothing == NURBS_SMOOTHING_NONE && options.penalty_order == 2 && options.lambda == 0);
    CHECK(options.target == 0 && options.regularize == 0 && options.reserved == 0);
    CHECK(options.conditions == 0 && options.condition_params == NULL && options.condition_orders == NULL &&
          options.condition_targets == NULL);
    CHECK(options.robust == NURBS_ROBUST_NONE && options.reserved2 == 0 && options.robust_width == 0);
    CHECK(options.shapes == NULL && options.lower == NULL && options.upper == NULL);
}

/* Arrays that no memory holds are refused before they are looked at. */
static void endless_conditions(const nurbs_statistics *shared) {
    BOTH_FAIL(CONDITIONS(INT64_MAX, VALUES(0), NULL, VALUES(0)), NURBS_ERROR_OVERFLOW, "condition");
}

int main(void) {
    nurbs_statistics *shared = statistics_of_line();
    refused_data();
    refused_flags();
    refused_numbers();
    refused_knots(shared);
    refused_options(shared);
    refused_conditions(shared);
    newer_structs();
    structs();
    endless_conditions(shared);
    nurbs_statistics_destroy(shared);
    return check_summary("fit_refused");
}
