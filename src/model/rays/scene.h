// SPDX-License-Identifier: MIT
// The faces of a model where they stand, for rays. It is kept with the model.
#pragma once

#include "base/lazy.h"
#include "model/rays/face_edges.h"
#include "model/rays/instances.h"

#include <memory>
#include <vector>

namespace nrb::model {

// A face in an instance of its part.
struct PlacedFace {
    int64_t face, instance;
    int64_t group; // faces of one solid, or of none, in one instance
};

// Of each face the largest tolerance of those with which it shares edges: between neighbours there may be four times as much,
// from the curve of one to its edge, to that of the other one, and to its curve.
std::vector<double> widest_tolerances(const Model &model);

class Scene {
public:
    // closed: what lies between neighbours is part of the boundary, however far edges are from curves. Throws what
    // instances_of() and Placement() do.
    Scene(const Model &model, bool closed);

    [[nodiscard]] const std::vector<Instance> &instances() const noexcept { return instances_; }
    [[nodiscard]] const std::vector<PlacedFace> &faces() const noexcept { return faces_; }
    [[nodiscard]] const PlacedFace &face(int32_t i) const noexcept { return faces_[static_cast<size_t>(i)]; }
    [[nodiscard]] const Placement &placement(const PlacedFace &face) const noexcept {
        return placements_[static_cast<size_t>(face.instance)];
    }
    [[nodiscard]] int64_t groups() const noexcept { return groups_; }
    // Of faces() in the whole.
    [[nodiscard]] const intersect::BoxTree &tree() const noexcept { return tree_; }
    // Built at the first use.
    [[nodiscard]] const FaceEdges &edges(const Model &model, int64_t face) const;

private:
    std::vector<Instance> instances_;
    std::vector<Placement> placements_;
    std::vector<PlacedFace> faces_;
    int64_t groups_ = 0;
    intersect::BoxTree tree_;
    std::vector<std::vector<double>> rooms_; // of each face, around each loop and, last, other curves
    std::vector<Lazy<FaceEdges>> edges_;     // of each face
};

// Built at the first use. Of a closed one throws what check_closed() does, too.
const Scene &scene_of(const Model &model);
const Scene &closed_scene_of(const Model &model);

} // namespace nrb::model
