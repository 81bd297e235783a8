/* SPDX-License-Identifier: MIT */
/* Paths of a ball over a face, to mill it: along the sections by planes, and along lines of one distance from the border. The
 * next pass is as far as it may be for the scallops in between to stay below a height, which is proven for each strip between
 * two passes; and how far the ball cuts into the face, or hangs above it, is proven for each segment of a path. Refuses a ball
 * that gouges. Writes a table of the positions of the centre, with these two
 * bounds, and a picture.
 * Compile: cc -std=c99 toolpath.c $(pkg-config --cflags --libs nurbs) -lm -o toolpath */
#include "toolpath/scallops.h"

enum { MOST_PASSES = 5000 };

/* All passes of one kind. */
typedef struct job {
    pass *pass;
    int n;
    double scallop; /* the largest bound of a strip */
} job;

/* --- what the passes follow --- */

/* The axis along which the face is longest: planes across it are not in the face. */
static int longest_axis(const part *p) {
    int k, best = 0;
    for (k = 1; k < 3; ++k) {
        best = p->upper[k] - p->lower[k] > p->upper[best] - p->lower[best] ? k : best;
    }
    return best;
}

/* Places and their distances from what of the border is not a seam, which loops pass there and back. */
typedef struct places {
    double (*point)[3], *distance;
    int64_t *keys;
    int curves;
} places;

static void list_key(part *p, int64_t loop, int64_t index, void *user) {
    places *to = user;
    nurbs *edge;
    to->keys = room(to->keys, (size_t)(to->curves + 1) * sizeof *to->keys);
    check(nurbs_face_edge(p->face, loop, index, &to->keys[to->curves++], &edge));
    nurbs_destroy(edge);
}

static int is_seam(const places *of, int64_t key) {
    int i;
    for (i = 0; key != 0 && i < of->curves; ++i) {
        if (of->keys[i] == -key) {
            return 1;
        }
    }
    return 0;
}

static void near_edge(part *p, int64_t loop, int64_t index, void *user) {
    static double found[GRID_PLACES];
    places *to = user;
    int64_t key;
    nurbs *edge;
    int i;
    check(nurbs_face_edge(p->face, loop, index, &key, &edge));
    if (!is_seam(to, key)) {
        check(nurbs_closest_points(edge, GRID_PLACES, to->point[0], 0, 0, NULL, 0, 0, NULL, 0, 0, NULL, 0, 0,
                                   found, 0, NULL, 0));
        for (i = 0; i < GRID_PLACES; ++i) {
            to->distance[i] = fmin(to->distance[i], found[i]);
        }
    }
    nurbs_destroy(edge);
}

/* A spline over the domain through distances from the border of the face, negative outside; NULL if there is no border. It need
 * not be exact: whatever the passes follow, what they leave is proven. */
static nurbs *border_distance(part *p) {
    static double params[GRID_PLACES][2], points[GRID_PLACES][3], far[GRID_PLACES], knots[2 * (GRID + 1)];
    static int32_t sides[GRID_PLACES];
    static const int32_t degrees[2] = {3, 3};
    static const int64_t counts[2] = {GRID + 1, GRID + 1};
    places to = {points, far, NULL, 0};
    nurbs *guide;
    int i;
    grid_params(p, params);
    check(nurbs_eval(p->surface, GRID_PLACES, params[0], 0, 0, points[0], 0, 0, 0));
    check(nurbs_face_classify(p->face, GRID_PLACES, params[0], 0, 0, 0, sides));
    for (i = 0; i < GRID_PLACES; ++i) {
        far[i] = INFINITY;
    }
    each_curve(p, list_key, &to);
    each_curve(p, near_edge, &to);
    free(to.keys);
    if (far[0] == INFINITY) {
        return NULL;
    }
    for (i = 0; i < GRID_PLACES; ++i) {
        far[i] = sides[i] < 0 ? -far[i] : far[i];
    }
    for (i = 0; i <= GRID; ++i) {
        knots[i] = params[i * (GRID + 1)][0];
        knots[GRID + 1 + i] = params[i][1];
    }
    check(nurbs_interpolate(2, degrees, counts, knots, 1, far, 0, 0, NULL, 0, NULL, &guide));
    return guide;
}

/* The pass along a level: the section by a plane if there is a normal, else a level curve of the guide. */
static pass pass_at(const cells *all, const double *normal, double level) {
    const double tolerance = all->tool->chord;
    nurbs_meet *meet;
    if (normal != NULL) {
        check(nurbs_surface_sections(all->part->surface, normal, 1, &level, tolerance, &meet));
    } else {
        check(nurbs_surface_level_curves(all->part->surface, all->guide, 1, &level, tolerance, &meet));
    }
    return make_pass(all->part, all->tool, level, meet);
}

/* --- as few passes as the scallops allow --- */

static int hold(cells *all, strip *s) {
    s->found = 0;
    return is_cut(all, 0, s);
}

/* The pass after the last one: the step is shortened until the scallops are low enough, and longer next time if they are lower
 * than that. */
static pass next_pass(cells *all, const double *normal, const pass *last, double from, double highest,
                      double *step) {
    for (;;) {
        const double level = from + *step < highest ? from + *step : 0.5 * (from + highest);
        pass next = pass_at(all, normal, level);
        strip s = {last, &next, last == NULL ? -INFINITY : from, level, 0};
        if (hold(all, &s)) {
            next.scallop = s.found;
            *step = fmin(*step, level - from) *
                    fmin(1.5, fmax(1.05, sqrt(all->tool->scallop / fmax(s.found, 1e-300))));
            return next;
        }
        free_pass(&next);
        *step = 0.8 * (level - from);
        if (*step < 1e-4 * (highest - from)) {
            REFUSE(
                "no step is short enough after the level %g: the ball does not reach all of the face there",
                from);
        }
    }
}

static job make_job(part *p, const tool *t, const nurbs *guide, const double *normal) {
    cells all = make_cells(p, t, guide);
    job j = {NULL, 0, 0};
    double low = INFINITY, high = -INFINITY, step = sqrt(2 * t->radius * t->scallop);
    levels_of(&all, 0, 8, &low, &high);
    for (;;) {
        const pass *last = j.n > 0 ? &j.pass[j.n - 1] : NULL;
        strip rest = {last, NULL, last == NULL ? -INFINITY : last->level, INFINITY, 0};
        if (last != NULL && hold(&all, &rest)) {
            j.scallop = fmax(j.scallop, rest.found);
            break;
        }
        if (j.n == MOST_PASSES) {
            REFUSE("more than %d passes are needed", MOST_PASSES);
        }
        j.pass = room(j.pass, (size_t)(j.n + 1) * sizeof *j.pass);
        last = j.n > 0 ? &j.pass[j.n - 1] : NULL;
        j.pass[j.n] = next_pass(&all, normal, last, last == NULL ? low : last->level, high, &step);
        j.scallop = fmax(j.scallop, j.pass[j.n++].scallop);
    }
    free_cells(&all);
    return j;
}

/* --- what is told, written and drawn --- */

static void tell(const job *j, const char *name) {
    double length = 0, chord = 0;
    int i, k, lines = 0, positions = 0;
    for (i = 0; i < j->n; ++i) {
        length += j->pass[i].length;
        for (k = 0; k < j->pass[i].n; ++k) {
            chord = fmax(chord, j->pass[i].chord[k]);
        }
        lines += j->pass[i].lines;
        positions += j->pass[i].n;
    }
    printf(
        "%s: %d passes, %d lines, %d positions, %.6g long; proven: scallops below %.4g, chords within %.4g\n",
        name, j->n, lines, positions, length, j->scallop, chord);
}

static void write_table(FILE *file, const job *j, const char *name) {
    int i, k, line = 0;
    for (i = 0; i < j->n; ++i) {
        const pass *a = &j->pass[i];
        for (k = 0; k < a->n; ++k) {
            const double *at = a->centre[k];
            line += a->begins[k];
            fprintf(file, "%s,%d,%d,%.12g,%.12g,%.12g,%.6g,%.6g\n", name, i + 1, line, at[0], at[1], at[2],
                    a->chord[k], a->scallop);
        }
    }
}

/* Every third position of a pass, as it touches the face. */
static void draw_pass(gallery *picture, const pass *a, double scale) {
    double way[6];
    int k, c;
    for (k = 3; k < a->n; k += 3) {
        if (a->begins[k] || a->begins[k - 1] || a->begins[k - 2]) {
            continue;
        }
        for (c = 0; c < 3; ++c) {
            way[c] = scale * a->contact[k - 3][c];
            way[3 + c] = scale * a->contact[k][c];
        }
        add_line(picture, "frame", way, 2, 3);
    }
}

/* What is drawn is about as large as the other pictures, so that lines are in front. */
static void draw(gallery *picture, const part *p, const job *j, const char *label) {
    double matrix[9] = {0}, scale = 0;
    nurbs *shown;
    int i;
    for (i = 0; i < 3; ++i) {
        scale = fmax(scale, p->upper[i] - p->lower[i]);
    }
    scale = 4 / scale;
    matrix[0] = matrix[4] = matrix[8] = scale;
    check(nurbs_transform(p->surface, 3, matrix, NULL, &shown));
    add_surface(picture, shown, 32, 32, p->outside > 0 ? OPEN : TURNED);
    nurbs_destroy(shown);
    for (i = 0; i < j->n; ++i) {
        draw_pass(picture, &j->pass[i], scale);
    }
    end_cell(picture, label);
}

static void finish(FILE *table, gallery *picture, const part *p, job *j, const char *name,
                   const char *label) {
    int i;
    tell(j, name);
    write_table(table, j, name);
    draw(picture, p, j, label);
    for (i = 0; i < j->n; ++i) {
        free_pass(&j->pass[i]);
    }
    free(j->pass);
}

static void check_hollows(const part *p, const tool *t) {
    double where[3] = {0, 0, 0};
    const double hollow = smallest_hollow(p, where);
    if (hollow < t->radius) {
        REFUSE("a ball of radius %g gouges: the face is hollow with radius %.4g at (%g, %g, %g)", t->radius,
               hollow, where[0], where[1], where[2]);
    }
}

static void make_all(part *p, const tool *t, FILE *table, gallery *picture) {
    const int axis = longest_axis(p);
    double normal[3] = {0, 0, 0};
    nurbs *height, *border;
    job j;
    normal[axis] = 1;
    check(nurbs_transform(p->surface, 1, normal, NULL, &height));
    j = make_job(p, t, height, normal);
    finish(table, picture, p, &j, "planes", "parallel passes");
    nurbs_destroy(height);
    border = border_distance(p);
    if (border != NULL) {
        j = make_job(p, t, border, NULL);
        finish(table, picture, p, &j, "border", "passes along the border");
        nurbs_destroy(border);
    }
}

/* A positive number, or the end. */
static double number(const char *text) {
    char *end;
    const double x = strtod(text, &end);
    if (*end != '\0' || end == text || !(x > 0 && x < INFINITY)) {
        REFUSE("%s is no positive number", text);
    }
    return x;
}

/* The index of a face that is counted from 1. */
static int64_t face_index(const char *text) {
    const double x = number(text);
    if (x != floor(x) || x > 1e9) {
        REFUSE("%s is no number of a face", text);
    }
    return (int64_t)x - 1;
}

int main(int argc, char **argv) {
    static gallery picture;
    tool t = {4, 0.2, 0.04};
    part p;
    FILE *table;
    if (argc != 3 && argc != 6 && argc != 8) {
        fprintf(stderr, "usage: toolpath TABLE.csv PICTURE.svg [RADIUS SCALLOP CHORD [FILE FACE]]\n");
        return 2;
    }
    if (argc > 3) {
        t.radius = number(argv[3]);
        t.scallop = number(argv[4]);
        t.chord = number(argv[5]);
        if (!(t.scallop < 0.5 * t.radius && t.chord < 0.5 * t.radius)) {
            REFUSE("scallops and chords have to be less than half of the radius");
        }
    }
    p = argc == 8 ? read_part(argv[6], face_index(argv[7])) : make_mould();
    check_hollows(&p, &t);
    table = fopen(argv[1], "w");
    if (table == NULL) {
        perror(argv[1]);
        return 1;
    }
    open_picture(&picture, argv[2], 2, 1);
    fputs("kind,pass,line,x,y,z,chord,scallop\n", table);
    make_all(&p, &t, table, &picture);
    close_picture(&picture);
    if (fclose(table) != 0) {
        perror(argv[1]);
        return 1;
    }
    free_part(&p);
    return 0;
}
