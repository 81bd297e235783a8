// SPDX-License-Identifier: MIT
// The point of a model nearest to a given point.
#pragma once

#include "face/near/face_locator.h"
#include "model/rays/scene.h"

#include <map>
#include <memory>
#include <vector>

namespace nrb::model {

// The nearest point in the whole. `foot` has the parameters of the surface in its part, and the distance in
// the whole. face = -1: there is none.
struct ModelFoot {
    closest::Foot foot;
    Vector3 point{};
    int64_t face = -1, instance = -1;
};

// Searches all faces where they stand in the whole, in the order of the distances of their boxes. Takes one
// point after another; the model must outlive the object.
class ModelLocator {
public:
    // Throws what scene_of() throws.
    explicit ModelLocator(const Model &model)
        : model_(model), scene_(scene_of(model)), locators_(model.faces.size()) {}

    // x: finite. tolerance: how much nearer another point may be. Status: closest_ bits as for FaceLocator.
    [[nodiscard]] ModelFoot nearest(const Vector3 &x, double tolerance);

private:
    // A face moved into the whole, for placements that are not similarities.
    struct Moved {
        face::FacePtr face;
        face::FaceLocator locator;
        double rounding; // a bound for points of the face

        Moved(face::FacePtr made, double error) : face(std::move(made)), locator(*face), rounding(error) {}
    };
    class Nearest;
    [[nodiscard]] const face::Face &face(int64_t i) const noexcept {
        return *model_.faces[static_cast<size_t>(i)].face;
    }
    // The nearest point of a placed face, with its distance in the whole. If the whole surface is certainly
    // farther than `far`, the answer is its foot point, which need not lie on the face.
    [[nodiscard]] closest::BoundedFoot foot(int32_t number, const Vector3 &x, double tolerance, double far);
    [[nodiscard]] closest::BoundedFoot foot_in_part(const PlacedFace &placed, const Vector3 &x,
                                                    double tolerance, double far);
    [[nodiscard]] Moved &moved(int32_t placed);
    void settle(ModelFoot &found, const Vector3 &x, double tolerance) const;

    const Model &model_;
    const Scene &scene_;
    std::vector<std::unique_ptr<face::FaceLocator>> locators_; // indexed by face
    std::map<int32_t, std::unique_ptr<Moved>> moved_;          // by placed face
};

} // namespace nrb::model
