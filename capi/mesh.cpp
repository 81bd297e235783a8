// SPDX-License-Identifier: MIT
// Triangle meshes of surfaces, faces and models, hexahedral meshes of volumes, and the options that limit
// their deviation.
#include "checks.h"
#include "guard.h"
#include "structs.h"
#include "watched.h"

#include "mesh/surface_mesh.h"
#include "mesh/volume/volume_mesh.h"
#include "spline/kind.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

using namespace nrb;
using namespace nrb::capi;

namespace {

constexpr int64_t usual_hexahedra = int64_t{1} << 20;

// The usual limit of work, in multiply-adds: enough for about two million triangles, plus a share for each
// control point.
constexpr int64_t usual_work_for_meshes = 4000000000, work_for_a_point = 20000;

// Whether a limit other than the chord error takes effect. An angle of pi limits nothing.
bool is_limited(const mesh::MeshRule &rule) noexcept {
    return rule.relative > 0 || rule.longest > 0 || (rule.angle > 0 && rule.angle < std::numbers::pi);
}

// Checks `chord` last: it may be infinite if another limit is set, so an invalid value of another limit is
// reported first.
void check_limits(const mesh::MeshRule &rule) {
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
    if (!(rule.least_angle >= 0 && rule.least_angle <= std::numbers::pi / 6)) {
        fail(Status::angle, "options: minimum_angle = %s, expected one from 0 to pi / 6",
             Number(rule.least_angle).text);
    }
    if (!(rule.chord > 0) || (std::isinf(rule.chord) && !is_limited(rule))) {
        fail(Status::tolerance, "options: chord = %s, expected > 0, and finite without another limit",
             Number(rule.chord).text);
    }
}

mesh::MeshRule usual_rule() noexcept {
    mesh::MeshRule rule;
    rule.relative = 1e-3;
    return rule;
}

mesh::MeshRule unchecked_rule_of(const nurbs_mesh_options *options) {
    if (options == nullptr) {
        return usual_rule();
    }
    const nurbs_mesh_options &given = checked_struct("options", options);
    return {given.chord, given.relative_chord, given.longest, given.angle, given.minimum_angle};
}

mesh::MeshRule rule_of(const nurbs_mesh_options *options) {
    const mesh::MeshRule rule = unchecked_rule_of(options);
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

// At the limit of work the mesh consists of the triangles made by then.
template <class Shape>
void give_mesh(const Shape &shape, int64_t points, const nurbs_mesh_options *options, nurbs_mesh **out) {
    const mesh::MeshRule rule = rule_of(options);
    const UsualLimit usual(usual_work_for_meshes + work_for_a_point * points);
    const LimitedSearch limited;
    *out = new nurbs_mesh{mesh::mesh_of(shape, rule)};
}

// The rule common to all levels, after a check of their chord errors. Its own chord error is infinite: each
// level brings its own. Both chord errors of the options are ignored.
mesh::MeshRule rule_of_levels(const nurbs_mesh_options *options, std::span<const double> chords) {
    mesh::MeshRule rule = unchecked_rule_of(options);
    rule.relative = 0;
    rule.chord = 1;
    check_limits(rule);
    rule.chord = infinity;
    for (size_t i = 0; i < chords.size(); ++i) {
        if (!(chords[i] > 0)) {
            fail(Status::tolerance, "chords[%zu] = %s, expected > 0", i, Number(chords[i]).text);
        }
        if (std::isinf(chords[i]) && !is_limited(rule)) {
            fail(Status::tolerance, "chords[%zu] = %s, expected a finite one without another limit", i,
                 Number(chords[i]).text);
        }
    }
    return rule;
}

// A larger number of levels is taken for a mistake.
constexpr int64_t most_levels = 4096;

// As require_out(), for an array of `count` handles.
void require_outs(int64_t count, nurbs_mesh **out) {
    check_length(count, "count");
    if (count > most_levels) {
        fail(Status::count, "count = %lld, expected at most %lld", static_cast<long long>(count),
             static_cast<long long>(most_levels));
    }
    if (count > 0) {
        require(out, "out");
        std::fill_n(out, count, nullptr);
    }
}

template <class Shape>
void give_levels(const Shape &shape, int64_t points, std::span<const double> chords,
                 const nurbs_mesh_options *options, nurbs_mesh **out) {
    const mesh::MeshRule rule = rule_of_levels(options, chords);
    const std::vector<mesh::MeshPtr> meshes =
        mesh::meshes_of(shape, rule, {chords, usual_work_for_meshes + work_for_a_point * points});
    std::vector<std::unique_ptr<nurbs_mesh>> handles;
    for (const mesh::MeshPtr &own : meshes) {
        handles.push_back(std::make_unique<nurbs_mesh>(nurbs_mesh{own}));
    }
    for (size_t i = 0; i < handles.size(); ++i) {
        out[i] = handles[i].release();
    }
}

// As watched() for one handle: all handles are NULL also if the call options are wrong.
template <class Body>
nurbs_status watched_levels(int64_t count, nurbs_mesh **out, const nurbs_call_options *call, Body &&body) {
    if (out != nullptr && count > 0 && count <= most_levels) {
        std::fill_n(out, count, nullptr);
    }
    return watched(call, body);
}

std::span<const double> checked_chords(int64_t count, const double *chords) {
    if (count > 0) {
        require(chords, "chords");
    }
    return {chords, static_cast<size_t>(count)};
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
        options->minimum_angle = usual.least_angle;
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

nurbs_status nurbs_mesh_surface_levels(const nurbs *g, int64_t count, const double *chords,
                                       const nurbs_mesh_options *options, nurbs_mesh **out) {
    return guard([&] {
        require_outs(count, out);
        const Spline &surface = surface_of(g);
        check_dimension(surface, 2, 3);
        give_levels(surface, surface.point_count(), checked_chords(count, chords), options, out);
    });
}

nurbs_status nurbs_mesh_surface_levels_with(const nurbs *g, int64_t count, const double *chords,
                                            const nurbs_mesh_options *options, const nurbs_call_options *call,
                                            nurbs_mesh **out) {
    return watched_levels(count, out, call,
                          [&] { return nurbs_mesh_surface_levels(g, count, chords, options, out); });
}

nurbs_status nurbs_mesh_face_levels(const nurbs_face *face, int64_t count, const double *chords,
                                    const nurbs_mesh_options *options, nurbs_mesh **out) {
    return guard([&] {
        require_outs(count, out);
        require(face, "face");
        give_levels(face->face, face->face->surface()->point_count(), checked_chords(count, chords), options,
                    out);
    });
}

nurbs_status nurbs_mesh_face_levels_with(const nurbs_face *face, int64_t count, const double *chords,
                                         const nurbs_mesh_options *options, const nurbs_call_options *call,
                                         nurbs_mesh **out) {
    return watched_levels(count, out, call,
                          [&] { return nurbs_mesh_face_levels(face, count, chords, options, out); });
}

nurbs_status nurbs_mesh_model_levels(const nurbs_model *model, int64_t count, const double *chords,
                                     const nurbs_mesh_options *options, nurbs_mesh **out) {
    return guard([&] {
        require_outs(count, out);
        const model::Model &own = model_of(model);
        give_levels(own, points_of(own), checked_chords(count, chords), options, out);
    });
}

nurbs_status nurbs_mesh_model_levels_with(const nurbs_model *model, int64_t count, const double *chords,
                                          const nurbs_mesh_options *options, const nurbs_call_options *call,
                                          nurbs_mesh **out) {
    return watched_levels(count, out, call,
                          [&] { return nurbs_mesh_model_levels(model, count, chords, options, out); });
}

nurbs_status nurbs_mesh_volume(const nurbs *g, const nurbs_mesh_options *options, int64_t limit,
                               nurbs_mesh **out) {
    return guard([&] {
        require_out(out);
        require(g, "g");
        mesh::check_volume(*g->spline);
        check_length(limit, "limit");
        const mesh::MeshRule rule = rule_of(options);
        if (rule.angle > 0 || rule.least_angle > 0) {
            fail(Status::angle, "options: %s = %s, expected 0 for a volume",
                 rule.angle > 0 ? "angle" : "minimum_angle",
                 Number(rule.angle > 0 ? rule.angle : rule.least_angle).text);
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
