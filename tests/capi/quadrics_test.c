/* SPDX-License-Identifier: MIT */
/* Quadrics, the torus and the sphere without poles: known control points, and every argument wrong. */
#include "check.h"
#include "shapes.h"

#define VALUES(...) ((const double[]){__VA_ARGS__})
#define PI 3.14159265358979323846

/* The arguments of all shapes; each takes those that it needs. */
typedef struct Args {
    const double *center, *axis, *x;
    double a, b, c; /* radii */
    double height, top, start, sweep, start2, sweep2;
    int32_t form;
    uint32_t flags;
} Args;

static Args usual(void) {
    Args args = {NULL, NULL, NULL, 2, 1, 3, 0.5, 4, 0, 2 * PI, -PI / 2, PI, NURBS_ARC_QUARTERS, 0};
    return args;
}

static nurbs_status sphere(Args s, nurbs **out) {
    return nurbs_surface_sphere(s.center, s.axis, s.x, s.a, s.form, out);
}
static nurbs_status spherical_patch(Args s, nurbs **out) {
    return nurbs_surface_spherical_patch(s.center, s.axis, s.x, s.a, s.start, s.sweep, s.start2,
                                         s.start2 + s.sweep2, s.form, out);
}
static nurbs_status ellipsoid(Args s, nurbs **out) {
    return nurbs_surface_ellipsoid(s.center, s.axis, s.x, s.a, s.b, s.c, s.form, out);
}
static nurbs_status cylinder(Args s, nurbs **out) {
    return nurbs_surface_cylinder(s.center, s.axis, s.x, s.a, s.height, s.start, s.sweep, s.form, out);
}
static nurbs_status cone(Args s, nurbs **out) {
    return nurbs_surface_cone(s.center, s.axis, s.x, s.a, s.b, s.height, s.start, s.sweep, s.form, out);
}
static nurbs_status torus(Args s, nurbs **out) {
    return nurbs_surface_torus(s.center, s.axis, s.x, s.a, s.b, s.start, s.sweep, s.start2, s.sweep2, s.form,
                               out);
}
static nurbs_status paraboloid(Args s, nurbs **out) {
    return nurbs_surface_paraboloid(s.center, s.axis, s.x, s.a, s.b, s.height, s.start, s.sweep, s.form, out);
}
static nurbs_status saddle(Args s, nurbs **out) {
    return nurbs_surface_saddle(s.center, s.axis, s.x, s.a, s.b, s.height, out);
}
static nurbs_status hyperboloid(Args s, nurbs **out) {
    return nurbs_surface_hyperboloid(s.center, s.axis, s.x, s.a, s.b, s.c, s.height, s.top, s.start, s.sweep,
                                     s.form, s.flags, out);
}

enum { turns = 1, forms = 2, two_radii = 4, three_radii = 8, heights = 16 };

typedef struct Shape {
    nurbs_status (*make)(Args, nurbs **);
    int uses;
    const char *center;
    const char *names[3]; /* of the radii */
} Shape;

static const Shape shapes[] = {
    {sphere, forms, "center", {"radius", "", ""}},
    {spherical_patch, forms | turns, "center", {"radius", "", ""}},
    {ellipsoid, forms | two_radii | three_radii, "center", {"radius_x", "radius_y", "radius_z"}},
    {cylinder, forms | turns | heights, "origin", {"radius", "", ""}},
    {cone, forms | turns | two_radii | heights, "origin", {"base_radius", "top_radius", ""}},
    {torus, forms | turns | two_radii, "center", {"major_radius", "minor_radius", ""}},
    {paraboloid, forms | turns | two_radii | heights, "vertex", {"radius_x", "radius_y", ""}},
    {saddle, two_radii | heights, "center", {"radius_x", "radius_y", ""}},
    {hyperboloid, forms | turns | two_radii | three_radii, "center", {"radius_x", "radius_y", "radius_z"}},
};
enum { shape_count = sizeof shapes / sizeof *shapes };

static void check_refused(const Shape *shape, Args args, nurbs_status status, const char *words) {
    nurbs *out = NULL;
    CHECK_NO_HANDLE(out, shape->make(args, &out), status, words);
}

static void places_refused(const Shape *shape) {
    Args args = usual();
    CHECK_FAILS(shape->make(args, NULL), NURBS_ERROR_NULL, "out is NULL");
    args.center = edited(VALUES(1, 2, 3), 3, 1, NAN);
    check_refused(shape, args, NURBS_ERROR_POINT_NOT_FINITE, shape->center);
    check_refused(shape, args, NURBS_ERROR_POINT_NOT_FINITE, "[1] = nan");
    args = usual();
    args.axis = VALUES(0, 0, 0);
    check_refused(shape, args, NURBS_ERROR_DIRECTION, "axis is zero");
    args.axis = VALUES(0, INFINITY, 0);
    check_refused(shape, args, NURBS_ERROR_DIRECTION, "axis[1] = inf");
    args.axis = VALUES(1, 2, 3);
    args.x = VALUES(-2, -4, -6);
    check_refused(shape, args, NURBS_ERROR_DIRECTION, "x = (-2, -4, -6)|parallel to the axis");
    args.x = VALUES(0, 0, 0);
    check_refused(shape, args, NURBS_ERROR_DIRECTION, "x is zero");
}

static void lengths_refused(const Shape *shape) {
    static const double bad[] = {-1, NAN, INFINITY, -INFINITY};
    const int count = (shape->uses & three_radii) != 0 ? 3 : (shape->uses & two_radii) != 0 ? 2 : 1;
    for (int i = 0; i < 4; ++i) {
        for (int k = 0; k < count; ++k) {
            Args args = usual();
            *(k == 0 ? &args.a : k == 1 ? &args.b : &args.c) = bad[i];
            check_refused(shape, args, NURBS_ERROR_LENGTH, shape->names[k]);
        }
        if ((shape->uses & heights) != 0) {
            Args args = usual();
            args.height = bad[i];
            check_refused(shape, args, NURBS_ERROR_LENGTH, "height = |expected a finite length above 0");
        }
    }
    Args args = usual();
    args.a = 0;
    if (shape->make != cone) {
        check_refused(shape, args, NURBS_ERROR_LENGTH, shape->names[0]);
    }
    args = usual();
    args.a = args.b = args.c = args.height = 1.5e308;
    args.center = VALUES(1.5e308, 0, 1.5e308);
    args.b /= 2;
    args.top = 1.7e308;
    check_refused(shape, args, NURBS_ERROR_NOT_REPRESENTABLE, "overflow");
}

static void forms_and_turns_refused(const Shape *shape) {
    Args args = usual();
    if ((shape->uses & forms) != 0) {
        args.form = 3;
        check_refused(shape, args, NURBS_ERROR_FORM, "form = 3");
        args.form = -1;
        check_refused(shape, args, NURBS_ERROR_FORM, "form = -1");
    }
    if ((shape->uses & turns) != 0) {
        args = usual();
        args.start = NAN;
        check_refused(shape, args, NURBS_ERROR_ANGLE, "start = nan");
        args.start = 0;
        args.sweep = 0;
        check_refused(shape, args, NURBS_ERROR_ANGLE, "sweep = 0|full turn");
        args.sweep = 6.3;
        check_refused(shape, args, NURBS_ERROR_ANGLE, "sweep = 6.3");
        args.sweep = INFINITY;
        check_refused(shape, args, NURBS_ERROR_ANGLE, "sweep = inf");
    }
}

static void own_arguments_refused(void) {
    Args args = usual();
    const Shape *patch_shape = &shapes[1], *cone_shape = &shapes[4], *torus_shape = &shapes[5],
                *hyperboloid_shape = &shapes[8];
    args.start2 = -2;
    args.sweep2 = 1;
    check_refused(patch_shape, args, NURBS_ERROR_ANGLE, "south = -2|north = -1");
    args.start2 = 0.5;
    args.sweep2 = 0;
    check_refused(patch_shape, args, NURBS_ERROR_ANGLE, "latitudes|south < north");
    args.sweep2 = NAN;
    check_refused(patch_shape, args, NURBS_ERROR_ANGLE, "north = nan");
    args = usual();
    args.a = args.b = 1;
    check_refused(cone_shape, args, NURBS_ERROR_LENGTH, "base_radius = 1|two radii that differ");
    args = usual();
    args.sweep2 = 7;
    check_refused(torus_shape, args, NURBS_ERROR_ANGLE, "tube_sweep = 7");
    args.start2 = INFINITY;
    check_refused(torus_shape, args, NURBS_ERROR_ANGLE, "tube_start = inf");
    args = usual();
    args.flags = 1;
    check_refused(hyperboloid_shape, args, NURBS_ERROR_FLAGS, "flags = 0x1|NURBS_TWO_SHEETS");
    args.flags = 0;
    args.top = args.height;
    check_refused(hyperboloid_shape, args, NURBS_ERROR_LENGTH, "bottom = 0.5|top = 0.5");
    args.top = NAN;
    check_refused(hyperboloid_shape, args, NURBS_ERROR_LENGTH, "top = nan");
    args.flags = NURBS_TWO_SHEETS;
    args.top = 9; /* from below the vertex at 3 */
    check_refused(hyperboloid_shape, args, NURBS_ERROR_LENGTH, "bottom = 0.5|at least 3|at most -3");
    args.flags = 0;
    args.c = 1e-300;
    args.top = 1e300;
    check_refused(hyperboloid_shape, args, NURBS_ERROR_NOT_REPRESENTABLE, "overflow");
}

static nurbs *made(nurbs_status (*make)(Args, nurbs **), Args args) {
    nurbs *out = NULL;
    CHECK_OK(make(args, &out));
    return out;
}

#define ROOT HALF_ROOT

static void known_points(void) {
    Args args = usual();
    args.sweep = PI / 2;
    args.center = VALUES(10, 20, 30);
    nurbs *g = made(cylinder, args);
    CHECK_POINTS(g, VALUES(12, 20, 30, 12, 20, 30.5, 12, 22, 30, 12, 22, 30.5, 10, 22, 30, 10, 22, 30.5));
    CHECK_WEIGHTS(g, VALUES(1, 1, ROOT, ROOT, 1, 1));
    CHECK_KNOTS(g, 0, VALUES(0, 0, 0, 1, 1, 1));
    CHECK_KNOTS(g, 1, VALUES(0, 0, 1, 1));
    nurbs_destroy(g);
    args.axis = VALUES(5, 0, 0); /* X = y, Y = z */
    args.a = 0;
    g = made(cone, args);
    CHECK_POINTS(g, VALUES(10, 20, 30, 10.5, 21, 30, 10, 20, 30, 10.5, 21, 31, 10, 20, 30, 10.5, 20, 31));
    nurbs_destroy(g);
    args = usual();
    args.x = VALUES(0, 7, 3); /* Y = -x */
    args.sweep = -PI / 2;
    args.start2 = 0;
    args.sweep2 = PI / 2;
    g = made(spherical_patch, args);
    CHECK_POINTS(g, VALUES(0, 2, 0, 0, 2, 2, 0, 0, 2, 2, 2, 0, 2, 2, 2, 0, 0, 2, 2, 0, 0, 2, 0, 2, 0, 0, 2));
    CHECK_WEIGHTS(g, VALUES(1, ROOT, 1, ROOT, ROOT * ROOT, ROOT, 1, ROOT, 1));
    nurbs_destroy(g);
    args.x = NULL;
    args.sweep = PI / 2;
    g = made(torus, args);
    CHECK_POINTS(g, VALUES(3, 0, 0, 3, 0, 1, 2, 0, 1, 3, 3, 0, 3, 3, 1, 2, 2, 1, 0, 3, 0, 0, 3, 1, 0, 2, 1));
    nurbs_destroy(g);
    g = made(paraboloid, args);
    CHECK_POINTS(
        g, VALUES(0, 0, 0, 1, 0, 0, 2, 0, 0.5, 0, 0, 0, 1, 0.5, 0, 2, 1, 0.5, 0, 0, 0, 0, 0.5, 0, 0, 1, 0.5));
    nurbs_destroy(g);
    g = made(saddle, args);
    CHECK_POINTS(
        g, VALUES(-2, -1, 0, -2, 0, 1, -2, 1, 0, 0, -1, -1, 0, 0, 0, 0, 1, -1, 2, -1, 0, 2, 0, 1, 2, 1, 0));
    CHECK_KNOTS(g, 1, VALUES(0, 0, 0, 1, 1, 1));
    nurbs_destroy(g);
    args = usual();
    args.flags = NURBS_TWO_SHEETS;
    args.height = -5;
    args.top = -3;
    args.sweep = PI / 2;
    g = made(hyperboloid,
             args); /* 4/3 from the axis at -5, in radii, where the tangent meets that at the vertex in 1/2 */
    double p[27];
    CHECK_OK(nurbs_points(g, 9, p, 0, 0));
    CHECK_NEAR(p, VALUES(8 / 3.0, 0, -5, 1, 0, -3, 0, 0, -3), 9, 1e-15);
    CHECK_DOUBLES(p + 2, VALUES(-5), 1);
    CHECK_DOUBLES(p + 8, VALUES(-3), 1);
    nurbs_destroy(g);
}

static void check_counts(nurbs *g, int32_t degree, int64_t u, int64_t v) {
    int64_t counts[2] = {0, 0};
    int32_t degrees[2] = {0, 0};
    for (int32_t k = 0; k < 2; ++k) {
        CHECK_OK(nurbs_count(g, k, &counts[k]));
        CHECK_OK(nurbs_degree(g, k, &degrees[k]));
        CHECK_INT(degrees[k], degree);
    }
    CHECK_INT(counts[0], u);
    CHECK_INT(counts[1], v);
    nurbs_destroy(g);
}

static void forms_differ(void) {
    Args args = usual();
    check_counts(made(sphere, args), 2, 9, 5);
    args.form = NURBS_ARC_THIRDS;
    check_counts(made(ellipsoid, args), 2, 7, 5);
    args.form = NURBS_ARC_SMOOTH;
    check_counts(made(sphere, args), 5, 6, 6);
}

static void check_face(const nurbs_list *list, int64_t i, const char *name, double x, double y, double z) {
    char text[8];
    nurbs *g = NULL;
    double point[3], middle[] = {0.5, 0.5};
    CHECK_OK(nurbs_list_name(list, i, text, 8, NULL));
    CHECK(strcmp(text, name) == 0);
    CHECK_OK(nurbs_list_get(list, i, &g));
    CHECK_OK(nurbs_eval(g, 1, middle, 0, 0, point, 0, 0, 0));
    CHECK_NEAR(point, VALUES(x, y, z), 3, 1e-14);
    check_counts(g, 4, 5, 5);
}

static void sphere_patches(void) {
    nurbs_list *list = NULL;
    int64_t count = 0;
    CHECK_OK(nurbs_surface_sphere_patches(VALUES(1, 2, 3), NULL, NULL, 5, 0, &list));
    CHECK_OK(nurbs_list_count(list, &count));
    CHECK_INT(count, 6);
    check_face(list, 0, "+X", 6, 2, 3);
    check_face(list, 1, "+Y", 1, 7, 3);
    check_face(list, 2, "-X", -4, 2, 3);
    check_face(list, 3, "-Y", 1, -3, 3);
    check_face(list, 4, "+Z", 1, 2, 8);
    check_face(list, 5, "-Z", 1, 2, -2);
    nurbs_list_destroy(list);
    CHECK_OK(nurbs_surface_sphere_patches(NULL, NULL, NULL, 1, NURBS_HEMISPHERE, &list));
    CHECK_OK(nurbs_list_count(list, &count));
    CHECK_INT(count, 5);
    check_face(list, 4, "+Z", 0, 0, 1);
    nurbs_list_destroy(list);
    list = (nurbs_list *)(void *)check_before;
    CHECK_FAILS(nurbs_surface_sphere_patches(NULL, NULL, NULL, 1, 1, &list), NURBS_ERROR_FLAGS,
                "flags = 0x1|NURBS_HEMISPHERE");
    CHECK(list == NULL);
    CHECK_FAILS(nurbs_surface_sphere_patches(NULL, NULL, NULL, 0, 0, &list), NURBS_ERROR_LENGTH,
                "radius = 0");
    CHECK_FAILS(nurbs_surface_sphere_patches(NULL, VALUES(0, 0, 0), NULL, 1, 0, &list), NURBS_ERROR_DIRECTION,
                "axis is zero");
    CHECK_FAILS(nurbs_surface_sphere_patches(VALUES(NAN, 0, 0), NULL, NULL, 1, 0, &list),
                NURBS_ERROR_POINT_NOT_FINITE, "center[0]");
    CHECK_FAILS(nurbs_surface_sphere_patches(NULL, NULL, NULL, 1.6e308, 0, &list),
                NURBS_ERROR_NOT_REPRESENTABLE, "overflow");
    CHECK_FAILS(nurbs_surface_sphere_patches(NULL, NULL, NULL, 1, 0, NULL), NURBS_ERROR_NULL, "out is NULL");
}

int main(void) {
    for (int i = 0; i < shape_count; ++i) {
        places_refused(&shapes[i]);
        lengths_refused(&shapes[i]);
        forms_and_turns_refused(&shapes[i]);
    }
    own_arguments_refused();
    known_points();
    forms_differ();
    sphere_patches();
    return check_summary("quadrics");
}
