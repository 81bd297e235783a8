/* SPDX-License-Identifier: MIT */
/* How high the scallops between two passes are, for toolpath.c: a bound for all of the part between them, not for samples.
 *
 * The domain is halved into cells. The control points of the surface over a cell have it in their hull, and their distance from
 * a segment of a pass is a convex function: no point of the cell is farther from the segment than the farthest control point.
 * Moved outwards by h along its own normal, which a cone of normals keeps near its axis, a point of the cell is where the ball
 * has been, if all control points moved by h along the axis are within the radius of one segment, less what the cone opens. If
 * that holds for all cells between two passes, the ball takes away all that is as high as h over the part. */
#ifndef TOOLPATH_SCALLOPS_H
#define TOOLPATH_SCALLOPS_H

#include "passes.h"

typedef struct cell {
    double range[2][2], low, high; /* parameters; the levels in it */
    double axis[3],
        spread; /* of the normals: none is farther than spread from the axis, as vectors of length 1 */
    double params[2], middle[3], normal[3];
    double *net, extent[2]; /* control points, and how far they go along each axis */
    int points, side;       /* side: 1 in the face, 0 perhaps, -1 outside */
    int child;              /* the first of two, 0: none yet */
} cell;

/* All cells that were looked at so far, and the function whose levels the passes follow. */
typedef struct cells {
    part *part;
    const tool *tool;
    const nurbs *guide;
    cell *cell;
    int count, most;
} cells;

/* The control points over a cell; as weights are positive, it is in their hull. */
static inline void take_net(cell *c, const nurbs *surface) {
    const double lower[2] = {c->range[0][0], c->range[1][0]}, upper[2] = {c->range[0][1], c->range[1][1]};
    int64_t count, rows[2], i, k;
    nurbs *part;
    check(nurbs_extract(surface, lower, upper, &part));
    check(nurbs_point_count(part, &count));
    check(nurbs_count(part, 0, &rows[0]));
    check(nurbs_count(part, 1, &rows[1]));
    c->points = (int)count;
    c->net = room(NULL, (size_t)count * 3 * sizeof *c->net);
    check(nurbs_points(part, count, c->net, 0, 0));
    for (i = 0; i < rows[0]; ++i) {
        for (k = 0; k < rows[1]; ++k) {
            const double *at = c->net + 3 * (i * rows[1] + k);
            c->extent[0] = fmax(c->extent[0], distance(at, c->net + 3 * k));
            c->extent[1] = fmax(c->extent[1], distance(at, c->net + 3 * i * rows[1]));
        }
    }
    nurbs_destroy(part);
}

/* The cone of the normals over a cell. One that is narrow already serves the halves, too. */
static inline void take_cone(cell *c, const part *p, const cell *whole) {
    double angle;
    int k;
    if (whole != NULL && whole->spread < 0.02) {
        memcpy(c->axis, whole->axis, sizeof c->axis);
        c->spread = whole->spread;
        return;
    }
    check(nurbs_normal_cone(p->surface, c->range[0], INFINITY, c->axis, &angle));
    c->spread = 2 * sin(fmin(angle, 3.1415926535897932) / 2) * (1 + 1e-15);
    for (k = 0; k < 3; ++k) {
        c->axis[k] *= p->outside;
    }
}

/* A cell, or a half of one. */
static inline int add_cell(cells *all, const double (*range)[2], const cell *whole) {
    part *p = all->part;
    cell c = {0};
    int k;
    memcpy(c.range, range, sizeof c.range);
    for (k = 0; k < 2; ++k) {
        c.params[k] = 0.5 * (range[k][0] + range[k][1]);
    }
    c.side = whole != NULL && whole->side > 0 ? 1 : side_of(p, range, c.params);
    if (c.side >= 0) {
        take_net(&c, p->surface);
        take_cone(&c, p, whole);
        check(nurbs_box(all->guide, range[0], INFINITY, &c.low, &c.high, NULL));
        check(nurbs_surface_eval_frames(p->surface, 1, c.params, 0, 0, c.middle, 0, 0, NULL, 0, 0, NULL, 0, 0,
                                        c.normal, 0, 0, NULL, 0));
        for (k = 0; k < 3; ++k) {
            c.normal[k] *= p->outside;
        }
    }
    if (all->count == all->most) {
        all->most = 2 * all->most + 64;
        all->cell = room(all->cell, (size_t)all->most * sizeof *all->cell);
    }
    all->cell[all->count] = c;
    return all->count++;
}

static inline cells make_cells(part *p, const tool *t, const nurbs *guide) {
    cells all = {0};
    all.part = p;
    all.tool = t;
    all.guide = guide;
    add_cell(&all, (const double(*)[2])p->domain, NULL);
    return all;
}

static inline void free_cells(cells *all) {
    int i;
    for (i = 0; i < all->count; ++i) {
        free(all->cell[i].net);
    }
    free(all->cell);
}

/* Both halves of a cell, across the axis along which it is longer; memory of cells may move. */
static inline void halve(cells *all, int index) {
    const cell c = all->cell[index];
    const int axis = c.extent[1] > c.extent[0];
    double range[2][2];
    int half, first = 0;
    for (half = 0; half < 2; ++half) {
        memcpy(range, c.range, sizeof range);
        range[axis][1 - half] = c.params[axis];
        first = add_cell(all, (const double(*)[2])range, &c) - half;
    }
    all->cell[index].child = first;
}

/* What lies between two passes, one of which may be missing; and the bound that is found. */
typedef struct strip {
    const pass *a, *b;
    double from, to, found;
} strip;

/* The segment of a pass that is nearest to a point; its end, 0 if there is none. */
static inline int nearest_segment(const pass *a, const double *x) {
    double least = INFINITY;
    int i, best = 0;
    for (i = 1; a != NULL && i < a->n; ++i) {
        const double d = a->begins[i] ? INFINITY : to_segment(x, a->centre[i - 1], a->centre[i]);
        if (d < least) {
            least = d;
            best = i;
        }
    }
    return best;
}

/* The largest distance of points from a segment, moved by h along a direction. */
static inline double farthest(const double *points, int n, const double *direction, double h, const double *a,
                              const double *b) {
    double most = 0;
    int i;
    for (i = 0; i < n; ++i) {
        const double *p = points + 3 * i;
        const double moved[3] = {p[0] + h * direction[0], p[1] + h * direction[1], p[2] + h * direction[2]};
        most = fmax(most, to_segment(moved, a, b));
    }
    return most;
}

/* A height at which the ball has been over all of some points along a segment, found by halving; INFINITY: the limit is none. */
static inline double least_height(const double *points, int n, const double *direction, double spread,
                                  double reach, double limit, const double *a, const double *b) {
    double low = 0, high = limit;
    int i;
    if (farthest(points, n, direction, limit, a, b) + limit * spread > reach) {
        return INFINITY;
    }
    for (i = 0; i < 16; ++i) {
        const double h = 0.5 * (low + high);
        *(farthest(points, n, direction, h, a, b) + h * spread <= reach ? &high : &low) = h;
    }
    return high;
}

/* The least height of a cell, and of its middle alone, over the nearest segment of either pass. */
static inline double height_over(const cells *all, const cell *c, const strip *s, double *of_middle) {
    const tool *t = all->tool;
    const double reach = t->radius - rounding_of(all->part, t);
    const pass *const sides[2] = {s->a, s->b};
    double least = INFINITY;
    int k;
    *of_middle = INFINITY;
    for (k = 0; k < 2; ++k) {
        const int i = nearest_segment(sides[k], c->middle);
        if (i > 0) {
            const double *a = sides[k]->centre[i - 1], *b = sides[k]->centre[i];
            least = fmin(least, least_height(c->net, c->points, c->axis, c->spread, reach, t->scallop, a, b));
            *of_middle = fmin(*of_middle, least_height(c->middle, 1, c->normal, 0, reach, t->scallop, a, b));
        }
    }
    return least;
}

static inline int is_inside(const cells *all, const cell *c, const strip *s) {
    double level;
    int32_t side = c->side;
    if (side == 0) {
        check(nurbs_face_classify(all->part->face, 1, c->params, 0, 0, 0, &side));
    }
    check(nurbs_eval(all->guide, 1, c->params, 0, 0, &level, 0, 0, 0));
    return side > 0 && s->from <= level && level <= s->to;
}

/* Whether no scallop over a cell is higher than the tool may leave it. Where it is lower than most of that, or not much higher than
 * over the middle of the cell, halving would tell nothing new. */
static inline int is_cut(cells *all, int index, strip *s) {
    const cell c = all->cell[index];
    const tool *t = all->tool;
    double height, of_middle;
    if (c.side < 0 || c.high < s->from || c.low > s->to) {
        return 1;
    }
    height = height_over(all, &c, s, &of_middle);
    if (height < INFINITY && height <= fmax(fmax(s->found, 0.7 * t->scallop), 1.2 * of_middle)) {
        s->found = fmax(s->found, height);
        return 1;
    }
    if ((of_middle == INFINITY && is_inside(all, &c, s)) ||
        fmax(c.extent[0], c.extent[1]) < 0.02 * t->scallop) {
        return 0;
    }
    if (c.child == 0) {
        halve(all, index);
    }
    return is_cut(all, all->cell[index].child, s) && is_cut(all, all->cell[index].child + 1, s);
}

/* The levels on the face, from the cells that may be in it. */
static inline void levels_of(cells *all, int index, int depth, double *low, double *high) {
    const cell c = all->cell[index];
    if (c.side < 0) {
        return;
    }
    if (depth == 0) {
        *low = fmin(*low, c.low);
        *high = fmax(*high, c.high);
        return;
    }
    if (c.child == 0) {
        halve(all, index);
    }
    levels_of(all, all->cell[index].child, depth - 1, low, high);
    levels_of(all, all->cell[index].child + 1, depth - 1, low, high);
}

#endif
