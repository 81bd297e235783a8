/* SPDX-License-Identifier: MIT */
/* A circle is a rational curve: create it, evaluate a batch, insert a knot, and see that the radius did not
 * change.
 *     cc circle.c $(pkg-config --cflags --libs nurbs) -lm -o circle && ./circle */
#include <nurbs/nurbs.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { N = 1000 };

static void check(nurbs_status status) {
    char message[512];
    if (status != NURBS_OK) {
        nurbs_last_error(message, (int64_t)sizeof message);
        fprintf(stderr, "%s: %s\n", nurbs_status_name(status), message);
        exit(EXIT_FAILURE);
    }
}

/* The largest distance of N points of the curve from the unit circle. */
static double radius_error(const nurbs *curve) {
    static double params[N], points[N][2];
    double largest = 0;
    int i;
    for (i = 0; i < N; ++i) {
        params[i] = i / (N - 1.0);
    }
    check(nurbs_eval(curve, N, params, 0, 0, points[0], 0, 0, 0));
    for (i = 0; i < N; ++i) {
        largest = fmax(largest, fabs(hypot(points[i][0], points[i][1]) - 1));
    }
    return largest;
}

int main(void) {
    const double s = sqrt(0.5);
    const double points[9][2] = {{1, 0},   {1, 1},  {0, 1},  {-1, 1}, {-1, 0},
                                 {-1, -1}, {0, -1}, {1, -1}, {1, 0}};
    const double weights[9] = {1, s, 1, s, 1, s, 1, s, 1};
    const double knots[12] = {0, 0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1, 1};
    const int32_t degree = 2;
    const int64_t count = 9;
    nurbs *circle, *finer;
    int64_t finer_count;

    check(nurbs_create(1, &degree, &count, knots, 12, 2, points[0], 0, 0, weights, 0, 0, &circle));
    check(nurbs_insert_knot(circle, 0, 0.3, 2, &finer));
    check(nurbs_count(finer, 0, &finer_count));
    printf("%lld control points, radius 1 to within %.2g\n", (long long)count, radius_error(circle));
    printf("%lld control points, radius 1 to within %.2g\n", (long long)finer_count, radius_error(finer));
    nurbs_destroy(finer);
    nurbs_destroy(circle);
    return 0;
}
