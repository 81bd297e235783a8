/* SPDX-License-Identifier: MIT */
/* What nurbs_fit_tolerance() refuses. */
#include "fits.h"

static ToleranceArgs good(void) {
    static double params[30], values[30];
    for (int i = 0; i < 30; ++i) {
        params[i] = i / 29.0;
        values[i] = sin(9 * params[i]);
    }
    return tolerance_args(data_of(1, 1, 30, params, values), 1e-2);
}

static void check_fails(int line, ToleranceArgs a, nurbs_status status, const char *words) {
    ToleranceArgs before;
    nurbs *out = check_poison();
    memcpy(&before, &a, sizeof a);
    check_forget();
    check_refusal(__FILE__, line, tolerance_fit(&a, NULL, &out), status, words);
    check_true(__FILE__, line, out == NULL, "out == NULL");
    check_true(__FILE__, line, memcmp(&before, &a, sizeof a) == 0, "the arguments are what they were");
}
#define FAILS(change, status, words)                                                                         \
    do {                                                                                                     \
        ToleranceArgs a = good();                                                                            \
        change;                                                                                              \
        check_fails(__LINE__, a, status, words);                                                             \
    } while (0)

static void refused_arguments(void) {
    FAILS(a.without_data = 1, NURBS_ERROR_NULL, "data");
    FAILS(a.degrees = NULL, NURBS_ERROR_NULL, "degrees");
    CHECK_FAILS(nurbs_fit_tolerance(NULL, NULL, NULL, 0, 0, 0, NULL, NULL, NULL), NURBS_ERROR_NULL, "out");
    FAILS(a.degrees = DEGREES(32), NURBS_ERROR_DEGREE, "degrees[0] = 32");
    FAILS(a.degrees = DEGREES(-1), NURBS_ERROR_DEGREE, "degrees[0] = -1");
    FAILS(a.tolerance = -1e-3, NURBS_ERROR_TOLERANCE, "tolerance = -0.001");
    FAILS(a.tolerance = NAN, NURBS_ERROR_TOLERANCE, "tolerance|nan");
    FAILS(a.max_count = -1, NURBS_ERROR_COUNT, "max_count = -1");
    FAILS(a.max_count = 3, NURBS_ERROR_TOO_FEW_POINTS, "max_count = 3|4");
    FAILS(a.flags = 2, NURBS_ERROR_FLAGS, "flags = 0x2");
    FAILS(a.flags = NURBS_ON_AXIS(1, NURBS_PERIODIC), NURBS_ERROR_FLAGS, "0x100|1 axes");
    FAILS(a.domain = VALUES(1, 1), NURBS_ERROR_EMPTY_DOMAIN, "domain[0] = [1, 1]");
    FAILS(a.domain = VALUES(1, 0), NURBS_ERROR_EMPTY_DOMAIN, "domain[0] = [1, 0]");
    FAILS(a.domain = VALUES(0, NAN), NURBS_ERROR_EMPTY_DOMAIN, "domain[0]|nan");
    FAILS(a.domain = VALUES(-INFINITY, 1), NURBS_ERROR_EMPTY_DOMAIN, "domain[0]|-inf");
    FAILS(a.domain = VALUES(-1e308, 1e308), NURBS_ERROR_EMPTY_DOMAIN, "domain[0]|1e+308");
    FAILS(a.data.n = 1, NURBS_ERROR_EMPTY_DOMAIN, "domain[0] = [0, 0]");
}

static void refused_layouts(void) {
    FAILS(a.data.struct_size = 95, NURBS_ERROR_OPTIONS, "data|struct_size = 95");
    FAILS(a.data.reserved = 9, NURBS_ERROR_OPTIONS, "data|reserved = 9");
    FAILS(a.data.n = 0, NURBS_ERROR_COUNT, "n = 0|1");
    FAILS(a.data.n = -1, NURBS_ERROR_COUNT, "n = -1");
    FAILS(a.data.axes = 4, NURBS_ERROR_AXES, "axes = 4");
    FAILS(a.data.dim = 0, NURBS_ERROR_DIMENSION, "dim = 0");
    FAILS(a.data.params = NULL, NURBS_ERROR_NULL, "params");
    FAILS(a.data.values = NULL, NURBS_ERROR_NULL, "values");
    FAILS(a.data.param_stride = -1, NURBS_ERROR_STRIDE, "params|-1");
    FAILS(a.data.value_component_stride = -1, NURBS_ERROR_STRIDE, "values|-1");
    FAILS(a.data.n = INT64_MAX, NURBS_ERROR_OVERFLOW, "params");
    FAILS(a.data.flags = NURBS_EXTRAPOLATE, NURBS_ERROR_FLAGS, "flags = 0x4");
    FAILS(a.data.flags = 0x40, NURBS_ERROR_FLAGS, "0x40|axis 0");
}

static void refused_numbers(void) {
    FAILS(a.data.params = edited(a.data.params, 30, 4, NAN), NURBS_ERROR_PARAMETER_NOT_FINITE,
          "params[4]|nan");
    FAILS(a.data.params = edited(a.data.params, 30, 0, -INFINITY), NURBS_ERROR_PARAMETER_NOT_FINITE,
          "params[0]|-inf");
    FAILS(a.domain = VALUES(0, 0.99), NURBS_ERROR_OUTSIDE_DOMAIN, "params[29]|= 1|[0, 0.99]");
    FAILS(a.data.values = edited(a.data.values, 30, 29, INFINITY), NURBS_ERROR_POINT_NOT_FINITE,
          "values[29][0]|inf");
    FAILS(a.data.values = edited(a.data.values, 30, 3, NAN), NURBS_ERROR_POINT_NOT_FINITE,
          "values[3][0]|nan");
    FAILS(a.data.weights = edited(a.data.params, 30, 5, NAN), NURBS_ERROR_WEIGHT_NOT_FINITE,
          "weights[5]|nan");
    FAILS(a.data.weights = edited(a.data.params, 30, 6, -2), NURBS_ERROR_WEIGHT_NEGATIVE, "weights[6] = -2");
    FAILS((a.data.n = 4, a.data.params = VALUES(0, 0.25, 0.75, 1),
           a.data.values = VALUES(-1.7e308, 1.7e308, -1.7e308, 1.7e308), a.tolerance = 1e300),
          NURBS_ERROR_NOT_REPRESENTABLE, "of the result");
}

static void refused_options(void) {
    FAILS(a.options.struct_size = 71, NURBS_ERROR_OPTIONS, "options|struct_size = 71");
    FAILS(a.options.reserved = -1, NURBS_ERROR_OPTIONS, "options|reserved = -1");
    FAILS(a.report.struct_size = 0, NURBS_ERROR_OPTIONS, "report|struct_size = 0");
    FAILS(a.options.smoothing = 7, NURBS_ERROR_RULE, "smoothing = 7");
    FAILS(a.options.penalty_order = 0, NURBS_ERROR_ORDER, "penalty_order = 0");
    FAILS((a.options.penalty_order = 4, a.options.smoothing = NURBS_SMOOTHING_REML), NURBS_ERROR_ORDER,
          "penalty_order = 4|3");
    FAILS(a.options.lambda = -1e-9, NURBS_ERROR_FACTOR, "lambda = -1e-09");
    FAILS(a.options.target = INFINITY, NURBS_ERROR_FACTOR, "target = inf");
    FAILS(a.options.conditions = -1, NURBS_ERROR_COUNT, "conditions = -1");
    FAILS(a.options.conditions = 1, NURBS_ERROR_NULL, "condition_params");
}

#define CONDITIONS(at, order, target)                                                                        \
    (a.options.conditions = 2, a.options.condition_params = (at), a.options.condition_orders = (order),      \
     a.options.condition_targets = (target))

static void refused_conditions(void) {
    const double *two = VALUES(0, 1);
    FAILS(CONDITIONS(VALUES(0, 1.5), NULL, two), NURBS_ERROR_OUTSIDE_DOMAIN,
          "condition_params[1][0] = 1.5|[0, 1]");
    FAILS(CONDITIONS(VALUES(INFINITY, 1), NULL, two), NURBS_ERROR_PARAMETER_NOT_FINITE,
          "condition_params[0][0]");
    FAILS(CONDITIONS(two, DEGREES(0, 4), two), NURBS_ERROR_ORDER, "condition_orders[1][0] = 4|3");
    FAILS(CONDITIONS(two, NULL, VALUES(NAN, 0)), NURBS_ERROR_POINT_NOT_FINITE, "condition_targets[0][0]|nan");
    FAILS(CONDITIONS(VALUES(0.5, 0.5), NULL, two), NURBS_ERROR_CONTRADICTION, "conditions[1]");
}

int main(void) {
    refused_arguments();
    refused_layouts();
    refused_numbers();
    refused_options();
    refused_conditions();
    return check_summary("fit_tolerance_refused");
}
