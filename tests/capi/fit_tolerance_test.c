/* SPDX-License-Identifier: MIT */
/* nurbs_fit_tolerance(): few control points, and no datum farther away than the tolerance. */
#define _POSIX_C_SOURCE 200809L
#include "fits.h"
#include "shapes.h"

#include <sys/wait.h>
#include <unistd.h>

enum { most_data = 500 };

/* Values of a function at even parameters from 0 to 1. */
static nurbs_data samples(int n, double (*f)(double)) {
    static double params[most_data], values[most_data];
    for (int i = 0; i < n; ++i) {
        params[i] = i / (n - 1.0);
        values[i] = f(params[i]);
    }
    return data_of(1, 1, n, params, values);
}

static double wave(double t) {
    return sin(9 * t);
}
static double kink(double t) {
    return fabs(t - 0.3);
}
static double step(double t) {
    return t > 0.5;
}
static double parabola(double t) {
    return t * (1 - t);
}
static double noise(double t) {
    return sin(1e5 * t);
}

static int64_t count_of(const nurbs *g) {
    int64_t count = -1;
    CHECK_OK(nurbs_point_count(g, &count));
    return count;
}

/* The control points of a curve on the line, at most `cap` of them; how many there are. */
static int64_t points_of(const nurbs *g, int64_t cap, double *points) {
    const int64_t count = count_of(g);
    memset(points, 0, (size_t)cap * sizeof *points);
    CHECK(count <= cap);
    if (count <= cap) {
        CHECK_OK(nurbs_points(g, count, points, 0, 0));
    }
    return count;
}

/* The report says of the data what the spline says of them. */
static void check_told(const char *file, int line, const ToleranceArgs *a, const nurbs *g) {
    const int64_t n = a->data.n, dim = a->data.dim;
    double *made = (double *)malloc((size_t)(n * dim) * sizeof *made), most = 0, squares = 0;
    int64_t worst = -1;
    CHECK_OK(nurbs_eval(g, n, a->data.params, a->data.param_stride, a->data.param_component_stride, made, 0,
                        0, a->data.flags));
    for (int64_t i = 0; i < n; ++i) {
        double square = 0;
        for (int64_t c = 0; c < dim; ++c) {
            square += pow(made[i * dim + c] - a->data.values[i * dim + c], 2);
        }
        squares += square;
        worst = sqrt(square) > most ? i : worst;
        most = fmax(most, sqrt(square));
    }
    check_doubles(file, line, &a->report.largest, &most, 1, 1e-15);
    check_doubles(file, line, &a->report.squares, &squares, 1, 1e-13 * (1 + squares));
    check_integers(file, line, "largest_index", worst < 0 ? -1 : a->report.largest_index, worst);
    check_integers(file, line, "data_count", a->report.data_count, n);
    check_true(file, line, (most <= a->tolerance) == (a->report.bits == 0),
               "the bits are those of the distance");
    free(made);
}
#define CHECK_TOLD(a, g) check_told(__FILE__, __LINE__, a, g)

/* A fit that works. */
static nurbs *found(ToleranceArgs *a) {
    nurbs *g = NULL;
    CHECK_OK(tolerance_fit(a, NULL, &g));
    return g;
}

static void a_wave(void) {
    ToleranceArgs a = tolerance_args(samples(400, wave), 1e-4);
    nurbs *g = found(&a), *same = NULL;
    double domain[2], points[64];
    CHECK_TOLD(&a, g);
    CHECK(a.report.largest <= 1e-4 && a.report.bits == 0);
    CHECK(count_of(g) > 6 && count_of(g) <= 24);
    CHECK_DOUBLE(a.report.weight, 400);
    CHECK_DOUBLE(a.report.lambda, 0);
    CHECK_DOUBLE(a.report.freedom, (double)count_of(g));
    const double rms = sqrt(a.report.squares / 400),
                 sigma = sqrt(a.report.squares / (double)(400 - count_of(g)));
    CHECK_NEAR(&a.report.rms, &rms, 1, 1e-15);
    CHECK_NEAR(&a.report.sigma, &sigma, 1, 1e-15);
    CHECK(a.report.residual >= 0 && a.report.residual <= 1e-20 && a.report.rounds == 1);
    CHECK_OK(nurbs_domain(g, 0, domain));
    CHECK_DOUBLES(domain, VALUES(0, 1), 2);
    CHECK_OK(nurbs_fit_tolerance(&a.data, a.degrees, NULL, 1e-4, 0, 0, NULL, NULL, &same));
    CHECK_INT(points_of(same, 64, points), count_of(g));
    CHECK_POINTS(g, points);
    nurbs_destroy(g);
    nurbs_destroy(same);
}

/* No knot where none is needed. */
static void polynomials(void) {
    ToleranceArgs a = tolerance_args(samples(200, parabola), 1e-12);
    nurbs *g = found(&a);
    CHECK_POINTS_NEAR(g, VALUES(0, 1 / 3.0, 1 / 3.0, 0), 1e-12);
    nurbs_destroy(g);
    a = tolerance_args(samples(200, noise), INFINITY);
    g = found(&a);
    CHECK_INT(count_of(g), 4);
    CHECK_INT(a.report.bits, 0);
    nurbs_destroy(g);
}

/* Knots as often as the curve needs them. */
static void breaks(void) {
    ToleranceArgs a = tolerance_args(samples(499, step), 1e-9);
    nurbs *g = found(&a);
    CHECK_POINTS_NEAR(g, VALUES(0, 0, 0, 0, 1, 1, 1, 1), 1e-12);
    CHECK_TOLD(&a, g);
    nurbs_destroy(g);
    a = tolerance_args(samples(500, kink), 1e-9);
    g = found(&a);
    CHECK(a.report.largest <= 1e-9);
    CHECK(count_of(g) <= 16);
    nurbs_destroy(g);
}

/* What does not do is told: the limit is kept. */
static void limits(void) {
    for (int64_t most = 4; most < 40; most += 7) {
        ToleranceArgs a = tolerance_args(samples(400, noise), 1e-3);
        a.max_count = most;
        nurbs *g = found(&a);
        CHECK(count_of(g) <= most);
        CHECK_INT(a.report.bits, NURBS_FIT_TARGET_MISSED);
        CHECK_TOLD(&a, g);
        nurbs_destroy(g);
    }
    ToleranceArgs a = tolerance_args(samples(50, wave), 0); /* as many as data */
    nurbs *g = found(&a);
    CHECK(count_of(g) <= 50);
    CHECK(a.report.largest <= 1e-4);
    nurbs_destroy(g);
}

/* Wider than the data, or narrower, with what is outside left out or moved. */
static void domains(void) {
    ToleranceArgs a = tolerance_args(samples(101, parabola), 1e-9);
    double domain[2], ends[2];
    a.domain = VALUES(-1, 2);
    nurbs *g = found(&a);
    CHECK_OK(nurbs_domain(g, 0, domain));
    CHECK_DOUBLES(domain, VALUES(-1, 2), 2);
    CHECK(a.report.largest <= 1e-9);
    nurbs_destroy(g);
    a.domain = VALUES(0, 0.5);
    a.data.flags = NURBS_NAN;
    g = found(&a);
    CHECK_POINTS_NEAR(g, VALUES(0, 1 / 6.0, 0.25, 0.25), 1e-12);
    CHECK_INT(a.report.data_count, 51);
    nurbs_destroy(g);
    a = tolerance_args(samples(101, step), 1e-9);
    a.domain = VALUES(0, 0.75);
    a.data.flags = NURBS_CLAMP;
    g = found(&a);
    CHECK_OK(nurbs_eval(g, 2, VALUES(0, 0.75), 0, 0, ends, 0, 0, 0));
    CHECK_NEAR(ends, VALUES(0, 1), 2, 1e-9);
    CHECK_INT(a.report.data_count, 101);
    nurbs_destroy(g);
}

static void a_loop(void) {
    static double params[200], values[400];
    double points[64];
    int32_t form = 0;
    for (int i = 0; i < 200; ++i) {
        params[i] = i / 50.0 - 1; /* round and round */
        values[2 * i] = cos(6.283185307179586 * params[i]);
        values[2 * i + 1] = sin(6.283185307179586 * params[i]);
    }
    ToleranceArgs a = tolerance_args(data_of(1, 2, 200, params, values), 1e-4);
    a.data.flags = NURBS_WRAP;
    a.domain = VALUES(0, 1);
    a.flags = NURBS_PERIODIC;
    nurbs *g = found(&a);
    CHECK_OK(nurbs_knot_form(g, 0, &form));
    CHECK_INT(form, NURBS_FORM_PERIODIC);
    const int64_t count = count_of(g);
    CHECK(count > 7 && count <= 16 && a.report.largest <= 1e-4);
    CHECK_OK(nurbs_points(g, count, points, 0, 0));
    CHECK_BITS(points, points + 2 * (count - 3), 6 * sizeof(double));
    CHECK_DOUBLE(a.report.freedom, (double)(count - 3));
    CHECK_TOLD(&a, g);
    nurbs_destroy(g);
}

/* Jumps of data from other periods than that of the domain. */
static void a_wrapped_step(void) {
    static double params[400], values[400];
    for (int i = 0; i < 400; ++i) {
        params[i] = 1 + i / 400.0;
        values[i] = i >= 200;
    }
    for (int i = 0; i < 2; ++i) {
        ToleranceArgs a = tolerance_args(data_of(1, 1, 400, params, values), 1e-3);
        a.data.flags = NURBS_WRAP;
        a.domain = VALUES(0, 1);
        a.flags = i == 0 ? 0 : NURBS_PERIODIC;
        nurbs *g = found(&a);
        CHECK(a.report.largest <= 1e-3);
        nurbs_destroy(g);
    }
}

/* A periodic curve from 0 to 1 through a kink near 0, with data before and after that are left out. */
static void a_kink_near_the_seam(void) {
    static double params[425], values[425];
    for (int i = 0; i < 425; ++i) {
        params[i] = i / 212.0 - 0.5;
        values[i] = fabs(params[i] - 0.0999);
    }
    ToleranceArgs a = tolerance_args(data_of(1, 1, 425, params, values), 1e-3);
    a.data.flags = NURBS_NAN;
    a.domain = VALUES(0, 1);
    a.flags = NURBS_PERIODIC;
    nurbs *g = found(&a);
    CHECK_INT(a.report.data_count, 213);
    nurbs_destroy(g);
}

/* The parameters of a grid of `side` points on each axis. */
static void grid_params(int32_t axes, int side, double *params) {
    const int n = axes == 2 ? side * side : side * side * side;
    for (int i = 0; i < n; ++i) {
        int rest = i;
        for (int32_t k = axes; k-- > 0; rest /= side) {
            params[axes * i + k] = rest % side / (double)(side - 1);
        }
    }
}

static void surfaces(void) {
    static double params[800], values[400];
    int64_t counts[2];
    grid_params(2, 20, params);
    for (int i = 0; i < 400; ++i) {
        values[i] = sin(12 * params[2 * i + 1]) + params[2 * i];
    }
    ToleranceArgs a = tolerance_args(data_of(2, 1, 400, params, values), 5e-3);
    nurbs *g = found(&a);
    CHECK_OK(nurbs_count(g, 0, counts));
    CHECK_OK(nurbs_count(g, 1, counts + 1));
    CHECK(counts[0] == 4 && counts[1] > 6 && counts[1] < 20); /* only axis 1 needs knots */
    CHECK_TOLD(&a, g);
    CHECK_INT(a.report.bits, 0);
    nurbs_destroy(g);
    a.degrees = DEGREES(1, 1);
    for (int i = 0; i < 400; ++i) {
        values[i] = params[2 * i + 1] * params[2 * i];
    }
    g = found(&a);
    CHECK_POINTS_NEAR(g, VALUES(0, 0, 0, 1), 1e-14);
    nurbs_destroy(g);
}

static void a_volume(void) {
    static double params[375], values[500];
    grid_params(3, 5, params);
    for (int i = 0; i < 125; ++i) {
        const double *u = params + 3 * i;
        memcpy(values + 4 * i, u, 3 * sizeof *u);
        values[4 * i + 3] = u[0] * u[1] * u[2];
    }
    ToleranceArgs a = tolerance_args(data_of(3, 4, 125, params, values), 1e-9);
    a.degrees = DEGREES(1, 1, 1);
    nurbs *g = found(&a);
    CHECK_POINTS_NEAR(g, cube().points, 1e-14);
    CHECK_TOLD(&a, g);
    nurbs_destroy(g);
}

/* Data of weight 0 change nothing, whatever their values are. */
static void masked_values(void) {
    double weights[400], points[3][64];
    int64_t counts[3];
    for (int i = 0; i < 3; ++i) {
        nurbs_data data = samples(400, kink);
        double values[400];
        memcpy(values, data.values, sizeof values);
        for (int k = 0; k < 400; ++k) {
            weights[k] = k == 300 || k == 7 ? 0 : 1;
        }
        values[300] = values[7] = VALUES(NAN, 1e3, -1e30)[i];
        data.values = values;
        data.weights = weights;
        ToleranceArgs a = tolerance_args(data, 1e-3);
        nurbs *g = found(&a);
        CHECK(a.report.largest <= 1e-3 && a.report.bits == 0);
        CHECK_INT(a.report.data_count, 398);
        counts[i] = points_of(g, 64, points[i]);
        nurbs_destroy(g);
    }
    CHECK(counts[1] == counts[0] && counts[2] == counts[0]);
    CHECK_BITS(points[1], points[0], sizeof points[0]);
    CHECK_BITS(points[2], points[0], sizeof points[0]);
}

/* And so does what NURBS_NAN leaves out. */
static void left_out(void) {
    static double params[402], values[402];
    double points[64];
    const nurbs_data data = samples(400, wave);
    ToleranceArgs a = tolerance_args(data, 1e-3);
    nurbs *g = found(&a);
    const int64_t count = points_of(g, 64, points);
    nurbs_destroy(g);
    memcpy(params, data.params, 400 * sizeof *params);
    memcpy(values, data.values, 400 * sizeof *values);
    params[400] = NAN;
    params[401] = 8;
    values[400] = NAN;
    values[401] = 1e30;
    a = tolerance_args(data_of(1, 1, 402, params, values), 1e-3);
    a.data.flags = NURBS_NAN;
    a.domain = VALUES(0, 1);
    g = found(&a);
    CHECK_INT(a.report.data_count, 400);
    CHECK(a.report.largest <= 1e-3);
    CHECK_INT(count_of(g), count);
    CHECK_POINTS_NEAR(g, points, 1e-3);
    nurbs_destroy(g);
}

static void smoothed(void) {
    for (int32_t rule = NURBS_SMOOTHING_LAMBDA; rule <= NURBS_SMOOTHING_DISCREPANCY; ++rule) {
        ToleranceArgs a = tolerance_args(samples(300, wave), 0.01);
        a.options.smoothing = rule;
        a.options.lambda = 1e-7;
        a.options.target = 0.004;
        nurbs *g = found(&a);
        CHECK(a.report.lambda > 0);
        CHECK_TOLD(&a, g);
        nurbs_destroy(g);
    }
    /* One datum, and a penalty that leaves lines open. */
    ToleranceArgs a = tolerance_args(data_of(1, 1, 1, VALUES(0.5), VALUES(2)), 1e-3);
    a.domain = VALUES(0, 1);
    nurbs *g = found(&a);
    CHECK_POINTS_NEAR(g, VALUES(2, 2, 2, 2), 1e-9);
    nurbs_destroy(g);
    a.options.smoothing = NURBS_SMOOTHING_LAMBDA;
    a.options.lambda = 1;
    g = found(&a);
    CHECK_POINTS_NEAR(g, VALUES(2, 2, 2, 2), 1e-9);
    nurbs_destroy(g);
}

/* Few conditions, and more of them than a cubic without knots can keep. */
static void conditions(void) {
    double at[6], targets[6], made[6];
    for (int i = 0; i < 6; ++i) {
        at[i] = i / 5.0;
        targets[i] = wave(at[i]);
    }
    for (int64_t many = 2; many <= 6; many += 4) {
        ToleranceArgs a = tolerance_args(samples(400, wave), 1e-3);
        a.options.conditions = many;
        a.options.condition_params = at;
        a.options.condition_targets = targets;
        nurbs *g = found(&a);
        CHECK(a.report.largest <= 1e-3 && a.report.bits == 0);
        CHECK_OK(nurbs_eval(g, many, at, 0, 0, made, 0, 0, 0));
        CHECK_NEAR(made, targets, many, 1e-12);
        nurbs_destroy(g);
    }
}

/* Nothing depends on the unit of parameters. */
static void units(void) {
    static const double factors[] = {1, 0x1p-400, 0x1p400, 0x1p-900, 0x1p900};
    static double params[400];
    double points[64];
    const nurbs_data data = samples(400, wave);
    for (int i = 0; i < 5; ++i) {
        for (int k = 0; k < 400; ++k) {
            params[k] = data.params[k] * factors[i];
        }
        ToleranceArgs a = tolerance_args(data_of(1, 1, 400, params, data.values), 1e-4);
        nurbs *g = found(&a);
        CHECK(a.report.largest <= 1e-4);
        if (i == 0) {
            (void)points_of(g, 64, points);
        }
        CHECK_POINTS(g, points);
        nurbs_destroy(g);
    }
}

/* Fewer data than control points, in some of the splines that are tried. */
static void few_data(void) {
    ToleranceArgs a = tolerance_args(samples(15, step), 0);
    nurbs *g = found(&a);
    CHECK(count_of(g) <= 15);
    nurbs_destroy(g);
}

static void watched(void) {
    const ManyData many = many_data(500000);
    FitWatcher w = {0, 0, 0, 0};
    nurbs_call_options call = watched_by(&w, 0);
    ToleranceArgs a = tolerance_args(data_of(1, 1, many.n, many.params, many.values), 2e-3);
    nurbs *plain = found(&a), *g = NULL;
    double points[256], same[256];
    CHECK_OK(tolerance_fit(&a, &call, &g));
    CHECK(w.calls > 0 && w.wrong == 0);
    CHECK_INT(points_of(g, 256, same), points_of(plain, 256, points));
    CHECK_BITS(points, same, sizeof points);
    nurbs_destroy(plain);
    nurbs_destroy(g);
    a.report = unwritten_report();
    const nurbs_fit_report before = a.report;
    w = (FitWatcher){0, 0, 1, 0};
    CHECK_NO_HANDLE(g, tolerance_fit(&a, &call, &g), NURBS_ERROR_CANCELLED, "progress|1");
    CHECK_INT(w.calls, 1);
    call = watched_by(NULL, 100);
    CHECK_NO_HANDLE(g, tolerance_fit(&a, &call, &g), NURBS_ERROR_WORK, "work = 100");
    call.work = -5;
    CHECK_NO_HANDLE(g, tolerance_fit(&a, &call, &g), NURBS_ERROR_OPTIONS, "call|work = -5");
    call.struct_size = 0;
    CHECK_NO_HANDLE(g, tolerance_fit(&a, &call, &g), NURBS_ERROR_OPTIONS, "call|struct_size = 0");
    CHECK(memcmp(&before, &a.report, sizeof before) == 0);
    free_many(many);
}

/* Several data at each parameter. */
static void repeated_parameters(void) {
    ToleranceArgs a =
        tolerance_args(data_of(1, 1, 6, VALUES(0, 0, 0.5, 0.5, 1, 1), VALUES(0, 0, 1, 2, 2, 2)), 0);
    a.degrees = DEGREES(0);
    nurbs *g = found(&a);
    CHECK(a.report.largest >= 0.5);
    CHECK_INT(a.report.bits, NURBS_FIT_TARGET_MISSED);
    nurbs_destroy(g);
}

/* A domain in which there is but one number. */
static void a_narrow_domain(void) {
    double params[300], values[300];
    for (int i = 0; i < 300; ++i) {
        params[i] = 1 + i % 3 * 0x1p-52;
        values[i] = i % 7;
    }
    ToleranceArgs a = tolerance_args(data_of(1, 1, 300, params, values), 1e-3);
    nurbs *g = found(&a);
    CHECK_INT(a.report.bits, NURBS_FIT_TARGET_MISSED);
    nurbs_destroy(g);
}

/* In a process of its own, which may crash, or go on for ever. */
static void ends(void (*body)(void), const char *name) {
    int state = 0;
    fflush(NULL);
    const pid_t child = fork();
    if (child == 0) {
        alarm(60);
        check_failures = 0;
        body();
        _exit(check_failures == 0 ? 0 : 1);
    }
    CHECK(child > 0 && waitpid(child, &state, 0) == child);
    if (!WIFEXITED(state) || WEXITSTATUS(state) != 0) {
        check_report(__FILE__, __LINE__, name);
        fprintf(stderr, WIFSIGNALED(state) ? ": signal %d\n" : ": state %d\n",
                WIFSIGNALED(state) ? WTERMSIG(state) : state);
    }
}

int main(void) {
    a_wave();
    polynomials();
    breaks();
    limits();
    domains();
    a_loop();
    a_wrapped_step();
    a_kink_near_the_seam();
    surfaces();
    a_volume();
    masked_values();
    left_out();
    smoothed();
    conditions();
    units();
    few_data();
    watched();
    ends(repeated_parameters, "repeated_parameters");
    ends(a_narrow_domain, "a_narrow_domain");
    return check_summary("fit_tolerance");
}
