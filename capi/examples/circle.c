/* SPDX-License-Identifier: MIT */
/* A circle is a rational curve: its points and tangents, a knot more, the point that is closest to another,
 * its length, and what a bad call says. A call returns 0 or what is wrong, so that || stops at the first
 * failure.
 *     cc circle.c $(pkg-config --cflags --libs nurbs) -lm -o circle && ./circle */
#include <math.h>
#include <nurbs/nurbs.h>
#include <stdio.h>

int main(void) {
    static double t[1000], c[1000][2][2], after[1000][2]; /* parameters; points, derivatives; points again */
    double query[2] = {3, 4}, outside = 2, radius[2] = {0}, slant = 0, moved = 0, at[2], gap, length, error;
    int64_t counts[2];
    int32_t found;
    char message[256];
    nurbs *circle = NULL, *finer = NULL;
    for (int i = 0; i < 1000; ++i)
        t[i] = i / 999.0;
    if (nurbs_curve_circle(2, 0, 0, 0, 1, NURBS_ARC_QUARTERS, &circle) ||
        nurbs_eval_derivs(circle, 1, 1000, t, 0, 0, c[0][0], 0, 0, 0) || nurbs_count(circle, 0, &counts[0]) ||
        nurbs_insert_knot(circle, 0, 0.3, 2, &finer) || nurbs_count(finer, 0, &counts[1]) ||
        nurbs_eval(finer, 1000, t, 0, 0, after[0], 0, 0, 0) ||
        nurbs_curve_length(circle, 0, 0, &length, &error) ||
        nurbs_closest_points(circle, 1, query, 0, 0, 0, 0, 0, 0, 0, 0, at, 0, 0, &gap, 0, &found, 0))
        return 1;
    for (int i = 0; i < 1000; ++i) {
        radius[0] = fmax(radius[0], fabs(hypot(c[i][0][0], c[i][0][1]) - 1));
        radius[1] = fmax(radius[1], fabs(hypot(after[i][0], after[i][1]) - 1));
        slant = fmax(slant, fabs(c[i][0][0] * c[i][1][0] + c[i][0][1] * c[i][1][1]));
        moved = fmax(moved, fmax(fabs(after[i][0] - c[i][0][0]), fabs(after[i][1] - c[i][0][1])));
    }
    printf("%d control points, radius 1 to within %.2g\n", (int)counts[0], radius[0]);
    printf("tangents at right angles to within %.2g\n", slant);
    printf("%d control points, radius 1 to within %.2g\n", (int)counts[1], radius[1]);
    printf("the points moved by at most %.2g\n", moved);
    printf("closest to (3, 4): (%.6f, %.6f), distance %.6f, %s\n", at[0], at[1], gap,
           found & NURBS_CLOSEST_CERTIFIED ? "certified" : "not certified");
    printf("length %.12f, error about %.2g\n", length, error);
    (void)nurbs_eval(circle, 1, &outside, 0, 0, at, 0, 0, 0); /* a bad call */
    (void)nurbs_last_error(message, sizeof message);
    printf("a bad call says: %s\n", message);
    nurbs_destroy(finer);
    nurbs_destroy(circle);
    return 0;
}
