/* A program that uses the installed library: header, linking, values and messages have to fit together. */
#include <nurbs/nurbs.h>
#include <stdio.h>
#include <string.h>

static int expect(int condition, const char *what) {
    if (!condition) {
        char message[256];
        nurbs_last_error(message, sizeof message);
        fprintf(stderr, "%s (last error: %s)\n", what, message);
    }
    return condition;
}

int main(void) {
    const int32_t degree = 2;
    const double points[] = {0, 0, 1, 2, 2, 0};
    const double params[] = {0, 0.5, 1};
    const double outside = 2;
    const double expected[] = {0, 0, 1, 1, 2, 0};
    double values[6];
    nurbs *parabola;
    int ok = expect(nurbs_version() == NURBS_VERSION, "the header and the library have different versions");
    ok &=
        expect(nurbs_create_bezier(1, &degree, 2, points, 0, 0, NULL, 0, &parabola) == NURBS_OK, "no curve");
    ok &= expect(nurbs_eval(parabola, 3, params, 0, 0, values, 0, 0, 0) == NURBS_OK, "no points");
    ok &= expect(memcmp(values, expected, sizeof values) == 0, "wrong points");
    ok &= expect(nurbs_eval(parabola, 1, &outside, 0, 0, values, 0, 0, 0) == NURBS_ERROR_OUTSIDE_DOMAIN,
                 "a parameter outside the domain is accepted");
    nurbs_destroy(parabola);
    printf("libnurbs %d: %s\n", (int)nurbs_version(), ok ? "works" : "does not work");
    return ok ? 0 : 1;
}
