/* SPDX-License-Identifier: MIT */
/* nurbs_eval(): known points, exact ends, one point alone and in a batch. */
#include "batch.h"
#include "check.h"
#include "shapes.h"

static void values_at(SplineArgs a, int64_t n, const double *params, uint32_t flags, const double *expected,
                      double bound) {
    double points[64];
    nurbs *g = make(a);
    FILL(points);
    CHECK_OK(nurbs_eval(g, n, params, 0, 0, points, 0, 0, flags));
    CHECK_NEAR(points, expected, n * a.dim, bound);
    check_untouched(__FILE__, __LINE__, points + n * a.dim,
                    sizeof points - (size_t)(n * a.dim) * sizeof *points);
    nurbs_destroy(g);
}

#define VALUES(...) ((const double[]){__VA_ARGS__})

/* Bounds are c(p) eps hull; where all intermediate numbers are short, the values are exact. */
static void known_points(void) {
    values_at(arch(), 3, VALUES(0, 0.5, 1), 0, VALUES(0, 0, 2, 1.5, 4, 0), 0);
    values_at(arch(), 1, VALUES(0.25), 0, VALUES(0.90625, 1.125), 4 * 0x1p-52 * 4);
    values_at(hill(), 5, VALUES(2, 3, 4, 5, 3.5), 0, VALUES(1, 3, 3, 1, 3.5), 0);
    values_at(loop(), 3, VALUES(2, 3, 6), 0, VALUES(0, 1, -1, 0, 0, 1), 0);
    values_at(jump(), 4, VALUES(0.5, 1, 1.25, 2), 0, VALUES(0.5, 5, 5.25, 6), 0);
    values_at(jump(), 4, VALUES(0.5, 1, 1.25, 2), NURBS_LEFT, VALUES(0.5, 1, 5.25, 6), 0);
    values_at(stairs(), 4, VALUES(0, 1, 2, 3), 0, VALUES(10, 20, 30, 30), 0);
    values_at(stairs(), 4, VALUES(0, 1, 2, 3), NURBS_LEFT, VALUES(10, 10, 20, 30), 0);
    values_at(patch(), 2, VALUES(0.5, 0.25, 1, 0.75), 0, VALUES(0.5, 0.25, 0.125, 1, 0.75, 0.75), 0);
    values_at(trough(), 2, VALUES(0.5, 1.5, 0.25, 3), 0, VALUES(0.5, 1.5, 1.75, 0.25, 3, 3.0625), 0);
    values_at(cube(), 1, VALUES(0.5, 0.25, 0.75), 0, VALUES(0.5, 0.25, 0.75, 0.09375), 0);
}

/* Every point of the circle has radius 1 to 4 eps. */
static void on_the_circle(void) {
    nurbs *g = make(circle());
    for (int i = 0; i <= 1000; ++i) {
        double t = i / 1000.0, p[2] = {0, 0};
        CHECK_OK(nurbs_eval(g, 1, &t, 0, 0, p, 0, 0, 0));
        CHECK(fabs(hypot(p[0], p[1]) - 1) <= 4 * 0x1p-52);
    }
    nurbs_destroy(g);
}

/* Clamped ends, and places where one basis function is 1, give the stored point with the stored bits. */
static void exact_places(void) {
    static const double points[] = {0.1, -0.0, 0.2, 0.3, 1.0 / 3, 1e-300, 0.7, 9, -0.0, 0.3,
                                    3,   1,    4,   1,   5e-324,  0.9,    2,   6, 0.1,  1e300};
    static const double weights[] = {0.3, 0.7, 0.1, 0.9, 1e-6, 1e6, 0.3, 0.2, 0.7};
    static const double params[] = {0, 0.25, 0.5, 0.75, 1};
    double values[10];
    SplineArgs a = circle();
    a.points = points;
    for (int rational = 0; rational < 2; ++rational) {
        for (uint32_t side = 0; side <= NURBS_LEFT; ++side) {
            a.weights = rational ? weights : NULL;
            nurbs *g = make(a);
            CHECK_OK(nurbs_eval(g, 5, params, 0, 0, values, 0, 0, side));
            for (int i = 0; i < 5; ++i) {
                CHECK_BITS(values + 2 * i, points + 4 * i, 2 * sizeof *values);
            }
            nurbs_destroy(g);
        }
    }
}

/* One point has the same bits alone, in a batch, in reverse order and in another layout. */
static void same_bits(SplineArgs a) {
    enum { n = 257 };
    static double params[3 * n], backwards[3 * n], batch[4 * n], reversed[4 * n], transposed[4 * n], one[4];
    nurbs *g = make(a);
    double domain[3][2];
    for (int32_t k = 0; k < a.axes; ++k) {
        CHECK_OK(nurbs_domain(g, k, domain[k]));
    }
    for (int i = 0; i < n; ++i) {
        for (int k = 0; k < a.axes; ++k) {
            double s = fmod(0.6180339887498949 * (i + 1) * (k + 1), 1.0);
            params[a.axes * i + k] = domain[k][0] + s * (domain[k][1] - domain[k][0]);
            backwards[a.axes * (n - 1 - i) + k] = params[a.axes * i + k];
        }
    }
    CHECK_OK(nurbs_eval(g, n, params, 0, 0, batch, 0, 0, 0));
    CHECK_OK(nurbs_eval(g, n, backwards, 0, 0, reversed, 0, 0, 0));
    CHECK_OK(nurbs_eval(g, n, params, 0, 0, transposed, 1, n, 0));
    for (int i = 0; i < n; ++i) {
        CHECK_OK(nurbs_eval(g, 1, params + a.axes * i, 0, 0, one, 0, 0, 0));
        CHECK_BITS(one, batch + a.dim * i, (size_t)a.dim * sizeof *one);
        CHECK_BITS(one, reversed + a.dim * (n - 1 - i), (size_t)a.dim * sizeof *one);
        for (int c = 0; c < a.dim; ++c) {
            CHECK_BITS(one + c, transposed + n * c + i, sizeof *one);
        }
    }
    nurbs_destroy(g);
}

/* A bad parameter anywhere in a long batch is named, and nothing is written. */
static void last_of_many(void) {
    static double params[1000], points[2000];
    nurbs *g = make(arch());
    for (int i = 0; i < 1000; ++i) {
        params[i] = i / 1000.0;
    }
    params[777] = 1.25;
    FILL(points);
    CHECK_FAILS(nurbs_eval(g, 1000, params, 0, 0, points, 0, 0, 0), NURBS_ERROR_OUTSIDE_DOMAIN,
                "params[777|1.25|0|1");
    CHECK_UNTOUCHED(points);
    nurbs_destroy(g);
}

int main(void) {
    nurbs *curve = make(arch()), *ring = make(circle()), *surface = make(patch()), *volume = make(cube());
    const SplineArgs shapes[] = {arch(),   circle(), hill(),   loop(), jump(),
                                 stairs(), patch(),  trough(), cube()};
    BatchCase cases[] = {{nurbs_eval, curve, 1, 2, "points", "point", 1, 1, 1, 1},
                         {nurbs_eval, ring, 1, 2, "points", "point", 1, 1, 1, 1},
                         {nurbs_eval, surface, 2, 3, "points", "point", 1, 1, 1, 1},
                         {nurbs_eval, volume, 3, 4, "points", "point", 1, 1, 1, 1}};
    known_points();
    on_the_circle();
    exact_places();
    for (int i = 0; i < 9; ++i) {
        same_bits(shapes[i]);
    }
    last_of_many();
    for (int i = 0; i < 4; ++i) {
        batch_checks(cases + i);
    }
    nurbs_destroy(curve);
    nurbs_destroy(ring);
    nurbs_destroy(surface);
    nurbs_destroy(volume);
    return check_summary("eval");
}
