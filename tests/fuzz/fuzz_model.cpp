// Models: any bytes go through nurbs_read_model(), and make faces of planes and of surfaces that close up, whose edges share
// keys as they should and as they should not. Whatever model comes out is complete: its numbers name what it holds.
#include "fuzz/harness.h"

#include <cmath>
#include <memory>
#include <string>

using fuzz::Input;

namespace {

struct Deleter {
    void operator()(nurbs_face *face) const { nurbs_face_destroy(face); }
    void operator()(nurbs_model *model) const { nurbs_model_destroy(model); }
    void operator()(nurbs_list *list) const { nurbs_list_destroy(list); }
};
using Face = std::unique_ptr<nurbs_face, Deleter>;
using Model = std::unique_ptr<nurbs_model, Deleter>;
using List = std::unique_ptr<nurbs_list, Deleter>;

Model made(nurbs_status status, nurbs_model *const &out, int line) {
    if (fuzz::succeeded(status, line) != (out != nullptr)) {
        fuzz::violated("status and model disagree", line);
    }
    return Model(out);
}
#define MODEL_MADE(call, out) made(call, out, __LINE__)

// Plain forms of calls that have been made with a limit have none: some inputs are given to them.
bool is_one_of_eight(const uint8_t *data, size_t size) {
    unsigned sum = 0;
    for (size_t i = 0; i < size; ++i) {
        sum += data[i];
    }
    return sum % 8 == 0;
}

// What takes long ends.
nurbs_call_options limited(int64_t work) {
    nurbs_call_options call;
    FUZZ_REQUIRE(nurbs_call_options_init(&call, sizeof call) == NURBS_OK);
    call.work = work;
    return call;
}

constexpr double full_turn = 6.283185307179586;

// --- What a model holds.

struct Counts {
    int64_t parts = -1, uses = -1, faces = -1, edges = -1, vertices = -1;
};

Counts counts_of(const nurbs_model *model) {
    Counts n;
    FUZZ_REQUIRE(nurbs_model_counts(model, &n.parts, &n.uses, &n.faces, &n.edges, &n.vertices) == NURBS_OK);
    FUZZ_REQUIRE(n.parts >= 0 && n.uses >= 0 && n.faces >= 0 && n.edges >= 0 && n.vertices >= 0);
    return n;
}

bool among(int64_t index, int64_t count) {
    return 0 <= index && index < count;
}

Face face_of(const nurbs_model *model, const Counts &n, int64_t index) {
    int64_t part = -1;
    int32_t shape = -1, against = -1;
    double colour[3] = {0, 0, 0};
    nurbs_face *face = nullptr;
    FUZZ_REQUIRE(nurbs_model_face(model, index, &part, &shape, &against, colour, &face) == NURBS_OK);
    FUZZ_REQUIRE(among(part, n.parts) && (against == 0 || against == 1));
    FUZZ_REQUIRE(NURBS_SHAPE_NONE <= shape && shape <= NURBS_SHAPE_OFFSET);
    for (const double part_of_light : colour) {
        FUZZ_REQUIRE(!(part_of_light < 0) && !(part_of_light > 1));
    }
    return Face(face);
}

std::vector<int64_t> loops_of(const nurbs_face *face) {
    int64_t count = -1;
    FUZZ_REQUIRE(nurbs_face_loops(face, 0, nullptr, &count) == NURBS_OK && count >= 0);
    std::vector<int64_t> sizes(static_cast<size_t>(count));
    FUZZ_REQUIRE(nurbs_face_loops(face, count, sizes.data(), nullptr) == NURBS_OK);
    return sizes;
}

// The number of coedges of all faces.
int64_t use_faces(const nurbs_model *model, const Counts &n) {
    int64_t coedges = 0;
    for (int64_t i = 0; i < n.faces; ++i) {
        const Face face = face_of(model, n, i);
        for (const int64_t size : loops_of(face.get())) {
            coedges += size;
        }
        char name[8];
        int64_t length = -1;
        FUZZ_REQUIRE(nurbs_model_face_name(model, i, name, sizeof name, &length) == NURBS_OK && length > 0);
        const nurbs_call_options call = limited(300'000);
        double area = 0;
        FUZZ_OK(nurbs_face_area_with(face.get(), 1e-3, &area, nullptr, &call));
    }
    return coedges;
}

void use_edge(const nurbs_model *model, const Counts &n, int64_t index) {
    int64_t part = -1, ends[2] = {-2, -2};
    int32_t shape = -1, axes = 0;
    nurbs *g = nullptr;
    const fuzz::Handle edge(FUZZ_MADE(nurbs_model_edge(model, index, &part, ends, &shape, &g), g));
    FUZZ_REQUIRE(edge && nurbs_axes(edge.get(), &axes) == NURBS_OK && axes == 1);
    FUZZ_REQUIRE(among(part, n.parts) && among(ends[0] + 1, n.vertices + 1) &&
                 among(ends[1] + 1, n.vertices + 1));
    FUZZ_REQUIRE(NURBS_SHAPE_NONE <= shape && shape <= NURBS_SHAPE_HYPERBOLA);
}

// Every place is that of a coedge: the number of them.
int64_t use_places(const nurbs_model *model, const Counts &n, int64_t edge) {
    int64_t count = -1;
    FUZZ_REQUIRE(nurbs_model_edge_uses(model, edge, 0, nullptr, &count) == NURBS_OK && count >= 0);
    std::vector<int64_t> places(static_cast<size_t>(3 * count));
    FUZZ_REQUIRE(nurbs_model_edge_uses(model, edge, count, places.data(), nullptr) == NURBS_OK);
    for (size_t i = 0; i < places.size(); i += 3) {
        FUZZ_REQUIRE(among(places[i], n.faces));
        const std::vector<int64_t> sizes = loops_of(face_of(model, n, places[i]).get());
        FUZZ_REQUIRE(among(places[i + 1], std::ssize(sizes)));
        FUZZ_REQUIRE(among(places[i + 2], sizes[static_cast<size_t>(places[i + 1])]));
    }
    return count;
}

void use_parts(const nurbs_model *model, const Counts &n) {
    char name[8];
    for (int64_t i = 0; i < n.parts; ++i) {
        FUZZ_REQUIRE(nurbs_model_part(model, i, name, sizeof name, nullptr) == NURBS_OK);
    }
    for (int64_t i = 0; i < n.uses; ++i) {
        int64_t parent = -2, part = -2;
        double placement[12];
        FUZZ_REQUIRE(nurbs_model_use(model, i, &parent, &part, placement) == NURBS_OK);
        FUZZ_REQUIRE(among(parent + 1, n.parts + 1) && among(part, n.parts));
    }
}

// In how many layers it is, all of them rising numbers of layers that there are.
template <class Layers>
void use_layers_of(Layers layers_of, int64_t layers) {
    int64_t count = -1, before = -1;
    FUZZ_REQUIRE(layers_of(0, nullptr, &count) == NURBS_OK && among(count, layers + 1));
    std::vector<int64_t> own(static_cast<size_t>(count));
    FUZZ_REQUIRE(layers_of(count, own.data(), nullptr) == NURBS_OK);
    for (const int64_t layer : own) {
        FUZZ_REQUIRE(before < layer && layer < layers);
        before = layer;
    }
}

void use_layers(const nurbs_model *model, const Counts &n) {
    int64_t layers = -1, splines = -1;
    FUZZ_REQUIRE(nurbs_model_layer_count(model, &layers) == NURBS_OK && layers >= 0);
    for (int64_t i = 0; i < layers; ++i) {
        char name[8];
        FUZZ_REQUIRE(nurbs_model_layer(model, i, name, sizeof name, nullptr) == NURBS_OK);
    }
    for (int64_t i = 0; i < n.faces; ++i) {
        use_layers_of([&](int64_t cap, int64_t *own,
                          int64_t *count) { return nurbs_model_face_layers(model, i, cap, own, count); },
                      layers);
    }
    nurbs_list *out = nullptr;
    FUZZ_REQUIRE(nurbs_model_splines(model, &out) == NURBS_OK);
    const List list(out);
    FUZZ_REQUIRE(nurbs_list_count(list.get(), &splines) == NURBS_OK);
    for (int64_t i = 0; i < splines; ++i) {
        use_layers_of([&](int64_t cap, int64_t *own,
                          int64_t *count) { return nurbs_model_spline_layers(model, i, cap, own, count); },
                      layers);
    }
}

// Numbers of solids begin at 0, in the order of their first faces.
void use_solids(const nurbs_model *model, const Counts &n) {
    int64_t next = 0;
    for (int64_t i = 0; i < n.faces; ++i) {
        int64_t solid = -2;
        int32_t in_void = -1;
        FUZZ_REQUIRE(nurbs_model_face_solid(model, i, &solid, &in_void) == NURBS_OK);
        FUZZ_REQUIRE(among(solid + 1, next + 2) && (in_void == 0 || (in_void == 1 && solid >= 0)));
        next = solid == next ? next + 1 : next;
    }
}

int64_t use_instances(const nurbs_model *model, const Counts &n) {
    int64_t count = 0;
    if (!FUZZ_OK(nurbs_model_instances(model, 0, nullptr, nullptr, nullptr, nullptr, &count)) ||
        count > 1000) {
        return -1;
    }
    const auto size = static_cast<size_t>(count);
    std::vector<int64_t> parents(size), uses(size), parts(size);
    std::vector<double> placements(12 * size);
    FUZZ_REQUIRE(nurbs_model_instances(model, count, parents.data(), uses.data(), parts.data(),
                                       placements.data(), nullptr) == NURBS_OK);
    for (int64_t i = 0; i < count; ++i) {
        const auto at = static_cast<size_t>(i);
        FUZZ_REQUIRE(among(parents[at] + 1, i + 1) && among(uses[at], n.uses) && among(parts[at], n.parts));
    }
    return count;
}

// What a place says is there, unless there are no faces.
void use_nearest(const nurbs_model *model, const Counts &n, bool plain) {
    if (n.faces > 12) {
        return;
    }
    const double from[] = {0.3, 0.4, 5, -3, 0.2, 0.1};
    double params[4], feet[6], distances[2];
    int32_t status[2];
    int64_t places[4];
    const nurbs_call_options call = limited(3'000'000);
    if (!FUZZ_OK(nurbs_model_closest_points_with(model, 2, from, 0, 0, 1e-6, params, feet, distances, status,
                                                 places, &call))) {
        return;
    }
    for (size_t i = 0; i < 2; ++i) {
        FUZZ_REQUIRE(std::isinf(distances[i]) || among(places[2 * i], n.faces));
        FUZZ_REQUIRE(std::isnan(params[2 * i]) == (places[2 * i] == -1));
    }
    double distance = -1;
    if (plain && (status[0] & NURBS_CLOSEST_CERTIFIED) != 0 &&
        FUZZ_OK(nurbs_model_closest_points(model, 1, from, 0, 0, 1e-6, nullptr, nullptr, &distance, nullptr,
                                           nullptr))) {
        FUZZ_REQUIRE(distance <= distances[0] + 1e-6 + 1e-9 * distance);
    }
}

// What a place says is there; a point inside has something on every side of it.
void use_rays(const nurbs_model *model, const Counts &n, bool plain) {
    const int64_t instances = use_instances(model, n);
    const double from[] = {0.3, 0.4, 5, -3, 0.2, 0.1}, along[] = {0, 0.05, -1, 1, 0.1, 0.05};
    if (instances < 0 || n.faces > 12) {
        return;
    }
    double t[2] = {0, 0};
    int32_t status[2] = {0, 0}, complete = -1;
    int64_t places[4] = {0, 0, 0, 0}, count = -1;
    const nurbs_call_options call = limited(3'000'000);
    if ((plain && !FUZZ_OK(nurbs_model_rays(model, 1, from, along, nullptr, t, status, places))) ||
        !FUZZ_OK(nurbs_model_rays_with(model, 2, from, along, nullptr, t, status, places, &call))) {
        return;
    }
    for (size_t i = 0; i < 2; ++i) {
        const bool found = (status[i] & (NURBS_RAY_HIT | NURBS_RAY_TOUCH)) != 0;
        FUZZ_REQUIRE(found == !std::isnan(t[i]));
        FUZZ_REQUIRE(found ? among(places[2 * i], n.faces) && among(places[2 * i + 1], instances)
                           : places[2 * i] == -1 && places[2 * i + 1] == -1);
    }
    FUZZ_OK(nurbs_model_ray_hits_with(model, from, along, nullptr, 0, nullptr, nullptr, nullptr, nullptr,
                                      &count, &complete, &call));
    if (plain) {
        FUZZ_OK(nurbs_model_ray_hits(model, from, along, nullptr, 0, nullptr, nullptr, nullptr, nullptr,
                                     &count, &complete));
        FUZZ_REQUIRE(count >= 0 && (complete == 0 || complete == 1));
    }
    int32_t side = 7;
    if (plain && FUZZ_OK(nurbs_model_classify_with(model, 1, from, 0, 0, 1e-3, &side, &call))) {
        FUZZ_REQUIRE(-1 <= side && side <= 2);
        const int32_t before = side;
        FUZZ_REQUIRE(nurbs_model_classify(model, 1, from, 0, 0, 1e-3, &side) == NURBS_OK);
        FUZZ_REQUIRE(side == before || before == NURBS_SIDE_UNDECIDED);
        FUZZ_REQUIRE(side != NURBS_SIDE_INSIDE || count > 0);
    }
}

// What is held has a surface around it.
void use_volume(const nurbs_model *model, const Counts &n, bool plain) {
    const int64_t instances = use_instances(model, n);
    if (instances < 0 || instances > 16 || n.faces > 8) {
        return;
    }
    const nurbs_call_options call = limited(3'000'000);
    double area = -1, again = -1, volume = -1, centroid[3], inertia[9], openness = -1, error = -1;
    const bool measured = FUZZ_OK(nurbs_model_area_with(model, 1e-3, &area, &error, &call));
    FUZZ_REQUIRE(!measured || (area >= 0 && error >= 0));
    FUZZ_REQUIRE(!measured || !plain ||
                 (nurbs_model_area(model, 1e-3, &again, nullptr) == NURBS_OK && again == area));
    if (FUZZ_OK(nurbs_model_volume_with(model, 1e-3, &volume, nullptr, nullptr, &openness, &error, &call))) {
        FUZZ_REQUIRE(volume >= 0 && error >= 0 && openness >= 0);
        FUZZ_REQUIRE(!measured || area > 0 || volume == 0);
        if (plain) {
            FUZZ_OK(nurbs_model_volume(model, 1e-3, &volume, centroid, inertia, nullptr, nullptr));
        }
    }
}

// Ways are made of all branches, and what goes on in another comes back; more work tells no less.
void look_at_sections(const nurbs_meet *meet, const Counts &n, int64_t instances) {
    int64_t branches = -1, nodes = -1, count = -1, sum = 0;
    int32_t complete = -1;
    FUZZ_REQUIRE(nurbs_meet_counts(meet, &branches, &nodes, &complete) == NURBS_OK);
    FUZZ_REQUIRE(nurbs_meet_ways(meet, 0, nullptr, nullptr, nullptr, nullptr, nullptr, &count) == NURBS_OK);
    const auto ways = static_cast<size_t>(count), of_nodes = static_cast<size_t>(nodes),
               of_branches = static_cast<size_t>(branches);
    std::vector<int64_t> sizes(ways), faces(of_branches), places(of_branches), next(of_nodes);
    std::vector<double> gaps(of_nodes);
    FUZZ_REQUIRE(nurbs_meet_ways(meet, count, nullptr, nullptr, sizes.data(), nullptr, nullptr, nullptr) ==
                 NURBS_OK);
    FUZZ_REQUIRE(nurbs_meet_faces(meet, branches, faces.data(), places.data(), nullptr) == NURBS_OK);
    FUZZ_REQUIRE(nurbs_meet_joints(meet, nodes, next.data(), gaps.data(), nullptr, nullptr, nullptr) ==
                 NURBS_OK);
    for (const int64_t size : sizes) {
        FUZZ_REQUIRE(size > 0);
        sum += size;
    }
    FUZZ_REQUIRE(sum == branches);
    for (size_t i = 0; i < of_branches; ++i) {
        FUZZ_REQUIRE(among(faces[i], n.faces) && among(places[i], instances));
    }
    for (size_t i = 0; i < of_nodes; ++i) {
        FUZZ_REQUIRE(next[i] == -1 || (among(next[i], nodes) && gaps[i] >= 0 &&
                                       next[static_cast<size_t>(next[i])] == static_cast<int64_t>(i)));
    }
}

void use_sections(const nurbs_model *model, const Counts &n, bool plain) {
    const int64_t instances = use_instances(model, n);
    const double normals[] = {0, 0, 1, 0.6, 0, 0.8}, offsets[] = {0.5, 0.25};
    if (instances < 0 || instances > 16 || n.faces > 8) {
        return;
    }
    const nurbs_call_options call = limited(3'000'000);
    nurbs_meet *meet = nullptr;
    if (FUZZ_OK(nurbs_model_sections_with(model, 2, normals, offsets, 1e-3, &call, &meet))) {
        look_at_sections(meet, n, instances);
        nurbs_meet_destroy(meet);
        if (plain && FUZZ_OK(nurbs_model_sections(model, 1, normals, offsets, 1e-3, &meet))) {
            look_at_sections(meet, n, instances);
            nurbs_meet_destroy(meet);
        }
    }
}

// A floor through what is read.
Model floor_model() {
    const double origin[] = {-100, -100, 0.25}, u[] = {200, 0, 1}, v[] = {0, 200, 0};
    nurbs *g = nullptr;
    FUZZ_REQUIRE(nurbs_surface_plane(3, origin, u, v, &g) == NURBS_OK);
    const fuzz::Handle surface(g);
    nurbs_face *face = nullptr;
    nurbs_model *model = nullptr;
    FUZZ_REQUIRE(nurbs_face_create(g, 0, nullptr, nullptr, nullptr, nullptr, 1e-6, 0, nullptr, &face) ==
                 NURBS_OK);
    const nurbs_status status = nurbs_model_create(1, &face, 1, &model);
    nurbs_face_destroy(face);
    FUZZ_REQUIRE(status == NURBS_OK);
    return Model(model);
}

void use_meets(const nurbs_model *model, const Counts &n, bool plain) {
    const int64_t instances = use_instances(model, n);
    if (instances < 0 || instances > 16 || n.faces > 8) {
        return;
    }
    static const Model ground = floor_model();
    const nurbs_call_options call = limited(3'000'000);
    nurbs_meet *meet = nullptr;
    if (!FUZZ_OK(plain ? nurbs_model_intersections(model, ground.get(), 1e-3, &meet)
                       : nurbs_model_intersections_with(model, ground.get(), 1e-3, &call, &meet))) {
        FUZZ_REQUIRE(meet == nullptr);
        return;
    }
    look_at_sections(meet, n, instances);
    int64_t branches = 0, nodes = 0;
    FUZZ_REQUIRE(nurbs_meet_counts(meet, &branches, &nodes, nullptr) == NURBS_OK);
    std::vector<int64_t> faces(static_cast<size_t>(branches)), of_nodes(static_cast<size_t>(nodes));
    FUZZ_REQUIRE(nurbs_meet_faces_second(meet, branches, faces.data(), nullptr, nullptr) == NURBS_OK);
    FUZZ_REQUIRE(nurbs_meet_joints_second(meet, nodes, of_nodes.data(), nullptr, nullptr) == NURBS_OK);
    FUZZ_REQUIRE(std::ranges::count(faces, 0) == branches && std::ranges::count(of_nodes, 0) == nodes);
    nurbs_meet_destroy(meet);
}

void use(const nurbs_model *model, bool all_edges, bool plain) {
    const Counts n = counts_of(model);
    use_layers(model, n);
    use_solids(model, n);
    const int64_t coedges = use_faces(model, n);
    int64_t places = 0;
    for (int64_t i = 0; i < n.edges; ++i) {
        use_edge(model, n, i);
        places += use_places(model, n, i);
    }
    FUZZ_REQUIRE(all_edges ? places == coedges : places <= coedges);
    for (int64_t i = 0; i < n.vertices; ++i) {
        double point[3];
        FUZZ_REQUIRE(nurbs_model_vertex(model, i, point) == NURBS_OK);
    }
    use_parts(model, n);
    use_rays(model, n, plain);
    use_nearest(model, n, plain);
    use_volume(model, n, plain);
    use_sections(model, n, plain);
    use_meets(model, n, plain);
    nurbs_list *list = nullptr;
    FUZZ_REQUIRE(nurbs_model_splines(model, &list) == NURBS_OK && list != nullptr);
    const List owner(list);
    double metres = -1;
    FUZZ_REQUIRE(nurbs_list_unit(list, &metres) == NURBS_OK && metres >= 0);
}

// What is not there is refused.
void beyond(Input &in, const nurbs_model *model) {
    const int64_t index = in.coin() ? in.bad_size() : 1'000'000;
    double values[12];
    nurbs *edge = fuzz::poison();
    FUZZ_REQUIRE(!FUZZ_OK(nurbs_model_vertex(model, index, values)));
    FUZZ_REQUIRE(!FUZZ_OK(nurbs_model_use(model, index, nullptr, nullptr, values)));
    FUZZ_REQUIRE(!FUZZ_OK(nurbs_model_edge(model, index, nullptr, nullptr, nullptr, &edge)) &&
                 edge == nullptr);
    FUZZ_REQUIRE(!FUZZ_OK(nurbs_model_edge_uses(model, index, 0, nullptr, nullptr)));
    FUZZ_REQUIRE(!FUZZ_OK(nurbs_model_face_name(model, index, nullptr, 0, nullptr)));
    FUZZ_REQUIRE(!FUZZ_OK(nurbs_model_part(model, index, nullptr, 0, nullptr)));
}

// --- Models of files.

void read_any(const uint8_t *data, size_t size, double unit, bool used, bool plain) {
    nurbs_read_options options;
    FUZZ_REQUIRE(nurbs_read_options_init(&options, sizeof options) == NURBS_OK);
    options.unit = unit;
    const nurbs_call_options call = limited(3'000'000);
    nurbs_model *out = reinterpret_cast<nurbs_model *>(fuzz::poison());
    const Model model =
        MODEL_MADE(nurbs_read_model_with(data, static_cast<int64_t>(size), &options, &call, &out), out);
    if (model && used) {
        use(model.get(), false, plain);
    }
}

void read_without_options(const uint8_t *data, size_t size) {
    nurbs_model *out = nullptr;
    const std::string path = "/nonexistent/" + std::string(data, data + std::min<size_t>(size, 300));
    FUZZ_REQUIRE(nurbs_read_model_file(path.c_str(), nullptr, &out) == NURBS_ERROR_FILE && out == nullptr);
    FUZZ_REQUIRE(nurbs_read_model_file_with(path.c_str(), nullptr, nullptr, &out) == NURBS_ERROR_FILE);
    if (size < 64) { // too short for geometry
        const Model model =
            MODEL_MADE(nurbs_read_model(data, static_cast<int64_t>(size), nullptr, &out), out);
    }
}

// --- Models of faces.

nurbs *any_surface(Input &in, bool &flat) {
    nurbs *g = nullptr;
    static constexpr double origin[] = {0, 0, 0}, u[] = {1, 0, 0}, v[] = {0, 1, 0}, w[] = {0, 0, 1};
    const int kind = in.below(8);
    flat = kind < 5;
    switch (kind) {
    case 5:
        FUZZ_REQUIRE(nurbs_surface_sphere(nullptr, nullptr, nullptr, 1, in.below(2), &g) == NURBS_OK);
        return g;
    case 6:
        FUZZ_REQUIRE(nurbs_surface_cylinder(nullptr, nullptr, nullptr, 1, 2, 0, full_turn, 0, &g) ==
                     NURBS_OK);
        return g;
    case 7:
        return fuzz::create(fuzz::any_spline(in));
    default:
        FUZZ_REQUIRE(nurbs_surface_plane(3, origin, kind < 3 ? u : v, kind < 3 ? v : w, &g) == NURBS_OK);
        return g;
    }
}

nurbs *segment(double u0, double v0, double u1, double v1) {
    static constexpr int32_t degree = 1;
    static constexpr int64_t count = 2;
    const double knots[] = {0, 0, 1, 1}, points[] = {u0, v0, u1, v1};
    nurbs *g = nullptr;
    FUZZ_REQUIRE(nurbs_create(1, &degree, &count, knots, 4, 2, points, 0, 0, nullptr, 0, 0, &g) == NURBS_OK);
    return g;
}

// A square whose sides have any keys, or all that a surface has.
Face any_face(Input &in) {
    bool flat = false;
    const fuzz::Handle surface(any_surface(in, flat));
    if (!surface) {
        return nullptr;
    }
    nurbs_face *face = nullptr;
    const nurbs_call_options call = limited(300'000);
    if (!flat) {
        FUZZ_OK(nurbs_face_create_with(surface.get(), 0, nullptr, nullptr, nullptr, nullptr, 1e-9, 0, nullptr,
                                       &call, &face));
        return Face(face);
    }
    const double low = in.below(4) / 8.0, high = 1 - in.below(4) / 8.0;
    const fuzz::Handle sides[] = {
        fuzz::Handle(segment(low, low, high, low)), fuzz::Handle(segment(high, low, high, high)),
        fuzz::Handle(segment(high, high, low, high)), fuzz::Handle(segment(low, high, low, low))};
    const nurbs *curves[4];
    int64_t keys[4];
    for (size_t i = 0; i < 4; ++i) {
        curves[i] = sides[i].get();
        keys[i] = in.rarely() ? -(in.bad_size() / 2) : in.below(9) - 4;
    }
    const int64_t four = 4;
    FUZZ_OK(nurbs_face_create_with(surface.get(), 1, &four, curves, nullptr, keys, 1e-9, 0, nullptr, &call,
                                   &face));
    return Face(face);
}

// Faces keep their numbers, edges have the uses that they tell, and what is sewn can be sewn again.
void sew(Input &in, const std::vector<const nurbs_face *> &given, bool plain) {
    const nurbs_call_options call = limited(2'000'000);
    const double tolerance = in.rarely() ? in.anything() : std::ldexp(1, -in.below(30));
    nurbs_model *out = reinterpret_cast<nurbs_model *>(fuzz::poison());
    Model model = MODEL_MADE(
        nurbs_model_sew_with(std::ssize(given), given.data(), tolerance, in.below(2), &call, &out), out);
    if (!model) {
        return;
    }
    const Counts n = counts_of(model.get());
    FUZZ_REQUIRE(n.faces == std::ssize(given));
    std::vector<int64_t> uses(static_cast<size_t>(n.edges));
    std::vector<double> gaps(uses.size());
    FUZZ_REQUIRE(nurbs_model_edge_gaps(model.get(), n.edges, uses.data(), nullptr, nullptr, nullptr) ==
                 NURBS_OK);
    for (int64_t i = 0; i < n.edges; ++i) {
        FUZZ_REQUIRE(use_places(model.get(), n, i) == uses[static_cast<size_t>(i)]);
        use_edge(model.get(), n, i);
    }
    if (n.faces <= 3 &&
        FUZZ_OK(nurbs_model_edge_gaps(model.get(), n.edges, nullptr, gaps.data(), nullptr, nullptr))) {
        for (const double gap : gaps) {
            FUZZ_REQUIRE(gap >= 0);
        }
    }
    std::vector<Face> faces;
    std::vector<const nurbs_face *> again;
    for (int64_t i = 0; i < n.faces; ++i) {
        faces.push_back(face_of(model.get(), n, i));
        again.push_back(faces.back().get());
    }
    out = nullptr;
    model = MODEL_MADE(plain && n.faces <= 2
                           ? nurbs_model_sew(n.faces, again.data(), tolerance, 0, &out)
                           : nurbs_model_sew_with(n.faces, again.data(), tolerance, 0, &call, &out),
                       out);
    FUZZ_REQUIRE(!model || counts_of(model.get()).faces == n.faces);
}

void of_faces(Input &in, bool plain) {
    std::vector<Face> faces;
    std::vector<const nurbs_face *> given;
    for (int i = in.below(7); i > 0; --i) {
        if (Face face = any_face(in)) {
            given.push_back(face.get());
            faces.push_back(std::move(face));
        }
    }
    if (in.rarely()) {
        given.push_back(nullptr);
    }
    const int64_t count = in.rarely() && given.empty() ? in.bad_size() : std::ssize(given);
    const double metres = in.rarely() ? in.anything() : in.below(3);
    nurbs_model *out = reinterpret_cast<nurbs_model *>(fuzz::poison()), *clone = nullptr;
    Model model = MODEL_MADE(nurbs_model_create(count, given.data(), metres, &out), out);
    if (!model) {
        return;
    }
    FUZZ_REQUIRE(nurbs_model_clone(model.get(), &clone) == NURBS_OK);
    model.reset();
    sew(in, given, plain);
    faces.clear();
    const Model kept(clone);
    FUZZ_REQUIRE(counts_of(clone).faces == count);
    use(clone, true, plain);
    beyond(in, clone);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    const bool plain = is_one_of_eight(data, size);
    read_any(data, size, 0, !plain, false);
    read_any(data, size, 0.001, plain, plain);
    read_without_options(data, size);
    Input in(data, size);
    of_faces(in, plain);
    return 0;
}
