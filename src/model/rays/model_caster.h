// SPDX-License-Identifier: MIT
// Where rays meet the faces of a model.
#pragma once

#include "intersect/rays/rays.h"
#include "model/rays/scene.h"

#include <memory>
#include <optional>
#include <vector>

namespace nrb::model {

struct ModelAnswer {
    intersect::RayAnswer answer;
    int64_t face = -1, instance = -1;
};

// A meet, with the number of its placed face.
struct PlacedMeet {
    intersect::RayAnswer answer;
    int32_t placed;
    double room; // how far rounding may move t
};

// Calls with one ray after the other. A ray that passes near an edge of a face touches it. Precondition as for RayCaster.
class ModelCaster {
public:
    ModelCaster(const Model &model, const Scene &scene);

    [[nodiscard]] ModelAnswer first(const intersect::RayQuery &query);
    // All of them, rising, in a vector that was empty. Returns whether there are no others, and none is a touch.
    bool all(const intersect::RayQuery &query, std::vector<PlacedMeet> &out);
    // The same with one placed face, in any order. Precondition: a direction of about 1.
    bool all_of(int32_t placed, const intersect::RayQuery &given, std::vector<PlacedMeet> &out);
    [[nodiscard]] ModelAnswer answer(const PlacedMeet &meet) const;

private:
    class First;
    [[nodiscard]] ModelAnswer first_of(const intersect::RayQuery &query);
    [[nodiscard]] const face::Face &face(int64_t i) const noexcept {
        return *model_.faces[static_cast<size_t>(i)].face;
    }
    intersect::RayCaster &caster(int64_t face);
    const std::vector<EdgePassage> &passages(const intersect::RayQuery &query, int64_t face);

    const Model &model_;
    const Scene &scene_;
    std::vector<std::unique_ptr<intersect::RayCaster>> casters_; // of each face
    std::vector<EdgePassage> passages_;
    std::vector<intersect::RayAnswer> answers_;
};

} // namespace nrb::model
