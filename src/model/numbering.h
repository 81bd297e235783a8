// SPDX-License-Identifier: MIT
// Numbers of what faces have in common, after faces that could not be made.
#pragma once

#include "model/model.h"

namespace nrb::model {

// Numbers solids from 0 on in the order of their first faces, so that none is without a face.
void number_solids(Model &model);

// Leaves out the layers that no face and no spline is in.
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
