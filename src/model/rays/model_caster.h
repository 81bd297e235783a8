// SPDX-License-Identifier: MIT
// Intersections of rays with the faces of a model.
#pragma once

#include "intersect/rays/rays.h"
#include "model/rays/scene.h"

#include <memory>
#include <optional>
#include <vector>

namespace nrb::model {

// The answer for a ray, with its placed face; -1: it meets none.
struct ModelAnswer {
    intersect::RayAnswer answer;
    int64_t face = -1, instance = -1;
};

// An intersection with a placed face, by its number in the scene.
struct PlacedMeet {
    intersect::RayAnswer answer;
    int32_t placed;
    double room; // a bound of the rounding of t
};

// Casts one ray after another. A ray that passes near an edge of a face touches the face there. Precondition:
// as for RayCaster.
class ModelCaster {
public:
    ModelCaster(const Model &model, const Scene &scene);

    [[nodiscard]] ModelAnswer first(const intersect::RayQuery &query);
    // All intersections, by ascending t; `out` must be empty before. Returns whether they are proven to be
    // hits, and all of them.
    bool all(const intersect::RayQuery &query, std::vector<PlacedMeet> &out);
    // The same for one placed face, in any order. Precondition: the direction has a length of about 1.
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
    std::vector<std::unique_ptr<intersect::RayCaster>> casters_; // indexed by face
    std::vector<EdgePassage> passages_;
    std::vector<intersect::RayAnswer> answers_;
};

} // namespace nrb::model
