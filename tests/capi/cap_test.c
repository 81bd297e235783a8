/* SPDX-License-Identifier: MIT */
/* Arrays that are said to be as long as can be: what is beyond the answer is not looked at. */
#include "shapes.h"

#define VALUES(...) ((const double[]){__VA_ARGS__})

enum { room = 4096 };
static const int64_t most = INT64_MAX;
static double a[room], b[room], c[room], d[room];
static int32_t i[room], j[room], k[room];
static int64_t m[room], n[room];

static void lists(const nurbs *g) {
    int64_t count = -1;
    CHECK_OK(nurbs_distinct_knots(g, 0, most, a, i, &count));
    CHECK(count == 2);
    CHECK_OK(nurbs_to_power(g, most, a, b, m, &count));
    CHECK(count == 8);
    CHECK_OK(nurbs_to_hermite(g, most, a, b, c, &count));
    CHECK(count == 2);
    CHECK_OK(nurbs_continuity(g, 0, 0, 0, 0, most, a, i, j, k, b, c, d, &count));
    CHECK(count == 0);
    CHECK_OK(nurbs_bezier_extraction(g, 0, most, a, m, b, &count));
    CHECK(count == 1);
    CHECK_OK(nurbs_bezier_pieces(g, most, a, b, c, m, &count));
    CHECK(count == 1);
}

static void matrices(const nurbs *g) {
    int64_t count = -1;
    CHECK_OK(nurbs_refinement_matrix(g, 0, 1, VALUES(0.5), most, a, m, n, &count));
    CHECK(count > 0 && count <= 20);
    const SplineArgs args = arch();
    CHECK_OK(nurbs_collocation(1, args.degrees, args.counts, args.knots, 8, NULL, 1, VALUES(0.5), 0, 0, most,
                               a, m, n, &count, 0));
    CHECK(count == 4);
    CHECK_OK(nurbs_rational_collocation(g, NULL, 1, VALUES(0.5), 0, 0, most, a, m, n, &count, 0));
    CHECK(count == 4);
}

static void queries(const nurbs *g) {
    int64_t count = -1;
    int32_t status = 0;
    CHECK_OK(nurbs_curve_features(g, NURBS_FEATURE_CURVATURE_MAXIMUM, most, a, i, b, &count, &status));
    CHECK(count == 1); /* in the middle */
    CHECK_OK(nurbs_curve_monotone_pieces(g, VALUES(1, 0), most, a, i, &count, &status));
    CHECK(count == 1);
    CHECK_OK(nurbs_singular_points(g, 1e-6, most, a, b, &count, &status));
    CHECK(count == 0);
    CHECK_OK(nurbs_closest_all(g, VALUES(0.5, 9), NULL, 1e-9, 0, most, a, b, &count, &status));
    CHECK(count >= 1 && count < 10);
    CHECK_OK(nurbs_critical_points(g, VALUES(0.5, 9), NULL, 1e-9, 0, most, a, b, i, &count, &status));
    CHECK(count >= 1 && count < 10);
}

/* Outputs are still kept apart, as far as they are written. */
static void overlaps(const nurbs *g) {
    int64_t count = -1;
    CHECK_FAILS(nurbs_to_hermite(g, most, a, a + 1, c, &count), NURBS_ERROR_OVERLAP, "params|points");
    CHECK_FAILS(nurbs_curve_monotone_pieces(g, VALUES(1, 0), most, a, (int32_t *)a, &count, NULL),
                NURBS_ERROR_OVERLAP, "starts|signs");
    CHECK_FAILS(nurbs_closest_all(g, VALUES(0.5, 9), NULL, 1e-9, 0, most, a, a, &count, NULL),
                NURBS_ERROR_OVERLAP, "params|distances");
    CHECK(count == -1);
}

int main(void) {
    nurbs *g = make(arch());
    lists(g);
    matrices(g);
    queries(g);
    overlaps(g);
    nurbs_destroy(g);
    return check_summary("cap");
}
