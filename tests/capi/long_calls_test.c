/* SPDX-License-Identifier: MIT */
/* Every function nurbs_X_with: the answers of its plain form; what its callback sees and does; limits of work; wrong
 * structs. */
#include "long_calls.h"

typedef struct {
    int calls, stop_after; /* progress returns 7 then */
    double last;
    int wrong;
    const LongShapes *shapes; /* asked by the callback, if not NULL */
} Watcher;

static int32_t watch(double done, void *user) {
    Watcher *w = (Watcher *)user;
    w->wrong += !(done >= w->last && done >= 0 && done <= 1);
    w->last = done;
    if (w->shapes != NULL) { /* a call of its own, on a handle in use */
        const double t[] = {0.5, 0.5};
        double x[3], length;
        w->wrong += nurbs_eval(w->shapes->rough, 1, t, 0, 0, x, 0, 0, 0) != NURBS_OK;
        w->wrong += nurbs_curve_length(w->shapes->plane, NULL, 1e-6, &length, NULL) != NURBS_OK;
        w->wrong += nurbs_eval(w->shapes->rough, 1, NULL, 0, 0, x, 0, 0, 0) != NURBS_ERROR_NULL;
    }
    return ++w->calls >= w->stop_after ? 7 : 0;
}

static nurbs_call_options options_for(Watcher *w, int64_t work) {
    nurbs_call_options call;
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    call.work = work;
    call.progress = w == NULL ? NULL : watch;
    call.user = w;
    return call;
}

static LongResult *fresh(void) {
    LongResult *r = malloc(sizeof *r);
    memset(r, 0x5a, sizeof *r);
    r->out = NULL;
    r->list = NULL;
    return r;
}

static void discard(LongResult *r) {
    nurbs_destroy(r->out);
    nurbs_list_destroy(r->list);
    free(r);
}

static void check_same_spline(const nurbs *a, const nurbs *b) {
    int64_t n = 0, m = 0;
    int32_t dim = 0;
    CHECK(nurbs_point_count(a, &n) == NURBS_OK && nurbs_point_count(b, &m) == NURBS_OK && n == m);
    CHECK(nurbs_dimension(a, &dim) == NURBS_OK);
    if (n == m) {
        const size_t bytes = (size_t)(n * (dim + 1)) * sizeof(double);
        double *p = malloc(bytes), *q = malloc(bytes);
        CHECK(nurbs_homogeneous_points(a, n, p, 0, 0) == NURBS_OK &&
              nurbs_homogeneous_points(b, n, q, 0, 0) == NURBS_OK);
        CHECK_BITS(p, q, bytes);
        free(p);
        free(q);
    }
}

static void check_same(const char *name, const LongResult *a, const LongResult *b) {
    const int before = check_failures;
    int64_t n = 0, m = 0;
    CHECK_BITS(a->values, b->values, sizeof a->values);
    CHECK_BITS(a->counts, b->counts, sizeof a->counts);
    CHECK_BITS(a->states, b->states, sizeof a->states);
    CHECK((a->out == NULL) == (b->out == NULL) && (a->list == NULL) == (b->list == NULL));
    if (a->out != NULL && b->out != NULL) {
        check_same_spline(a->out, b->out);
    }
    if (a->list != NULL && b->list != NULL) {
        CHECK(nurbs_list_count(a->list, &n) == NURBS_OK && nurbs_list_count(b->list, &m) == NURBS_OK &&
              n == m && n > 0);
    }
    if (check_failures != before) {
        fprintf(stderr, "in %s\n", name);
    }
}

static void check_nothing_written(const char *name, const LongResult *r) {
    const int before = check_failures;
    CHECK_UNTOUCHED(r->values);
    CHECK_UNTOUCHED(r->states);
    CHECK_UNTOUCHED(r->counts);
    CHECK(r->out == NULL && r->list == NULL);
    if (check_failures != before) {
        fprintf(stderr, "in %s\n", name);
    }
}

static void answers(const LongShapes *s, const LongEntry *entry, const LongResult *plain) {
    Watcher w = {0, 1 << 30, 0, 0, s};
    nurbs_call_options call = options_for(&w, 0);
    LongResult *r = fresh();
    CHECK_OK(entry->run(s, 0, NULL, r));
    check_same(entry->name, r, plain);
    discard(r);
    r = fresh();
    CHECK(entry->run(s, 0, &call, r) == NURBS_OK); /* the callback leaves messages */
    CHECK_INT(w.wrong, 0);
    check_same(entry->name, r, plain);
    discard(r);
}

/* After a cancelled call the handles answer as before. */
static void cancelled(const LongShapes *s, const LongEntry *entry, const LongResult *plain) {
    Watcher w = {0, 1, 0, 0, NULL};
    nurbs_call_options call = options_for(&w, 0);
    LongResult *r = fresh();
    check_forget();
    const nurbs_status status = entry->run(s, 0, &call, r);
    if (w.calls == 0) { /* it took less than 10 ms */
        CHECK_INT(status, NURBS_OK);
    } else {
        check_refusal(__FILE__, __LINE__, status, NURBS_ERROR_CANCELLED, "progress|7");
        CHECK_INT(w.calls, 1);
        check_nothing_written(entry->name, r);
    }
    discard(r);
    r = fresh();
    CHECK_OK(entry->run(s, 1, NULL, r));
    check_same(entry->name, r, plain);
    discard(r);
}

static void limited(const LongShapes *s, const LongEntry *entry, const LongResult *plain) {
    for (int64_t work = 1; work < 100000000; work *= 50) {
        nurbs_call_options call = options_for(NULL, work);
        LongResult *a = fresh(), *b = fresh();
        const nurbs_status first = entry->run(s, 0, &call, a), second = entry->run(s, 0, &call, b);
        CHECK_INT(first, second); /* no clock decides */
        CHECK(first == NURBS_OK || (first == NURBS_ERROR_WORK && !entry->answers));
        if (first != NURBS_OK && entry->answers) {
            fprintf(stderr, "in %s with %lld\n", entry->name, (long long)work);
        }
        if (first == NURBS_OK) {
            check_same(entry->name, a, b);
        } else {
            check_nothing_written(entry->name, a);
        }
        if (first == NURBS_OK && !entry->answers) {
            check_same(entry->name, a, plain);
        }
        discard(a);
        discard(b);
    }
}

/* What searches say at the limit. */
static void answers_at_the_limit(const LongShapes *s) {
    nurbs_call_options call = options_for(NULL, 1);
    double least = -1, most = -1;
    int64_t count = -1;
    int32_t state = -1, status[long_points];
    nurbs_closest_query query = long_query(s);
    nurbs_closest_answer answer;
    CHECK_OK(nurbs_distance_with(s->rough, s->other, 0, 0, &least, &most, NULL, NULL, &state, &call));
    CHECK(state == NURBS_CLOSEST_BUDGET && least >= 0 && least <= most);
    CHECK_OK(nurbs_curve_features_with(s->plane, NURBS_FEATURE_INFLECTION, 0, NULL, NULL, NULL, &count,
                                       &state, &call));
    CHECK_INT(state, 0);
    CHECK_OK(nurbs_fold_test_with(s->folded, NULL, &state, NULL, NULL, &call));
    CHECK_INT(state, NURBS_FOLD_UNDECIDED);
    memset(&answer, 0, sizeof answer);
    answer.struct_size = sizeof answer;
    answer.status = status;
    CHECK_OK(nurbs_closest_points_with(s->rough, &query, &answer, &call));
    CHECK((status[s->n - 1] & NURBS_CLOSEST_BUDGET) != 0 &&
          (status[s->n - 1] & NURBS_CLOSEST_CERTIFIED) == 0);
    query.guesses = s->params;
    CHECK_OK(nurbs_closest_local_with(s->rough, &query, &answer, &call));
    CHECK((status[s->n - 1] & NURBS_CLOSEST_BUDGET) != 0);
}

static void wrong_options(const LongShapes *s, const LongEntry *entry) {
    struct {
        nurbs_call_options known;
        int64_t more;
    } newer;
    nurbs_call_options call = options_for(NULL, 0);
    LongResult *r = fresh();
    call.struct_size = sizeof call - 1;
    CHECK_FAILS(entry->run(s, 0, &call, r), NURBS_ERROR_OPTIONS, "call|struct_size");
    call.struct_size = 0;
    CHECK_FAILS(entry->run(s, 0, &call, r), NURBS_ERROR_OPTIONS, "call|struct_size = 0");
    call = options_for(NULL, -1);
    CHECK_FAILS(entry->run(s, 0, &call, r), NURBS_ERROR_OPTIONS, "call|work = -1");
    newer.known = options_for(NULL, 0);
    newer.known.struct_size = sizeof newer;
    newer.more = 1;
    CHECK_FAILS(entry->run(s, 0, &newer.known, r), NURBS_ERROR_OPTIONS, "call|unknown");
    check_nothing_written(entry->name, r);
    newer.more = 0;
    CHECK_OK(entry->run(s, 0, &newer.known, r));
    discard(r);
}

static void options(void) {
    nurbs_call_options call;
    memset(&call, 0x5a, sizeof call);
    CHECK_FAILS(nurbs_call_options_init(NULL, sizeof call), NURBS_ERROR_NULL, "options");
    CHECK_FAILS(nurbs_call_options_init(&call, 8), NURBS_ERROR_OPTIONS, "struct_size = 8");
    CHECK_FAILS(nurbs_call_options_init(&call, 5000), NURBS_ERROR_OPTIONS, "struct_size = 5000|4096");
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    CHECK(call.struct_size == sizeof call && call.work == 0 && call.progress == NULL && call.user == NULL);
}

static void wrong_batches(const LongShapes *s) {
    LongResult *r = fresh();
    nurbs_closest_query query = long_query(s);
    nurbs_closest_answer answer = long_answer(r);
    const double range[] = {0, 1, 0, 1};
    CHECK_FAILS(nurbs_closest_points_with(s->rough, NULL, &answer, NULL), NURBS_ERROR_NULL, "query");
    CHECK_FAILS(nurbs_closest_points_with(s->rough, &query, NULL, NULL), NURBS_ERROR_NULL, "answer");
    CHECK_FAILS(nurbs_closest_points_with(NULL, &query, &answer, NULL), NURBS_ERROR_NULL, "g");
    query.struct_size = 8;
    CHECK_FAILS(nurbs_closest_points_with(s->rough, &query, &answer, NULL), NURBS_ERROR_OPTIONS,
                "query|struct_size");
    query.struct_size = sizeof query;
    answer.struct_size = -1;
    CHECK_FAILS(nurbs_farthest_points_with(s->rough, &query, &answer, NULL), NURBS_ERROR_OPTIONS,
                "answer|struct_size");
    answer.struct_size = sizeof answer;
    query.guesses = s->params;
    CHECK_FAILS(nurbs_farthest_points_with(s->rough, &query, &answer, NULL), NURBS_ERROR_OPTIONS,
                "query.guesses");
    CHECK_FAILS(nurbs_curve_signed_distances_with(s->plane, &query, &answer, NULL), NURBS_ERROR_OPTIONS,
                "query.guesses");
    query.tolerance = 1;
    CHECK_FAILS(nurbs_closest_local_with(s->rough, &query, &answer, NULL), NURBS_ERROR_OPTIONS,
                "query.tolerance");
    query.tolerance = 0;
    query.budget = 1;
    CHECK_FAILS(nurbs_closest_local_with(s->rough, &query, &answer, NULL), NURBS_ERROR_OPTIONS,
                "query.budget");
    query.budget = 0;
    query.range = range;
    CHECK_FAILS(nurbs_closest_local_with(s->rough, &query, &answer, NULL), NURBS_ERROR_OPTIONS,
                "query.range");
    query.range = NULL;
    query.reserved = 1;
    CHECK_FAILS(nurbs_closest_local_with(s->rough, &query, &answer, NULL), NURBS_ERROR_OPTIONS,
                "query.reserved");
    query.reserved = 0;
    query.guesses = NULL;
    CHECK_FAILS(nurbs_closest_local_with(s->rough, &query, &answer, NULL), NURBS_ERROR_NULL, "guesses");
    query.n = -1;
    CHECK_FAILS(nurbs_closest_points_with(s->rough, &query, &answer, NULL), NURBS_ERROR_COUNT, "n = -1");
    query = long_query(s);
    answer.feet = r->values + 2000;
    CHECK_FAILS(nurbs_curve_signed_distances_with(s->plane, &query, &answer, NULL), NURBS_ERROR_OPTIONS,
                "answer.feet");
    check_nothing_written("batches", r);
    discard(r);
}

static void wrong_constraints(const LongShapes *s) {
    nurbs_constraints wanted;
    nurbs_constraint_report report;
    nurbs *out;
    memset(&wanted, 0, sizeof wanted);
    memset(&report, 0, sizeof report);
    CHECK_NO_HANDLE(out, nurbs_constrain_with(s->smooth, NULL, &report, NULL, &out), NURBS_ERROR_NULL,
                    "constraints");
    CHECK_NO_HANDLE(out, nurbs_constrain_with(s->smooth, &wanted, &report, NULL, &out), NURBS_ERROR_OPTIONS,
                    "constraints|struct_size");
    wanted.struct_size = sizeof wanted;
    CHECK_NO_HANDLE(out, nurbs_constrain_with(s->smooth, &wanted, &report, NULL, &out), NURBS_ERROR_OPTIONS,
                    "report|struct_size");
    report.struct_size = sizeof report;
    CHECK_NO_HANDLE(out, nurbs_constrain_with(s->smooth, &wanted, &report, NULL, &out), NURBS_ERROR_COUNT,
                    "count");
    CHECK_NO_HANDLE(out, nurbs_constrain_with(NULL, &wanted, &report, NULL, &out), NURBS_ERROR_NULL, "g");
    CHECK_FAILS(nurbs_constrain_with(s->smooth, &wanted, &report, NULL, NULL), NURBS_ERROR_NULL, "out");
}

int main(void) {
    const char *scale = getenv("NURBS_TEST_SCALE"); /* below 1 where the library is instrumented */
    LongShapes *s = long_shapes(scale != NULL && atof(scale) < 1 ? 0.5 : 4);
    FILE *file = fopen(long_path, "wb");
    CHECK(file != NULL && fwrite(s->file, 1, (size_t)s->file_size, file) == (size_t)s->file_size);
    CHECK(file == NULL || fclose(file) == 0);
    options();
    for (size_t i = 0; i < long_call_count; ++i) {
        LongResult *plain = fresh();
        CHECK_OK(long_calls[i].run(s, 1, NULL, plain));
        answers(s, &long_calls[i], plain);
        cancelled(s, &long_calls[i], plain);
        limited(s, &long_calls[i], plain);
        wrong_options(s, &long_calls[i]);
        discard(plain);
    }
    answers_at_the_limit(s);
    wrong_batches(s);
    wrong_constraints(s);
    remove(long_path);
    long_destroy(s);
    return check_summary("long_calls");
}
