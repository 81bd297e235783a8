// SPDX-License-Identifier: MIT
#include "base/error.h"
#include "io/iges/geometry/geometry.h"
#include "io/iges/geometry/spline.h"

namespace nrb::io::iges {
namespace {

using model::SurfaceKind;
using model::SurfaceShape;

SurfaceShape shape_of(SurfaceKind kind) {
    SurfaceShape shape{kind, {}, {0, 0}, {}, nullptr, {}, nullptr, 0, true, true, nullptr};
    shape.place.dim = 3;
    return shape;
}

Surface of_spline(SplinePtr spline) {
    SurfaceShape shape = shape_of(SurfaceKind::spline);
    shape.spline = std::move(spline);
    return {std::make_shared<const SurfaceShape>(std::move(shape))};
}

} // namespace

bool is_surface(int type) noexcept {
    return type == spline_surface_type;
}

Surface Geometry::read_surface(Reading &reading) {
    auto &[entry, record, place, parts] = reading;
    switch (entry.type) {
    case spline_surface_type:
        return of_spline(build_spline(read_surface_data(record), place));
    default:
        fail(Status::unsupported, "is not read as a surface in this version");
    }
}

} // namespace nrb::io::iges
