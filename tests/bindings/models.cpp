// SPDX-License-Identifier: MIT
// Models through the C++ wrapper: bushing.step, the path of which is the argument.
#include "expect.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

using namespace libnurbs;

static void is_the_bushing(const Model &model) {
    const ModelCounts n = model.counts();
    EXPECT(n.faces == 4 && n.edges == 6 && n.vertices == 4);
    const ModelFace bore = model.face(1);
    EXPECT(model.face_name(1) == "bore" && bore.shape == shape_cylinder && bore.against);
    EXPECT(near({bore.face.area(1e-12).value}, {24 * pi}));
    const ModelEdge seam = model.edge(4);
    EXPECT(seam.shape == shape_line && (seam.vertices == std::array<std::int64_t, 2>{0, 1}));
    EXPECT((model.edge_uses(4) == std::vector<std::int64_t>{0, 0, 1, 0, 0, 3}));
    EXPECT((model.vertex(1) == std::array<double, 3>{5, 0, 4}));
    const ModelUse whole = model.use(0);
    EXPECT(whole.parent == -1 && whole.part == 0 && whole.placement[0][0] == 1 && whole.placement[0][3] == 0);
    EXPECT(model.splines().unit() == 0.001 && model.splines().size() == 0);
    EXPECT(status_of([&] { (void)model.face(4); }) == Status::index);
}

static void copies(const Model &model) {
    const Model copy = model; // NOLINT: the copy is what is tested
    is_the_bushing(copy);
    const Face faces[] = {ModelFace(model.face(0)).face, ModelFace(model.face(1)).face};
    const Model two = Model::create(faces, 0.001);
    EXPECT(two.counts().faces == 2 && two.face_name(1) == "1" && two.part(0).empty());
    EXPECT(status_of([&] { (void)Model::create(faces, -1); }) == Status::factor);
}

// Its faces know each other again, without their keys.
static void sewn(const Model &model) {
    std::vector<Face> faces;
    for (std::int64_t i = 0; i < 4; ++i) {
        faces.push_back(ModelFace(model.face(i)).face);
    }
    const Model again = Model::sew(faces, 1e-6, 0.001),
                watched = Model::sew(faces, 1e-6, 0.001, CallOptions());
    EXPECT(again.counts().edges == 6 && watched.counts().edges == 6);
    const EdgeGaps gaps = again.edge_gaps();
    EXPECT(gaps.uses == std::vector<std::int64_t>(6, 2) && gaps.bounded == std::vector<std::int32_t>(6, 1));
    EXPECT(*std::max_element(gaps.gaps.begin(), gaps.gaps.end()) < 1e-6);
    EXPECT(status_of([&] { (void)Model::sew(faces, 0); }) == Status::tolerance);
    EXPECT(status_of([&] { (void)Model::sew({}, 1); }) == Status::count);
}

// The same again of what is written, to memory and to a file.
static void written(const Model &model) {
    WriteOptions options;
    const std::vector<std::byte> bytes = model.write(format_step),
                                 again = model.write(format_step, options, {});
    EXPECT(bytes.size() > 1000 && bytes == again);
    is_the_bushing(Model::read(bytes));
    model.write_file("models_cpp.step", format_step);
    is_the_bushing(Model::read_file("models_cpp.step"));
    options.unit = 1;
    EXPECT(Model(Model::read(model.write(format_step, options))).splines().unit() == 1);
    const List list = List::create({}, {}, 0.5);
    EXPECT(List(List::read(list.write(format_step))).unit() == 0.5);
    EXPECT(List(List::read(list.write(format_step, options, {}))).unit() == 1);
    list.write_file("models_cpp.step", format_step, options, {});
    EXPECT(List(List::read_file("models_cpp.step")).unit() == 1);
    EXPECT(status_of([&] { (void)model.write(99); }) == Status::format);
    EXPECT(status_of([&] { model.write_file("/no/such/file", format_step); }) == Status::file);
}

// Of all shapes, for two distances.
static void levels(const Model &model) {
    const Face wall = ModelFace(model.face(0)).face;
    const std::vector<Mesh> all = mesh_levels(model, {1e-1, 1e-2}), same = mesh_levels(model, {1e-2}, {}, {}),
                            one = mesh_levels(wall, {1e-1}), again = mesh_levels(wall, {1e-1}, {}, {}),
                            whole = mesh_levels(wall.surface(), {1e-1}, {}, {});
    EXPECT(all.size() == 2 && same[0].counts().triangles == all[1].counts().triangles);
    EXPECT(one[0].counts().triangles == again[0].counts().triangles && whole.size() == 1);
}

// Its triangles as files.
static void triangles(const Model &model) {
    const Mesh mesh = Mesh::of_model(model);
    WriteOptions options;
    const auto facets = static_cast<std::size_t>(MeshCounts(mesh.counts()).triangles);
    const std::vector<std::byte> contents = mesh.write(format_stl), scene = mesh.write(format_glb),
                                 again = mesh.write(format_glb, options, {}), plain = mesh.write(format_vtu);
    EXPECT(contents.size() == 84 + 50 * facets);
    EXPECT(scene == again);
    options.unit = 0.0254;
    const std::vector<std::byte> inches = mesh.write(format_vtu, options);
    EXPECT(plain != inches);
    mesh.write_file("models_cpp.obj", format_obj);
    mesh.write_file("models_cpp.ply", format_ply, options, {});
    EXPECT(status_of([&] { (void)mesh.write(format_step); }) == Status::format);
    EXPECT(status_of([&] { mesh.write_file("/no/such/file", format_stl_text); }) == Status::file);
}

static void bytes(const Model &model) {
    const std::vector<std::byte> whole = model.to_bytes(), one = model.face(1).face.to_bytes();
    EXPECT(bytes_kind(whole).kind == bytes_model && bytes_kind(one).kind == bytes_face);
    is_the_bushing(Model::from_bytes(whole));
    EXPECT(Face::from_bytes(one).to_bytes() == one);
    EXPECT(status_of([&] { (void)Model::from_bytes(one); }) == Status::format);
    EXPECT(status_of([&] { (void)Face::from_bytes(whole); }) == Status::format);
}

static void rays(const Model &model) {
    const ModelRays first = model.rays({9, 0.1, 2, 0, 0.1, 9}, {-1, 0, 0, 0, 0, -1});
    EXPECT(near({first.distances[0]}, {9 - std::sqrt(24.99)}) && std::isnan(first.distances[1]));
    EXPECT(first.status == (std::vector{ray_hit | ray_certified, ray_certified}));
    EXPECT((first.places == std::vector<std::int64_t>{0, 0, -1, -1}));
    const ModelRayHits through = model.ray_hits({9, 0.1, 2}, {-1, 0, 0});
    EXPECT(through.complete && through.distances.size() == 4 && through.places[2] == 1);
    EXPECT((model.classify({4, 0.1, 2, 0, 0.1, 2}) == std::vector<std::int32_t>{side_inside, side_outside}));
    const ModelInstances whole = model.instances();
    EXPECT(whole.uses.size() == 1 && whole.parents[0] == -1 && whole.placements[5] == 1);
    const Face outside = model.face(0).face;
    const ClosestOnFace foot = outside.closest_points({9, 0, 2}, 1e-9);
    EXPECT(near(foot.distances, {4}, 1e-8) && (foot.status[0] & closest_certified) != 0);
    EXPECT(near({Rays(outside.rays({9, 0.1, 2}, {-1, 0, 0})).distances[0]}, {9 - std::sqrt(24.99)}));
}

// Around the wall outside and, the other way, inside.
static void sections(const Model &model) {
    const Meet meet = Meet::model_sections(model, {0, 0, 1, 0, 0, 1}, {2, 9}, 1e-6);
    const MeetWays ways = meet.ways();
    EXPECT(
        (ways.levels == std::vector<std::int64_t>{0, 0} && ways.closed == std::vector<std::int32_t>{1, 1}));
    EXPECT(ways.firsts[0] == 0 && ways.firsts[1] == ways.sizes[0] && ways.gaps.size() == 2);
    const MeetFaces faces = meet.faces();
    EXPECT(faces.faces.front() == 0 && faces.faces.back() == 1 && faces.instances.front() == 0);
    const MeetJoints joints = meet.joints();
    EXPECT(std::cmp_equal(joints.faces.size(), MeetCounts(meet.counts()).nodes) &&
           joints.gaps.size() == joints.next_nodes.size());
    EXPECT(status_of([&] { (void)Meet::model_sections(model, {0, 0, 0}, {1}, 1e-6); }) == Status::direction);
}

int main(int count, char **arguments) {
    EXPECT(count == 2);
    if (count == 2) {
        const Model model = Model::read_file(arguments[1]);
        is_the_bushing(model);
        copies(model);
        sewn(model);
        written(model);
        levels(model);
        triangles(model);
        bytes(model);
        rays(model);
        sections(model);
    }
    EXPECT(status_of([] { (void)Model::read_file("/no/such/file"); }) == Status::file);
    return failures == 0 ? 0 : 1;
}
