// SPDX-License-Identifier: MIT
// Renumbers solids and layers of a model, of which some may have lost all their faces because these could not
// be made.
#pragma once

#include "model/model.h"

namespace nrb::model {

// Numbers the solids from 0 on in the order of their first faces, so that each has a face.
void number_solids(Model &model);

// Drops the layers to which no face and no spline belongs.
void number_layers(Model &model);

// Calls visit(layers) for each face, then for each spline.
template <class Any, class Visit>
void for_each_in_layers(Any &model, const Visit &visit) {
    for (auto &face : model.faces) {
        visit(face.layers);
    }
    for (auto &spline : model.splines) {
        visit(spline.layers);
    }
}

} // namespace nrb::model
