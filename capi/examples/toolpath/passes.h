/* SPDX-License-Identifier: MIT */
/* Passes of a ball over a part for toolpath.c: from curves on its surface to positions of the centre, and how far the ball is
 * from touching the part between two of these, with proof. */
#ifndef TOOLPATH_PASSES_H
#define TOOLPATH_PASSES_H

#include "part.h"

/* The way of the centre along one level: position k goes straight to k + 1, unless a line begins there. */
typedef struct pass {
    double level, length;
    int n, lines;
    double (*centre)[3], (*contact)[3];
    char *begins;
    double *
        chord; /* of the segment that ends in a position: no point of the part is nearer to the centre than the radius less
                     * the chord, and the nearest one no farther than the radius and the chord */
    double scallop; /* no scallop between the pass before and this one is higher */
} pass;

static inline double distance(const double *a, const double *b) {
    const double d[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    return sqrt(dot(d, d));
}

/* Of a point from a segment. */
static inline double to_segment(const double *p, const double *a, const double *b) {
    const double along[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    const double from[3] = {p[0] - a[0], p[1] - a[1], p[2] - a[2]};
    const double square = dot(along, along), t = square > 0 ? fmin(1, fmax(0, dot(from, along) / square)) : 0;
    const double foot[3] = {a[0] + t * along[0], a[1] + t * along[1], a[2] + t * along[2]};
    return distance(p, foot);
}

static inline void free_pass(pass *p) {
    free(p->centre);
    free(p->contact);
    free(p->begins);
    free(p->chord);
}

/* What rounding may do to lengths: some hundred units of the largest coordinates, as the control points of a part of a surface,
 * and distances from them, have. */
static inline double rounding_of(const part *p, const tool *t) {
    return 1e-13 * (p->hull + t->radius);
}

/* How far a ball that goes straight from position i - 1 to i is from touching the part. For a point P, |P - C|^2 along a segment of
 * centres from A to B is (1 - t) |P - A|^2 + t |P - B|^2 - t (1 - t) |B - A|^2. So if no point of the part is nearer than d to A and
 * to B, none is nearer than sqrt(d^2 - |B - A|^2 / 4) to a centre between them. And as that is convex in t, the point where the ball
 * touches at A is not farther from the first half of the segment than from its ends; so is that at B from the other half. */
static inline double chord_of(const double (*contact)[3], const double (*centre)[3], double d,
                              double radius) {
    const double *a = centre[-1], *b = centre[0];
    const double middle[3] = {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2])};
    const double step = distance(a, b), least = d * d - step * step / 4;
    const double most = fmax(distance(contact[-1], middle), distance(contact[0], middle));
    return fmax(radius - (least > 0 ? sqrt(least) : 0), most - radius);
}

/* Centres of balls that touch the surface at n places, equally spaced along a curve in the domain; the largest of the chords, if
 * nothing else is near. */
static inline double place_balls(const part *p, const tool *t, const nurbs *curve, int n,
                                 double (*contact)[3], double (*centre)[3]) {
    double domain[2], *at = room(NULL, (size_t)n * 3 * sizeof *at),
                      (*params)[2] = room(NULL, (size_t)n * sizeof *params);
    double(*normals)[3] = room(NULL, (size_t)n * sizeof *normals), largest = 0, sum = 0;
    int i, k;
    check(nurbs_domain(curve, 0, domain));
    for (i = 0; i < n; ++i) {
        at[i] = between(domain[0], domain[1], i, n - 1);
    }
    check(nurbs_eval(curve, n, at, 0, 0, params[0], 0, 0, 0));
    check(nurbs_surface_eval_frames(p->surface, n, params[0], 0, 0, contact[0], 0, 0, NULL, 0, 0, NULL, 0, 0,
                                    normals[0], 0, 0, NULL, NURBS_CLAMP | NURBS_CLAMP << 8));
    for (i = 0; i < n; ++i) {
        for (k = 0; k < 3; ++k) {
            centre[i][k] = contact[i][k] + p->outside * t->radius * normals[i][k];
            sum += centre[i][k];
        }
        if (i > 0) {
            largest = fmax(largest, chord_of((const double(*)[3])contact + i, (const double(*)[3])centre + i,
                                             t->radius, t->radius));
        }
    }
    free(normals);
    free(params);
    free(at);
    return isfinite(sum) ? largest : NAN; /* a normal may be missing */
}

/* Adds a line of a pass: as many positions as the chords take. */
static inline void add_line_of(pass *to, const part *p, const tool *t, const nurbs *curve) {
    const double limit = 0.8 * t->chord;
    double domain[2], largest;
    int n;
    check(nurbs_domain(curve, 0, domain)); /* about the length */
    n = 2 + (int)fmin(1e6, (domain[1] - domain[0]) / sqrt(8 * t->radius * limit));
    for (;;) {
        const size_t size = (size_t)(to->n + n) * sizeof *to->centre;
        to->centre = room(to->centre, size);
        to->contact = room(to->contact, size);
        largest = place_balls(p, t, curve, n, to->contact + to->n, to->centre + to->n);
        if (isnan(largest) || n > 1000000) {
            REFUSE("the surface has no normal somewhere along a path");
        }
        if (largest <= limit) {
            break;
        }
        n = 2 + (int)(n * 1.05 * sqrt(largest / limit));
    }
    to->begins = room(to->begins, (size_t)(to->n + n));
    memset(to->begins + to->n, 0, (size_t)n);
    to->begins[to->n] = 1;
    to->n += n;
    ++to->lines;
}

/* The chord at position i, whose centre is at least d from the part, as is the one before. */
static inline double chord_at(const pass *a, int i, double d, const tool *t) {
    const double chord = a->begins[i] ? t->radius - d
                                      : chord_of((const double(*)[3])a->contact + i,
                                                 (const double(*)[3])a->centre + i, d, t->radius);
    const double *at = a->contact[i];
    if (chord > t->chord) {
        REFUSE("a ball of radius %g gouges: where it touches (%g, %g, %g), it may cut %.3g deep", t->radius,
               at[0], at[1], at[2], chord);
    }
    return chord;
}

/* Lengths and chords of all segments, by distances of the centres from the whole face, which are proven. */
static inline void measure_pass(pass *a, const part *p, const tool *t) {
    double *far = room(NULL, (size_t)(a->n + 1) * sizeof *far);
    int32_t *status = room(NULL, (size_t)(a->n + 1) * sizeof *status);
    const double tolerance = 0.02 * t->chord, rounding = rounding_of(p, t);
    int i;
    a->chord = room(NULL, (size_t)(a->n + 1) * sizeof *a->chord);
    check(nurbs_face_closest_points(p->face, a->n, a->centre[0], 0, 0, tolerance, NULL, NULL, far, status));
    for (i = 0; i < a->n; ++i) {
        const double least = a->begins[i] ? far[i] : fmin(far[i - 1], far[i]);
        if (!(status[i] & NURBS_CLOSEST_CERTIFIED)) {
            REFUSE("how near the face is to (%g, %g, %g) is not proven", a->centre[i][0], a->centre[i][1],
                   a->centre[i][2]);
        }
        a->chord[i] = chord_at(a, i, least - tolerance - rounding, t) + rounding;
        a->length += a->begins[i] ? 0 : distance(a->centre[i - 1], a->centre[i]);
    }
    free(status);
    free(far);
}

/* The pass along the curves of a meet, as far as they lie in the face; the meet goes. */
static inline pass make_pass(const part *p, const tool *t, double level, nurbs_meet *meet) {
    pass a = {0};
    nurbs_meet *inside;
    int64_t count, i;
    a.level = level;
    check(nurbs_meet_trim(meet, p->face, &inside));
    nurbs_meet_destroy(meet);
    check(nurbs_meet_counts(inside, &count, NULL, NULL));
    for (i = 0; i < count; ++i) {
        nurbs *space, *on_surface;
        check(nurbs_meet_branch(inside, i, &space, &on_surface));
        add_line_of(&a, p, t, on_surface);
        nurbs_destroy(on_surface);
        nurbs_destroy(space);
    }
    nurbs_meet_destroy(inside);
    if (a.n > 0) {
        measure_pass(&a, p, t);
    }
    return a;
}

#endif
