// SPDX-License-Identifier: MIT
// Meshes by this library, through its C interface.
//   bench_meshes_nurbs SHAPE CHORD [MESH]    a shape of shapes.h, and where its mesh is written
//   bench_meshes_nurbs FILE SHARE            all faces of a STEP or IGES file, to this share of its size
#include "bench/meshes/job.h"
#include "bench/meshes/nurbs_handles.h"
#include "bench/meshes/programs.h"

namespace {

using namespace bench::meshes;

struct Shape {
    Kind kind;
    Surface surface;
    Face face;
    OwnMesh mesh;

    // With nothing left of what calls may have kept with the handles.
    void renew() {
        face = nullptr;
        surface = surface_of(kind.surface);
        if (kind.trim != Trim::none) {
            face = face_of(surface.get(), kind.trim);
        }
    }
    void make(double chord) {
        const nurbs_mesh_options options = limit(chord);
        nurbs_call_options call;
        good(nurbs_call_options_init(&call, sizeof call));
        call.work = INT64_MAX;
        nurbs_mesh *out = nullptr;
        good(face ? nurbs_mesh_face_with(face.get(), &options, &call, &out)
                  : nurbs_mesh_surface_with(surface.get(), &options, &call, &out));
        mesh.reset(out);
    }
};

} // namespace

void bench::meshes::mesh_shape(const std::string &name, double chord, const char *path) {
    Shape shape{kind_of(name), nullptr, nullptr, nullptr};
    int64_t triangles = 0;
    double from_shape = 0, from_mesh = 0;
    int32_t reached = 0;
    const Cost cost =
        cost_of({[&] { shape.renew(); }, [&] { shape.make(chord); },
                 [&] {
                     good(nurbs_mesh_counts(shape.mesh.get(), nullptr, nullptr, &triangles, nullptr, nullptr,
                                            nullptr));
                     good(nurbs_mesh_bound(shape.mesh.get(), &from_shape, &from_mesh, &reached));
                     if (path != nullptr) {
                         write(arrays_of(shape.mesh.get()), path);
                     }
                 },
                 [&] { shape.mesh = nullptr; }});
    char more[128];
    std::snprintf(more, sizeof more, ", \"from_shape\": %.17g, \"from_mesh\": %.17g, \"reached\": %d",
                  from_shape, from_mesh, reached);
    tell(cost, triangles, more);
}

int main(int count, char **arguments) {
    return run(count, arguments);
}
