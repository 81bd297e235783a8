/* SPDX-License-Identifier: MIT */
/* What toolpath.c cuts: a face of a file or a surface of its own, its outer side, its border in the domain, and its largest
 * concave curvature. */
#ifndef TOOLPATH_PART_H
#define TOOLPATH_PART_H

#include "../gallery/draw.h"

enum { GRID = 48 };

/* A ball and what it may leave and cut, as lengths. */
typedef struct tool {
    double radius, scallop, chord;
} tool;

/* A part of a curve of a loop, and the box in the domain that contains it. */
typedef struct piece {
    const nurbs *curve;
    double range[2], box[2][2];
    int child; /* the first of its halves, 0: none yet */
} piece;

typedef struct part {
    nurbs_face *face;
    nurbs *surface; /* that of the face, clamped: the same points at the same parameters */
    double outside; /* 1, or -1 where the outer normal is against that of the surface */
    double domain[2][2], lower[3], upper[3];
    double hull;   /* the largest coordinate of a control point, times the ratio of the weights */
    nurbs **curve; /* those of all loops, and their pieces, the first ones being whole curves */
    piece *piece;
    int curves, pieces;
} part;

static inline void *room(void *memory, size_t size) {
    memory = realloc(memory, size);
    if (memory == NULL) {
        fprintf(stderr, "toolpath: out of memory\n");
        exit(EXIT_FAILURE);
    }
    return memory;
}

/* Ends the program, since no paths can be made; told as a printf. */
#define REFUSE(...) (fprintf(stderr, "toolpath: " __VA_ARGS__), fputc('\n', stderr), exit(EXIT_FAILURE))

static inline double between(double a, double b, int i, int n) {
    const double t = (double)i / n;
    return i == n ? b : (1 - t) * a + t * b;
}

/* Does something for each curve of each loop. */
static inline void each_curve(part *p, void (*what)(part *, int64_t loop, int64_t index, void *),
                              void *user) {
    int64_t loops, i, k, *sizes;
    check(nurbs_face_loops(p->face, 0, NULL, &loops));
    sizes = room(NULL, (size_t)(loops + 1) * sizeof *sizes);
    check(nurbs_face_loops(p->face, loops, sizes, NULL));
    for (i = 0; i < loops; ++i) {
        for (k = 0; k < sizes[i]; ++k) {
            what(p, i, k, user);
        }
    }
    free(sizes);
}

static inline int add_piece(part *p, const nurbs *curve, double from, double to) {
    double lower[2], upper[2];
    piece one = {curve, {from, to}, {{0}}, 0};
    int axis;
    check(nurbs_box(curve, one.range, INFINITY, lower, upper, NULL));
    for (axis = 0; axis < 2; ++axis) {
        one.box[axis][0] = lower[axis];
        one.box[axis][1] = upper[axis];
    }
    if ((p->pieces & (p->pieces - 1)) == 0) { /* room for twice as many */
        p->piece = room(p->piece, (size_t)(2 * p->pieces + 1) * sizeof *p->piece);
    }
    p->piece[p->pieces] = one;
    return p->pieces++;
}

static inline void halve_piece(part *p, int index) {
    const piece whole = p->piece[index];
    const double middle = 0.5 * (whole.range[0] + whole.range[1]);
    const int first = add_piece(p, whole.curve, whole.range[0], middle);
    add_piece(p, whole.curve, middle, whole.range[1]);
    p->piece[index].child = first;
}

static inline void add_border(part *p, int64_t loop, int64_t index, void *user) {
    (void)user;
    p->curve = room(p->curve, (size_t)(p->curves + 1) * sizeof *p->curve);
    check(nurbs_face_curve(p->face, loop, index, &p->curve[p->curves++]));
}

static inline void take_borders(part *p) {
    double domain[2];
    int i;
    each_curve(p, add_border, NULL);
    for (i = 0; i < p->curves; ++i) {
        check(nurbs_domain(p->curve[i], 0, domain));
        add_piece(p, p->curve[i], domain[0], domain[1]);
    }
}

static inline int apart(const double (*a)[2], const double (*b)[2], const double *shift) {
    int k;
    for (k = 0; k < 2; ++k) {
        if (a[k][0] > b[k][1] + shift[k] || a[k][1] < b[k][0] + shift[k]) {
            return 1;
        }
    }
    return 0;
}

/* Whether a piece of a loop may meet a rectangle of the domain: its parts are looked at until they are smaller than that. */
static inline int meets(part *p, int index, const double (*range)[2], const double *shift) {
    const piece one = p->piece[index];
    if (apart(range, one.box, shift)) {
        return 0;
    }
    if (one.box[0][1] - one.box[0][0] <= 0.5 * (range[0][1] - range[0][0]) &&
        one.box[1][1] - one.box[1][0] <= 0.5 * (range[1][1] - range[1][0])) {
        return 1;
    }
    if (one.child == 0) {
        halve_piece(p, index);
    }
    return meets(p, p->piece[index].child, range, shift) || meets(p, p->piece[index].child + 1, range, shift);
}

/* 0: a rectangle of the domain may meet a loop, also where those run on in the next period of a closed axis; else it lies on one
 * side, 1 in the face and -1 outside. */
static inline int side_of(part *p, const double (*range)[2], const double *middle) {
    int32_t side;
    int i, j, k;
    for (i = 0; i < p->curves; ++i) {
        for (j = -1; j <= 1; ++j) {
            for (k = -1; k <= 1; ++k) {
                const double shift[2] = {j * (p->domain[0][1] - p->domain[0][0]),
                                         k * (p->domain[1][1] - p->domain[1][0])};
                if (meets(p, i, range, shift)) {
                    return 0;
                }
            }
        }
    }
    check(nurbs_face_classify(p->face, 1, middle, 0, 0, 0, &side));
    return side;
}

/* Replaces a surface. */
static inline nurbs *clamped(nurbs *g) {
    int axis;
    for (axis = 0; axis < 2; ++axis) {
        nurbs *next;
        check(nurbs_clamp_ends(g, axis, NURBS_FORM_CLAMPED_START | NURBS_FORM_CLAMPED_END, &next));
        nurbs_destroy(g);
        g = next;
    }
    return g;
}

static inline double hull_of(const nurbs *g) {
    double size = 0, least = INFINITY, most = 0, *points, *weights;
    int64_t count, i;
    check(nurbs_point_count(g, &count));
    points = room(NULL, (size_t)count * 4 * sizeof *points);
    weights = points + 3 * count;
    check(nurbs_points(g, count, points, 0, 0));
    check(nurbs_weights(g, count, weights, 0));
    for (i = 0; i < count; ++i) {
        least = fmin(least, weights[i]);
        most = fmax(most, weights[i]);
    }
    for (i = 0; i < 3 * count; ++i) {
        size = fmax(size, fabs(points[i]));
    }
    free(points);
    if (!(least > 0)) {
        REFUSE("a weight of the surface is not positive");
    }
    return size * most / least;
}

/* Takes a face, which belongs to the part from then on. */
static inline part make_part(nurbs_face *face, int against) {
    part p = {0};
    nurbs *surface;
    int32_t dim;
    int axis;
    p.face = face;
    p.outside = against ? -1 : 1;
    check(nurbs_face_surface(face, &surface));
    check(nurbs_dimension(surface, &dim));
    if (dim != 3) {
        REFUSE("the face is not in space");
    }
    p.surface = clamped(surface);
    for (axis = 0; axis < 2; ++axis) {
        check(nurbs_domain(p.surface, axis, p.domain[axis]));
    }
    p.hull = hull_of(p.surface);
    check(nurbs_face_box(face, 1e-3, p.lower, p.upper, NULL));
    take_borders(&p);
    return p;
}

static inline part read_part(const char *path, int64_t index) {
    nurbs_model *model;
    nurbs_face *face;
    int32_t against;
    check(nurbs_read_model_file(path, NULL, &model));
    check(nurbs_model_face(model, index, NULL, NULL, &against, NULL, &face));
    nurbs_model_destroy(model);
    return make_part(face, against);
}

/* A mould of 48 x 36 with a hill and a hollow. */
static inline part make_mould(void) {
    static const double heights[6][5] = {{3, 2, 0, 1, 2}, {2, 14, 20, 4, 0}, {1, 13, 18, 5, 1},
                                         {2, 4, 4, 2, 3}, {4, 0, -6, -1, 4}, {5, 2, 0, 2, 6}};
    static const int32_t degrees[2] = {3, 3};
    static const int64_t counts[2] = {6, 5};
    double knots[19], points[6][5][3];
    nurbs_face *face;
    nurbs *surface;
    int i, j;
    for (i = 0; i < 6; ++i) {
        for (j = 0; j < 5; ++j) {
            points[i][j][0] = 48.0 * i / 5;
            points[i][j][1] = 36.0 * j / 4;
            points[i][j][2] = heights[i][j];
        }
    }
    check(nurbs_knots_open_uniform(3, 6, 0, 1, 10, knots));
    check(nurbs_knots_open_uniform(3, 5, 0, 1, 9, knots + 10));
    check(nurbs_create(2, degrees, counts, knots, 19, 3, points[0][0], 0, 0, NULL, 0, 0, &surface));
    check(nurbs_face_create(surface, 0, NULL, NULL, NULL, NULL, 1e-6, 0, NULL, &face));
    nurbs_destroy(surface);
    return make_part(face, 0);
}

static inline void free_part(part *p) {
    int i;
    for (i = 0; i < p->curves; ++i) {
        nurbs_destroy(p->curve[i]);
    }
    free(p->curve);
    free(p->piece);
    nurbs_destroy(p->surface);
    nurbs_face_destroy(p->face);
}

/* --- places on a grid over the domain --- */

static inline void grid_params(const part *p, double (*params)[2]) {
    int i, j;
    for (i = 0; i <= GRID; ++i) {
        for (j = 0; j <= GRID; ++j) {
            double *at = params[i * (GRID + 1) + j];
            at[0] = between(p->domain[0][0], p->domain[0][1], i, GRID);
            at[1] = between(p->domain[1][0], p->domain[1][1], j, GRID);
        }
    }
}

enum { GRID_PLACES = (GRID + 1) * (GRID + 1) };

/* A ball that is larger than a hollow cannot reach the ground of it, and cuts into its sides: the smallest radius of a concave
 * curvature that is met on the grid, and where. What this leaves out the distances of the passes tell. */
static inline double smallest_hollow(const part *p, double *where) {
    static double params[GRID_PLACES][2], bends[GRID_PLACES][2];
    static int32_t sides[GRID_PLACES];
    double most = 0;
    int i;
    grid_params(p, params);
    check(nurbs_face_classify(p->face, GRID_PLACES, params[0], 0, 0, 0, sides));
    check(nurbs_surface_eval_curvatures(p->surface, GRID_PLACES, params[0], 0, 0, bends[0], 0, 0, NULL, 0, 0,
                                        NULL, 0, NULL, 0, NULL, 0));
    for (i = 0; i < GRID_PLACES; ++i) {
        const double bend = p->outside > 0 ? bends[i][0] : -bends[i][1]; /* towards the tool */
        if (sides[i] >= 0 && bend > most) {
            most = bend;
            check(nurbs_eval(p->surface, 1, params[i], 0, 0, where, 0, 0, 0));
        }
    }
    return 1 / most;
}

#endif
