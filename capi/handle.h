// SPDX-License-Identifier: MIT
// The opaque types of the C API.
#pragma once

#include "face/face.h"
#include "intersect/levels/level_meet.h"
#include "mesh/mesh.h"
#include "model/model.h"
#include "refine/parts/cut.h"
#include "spline/spline.h"

#include <nurbs/nurbs.h>
#include <variant>
#include <vector>

struct nurbs {
    nrb::SplinePtr spline;
};

namespace nrb::capi {

using NamedSplines = std::vector<model::NamedSpline>;

// The parts of one spline. A part becomes a spline of its own when the caller takes it.
struct Parts {
    refine::PartedSpline spline;
    bool named_by_axes; // by their indices along the axes, such as "2,0", not by one index
};

} // namespace nrb::capi

struct nurbs_face {
    nrb::face::FacePtr face;
};

struct nurbs_model {
    nrb::model::ModelPtr model;
};

struct nurbs_meet {
    std::shared_ptr<const nrb::intersect::Meet> meet;
};

struct nurbs_mesh {
    nrb::mesh::MeshPtr mesh;
};

struct nurbs_list {
    std::variant<nrb::capi::NamedSplines, nrb::capi::Parts, nrb::model::Model> contents;
};

namespace nrb::capi {

// Hands a spline or a model over to the caller in a new handle.
inline void give(SplinePtr spline, ::nurbs **out) {
    *out = new ::nurbs{std::move(spline)};
}
inline void give(model::Model made, ::nurbs_model **out) {
    *out = new ::nurbs_model{std::make_shared<const model::Model>(std::move(made))};
}

} // namespace nrb::capi
