/* SPDX-License-Identifier: MIT */
/* Writes pictures for quickstart.c: line drawings as SVG, grids of a surface as OBJ. Nothing here is
 * about splines. */
#ifndef PICTURES_H
#define PICTURES_H

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

static void *allocate(int64_t n, size_t size) {
    void *memory = malloc((size_t)n * size);
    if (memory == NULL) {
        fprintf(stderr, "quickstart: out of memory\n");
        exit(EXIT_FAILURE);
    }
    return memory;
}

static FILE *create_file(const char *folder, const char *name) {
    char path[1024];
    FILE *file;
    snprintf(path, sizeof path, "%s/%s", folder, name);
    file = fopen(path, "w");
    if (file == NULL) {
        perror(path);
        exit(EXIT_FAILURE);
    }
    printf("writing %s\n", path);
    return file;
}

static void close_file(FILE *file) {
    const int failed = ferror(file);
    if (fclose(file) != 0 || failed) {
        perror("writing a file");
        exit(EXIT_FAILURE);
    }
}

/* --- SVG --- */

enum { SVG_WIDTH = 960, SVG_HEIGHT = 600, SVG_MARGIN = 40, SVG_LEGEND = 220, SVG_TITLE = 50 };

/* A drawing of points with `dim` coordinates, projected along the axis on which they extend the least. */
typedef struct svg {
    FILE *file;
    int32_t dim, x, y;
    double left, top, scale;
    int rows; /* of the legend */
} svg;

static void extent(const double *points, int64_t n, int32_t dim, int32_t axis, double *low, double *high) {
    int64_t i;
    *low = *high = points[axis];
    for (i = 1; i < n; ++i) {
        *low = fmin(*low, points[i * dim + axis]);
        *high = fmax(*high, points[i * dim + axis]);
    }
}

/* Chooses the two axes to draw. */
static void svg_project(svg *s, const double *points, int64_t n) {
    int32_t axis, least = 0;
    double low, high, smallest = HUGE_VAL;
    for (axis = s->dim - 1; axis >= 0; --axis) {
        extent(points, n, s->dim, axis, &low, &high);
        if (high - low < smallest) {
            smallest = high - low;
            least = axis;
        }
    }
    least = s->dim == 2 ? 2 : least;
    s->x = least == 0 ? 1 : 0;
    s->y = least == 2 ? 1 : 2;
}

/* Fits the box around the points into the area beside the legend. */
static void svg_fit(svg *s, const double *points, int64_t n) {
    const double width = SVG_WIDTH - SVG_LEGEND - 2 * SVG_MARGIN;
    const double height = SVG_HEIGHT - SVG_TITLE - 2 * SVG_MARGIN;
    double x0, x1, y0, y1;
    extent(points, n, s->dim, s->x, &x0, &x1);
    extent(points, n, s->dim, s->y, &y0, &y1);
    s->scale = fmin(x1 > x0 ? width / (x1 - x0) : HUGE_VAL, y1 > y0 ? height / (y1 - y0) : HUGE_VAL);
    s->scale = isfinite(s->scale) ? s->scale : 1;
    s->left = SVG_MARGIN + 0.5 * width - 0.5 * (x0 + x1) * s->scale;
    s->top = SVG_TITLE + SVG_MARGIN + 0.5 * height + 0.5 * (y0 + y1) * s->scale;
}

static void svg_text(svg *s, double x, double y, const char *style, const char *text) {
    fprintf(s->file, "<text class=\"%s\" x=\"%g\" y=\"%g\">", style, x, y);
    for (; *text != '\0'; ++text) {
        if (*text == '<' || *text == '&') {
            fprintf(s->file, "&#%d;", *text);
        } else {
            fputc(*text, s->file);
        }
    }
    fprintf(s->file, "</text>\n");
}

static const char svg_styles[] =
    "<style>\n"
    "text { font: 14px sans-serif; fill: #1f2933 } .title { font: bold 20px sans-serif }\n"
    "path { fill: none; stroke-linejoin: round; stroke-linecap: round }\n"
    "path.curve { stroke: #0b4f8a; stroke-width: 4 }\n"
    "path.before { stroke: #9aa5b1; stroke-width: 1.5; stroke-dasharray: 7 5 }\n"
    "path.after { stroke: #e07a1f; stroke-width: 1.5 }\n"
    "circle.before { fill: #fff; stroke: #7b8794; stroke-width: 1.5 }\n"
    "circle.after { fill: #e07a1f }\n"
    "circle.knot { fill: #0b4f8a; stroke: #fff; stroke-width: 1.5 }\n"
    "circle.new { fill: #fff; stroke: #c2255c; stroke-width: 2.5 }\n"
    "</style>\n";

static void svg_open(svg *s, FILE *file, const char *title, const double *points, int64_t n, int32_t dim) {
    s->file = file;
    s->dim = dim;
    s->rows = 0;
    svg_project(s, points, n);
    svg_fit(s, points, n);
    fprintf(file, "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\">\n%s", SVG_WIDTH,
            SVG_HEIGHT, svg_styles);
    fprintf(file, "<rect width=\"%d\" height=\"%d\" fill=\"#fbfaf7\"/>\n", SVG_WIDTH, SVG_HEIGHT);
    svg_text(s, SVG_MARGIN, SVG_TITLE, "title", title);
}

static void svg_line(svg *s, const char *style, const double *points, int64_t n) {
    int64_t i;
    fprintf(s->file, "<path class=\"%s\" d=\"", style);
    for (i = 0; i < n; ++i) {
        const double *p = points + i * s->dim;
        fprintf(s->file, "%c%.2f %.2f", i == 0 ? 'M' : 'L', s->left + p[s->x] * s->scale,
                s->top - p[s->y] * s->scale);
    }
    fprintf(s->file, "\"/>\n");
}

static void svg_dots(svg *s, const char *style, const double *points, int64_t n, double radius) {
    int64_t i;
    for (i = 0; i < n; ++i) {
        const double *p = points + i * s->dim;
        fprintf(s->file, "<circle class=\"%s\" cx=\"%.2f\" cy=\"%.2f\" r=\"%g\"/>\n", style,
                s->left + p[s->x] * s->scale, s->top - p[s->y] * s->scale, radius);
    }
}

/* Points as dots where the radius is positive, and joined by a line if asked for; a row in the legend. */
static void svg_series(svg *s, const char *style, const char *label, const double *points, int64_t n,
                       int line, double radius) {
    const int x = SVG_WIDTH - SVG_LEGEND, y = SVG_TITLE + SVG_MARGIN + 30 * s->rows++;
    if (line) {
        svg_line(s, style, points, n);
        fprintf(s->file, "<path class=\"%s\" d=\"M%d %dh30\"/>\n", style, x, y);
    }
    if (radius > 0) {
        svg_dots(s, style, points, n, radius);
        fprintf(s->file, "<circle class=\"%s\" cx=\"%d\" cy=\"%d\" r=\"%g\"/>\n", style, x + 15, y, radius);
    }
    svg_text(s, x + 42, y + 5, "label", label);
}

static void svg_close(svg *s) {
    fprintf(s->file, "</svg>\n");
}

/* --- OBJ --- */

/* The unit normal of du and dv; 0 if they do not span a plane. */
static int unit_normal(const double *du, const double *dv, double *normal) {
    double length;
    normal[0] = du[1] * dv[2] - du[2] * dv[1];
    normal[1] = du[2] * dv[0] - du[0] * dv[2];
    normal[2] = du[0] * dv[1] - du[1] * dv[0];
    length = sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
    if (!(length > 1e-12 * hypot(hypot(du[0], du[1]), du[2]) * hypot(hypot(dv[0], dv[1]), dv[2]))) {
        return 0;
    }
    normal[0] /= length;
    normal[1] /= length;
    normal[2] /= length;
    return 1;
}

/* Where an edge collapses to a point there is no normal: that of the next place towards the middle serves. */
static void grid_normal(const double *derivs, int i, int j, int rows, int columns, double *normal) {
    const double *d = derivs + 9 * (i * columns + j);
    while (!unit_normal(d + 3, d + 6, normal) && (i != rows / 2 || j != columns / 2)) {
        i += (i < rows / 2) - (i > rows / 2);
        j += (j < columns / 2) - (j > columns / 2);
        d = derivs + 9 * (i * columns + j);
    }
}

/* An object of rows * columns vertices; derivs has point, d/du and d/dv of each. Indices count back from the
 * end. */
static void obj_grid(FILE *file, const char *name, const double *derivs, int rows, int columns) {
    int i, j;
    fprintf(file, "o %s\n", name);
    for (i = 0; i < rows * columns; ++i) {
        const double *p = derivs + 9 * i;
        double n[3];
        grid_normal(derivs, i / columns, i % columns, rows, columns, n);
        fprintf(file, "v %.9g %.9g %.9g\nvn %.4f %.4f %.4f\n", p[0], p[1], p[2], n[0], n[1], n[2]);
    }
    for (i = 0; i + 1 < rows; ++i) {
        for (j = 0; j + 1 < columns; ++j) {
            const int a = i * columns + j - rows * columns, b = a + columns;
            fprintf(file, "f %d//%d %d//%d %d//%d %d//%d\n", a, a, b, b, b + 1, b + 1, a + 1, a + 1);
        }
    }
}

#endif
