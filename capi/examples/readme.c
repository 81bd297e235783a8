#include <nurbs/nurbs.h>
#include <stdio.h>

/* A quarter of the unit circle: points, tangents, the same points after inserting a knot, and a mistake. */
int main(void) {
    const int32_t degree = 2;
    const int64_t count = 3;
    const double knots[] = {0, 0, 0, 1, 1, 1}, weights[] = {1, 0.70710678118654752, 1};
    const double points[] = {1, 0, 1, 1, 0, 1}, params[] = {0, 0.25, 0.5, 0.75, 1}, outside = 1.5;
    double derivs[5][2][2], after[5][2], none[2];
    char message[256];
    nurbs *arc = NULL, *finer = NULL;

    int ok = nurbs_create(1, &degree, &count, knots, 6, 2, points, 0, 0, weights, 0, 0, &arc) == NURBS_OK &&
             nurbs_eval_derivs(arc, 1, 5, params, 0, 0, derivs[0][0], 0, 0, 0) == NURBS_OK &&
             nurbs_insert_knot(arc, 0, 0.3, 1, &finer) == NURBS_OK &&
             nurbs_eval(finer, 5, params, 0, 0, after[0], 0, 0, 0) == NURBS_OK;
    for (int i = 0; ok && i < 5; ++i) {
        printf("C(%.2f) = (%.12f, %.12f), C' = (%.3f, %.3f), ", params[i], derivs[i][0][0], derivs[i][0][1],
               derivs[i][1][0], derivs[i][1][1]);
        printf("with a knot more (%.12f, %.12f)\n", after[i][0], after[i][1]);
    }
    if (ok && nurbs_eval(arc, 1, &outside, 0, 0, none, 0, 0, 0) != NURBS_OK) {
        nurbs_last_error(message, sizeof message);
        printf("a bad call says: %s\n", message);
    }
    nurbs_destroy(finer);
    nurbs_destroy(arc);
    return ok ? 0 : 1;
}
