// The two opaque types of the C API.
#pragma once

#include "io/document.h"
#include "spline/spline.h"

#include <nurbs/nurbs.h>

struct nurbs {
    nrb::SplinePtr spline;
};

struct nurbs_list {
    nrb::Document document;
};

namespace nrb::capi {

// Hands a spline to the caller in a handle of its own.
inline void give(SplinePtr spline, ::nurbs **out) {
    *out = new ::nurbs{std::move(spline)};
}

} // namespace nrb::capi
