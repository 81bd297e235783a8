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
    PIN(sizeof(nurbs_read_options), 40);
    PIN(offsetof(nurbs_read_options, struct_size), 0);
    PIN(offsetof(nurbs_read_options, unit), 8);
    PIN(offsetof(nurbs_read_options, max_bytes), 16);
    PIN(offsetof(nurbs_read_options, tolerance), 24);
    PIN(offsetof(nurbs_read_options, kinds), 32);
    PIN(offsetof(nurbs_read_options, reserved), 36);
    if (nurbs_read_options_init(&options, (int64_t)sizeof options) != NURBS_OK) {
        fprintf(stderr, "the library does not know the struct of this size\n");
        ++failures;
        return;
    }
    PIN((size_t)options.struct_size, 40);
    PIN((size_t)options.max_bytes, (size_t)1 << 30);
    if (options.unit != 0 || options.tolerance != 0 || options.kinds != 0 || options.reserved != 0) {
        fprintf(stderr, "unit, tolerance and kinds are not 0 by default\n");
        ++failures;
    }
}

static void pin_write_options(void) {
    nurbs_write_options options;
    PIN(sizeof(nurbs_write_options), 24);
    PIN(offsetof(nurbs_write_options, struct_size), 0);
    PIN(offsetof(nurbs_write_options, unit), 8);
    PIN(offsetof(nurbs_write_options, tolerance), 16);
    if (nurbs_write_options_init(&options, (int64_t)sizeof options) != NURBS_OK) {
        fprintf(stderr, "the library does not know the struct of this size\n");
        ++failures;
        return;
    }
    PIN((size_t)options.struct_size, 24);
    if (options.unit != 0 || options.tolerance != 0) {
        fprintf(stderr, "unit and tolerance are not 0 by default\n");
        ++failures;
    }
}

static void pin_call_options(void) {
    nurbs_call_options options;
    PIN(sizeof(nurbs_call_options), 32);
    PIN(offsetof(nurbs_call_options, struct_size), 0);
    PIN(offsetof(nurbs_call_options, work), 8);
    PIN(offsetof(nurbs_call_options, progress), 16);
    PIN(offsetof(nurbs_call_options, user), 24);
    if (nurbs_call_options_init(&options, (int64_t)sizeof options) != NURBS_OK) {
        fprintf(stderr, "the library does not know the call options of this size\n");
        ++failures;
        return;
    }
    PIN((size_t)options.struct_size, 32);
    PIN((size_t)options.work, 0);
    if (options.progress != NULL || options.user != NULL) {
        fprintf(stderr, "there is a callback by default\n");
        ++failures;
    }
}

static void pin_closest_query(void) {
    PIN(sizeof(nurbs_closest_query), 96);
    PIN(offsetof(nurbs_closest_query, struct_size), 0);
    PIN(offsetof(nurbs_closest_query, n), 8);
    PIN(offsetof(nurbs_closest_query, points), 16);
    PIN(offsetof(nurbs_closest_query, point_stride), 24);
    PIN(offsetof(nurbs_closest_query, point_component_stride), 32);
    PIN(offsetof(nurbs_closest_query, guesses), 40);
    PIN(offsetof(nurbs_closest_query, guess_stride), 48);
    PIN(offsetof(nurbs_closest_query, guess_component_stride), 56);
    PIN(offsetof(nurbs_closest_query, range), 64);
    PIN(offsetof(nurbs_closest_query, tolerance), 72);
    PIN(offsetof(nurbs_closest_query, budget), 80);
    PIN(offsetof(nurbs_closest_query, flags), 88);
    PIN(offsetof(nurbs_closest_query, reserved), 92);
}

static void pin_closest_answer(void) {
    PIN(sizeof(nurbs_closest_answer), 80);
    PIN(offsetof(nurbs_closest_answer, struct_size), 0);
    PIN(offsetof(nurbs_closest_answer, params), 8);
    PIN(offsetof(nurbs_closest_answer, param_stride), 16);
    PIN(offsetof(nurbs_closest_answer, param_component_stride), 24);
    PIN(offsetof(nurbs_closest_answer, feet), 32);
    PIN(offsetof(nurbs_closest_answer, foot_stride), 40);
    PIN(offsetof(nurbs_closest_answer, foot_component_stride), 48);
    PIN(offsetof(nurbs_closest_answer, distances), 56);
    PIN(offsetof(nurbs_closest_answer, distance_stride), 64);
    PIN(offsetof(nurbs_closest_answer, status), 72);
}

static void pin_constraints(void) {
    PIN(sizeof(nurbs_constraints), 80);
    PIN(offsetof(nurbs_constraints, struct_size), 0);
    PIN(offsetof(nurbs_constraints, count), 8);
    PIN(offsetof(nurbs_constraints, kinds), 16);
    PIN(offsetof(nurbs_constraints, orders), 24);
    PIN(offsetof(nurbs_constraints, params), 32);
    PIN(offsetof(nurbs_constraints, targets), 40);
    PIN(offsetof(nurbs_constraints, keep), 48);
    PIN(offsetof(nurbs_constraints, costs), 56);
    PIN(offsetof(nurbs_constraints, weight_costs), 64);
    PIN(offsetof(nurbs_constraints, tolerance), 72);
}

static void pin_constraint_report(void) {
    PIN(sizeof(nurbs_constraint_report), 40);
    PIN(offsetof(nurbs_constraint_report, struct_size), 0);
    PIN(offsetof(nurbs_constraint_report, residuals), 8);
    PIN(offsetof(nurbs_constraint_report, rank), 16);
    PIN(offsetof(nurbs_constraint_report, moved), 24);
    PIN(offsetof(nurbs_constraint_report, optimality), 32);
}

static void pin_data(void) {
    nurbs_data data;
    PIN(sizeof(nurbs_data), 96);
    PIN(offsetof(nurbs_data, struct_size), 0);
    PIN(offsetof(nurbs_data, n), 8);
    PIN(offsetof(nurbs_data, axes), 16);
    PIN(offsetof(nurbs_data, dim), 20);
    PIN(offsetof(nurbs_data, params), 24);
    PIN(offsetof(nurbs_data, param_stride), 32);
    PIN(offsetof(nurbs_data, param_component_stride), 40);
    PIN(offsetof(nurbs_data, values), 48);
    PIN(offsetof(nurbs_data, value_stride), 56);
    PIN(offsetof(nurbs_data, value_component_stride), 64);
    PIN(offsetof(nurbs_data, weights), 72);
    PIN(offsetof(nurbs_data, weight_stride), 80);
    PIN(offsetof(nurbs_data, flags), 88);
    PIN(offsetof(nurbs_data, reserved), 92);
    if (nurbs_data_init(&data, (int64_t)sizeof data) != NURBS_OK) {
        fprintf(stderr, "the library does not know the data of this size\n");
        ++failures;
        return;
    }
    PIN((size_t)data.struct_size, 96);
    PIN((size_t)data.n, 0);
    PIN((size_t)data.reserved, 0);
}

static void pin_fit_options(void) {
    nurbs_fit_options options;
    PIN(sizeof(nurbs_fit_options), 112);
    PIN(offsetof(nurbs_fit_options, struct_size), 0);
    PIN(offsetof(nurbs_fit_options, smoothing), 8);
    PIN(offsetof(nurbs_fit_options, penalty_order), 12);
    PIN(offsetof(nurbs_fit_options, lambda), 16);
    PIN(offsetof(nurbs_fit_options, target), 24);
    PIN(offsetof(nurbs_fit_options, regularize), 32);
    PIN(offsetof(nurbs_fit_options, reserved), 36);
    PIN(offsetof(nurbs_fit_options, conditions), 40);
    PIN(offsetof(nurbs_fit_options, condition_params), 48);
    PIN(offsetof(nurbs_fit_options, condition_orders), 56);
    PIN(offsetof(nurbs_fit_options, condition_targets), 64);
    PIN(offsetof(nurbs_fit_options, robust), 72);
    PIN(offsetof(nurbs_fit_options, reserved2), 76);
    PIN(offsetof(nurbs_fit_options, robust_width), 80);
    PIN(offsetof(nurbs_fit_options, shapes), 88);
    PIN(offsetof(nurbs_fit_options, lower), 96);
    PIN(offsetof(nurbs_fit_options, upper), 104);
    if (nurbs_fit_options_init(&options, (int64_t)sizeof options) != NURBS_OK) {
        fprintf(stderr, "the library does not know the options of a fit of this size\n");
        ++failures;
        return;
    }
    PIN((size_t)options.struct_size, 112);
    PIN((size_t)options.penalty_order, 2);
    PIN((size_t)options.conditions, 0);
}

static void pin_fit_report(void) {
    PIN(sizeof(nurbs_fit_report), 104);
    PIN(offsetof(nurbs_fit_report, struct_size), 0);
    PIN(offsetof(nurbs_fit_report, data_count), 8);
    PIN(offsetof(nurbs_fit_report, weight), 16);
    PIN(offsetof(nurbs_fit_report, squares), 24);
    PIN(offsetof(nurbs_fit_report, rms), 32);
    PIN(offsetof(nurbs_fit_report, lambda), 40);
    PIN(offsetof(nurbs_fit_report, freedom), 48);
    PIN(offsetof(nurbs_fit_report, sigma), 56);
    PIN(offsetof(nurbs_fit_report, residual), 64);
    PIN(offsetof(nurbs_fit_report, largest), 72);
    PIN(offsetof(nurbs_fit_report, largest_index), 80);
    PIN(offsetof(nurbs_fit_report, bits), 88);
    PIN(offsetof(nurbs_fit_report, rounds), 92);
    PIN(offsetof(nurbs_fit_report, outliers), 96);
}

static void pin_cloud_options(void) {
    nurbs_cloud_options options;
    PIN(sizeof(nurbs_cloud_options), 40);
    PIN(offsetof(nurbs_cloud_options, struct_size), 0);
    PIN(offsetof(nurbs_cloud_options, penalty_order), 8);
    PIN(offsetof(nurbs_cloud_options, rounds), 12);
    PIN(offsetof(nurbs_cloud_options, lambda), 16);
    PIN(offsetof(nurbs_cloud_options, first_lambda), 24);
    PIN(offsetof(nurbs_cloud_options, tolerance), 32);
    if (nurbs_cloud_options_init(&options, (int64_t)sizeof options) != NURBS_OK) {
        fprintf(stderr, "the library does not know the options of a fit of a cloud of this size\n");
        ++failures;
        return;
    }
    PIN((size_t)options.struct_size, 40);
    PIN((size_t)options.penalty_order, 2);
    PIN((size_t)options.rounds, 100);
}

static void pin_mesh_options(void) {
    nurbs_mesh_options options;
    PIN(sizeof(nurbs_mesh_options), 48);
    PIN(offsetof(nurbs_mesh_options, struct_size), 0);
    PIN(offsetof(nurbs_mesh_options, chord), 8);
    PIN(offsetof(nurbs_mesh_options, relative_chord), 16);
    PIN(offsetof(nurbs_mesh_options, longest), 24);
    PIN(offsetof(nurbs_mesh_options, angle), 32);
    PIN(offsetof(nurbs_mesh_options, minimum_angle), 40);
    if (nurbs_mesh_options_init(&options, (int64_t)sizeof options) != NURBS_OK) {
        fprintf(stderr, "the library does not know the options of a mesh of this size\n");
        ++failures;
        return;
    }
    PIN((size_t)options.struct_size, 48);
    if (options.chord < 1e308 || options.relative_chord != 1e-3 || options.longest != 0 ||
        options.angle != 0 || options.minimum_angle != 0) {
        fprintf(stderr, "the limits of meshes are others by default\n");
        ++failures;
    }
}

static void pin_cloud_report(void) {
    PIN(sizeof(nurbs_cloud_report), 96);
    PIN(offsetof(nurbs_cloud_report, struct_size), 0);
    PIN(offsetof(nurbs_cloud_report, data_count), 8);
    PIN(offsetof(nurbs_cloud_report, weight), 16);
    PIN(offsetof(nurbs_cloud_report, squares), 24);
    PIN(offsetof(nurbs_cloud_report, rms), 32);
    PIN(offsetof(nurbs_cloud_report, largest), 40);
    PIN(offsetof(nurbs_cloud_report, largest_index), 48);
    PIN(offsetof(nurbs_cloud_report, lambda), 56);
    PIN(offsetof(nurbs_cloud_report, noise), 64);
    PIN(offsetof(nurbs_cloud_report, boundary), 72);
    PIN(offsetof(nurbs_cloud_report, uncertified), 80);
    PIN(offsetof(nurbs_cloud_report, rounds), 88);
    PIN(offsetof(nurbs_cloud_report, bits), 92);
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
    PIN(NURBS_ERROR_INFLUENCE, 60);
    PIN(NURBS_ERROR_CONTRADICTION, 61);
    PIN(NURBS_ERROR_CONSTRAINT, 62);
    PIN(NURBS_ERROR_OFF_POLYGON, 63);
    PIN(NURBS_ERROR_RULE, 64);
    PIN(NURBS_ERROR_SCHOENBERG_WHITNEY, 65);
    PIN(NURBS_ERROR_RANK, 66);
    PIN(NURBS_ERROR_SCALE, 67);
    PIN(NURBS_ERROR_ORIENTATION, 68);
    PIN(NURBS_ERROR_SAME, 69);
    PIN(NURBS_ERROR_CROSSING, 70);
    PIN(NURBS_ERROR_OUTSIDE_DOMAIN, 100);
    PIN(NURBS_ERROR_NOT_REPRESENTABLE, 200);
    PIN(NURBS_ERROR_KNOTS_MERGE, 202);
    PIN(NURBS_ERROR_NOT_CONVERGED, 203);
    PIN(NURBS_ERROR_MEMORY, 300);
    PIN(NURBS_ERROR_FILE, 301);
    PIN(NURBS_ERROR_TOO_LARGE, 302);
    PIN(NURBS_ERROR_CANCELLED, 303);
    PIN(NURBS_ERROR_WORK, 304);
    PIN(NURBS_ERROR_FORMAT, 400);
    PIN(NURBS_ERROR_TRUNCATED, 401);
    PIN(NURBS_ERROR_SYNTAX, 402);
    PIN(NURBS_ERROR_UNSUPPORTED, 403);
    PIN(NURBS_ERROR_CHECKSUM, 404);
    PIN(NURBS_ERROR_VERSION, 405);
    PIN(NURBS_ERROR_CYCLE, 406);
    PIN(NURBS_ERROR_INTERNAL, 900);
}

static void pin_flags(void) {
    PIN(NURBS_LEFT, 1);
    PIN(NURBS_CLAMP, 2);
    PIN(NURBS_EXTRAPOLATE, 4);
    PIN(NURBS_WRAP, 8);
    PIN(NURBS_NAN, 16);
    PIN(NURBS_PERIODIC, 1);
    PIN(NURBS_ACCUMULATE, 0x01000000);
    PIN(NURBS_KEEP_DOMAIN, 0x02000000);
    PIN(NURBS_KEEP_GAPS, 0x04000000);
    PIN(NURBS_PRODUCT_DOT, 0x08000000);
    PIN(NURBS_PRODUCT_CROSS, 0x10000000);
    PIN(NURBS_HOMOGENEOUS, 0x20000000);
    PIN(NURBS_MAP_DOMAINS, 0x40000000);
    PIN(NURBS_RULED_CARTESIAN, 0x80000000);
    PIN(NURBS_HEMISPHERE, 0x01000000);
    PIN(NURBS_TWO_SHEETS, 0x02000000);
    PIN(NURBS_MESH_WELDED, 0x01000000);
    PIN(NURBS_FILL_NON_ZERO, 1);
    PIN(NURBS_FILL_EVEN_ODD, 2);
    PIN(NURBS_FILL_POSITIVE, 3);
    PIN(NURBS_REGION_UNION, 1);
    PIN(NURBS_REGION_INTERSECTION, 2);
    PIN(NURBS_REGION_DIFFERENCE, 3);
    PIN(NURBS_TRIM_FRONT, 1);
    PIN(NURBS_TRIM_BACK, -1);
    PIN(NURBS_REGION_EITHER, 4);
    PIN(NURBS_EQUAL_CHORDS, 0x02000000);
    PIN(NURBS_REVERSED, 0x04000000);
    PIN(NURBS_NAN_POINTS, 0x01000000);
    PIN(NURBS_AS_ORIENTED, 0x01000000);
    PIN(NURBS_CHECK_CROSSINGS, 0x02000000);
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
    PIN(NURBS_BYTES_SPLINE, 1);
    PIN(NURBS_BYTES_LIST, 2);
    PIN(NURBS_BYTES_STATISTICS, 3);
    PIN(NURBS_BYTES_FACE, 4);
    PIN(NURBS_BYTES_MODEL, 5);
    PIN(NURBS_FORMAT_STEP, 1);
    PIN(NURBS_FORMAT_IGES, 2);
    PIN(NURBS_FORMAT_STL, 3);
    PIN(NURBS_FORMAT_STL_TEXT, 4);
    PIN(NURBS_FORMAT_OBJ, 5);
    PIN(NURBS_FORMAT_PLY, 6);
    PIN(NURBS_FORMAT_GLB, 7);
    PIN(NURBS_FORMAT_VTU, 8);
    PIN(NURBS_READ_CURVES, 1);
    PIN(NURBS_READ_SURFACES, 2);
    PIN(NURBS_READ_FACES, 4);
    PIN(NURBS_ARC_QUARTERS, 0);
    PIN(NURBS_ARC_THIRDS, 1);
    PIN(NURBS_ARC_SMOOTH, 2);
    PIN(NURBS_CONIC_ELLIPSE, 1);
    PIN(NURBS_CONIC_PARABOLA, 2);
    PIN(NURBS_CONIC_HYPERBOLA, 3);
    PIN(NURBS_CONIC_CHORD, 4);
    PIN(NURBS_CONIC_LEGS, 5);
    PIN(NURBS_CONIC_LINE, 6);
    PIN(NURBS_PARAMS_UNIFORM, 0);
    PIN(NURBS_PARAMS_CHORD, 1);
    PIN(NURBS_PARAMS_CENTRIPETAL, 2);
    PIN(NURBS_PARAMS_POWER, 3);
    PIN(NURBS_PARAMS_FOLEY_NIELSON, 4);
    PIN(NURBS_ENDS_NOT_A_KNOT, 0);
    PIN(NURBS_ENDS_NATURAL, 1);
    PIN(NURBS_ENDS_FREE, 2);
    PIN(NURBS_ORDER_DIRECTION, (size_t)-1);
    PIN(NURBS_SMOOTHING_NONE, 0);
    PIN(NURBS_SMOOTHING_LAMBDA, 1);
    PIN(NURBS_SMOOTHING_GCV, 2);
    PIN(NURBS_SMOOTHING_REML, 3);
    PIN(NURBS_SMOOTHING_DISCREPANCY, 4);
    PIN(NURBS_ROBUST_NONE, 0);
    PIN(NURBS_ROBUST_HUBER, 1);
    PIN(NURBS_ROBUST_TUKEY, 2);
    PIN(NURBS_TREND_RISING, 1);
    PIN(NURBS_TREND_FALLING, 2);
    PIN(NURBS_TREND_CONVEX, 4);
    PIN(NURBS_TREND_CONCAVE, 8);
    PIN(NURBS_FIT_TARGET_MISSED, 1);
    PIN(NURBS_FIT_NOT_CONVERGED, 2);
    PIN(NURBS_CLOUD_NOT_CONVERGED, 1);
    PIN(NURBS_TANGENTS_CATMULL_ROM, 0);
    PIN(NURBS_TANGENTS_BESSEL, 1);
    PIN(NURBS_TANGENTS_AKIMA, 2);
    PIN(NURBS_TANGENTS_MONOTONE, 3);
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
    PIN(NURBS_SHAPE_REVOLUTION, 12);
    PIN(NURBS_SHAPE_EXTRUSION, 13);
    PIN(NURBS_SHAPE_OFFSET, 14);
}

static void pin_queries(void) {
    PIN(NURBS_CLOSEST_CERTIFIED, 1);
    PIN(NURBS_CLOSEST_BOUNDARY, 2);
    PIN(NURBS_CLOSEST_NOT_UNIQUE, 4);
    PIN(NURBS_CLOSEST_BUDGET, 8);
    PIN(NURBS_CLOSEST_INVALID, 16);
    PIN(NURBS_CLOSEST_COARSE, 32);
    PIN(NURBS_CLOSEST_SINGULAR, 64);
    PIN(NURBS_CLOSEST_LEFT, 256);
    PIN(NURBS_CRITICAL_MINIMUM, 1);
    PIN(NURBS_CRITICAL_MAXIMUM, 2);
    PIN(NURBS_CRITICAL_SADDLE, 3);
    PIN(NURBS_CRITICAL_UNDECIDED, 4);
    PIN(NURBS_FEATURE_INFLECTION, 1);
    PIN(NURBS_FEATURE_CURVATURE_MAXIMUM, 2);
    PIN(NURBS_FEATURE_CURVATURE_MINIMUM, 4);
    PIN(NURBS_FEATURE_CUSP, 8);
    PIN(NURBS_FEATURE_KINK, 16);
    PIN(NURBS_FEATURE_JUMP, 32);
    PIN(NURBS_FEATURE_TORSION, 64);
    PIN(NURBS_EXTREMUM_MINIMUM, 1);
    PIN(NURBS_EXTREMUM_MAXIMUM, 2);
    PIN(NURBS_EXTREMUM_SADDLE, 4);
    PIN(NURBS_EXTREMUM_PLATEAU, 8);
    PIN(NURBS_EXTREMUM_UNDECIDED, 16);
    PIN(NURBS_CONVEXITY_NONE, 0);
    PIN(NURBS_CONVEXITY_LEFT, 1);
    PIN(NURBS_CONVEXITY_RIGHT, 2);
    PIN(NURBS_CONVEXITY_STRAIGHT, 3);
    PIN(NURBS_CONVEXITY_UNDECIDED, 4);
    PIN(NURBS_FOLD_NONE, 0);
    PIN(NURBS_FOLD_FOUND, 1);
    PIN(NURBS_FOLD_UNDECIDED, 2);
    PIN(NURBS_RAY_HIT, 1);
    PIN(NURBS_RAY_CERTIFIED, 2);
    PIN(NURBS_RAY_TOUCH, 4);
    PIN(NURBS_RAY_BACK, 8);
    PIN(NURBS_SIDE_INSIDE, 1);
    PIN(NURBS_SIDE_ON, 0);
    PIN(NURBS_SIDE_OUTSIDE, -1);
    PIN(NURBS_SIDE_UNDECIDED, 2);
    PIN(NURBS_HIT_CROSSING, 1);
    PIN(NURBS_HIT_TANGENT, 2);
    PIN(NURBS_HIT_CONTACT, 3);
    PIN(NURBS_HIT_OVERLAP, 4);
    PIN(NURBS_HIT_JUMP, 5);
    PIN(NURBS_HIT_UNDECIDED, 6);
    PIN(NURBS_NODE_BORDER, 1);
    PIN(NURBS_NODE_SEAM, 2);
    PIN(NURBS_NODE_TOUCH, 3);
    PIN(NURBS_NODE_UNDECIDED, 4);
    PIN(NURBS_NODE_EDGE, 5);
    PIN(NURBS_BRANCH_CROSSING, 1);
    PIN(NURBS_BRANCH_EDGE, 2);
    PIN(NURBS_BRANCH_CONTACT, 3);
    PIN(NURBS_BRANCH_TOUCH, 4);
    PIN(NURBS_BRANCH_OVERLAP, 5);
    PIN(NURBS_NODE_FOLD, 6);
    PIN(NURBS_NODE_OVERLAP, 7);
    PIN(NURBS_CONTOUR_SILHOUETTE, 1);
    PIN(NURBS_CONTOUR_PERSPECTIVE, 2);
    PIN(NURBS_CONTOUR_ISOPHOTE, 3);
    PIN(NURBS_CONTOUR_PARABOLIC, 4);
    PIN(NURBS_REFLECTION_HIGHLIGHT, 1);
    PIN(NURBS_REFLECTION_ALONG, 2);
    PIN(NURBS_REFLECTION_FROM, 3);
    PIN(NURBS_CONSTRAIN_VALUE, 0);
    PIN(NURBS_CONSTRAIN_DIRECTION, 1);
    PIN(NURBS_CONSTRAIN_NORMAL, 2);
    PIN(NURBS_CONSTRAIN_CURVATURE, 3);
}

int main(void) {
    pin_read_options();
    pin_write_options();
    if (sizeof(void *) == 8) { /* smaller pointers make other layouts */
        pin_call_options();
        pin_closest_query();
        pin_closest_answer();
        pin_constraints();
        pin_constraint_report();
        pin_data();
        pin_fit_options();
    }
    pin_fit_report();
    pin_cloud_options();
    pin_cloud_report();
    pin_mesh_options();
    pin_codes();
    pin_flags();
    pin_kinds();
    pin_queries();
    printf("%d differences\n", failures);
    return failures == 0 ? 0 : 1;
}
