/* SPDX-License-Identifier: MIT */
/* Splines as cells: the order of VTK, points that cells have in common, what is refused, and what ends a long call. */
#include "shapes.h"

/* V = (x, y, z) of degrees 2, 2, 2 in one piece, with points 0, 1/2, 1 along each axis. */
static nurbs *a_smooth_cube(void) {
    static const int32_t degrees[] = {2, 2, 2};
    double points[27][3];
    for (int i = 0; i < 27; ++i) {
        points[i][0] = i / 9 / 2.0;
        points[i][1] = i / 3 % 3 / 2.0;
        points[i][2] = i % 3 / 2.0;
    }
    nurbs *g = NULL;
    CHECK_OK(nurbs_create_bezier(3, degrees, 3, points[0], 0, 0, NULL, 0, &g));
    return g;
}

/* Twice the places in the 27 points of the cell that VTK calls a triquadratic hexahedron, but for its sides, which Bezier
 * cells have axis by axis. */
static void order_of_a_volume(void) {
    static const double places[27][3] = {
        {0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2}, {0, 2, 2}, {1, 0, 0},
        {2, 1, 0}, {1, 2, 0}, {0, 1, 0}, {1, 0, 2}, {2, 1, 2}, {1, 2, 2}, {0, 1, 2}, {0, 0, 1}, {2, 0, 1},
        {2, 2, 1}, {0, 2, 1}, {0, 1, 1}, {2, 1, 1}, {1, 0, 1}, {1, 2, 1}, {1, 1, 0}, {1, 1, 2}, {1, 1, 1}};
    nurbs *g = a_smooth_cube();
    int64_t cell[27], points = 0, count = 0, same = 0;
    int32_t kind = 0;
    double x[27][3], w[27];
    CHECK_OK(nurbs_bezier_cells(g, 1, cell, &kind, &points, &count));
    CHECK_INT(count, 1);
    CHECK_INT(points, 27);
    CHECK_INT(kind, 79);
    CHECK_OK(nurbs_bezier_cell_points(g, 27, x[0], w, &same));
    CHECK_INT(same, 27);
    for (int i = 0; i < 27; ++i) {
        CHECK(cell[i] >= 0 && cell[i] < 27 && w[i] == 1);
        for (int k = 0; k < 3; ++k) {
            CHECK(2 * x[cell[i]][k] == places[i][k]);
        }
    }
    nurbs_destroy(g);
}

/* Degrees 3 and 2: 12 points. */
static void order_of_a_surface(void) {
    static const int32_t degrees[] = {3, 2};
    static const int64_t expected[] = {0, 9, 11, 2, 3, 6, 10, 5, 8, 1, 4, 7};
    static const double points[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
    nurbs *g = NULL;
    int64_t cell[12];
    int32_t kind = 0;
    CHECK_OK(nurbs_create_bezier(2, degrees, 1, points, 0, 0, NULL, 0, &g));
    CHECK_OK(nurbs_bezier_cells(g, 1, cell, &kind, NULL, NULL));
    CHECK_INT(kind, 77);
    for (int i = 0; i < 12; ++i) {
        CHECK_INT(cell[i], expected[i]);
    }
    nurbs_destroy(g);
}

/* A circle of four arcs closes: eight control points for twelve places, the last one being the first. */
static void a_circle(void) {
    static const int64_t expected[4][3] = {{0, 2, 1}, {2, 4, 3}, {4, 6, 5}, {6, 0, 7}};
    nurbs *g = NULL;
    int64_t cells[4][3], points = 0, count = 0;
    int32_t kind = 0;
    double x[8][2], w[8];
    CHECK_OK(nurbs_curve_circle(2, NULL, NULL, NULL, 1.0, NURBS_ARC_QUARTERS, &g));
    CHECK_OK(nurbs_bezier_cells(g, 4, cells[0], &kind, &points, &count));
    CHECK_INT(count, 4);
    CHECK_INT(kind, 75);
    CHECK_INT(points, 8);
    for (int i = 0; i < 12; ++i) {
        CHECK_INT(cells[i / 3][i % 3], expected[i / 3][i % 3]);
    }
    CHECK_OK(nurbs_bezier_cell_points(g, 8, x[0], w, NULL));
    for (int i = 0; i < 8; ++i) {
        CHECK(i % 2 == 0 ? w[i] == 1 : w[i] > 0.7 && w[i] < 0.71);
        CHECK(fabs(hypot(x[i][0], x[i][1]) - (i % 2 == 0 ? 1 : sqrt(2))) < 1e-15);
    }
    nurbs_destroy(g);
}

/* Two parts of a line with a gap, and a line without: they have no point, or one, in common. */
static void a_jump(void) {
    static const double points[] = {0, 1, 2, 3};
    static const struct {
        double knots[6];
        int64_t count, total;
    } lines[] = {{{0, 0, 1, 1, 2, 2}, 4, 4}, {{0, 0, 1, 2, 2}, 3, 3}};
    const int32_t degree = 1;
    for (int i = 0; i < 2; ++i) {
        nurbs *g = NULL;
        int64_t cells[2][2], total = 0;
        CHECK_OK(nurbs_create(1, &degree, &lines[i].count, lines[i].knots, lines[i].count + 2, 1, points, 0,
                              0, NULL, 0, 0, &g));
        CHECK_OK(nurbs_bezier_cells(g, 2, cells[0], NULL, &total, NULL));
        CHECK_INT(total, lines[i].total);
        CHECK_INT(cells[1][0] - cells[0][1], i == 0 ? 1 : 0);
        nurbs_destroy(g);
    }
}

static nurbs_mesh_options options_of(double chord) {
    nurbs_mesh_options options;
    CHECK_OK(nurbs_mesh_options_init(&options, sizeof options));
    options.chord = chord;
    options.relative_chord = 0;
    return options;
}

static nurbs_mesh *mesh_of(const nurbs *g, double chord, int64_t limit) {
    const nurbs_mesh_options options = options_of(chord);
    nurbs_mesh *mesh = NULL;
    CHECK_OK(nurbs_mesh_volume(g, &options, limit, &mesh));
    return mesh;
}

/* One hexahedron, whatever the tolerance: the corners of the cube in the order of VTK. */
static void a_cube(void) {
    static const double expected[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                          {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    nurbs *g = a_smooth_cube();
    nurbs_mesh *mesh = mesh_of(g, 1e-12, 0);
    int64_t corners[8], count = 0, points = 0, faces = 0, pieces = 0;
    int32_t fold = -1, sign = 0, reached = 0;
    double domain[3][2], x[8][3], bound = -1;
    CHECK_OK(nurbs_mesh_hexahedra(mesh, 1, corners, domain[0], &fold, &sign, &count));
    CHECK_INT(count, 1);
    CHECK_INT(fold, NURBS_FOLD_NONE);
    CHECK_INT(sign, 1);
    CHECK_OK(nurbs_mesh_counts(mesh, &points, NULL, NULL, &faces, NULL, NULL));
    CHECK_INT(points, 8);
    CHECK_INT(faces, 1);
    CHECK_OK(nurbs_mesh_points(mesh, 8, x[0], NULL));
    for (int i = 0; i < 8; ++i) {
        for (int k = 0; k < 3; ++k) {
            CHECK(x[corners[i]][k] == expected[i][k]);
            CHECK(domain[k][0] == 0 && domain[k][1] == 1);
        }
    }
    CHECK_OK(nurbs_mesh_bound(mesh, &bound, NULL, &reached));
    CHECK(bound > 0 && bound < 1e-12 && reached == 1);
    CHECK_OK(nurbs_fold_pieces(g, NULL, 1, &fold, &sign, &pieces));
    CHECK_INT(pieces, 1);
    CHECK_INT(fold, NURBS_FOLD_NONE);
    CHECK_INT(sign, 1);
    nurbs_mesh_destroy(mesh);
    nurbs_destroy(g);
}

/* Hexahedra of V = (u, v, w + u^2): along u alone there are several, as many as sqrt(2 / 8 / chord). */
static nurbs *bent(void) {
    nurbs *flat = NULL, *g = NULL;
    static const int32_t degrees[] = {2, 1};
    static const double points[] = {0, 0, 0, 0, 1, 0, 0.5, 0, 0, 0.5, 1, 0, 1, 0, 1, 1, 1, 1};
    static const double up[] = {0, 0, 1};
    CHECK_OK(nurbs_create_bezier(2, degrees, 3, points, 0, 0, NULL, 0, &flat));
    CHECK_OK(nurbs_extrude(flat, up, &g));
    nurbs_destroy(flat);
    return g;
}

static void as_many_as_needed(void) {
    nurbs *g = bent();
    for (int n = 1; n <= 64; n *= 2) {
        const double least = 0.25 / n / n;
        for (int i = 0; i < 2; ++i) {
            nurbs_mesh *mesh = mesh_of(g, least * (i == 0 ? 1 + 1e-8 : 1 - 1e-8), 0);
            int64_t count = 0;
            double bound = 0;
            int32_t reached = 0;
            CHECK_OK(nurbs_mesh_hexahedra(mesh, 0, NULL, NULL, NULL, NULL, &count));
            CHECK_OK(nurbs_mesh_bound(mesh, &bound, NULL, &reached));
            CHECK_INT(reached, 1);
            CHECK(i == 0 ? count == n : count > n);
            CHECK(i == 1 || fabs(bound - least) < 1e-12);
            nurbs_mesh_destroy(mesh);
        }
    }
    nurbs_mesh *mesh = mesh_of(g, 1e-6, 10);
    int64_t count = 0;
    int32_t reached = 1;
    CHECK_OK(nurbs_mesh_hexahedra(mesh, 0, NULL, NULL, NULL, NULL, &count));
    CHECK_OK(nurbs_mesh_bound(mesh, NULL, NULL, &reached));
    CHECK_INT(count, 10);
    CHECK_INT(reached, 0);
    nurbs_mesh_destroy(mesh);
    CHECK_OK(nurbs_mesh_volume(g, NULL, 0, &mesh)); /* within a thousandth of the longest side, which is 2 */
    CHECK_OK(nurbs_mesh_hexahedra(mesh, 0, NULL, NULL, NULL, NULL, &count));
    CHECK_INT(count, 12);
    nurbs_mesh_destroy(mesh);
    nurbs_destroy(g);
}

/* A cylinder: one point for all that is on its axis, and none twice where it closes. */
static void a_cylinder(void) {
    static const int32_t degrees[] = {1, 1};
    static const double sheet[] = {0, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0, 1};
    nurbs *half = NULL, *g = NULL;
    CHECK_OK(nurbs_create_bezier(2, degrees, 3, sheet, 0, 0, NULL, 0, &half));
    CHECK_OK(nurbs_revolve(half, NULL, NULL, 2 * acos(-1.0), NURBS_ARC_QUARTERS, &g));
    nurbs_mesh *mesh = mesh_of(g, 1, 0);
    int64_t corners[4][8], points = 0, count = 0;
    int32_t folds[4], signs[4];
    CHECK_OK(nurbs_mesh_counts(mesh, &points, NULL, NULL, NULL, NULL, NULL));
    CHECK_OK(nurbs_mesh_hexahedra(mesh, 4, corners[0], NULL, folds, signs, &count));
    CHECK_INT(count, 4);
    CHECK_INT(points, 2 * (4 + 1));
    for (int i = 0; i < 4; ++i) {
        CHECK(corners[i][0] == corners[i][1] && corners[i][4] == corners[i][5]);
        CHECK(corners[i][2] == corners[(i + 1) % 4][3] && corners[i][6] == corners[(i + 1) % 4][7]);
        CHECK(folds[i] == NURBS_FOLD_NONE && signs[i] == -1);
    }
    nurbs_mesh_destroy(mesh);
    nurbs_destroy(half);
    nurbs_destroy(g);
}

static int32_t stop(double done, void *user) {
    (void)done;
    ++*(int *)user;
    return 1;
}

static void watched(void) {
    nurbs *g = bent();
    const nurbs_mesh_options options = options_of(1e-9), fine = options_of(1e-13);
    nurbs_call_options call;
    nurbs_mesh *mesh = NULL;
    int32_t fold = -1;
    int64_t count = 0;
    int asked = 0;
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    CHECK_OK(nurbs_mesh_volume_with(g, NULL, 0, &call, &mesh));
    nurbs_mesh_destroy(mesh);
    CHECK_OK(nurbs_fold_pieces_with(g, NULL, 1, &fold, NULL, &count, &call));
    CHECK_INT(fold, NURBS_FOLD_NONE);
    call.work = 10;
    CHECK_FAILS(nurbs_mesh_volume_with(g, &options, 0, &call, &mesh), NURBS_ERROR_WORK, "");
    CHECK(mesh == NULL);
    CHECK_OK(nurbs_fold_pieces_with(g, NULL, 1, &fold, NULL, &count, &call));
    CHECK_INT(fold, NURBS_FOLD_UNDECIDED);
    call.work = 0;
    call.progress = stop;
    call.user = &asked;
    /* A million cells take a second, far more than the 10 ms after which the callback is asked. */
    CHECK_FAILS(nurbs_mesh_volume_with(g, &fine, 1 << 20, &call, &mesh), NURBS_ERROR_CANCELLED, "");
    CHECK(mesh == NULL && asked > 0);
    nurbs_destroy(g);
}

static void cells_refused(void) {
    static const int32_t degrees[] = {1, 0};
    nurbs *g = a_smooth_cube(), *steps = NULL;
    int64_t i[40] = {0}, j[2] = {0};
    int32_t k[2] = {0};
    double a[90] = {0}, b[30] = {0};
    CHECK_OK(nurbs_create_bezier(2, degrees, 1, a, 0, 0, NULL, 0, &steps));
    CHECK_FAILS(nurbs_bezier_cells(NULL, 1, i, k, j, j + 1), NURBS_ERROR_NULL, "g is NULL");
    CHECK_FAILS(nurbs_bezier_cells(steps, 1, i, k, j, j + 1), NURBS_ERROR_DEGREE, "axis 1|degree 0");
    CHECK_FAILS(nurbs_bezier_cells(g, -1, i, k, j, j + 1), NURBS_ERROR_COUNT, "cap = -1");
    CHECK_FAILS(nurbs_bezier_cells(g, 1, i, k, i + 26, j), NURBS_ERROR_OVERLAP, "points");
    CHECK_FAILS(nurbs_bezier_cell_points(NULL, 27, a, b, j), NURBS_ERROR_NULL, "g is NULL");
    CHECK_FAILS(nurbs_bezier_cell_points(steps, 27, a, b, j), NURBS_ERROR_DEGREE, "axis 1");
    CHECK_FAILS(nurbs_bezier_cell_points(g, 26, a, b, j), NURBS_ERROR_SIZE, "cap = 26|27");
    CHECK_FAILS(nurbs_bezier_cell_points(g, 27, a, a + 80, j), NURBS_ERROR_OVERLAP, "weights|points");
    CHECK_FAILS(nurbs_fold_pieces(NULL, NULL, 1, k, k + 1, j), NURBS_ERROR_NULL, "g is NULL");
    CHECK_FAILS(nurbs_fold_pieces(g, NULL, -1, k, k + 1, j), NURBS_ERROR_COUNT, "cap");
    CHECK_FAILS(nurbs_fold_pieces(g, NULL, 1, k, k, j), NURBS_ERROR_OVERLAP, "signs|folds");
    CHECK_FAILS(nurbs_fold_pieces(steps, NULL, 1, k, k + 1, j), NURBS_ERROR_DIMENSION, "");
    CHECK_FAILS(nurbs_fold_pieces(g, b, 1, k, k + 1, j), NURBS_ERROR_DIRECTION, "reference");
    for (int c = 0; c < 2; ++c) {
        CHECK(i[c] == 0 && j[c] == 0 && k[c] == 0 && a[c] == 0 && b[c] == 0);
    }
    nurbs_destroy(g);
    nurbs_destroy(steps);
}

#define CHECK_NO_MESH(call, status, words)                                                                   \
    do {                                                                                                     \
        mesh = (nurbs_mesh *)(void *)&mesh;                                                                  \
        CHECK_FAILS(call, status, words);                                                                    \
        CHECK(mesh == NULL);                                                                                 \
    } while (0)

static void volumes_refused(void) {
    static const int32_t degrees[] = {1, 1, 0}, linear[] = {1, 1, 1};
    const double zeros[24] = {0};
    nurbs *g = a_smooth_cube(), *flat = NULL, *plane = NULL, *sheet = NULL;
    CHECK_OK(nurbs_create_bezier(3, degrees, 3, zeros, 0, 0, NULL, 0, &flat));
    CHECK_OK(nurbs_create_bezier(3, linear, 2, zeros, 0, 0, NULL, 0, &plane));
    CHECK_OK(nurbs_create_bezier(2, linear, 3, zeros, 0, 0, NULL, 0, &sheet));
    nurbs_mesh_options options = options_of(1);
    nurbs_mesh *mesh = NULL;
    int64_t i[16] = {0}, j = 0;
    int32_t k[2] = {0};
    double a[8] = {0};
    CHECK_FAILS(nurbs_mesh_volume(g, NULL, 0, NULL), NURBS_ERROR_NULL, "out");
    CHECK_NO_MESH(nurbs_mesh_volume(NULL, NULL, 0, &mesh), NURBS_ERROR_NULL, "g is NULL");
    CHECK_NO_MESH(nurbs_mesh_volume(sheet, NULL, 0, &mesh), NURBS_ERROR_AXES, "2 axes|volume");
    CHECK_NO_MESH(nurbs_mesh_volume(plane, NULL, 0, &mesh), NURBS_ERROR_DIMENSION, "dimension 2");
    CHECK_NO_MESH(nurbs_mesh_volume(flat, NULL, 0, &mesh), NURBS_ERROR_DEGREE, "axis 2|degree 0");
    CHECK_NO_MESH(nurbs_mesh_volume(g, NULL, -1, &mesh), NURBS_ERROR_COUNT, "limit = -1");
    options.chord = -1;
    CHECK_NO_MESH(nurbs_mesh_volume(g, &options, 0, &mesh), NURBS_ERROR_TOLERANCE, "chord");
    options.struct_size = 8;
    CHECK_NO_MESH(nurbs_mesh_volume(g, &options, 0, &mesh), NURBS_ERROR_OPTIONS, "struct_size");
    CHECK_OK(nurbs_mesh_volume(g, NULL, 0, &mesh));
    CHECK_FAILS(nurbs_mesh_hexahedra(NULL, 1, i, a, k, k + 1, &j), NURBS_ERROR_NULL, "mesh");
    CHECK_FAILS(nurbs_mesh_hexahedra(mesh, -1, i, a, k, k + 1, &j), NURBS_ERROR_COUNT, "cap = -1");
    CHECK_FAILS(nurbs_mesh_hexahedra(mesh, 1, i, a, k, k, &j), NURBS_ERROR_OVERLAP, "signs");
    CHECK_FAILS(nurbs_mesh_hexahedra(mesh, 1, i, a, k, k + 1, i + 7), NURBS_ERROR_OVERLAP, "count");
    CHECK(i[0] == 0 && a[0] == 0 && k[0] == 0 && j == 0);
    nurbs_mesh_destroy(mesh);
    nurbs_destroy(g);
    nurbs_destroy(flat);
    nurbs_destroy(plane);
    nurbs_destroy(sheet);
}

int main(void) {
    order_of_a_volume();
    order_of_a_surface();
    a_circle();
    a_jump();
    a_cube();
    as_many_as_needed();
    a_cylinder();
    watched();
    cells_refused();
    volumes_refused();
    return check_summary("cells");
}
