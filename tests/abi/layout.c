/* Sizes and offsets that compiled programs rely on. They may only grow at the end. */
#include <nurbs/nurbs.h>
#include <stddef.h>
#include <stdio.h>

static int failures;

static void pin(const char *what, size_t actual, size_t expected) {
    if (actual != expected) {
        fprintf(stderr, "%s is %lu, was %lu\n", what, (unsigned long)actual, (unsigned long)expected);
        ++failures;
    }
}

#define PIN(expression, expected) pin(#expression, expression, expected)

static void pin_read_options(void) {
    nurbs_read_options options;
    PIN(sizeof(nurbs_read_options), 24);
    PIN(offsetof(nurbs_read_options, struct_size), 0);
    PIN(offsetof(nurbs_read_options, unit), 8);
    PIN(offsetof(nurbs_read_options, max_bytes), 16);
    if (nurbs_read_options_init(&options, (int64_t)sizeof options) != NURBS_OK) {
        fprintf(stderr, "the library does not know the struct of this size\n");
        ++failures;
        return;
    }
    PIN((size_t)options.struct_size, 24);
    PIN((size_t)options.max_bytes, (size_t)1 << 30);
    if (options.unit != 0) {
        fprintf(stderr, "unit is not 0 by default\n");
        ++failures;
    }
}

/* Codes are compiled into callers: one that moves would be taken for another. */
static void pin_codes(void) {
    PIN(sizeof(nurbs_status), 4);
    PIN(NURBS_OK, 0);
    PIN(NURBS_ERROR_NULL, 1);
    PIN(NURBS_ERROR_AXES, 2);
    PIN(NURBS_ERROR_AXIS, 3);
    PIN(NURBS_ERROR_DEGREE, 4);
    PIN(NURBS_ERROR_COUNT, 5);
    PIN(NURBS_ERROR_TOO_FEW_POINTS, 6);
    PIN(NURBS_ERROR_OVERFLOW, 7);
    PIN(NURBS_ERROR_SIZE, 8);
    PIN(NURBS_ERROR_DIMENSION, 9);
    PIN(NURBS_ERROR_STRIDE, 10);
    PIN(NURBS_ERROR_OVERLAP, 11);
    PIN(NURBS_ERROR_FLAGS, 12);
    PIN(NURBS_ERROR_ORDER, 13);
    PIN(NURBS_ERROR_KNOT_NOT_FINITE, 14);
    PIN(NURBS_ERROR_KNOTS_DECREASING, 15);
    PIN(NURBS_ERROR_END_MULTIPLICITY, 16);
    PIN(NURBS_ERROR_MULTIPLICITY, 17);
    PIN(NURBS_ERROR_EMPTY_DOMAIN, 18);
    PIN(NURBS_ERROR_POINT_NOT_FINITE, 19);
    PIN(NURBS_ERROR_WEIGHT_NOT_FINITE, 20);
    PIN(NURBS_ERROR_WEIGHT_NEGATIVE, 21);
    PIN(NURBS_ERROR_WEIGHTS_VANISH, 22);
    PIN(NURBS_ERROR_PARAMETER_NOT_FINITE, 23);
    PIN(NURBS_ERROR_PERIODIC_KNOTS, 24);
    PIN(NURBS_ERROR_PERIODIC_POINTS, 25);
    PIN(NURBS_ERROR_TIMES, 26);
    PIN(NURBS_ERROR_OPTIONS, 27);
    PIN(NURBS_ERROR_INDEX, 28);
    PIN(NURBS_ERROR_DIRECTION, 29);
    PIN(NURBS_ERROR_END_KNOT, 30);
    PIN(NURBS_ERROR_NOT_A_KNOT, 31);
    PIN(NURBS_ERROR_MATRIX, 32);
    PIN(NURBS_ERROR_RATIONAL, 33);
    PIN(NURBS_ERROR_INCOMPATIBLE, 40);
    PIN(NURBS_ERROR_GAP, 41);
    PIN(NURBS_ERROR_TOLERANCE, 42);
    PIN(NURBS_ERROR_NOT_PERIODIC, 43);
    PIN(NURBS_ERROR_END_WEIGHTS, 44);
    PIN(NURBS_ERROR_FACTOR, 45);
    PIN(NURBS_ERROR_PERIODIC, 48);
    PIN(NURBS_ERROR_END, 49);
    PIN(NURBS_ERROR_BASIS, 50);
    PIN(NURBS_ERROR_NOT_MONOTONE, 51);
    PIN(NURBS_ERROR_CONTINUITY, 46);
    PIN(NURBS_ERROR_WEIGHT_SIGN, 47);
    PIN(NURBS_ERROR_ANGLE, 52);
    PIN(NURBS_ERROR_LENGTH, 53);
    PIN(NURBS_ERROR_COLLINEAR, 54);
    PIN(NURBS_ERROR_CONIC, 55);
    PIN(NURBS_ERROR_FORM, 56);
    PIN(NURBS_ERROR_TANGENT, 57);
    PIN(NURBS_ERROR_TWIST, 58);
    PIN(NURBS_ERROR_TWIST_RULE, 59);
    PIN(NURBS_ERROR_OUTSIDE_DOMAIN, 100);
    PIN(NURBS_ERROR_NOT_REPRESENTABLE, 200);
    PIN(NURBS_ERROR_KNOTS_MERGE, 202);
    PIN(NURBS_ERROR_MEMORY, 300);
    PIN(NURBS_ERROR_FILE, 301);
    PIN(NURBS_ERROR_TOO_LARGE, 302);
    PIN(NURBS_ERROR_FORMAT, 400);
    PIN(NURBS_ERROR_TRUNCATED, 401);
    PIN(NURBS_ERROR_SYNTAX, 402);
    PIN(NURBS_ERROR_UNSUPPORTED, 403);
    PIN(NURBS_ERROR_INTERNAL, 900);
}

static void pin_flags(void) {
    PIN(NURBS_LEFT, 1);
    PIN(NURBS_CLAMP, 2);
    PIN(NURBS_EXTRAPOLATE, 4);
    PIN(NURBS_WRAP, 8);
    PIN(NURBS_NAN, 16);
    PIN(NURBS_PERIODIC, 1);
    PIN(NURBS_KEEP_DOMAIN, 0x02000000);
    PIN(NURBS_KEEP_GAPS, 0x04000000);
    PIN(NURBS_PRODUCT_DOT, 0x08000000);
    PIN(NURBS_PRODUCT_CROSS, 0x10000000);
    PIN(NURBS_HOMOGENEOUS, 0x20000000);
    PIN(NURBS_MAP_DOMAINS, 0x40000000);
    PIN(NURBS_RULED_CARTESIAN, 0x80000000);
    PIN(NURBS_HEMISPHERE, 0x01000000);
    PIN(NURBS_TWO_SHEETS, 0x02000000);
    PIN(NURBS_BASIS_POWER, 0);
    PIN(NURBS_BASIS_BERNSTEIN, 1);
    PIN(NURBS_BASIS_HERMITE, 2);
    PIN(NURBS_BASIS_BSPLINE, 3);
    PIN(NURBS_START, 0);
    PIN(NURBS_END, 1);
    PIN(NURBS_FORM_CLAMPED_START, 1);
    PIN(NURBS_FORM_CLAMPED_END, 2);
    PIN(NURBS_FORM_PERIODIC, 4);
    PIN(NURBS_FRAME_LIMIT, 1);
    PIN(NURBS_FRAME_NORMAL_LIMIT, 2);
    PIN(NURBS_FRAME_RULE, 4);
    PIN(NURBS_FRAME_UNDEFINED, 8);
    PIN(NURBS_ON_AXIS(2, NURBS_LEFT), 0x10000);
    PIN(NURBS_ON_ALL_AXES(1, NURBS_CLAMP), 0x2);
    PIN(NURBS_ON_ALL_AXES(2, NURBS_CLAMP), 0x202);
    PIN(NURBS_ON_ALL_AXES(3, NURBS_CLAMP), 0x20202);
    PIN(NURBS_MAX_DEGREE, 31);
    PIN(NURBS_MAX_AXES, 3);
    PIN(NURBS_MAX_ORDER, 255);
}

static void pin_kinds(void) {
    PIN(NURBS_ARC_QUARTERS, 0);
    PIN(NURBS_ARC_THIRDS, 1);
    PIN(NURBS_ARC_SMOOTH, 2);
    PIN(NURBS_CONIC_ELLIPSE, 1);
    PIN(NURBS_CONIC_PARABOLA, 2);
    PIN(NURBS_CONIC_HYPERBOLA, 3);
    PIN(NURBS_CONIC_CHORD, 4);
    PIN(NURBS_CONIC_LEGS, 5);
    PIN(NURBS_CONIC_LINE, 6);
    PIN(NURBS_TWIST_COMPATIBLE, 0);
    PIN(NURBS_TWIST_AVERAGE, 1);
    PIN(NURBS_TWIST_GIVEN, 2);
    PIN(NURBS_TWIST_ZERO, 3);
    PIN(NURBS_TWIST_BILINEAR, 4);
    PIN(NURBS_TWIST_ADINI, 5);
    PIN(NURBS_SHAPE_NONE, 0);
    PIN(NURBS_SHAPE_POINT, 1);
    PIN(NURBS_SHAPE_LINE, 2);
    PIN(NURBS_SHAPE_CIRCLE, 3);
    PIN(NURBS_SHAPE_ELLIPSE, 4);
    PIN(NURBS_SHAPE_PARABOLA, 5);
    PIN(NURBS_SHAPE_HYPERBOLA, 6);
    PIN(NURBS_SHAPE_PLANE, 7);
    PIN(NURBS_SHAPE_SPHERE, 8);
    PIN(NURBS_SHAPE_CYLINDER, 9);
    PIN(NURBS_SHAPE_CONE, 10);
    PIN(NURBS_SHAPE_TORUS, 11);
}

int main(void) {
    pin_read_options();
    pin_codes();
    pin_flags();
    pin_kinds();
    printf("%d differences\n", failures);
    return failures == 0 ? 0 : 1;
}
