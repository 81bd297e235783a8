// SPDX-License-Identifier: MIT
// The faces of a model where they stand in the whole, for intersections with another model.
#pragma once

#include "model/rays/instances.h"
#include "model/sections/shared_borders.h"

#include <vector>

namespace nrb::model {

class PlacedFaces {
public:
    // Throws what instances_of() and Placement() throw. The model must outlive the object.
    explicit PlacedFaces(const Model &model);

    struct Place {
        int64_t face, instance;
        bool turned; // whether the outer normal is opposite to that of the placed surface
        intersect::Box3 box;
    };
    [[nodiscard]] const std::vector<Place> &places() const noexcept { return places_; }
    // The face with its surface in the whole, over the same parameters and without its edges in space; made
    // at the first request.
    [[nodiscard]] const face::FacePtr &shape(size_t place);
    [[nodiscard]] const SharedBorders &borders() const noexcept { return borders_; }
    [[nodiscard]] const face::Face &own(int64_t face) const noexcept {
        return *model_.faces[static_cast<size_t>(face)].face;
    }
    // How far from a border of the face the neighbouring face may begin, in the whole.
    [[nodiscard]] double room(const Place &place) const noexcept;

private:
    const Model &model_;
    SharedBorders borders_;
    std::vector<Instance> instances_;
    std::vector<Placement> placements_;
    std::vector<double> tolerances_;
    std::vector<Place> places_;
    std::vector<face::FacePtr> shapes_;
};

} // namespace nrb::model
