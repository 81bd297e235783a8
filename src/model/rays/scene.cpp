// SPDX-License-Identifier: MIT
#include "model/rays/scene.h"

#include "base/watch.h"
#include "face/deviation.h"
#include "model/rays/boxed_distance.h"
#include "model/rays/closed.h"
#include "model/rays/face_place.h"

#include <algorithm>
#include <map>

namespace nrb::model {

namespace {

constexpr double rounding = 0x1p-44; // of composed curves, relative to the largest coordinate
constexpr int64_t work_of_a_face = 20000;

// A bound of the distances of the curves of a loop from their edges, which other faces may share.
double deviation_of_loop(const face::Face &face, int32_t number) {
    const face::Loop &loop = face.loops()[static_cast<size_t>(number)];
    double most = 0;
    for (int32_t i = 0; i < static_cast<int32_t>(loop.size()); ++i) {
        const face::Coedge &coedge = loop[static_cast<size_t>(i)];
        if (coedge.edge != nullptr) {
            const face::Deviation own = face::deviation_of(face, coedge);
            most = std::max(most, own.proven ? own.distance : boxed_distance(face, number, i));
        }
    }
    return most;
}

std::vector<double> rooms_of(const face::Face &face, double tolerance, double size, bool closed) {
    const double least = 2 * tolerance + rounding * size;
    std::vector<double> rooms;
    for (int32_t i = 0; i < static_cast<int32_t>(face.loops().size()); ++i) {
        rooms.push_back(least + (closed ? deviation_of_loop(face, i) : 0));
    }
    rooms.push_back(least);
    return rooms;
}

} // namespace

std::vector<double> widest_tolerances(const Model &model) {
    std::vector<double> found;
    for (const ModelFace &face : model.faces) {
        found.push_back(face.face->tolerance());
    }
    for (const Edge &edge : model.edges) {
        double most = 0;
        for (const EdgeUse &use : edge.uses) {
            most = std::max(most, model.faces[static_cast<size_t>(use.face)].face->tolerance());
        }
        for (const EdgeUse &use : edge.uses) {
            double &own = found[static_cast<size_t>(use.face)];
            own = std::max(own, most);
        }
    }
    return found;
}

Scene::Scene(const Model &model, bool closed) : instances_(instances_of(model)), edges_(model.faces.size()) {
    const std::vector<double> tolerances = widest_tolerances(model);
    std::vector<intersect::Box3> own;
    std::vector<std::vector<size_t>> of_part(model.parts.size());
    for (size_t i = 0; i < model.faces.size(); ++i) {
        const ModelFace &face = model.faces[i];
        own.push_back(face_box(*face.face));
        rooms_.push_back(rooms_of(*face.face, tolerances[i], own.back().magnitude(), closed));
        own.back().grow(*std::ranges::max_element(rooms_.back()));
        of_part[static_cast<size_t>(face.part)].push_back(i);
        count_work(work_of_a_face);
    }
    std::vector<intersect::Box3> boxes;
    for (size_t i = 0; i < instances_.size(); ++i) {
        placements_.emplace_back(instances_, i);
        std::map<int64_t, int64_t> solids;
        for (const size_t face : of_part[static_cast<size_t>(instances_[i].part)]) {
            const auto group = solids.try_emplace(model.faces[face].solid, groups_);
            groups_ += group.second ? 1 : 0;
            faces_.push_back({static_cast<int64_t>(face), static_cast<int64_t>(i), group.first->second});
            boxes.push_back(placements_.back().placed(own[face]));
        }
    }
    tree_ = intersect::BoxTree(boxes);
}

const FaceEdges &Scene::edges(const Model &model, int64_t face) const {
    const auto i = static_cast<size_t>(face);
    return edges_[i].get([&] { return FaceEdges(*model.faces[i].face, rooms_[i]); });
}

const Scene &scene_of(const Model &model) {
    return model.rays.get<Scene>([&] { return std::make_shared<const Scene>(model, false); });
}

const Scene &closed_scene_of(const Model &model) {
    return model.closed_rays.get<Scene>([&] {
        check_closed(model);
        return std::make_shared<const Scene>(model, true);
    });
}

} // namespace nrb::model
