/* SPDX-License-Identifier: MIT */
/* Cuts the faces of files by a hundred planes across each axis: draws what is found as seen along the axis (of a ship the body
 * plan, the buttocks and the waterlines), and tells how many loops there are, how well they close, and the areas inside. Ways
 * that end where faces share no edge are joined by their ends, if those are no farther apart than twice the largest tolerance of
 * the faces.
 * Compile: cc -std=c99 cut.c $(pkg-config --cflags --libs nurbs) -lm -o cut */
#include "gallery/draw.h"

enum { CUTS = 100, SHOWN = 5, STEPS = 48, MAX_WAYS = 64 }; /* every fifth plane is drawn, and its area told */

static const char *const names[3] = {"x", "y", "z"};
static const int across[3][2] = {{1, 2}, {0, 2}, {0, 1}}; /* what is seen along an axis */

/* A line through points of a plane, or a loop. */
typedef struct line {
    double *points;       /* [n][2] */
    int n, closed, known; /* whether it closed before lines were joined */
} line;

static void *room(void *memory, size_t size) {
    memory = realloc(memory, size);
    if (memory == NULL) {
        fprintf(stderr, "cut: out of memory\n");
        exit(EXIT_FAILURE);
    }
    return memory;
}

/* The box of all faces, and the largest of their tolerances. */
static double box_of(const nurbs_model *model, double *lower, double *upper) {
    double largest = 0;
    int64_t count, i;
    int k;
    for (k = 0; k < 3; ++k) {
        lower[k] = HUGE_VAL;
        upper[k] = -HUGE_VAL;
    }
    check(nurbs_model_counts(model, NULL, NULL, &count, NULL, NULL));
    for (i = 0; i < count; ++i) {
        double low[3], high[3], tolerance;
        nurbs_face *face;
        check(nurbs_model_face(model, i, NULL, NULL, NULL, NULL, &face));
        check(nurbs_face_box(face, 1e-3, low, high, NULL));
        check(nurbs_face_tolerance(face, &tolerance));
        nurbs_face_destroy(face);
        largest = fmax(largest, tolerance);
        for (k = 0; k < 3; ++k) {
            lower[k] = fmin(lower[k], low[k]);
            upper[k] = fmax(upper[k], high[k]);
        }
    }
    return largest;
}

/* Adds points along a branch, as they are seen along an axis. */
static void add_branch(line *to, const nurbs_meet *meet, int64_t branch, int axis) {
    double domain[2], params[STEPS + 1], points[3 * (STEPS + 1)];
    nurbs *curve, *on_surface;
    int k;
    check(nurbs_meet_branch(meet, branch, &curve, &on_surface));
    check(nurbs_domain(curve, 0, domain));
    for (k = 0; k <= STEPS; ++k) {
        const double t = (double)k / STEPS;
        params[k] = k == STEPS ? domain[1] : (1 - t) * domain[0] + t * domain[1];
    }
    check(nurbs_eval(curve, STEPS + 1, params, 0, 0, points, 0, 0, 0));
    nurbs_destroy(on_surface);
    nurbs_destroy(curve);
    to->points = room(to->points, (size_t)(to->n + STEPS + 1) * 2 * sizeof *to->points);
    for (k = 0; k <= STEPS; ++k) {
        to->points[2 * to->n] = points[3 * k + across[axis][0]];
        to->points[2 * to->n++ + 1] = points[3 * k + across[axis][1]];
    }
}

static const double *end_of(const line *of, int last) {
    return of->points + (last ? 2 * (of->n - 1) : 0);
}

static double between(const double *a, const double *b) {
    return hypot(a[0] - b[0], a[1] - b[1]);
}

static void turn(line *one) {
    int i, k;
    for (i = 0; i < one->n / 2; ++i) {
        for (k = 0; k < 2; ++k) {
            double *a = one->points + 2 * i + k, *b = one->points + 2 * (one->n - 1 - i) + k;
            const double x = *a;
            *a = *b;
            *b = x;
        }
    }
}

/* The second line goes on where the first one ends, and is empty then. */
static void append(line *to, line *from) {
    to->points = room(to->points, (size_t)(to->n + from->n) * 2 * sizeof *to->points);
    memcpy(to->points + 2 * to->n, from->points, (size_t)from->n * 2 * sizeof *to->points);
    to->n += from->n;
    from->n = 0;
}

/* Joins the two open lines that are nearest to each other by their ends; 0 if none are near. */
static int join_nearest(line *lines, int count, double near, double *gap) {
    int i, j, ends, best_i = -1, best_j = -1, best_ends = 0;
    double least = near;
    for (i = 0; i < count; ++i) {
        for (j = i; j < count && !lines[i].closed && lines[i].n > 0; ++j) {
            for (ends = i == j ? 1 : 0; ends < (i == j ? 2 : 4) && !lines[j].closed && lines[j].n > 0;
                 ++ends) {
                const double apart =
                    between(end_of(lines + i, ends & 1), end_of(lines + j, i != j && ends & 2));
                if (apart <= least) {
                    least = apart;
                    best_i = i;
                    best_j = j;
                    best_ends = ends;
                }
            }
        }
    }
    if (best_i < 0) {
        return 0;
    }
    *gap = fmax(*gap, least);
    if (best_i == best_j) {
        lines[best_i].closed = 1;
        return 1;
    }
    if (!(best_ends & 1)) {
        turn(lines + best_i);
    }
    if (best_ends & 2) {
        turn(lines + best_j);
    }
    append(lines + best_i, lines + best_j);
    return 1;
}

/* Inside of a loop, less than 0 if it runs clockwise; inside of a line and of a straight one between its ends. */
static double area_of(const line *of) {
    double sum = 0;
    int i;
    for (i = 0; i < of->n; ++i) {
        const double *a = of->points + 2 * i, *b = of->points + 2 * ((i + 1) % of->n);
        sum += 0.5 * (a[0] * b[1] - a[1] * b[0]);
    }
    return sum;
}

/* What is known of all planes across an axis. */
typedef struct findings {
    int loops, open;
    double gap, areas[CUTS];
} findings;

static void add_plane(gallery *picture, line *lines, int count, double near, int64_t plane, findings *found) {
    double area = 0, solid = 0; /* loops around holes of a solid run clockwise */
    int i;
    for (i = 0; i < count; ++i) {
        solid += lines[i].known ? area_of(lines + i) : 0;
    }
    while (join_nearest(lines, count, near, &found->gap)) {
    }
    for (i = 0; i < count; ++i) {
        if (lines[i].n > 0) {
            found->loops += lines[i].closed ? 1 : 0;
            found->open += lines[i].closed ? 0 : 1;
            area += lines[i].known ? 0 : fabs(area_of(lines + i));
            if (plane % SHOWN == 0) {
                add_line(picture, lines[i].closed ? "water" : "frame", lines[i].points, lines[i].n, 2);
            }
        }
        free(lines[i].points);
    }
    found->areas[plane] = area + fabs(solid);
}

/* Ways follow one another by their planes. */
static void add_ways(gallery *picture, const nurbs_meet *meet, int axis, double near, findings *found) {
    int64_t count, i, k, *levels, *firsts, *sizes;
    int32_t *closes;
    line lines[MAX_WAYS];
    int used = 0;
    check(nurbs_meet_ways(meet, 0, NULL, NULL, NULL, NULL, NULL, &count));
    levels = room(NULL, (size_t)(3 * count + 1) * sizeof *levels);
    firsts = levels + count;
    sizes = firsts + count;
    closes = room(NULL, (size_t)(count + 1) * sizeof *closes);
    check(nurbs_meet_ways(meet, count, levels, firsts, sizes, closes, NULL, NULL));
    for (i = 0; i < count; ++i) {
        line *one = lines + used++;
        one->points = NULL;
        one->n = 0;
        one->closed = one->known = closes[i];
        for (k = 0; k < sizes[i]; ++k) {
            add_branch(one, meet, firsts[i] + k, axis);
        }
        if (i + 1 == count || levels[i + 1] != levels[i] || used == MAX_WAYS) {
            add_plane(picture, lines, used, near, levels[i], found);
            used = 0;
        }
    }
    free(closes);
    free(levels);
}

static void cut_across(gallery *picture, const nurbs_model *model, const char *name, int axis, double lower,
                       double upper, double size, double near) {
    double normals[3 * CUTS] = {0}, at[CUTS];
    findings found = {0, 0, 0, {0}};
    nurbs_meet *meet;
    int32_t complete;
    char label[64];
    int i;
    for (i = 0; i < CUTS; ++i) {
        normals[3 * i + axis] = 1;
        at[i] = lower + (upper - lower) * (i + 0.5) / CUTS;
    }
    check(nurbs_model_sections(model, CUTS, normals, at, 1e-6 * size, &meet));
    check(nurbs_meet_counts(meet, NULL, NULL, &complete));
    add_ways(picture, meet, axis, near, &found);
    nurbs_meet_destroy(meet);
    printf("across %s: %d loops closed to %.1e, %d open lines, %s; areas", names[axis], found.loops,
           found.gap, found.open, complete ? "proven to be all" : "there may be more");
    for (i = 0; i < CUTS; i += SHOWN) {
        printf(" %.4g", found.areas[i]);
    }
    printf("\n");
    snprintf(label, sizeof label, "%.24s, %s", name, names[axis]);
    end_cell(picture, label);
}

/* The name of a file without its folder and its ending. */
static void short_name(const char *path, char *name, size_t size) {
    const char *slash = strrchr(path, '/');
    char *dot;
    snprintf(name, size, "%s", slash == NULL ? path : slash + 1);
    dot = strrchr(name, '.');
    if (dot != NULL) {
        *dot = '\0';
    }
}

static void cut_file(gallery *picture, const char *path) {
    char name[256];
    double lower[3], upper[3], size, tolerance;
    nurbs_model *model;
    int axis;
    check(nurbs_read_model_file(path, NULL, &model));
    short_name(path, name, sizeof name);
    tolerance = box_of(model, lower, upper);
    size = fmax(fmax(upper[0] - lower[0], upper[1] - lower[1]), upper[2] - lower[2]);
    printf("%s: %.6g x %.6g x %.6g\n", path, upper[0] - lower[0], upper[1] - lower[1], upper[2] - lower[2]);
    for (axis = 0; axis < 3; ++axis) {
        cut_across(picture, model, name, axis, lower[axis], upper[axis], size, 2 * tolerance);
    }
    nurbs_model_destroy(model);
}

int main(int argc, char **argv) {
    static gallery picture;
    int i;
    if (argc < 3) {
        fprintf(stderr, "usage: cut PICTURE.svg FILE...\n");
        return 2;
    }
    open_picture(&picture, argv[1], 3, argc - 2);
    for (i = 2; i < argc; ++i) {
        cut_file(&picture, argv[i]);
    }
    close_picture(&picture);
    return 0;
}
