/* SPDX-License-Identifier: MIT */
/* Of every function nurbs_X_with: 10^9 units of work take a second or two, and what its callback is told grows. */
#define _POSIX_C_SOURCE 200809L
#define LONG_PATH "long_calls_work_test.igs"
#include "long_calls.h"

#include <time.h>

static const double shortest = 0.05,
                    longest = 6; /* seconds for 10^9: other processors are faster, or slower */

static double seconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static void discard(LongResult *r) {
    nurbs_destroy(r->out);
    nurbs_list_destroy(r->list);
    memset(r, 0, sizeof *r);
}

/* Whether a call gets its whole answer within a limit. */
static int is_enough(const LongShapes *s, const LongEntry *entry, int64_t work, const LongResult *wanted,
                     LongResult *r) {
    nurbs_call_options call;
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    call.work = work;
    const nurbs_status status = entry->run(s, 0, &call, r);
    const int enough = status == NURBS_OK && memcmp(r->values, wanted->values, sizeof r->values) == 0 &&
                       memcmp(r->states, wanted->states, sizeof r->states) == 0 &&
                       memcmp(r->counts, wanted->counts, sizeof r->counts) == 0;
    discard(r);
    return enough;
}

/* The least limit, to about 6 %. */
static int64_t work_of(const LongShapes *s, const LongEntry *entry, const LongResult *wanted, LongResult *r) {
    int64_t high = 1;
    while (high < INT64_C(1) << 45 && !is_enough(s, entry, high, wanted, r)) {
        high *= 2;
    }
    int64_t low = high / 2;
    for (int i = 0; i < 4; ++i) {
        const int64_t middle = low / 2 + high / 2;
        if (is_enough(s, entry, middle, wanted, r)) {
            high = middle;
        } else {
            low = middle;
        }
    }
    return high;
}

static double time_of(const LongShapes *s, const LongEntry *entry, LongResult *r) {
    double least = 1e9;
    for (int i = 0; i < 3; ++i) {
        const double start = seconds();
        CHECK_OK(entry->run(s, 0, NULL, r));
        const double end = seconds();
        least = end - start < least ? end - start : least;
        discard(r);
    }
    return least;
}

static void takes_a_second_or_two(const LongShapes *s, const LongEntry *entry, const LongResult *wanted,
                                  LongResult *r) {
    const double unit = 1e9 * time_of(s, entry, r) / (double)work_of(s, entry, wanted, r);
    if (!(unit >= shortest && unit <= longest)) {
        fprintf(stderr, "%s: 10^9 multiply-adds take %.3g s\n", entry->name, unit);
    }
    CHECK(unit >= shortest && unit <= longest);
}

typedef struct {
    int calls;
    double first, last;
} Told;

static int32_t listen(double done, void *user) {
    Told *told = (Told *)user;
    told->first = told->calls++ == 0 ? done : told->first;
    told->last = done;
    return 0;
}

static void tells_how_much(const LongShapes *s, const LongEntry *entry, LongResult *r) {
    Told told = {0, 0, 0};
    nurbs_call_options call;
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    call.progress = listen;
    call.user = &told;
    CHECK_OK(entry->run(s, 0, &call, r));
    discard(r);
    const int wrong = told.calls >= 8 && !(told.first < 1 && told.last > told.first);
    if (wrong) {
        fprintf(stderr, "%s: told from %g to %g in %d calls\n", entry->name, told.first, told.last,
                told.calls);
    }
    CHECK(!wrong);
}

int main(void) {
    const char *scale = getenv("NURBS_TEST_SCALE"); /* below 1 where the library is instrumented */
    if (scale != NULL && atof(scale) < 1) {
        puts("skipped: an instrumented library has times of its own");
        return 77;
    }
    LongShapes *s = long_shapes(3);
    LongResult *wanted = (LongResult *)calloc(1, sizeof(LongResult)),
               *r = (LongResult *)calloc(1, sizeof(LongResult));
    FILE *file = fopen(long_path, "wb");
    CHECK(file != NULL && fwrite(s->file, 1, (size_t)s->file_size, file) == (size_t)s->file_size);
    CHECK(file == NULL || fclose(file) == 0);
    for (size_t i = 0; i < long_call_count; ++i) {
        CHECK_OK(long_calls[i].run(s, 1, NULL, wanted)); /* makes the tables that handles keep */
        tells_how_much(s, &long_calls[i], r);
        takes_a_second_or_two(s, &long_calls[i], wanted, r);
        discard(wanted);
    }
    free(wanted);
    free(r);
    remove(long_path);
    long_destroy(s);
    return check_summary("long_calls_work");
}
