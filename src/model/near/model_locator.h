// SPDX-License-Identifier: MIT
// Nearest points of models.
#pragma once

#include "face/near/face_locator.h"
#include "model/rays/scene.h"

#include <map>
#include <memory>
#include <vector>

namespace nrb::model {

// A nearest point in the whole; its foot is that of a surface in a part, with the distance in the whole. -1: no face.
struct ModelFoot {
    closest::Foot foot;
    Vector3 point{};
    int64_t face = -1, instance = -1;
};

// Of all faces where they stand, the nearest boxes first. Calls with one point after the other; the model has to stay.
class ModelLocator {
public:
    // Throws what scene_of() does.
    explicit ModelLocator(const Model &model)
        : model_(model), scene_(scene_of(model)), locators_(model.faces.size()) {}

    // x: finite. tolerance: how much nearer another point may be. Status: closest_ bits as of FaceLocator.
    [[nodiscard]] ModelFoot nearest(const Vector3 &x, double tolerance);

private:
    // A face in the whole, for placements that change ratios of distances.
    struct Moved {
        face::FacePtr face;
        face::FaceLocator locator;
        double rounding; // of its points

        Moved(face::FacePtr made, double error) : face(std::move(made)), locator(*face), rounding(error) {}
    };
    class Nearest;
    [[nodiscard]] const face::Face &face(int64_t i) const noexcept {
        return *model_.faces[static_cast<size_t>(i)].face;
    }
    // In the whole; of its surface, if that is farther than `far` for certain.
    [[nodiscard]] closest::BoundedFoot foot(int32_t number, const Vector3 &x, double tolerance, double far);
    [[nodiscard]] closest::BoundedFoot foot_in_part(const PlacedFace &placed, const Vector3 &x,
                                                    double tolerance, double far);
    [[nodiscard]] Moved &moved(int32_t placed);
    void settle(ModelFoot &found, const Vector3 &x, double tolerance) const;

    const Model &model_;
    const Scene &scene_;
    std::vector<std::unique_ptr<face::FaceLocator>> locators_; // of each face
    std::map<int32_t, std::unique_ptr<Moved>> moved_;          // of placed faces
};

} // namespace nrb::model
