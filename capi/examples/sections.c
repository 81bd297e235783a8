/* SPDX-License-Identifier: MIT */
/* The lines of a ship's hull: cut by planes into waterlines and frames, with the areas inside; and the outlines, isophotes
 * and parabolic curves of a torus. Draws sections.svg, or the file that is named.
 * Compile: cc -std=c99 sections.c $(pkg-config --cflags --libs nurbs) -lm -o sections */
#include "gallery/hull.h"

enum { PLANES = 8, SAMPLES = 121 };

static const double along[3] = {0, 1, 0}, up[3] = {0, 0, 1};

/* Heights of waterlines, from above the keel to below the deck; and places of frames, from the stern to the bow. */
static void places(double lower, double upper, int n, double *at) {
    int i;
    for (i = 0; i < n; ++i) {
        at[i] = lower + (upper - lower) * (i + 0.5) / n;
    }
}

static nurbs_meet *sections(const nurbs *g, const double *normal, int n, const double *at) {
    nurbs_meet *meet;
    int32_t complete;
    check(nurbs_surface_sections(g, normal, n, at, 1e-4, &meet));
    check(nurbs_meet_counts(meet, NULL, NULL, &complete));
    if (!complete) {
        fprintf(stderr, "sections: there may be more\n");
    }
    return meet;
}

static int64_t branches_of(const nurbs_meet *meet) {
    int64_t count;
    check(nurbs_meet_counts(meet, &count, NULL, NULL));
    return count;
}

/* Points [SAMPLES][3] along a branch. */
static void sample_branch(const nurbs_meet *meet, int64_t i, double *points) {
    double domain[2], params[SAMPLES];
    nurbs *curve, *on_surface;
    int k;
    check(nurbs_meet_branch(meet, i, &curve, &on_surface));
    check(nurbs_domain(curve, 0, domain));
    for (k = 0; k < SAMPLES; ++k) {
        const double t = (double)k / (SAMPLES - 1);
        params[k] = k + 1 == SAMPLES ? domain[1] : (1 - t) * domain[0] + t * domain[1];
    }
    check(nurbs_eval(curve, SAMPLES, params, 0, 0, points, 0, 0, 0));
    nurbs_destroy(on_surface);
    nurbs_destroy(curve);
}

static void add_branches(gallery *picture, const nurbs_meet *meet, const char *style) {
    double points[3 * SAMPLES];
    int64_t i;
    for (i = 0; i < branches_of(meet); ++i) {
        sample_branch(meet, i, points);
        add_line(picture, style, points, SAMPLES, 3);
    }
}

/* Both sides of the hull, seen along an axis; frames before the middle are on the right alone, those behind it on the left. */
static void add_plan(gallery *picture, const nurbs_meet *meet, int side, int top, int frames,
                     const char *style) {
    double points[3 * SAMPLES], flat[2 * SAMPLES];
    int64_t i;
    int hand, k;
    for (i = 0; i < branches_of(meet); ++i) {
        sample_branch(meet, i, points);
        for (hand = -1; hand <= 1; hand += 2) {
            if (frames && hand != (points[1] > 0 ? 1 : -1)) {
                continue;
            }
            for (k = 0; k < SAMPLES; ++k) {
                flat[2 * k] = (top == 0 ? 1 : hand) * points[3 * k + side];
                flat[2 * k + 1] = (top == 0 ? hand : 1) * points[3 * k + top];
            }
            add_line(picture, style, flat, SAMPLES, 2);
        }
    }
}

/* Twice the integral of x dy: of both sides of the hull. */
static double area_of(const nurbs_meet *meet, int64_t branch, int along_axis) {
    double points[3 * SAMPLES], sum = 0;
    int k;
    sample_branch(meet, branch, points);
    for (k = 0; k + 1 < SAMPLES; ++k) {
        const double *a = points + 3 * k, *b = a + 3;
        sum += (a[0] + b[0]) * (b[along_axis] - a[along_axis]);
    }
    return fabs(sum);
}

static void tell_areas(const nurbs_meet *meet, const double *at, int along_axis, const char *name) {
    int64_t levels[PLANES], i;
    check(nurbs_meet_branches(meet, PLANES, levels, NULL, NULL, NULL, NULL));
    for (i = 0; i < branches_of(meet); ++i) {
        printf("%s at %6.3f: area %.4f\n", name, at[levels[i]], area_of(meet, i, along_axis));
    }
}

static void draw_hull(gallery *picture) {
    double heights[PLANES], stations[PLANES];
    nurbs *hull = make_hull();
    nurbs_meet *waterlines, *frames;
    places(-1.1, 0.9, PLANES, heights);
    places(-4, 4, PLANES, stations);
    waterlines = sections(hull, up, PLANES, heights);
    frames = sections(hull, along, PLANES, stations);
    tell_areas(waterlines, heights, 1, "waterplane");
    tell_areas(frames, stations, 2, "frame");
    add_surface(picture, hull, 32, 20, OPEN | TURNED);
    add_branches(picture, waterlines, "water");
    add_branches(picture, frames, "frame");
    end_cell(picture, "waterlines and frames");
    add_plan(picture, frames, 0, 2, 1, "frame");
    end_cell(picture, "the body plan");
    add_plan(picture, waterlines, 1, 0, 0, "water");
    end_cell(picture, "the waterplanes");
    nurbs_meet_destroy(frames);
    nurbs_meet_destroy(waterlines);
    nurbs_destroy(hull);
}

static void draw_torus(gallery *picture) {
    static const double cosines[] = {0.9, 0.6, 0.3}, light[] = {0.468, -0.234, 0.852};
    const double turn = 6.283185307179586;
    nurbs *torus;
    nurbs_meet *meet;
    check(nurbs_surface_torus(NULL, NULL, NULL, 2, 0.8, 0, turn, 0, turn, NURBS_ARC_QUARTERS, &torus));
    add_surface(picture, torus, 40, 20, 0);
    check(nurbs_surface_contours(torus, NURBS_CONTOUR_ISOPHOTE, light, 3, cosines, 1e-3, &meet));
    add_branches(picture, meet, "frame");
    nurbs_meet_destroy(meet);
    check(nurbs_surface_contours(torus, NURBS_CONTOUR_SILHOUETTE, to_eye, 0, NULL, 1e-3, &meet));
    add_branches(picture, meet, "curve");
    nurbs_meet_destroy(meet);
    end_cell(picture, "outline and isophotes");
    nurbs_destroy(torus);
}

int main(int argc, char **argv) {
    static gallery picture;
    if (argc > 2) {
        fprintf(stderr, "usage: sections [PICTURE.svg]\n");
        return 2;
    }
    open_picture(&picture, argc > 1 ? argv[1] : "sections.svg", 4, 1);
    draw_hull(&picture);
    draw_torus(&picture);
    close_picture(&picture);
    return 0;
}
