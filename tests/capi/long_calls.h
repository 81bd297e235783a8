/* SPDX-License-Identifier: MIT */
/* One call of every function nurbs_X_with, and of its plain form, on shapes of any size. */
#ifndef NURBS_TESTS_CAPI_LONG_CALLS_H
#define NURBS_TESTS_CAPI_LONG_CALLS_H

#include "check.h"

enum { long_values = 4096, long_points = 2000 };

/* What a call writes. */
typedef struct {
    double values[long_values];
    int64_t counts[4];
    int32_t states[long_points];
    nurbs *out;
    nurbs_list *list;
} LongResult;

/* What the calls are given. `rough` and its like have a table that a first query builds. */
typedef struct {
    nurbs *tangled, *smooth, *plane, *ring;
    nurbs *rough, *hill, *knotted, *sphere;
    nurbs *other, *trace, *block, *folded;
    char *file;
    int64_t file_size;
    double points[3 * long_points], params[2 * long_points], lengths[long_points];
    int64_t n; /* of the points in a batch */
} LongShapes;

static unsigned long long long_state = 1;

/* In [-1, 1]. */
static inline double long_random(void) {
    long_state = long_state * 6364136223846793005ULL + 1442695040888963407ULL;
    return (double)(long_state >> 11) * 0x1p-52 - 1;
}

typedef void (*LongPoint)(const double *u, double *x);

static inline void long_tangle(const double *u, double *x) {
    (void)u;
    for (int c = 0; c < 3; ++c) {
        x[c] = long_random();
    }
}
static inline void long_wave(const double *u, double *x) {
    x[0] = u[0];
    x[1] = sin(20 * u[0]);
    x[2] = cos(17 * u[0]);
}
static inline void long_flat(const double *u, double *x) {
    (void)u;
    x[0] = long_random();
    x[1] = long_random();
}
static inline void long_ring(const double *u, double *x) {
    const double turn = 6.283185307179586 * u[0];
    x[0] = cos(turn) * (1 + 0.1 * sin(50 * turn));
    x[1] = u[0] == 1 ? 0 : sin(turn);
}
static inline void long_ridges(const double *u, double *x) {
    x[0] = u[0];
    x[1] = u[1];
    x[2] = 0.05 * long_random();
}
static inline void long_above(const double *u, double *x) {
    long_ridges(u, x);
    x[2] += 0.11;
}
static inline void long_hill(const double *u, double *x) {
    x[0] = u[0];
    x[1] = u[1];
    x[2] = sin(9 * u[0]) * cos(7 * u[1]);
}
static inline void long_trace(const double *u, double *x) {
    x[0] = 0.5 + 0.45 * sin(9 * u[0]);
    x[1] = u[0];
}
static inline void long_block(const double *u, double *x) {
    for (int k = 0; k < 3; ++k) {
        x[k] = u[k] + 0.05 * sin(5 * u[(k + 1) % 3]);
    }
}
static inline void long_folds(const double *u, double *x) {
    for (int k = 0; k < 3; ++k) {
        x[k] = u[k] + 0.04 * sin(5 * u[(k + 1) % 3]) + 0.01 * long_random();
    }
}

/* `count` control points on every axis, at the Greville abscissae of u. */
static inline nurbs *long_make(int32_t axes, int32_t degree, int64_t count, int32_t dim, int weighted,
                               LongPoint point) {
    const int32_t degrees[] = {degree, degree, degree};
    const int64_t counts[] = {count, count, count}, knots = count + degree + 1;
    int64_t total = 1;
    double *own = (double *)malloc((size_t)(axes * knots) * sizeof *own), *abscissae, *points, *weights;
    nurbs *g = NULL;
    for (int32_t k = 0; k < axes; ++k) {
        CHECK_OK(nurbs_knots_open_uniform(degree, count, 0, 1, knots, own + k * knots));
        total *= count;
    }
    abscissae = (double *)malloc((size_t)count * sizeof *abscissae);
    points = (double *)malloc((size_t)(total * dim) * sizeof *points);
    weights = (double *)malloc((size_t)total * sizeof *weights);
    for (int64_t i = 0; i < count; ++i) {
        double sum = 0;
        for (int32_t j = 1; j <= degree; ++j) {
            sum += own[i + j];
        }
        abscissae[i] = sum / degree;
    }
    for (int64_t i = 0; i < total; ++i) {
        double u[3] = {0, 0, 0};
        int64_t rest = i;
        for (int32_t k = axes; k-- > 0; rest /= count) {
            u[k] = abscissae[rest % count];
        }
        point(u, points + i * dim);
        weights[i] = 1 + 0.3 * long_random();
    }
    CHECK_OK(nurbs_create(axes, degrees, counts, own, axes * knots, dim, points, 0, 0,
                          weighted ? weights : NULL, 0, 0, &g));
    free(own);
    free(abscissae);
    free(points);
    free(weights);
    return g;
}

static inline nurbs *long_sphere(int64_t knots) {
    const double centre[] = {1, 2, 3}, axis[] = {0, 0, 1}, x[] = {1, 0, 0};
    double *fresh = (double *)malloc((size_t)knots * sizeof *fresh), domain[2];
    nurbs *sphere = NULL;
    CHECK_OK(nurbs_surface_sphere(centre, axis, x, 2, 0, &sphere));
    for (int32_t k = 0; k < 2; ++k) {
        nurbs *fine = NULL;
        CHECK_OK(nurbs_domain(sphere, k, domain));
        for (int64_t i = 0; i < knots; ++i) {
            fresh[i] = domain[0] + (domain[1] - domain[0]) * ((double)i + 0.37) / (double)knots;
        }
        CHECK_OK(nurbs_refine(sphere, k, knots, fresh, &fine));
        nurbs_destroy(sphere);
        sphere = fine;
    }
    free(fresh);
    return sphere;
}

/* An IGES file of curves of one span. */
static inline char *long_file(int64_t curves, int64_t *size) {
    const char *const global = "1H,,1H;,4HTEST,8Htest.igs,4HTEST,3H1.0,32,38,6,308,15,4HTEST,1.,2,";
    const char *const rest = "2HMM,1,1.,15H20260101.000000,1E-6,1.,4HNONE,4HNONE,11,0;";
    char *text = (char *)malloc((size_t)(5 + 4 * curves + 1) * 81 + 1), *at = text;
    char line[120];
    at += sprintf(at, "%-72s%c%7d\n", "test", 'S', 1);
    at += sprintf(at, "%-72s%c%7d\n", global, 'G', 1);
    at += sprintf(at, "%-72s%c%7d\n", rest, 'G', 2);
    for (int64_t i = 0; i < curves; ++i) {
        at += sprintf(at, "%8d%8lld%8d%8d%8d%8d%8d%8d%8s%c%7lld\n", 126, (long long)(2 * i + 1), 0, 0, 0, 0,
                      0, 0, "00000000", 'D', (long long)(2 * i + 1));
        at += sprintf(at, "%8d%8d%8d%8d%8d%8s%8s%8s%8d%c%7lld\n", 126, 0, 0, 2, 0, "", "", "", 0, 'D',
                      (long long)(2 * i + 2));
    }
    for (int64_t i = 0; i < curves; ++i) {
        sprintf(line, "126,2,2,0,0,1,0,0.,0.,0.,1.,1.,1.,1.,1.,1.,%lld.,0.,0.,", (long long)(i % 1000));
        at += sprintf(at, "%-64s%8lld%c%7lld\n", line, (long long)(2 * i + 1), 'P', (long long)(2 * i + 1));
        at += sprintf(at, "%-64s%8lld%c%7lld\n", "1.,2.,0.,3.,0.,0.,0.,1.,0.,0.,1.;", (long long)(2 * i + 1),
                      'P', (long long)(2 * i + 2));
    }
    sprintf(line, "S%7dG%7dD%7lldP%7lld", 1, 2, (long long)(2 * curves), (long long)(2 * curves));
    at += sprintf(at, "%-72s%c%7d\n", line, 'T', 1);
    *size = at - text;
    return text;
}

/* size 1: calls of some milliseconds; work grows with it. */
static inline LongShapes *long_shapes(double size) {
    LongShapes *s = (LongShapes *)calloc(1, sizeof *s);
    const double side = sqrt(size);
    const int64_t many = (int64_t)(2000 * size), edge = (int64_t)(20 * side);
    s->tangled = long_make(1, 3, many, 3, 1, long_tangle);
    s->smooth = long_make(1, 5, many, 3, 0, long_wave);
    s->plane = long_make(1, 3, 400, 2, 0, long_flat);
    s->ring = long_make(1, 3, 2 * many, 2, 1, long_ring);
    s->rough = long_make(2, 3, edge, 3, 0, long_ridges);
    s->other = long_make(2, 3, edge, 3, 0, long_above);
    s->hill = long_make(2, 3, edge, 3, 0, long_hill);
    s->knotted = long_make(2, 3, edge, 3, 1, long_tangle);
    s->sphere = long_sphere(2 * edge);
    s->trace = long_make(1, 3, many / 100 + 4, 2, 0, long_trace);
    s->block = long_make(3, 2, 6, 3, 0, long_block);
    s->folded = long_make(3, 2, 4 + edge / 8, 3, 0, long_folds);
    s->file = long_file(many / 2, &s->file_size);
    s->n = (int64_t)(size * 20) < long_points ? (int64_t)(size * 20) : (int64_t)long_points;
    for (int i = 0; i < 3 * long_points; ++i) {
        s->points[i] = long_random();
    }
    for (int i = 0; i < 2 * long_points; ++i) {
        s->params[i] = fabs(long_random());
    }
    for (int i = 0; i < long_points; ++i) {
        s->lengths[i] = s->params[i] * 10;
    }
    return s;
}

static inline void long_destroy(LongShapes *s) {
    nurbs *const all[] = {s->tangled, s->smooth,  s->plane,  s->ring,  s->rough, s->other,
                          s->hill,    s->knotted, s->sphere, s->trace, s->block, s->folded};
    for (size_t i = 0; i < sizeof all / sizeof *all; ++i) {
        nurbs_destroy(all[i]);
    }
    free(s->file);
    free(s);
}

/* plain: without `call`. Each pair is the same question. */
typedef nurbs_status (*LongCall)(const LongShapes *s, int plain, const nurbs_call_options *call,
                                 LongResult *r);

#define LONG_HANDLE(name, ...)                                                                               \
    static inline nurbs_status long_##name(const LongShapes *s, int plain, const nurbs_call_options *call,   \
                                           LongResult *r) {                                                  \
        return plain ? nurbs_##name(__VA_ARGS__, &r->out) : nurbs_##name##_with(__VA_ARGS__, call, &r->out); \
    }
#define LONG_QUERY(name, ...)                                                                                \
    static inline nurbs_status long_##name(const LongShapes *s, int plain, const nurbs_call_options *call,   \
                                           LongResult *r) {                                                  \
        return plain ? nurbs_##name(__VA_ARGS__) : nurbs_##name##_with(__VA_ARGS__, call);                   \
    }
#define LONG_V (r->values)
#define LONG_AXIS                                                                                            \
    { 0, 0, 1 }

LONG_HANDLE(product, s->tangled, s->tangled, NURBS_PRODUCT_DOT)
LONG_HANDLE(compose, s->hill, s->trace)
LONG_HANDLE(reduce_knots, s->smooth, 0, 1e-6, LONG_V)
LONG_HANDLE(reduce_degree, s->smooth, 0, 1, LONG_V)
LONG_HANDLE(simplify, s->hill, 1e-2, LONG_V)
LONG_QUERY(recognize, s->sphere, 1e-9, r->states, LONG_V, LONG_V + 9, LONG_V + 12)
LONG_QUERY(closest_all, s->knotted, s->points, NULL, 0.3, 0, 500, LONG_V, LONG_V + 1000, r->counts, r->states)
LONG_QUERY(critical_points, s->knotted, s->points, NULL, 0, 100000, 0, NULL, NULL, NULL, r->counts, r->states)
LONG_QUERY(distance, s->rough, s->other, 0, 0, LONG_V, LONG_V + 1, LONG_V + 2, LONG_V + 4, r->states)
LONG_QUERY(hausdorff_distance, s->rough, s->other, 1e-3, 20000, LONG_V, LONG_V + 2, LONG_V + 4, LONG_V + 6,
           r->states)
LONG_QUERY(curve_length, s->tangled, NULL, 1e-9, LONG_V, LONG_V + 1)
LONG_QUERY(curve_lengths, s->tangled, s->n, s->params, 0, 1e-9, LONG_V, 0)
LONG_QUERY(curve_params_at_lengths, s->tangled, s->n, s->lengths, 0, 1e-9, LONG_V, 0, NURBS_CLAMP)
LONG_QUERY(curve_divide, s->smooth, NULL, s->n, 1e-9, 0, LONG_V, LONG_V + long_points + 1)
LONG_QUERY(surface_area, s->hill, NULL, 1e-9, LONG_V, LONG_V + 1)
LONG_QUERY(moments, s->hill, 1e-7, LONG_V, LONG_V + 1, LONG_V + 4, LONG_V + 13)
LONG_QUERY(curve_features, s->plane, NURBS_FEATURE_INFLECTION | NURBS_FEATURE_CURVATURE_MAXIMUM, 0, NULL,
           NULL, NULL, r->counts, r->states)
LONG_QUERY(fold_test, s->folded, NULL, r->states, LONG_V, LONG_V + 3)

static inline nurbs_status long_enclosed_area(const LongShapes *s, int plain, const nurbs_call_options *call,
                                              LongResult *r) {
    const nurbs *const curves[] = {s->ring};
    return plain ? nurbs_enclosed_area(1, curves, 1e-6, 1e-9, LONG_V, LONG_V + 1, LONG_V + 3, LONG_V + 7)
                 : nurbs_enclosed_area_with(1, curves, 1e-6, 1e-9, LONG_V, LONG_V + 1, LONG_V + 3, LONG_V + 7,
                                            call);
}
static inline nurbs_status long_enclosed_volume(const LongShapes *s, int plain,
                                                const nurbs_call_options *call, LongResult *r) {
    const nurbs *const shell[] = {s->sphere};
    return plain ? nurbs_enclosed_volume(1, shell, 1e-9, LONG_V, LONG_V + 1, LONG_V + 4, LONG_V + 13,
                                         LONG_V + 14)
                 : nurbs_enclosed_volume_with(1, shell, 1e-9, LONG_V, LONG_V + 1, LONG_V + 4, LONG_V + 13,
                                              LONG_V + 14, call);
}
static inline nurbs_status long_bend(const LongShapes *s, int plain, const nurbs_call_options *call,
                                     LongResult *r) {
    const double origin[] = {0, 0, 0}, along[] = {1, 0, 0}, across[] = LONG_AXIS;
    return plain ? nurbs_bend(s->hill, origin, along, across, 0.5, 0.2, 0.8, 1e-4, LONG_V, r->states, &r->out)
                 : nurbs_bend_with(s->hill, origin, along, across, 0.5, 0.2, 0.8, 1e-4, LONG_V, r->states,
                                   call, &r->out);
}
static inline nurbs_status long_free_form_deform(const LongShapes *s, int plain,
                                                 const nurbs_call_options *call, LongResult *r) {
    const double lower[] = {-0.1, -0.1, -1.5}, upper[] = {1.1, 1.1, 1.5};
    return plain ? nurbs_free_form_deform(s->hill, s->block, lower, upper, 1e-3, LONG_V, r->states, &r->out)
                 : nurbs_free_form_deform_with(s->hill, s->block, lower, upper, 1e-3, LONG_V, r->states, call,
                                               &r->out);
}
LONG_HANDLE(fair, s->rough, 2, NULL, 1e-2, LONG_V, LONG_V + 2)

static inline nurbs_status long_read(const LongShapes *s, int plain, const nurbs_call_options *call,
                                     LongResult *r) {
    return plain ? nurbs_read(s->file, s->file_size, NULL, &r->list)
                 : nurbs_read_with(s->file, s->file_size, NULL, call, &r->list);
}
/* Of each program its own: tests run side by side. */
#ifndef LONG_PATH
#define LONG_PATH "long_calls_test.igs"
#endif
static const char *const long_path = LONG_PATH;
static inline nurbs_status long_read_file(const LongShapes *s, int plain, const nurbs_call_options *call,
                                          LongResult *r) {
    (void)s;
    return plain ? nurbs_read_file(long_path, NULL, &r->list)
                 : nurbs_read_file_with(long_path, NULL, call, &r->list);
}

static inline nurbs_closest_query long_query(const LongShapes *s) {
    nurbs_closest_query query;
    memset(&query, 0, sizeof query);
    query.struct_size = sizeof query;
    query.n = s->n;
    query.points = s->points;
    return query;
}
static inline nurbs_closest_answer long_answer(LongResult *r) {
    nurbs_closest_answer answer;
    memset(&answer, 0, sizeof answer);
    answer.struct_size = sizeof answer;
    answer.params = LONG_V;
    answer.status = r->states;
    return answer;
}
#define LONG_BATCH(name, g, ...)                                                                             \
    static inline nurbs_status long_##name(const LongShapes *s, int plain, const nurbs_call_options *call,   \
                                           LongResult *r) {                                                  \
        nurbs_closest_query query = long_query(s);                                                           \
        nurbs_closest_answer answer = long_answer(r);                                                        \
        if (plain) {                                                                                         \
            return nurbs_##name(g, s->n, s->points, 0, 0, __VA_ARGS__, LONG_V, 0, 0, NULL, 0, 0, NULL, 0,    \
                                r->states, 0);                                                               \
        }                                                                                                    \
        LONG_MORE(query)                                                                                     \
        return nurbs_##name##_with(g, &query, &answer, call);                                                \
    }
#define LONG_MORE(query)
LONG_BATCH(closest_points, s->rough, NULL, 0, 0)
LONG_BATCH(farthest_points, s->knotted, NULL, 0, 0)
#undef LONG_MORE
#define LONG_MORE(query) (query).guesses = s->params;
LONG_BATCH(closest_local, s->rough, s->params, 0, 0)

static inline nurbs_status long_curve_signed_distances(const LongShapes *s, int plain,
                                                       const nurbs_call_options *call, LongResult *r) {
    nurbs_closest_query query = long_query(s);
    nurbs_closest_answer answer = long_answer(r);
    answer.params = NULL;
    answer.distances = LONG_V;
    return plain ? nurbs_curve_signed_distances(s->plane, s->n, s->points, 0, 0, 0, 0, LONG_V, 0, NULL, 0,
                                                r->states, 0)
                 : nurbs_curve_signed_distances_with(s->plane, &query, &answer, call);
}

static inline nurbs_status long_constrain(const LongShapes *s, int plain, const nurbs_call_options *call,
                                          LongResult *r) {
    const int64_t count = s->n / 4 + 1;
    nurbs_constraints wanted;
    nurbs_constraint_report report;
    nurbs_status status;
    double rising[long_points];
    for (int64_t i = 0; i < count; ++i) {
        rising[i] = ((double)i + 0.5) / (double)count;
    }
    if (plain) {
        return nurbs_constrain(s->smooth, count, NULL, NULL, rising, s->points, NULL, NULL, NULL, 0, LONG_V,
                               r->counts, LONG_V + long_points, LONG_V + long_points + 1, &r->out);
    }
    memset(&wanted, 0, sizeof wanted);
    memset(&report, 0x5a, sizeof report);
    wanted.struct_size = sizeof wanted;
    wanted.count = count;
    wanted.params = rising;
    wanted.targets = s->points;
    report.struct_size = sizeof report;
    report.residuals = LONG_V;
    status = nurbs_constrain_with(s->smooth, &wanted, &report, call, &r->out);
    memcpy(r->counts, &report.rank, sizeof report.rank);
    memcpy(LONG_V + long_points, &report.moved, sizeof report.moved);
    memcpy(LONG_V + long_points + 1, &report.optimality, sizeof report.optimality);
    return status;
}

typedef struct {
    const char *name;
    LongCall run;
    int answers; /* at the limit of work with NURBS_OK */
} LongEntry;

static const LongEntry long_calls[] = {
    {"closest_points", long_closest_points, 1},
    {"farthest_points", long_farthest_points, 1},
    {"closest_local", long_closest_local, 1},
    {"curve_signed_distances", long_curve_signed_distances, 1},
    {"closest_all", long_closest_all, 1},
    {"critical_points", long_critical_points, 1},
    {"distance", long_distance, 1},
    {"hausdorff_distance", long_hausdorff_distance, 1},
    {"curve_features", long_curve_features, 1},
    {"fold_test", long_fold_test, 1},
    {"product", long_product, 0},
    {"compose", long_compose, 0},
    {"reduce_knots", long_reduce_knots, 0},
    {"reduce_degree", long_reduce_degree, 0},
    {"simplify", long_simplify, 0},
    {"recognize", long_recognize, 0},
    {"curve_length", long_curve_length, 0},
    {"curve_lengths", long_curve_lengths, 0},
    {"curve_params_at_lengths", long_curve_params_at_lengths, 0},
    {"curve_divide", long_curve_divide, 0},
    {"surface_area", long_surface_area, 0},
    {"moments", long_moments, 0},
    {"enclosed_area", long_enclosed_area, 0},
    {"enclosed_volume", long_enclosed_volume, 0},
    {"bend", long_bend, 0},
    {"free_form_deform", long_free_form_deform, 0},
    {"fair", long_fair, 0},
    {"constrain", long_constrain, 0},
    {"read", long_read, 0},
    {"read_file", long_read_file, 0},
};
enum { long_call_count = sizeof long_calls / sizeof *long_calls };

#endif
