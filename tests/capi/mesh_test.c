/* SPDX-License-Identifier: MIT */
/* Meshes: of known shapes, how many triangles there are at sides, what is refused, and what ends a long call. */
#include "models.h"

typedef struct Counts {
    int64_t points, vertices, triangles, faces, edges, edge_points;
} Counts;

static Counts counts_of(const nurbs_mesh *mesh) {
    Counts n = {-1, -1, -1, -1, -1, -1};
    CHECK_OK(
        nurbs_mesh_counts(mesh, &n.points, &n.vertices, &n.triangles, &n.faces, &n.edges, &n.edge_points));
    return n;
}

static nurbs_mesh_options options_of(double chord, double relative, double longest) {
    nurbs_mesh_options options;
    CHECK_OK(nurbs_mesh_options_init(&options, sizeof options));
    options.chord = chord;
    options.relative_chord = relative;
    options.longest = longest;
    return options;
}

static nurbs_mesh *surface_mesh(const nurbs *g, double chord) {
    const nurbs_mesh_options options = options_of(chord, 0, 0);
    nurbs_mesh *mesh = NULL;
    CHECK_OK(nurbs_mesh_surface(g, &options, &mesh));
    return mesh;
}

static int compare(const void *a, const void *b) {
    const int64_t *x = a, *y = b;
    return x[0] != y[0] ? (x[0] < y[0] ? -1 : 1) : x[1] != y[1] ? (x[1] < y[1] ? -1 : 1) : 0;
}

static void turn_triangles(const nurbs_mesh *mesh, int64_t face, int64_t *corners) {
    int64_t firsts[16], sizes[16];
    CHECK_OK(nurbs_mesh_faces(mesh, 16, NULL, NULL, firsts, sizes, NULL, NULL, NULL, NULL));
    for (int64_t i = firsts[face]; i < firsts[face] + sizes[face]; ++i) {
        const int64_t second = corners[3 * i + 1];
        corners[3 * i + 1] = corners[3 * i + 2];
        corners[3 * i + 2] = second;
    }
}

/* Corners of triangles as points, those of faces of a model about its outer normal. */
static int64_t *corners_of(const nurbs_mesh *mesh, const nurbs_model *model) {
    const Counts n = counts_of(mesh);
    int64_t *corners = malloc((size_t)n.triangles * 3 * sizeof *corners);
    CHECK_OK(nurbs_mesh_triangles(mesh, NURBS_MESH_WELDED, n.triangles, corners, NULL));
    for (int64_t face = 0; model != NULL && face < n.faces; ++face) {
        int32_t against = -1;
        nurbs_face *own = NULL;
        CHECK_OK(nurbs_model_face(model, face, NULL, NULL, &against, NULL, &own));
        nurbs_face_destroy(own);
        if (against == 1) {
            turn_triangles(mesh, face, corners);
        }
    }
    return corners;
}

/* Sides of triangles as pairs of points, in order. */
static int64_t (*sides_of(const nurbs_mesh *mesh, const nurbs_model *model))[2] {
    const int64_t n = counts_of(mesh).triangles;
    int64_t *corners = corners_of(mesh, model), (*sides)[2] = malloc((size_t)n * 3 * sizeof *sides);
    for (int64_t i = 0; i < 3 * n; ++i) {
        sides[i][0] = corners[i];
        sides[i][1] = corners[i % 3 == 2 ? i - 2 : i + 1];
        CHECK(sides[i][0] != sides[i][1]);
    }
    free(corners);
    qsort(sides, (size_t)(3 * n), sizeof *sides, compare);
    return sides;
}

/* How many sides have no triangle on their other side. No two triangles have one in the same direction. */
static int64_t free_sides(const nurbs_mesh *mesh, const nurbs_model *model) {
    const int64_t n = 3 * counts_of(mesh).triangles;
    int64_t(*sides)[2] = sides_of(mesh, model), alone = 0;
    for (int64_t i = 0; i < n; ++i) {
        const int64_t back[] = {sides[i][1], sides[i][0]};
        CHECK(i == 0 || compare(sides[i - 1], sides[i]) < 0);
        alone += bsearch(back, sides, (size_t)n, sizeof *sides, compare) == NULL;
    }
    free(sides);
    return alone;
}

/* Of a mesh all of whose points are in use. */
static int64_t euler(const nurbs_mesh *mesh, const nurbs_model *model) {
    const Counts n = counts_of(mesh);
    return n.points - (3 * n.triangles + free_sides(mesh, model)) / 2 + n.triangles;
}

/* Volume to the left of the triangles, and their area. */
static double volume_of(const nurbs_mesh *mesh, const nurbs_model *model, double *area) {
    const Counts n = counts_of(mesh);
    double *points = malloc((size_t)n.points * 3 * sizeof *points), volume = 0;
    int64_t *corners = corners_of(mesh, model);
    CHECK_OK(nurbs_mesh_points(mesh, n.points, points, NULL));
    *area = 0;
    for (int64_t i = 0; i < n.triangles; ++i) {
        const double *a = points + 3 * corners[3 * i], *b = points + 3 * corners[3 * i + 1],
                     *c = points + 3 * corners[3 * i + 2];
        double across[3];
        for (int k = 0; k < 3; ++k) {
            const int x = (k + 1) % 3, y = (k + 2) % 3;
            across[k] = (b[x] - a[x]) * (c[y] - a[y]) - (b[y] - a[y]) * (c[x] - a[x]);
        }
        volume += (a[0] * across[0] + a[1] * across[1] + a[2] * across[2]) / 6;
        *area += sqrt(across[0] * across[0] + across[1] * across[1] + across[2] * across[2]) / 2;
    }
    free(points);
    free(corners);
    return volume;
}

static void a_plane(void) {
    nurbs *g = plane();
    nurbs_mesh *mesh = NULL, *again = NULL;
    CHECK_OK(nurbs_mesh_surface(g, NULL, &mesh)); /* within a thousandth: the corners will do */
    const Counts n = counts_of(mesh);
    CHECK(n.points == 4 && n.vertices == 4 && n.triangles == 2 && n.faces == 1 && n.edges == 0 &&
          n.edge_points == 0);
    double from_shape = -1, from_mesh = -1, points[12], params[8], normals[12];
    int32_t reached = -1;
    CHECK_OK(nurbs_mesh_bound(mesh, &from_shape, &from_mesh, &reached));
    CHECK(from_shape >= 0 && from_shape < 1e-13 && from_mesh >= 0 && from_mesh < 1e-13 && reached == 1);
    int64_t at[4], count = -1;
    CHECK_OK(nurbs_mesh_points(mesh, 4, points, &count));
    CHECK_INT(count, 4);
    CHECK_OK(nurbs_mesh_vertices(mesh, 4, at, params, normals, &count));
    CHECK_INT(count, 4);
    for (int i = 0; i < 4; ++i) {
        const double *x = points + 3 * at[i];
        CHECK(x[0] == 2 * params[2 * i] && x[1] == 3 * params[2 * i + 1] && x[2] == 0);
        CHECK(normals[3 * i] == 0 && normals[3 * i + 1] == 0 && normals[3 * i + 2] == 1);
    }
    CHECK_INT(free_sides(mesh, NULL), 4);
    double area = 0;
    CHECK(volume_of(mesh, NULL, &area) == 0 && area == 6);
    CHECK_OK(nurbs_mesh_clone(mesh, &again));
    nurbs_mesh_destroy(mesh);
    CHECK_INT(counts_of(again).triangles, 2);
    nurbs_mesh_destroy(again);
    nurbs_mesh_destroy(NULL);
    nurbs_destroy(g);
}

/* A surface of the plane has z = 0. */
static void in_the_plane(void) {
    const double corners[] = {0, 0, 0, 1, 1, 0, 1, 1};
    const int32_t degrees[] = {1, 1};
    nurbs *g = NULL;
    CHECK_OK(nurbs_create_bezier(2, degrees, 2, corners, 0, 0, NULL, 0, &g));
    nurbs_mesh *mesh = surface_mesh(g, 0.5);
    double points[12];
    int64_t count = -1;
    CHECK_OK(nurbs_mesh_points(mesh, 4, points, &count));
    CHECK_INT(count, 4);
    for (int i = 0; i < 4; ++i) {
        CHECK(points[3 * i + 2] == 0);
    }
    nurbs_mesh_destroy(mesh);
    nurbs_destroy(g);
}

static void a_sphere(void) {
    nurbs *g = NULL;
    CHECK_OK(nurbs_surface_sphere(VALUES(1, 2, 3), NULL, NULL, 2, NURBS_ARC_QUARTERS, &g));
    nurbs_mesh *mesh = surface_mesh(g, 1e-2);
    CHECK_INT(free_sides(mesh, NULL), 0);
    CHECK_INT(euler(mesh, NULL), 2);
    double area = 0, from_shape = -1, from_mesh = -1;
    const double volume = volume_of(mesh, NULL, &area), pi = acos(-1), r = 2;
    CHECK_OK(nurbs_mesh_bound(mesh, &from_shape, &from_mesh, NULL));
    CHECK(from_shape > 0 && from_shape <= 1e-2 && from_mesh > 0 && from_mesh <= 1e-2);
    CHECK(volume < 4.0 / 3 * pi * r * r * r && volume > 4.0 / 3 * pi * pow(r - 1e-2, 3));
    CHECK(area < 4 * pi * r * r && area > 4 * pi * (r - 1e-2) * (r - 1e-2));
    nurbs_mesh_destroy(mesh);
    nurbs_destroy(g);
}

static void a_torus(void) {
    nurbs *g = NULL;
    const double pi = acos(-1);
    CHECK_OK(nurbs_surface_torus(NULL, NULL, NULL, 3, 1, 0, 2 * pi, 0, 2 * pi, NURBS_ARC_QUARTERS, &g));
    nurbs_mesh *mesh = surface_mesh(g, 1e-2);
    double area = 0;
    CHECK_INT(free_sides(mesh, NULL), 0);
    CHECK_INT(euler(mesh, NULL), 0);
    CHECK(fabs(volume_of(mesh, NULL, &area) - 6 * pi * pi) < 12 * pi * pi * 1e-2);
    nurbs_mesh_destroy(mesh);
    nurbs_destroy(g);
}

/* Closed around, with a round hole: a ring with one hole more. */
static void a_cylinder_with_a_hole(void) {
    nurbs *g = NULL;
    const double pi = acos(-1);
    CHECK_OK(nurbs_surface_cylinder(NULL, NULL, NULL, 1, 2, 0, 2 * pi, NURBS_ARC_QUARTERS, &g));
    double u[2], v[2];
    CHECK_OK(nurbs_domain(g, 0, u));
    CHECK_OK(nurbs_domain(g, 1, v));
    nurbs *low = segment(u[0], v[0], u[1], v[0]), *high = segment(u[1], v[1], u[0], v[1]),
          *hole = circle_in_domain(u[0] + 0.5 * (u[1] - u[0]), v[0] + 0.5 * (v[1] - v[0]),
                                   0.125 * fmin(u[1] - u[0], v[1] - v[0]));
    const nurbs *curves[] = {low, high, hole};
    nurbs_face *face = face_of(g, 3, curves);
    const nurbs_mesh_options options = options_of(1e-3, 0, 0);
    nurbs_mesh *mesh = NULL;
    double area = 0, known = 0;
    int32_t reached = -1;
    CHECK_OK(nurbs_mesh_face(face, &options, &mesh));
    CHECK_OK(nurbs_mesh_bound(mesh, NULL, NULL, &reached));
    CHECK_INT(reached, 1);
    CHECK_INT(euler(mesh, NULL), -1);
    CHECK_OK(nurbs_face_area(face, 1e-9, &known, NULL));
    volume_of(mesh, NULL, &area);
    CHECK(fabs(area - known) < 1e-2 * known);
    const Counts n = counts_of(mesh);
    CHECK(n.faces == 1 && n.edges == 3 && free_sides(mesh, NULL) > 0);
    nurbs_mesh_destroy(mesh);
    nurbs_face_destroy(face);
    nurbs_destroy(low);
    nurbs_destroy(high);
    nurbs_destroy(hole);
    nurbs_destroy(g);
}

/* The points of the edges, in one list. */
static void check_edges(const nurbs_model *model, const nurbs_mesh *mesh) {
    const Counts n = counts_of(mesh);
    int64_t *edges = malloc((size_t)n.edges * sizeof *edges),
            *firsts = malloc((size_t)n.edges * sizeof *firsts),
            *sizes = malloc((size_t)n.edges * sizeof *sizes),
            *places = malloc((size_t)n.edge_points * sizeof *places), count = -1, next = 0;
    double *points = malloc((size_t)n.points * 3 * sizeof *points);
    double *bounds = malloc((size_t)n.edges * sizeof *bounds);
    int32_t *reached = malloc((size_t)n.edges * sizeof *reached);
    CHECK_OK(nurbs_mesh_edges(mesh, n.edges, edges, firsts, sizes, bounds, reached, &count));
    CHECK_INT(count, n.edges);
    CHECK_OK(nurbs_mesh_edge_points(mesh, n.edge_points, places, &count));
    CHECK_INT(count, n.edge_points);
    CHECK_OK(nurbs_mesh_points(mesh, n.points, points, NULL));
    for (int64_t i = 0; i < n.edges; ++i) {
        CHECK(edges[i] == i && firsts[i] == next && sizes[i] >= 2 && reached[i] == 1 && bounds[i] >= 0);
        next += sizes[i];
        nurbs *edge = NULL;
        double ends[2], x[3];
        CHECK_OK(nurbs_model_edge(model, i, NULL, NULL, NULL, &edge));
        CHECK_OK(nurbs_domain(edge, 0, ends));
        CHECK_OK(nurbs_eval(edge, 1, ends, 0, 0, x, 0, 0, 0));
        CHECK_NEAR(points + 3 * places[firsts[i]], x, 3, 1e-9);
        CHECK_OK(nurbs_eval(edge, 1, ends + 1, 0, 0, x, 0, 0, 0));
        CHECK_NEAR(points + 3 * places[next - 1], x, 3, 1e-9);
        nurbs_destroy(edge);
    }
    CHECK_INT(next, n.edge_points);
    free(edges);
    free(firsts);
    free(sizes);
    free(places);
    free(points);
    free(bounds);
    free(reached);
}

static void a_box(void) {
    nurbs_model *model = box();
    nurbs_mesh *mesh = NULL;
    double area = 0;
    CHECK_OK(nurbs_mesh_model(model, NULL, &mesh));
    const Counts n = counts_of(mesh);
    CHECK(n.points == 8 && n.vertices == 24 && n.triangles == 12 && n.faces == 6 && n.edges == 12 &&
          n.edge_points == 24);
    CHECK_INT(free_sides(mesh, model), 0);
    CHECK_INT(euler(mesh, model), 2);
    CHECK(fabs(volume_of(mesh, model, &area) - 6) < 1e-14 && fabs(area - 22) < 1e-14);
    check_edges(model, mesh);
    int64_t first_vertices[6], vertices[6], first_triangles[6], triangles[6], count = -1;
    double from_shape[6], from_mesh[6];
    int32_t reached[6];
    CHECK_OK(nurbs_mesh_faces(mesh, 6, first_vertices, vertices, first_triangles, triangles, from_shape,
                              from_mesh, reached, &count));
    CHECK_INT(count, 6);
    for (int i = 0; i < 6; ++i) {
        CHECK(first_vertices[i] == 4 * i && vertices[i] == 4 && first_triangles[i] == 2 * i &&
              triangles[i] == 2 && reached[i] == 1);
        CHECK(from_shape[i] >= 0 && from_shape[i] < 1e-8 && from_mesh[i] >= 0 && from_mesh[i] < 1e-8);
    }
    nurbs_mesh_destroy(mesh);
    nurbs_model_destroy(model);
}

/* Two faces with one edge, which is a circle. */
static void a_half_ball(void) {
    nurbs_model *model = NULL;
    nurbs_mesh *mesh = NULL;
    double area = 0;
    const nurbs_mesh_options options = options_of(1e-3, 0, 0);
    CHECK_OK(nurbs_read_model(half_ball, (int64_t)strlen(half_ball), NULL, &model));
    CHECK_OK(nurbs_mesh_model(model, &options, &mesh));
    const Counts n = counts_of(mesh);
    CHECK(n.faces == 2 && n.edges == 1);
    CHECK_INT(free_sides(mesh, model), 0);
    CHECK_INT(euler(mesh, model), 2);
    const double pi = acos(-1);
    CHECK(fabs(volume_of(mesh, model, &area) - 2 * pi / 3) < 3 * pi * 1e-3);
    check_edges(model, mesh);
    nurbs_mesh_destroy(mesh);
    nurbs_model_destroy(model);
}

/* A plane is one quad; a sphere has quads everywhere but at its poles. */
static void quads(void) {
    nurbs *g = plane();
    nurbs_mesh *mesh = surface_mesh(g, 1);
    int64_t corners[4], triangles[6], first = -1, count = -1;
    for (int welded = 0; welded < 2; ++welded) {
        const uint32_t flags = welded ? NURBS_MESH_WELDED : 0;
        CHECK_OK(nurbs_mesh_quads(mesh, flags, 1, corners, &first, &count));
        CHECK(first == 0 && count == 1);
        CHECK_OK(nurbs_mesh_triangles(mesh, flags, 2, triangles, NULL));
        const int64_t expected[] = {corners[0], corners[1], corners[2], corners[0], corners[2], corners[3]};
        for (int half = 0; half < 2; ++half) {
            int same = 0;
            for (int turn = 0; turn < 3; ++turn) {
                same += triangles[3 * half] == expected[3 * half + turn] &&
                        triangles[3 * half + 1] == expected[3 * half + (turn + 1) % 3] &&
                        triangles[3 * half + 2] == expected[3 * half + (turn + 2) % 3];
            }
            CHECK_INT(same, 1);
        }
    }
    CHECK_OK(nurbs_mesh_quads(mesh, 0, 0, NULL, NULL, &count));
    CHECK_INT(count, 1);
    nurbs_mesh_destroy(mesh);
    nurbs_destroy(g);
    CHECK_OK(nurbs_surface_sphere(NULL, NULL, NULL, 1, NURBS_ARC_QUARTERS, &g));
    mesh = surface_mesh(g, 1e-3);
    CHECK_OK(nurbs_mesh_quads(mesh, 0, 0, NULL, NULL, &count));
    CHECK(count > 0 && 2 * count < counts_of(mesh).triangles);
    nurbs_mesh_destroy(mesh);
    nurbs_destroy(g);
}

/* Of a sphere normals are as far apart as points. */
static void angles(void) {
    nurbs *g = NULL;
    nurbs_mesh *mesh = NULL;
    int32_t reached = -1;
    nurbs_mesh_options options = options_of(INFINITY, 0, 0);
    options.angle = 0.2;
    CHECK_OK(nurbs_surface_sphere(NULL, NULL, NULL, 1, NURBS_ARC_QUARTERS, &g));
    CHECK_OK(nurbs_mesh_surface(g, &options, &mesh));
    CHECK_OK(nurbs_mesh_bound(mesh, NULL, NULL, &reached));
    CHECK_INT(reached, 1);
    const Counts n = counts_of(mesh);
    double *points = malloc((size_t)n.points * 3 * sizeof *points);
    int64_t *corners = corners_of(mesh, NULL);
    CHECK_OK(nurbs_mesh_points(mesh, n.points, points, NULL));
    double longest = 0;
    for (int64_t i = 0; i < 3 * n.triangles; ++i) {
        const double *a = points + 3 * corners[i], *b = points + 3 * corners[i % 3 == 2 ? i - 2 : i + 1];
        longest = fmax(longest, hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]));
    }
    CHECK(longest <= 2 * sin(0.1) && longest > 0.1 && n.triangles < 3000);
    free(points);
    free(corners);
    nurbs_mesh_destroy(mesh);
    options.angle = 1e-9; /* nobody can: some mesh, and it says so */
    CHECK_OK(nurbs_mesh_surface(g, &options, &mesh));
    CHECK_OK(nurbs_mesh_bound(mesh, NULL, NULL, &reached));
    CHECK_INT(reached, 0);
    nurbs_mesh_destroy(mesh);
    nurbs_destroy(g);
}

/* Twelve strips of a tube, as long as forty of them are wide. */
static void no_small_angles(void) {
    nurbs *g = NULL;
    CHECK_OK(nurbs_surface_cylinder(NULL, NULL, NULL, 1, 20, 0, 2 * acos(-1.0), NURBS_ARC_QUARTERS, &g));
    nurbs_mesh_options options = options_of(0.05, 0, 0);
    CHECK(options.minimum_angle == 0);
    nurbs_mesh *plain = NULL, *mesh = NULL;
    CHECK_OK(nurbs_mesh_surface(g, &options, &plain));
    options.minimum_angle = 0.5;
    CHECK_OK(nurbs_mesh_surface(g, &options, &mesh));
    double from_shape = -1, from_mesh = -1;
    int32_t reached = -1;
    CHECK_OK(nurbs_mesh_bound(mesh, &from_shape, &from_mesh, &reached));
    CHECK(reached == 1 && from_shape <= 0.05 && from_mesh <= 0.05);
    CHECK(counts_of(mesh).triangles > 5 * counts_of(plain).triangles);
    CHECK_INT(free_sides(mesh, NULL), free_sides(plain, NULL));
    CHECK_INT(euler(mesh, NULL), 0);
    nurbs_mesh_destroy(plain);
    nurbs_mesh_destroy(mesh);
    nurbs_destroy(g);
}

static void single_precision(void) {
    nurbs *g = plane();
    nurbs_mesh *mesh = surface_mesh(g, 1);
    double points[12], params[8], normals[12];
    float points32[12], drawn[12], params32[8], normals32[12];
    int64_t at[4], corners[6], count = -1;
    int32_t corners32[6];
    CHECK_OK(nurbs_mesh_points(mesh, 4, points, NULL));
    CHECK_OK(nurbs_mesh_vertices(mesh, 4, at, params, normals, NULL));
    CHECK_OK(nurbs_mesh_points_f32(mesh, 4, points32, &count));
    CHECK_INT(count, 4);
    CHECK_OK(nurbs_mesh_vertices_f32(mesh, 4, drawn, params32, normals32, &count));
    CHECK_INT(count, 4);
    for (int i = 0; i < 12; ++i) {
        CHECK(points32[i] == (float)points[i] && normals32[i] == (float)normals[i]);
        CHECK(drawn[i] == (float)points[3 * at[i / 3] + i % 3]);
        CHECK(i >= 8 || params32[i] == (float)params[i]);
    }
    for (int welded = 0; welded < 2; ++welded) {
        const uint32_t flags = welded ? NURBS_MESH_WELDED : 0;
        CHECK_OK(nurbs_mesh_triangles(mesh, flags, 2, corners, &count));
        CHECK_INT(count, 2);
        CHECK_OK(nurbs_mesh_triangles_i32(mesh, flags, 2, corners32, &count));
        CHECK_INT(count, 2);
        for (int i = 0; i < 6; ++i) {
            CHECK_INT(corners32[i], corners[i]);
        }
    }
    nurbs_mesh_destroy(mesh);
    nurbs_destroy(g);
}

static int32_t stop(double done, void *user) {
    (void)done;
    (void)user;
    return 1;
}

static void watched(void) {
    nurbs *g = NULL;
    nurbs_face *face = NULL;
    nurbs_model *model = box();
    nurbs_mesh *mesh = NULL;
    nurbs_call_options call;
    double from_shape = -1;
    int32_t reached = -1;
    const nurbs_mesh_options options = options_of(1e-5, 0, 0), fine = options_of(1e-9, 0, 0);
    CHECK_OK(nurbs_surface_sphere(NULL, NULL, NULL, 1, NURBS_ARC_QUARTERS, &g));
    CHECK_OK(nurbs_face_create(g, 0, NULL, NULL, NULL, NULL, 1e-9, 0, NULL, &face));
    CHECK_OK(nurbs_call_options_init(&call, sizeof call));
    call.work = 200000;
    CHECK_OK(nurbs_mesh_surface_with(g, &options, &call, &mesh));
    CHECK_OK(nurbs_mesh_bound(mesh, &from_shape, NULL, &reached));
    CHECK(reached == 0 && from_shape > 1e-5);
    nurbs_mesh_destroy(mesh);
    CHECK_OK(nurbs_mesh_face_with(face, &options, &call, &mesh));
    CHECK_OK(nurbs_mesh_bound(mesh, NULL, NULL, &reached));
    CHECK_INT(reached, 0);
    nurbs_mesh_destroy(mesh);
    CHECK_OK(nurbs_mesh_model_with(model, NULL, NULL, &mesh));
    CHECK_OK(nurbs_mesh_bound(mesh, NULL, NULL, &reached));
    CHECK_INT(reached, 1);
    nurbs_mesh_destroy(mesh);
    call.work = 0;
    call.progress = stop;
    mesh = (nurbs_mesh *)(void *)check_poison();
    CHECK_FAILS(nurbs_mesh_surface_with(g, &fine, &call, &mesh), NURBS_ERROR_CANCELLED, "");
    CHECK(mesh == NULL);
    CHECK_FAILS(nurbs_mesh_face_with(face, &fine, &call, &mesh), NURBS_ERROR_CANCELLED, "");
    call.work = -1;
    CHECK_FAILS(nurbs_mesh_model_with(model, NULL, &call, &mesh), NURBS_ERROR_OPTIONS, "work");
    nurbs_face_destroy(face);
    nurbs_model_destroy(model);
    nurbs_destroy(g);
}

#define CHECK_NO_MESH(call, status, words)                                                                   \
    do {                                                                                                     \
        mesh = (nurbs_mesh *)(void *)check_poison();                                                         \
        CHECK_FAILS(call, status, words);                                                                    \
        check_true(__FILE__, __LINE__, mesh == NULL, "mesh == NULL");                                        \
    } while (0)

static void limits_refused(void) {
    nurbs *g = plane();
    nurbs_mesh *mesh = NULL;
    const double bad_chords[] = {0, -1, NAN, -INFINITY};
    for (int i = 0; i < 4; ++i) {
        const nurbs_mesh_options options = options_of(bad_chords[i], 1e-3, 1);
        CHECK_NO_MESH(nurbs_mesh_surface(g, &options, &mesh), NURBS_ERROR_TOLERANCE, "chord");
    }
    const double bad_sizes[] = {-1, NAN, INFINITY};
    for (int i = 0; i < 3; ++i) {
        nurbs_mesh_options options = options_of(1, bad_sizes[i], 0);
        CHECK_NO_MESH(nurbs_mesh_surface(g, &options, &mesh), NURBS_ERROR_TOLERANCE, "relative_chord");
        options = options_of(1, 0, bad_sizes[i]);
        CHECK_NO_MESH(nurbs_mesh_surface(g, &options, &mesh), NURBS_ERROR_LENGTH, "longest");
        options = options_of(INFINITY, bad_sizes[i], 0);
        CHECK_NO_MESH(nurbs_mesh_surface(g, &options, &mesh), NURBS_ERROR_TOLERANCE, "relative_chord");
        options = options_of(INFINITY, 0, bad_sizes[i]);
        CHECK_NO_MESH(nurbs_mesh_surface(g, &options, &mesh), NURBS_ERROR_LENGTH, "longest");
    }
    nurbs_mesh_options options = options_of(INFINITY, 0, 0);
    CHECK_NO_MESH(nurbs_mesh_surface(g, &options, &mesh), NURBS_ERROR_TOLERANCE, "chord = inf");
    const double bad_angles[] = {-1e-9, NAN, INFINITY, 3.2};
    for (int i = 0; i < 4; ++i) {
        options = options_of(1, 0, 0);
        options.angle = bad_angles[i];
        CHECK_NO_MESH(nurbs_mesh_surface(g, &options, &mesh), NURBS_ERROR_ANGLE, "angle");
    }
    const double bad_minima[] = {-1e-9, NAN, INFINITY, 0.53};
    for (int i = 0; i < 4; ++i) {
        options = options_of(1, 0, 0);
        options.minimum_angle = bad_minima[i];
        CHECK_NO_MESH(nurbs_mesh_surface(g, &options, &mesh), NURBS_ERROR_ANGLE, "minimum_angle");
    }
    options = options_of(1, 0, 0);
    options.struct_size = 8;
    CHECK_NO_MESH(nurbs_mesh_surface(g, &options, &mesh), NURBS_ERROR_OPTIONS, "struct_size = 8");
    CHECK_FAILS(nurbs_mesh_options_init(NULL, sizeof options), NURBS_ERROR_NULL, "options");
    CHECK_FAILS(nurbs_mesh_options_init(&options, 4), NURBS_ERROR_OPTIONS, "struct_size = 4");
    nurbs_destroy(g);
}

static void shapes_refused(void) {
    nurbs *curve = make(arch()), *line_of_heights = NULL;
    const int32_t degrees[] = {1, 1};
    CHECK_OK(nurbs_create_bezier(2, degrees, 1, VALUES(0, 1, 2, 3), 0, 0, NULL, 0, &line_of_heights));
    nurbs_mesh *mesh = NULL;
    CHECK_FAILS(nurbs_mesh_surface(curve, NULL, NULL), NURBS_ERROR_NULL, "out");
    CHECK_NO_MESH(nurbs_mesh_surface(NULL, NULL, &mesh), NURBS_ERROR_NULL, "g is NULL");
    CHECK_NO_MESH(nurbs_mesh_surface(curve, NULL, &mesh), NURBS_ERROR_AXES, "");
    CHECK_NO_MESH(nurbs_mesh_surface(line_of_heights, NULL, &mesh), NURBS_ERROR_DIMENSION, "");
    CHECK_FAILS(nurbs_mesh_face(NULL, NULL, NULL), NURBS_ERROR_NULL, "out");
    CHECK_NO_MESH(nurbs_mesh_face(NULL, NULL, &mesh), NURBS_ERROR_NULL, "face");
    CHECK_FAILS(nurbs_mesh_model(NULL, NULL, NULL), NURBS_ERROR_NULL, "out");
    CHECK_NO_MESH(nurbs_mesh_model(NULL, NULL, &mesh), NURBS_ERROR_NULL, "model");
    CHECK_NO_MESH(nurbs_mesh_clone(NULL, &mesh), NURBS_ERROR_NULL, "mesh");
    CHECK_FAILS(nurbs_mesh_clone(NULL, NULL), NURBS_ERROR_NULL, "out");
    nurbs_destroy(curve);
    nurbs_destroy(line_of_heights);
}

static void arrays_refused(void) {
    nurbs *g = plane();
    nurbs_mesh *mesh = surface_mesh(g, 1);
    double a[12] = {0}, b[12] = {0};
    float f[12] = {0};
    int64_t i[12] = {0}, j[12] = {0};
    int32_t k[12] = {0};
    CHECK_FAILS(nurbs_mesh_counts(NULL, i, i + 1, i + 2, i + 3, i + 4, i + 5), NURBS_ERROR_NULL, "mesh");
    CHECK_FAILS(nurbs_mesh_counts(mesh, i, i, NULL, NULL, NULL, NULL), NURBS_ERROR_OVERLAP,
                "vertices|points");
    CHECK_FAILS(nurbs_mesh_bound(NULL, a, b, k), NURBS_ERROR_NULL, "mesh");
    CHECK_FAILS(nurbs_mesh_bound(mesh, a, a, k), NURBS_ERROR_OVERLAP, "from_mesh");
    CHECK_FAILS(nurbs_mesh_points(NULL, 4, a, i), NURBS_ERROR_NULL, "mesh");
    CHECK_FAILS(nurbs_mesh_points(mesh, -1, a, i), NURBS_ERROR_COUNT, "cap = -1");
    CHECK_FAILS(nurbs_mesh_points(mesh, 3, a, i), NURBS_ERROR_SIZE, "cap = 3");
    CHECK_FAILS(nurbs_mesh_points_f32(NULL, 4, f, i), NURBS_ERROR_NULL, "mesh");
    CHECK_FAILS(nurbs_mesh_points_f32(mesh, 1, f, i), NURBS_ERROR_SIZE, "cap = 1");
    CHECK_FAILS(nurbs_mesh_vertices(NULL, 4, i, a, b, j), NURBS_ERROR_NULL, "mesh");
    CHECK_FAILS(nurbs_mesh_vertices(mesh, 3, i, a, b, j), NURBS_ERROR_SIZE, "cap = 3");
    CHECK_FAILS(nurbs_mesh_vertices(mesh, 4, i, a, a + 7, j), NURBS_ERROR_OVERLAP, "normals");
    CHECK_FAILS(nurbs_mesh_vertices_f32(NULL, 4, f, NULL, NULL, i), NURBS_ERROR_NULL, "mesh");
    CHECK_FAILS(nurbs_mesh_vertices_f32(mesh, 4, f, f + 4, NULL, i), NURBS_ERROR_OVERLAP, "params");
    CHECK_FAILS(nurbs_mesh_triangles(NULL, 0, 4, i, j), NURBS_ERROR_NULL, "mesh");
    CHECK_FAILS(nurbs_mesh_triangles(mesh, 1, 4, i, j), NURBS_ERROR_FLAGS, "flags = 0x1");
    CHECK_FAILS(nurbs_mesh_triangles(mesh, 0, 1, i, j), NURBS_ERROR_SIZE, "cap = 1");
    CHECK_FAILS(nurbs_mesh_triangles(mesh, 0, 2, i, i + 5), NURBS_ERROR_OVERLAP, "count");
    CHECK_FAILS(nurbs_mesh_triangles_i32(NULL, 0, 4, k, j), NURBS_ERROR_NULL, "mesh");
    CHECK_FAILS(nurbs_mesh_triangles_i32(mesh, 0x80000000u, 4, k, j), NURBS_ERROR_FLAGS, "flags");
    CHECK_FAILS(nurbs_mesh_quads(NULL, 0, 1, i, i + 4, j), NURBS_ERROR_NULL, "mesh");
    CHECK_FAILS(nurbs_mesh_quads(mesh, 2, 1, i, i + 4, j), NURBS_ERROR_FLAGS, "flags = 0x2");
    CHECK_FAILS(nurbs_mesh_quads(mesh, 0, -1, i, i + 4, j), NURBS_ERROR_COUNT, "cap = -1");
    CHECK_FAILS(nurbs_mesh_quads(mesh, 0, 1, i, i + 3, j), NURBS_ERROR_OVERLAP, "own_triangles");
    CHECK_FAILS(nurbs_mesh_quads(mesh, 0, 1, i, i + 4, i), NURBS_ERROR_OVERLAP, "count");
    CHECK_FAILS(nurbs_mesh_faces(NULL, 1, i, i + 1, i + 2, i + 3, a, b, k, j), NURBS_ERROR_NULL, "mesh");
    CHECK_FAILS(nurbs_mesh_faces(mesh, -5, i, i + 1, i + 2, i + 3, a, b, k, j), NURBS_ERROR_COUNT, "cap");
    CHECK_FAILS(nurbs_mesh_faces(mesh, 1, i, i, i + 2, i + 3, a, b, k, j), NURBS_ERROR_OVERLAP,
                "vertex_counts");
    CHECK_FAILS(nurbs_mesh_edges(NULL, 1, i, i + 1, i + 2, a, k, j), NURBS_ERROR_NULL, "mesh");
    CHECK_FAILS(nurbs_mesh_edges(mesh, -1, i, i + 1, i + 2, a, k, j), NURBS_ERROR_COUNT, "cap");
    CHECK_FAILS(nurbs_mesh_edge_points(NULL, 1, i, j), NURBS_ERROR_NULL, "mesh");
    CHECK_FAILS(nurbs_mesh_edge_points(mesh, -1, i, j), NURBS_ERROR_COUNT, "cap");
    for (int c = 0; c < 12; ++c) {
        CHECK(a[c] == 0 && b[c] == 0 && f[c] == 0 && i[c] == 0 && j[c] == 0 && k[c] == 0);
    }
    nurbs_mesh_destroy(mesh);
    nurbs_destroy(g);
}

int main(void) {
    a_plane();
    in_the_plane();
    a_sphere();
    a_torus();
    a_cylinder_with_a_hole();
    a_box();
    a_half_ball();
    quads();
    angles();
    no_small_angles();
    single_precision();
    watched();
    limits_refused();
    shapes_refused();
    arrays_refused();
    return check_summary("mesh");
}
