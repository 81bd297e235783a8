// The two opaque types of the C API.
#pragma once

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

// The parts of one spline, which are made when they are taken.
struct Parts {
    refine::PartedSpline spline;
    bool named_by_axes; // by their place on every axis, not by their index
};

} // namespace nrb::capi

struct nurbs_list {
    std::variant<nrb::capi::NamedSplines, nrb::capi::Parts, nrb::model::Model> contents;
};

namespace nrb::capi {

// Hands a spline to the caller in a handle of its own.
inline void give(SplinePtr spline, ::nurbs **out) {
    *out = new ::nurbs{std::move(spline)};
}

} // namespace nrb::capi
