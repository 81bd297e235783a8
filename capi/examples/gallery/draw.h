/* SPDX-License-Identifier: MIT */
/* Draws splines into the cells of one SVG picture for gallery.c and hull.c: curves as lines, surfaces as
 * shaded quadrilaterals that are painted from the farthest to the nearest, volumes as their faces. What is
 * said about splines here is in sample_curve() and sample_surface(). */
#ifndef GALLERY_DRAW_H
#define GALLERY_DRAW_H

#include <nurbs/nurbs.h>

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Lengths in fifths of a pixel, so that coordinates are integers. */
enum { CELL = 700, MARGIN = 65, LABEL = 100, SHADES = 8, MAX_POINTS = 40000, MAX_ITEMS = 8000 };

/* A path over points of the cell. What is nearer to the eye has more depth; lines in the plane have none. */
typedef struct item {
    int first, count;
    double depth;
    char style[8];
} item;

typedef struct gallery {
    FILE *file;
    int columns, cells, points, items;
    double point[MAX_POINTS][2];
    item item[MAX_ITEMS];
} gallery;

static inline void check(nurbs_status status) {
    char message[512];
    if (status != NURBS_OK) {
        nurbs_last_error(message, (int64_t)sizeof message);
        fprintf(stderr, "gallery: %s: %s\n", nurbs_status_name(status), message);
        exit(EXIT_FAILURE);
    }
}

/* --- the view: from the side of (2, 1, 1.1) on the origin, without perspective --- */

static const double to_right[3] = {-0.447213595499958, 0.894427190999916, 0};
static const double to_top[3] = {-0.394771, -0.197386, 0.897331};
static const double to_eye[3] = {0.802597, 0.401299, 0.441376};
static const double to_light[3] = {0.468, -0.234, 0.852};

static inline double dot(const double *a, const double *b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void add_point(gallery *p, const double *x, int32_t dim) {
    double *to = p->point[p->points++];
    to[0] = dim == 2 ? x[0] : dot(x, to_right);
    to[1] = dim == 2 ? x[1] : dot(x, to_top);
    if (p->points == MAX_POINTS || p->items == MAX_ITEMS) {
        fprintf(stderr, "gallery: a cell is too full\n");
        exit(EXIT_FAILURE);
    }
}

static inline void add_item(gallery *p, const char *style, int count, double depth) {
    item *it = &p->item[p->items++];
    it->first = p->points;
    it->count = count;
    it->depth = floor(1e6 * depth); /* what is equal but for rounding stays in its order */
    snprintf(it->style, sizeof it->style, "%s", style);
}

/* A line in space goes piece by piece, a little in front of the surface that it may lie on. */
static inline void add_line(gallery *p, const char *style, const double *points, int n, int32_t dim) {
    const int pieces = dim == 3 && n > 1 ? n - 1 : 1, size = pieces > 1 ? 2 : n;
    int i, k;
    for (i = 0; i < pieces; ++i) {
        const double *at = points + i * dim;
        add_item(p, style, size, dim == 3 ? 0.06 + dot(at, to_eye) : 0);
        for (k = 0; k < size; ++k) {
            add_point(p, at + k * dim, dim);
        }
    }
}

static inline void add_dots(gallery *p, const char *style, const double *points, int n, int32_t dim) {
    int i;
    for (i = 0; i < n; ++i) {
        add_line(p, style, points + i * dim, 1, dim);
    }
}

/* --- curves --- */

enum { MAX_SAMPLES = 400, MAX_NET = 64 };

/* Points at equal steps between the knots of a clamped curve; corners are met, and what is straight has no
 * others. */
static inline int sample_curve(const nurbs *g, double *points, int32_t *dim) {
    double knots[MAX_SAMPLES], params[MAX_SAMPLES];
    int32_t degree, steps;
    int64_t count;
    int i, n;
    check(nurbs_dimension(g, dim));
    check(nurbs_degree(g, 0, &degree));
    check(nurbs_distinct_knots(g, 0, MAX_SAMPLES, knots, NULL, &count));
    steps = degree == 1 ? 1 : (int32_t)fmax(3, fmin(24, 144 / (double)(count - 1)));
    n = (int)(count - 1) * steps + 1;
    if (n > MAX_SAMPLES) {
        fprintf(stderr, "gallery: a curve of too many pieces\n");
        exit(EXIT_FAILURE);
    }
    for (i = 0; i < n; ++i) {
        const double t = (double)(i % steps) / steps;
        params[i] = i + 1 == n ? knots[count - 1] : (1 - t) * knots[i / steps] + t * knots[i / steps + 1];
    }
    check(nurbs_eval(g, n, params, 0, 0, points, 0, 0, 0));
    return n;
}

static inline void add_curve(gallery *p, const nurbs *g, const char *style) {
    double points[3 * MAX_SAMPLES];
    int32_t dim;
    const int n = sample_curve(g, points, &dim);
    add_line(p, style, points, n, dim);
}

/* The control polygon. */
static inline void add_net(gallery *p, const nurbs *g) {
    double points[3 * MAX_NET];
    int64_t n;
    int32_t dim;
    check(nurbs_dimension(g, &dim));
    check(nurbs_point_count(g, &n));
    if (n <= MAX_NET) {
        check(nurbs_points(g, n, points, 0, 0));
        add_line(p, "net", points, (int)n, dim);
        add_dots(p, "point", points, (int)n, dim);
    }
}

/* --- surfaces and volumes --- */

enum { MAX_SIDE = 33 };

/* Points on a grid of equal steps, rows * columns of them. */
static inline void sample_surface(const nurbs *g, int rows, int columns, double *points) {
    const int64_t counts[2] = {rows, columns};
    double params[2 * MAX_SIDE], domain[2];
    int axis, i, k = 0;
    for (axis = 0; axis < 2; ++axis) {
        check(nurbs_domain(g, axis, domain));
        for (i = 0; i < counts[axis]; ++i) {
            const double t = (double)i / (double)(counts[axis] - 1);
            params[k++] = (1 - t) * domain[0] + t * domain[1];
        }
    }
    check(nurbs_eval_grid(g, counts, params, points, 0, 0, 0));
}

/* Half of the product of the diagonals, the normal times the area. */
static inline void quad_normal(const double *const corner[4], double *normal) {
    double a[3], b[3];
    int k;
    for (k = 0; k < 3; ++k) {
        a[k] = corner[2][k] - corner[0][k];
        b[k] = corner[3][k] - corner[1][k];
    }
    normal[0] = a[1] * b[2] - a[2] * b[1];
    normal[1] = a[2] * b[0] - a[0] * b[2];
    normal[2] = a[0] * b[1] - a[1] * b[0];
}

/* Which side of a surface is the outer one, and whether the inner one can be seen. */
enum { OPEN = 0, CLOSED = 1, TURNED = 2 };

/* One quadrilateral: the outer side is blue, the inner one orange. */
static inline void add_quad(gallery *p, const double *const corner[4], int sides) {
    double normal[3], length, light, depth = 0;
    char style[3] = "f0";
    int k, outside;
    quad_normal(corner, normal);
    length = sqrt(dot(normal, normal)) * (sides & TURNED ? -1 : 1);
    outside = dot(normal, to_eye) * length > 0;
    if (length == 0 || (sides & CLOSED && !outside)) {
        return;
    }
    light = dot(normal, to_light) / (outside ? length : -length);
    style[0] = outside ? 'f' : 'b';
    style[1] = "01234567"[(int)fmin(SHADES - 1, fmax(0, floor(SHADES * (0.35 + 0.6 * light))))];
    for (k = 0; k < 4; ++k) {
        depth += 0.25 * dot(corner[k], to_eye);
    }
    add_item(p, style, 4, depth);
    for (k = 0; k < 4; ++k) {
        add_point(p, corner[k], 3);
    }
}

static inline void add_surface(gallery *p, const nurbs *g, int rows, int columns, int sides) {
    double points[MAX_SIDE * MAX_SIDE * 3];
    int i, j;
    sample_surface(g, rows + 1, columns + 1, points);
    for (i = 0; i < rows; ++i) {
        for (j = 0; j < columns; ++j) {
            const double *at = points + 3 * (i * (columns + 1) + j);
            const double *const corner[4] = {at, at + 3 * (columns + 1), at + 3 * (columns + 2), at + 3};
            add_quad(p, corner, sides);
        }
    }
}

static inline nurbs *item_of(const nurbs_list *list, int64_t index) {
    nurbs *g;
    check(nurbs_list_get(list, index, &g));
    return g;
}

/* The curves around a surface. */
static inline void add_edges(gallery *p, const nurbs *g) {
    nurbs_list *list;
    int i;
    check(nurbs_boundaries(g, &list));
    for (i = 0; i < 4; ++i) {
        nurbs *curve = item_of(list, i);
        add_curve(p, curve, "edge");
        nurbs_destroy(curve);
    }
    nurbs_list_destroy(list);
}

/* The faces of a volume whose axes are right-handed: the normals of three of them point into it. */
static inline void add_faces(gallery *p, const nurbs *g, int side) {
    static const int sides[6] = {CLOSED | TURNED, CLOSED, CLOSED, CLOSED | TURNED, CLOSED | TURNED, CLOSED};
    nurbs_list *list;
    int i;
    check(nurbs_boundaries(g, &list));
    for (i = 0; i < 6; ++i) {
        nurbs *face = item_of(list, i);
        add_surface(p, face, side, side, sides[i]);
        nurbs_destroy(face);
    }
    nurbs_list_destroy(list);
}

/* --- the picture --- */

static const char picture_styles[] =
    "<style>\n"
    "text { font: 50px sans-serif; fill: #1f2933; text-anchor: middle }\n"
    "path { fill: none; stroke-linejoin: round; stroke-linecap: round }\n"
    ".curve { stroke: #0b4f8a; stroke-width: 14 } .other { stroke: #e07a1f; stroke-width: 9 }\n"
    ".edge { stroke: #102a43; stroke-width: 9 }\n"
    ".water { stroke: #0b4f8a; stroke-width: 6 } .frame { stroke: #d9480f; stroke-width: 6 }\n"
    ".net { stroke: #9aa5b1; stroke-width: 4; stroke-dasharray: 15 12 }\n"
    ".point { stroke: #7b8794; stroke-width: 21 } .given { stroke: #c2255c; stroke-width: 30 }\n"
    ".data { stroke: #c2255c; stroke-width: 15 }\n"
    ".tangent { stroke: #c2255c; stroke-width: 7 }\n";

static inline void write_shades(FILE *file) {
    int i;
    for (i = 0; i < SHADES; ++i) {
        const double t = (double)i / (SHADES - 1);
        fprintf(file, ".f%d { fill: #%02x%02x%02x }\n", i, (int)(20 + 170 * t), (int)(60 + 160 * t),
                (int)(110 + 135 * t));
        fprintf(file, ".b%d { fill: #%02x%02x%02x }\n", i, (int)(130 + 118 * t), (int)(70 + 140 * t),
                (int)(30 + 130 * t));
    }
}

static inline void open_picture(gallery *p, const char *path, int columns, int rows) {
    const int width = columns * CELL, height = rows * (CELL + LABEL);
    p->file = fopen(path, "w");
    if (p->file == NULL) {
        perror(path);
        exit(EXIT_FAILURE);
    }
    p->columns = columns;
    p->cells = p->points = p->items = 0;
    fprintf(p->file, "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\">\n%s", width, height,
            picture_styles);
    write_shades(p->file);
    fprintf(p->file, "</style>\n<rect width=\"%d\" height=\"%d\" fill=\"#fbfaf7\"/>\n", width, height);
}

static inline void close_picture(gallery *p) {
    int failed;
    fprintf(p->file, "</svg>\n");
    failed = ferror(p->file);
    if (fclose(p->file) != 0 || failed) {
        perror("writing the picture");
        exit(EXIT_FAILURE);
    }
}

static inline int farther_first(const void *a, const void *b) {
    const item *p = a, *q = b;
    if (p->depth != q->depth) {
        return p->depth < q->depth ? -1 : 1;
    }
    return p->first < q->first ? -1 : p->first > q->first;
}

/* Where the points of the cell come to lie. */
typedef struct fit {
    double scale, x, y;
} fit;

static inline fit fit_cell(const gallery *p) {
    double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
    fit f;
    int i, k;
    for (i = 0; i < p->points; ++i) {
        for (k = 0; k < 2; ++k) {
            low[k] = fmin(low[k], p->point[i][k]);
            high[k] = fmax(high[k], p->point[i][k]);
        }
    }
    f.scale = (CELL - 2 * MARGIN) / fmax(fmax(high[0] - low[0], high[1] - low[1]), 1e-9);
    f.x = 0.5 * CELL - 0.5 * f.scale * (low[0] + high[0]);
    f.y = 0.5 * CELL + 0.5 * f.scale * (low[1] + high[1]);
    return f;
}

static inline int is_quad(const item *it) {
    return it->style[1] >= '0' && it->style[1] <= '9';
}

/* Whether b begins where a ends. */
static inline int goes_on(const gallery *p, const item *a, const item *b) {
    const double *end = p->point[a->first + a->count - 1], *start = p->point[b->first];
    return !is_quad(a) && end[0] == start[0] && end[1] == start[1];
}

/* Steps from point to point, negative ones without a space before them. */
static inline void write_path(const gallery *p, const item *it, const fit *f, int goes_on_from_last) {
    int i, x, y, old_x = 0, old_y = 0;
    for (i = it->first; i < it->first + it->count; ++i) {
        const int k = i - it->first;
        x = (int)floor(f->x + f->scale * p->point[i][0] + 0.5);
        y = (int)floor(f->y - f->scale * p->point[i][1] + 0.5);
        if (k > 0 || !goes_on_from_last) {
            const char *before = k == 0 ? "M" : k == 1 ? "l" : x - old_x < 0 ? "" : " ";
            fprintf(p->file, y - old_y < 0 ? "%s%d%d" : "%s%d %d", before, x - old_x, y - old_y);
        }
        old_x = x;
        old_y = y;
    }
    fputs(is_quad(it) ? "z" : it->count == 1 ? "h0" : "", p->file);
}

/* Neighbours of one style share a path. */
static inline void write_items(const gallery *p, const fit *f) {
    int i;
    for (i = 0; i < p->items; ++i) {
        const item *it = &p->item[i];
        const int same = i > 0 && strcmp(it->style, it[-1].style) == 0;
        if (!same) {
            fprintf(p->file, "%s<path class=\"%s\" d=\"", i > 0 ? "\"/>\n" : "", it->style);
        }
        write_path(p, it, f, same && goes_on(p, it - 1, it));
    }
    fputs(p->items > 0 ? "\"/>\n" : "", p->file);
}

/* Writes what was added since the last cell, under a label. */
static inline void end_cell(gallery *p, const char *label) {
    const int x = p->cells % p->columns * CELL, y = p->cells / p->columns * (CELL + LABEL);
    const fit f = fit_cell(p);
    qsort(p->item, (size_t)p->items, sizeof *p->item, farther_first);
    fprintf(p->file, "<g transform=\"translate(%d %d)\">\n", x, y);
    write_items(p, &f);
    fprintf(p->file, "<text x=\"%d\" y=\"%d\">%s</text>\n</g>\n", CELL / 2, CELL + LABEL / 3, label);
    ++p->cells;
    p->points = p->items = 0;
}

/* --- one spline in a cell, which then is over --- */

static inline void show_curve(gallery *p, const char *label, nurbs *g) {
    add_net(p, g);
    add_curve(p, g, "curve");
    end_cell(p, label);
    nurbs_destroy(g);
}

static inline void show_surface(gallery *p, const char *label, nurbs *g, int rows, int columns, int sides) {
    add_surface(p, g, rows, columns, sides);
    end_cell(p, label);
    nurbs_destroy(g);
}

static inline void show_volume(gallery *p, const char *label, nurbs *g, int side) {
    add_faces(p, g, side);
    end_cell(p, label);
    nurbs_destroy(g);
}

#endif
