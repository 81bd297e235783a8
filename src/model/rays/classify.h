// SPDX-License-Identifier: MIT
// Point-in-solid classification by ray casting.
#pragma once

#include "face/near/face_locator.h"
#include "model/rays/model_caster.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace nrb::model {

enum Side : int32_t { side_outside = -1, side_on = 0, side_inside = 1, side_undecided = 2 };

// Takes one point after another.
class Classifier {
public:
    // tolerance >= 0: the distance from a face up to which a point is on it. Throws what closed_scene_of()
    // throws.
    Classifier(const Model &model, double tolerance);

    // The side of a finite point, proven by the parity of the crossings of a ray from it. A direction counts
    // only if all crossings are proven and none is near an edge; if none of a fixed number of directions
    // decides, the point is undecided.
    [[nodiscard]] Side side(const Vector3 &x);

private:
    // The crossings of the current ray with the faces of one group.
    struct Group {
        int passed = 0;
        bool sure = true;
        bool settled = false; // the point is certainly outside of it
    };
    // The tolerance to which distances from faces are computed.
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
    std::vector<std::unique_ptr<face::FaceLocator>> locators_; // indexed by face
    std::vector<Group> groups_;
    std::vector<int64_t> met_; // groups met by the current ray
    std::vector<PlacedMeet> meets_;
};

} // namespace nrb::model
