// SPDX-License-Identifier: MIT
// The scene: the faces of a model where they stand in the whole, in a tree of boxes for rays and other
// searches. It is kept with the model.
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
    int64_t group; // the faces of one solid, or those of none, in one instance
};

// For each face the largest tolerance among it and the faces with which it shares edges. The gap between
// neighbours may be four times as wide: from the curve of one to its edge, to the edge of the other (by up to
// the sum of both tolerances), and to the curve of that.
std::vector<double> widest_tolerances(const Model &model);

class Scene {
public:
    // closed: gaps between neighbours belong to the boundary, however far the edges are from their curves.
    // Throws what instances_of() and Placement() throw.
    Scene(const Model &model, bool closed);

    [[nodiscard]] const std::vector<Instance> &instances() const noexcept { return instances_; }
    [[nodiscard]] const std::vector<PlacedFace> &faces() const noexcept { return faces_; }
    [[nodiscard]] const PlacedFace &face(int32_t i) const noexcept { return faces_[static_cast<size_t>(i)]; }
    [[nodiscard]] const Placement &placement(const PlacedFace &face) const noexcept {
        return placements_[static_cast<size_t>(face.instance)];
    }
    [[nodiscard]] int64_t groups() const noexcept { return groups_; }
    // Boxes of faces() in the whole, numbered likewise.
    [[nodiscard]] const intersect::BoxTree &tree() const noexcept { return tree_; }
    // Built at the first request.
    [[nodiscard]] const FaceEdges &edges(const Model &model, int64_t face) const;

private:
    std::vector<Instance> instances_;
    std::vector<Placement> placements_;
    std::vector<PlacedFace> faces_;
    int64_t groups_ = 0;
    intersect::BoxTree tree_;
    std::vector<std::vector<double>> rooms_; // of each face: around each loop and, last, around other curves
    std::vector<Lazy<FaceEdges>> edges_;     // indexed by face
};

// Built at the first request. closed_scene_of() throws what check_closed() throws, too.
const Scene &scene_of(const Model &model);
const Scene &closed_scene_of(const Model &model);

} // namespace nrb::model
