/* SPDX-License-Identifier: MIT */
/* Pulls one side of a ship's hull through three given points, with the smallest change of its control points
 * that leaves the edges where they are, and draws it before and after: hull.svg, or the file that is named.
 * Compile: cc -std=c99 hull.c $(pkg-config --cflags --libs nurbs) -lm -o hull */
#include "gallery/hull.h"

enum { POINTS = 3 };

/* Where on the hull, and what shall be there: room for a sonar in the bow, for a hold amidships, and a
 * narrower stern. */
static const double params[2 * POINTS] = {0.15, 0.35, 0.5, 0.4, 0.85, 0.45};
static const double targets[3 * POINTS] = {0.75, 2.9, -0.8, 1.6, 0, -0.7, 0.45, -3.0, -0.45};

static nurbs *pulled(const nurbs *hull) {
    static const int32_t edges_stay[4] = {0, 0, 0, 0};
    double residuals[POINTS], moved, missed = 0;
    int64_t rank;
    nurbs *result;
    int i;
    check(nurbs_constrain(hull, POINTS, NULL, NULL, params, targets, edges_stay, NULL, NULL, 0, residuals,
                          &rank, &moved, NULL, &result));
    for (i = 0; i < POINTS; ++i) {
        missed = fmax(missed, residuals[i]);
    }
    printf("%d points, %d equations: missed by at most %.1e, control points moved by up to %.2f\n", POINTS,
           (int)rank, missed, moved);
    return result;
}

/* The hull with its edges, the given points, and lines to them from where they belong. */
static void draw(gallery *picture, const nurbs *hull, const char *label) {
    double at[3 * POINTS], line[6];
    int i, k;
    check(nurbs_eval(hull, POINTS, params, 0, 0, at, 0, 0, 0));
    add_surface(picture, hull, 32, 20, OPEN | TURNED);
    add_edges(picture, hull);
    for (i = 0; i < POINTS; ++i) {
        for (k = 0; k < 3; ++k) {
            line[k] = at[3 * i + k];
            line[3 + k] = targets[3 * i + k];
        }
        add_line(picture, "tangent", line, 2, 3);
    }
    add_dots(picture, "given", targets, POINTS, 3);
    end_cell(picture, label);
}

int main(int argc, char **argv) {
    static gallery picture;
    nurbs *hull = make_hull(), *changed = pulled(hull);
    if (argc > 2) {
        fprintf(stderr, "usage: hull [PICTURE.svg]\n");
        return 2;
    }
    open_picture(&picture, argc == 2 ? argv[1] : "hull.svg", 2, 1);
    draw(&picture, hull, "three points given");
    draw(&picture, changed, "edges kept");
    close_picture(&picture);
    nurbs_destroy(hull);
    nurbs_destroy(changed);
    return 0;
}
