/* SPDX-License-Identifier: MIT */
/* nurbs_version(), nurbs_status_name() and nurbs_last_error() in one thread. */
#include "check.h"
#include "shapes.h"

#include <stdint.h>

static void version(void) {
    CHECK_INT(nurbs_version(), NURBS_VERSION);
    CHECK_INT(NURBS_VERSION, NURBS_VERSION_MAJOR * 10000 + NURBS_VERSION_MINOR * 100 + NURBS_VERSION_PATCH);
}

#define NAME(status)                                                                                         \
    { status, #status }

static void names(void) {
    static const struct {
        nurbs_status status;
        const char *name;
    } all[] = {NAME(NURBS_OK),
               NAME(NURBS_ERROR_NULL),
               NAME(NURBS_ERROR_AXES),
               NAME(NURBS_ERROR_AXIS),
               NAME(NURBS_ERROR_DEGREE),
               NAME(NURBS_ERROR_COUNT),
               NAME(NURBS_ERROR_TOO_FEW_POINTS),
               NAME(NURBS_ERROR_OVERFLOW),
               NAME(NURBS_ERROR_SIZE),
               NAME(NURBS_ERROR_DIMENSION),
               NAME(NURBS_ERROR_STRIDE),
               NAME(NURBS_ERROR_OVERLAP),
               NAME(NURBS_ERROR_FLAGS),
               NAME(NURBS_ERROR_ORDER),
               NAME(NURBS_ERROR_KNOT_NOT_FINITE),
               NAME(NURBS_ERROR_KNOTS_DECREASING),
               NAME(NURBS_ERROR_END_MULTIPLICITY),
               NAME(NURBS_ERROR_MULTIPLICITY),
               NAME(NURBS_ERROR_EMPTY_DOMAIN),
               NAME(NURBS_ERROR_POINT_NOT_FINITE),
               NAME(NURBS_ERROR_WEIGHT_NOT_FINITE),
               NAME(NURBS_ERROR_WEIGHT_NEGATIVE),
               NAME(NURBS_ERROR_WEIGHTS_VANISH),
               NAME(NURBS_ERROR_PARAMETER_NOT_FINITE),
               NAME(NURBS_ERROR_PERIODIC_KNOTS),
               NAME(NURBS_ERROR_PERIODIC_POINTS),
               NAME(NURBS_ERROR_TIMES),
               NAME(NURBS_ERROR_OPTIONS),
               NAME(NURBS_ERROR_INDEX),
               NAME(NURBS_ERROR_DIRECTION),
               NAME(NURBS_ERROR_END_KNOT),
               NAME(NURBS_ERROR_NOT_A_KNOT),
               NAME(NURBS_ERROR_MATRIX),
               NAME(NURBS_ERROR_RATIONAL),
               NAME(NURBS_ERROR_INCOMPATIBLE),
               NAME(NURBS_ERROR_GAP),
               NAME(NURBS_ERROR_TOLERANCE),
               NAME(NURBS_ERROR_NOT_PERIODIC),
               NAME(NURBS_ERROR_END_WEIGHTS),
               NAME(NURBS_ERROR_FACTOR),
               NAME(NURBS_ERROR_PERIODIC),
               NAME(NURBS_ERROR_END),
               NAME(NURBS_ERROR_BASIS),
               NAME(NURBS_ERROR_NOT_MONOTONE),
               NAME(NURBS_ERROR_ANGLE),
               NAME(NURBS_ERROR_LENGTH),
               NAME(NURBS_ERROR_COLLINEAR),
               NAME(NURBS_ERROR_CONIC),
               NAME(NURBS_ERROR_FORM),
               NAME(NURBS_ERROR_TANGENT),
               NAME(NURBS_ERROR_TWIST),
               NAME(NURBS_ERROR_TWIST_RULE),
               NAME(NURBS_ERROR_INFLUENCE),
               NAME(NURBS_ERROR_CONTRADICTION),
               NAME(NURBS_ERROR_CONSTRAINT),
               NAME(NURBS_ERROR_OFF_POLYGON),
               NAME(NURBS_ERROR_RULE),
               NAME(NURBS_ERROR_SCHOENBERG_WHITNEY),
               NAME(NURBS_ERROR_RANK),
               NAME(NURBS_ERROR_SCALE),
               NAME(NURBS_ERROR_CONTINUITY),
               NAME(NURBS_ERROR_WEIGHT_SIGN),
               NAME(NURBS_ERROR_OUTSIDE_DOMAIN),
               NAME(NURBS_ERROR_NOT_REPRESENTABLE),
               NAME(NURBS_ERROR_KNOTS_MERGE),
               NAME(NURBS_ERROR_NOT_CONVERGED),
               NAME(NURBS_ERROR_MEMORY),
               NAME(NURBS_ERROR_FILE),
               NAME(NURBS_ERROR_TOO_LARGE),
               NAME(NURBS_ERROR_CANCELLED),
               NAME(NURBS_ERROR_WORK),
               NAME(NURBS_ERROR_FORMAT),
               NAME(NURBS_ERROR_TRUNCATED),
               NAME(NURBS_ERROR_SYNTAX),
               NAME(NURBS_ERROR_UNSUPPORTED),
               NAME(NURBS_ERROR_CHECKSUM),
               NAME(NURBS_ERROR_VERSION),
               NAME(NURBS_ERROR_CYCLE),
               NAME(NURBS_ERROR_ORIENTATION),
               NAME(NURBS_ERROR_SAME),
               NAME(NURBS_ERROR_CROSSING),
               NAME(NURBS_ERROR_INTERNAL)};
    const size_t count = sizeof all / sizeof *all;
    size_t known = 0;
    for (size_t i = 0; i < count; ++i) {
        CHECK(strcmp(nurbs_status_name(all[i].status), all[i].name) == 0);
    }
    for (nurbs_status s = -10; s < 1100; ++s) {
        known += strcmp(nurbs_status_name(s), "NURBS_ERROR_UNKNOWN") != 0;
    }
    CHECK_INT(known, count);
    CHECK(strcmp(nurbs_status_name(INT32_MAX), "NURBS_ERROR_UNKNOWN") == 0);
    CHECK(strcmp(nurbs_status_name(INT32_MIN), "NURBS_ERROR_UNKNOWN") == 0);
}

/* Before any failure the message is empty; this has to run first. */
static void empty_at_first(void) {
    char text[4] = "abc";
    CHECK_INT(nurbs_last_error(text, 4), 0);
    CHECK_INT(text[0], 0);
    CHECK_INT(nurbs_last_error(NULL, 0), 0);
}

/* A buffer of cap bytes holds cap - 1 characters and the zero; nothing behind it is written. */
static void truncation(void) {
    char whole[check_text_size], part[check_text_size];
    check_forget();
    const int64_t length = nurbs_last_error(whole, check_text_size);
    CHECK(length > 8);
    CHECK_INT(strlen(whole), length);
    CHECK_INT(nurbs_last_error(NULL, 0), length);
    CHECK_INT(nurbs_last_error(NULL, -1), length);
    CHECK_INT(nurbs_last_error(NULL, INT64_MIN), length);
    for (int64_t cap = 1; cap <= length + 2; ++cap) {
        const size_t kept = (size_t)(cap - 1 < length ? cap - 1 : length);
        FILL(part);
        CHECK_INT(nurbs_last_error(part, cap), length);
        CHECK(memcmp(part, whole, kept) == 0);
        CHECK_INT(part[kept], 0);
        check_untouched(__FILE__, __LINE__, part + kept + 1, sizeof part - kept - 1);
    }
    FILL(part);
    CHECK_INT(nurbs_last_error(part, 0), length);
    CHECK_INT(nurbs_last_error(part, -5), length);
    CHECK_UNTOUCHED(part);
}

/* The example of the header. */
static void names_array_index_and_value(void) {
    double params[18], points[36];
    char text[check_text_size];
    nurbs *g = make(arch());
    for (int i = 0; i < 18; ++i) {
        params[i] = i / 20.0;
    }
    params[17] = 1.25;
    CHECK_FAILS(nurbs_eval(g, 18, params, 0, 0, points, 0, 0, 0), NURBS_ERROR_OUTSIDE_DOMAIN,
                "params[17|1.25|[0, 1]");
    (void)nurbs_last_error(text, check_text_size);
    CHECK_OK(nurbs_eval(g, 17, params, 0, 0, points, 0, 0, 0));
    CHECK(strcmp(text, (nurbs_last_error(check_before, check_text_size), check_before)) == 0);
    nurbs_destroy(g);
    nurbs_destroy(NULL);
    (void)nurbs_status_name(3);
    (void)nurbs_version();
    CHECK(strcmp(text, (nurbs_last_error(check_before, check_text_size), check_before)) == 0);
}

int main(void) {
    empty_at_first();
    version();
    names();
    truncation();
    names_array_index_and_value();
    return check_summary("error_text");
}
