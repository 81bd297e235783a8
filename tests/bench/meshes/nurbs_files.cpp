// SPDX-License-Identifier: MIT
// The faces of files meshed by this library.
#include "bench/meshes/job.h"
#include "bench/meshes/nurbs_handles.h"
#include "bench/meshes/programs.h"
#include "bench/meshes/verdict.h"

namespace {

using namespace bench::meshes;

Model read_model(const std::string &path) {
    nurbs_read_options options;
    good(nurbs_read_options_init(&options, sizeof options));
    options.unit = 0.001; // as others have it
    nurbs_model *out = nullptr;
    good(nurbs_read_model_file(path.c_str(), &options, &out));
    return Model(out);
}

Face face_of(const nurbs_model *model, int64_t index) {
    nurbs_face *out = nullptr;
    good(nurbs_model_face(model, index, nullptr, nullptr, nullptr, nullptr, &out));
    return Face(out);
}

int64_t faces_of(const nurbs_model *model) {
    int64_t count = 0;
    good(nurbs_model_counts(model, nullptr, nullptr, &count, nullptr, nullptr));
    return count;
}

// The longest side of the box of all faces.
double size_of(const nurbs_model *model) {
    Point lower{INFINITY, INFINITY, INFINITY}, upper{-INFINITY, -INFINITY, -INFINITY};
    for (int64_t i = 0; i < faces_of(model); ++i) {
        Point low, high;
        good(nurbs_face_box(face_of(model, i).get(), 1e-3, low.data(), high.data(), nullptr));
        for (size_t c = 0; c < 3; ++c) {
            lower[c] = std::min(lower[c], low[c]);
            upper[c] = std::max(upper[c], high[c]);
        }
    }
    const Point sides = upper - lower;
    return std::max({sides[0], sides[1], sides[2]});
}

// The triangles of each face by itself; vertices are those of all.
struct Parts {
    Mesh all;
    std::vector<int64_t> firsts, counts;
    std::vector<int32_t> reaches;
    std::vector<double> bounds;

    explicit Parts(const nurbs_mesh *mesh) : all(arrays_of(mesh)) {
        int64_t faces = 0;
        good(nurbs_mesh_counts(mesh, nullptr, nullptr, nullptr, &faces, nullptr, nullptr));
        firsts.resize(static_cast<size_t>(faces));
        counts.resize(firsts.size());
        reaches.resize(firsts.size());
        bounds.resize(firsts.size());
        good(nurbs_mesh_faces(mesh, faces, nullptr, nullptr, firsts.data(), counts.data(), nullptr,
                              bounds.data(), reaches.data(), nullptr));
    }
    [[nodiscard]] Mesh part(size_t face) const {
        const auto first = all.triangles.begin() + firsts[face];
        return {all.points, all.params, {first, first + counts[face]}};
    }
};

Verdict verdict_of(const nurbs_model *model, const Parts &parts) {
    Verdict verdict;
    for (int64_t i = 0; i < faces_of(model); ++i) {
        const Face face = face_of(model, i);
        nurbs *own = nullptr;
        good(nurbs_face_surface(face.get(), &own));
        const Surface surface(own);
        double area = 0;
        good(nurbs_face_area(face.get(), 1e-4, &area, nullptr));
        const auto at = static_cast<size_t>(i);
        verdict.add(parts.part(at), area, parts.bounds[at], domain_of(own),
                    [&](const Param &param) { return jet_of(own, param); });
    }
    return verdict;
}

} // namespace

void bench::meshes::mesh_file(const std::string &path, double share) {
    Model model = read_model(path);
    const double chord = share * size_of(model.get());
    const nurbs_mesh_options options = limit(chord);
    OwnMesh mesh;
    int64_t triangles = 0, unproven = 0;
    Verdict verdict;
    const Cost cost = cost_of({[&] { model = read_model(path); },
                               [&] {
                                   nurbs_mesh *out = nullptr;
                                   good(nurbs_mesh_model(model.get(), &options, &out));
                                   mesh.reset(out);
                               },
                               [&] {
                                   const Parts parts(mesh.get());
                                   verdict = verdict_of(model.get(), parts);
                                   triangles = static_cast<int64_t>(parts.all.triangles.size());
                                   unproven = std::count(parts.reaches.begin(), parts.reaches.end(), 0);
                               },
                               [&] { mesh = nullptr; }});
    tell(cost, triangles, verdict.told(chord) + ", \"unproven\": " + std::to_string(unproven));
}
