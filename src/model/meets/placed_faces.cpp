// SPDX-License-Identifier: MIT
#include "model/meets/placed_faces.h"

#include "base/watch.h"
#include "model/rays/face_place.h"
#include "model/rays/scene.h"

namespace nrb::model {

PlacedFaces::PlacedFaces(const Model &model)
    : model_(model), borders_(model), instances_(instances_of(model)), tolerances_(widest_tolerances(model)) {
    std::vector<std::vector<int64_t>> of_part(model.parts.size());
    std::vector<intersect::Box3> boxes;
    for (size_t i = 0; i < model.faces.size(); ++i) {
        of_part[static_cast<size_t>(model.faces[i].part)].push_back(static_cast<int64_t>(i));
        boxes.push_back(face_box(*model.faces[i].face));
        count_work(64 * model.faces[i].face->surface()->point_count());
    }
    for (size_t i = 0; i < instances_.size(); ++i) {
        const Placement &placement = placements_.emplace_back(instances_, i);
        for (const int64_t face : of_part[static_cast<size_t>(instances_[i].part)]) {
            const auto number = static_cast<size_t>(face);
            const bool turned =
                (model.faces[number].against != borders_.is_turned(face)) != placement.mirrors();
            places_.push_back({face, static_cast<int64_t>(i), turned, placement.placed(boxes[number])});
        }
    }
    shapes_.resize(places_.size());
}

const face::FacePtr &PlacedFaces::shape(size_t place) {
    face::FacePtr &shape = shapes_[place];
    if (!shape) {
        const auto &[face, instance, turned, box] = places_[place];
        const Placement &placement = placements_[static_cast<size_t>(instance)];
        const face::FacePtr &own = model_.faces[static_cast<size_t>(face)].face;
        shape = std::make_shared<const face::Face>(own, placement.in_whole(own->surface()),
                                                   placement.growth_to_whole() * own->tolerance());
    }
    return shape;
}

double PlacedFaces::room(const Place &place) const noexcept {
    const double growth = placements_[static_cast<size_t>(place.instance)].growth_to_whole();
    return 2 * growth * tolerances_[static_cast<size_t>(place.face)] + 0x1p-44 * place.box.magnitude();
}

} // namespace nrb::model
