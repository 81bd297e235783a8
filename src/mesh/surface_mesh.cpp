// SPDX-License-Identifier: MIT
#include "mesh/surface_mesh.h"

#include "base/watch.h"
#include "mesh/expected_work.h"
#include "mesh/extent.h"
#include "mesh/model_mesher.h"
#include "mesh/outside.h"
#include "model/from_faces.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>

namespace nrb::mesh {

namespace {

// Where the work is not enough, larger chord errors are tried: most_distances in all, each but the last with
// share_of_first of the work that is left. The work falls with the chord error to the power -growth; so the
// next one is chosen such that the work wanted now, times `reserve`, comes down to what there is, within a
// factor from least_coarser to most_coarser.
constexpr int most_distances = 4;
constexpr double share_of_first = 0.65, reserve = 1.3, growth = 0.7, least_coarser = 2, most_coarser = 64;

double extent_of_faces(const model::Model &model) {
    std::vector<Interval> box;
    double extent = 0;
    for (const model::ModelFace &face : model.faces) {
        extent = std::max(extent, extent_of(face.face->surface()->effective(), box));
    }
    return extent;
}

// Judges triangles that were made for a coarser rule by the one that was asked for: they may be close enough
// all the same.
void set_reached(const MeshRule &rule, Mesh &mesh) noexcept {
    const bool other = rule.longest > 0 || rule.angle > 0; // these were coarsened and are not checked again
    for (MeshFace &face : mesh.faces) {
        face.reached = face.reached && !other && std::max(face.from_shape, face.from_mesh) <= rule.chord;
    }
    for (MeshEdge &edge : mesh.edges) {
        edge.reached = edge.reached && !other && edge.bound <= rule.chord;
    }
}

void check_surface(const Spline &surface) {
    if (surface.axes() != 2) {
        fail(Status::axes, "a spline of %d axes, expected a surface", surface.axes());
    }
    if (surface.dim() != 2 && surface.dim() != 3) {
        fail(Status::dimension, "a surface of dimension %d, expected 2 or 3", surface.dim());
    }
}

MeshRule with_chord(MeshRule rule, double chord) {
    rule.chord = chord;
    return rule;
}

std::vector<double> parts_of(std::vector<double> work, double factor) {
    std::ranges::for_each(work, [factor](double &face) { face /= factor; });
    return work;
}

std::optional<Mesh> mesh_with_part(ModelMesher &mesher, bool last) {
    const PartOfWork part(last ? 1 : share_of_first);
    return mesher.mesh(!last);
}

// Where the work ends early, triangles are left that were never divided: a complete mesh for a larger chord
// error is closer to the shape.
Mesh mesh_within_work(const model::Model &model, const MeshRule &rule) {
    const double extent = extent_of_faces(model);
    const MeshRule asked = settled(rule, extent);
    const ExpectedWork work = expected_work(model, asked, extent);
    MeshRule own = with_chord(asked, work.chord);
    double factor = 1;
    for (int attempt = 1; true; ++attempt) {
        const bool last = attempt == most_distances || !work_is_limited();
        ModelMesher mesher(model, coarsened(own, factor), parts_of(work.faces, factor));
        if (std::optional<Mesh> mesh = mesh_with_part(mesher, last)) {
            if (factor > 1 || own.chord > asked.chord) {
                set_reached(asked, *mesh);
            }
            return *std::move(mesh);
        }
        const double has = share_of_first * static_cast<double>(work_left());
        factor *= std::clamp(std::pow(reserve * mesher.wanted_work() / has, 1 / growth), least_coarser,
                             most_coarser);
    }
}

void check_surfaces(const model::Model &model) {
    for (const model::ModelFace &face : model.faces) {
        check_surface(*face.face->surface());
    }
}

// The share of a mesh in the progress that is left for it and the finer ones: the number of triangles is
// about proportional to 1 / chord. `rest`: the sum of 1 / chord over all of these.
double share_of(double chord, double rest) noexcept {
    return std::isfinite(1 / chord) && rest > 0 ? 1 / chord / rest : 0.5;
}

// Calls make(chord) for each level, from coarse to fine, so that limited work goes to the coarse ones first.
template <class Make>
std::vector<MeshPtr> level_by_level(const Levels &levels, Make &&make) {
    std::vector<size_t> order(levels.chords.size());
    std::iota(order.begin(), order.end(), size_t{0});
    std::ranges::sort(order, {}, [&](size_t i) { return std::pair(-levels.chords[i], i); });
    double rest = 0;
    for (const double chord : levels.chords) {
        rest += 1 / chord;
    }
    std::vector<MeshPtr> meshes(order.size());
    for (size_t i = 0; i < order.size(); ++i) {
        const double chord = levels.chords[order[i]];
        if (i > 0 && chord == levels.chords[order[i - 1]]) {
            meshes[order[i]] = meshes[order[i - 1]];
            continue;
        }
        const Phase phase(share_of(chord, rest));
        const UsualLimit usual(levels.usual_work);
        const LimitedSearch limited;
        meshes[order[i]] = make(chord);
        rest -= 1 / chord;
    }
    return meshes;
}

} // namespace

MeshPtr mesh_of(const Spline &surface, const MeshRule &rule) {
    check_surface(surface);
    std::vector<Interval> box;
    const MeshRule own = settled(rule, extent_of(surface.effective(), box));
    Mesh mesh;
    append(mesh_of(domain_of(surface, face::Covering(surface, 0)), own), mesh);
    label_as_one_part(mesh);
    return std::make_shared<const Mesh>(std::move(mesh));
}

MeshPtr mesh_of(const face::FacePtr &face, const MeshRule &rule) {
    return mesh_of(model::model_of_faces({face}, 0), rule);
}

MeshPtr mesh_of(const model::Model &model, const MeshRule &rule) {
    check_surfaces(model);
    Mesh mesh = mesh_within_work(model, rule);
    label(model, mesh);
    return std::make_shared<const Mesh>(std::move(mesh));
}

std::vector<MeshPtr> meshes_of(const Spline &surface, const MeshRule &rule, const Levels &levels) {
    return level_by_level(levels, [&](double chord) { return mesh_of(surface, with_chord(rule, chord)); });
}

std::vector<MeshPtr> meshes_of(const face::FacePtr &face, const MeshRule &rule, const Levels &levels) {
    return meshes_of(model::model_of_faces({face}, 0), rule, levels);
}

std::vector<MeshPtr> meshes_of(const model::Model &model, const MeshRule &rule, const Levels &levels) {
    return level_by_level(levels, [&](double chord) { return mesh_of(model, with_chord(rule, chord)); });
}

} // namespace nrb::mesh
