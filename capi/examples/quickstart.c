/* SPDX-License-Identifier: MIT */
/* Reads a CAD file and shows what the library does with it: prints what the file holds, evaluates points and
 * derivatives, inserts knots and measures that the shape stayed where it was, draws a curve (SVG) and a mesh
 * (OBJ).
 * Compile: cc -std=c99 quickstart.c $(pkg-config --cflags --libs nurbs) -lm -o quickstart */
#include "pictures.h"

#include <nurbs/nurbs.h>

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { NAME = 64, SAMPLES = 800, SIDE = 24, NEW_KNOTS = 6, TYPES = 1000 };

/* All the error handling that a small program needs: the status says that, the message says what. */
static void check(nurbs_status status) {
    char message[512];
    if (status != NURBS_OK) {
        nurbs_last_error(message, (int64_t)sizeof message);
        fprintf(stderr, "quickstart: %s: %s\n", nurbs_status_name(status), message);
        exit(EXIT_FAILURE);
    }
}

/* --- splines, and what there is to know about them --- */

typedef struct shape {
    nurbs *g;
    char name[NAME];
    int32_t axes, dim, rational, degree[2], form[2];
    int64_t points, count[2];
    double domain[2][2];
} shape;

static void inspect(shape *s) {
    int32_t axis;
    check(nurbs_axes(s->g, &s->axes));
    check(nurbs_dimension(s->g, &s->dim));
    check(nurbs_is_rational(s->g, &s->rational));
    check(nurbs_point_count(s->g, &s->points));
    for (axis = 0; axis < s->axes; ++axis) {
        check(nurbs_degree(s->g, axis, &s->degree[axis]));
        check(nurbs_count(s->g, axis, &s->count[axis]));
        check(nurbs_knot_form(s->g, axis, &s->form[axis]));
        check(nurbs_domain(s->g, axis, s->domain[axis]));
    }
}

static shape *load_shapes(const nurbs_list *list, int64_t *count) {
    shape *shapes;
    int64_t i;
    check(nurbs_list_count(list, count));
    shapes = allocate(*count + 1, sizeof *shapes);
    for (i = 0; i < *count; ++i) {
        check(nurbs_list_get(list, i, &shapes[i].g));
        check(nurbs_list_name(list, i, shapes[i].name, NAME, NULL));
        inspect(&shapes[i]);
    }
    return shapes;
}

static int clamped(const shape *s) {
    return s->form[0] == (NURBS_FORM_CLAMPED_START | NURBS_FORM_CLAMPED_END);
}

static const char *form_name(const shape *s) {
    return s->form[0] & NURBS_FORM_PERIODIC ? "periodic" : clamped(s) ? "clamped" : "unclamped";
}

static void print_shape(const shape *s) {
    char degrees[32], counts[64];
    snprintf(degrees, sizeof degrees, "%d", (int)s->degree[0]);
    snprintf(counts, sizeof counts, "%lld", (long long)s->count[0]);
    if (s->axes == 2) {
        snprintf(degrees, sizeof degrees, "%d x %d", (int)s->degree[0], (int)s->degree[1]);
        snprintf(counts, sizeof counts, "%lld x %lld", (long long)s->count[0], (long long)s->count[1]);
    }
    printf("%-20.20s %-8s %-8s %-11s %-11s %s\n", s->name, s->axes == 1 ? "curve" : "surface", degrees,
           counts, s->rational ? "rational" : "polynomial", form_name(s));
}

/* How many entities of the file, by type, did not become a spline. */
static void print_notes(const nurbs_list *list) {
    int counts[TYPES] = {0};
    int32_t type;
    int64_t i, notes;
    check(nurbs_list_note_count(list, &notes));
    printf("entities that are no splines: %lld", (long long)notes);
    for (i = 0; i < notes; ++i) {
        check(nurbs_list_note(list, i, &type, NULL, NULL, NULL, 0, NULL));
        ++counts[type > 0 && type < TYPES ? type : 0];
    }
    for (type = 0; type < TYPES; ++type) {
        if (counts[type] > 0) {
            printf(", %d of type %d", counts[type], (int)type);
        }
    }
    printf("\n\n");
}

static void print_contents(const nurbs_list *list, const shape *shapes, int64_t count) {
    int64_t i;
    double unit;
    check(nurbs_list_unit(list, &unit));
    printf("%lld splines, one unit is %g m\n\n", (long long)count, unit);
    printf("%-20s %-8s %-8s %-11s %-11s %s\n", "name", "kind", "degree", "points", "weights", "knots");
    for (i = 0; i < count; ++i) {
        print_shape(&shapes[i]);
    }
    print_notes(list);
}

/* --- evaluation --- */

static double param_at(const shape *s, int32_t axis, double fraction) {
    return (1 - fraction) * s->domain[axis][0] + fraction * s->domain[axis][1];
}

/* SAMPLES parameters all over the domain, in order along the first axis. */
static void sample_params(const shape *s, double *params) {
    int64_t i;
    for (i = 0; i < SAMPLES; ++i) {
        params[i * s->axes] = param_at(s, 0, (double)i / (SAMPLES - 1));
        if (s->axes == 2) {
            params[2 * i + 1] = param_at(s, 1, fmod(0.618 * (double)i, 1));
        }
    }
}

/* A point and its first derivatives in the middle of the domain. */
static void print_evaluation(const shape *s) {
    static const char *const labels[] = {"point", "d/du", "d/dv"};
    const double params[2] = {param_at(s, 0, 0.5), param_at(s, s->axes - 1, 0.5)};
    double derivs[3][3] = {{0}};
    int32_t slot;
    check(nurbs_eval_derivs(s->g, 1, 1, params, 0, 0, derivs[0], 0, 0, 0));
    printf("%s, in the middle of its domain:\n", s->name);
    for (slot = 0; slot <= s->axes; ++slot) {
        const double *v = derivs[0] + slot * s->dim;
        printf("  %-6s %12.6g %12.6g %12.6g\n", labels[slot], v[0], v[1], s->dim == 3 ? v[2] : 0.0);
    }
}

/* --- knot insertion --- */

/* The distinct knots of an axis inside its closed domain; the caller frees them. */
static double *inner_knots(const shape *s, int32_t axis, int64_t *n) {
    int64_t i, all;
    double *knots;
    check(nurbs_distinct_knots(s->g, axis, 0, NULL, NULL, &all));
    knots = allocate(all, sizeof *knots);
    check(nurbs_distinct_knots(s->g, axis, all, knots, NULL, &all));
    for (i = *n = 0; i < all; ++i) {
        if (knots[i] >= s->domain[axis][0] && knots[i] <= s->domain[axis][1]) {
            knots[(*n)++] = knots[i];
        }
    }
    return knots;
}

/* The same spline with a new knot in the middle of spans on each axis, NEW_KNOTS of them at most. */
static shape refined(const shape *s) {
    shape finer = *s;
    int32_t axis;
    check(nurbs_clone(s->g, &finer.g));
    for (axis = 0; axis < s->axes; ++axis) {
        int64_t i, n;
        double *knots = inner_knots(s, axis, &n);
        for (i = 0; i + 1 < n; i += 1 + (n - 2) / NEW_KNOTS) {
            nurbs *old = finer.g;
            check(nurbs_insert_knot(old, axis, 0.5 * (knots[i] + knots[i + 1]), 1, &finer.g));
            nurbs_destroy(old);
        }
        free(knots);
    }
    inspect(&finer);
    return finer;
}

/* The largest distance between two splines, in units of eps * hull, in which the library states its
 * accuracy. */
static double difference(const shape *a, const shape *b) {
    static double params[2 * SAMPLES], p[3 * SAMPLES], q[3 * SAMPLES], hull[SAMPLES];
    double largest = 0;
    int64_t i;
    sample_params(a, params);
    check(nurbs_eval(a->g, SAMPLES, params, 0, 0, p, 0, 0, 0));
    check(nurbs_eval(b->g, SAMPLES, params, 0, 0, q, 0, 0, 0));
    check(nurbs_hull_size(a->g, SAMPLES, params, 0, 0, hull, 0, 0));
    for (i = 0; i < SAMPLES * a->dim; ++i) {
        largest = fmax(largest, fabs(p[i] - q[i]) / (DBL_EPSILON * hull[i / a->dim]));
    }
    return largest;
}

/* --- pictures --- */

static void draw_net(svg *picture, const shape *s, const char *style, const char *label) {
    double *points = allocate(s->points * s->dim, sizeof *points);
    check(nurbs_points(s->g, s->points, points, 0, 0));
    svg_series(picture, style, label, points, s->points, 1, 4.5);
    free(points);
}

static void draw_knots(svg *picture, const shape *s, const char *style, const char *label, double radius) {
    int64_t n;
    double *knots = inner_knots(s, 0, &n), *points = allocate(n * s->dim, sizeof *points);
    check(nurbs_eval(s->g, n, knots, 0, 0, points, 0, 0, 0));
    svg_series(picture, style, label, points, n, 0, radius);
    free(points);
    free(knots);
}

static void draw_curve(const char *folder, const shape *before, const shape *after) {
    static double params[SAMPLES], points[3 * SAMPLES];
    double *net = allocate(before->points * before->dim, sizeof *net);
    svg picture;
    check(nurbs_points(before->g, before->points, net, 0, 0));
    svg_open(&picture, create_file(folder, "curve.svg"), before->name, net, before->points, before->dim);
    draw_net(&picture, before, "before", "control polygon");
    draw_net(&picture, after, "after", "after inserting knots");
    sample_params(before, params);
    check(nurbs_eval(before->g, SAMPLES, params, 0, 0, points, 0, 0, 0));
    svg_series(&picture, "curve", "the curve, unchanged", points, SAMPLES, 1, 0);
    draw_knots(&picture, after, "new", "new knots", 5);
    draw_knots(&picture, before, "knot", "knots", 6.5);
    svg_close(&picture);
    free(net);
}

/* Every surface of the file as a grid of quadrilaterals with normals. */
static void write_mesh(const char *folder, const shape *shapes, int64_t count) {
    FILE *file = create_file(folder, "surfaces.obj");
    static double uv[2 * SIDE], derivs[SIDE * SIDE * 9];
    const int64_t counts[2] = {SIDE, SIDE};
    int64_t i, k;
    for (i = 0; i < count; ++i) {
        if (shapes[i].axes == 2 && shapes[i].dim == 3) {
            for (k = 0; k < 2 * SIDE; ++k) {
                uv[k] = param_at(&shapes[i], (int32_t)(k / SIDE), (double)(k % SIDE) / (SIDE - 1));
            }
            check(nurbs_eval_grid_derivs(shapes[i].g, 1, counts, uv, derivs, 0, 0, 0));
            obj_grid(file, shapes[i].name, derivs, SIDE, SIDE);
        }
    }
    close_file(file);
}

/* The most instructive shape with so many axes: free-form, clamped, not too large; NULL if there is none. */
static const shape *choose(const shape *shapes, int64_t count, int32_t axes) {
    const shape *best = NULL, *s;
    int64_t most = -1;
    for (s = shapes; s < shapes + count; ++s) {
        const int64_t merit = 1000 * (s->degree[0] > 2) + 500 * clamped(s) + (s->points < 64 ? s->points : 0);
        if (s->axes == axes && merit > most) {
            most = merit;
            best = s;
        }
    }
    return best;
}

/* What the header allows: twice the error of a point, and 2 for each inserted knot, in units of eps *
 * hull. */
static double allowance(const shape *before, const shape *after) {
    double units = 1;
    int32_t axis;
    for (axis = 0; axis < before->axes; ++axis) {
        const int32_t p = before->degree[axis];
        units += 2 * (p <= 3    ? 4
                      : p <= 15 ? 16
                                : 32) +
                 2 * (double)(after->count[axis] - before->count[axis]);
    }
    return units;
}

static void show(const shape *s, const char *folder) {
    shape finer;
    double moved, allowed;
    if (s == NULL) {
        return;
    }
    finer = refined(s);
    print_evaluation(s);
    moved = difference(s, &finer);
    allowed = allowance(s, &finer);
    printf("  %lld control points, %lld with more knots; the shape moved by %.2f eps * hull, rounding allows "
           "%g\n\n",
           (long long)s->points, (long long)finer.points, moved, allowed);
    if (!(moved <= allowed)) {
        fprintf(stderr, "quickstart: inserting knots has moved %s\n", s->name);
        exit(EXIT_FAILURE);
    }
    if (s->axes == 1) {
        draw_curve(folder, s, &finer);
    }
    nurbs_destroy(finer.g);
}

int main(int argc, char **argv) {
    const char *folder = argc > 2 ? argv[2] : ".";
    nurbs_list *list;
    shape *shapes;
    int64_t count;
    if (argc < 2 || argc > 3) {
        fprintf(stderr, "usage: quickstart FILE.igs [OUTPUT_FOLDER]\n");
        return 2;
    }
    check(nurbs_read_file(argv[1], NULL, &list));
    shapes = load_shapes(list, &count);
    print_contents(list, shapes, count);
    show(choose(shapes, count, 1), folder);
    show(choose(shapes, count, 2), folder);
    write_mesh(folder, shapes, count);
    while (count > 0) {
        nurbs_destroy(shapes[--count].g);
    }
    free(shapes);
    nurbs_list_destroy(list);
    return 0;
}
