// SPDX-License-Identifier: MIT
// Triangles in place of shapes, and how near they are to be.
#include "checks.h"
#include "guard.h"
#include "structs.h"
#include "watched.h"

#include "mesh/surface_mesh.h"
#include "mesh/volume/volume_mesh.h"
#include "spline/kind.h"

#include <cmath>
#include <numbers>

using namespace nrb;
using namespace nrb::capi;

namespace {

constexpr int64_t usual_hexahedra = int64_t{1} << 20;

// About two million triangles, and more for many control points.
constexpr int64_t usual_work_for_meshes = 4000000000, work_for_a_point = 20000;

void check_limits(const mesh::MeshRule &rule) {
    const bool limited =
        rule.relative > 0 || rule.longest > 0 || (rule.angle > 0 && rule.angle < std::numbers::pi);
    if (!(rule.chord > 0) || (std::isinf(rule.chord) && !limited)) {
        fail(Status::tolerance, "options: chord = %s, expected > 0, and finite without another limit",
             Number(rule.chord).text);
    }
    if (!(rule.relative >= 0) || std::isinf(rule.relative)) {
        fail(Status::tolerance, "options: relative_chord = %s, expected 0, or a share",
             Number(rule.relative).text);
    }
    if (!(rule.longest >= 0) || std::isinf(rule.longest)) {
        fail(Status::length, "options: longest = %s, expected 0, or a length", Number(rule.longest).text);
    }
    if (!(rule.angle >= 0 && rule.angle <= std::numbers::pi)) {
        fail(Status::angle, "options: angle = %s, expected one from 0 to pi", Number(rule.angle).text);
    }
}

mesh::MeshRule usual_rule() noexcept {
    mesh::MeshRule rule;
    rule.relative = 1e-3;
    return rule;
}

mesh::MeshRule rule_of(const nurbs_mesh_options *options) {
    if (options == nullptr) {
        return usual_rule();
    }
    const nurbs_mesh_options &given = checked_struct("options", options);
    const mesh::MeshRule rule{given.chord, given.relative_chord, given.longest, given.angle};
    check_limits(rule);
    return rule;
}

int64_t points_of(const model::Model &model) {
    int64_t points = 0;
    for (const model::ModelFace &face : model.faces) {
        points += face.face->surface()->point_count();
    }
    return points;
}

// At the limit of work the triangles that there are by then are the answer.
template <class Shape>
void give_mesh(const Shape &shape, int64_t points, const nurbs_mesh_options *options, nurbs_mesh **out) {
    const mesh::MeshRule rule = rule_of(options);
    const UsualLimit usual(usual_work_for_meshes + work_for_a_point * points);
    const LimitedSearch limited;
    *out = new nurbs_mesh{mesh::mesh_of(shape, rule)};
}

} // namespace

nurbs_status nurbs_mesh_options_init(nurbs_mesh_options *options, int64_t struct_size) {
    return guard([&] {
        clear_struct("options", options, struct_size);
        const mesh::MeshRule usual = usual_rule();
        options->chord = usual.chord;
        options->relative_chord = usual.relative;
        options->longest = usual.longest;
        options->angle = usual.angle;
    });
}

nurbs_status nurbs_mesh_surface(const nurbs *g, const nurbs_mesh_options *options, nurbs_mesh **out) {
    return guard([&] {
        require_out(out);
        const Spline &surface = surface_of(g);
        check_dimension(surface, 2, 3);
        give_mesh(surface, surface.point_count(), options, out);
    });
}

nurbs_status nurbs_mesh_surface_with(const nurbs *g, const nurbs_mesh_options *options,
                                     const nurbs_call_options *call, nurbs_mesh **out) {
    return watched(call, out, [&] { return nurbs_mesh_surface(g, options, out); });
}

nurbs_status nurbs_mesh_face(const nurbs_face *face, const nurbs_mesh_options *options, nurbs_mesh **out) {
    return guard([&] {
        require_out(out);
        require(face, "face");
        give_mesh(face->face, face->face->surface()->point_count(), options, out);
    });
}

nurbs_status nurbs_mesh_face_with(const nurbs_face *face, const nurbs_mesh_options *options,
                                  const nurbs_call_options *call, nurbs_mesh **out) {
    return watched(call, out, [&] { return nurbs_mesh_face(face, options, out); });
}

nurbs_status nurbs_mesh_model(const nurbs_model *model, const nurbs_mesh_options *options, nurbs_mesh **out) {
    return guard([&] {
        require_out(out);
        const model::Model &own = model_of(model);
        give_mesh(own, points_of(own), options, out);
    });
}

nurbs_status nurbs_mesh_model_with(const nurbs_model *model, const nurbs_mesh_options *options,
                                   const nurbs_call_options *call, nurbs_mesh **out) {
    return watched(call, out, [&] { return nurbs_mesh_model(model, options, out); });
}

nurbs_status nurbs_mesh_volume(const nurbs *g, const nurbs_mesh_options *options, int64_t limit,
                               nurbs_mesh **out) {
    return guard([&] {
        require_out(out);
        require(g, "g");
        mesh::check_volume(*g->spline);
        check_length(limit, "limit");
        const mesh::MeshRule rule = rule_of(options);
        if (rule.angle > 0) {
            fail(Status::angle, "options: angle = %s, expected 0 for a volume", Number(rule.angle).text);
        }
        *out = new nurbs_mesh{mesh::mesh_of_volume(g->spline, rule, limit == 0 ? usual_hexahedra : limit)};
    });
}

nurbs_status nurbs_mesh_volume_with(const nurbs *g, const nurbs_mesh_options *options, int64_t limit,
                                    const nurbs_call_options *call, nurbs_mesh **out) {
    return watched(call, out, [&] { return nurbs_mesh_volume(g, options, limit, out); });
}

nurbs_status nurbs_mesh_clone(const nurbs_mesh *mesh, nurbs_mesh **out) {
    return guard([&] {
        require_out(out);
        require(mesh, "mesh");
        *out = new nurbs_mesh{mesh->mesh};
    });
}

void nurbs_mesh_destroy(nurbs_mesh *mesh) {
    delete mesh;
}
