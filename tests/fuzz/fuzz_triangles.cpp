// SPDX-License-Identifier: MIT
// Meshes of surfaces, faces and models: numbers of points, vertices and triangles are some that there are, no triangle has two
// corners at a point, what is drawn is what is told, and where limits are kept no place of a surface is farther than the
// bound.
#include "fuzz/harness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

using fuzz::Input;

namespace {

struct Deleter {
    void operator()(nurbs_mesh *mesh) const { nurbs_mesh_destroy(mesh); }
    void operator()(nurbs_face *face) const { nurbs_face_destroy(face); }
    void operator()(nurbs_model *model) const { nurbs_model_destroy(model); }
};
using Mesh = std::unique_ptr<nurbs_mesh, Deleter>;
using Face = std::unique_ptr<nurbs_face, Deleter>;
using Model = std::unique_ptr<nurbs_model, Deleter>;
using Point = std::array<double, 3>;

struct Arrays {
    int64_t points = -1, vertices = -1, triangles = -1, faces = -1, edges = -1, edge_points = -1;
    double from_shape = -1, from_mesh = -1;
    int32_t reached = -1;
    std::vector<double> xyz, params, normals;
    std::vector<int64_t> at, corners, welded;
};

nurbs_mesh_options any_options(Input &in, double size) {
    nurbs_mesh_options options;
    FUZZ_REQUIRE(nurbs_mesh_options_init(&options, sizeof options) == NURBS_OK);
    if (in.rarely()) {
        options.chord = in.anything();
        options.relative_chord = in.anything();
        options.longest = in.anything();
        options.angle = in.anything();
        options.minimum_angle = in.anything();
    } else if (in.coin()) {
        options.chord = std::ldexp(size + 1e-300, -in.below(7));
        options.relative_chord = in.coin() ? 0 : 0.1;
        options.longest = in.coin() ? 0 : size * (0.05 + in.unit());
        options.angle = in.coin() ? 0 : 0.2 + in.unit();
        options.minimum_angle = in.coin() ? 0 : in.unit() / 2;
    }
    return options;
}

Arrays arrays_of(const nurbs_mesh *mesh) {
    Arrays all;
    FUZZ_REQUIRE(nurbs_mesh_counts(mesh, &all.points, &all.vertices, &all.triangles, &all.faces, &all.edges,
                                   &all.edge_points) == NURBS_OK);
    FUZZ_REQUIRE(nurbs_mesh_bound(mesh, &all.from_shape, &all.from_mesh, &all.reached) == NURBS_OK);
    all.xyz.resize(static_cast<size_t>(3 * all.points));
    all.params.resize(static_cast<size_t>(2 * all.vertices));
    all.normals.resize(static_cast<size_t>(3 * all.vertices));
    all.at.resize(static_cast<size_t>(all.vertices));
    all.corners.resize(static_cast<size_t>(3 * all.triangles));
    all.welded = all.corners;
    FUZZ_REQUIRE(nurbs_mesh_points(mesh, all.points, all.xyz.data(), nullptr) == NURBS_OK);
    FUZZ_REQUIRE(nurbs_mesh_vertices(mesh, all.vertices, all.at.data(), all.params.data(), all.normals.data(),
                                     nullptr) == NURBS_OK);
    FUZZ_REQUIRE(nurbs_mesh_triangles(mesh, 0, all.triangles, all.corners.data(), nullptr) == NURBS_OK);
    FUZZ_REQUIRE(nurbs_mesh_triangles(mesh, NURBS_MESH_WELDED, all.triangles, all.welded.data(), nullptr) ==
                 NURBS_OK);
    return all;
}

bool all_below(const std::vector<int64_t> &numbers, int64_t end) {
    return std::ranges::all_of(numbers, [end](int64_t i) { return i >= 0 && i < end; });
}

void check_triangles(const Arrays &all) {
    FUZZ_REQUIRE(all_below(all.at, all.points) && all_below(all.corners, all.vertices));
    for (size_t i = 0; i < all.corners.size(); ++i) {
        FUZZ_REQUIRE(all.welded[i] == all.at[static_cast<size_t>(all.corners[i])]);
        FUZZ_REQUIRE(all.welded[i] != all.welded[i % 3 == 2 ? i - 2 : i + 1]);
    }
    FUZZ_REQUIRE(all.from_shape >= 0 && all.from_mesh >= 0);
}

// Two triangles each, one after the other, and none in two.
void check_quads(const nurbs_mesh *mesh, const Arrays &all) {
    int64_t count = -1, next = 0;
    FUZZ_REQUIRE(nurbs_mesh_quads(mesh, 0, 0, nullptr, nullptr, &count) == NURBS_OK);
    std::vector<int64_t> corners(static_cast<size_t>(4 * count)), firsts(static_cast<size_t>(count));
    FUZZ_REQUIRE(nurbs_mesh_quads(mesh, NURBS_MESH_WELDED, count, corners.data(), firsts.data(), nullptr) ==
                 NURBS_OK);
    for (size_t i = 0; i < firsts.size(); ++i) {
        FUZZ_REQUIRE(firsts[i] >= next && firsts[i] + 1 < all.triangles);
        next = firsts[i] + 2;
        const std::array halves{std::array<size_t, 3>{0, 1, 2}, std::array<size_t, 3>{0, 2, 3}};
        for (size_t half = 0; half < 2; ++half) {
            const int64_t *triangle = &all.welded[3 * (static_cast<size_t>(firsts[i]) + half)];
            for (const size_t k : halves[half]) {
                FUZZ_REQUIRE(std::count(triangle, triangle + 3, corners[4 * i + k]) == 1);
            }
        }
    }
}

void check_single(const nurbs_mesh *mesh, const Arrays &all) {
    std::vector<float> points(all.xyz.size()), drawn(3 * all.at.size()), params(all.params.size()),
        normals(all.normals.size());
    std::vector<int32_t> corners(all.corners.size());
    FUZZ_REQUIRE(nurbs_mesh_points_f32(mesh, all.points, points.data(), nullptr) == NURBS_OK);
    FUZZ_REQUIRE(nurbs_mesh_vertices_f32(mesh, all.vertices, drawn.data(), params.data(), normals.data(),
                                         nullptr) == NURBS_OK);
    FUZZ_REQUIRE(nurbs_mesh_triangles_i32(mesh, 0, all.triangles, corners.data(), nullptr) == NURBS_OK);
    FUZZ_REQUIRE(std::ranges::equal(corners, all.corners));
    for (size_t i = 0; i < drawn.size(); ++i) {
        const float x = points[3 * static_cast<size_t>(all.at[i / 3]) + i % 3];
        FUZZ_REQUIRE(drawn[i] == x || (std::isnan(drawn[i]) && std::isnan(x)));
    }
}

void check_parts(const nurbs_mesh *mesh, const Arrays &all) {
    const auto faces = static_cast<size_t>(all.faces), edges = static_cast<size_t>(all.edges);
    std::vector<int64_t> vertices(faces), vertex_counts(faces), triangles(faces), triangle_counts(faces);
    FUZZ_REQUIRE(nurbs_mesh_faces(mesh, all.faces, vertices.data(), vertex_counts.data(), triangles.data(),
                                  triangle_counts.data(), nullptr, nullptr, nullptr, nullptr) == NURBS_OK);
    int64_t vertex = 0, triangle = 0, place = 0;
    for (size_t i = 0; i < faces; ++i) {
        FUZZ_REQUIRE(vertices[i] == vertex && triangles[i] == triangle);
        vertex += vertex_counts[i];
        triangle += triangle_counts[i];
    }
    FUZZ_REQUIRE(vertex == all.vertices && triangle == all.triangles);
    std::vector<int64_t> firsts(edges), sizes(edges), places(static_cast<size_t>(all.edge_points));
    FUZZ_REQUIRE(nurbs_mesh_edges(mesh, all.edges, nullptr, firsts.data(), sizes.data(), nullptr, nullptr,
                                  nullptr) == NURBS_OK);
    FUZZ_REQUIRE(nurbs_mesh_edge_points(mesh, all.edge_points, places.data(), nullptr) == NURBS_OK);
    for (size_t i = 0; i < edges; ++i) {
        FUZZ_REQUIRE(firsts[i] == place && sizes[i] >= 2);
        place += sizes[i];
    }
    FUZZ_REQUIRE(place == all.edge_points && all_below(places, all.points));
}

// Of every format as many bytes as asked for; of STL no more triangles than there are.
void check_files(const nurbs_mesh *mesh, const Arrays &all) {
    for (int32_t format = NURBS_FORMAT_STL; format <= NURBS_FORMAT_VTU; ++format) {
        int64_t size = 0, again = 0;
        if (!FUZZ_OK(nurbs_mesh_write(mesh, format, nullptr, 0, nullptr, &size))) {
            continue; // overflow in single precision, or no triangles
        }
        std::vector<char> bytes(static_cast<size_t>(size));
        FUZZ_REQUIRE(nurbs_mesh_write(mesh, format, nullptr, size, bytes.data(), &again) == NURBS_OK);
        FUZZ_REQUIRE(again == size && all.triangles > 0);
        FUZZ_REQUIRE(format != NURBS_FORMAT_STL || size <= 84 + 50 * all.triangles);
        FUZZ_REQUIRE(format != NURBS_FORMAT_PLY || size >= 13 * all.triangles + 40 * all.vertices);
    }
}

// With any settings, to where all is lost or refused, and within a limit of work.
void write_anywhere(Input &in, const nurbs_mesh *mesh) {
    nurbs_write_options options;
    FUZZ_REQUIRE(nurbs_write_options_init(&options, sizeof options) == NURBS_OK);
    options.unit = std::ldexp(1, in.below(2000) - 1000);
    const nurbs_write_options *given = in.rarely() ? &options : nullptr;
    nurbs_call_options call;
    FUZZ_REQUIRE(nurbs_call_options_init(&call, sizeof call) == NURBS_OK);
    call.work = int64_t{1} << in.below(20);
    const char *const path = in.rarely() ? "/nonexistent/a.stl" : "/dev/null";
    const int32_t format = in.below(10);
    FUZZ_OK(nurbs_mesh_write_file(mesh, path, format, given));
    FUZZ_OK(nurbs_mesh_write_file_with(mesh, path, format, given, &call));
    int64_t size = 0;
    std::vector<char> bytes(1 << 12, 7);
    if (!FUZZ_OK(nurbs_mesh_write_with(mesh, format, given, std::ssize(bytes), bytes.data(), &size, &call))) {
        FUZZ_REQUIRE(std::ranges::count(bytes, 7) == std::ssize(bytes));
    }
}

Arrays check(const nurbs_mesh *mesh) {
    nurbs_mesh *copy = nullptr;
    FUZZ_REQUIRE(nurbs_mesh_clone(mesh, &copy) == NURBS_OK);
    const Mesh own(copy);
    Arrays all = arrays_of(copy);
    check_triangles(all);
    check_quads(copy, all);
    check_single(copy, all);
    check_parts(copy, all);
    if (all.triangles < 100 && all.vertices % 4 == 0) { // some of the many
        check_files(copy, all);
    }
    return all;
}

double dot(const Point &a, const Point &b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Point minus(const Point &a, const Point &b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Point cross(const Point &a, const Point &b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double from_side(const Point &x, const Point &a, const Point &b) {
    const Point d = minus(b, a), off = minus(x, a);
    const double share = dot(d, d) > 0 ? std::clamp(dot(off, d) / dot(d, d), 0.0, 1.0) : 0;
    const Point rest{off[0] - share * d[0], off[1] - share * d[1], off[2] - share * d[2]};
    return std::sqrt(dot(rest, rest));
}

// Over the triangle the height, elsewhere the distance of the nearest side.
double distance(const Point &x, const std::array<Point, 3> &t) {
    const Point normal = cross(minus(t[1], t[0]), minus(t[2], t[0]));
    double least = INFINITY;
    bool over = dot(normal, normal) > 0;
    for (size_t k = 0; k < 3; ++k) {
        const Point &a = t[k], &b = t[(k + 1) % 3];
        over = over && dot(cross(normal, minus(b, a)), minus(x, a)) >= 0;
        least = std::min(least, from_side(x, a, b));
    }
    return over ? std::min(least, std::fabs(dot(normal, minus(x, t[0]))) / std::sqrt(dot(normal, normal)))
                : least;
}

double distance(const Point &x, const Arrays &all) {
    double least = INFINITY;
    for (size_t i = 0; i < all.welded.size(); i += 3) {
        std::array<Point, 3> t;
        for (size_t k = 0; k < 3; ++k) {
            std::copy_n(&all.xyz[3 * static_cast<size_t>(all.welded[i + k])], 3, t[k].begin());
        }
        least = std::min(least, distance(x, t));
    }
    return least;
}

bool all_in_use(const Arrays &all) {
    std::vector<bool> used(static_cast<size_t>(all.points));
    for (const int64_t point : all.welded) {
        used[static_cast<size_t>(point)] = true;
    }
    return std::ranges::find(used, false) == used.end();
}

// Of splines with numbers of ordinary sizes, no part of which is a closed strip of one cell.
void check_places(Input &in, const nurbs *g, const fuzz::Spline &s, const Arrays &all) {
    if (all.reached == 0 || !all_in_use(all) || !s.weights.empty() || all.triangles > 100 ||
        !(s.size() > 1e-100 && s.size() < 1e100)) {
        return;
    }
    for (int k = 0; k < 8; ++k) {
        const std::vector<double> at = fuzz::any_params(in, g, 2, 1, true);
        Point x{};
        FUZZ_REQUIRE(nurbs_eval(g, 1, at.data(), 0, 0, x.data(), 0, 0, 0) == NURBS_OK);
        FUZZ_REQUIRE(distance(x, all) <= all.from_shape * (1 + 1e-9) + 1e-6 * s.size());
    }
}

// A part of the domain: a square in it, with a hole or without.
Face any_face(Input &in, const nurbs *g) {
    double u[2], v[2];
    if (!FUZZ_OK(nurbs_domain(g, 0, u)) || !FUZZ_OK(nurbs_domain(g, 1, v))) {
        return nullptr;
    }
    const auto square = [&](double low, double high) {
        const double knots[] = {0, 0, 1, 2, 3, 4, 4};
        const double share[][2] = {{low, low}, {high, low}, {high, high}, {low, high}, {low, low}};
        double places[10];
        for (size_t i = 0; i < 5; ++i) {
            places[2 * i] = u[0] + share[i][0] * (u[1] - u[0]);
            places[2 * i + 1] = v[0] + share[i][1] * (v[1] - v[0]);
        }
        const int32_t degree = 1;
        const int64_t count = 5;
        nurbs *curve = nullptr;
        FUZZ_OK(nurbs_create(1, &degree, &count, knots, 7, 2, places, 0, 0, nullptr, 0, 0, &curve));
        return fuzz::Handle(curve);
    };
    const double low = in.unit() / 4;
    const fuzz::Handle outer = square(low, 1 - in.unit() / 4), inner = square(0.4, 0.4 + in.unit() / 5);
    if (!outer || !inner) {
        return nullptr;
    }
    const nurbs *curves[] = {outer.get(), inner.get()};
    const int64_t sizes[] = {1, 1}, loops = in.below(3);
    nurbs_face *face = nullptr;
    FUZZ_OK(nurbs_face_create(g, loops, sizes, curves, nullptr, nullptr, std::ldexp(1, -in.below(30)), 0,
                              nullptr, &face));
    return Face(face);
}

// All or none; without a limit of work that is reached, each as by itself. levels(plain, chords, meshes), single(options, mesh).
template <class Levels, class Single>
void mesh_levels(Input &in, const nurbs_mesh_options *options, double size, Levels &&levels,
                 Single &&single) {
    const double chords[] = {std::ldexp(size, -in.below(7)), in.rarely() ? in.anything() : size};
    std::array<nurbs_mesh *, 2> made{};
    const bool done = FUZZ_OK(levels(in.rarely() && options == nullptr, chords, made.data()));
    const Mesh first(made[0]), second(made[1]);
    FUZZ_REQUIRE((first != nullptr) == done && (second != nullptr) == done);
    if (!done || arrays_of(first.get()).reached == 0 || arrays_of(first.get()).triangles > 1000) {
        return;
    }
    check(first.get());
    nurbs_mesh_options own{};
    FUZZ_REQUIRE(nurbs_mesh_options_init(&own, sizeof own) == NURBS_OK);
    own = options == nullptr ? own : *options;
    own.chord = chords[0];
    own.relative_chord = 0;
    nurbs_mesh *alone = nullptr;
    FUZZ_REQUIRE(single(&own, &alone) == NURBS_OK);
    const Mesh other(alone);
    FUZZ_REQUIRE(arrays_of(alone).reached == 1);
}

void mesh_faces(Input &in, const nurbs *g, const nurbs_mesh_options *options,
                const nurbs_call_options *call) {
    const Face face = any_face(in, g);
    if (!face) {
        return;
    }
    const bool plain = in.rarely();
    nurbs_mesh *mesh = nullptr;
    FUZZ_OK(plain && options == nullptr ? nurbs_mesh_face(face.get(), options, &mesh)
                                        : nurbs_mesh_face_with(face.get(), options, call, &mesh));
    if (const Mesh own(mesh); own) {
        FUZZ_REQUIRE(check(own.get()).faces == 1);
    }
    if (in.rarely()) {
        mesh_levels(
            in, options, 1,
            [&](bool bare, const double *chords, nurbs_mesh **out) {
                return bare ? nurbs_mesh_face_levels(face.get(), 2, chords, options, out)
                            : nurbs_mesh_face_levels_with(face.get(), 2, chords, options, call, out);
            },
            [&](const nurbs_mesh_options *own, nurbs_mesh **out) {
                return nurbs_mesh_face(face.get(), own, out);
            });
    }
    const nurbs_face *faces[] = {face.get(), face.get()};
    nurbs_model *model = nullptr;
    if (in.coin() || !FUZZ_OK(nurbs_model_create(2, faces, 0, &model))) { // of faces in the plane
        return;
    }
    const Model parts(model);
    if (in.rarely()) {
        mesh_levels(
            in, options, 1,
            [&](bool bare, const double *chords, nurbs_mesh **out) {
                return bare ? nurbs_mesh_model_levels(model, 2, chords, options, out)
                            : nurbs_mesh_model_levels_with(model, 2, chords, options, call, out);
            },
            [&](const nurbs_mesh_options *own, nurbs_mesh **out) {
                return nurbs_mesh_model(model, own, out);
            });
    }
    mesh = nullptr;
    FUZZ_OK(plain && options == nullptr ? nurbs_mesh_model(model, options, &mesh)
                                        : nurbs_mesh_model_with(model, options, call, &mesh));
    if (const Mesh own(mesh); own) {
        FUZZ_REQUIRE(check(own.get()).faces == 2);
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Input in(data, size);
    fuzz::Spline s;
    fuzz::add_axes(in, s, in.rarely() ? 1 : 2);
    fuzz::add_values(in, s, in.rarely() ? 1 : 2 + in.below(2));
    const fuzz::Handle g(fuzz::create(s));
    if (!g) {
        return 0;
    }
    nurbs_call_options call;
    FUZZ_REQUIRE(nurbs_call_options_init(&call, sizeof call) == NURBS_OK);
    call.work = int64_t{1} << (8 + in.below(13));
    const nurbs_mesh_options given = any_options(in, s.size());
    const nurbs_mesh_options *options = in.rarely() ? nullptr : &given;
    nurbs_mesh *mesh = nullptr;
    if (FUZZ_OK(nurbs_mesh_surface_with(g.get(), options, &call, &mesh))) {
        const Mesh own(mesh);
        const Arrays all = check(mesh);
        check_places(in, g.get(), s, all);
        if (all.triangles < 100 && in.rarely()) {
            write_anywhere(in, mesh);
        }
        const bool by_refinement = options != nullptr && options->minimum_angle > 0;
        if (all.reached == 1 && !by_refinement &&
            in.below(4) == 0) { // a call without a limit reaches it, too
            nurbs_mesh *again = nullptr;
            FUZZ_REQUIRE(nurbs_mesh_surface(g.get(), options, &again) == NURBS_OK);
            const Mesh other(again);
            FUZZ_REQUIRE(arrays_of(again).reached == 1);
        }
    } else {
        FUZZ_REQUIRE(mesh == nullptr);
    }
    if (in.rarely()) {
        mesh_levels(
            in, options, s.size(),
            [&](bool bare, const double *chords, nurbs_mesh **out) {
                return bare ? nurbs_mesh_surface_levels(g.get(), 2, chords, options, out)
                            : nurbs_mesh_surface_levels_with(g.get(), 2, chords, options, &call, out);
            },
            [&](const nurbs_mesh_options *own, nurbs_mesh **out) {
                return nurbs_mesh_surface(g.get(), own, out);
            });
    }
    if (s.axes() == 2 && in.coin()) { // half of the time would be theirs
        mesh_faces(in, g.get(), options, &call);
    }
    return 0;
}
