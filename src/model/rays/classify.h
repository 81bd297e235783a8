// SPDX-License-Identifier: MIT
// Whether points are inside the solids of a model.
#pragma once

#include "face/near/face_locator.h"
#include "model/rays/model_caster.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace nrb::model {

enum Side : int32_t { side_outside = -1, side_on = 0, side_inside = 1, side_undecided = 2 };

// Calls with one point after the other.
class Classifier {
public:
    // tolerance: of what is on a face, >= 0. Throws what closed_scene_of() does.
    Classifier(const Model &model, double tolerance);

    // Of a finite point. Proven by the number of faces that a ray from it passes, where all of them are proven and none is near
    // an edge; undecided if that holds for none of some directions.
    [[nodiscard]] Side side(const Vector3 &x);

private:
    struct Group {
        int passed = 0;
        bool sure = true;
        bool settled = false; // outside of it, for certain
    };
    // Of distances.
    [[nodiscard]] double precision() const noexcept { return tolerance_ / 1024; }
    [[nodiscard]] Side nearness(const Vector3 &x);
    [[nodiscard]] Side nearness(const Vector3 &x, const PlacedFace &placed);
    face::FaceLocator &locator(int64_t face);
    [[nodiscard]] Side side_along(const Vector3 &x, const Vector3 &direction);
    void pass(int32_t placed, const intersect::RayQuery &query);

    const Model &model_;
    const Scene &scene_;
    ModelCaster caster_;
    double tolerance_;
    std::vector<std::unique_ptr<face::FaceLocator>> locators_; // of each face
    std::vector<Group> groups_;
    std::vector<int64_t> met_; // groups
    std::vector<PlacedMeet> meets_;
};

} // namespace nrb::model
