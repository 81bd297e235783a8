// The two opaque types of the C API.
#pragma once

#include "model/document.h"
#include "refine/parts/cut.h"
#include "spline/spline.h"

#include <nurbs/nurbs.h>
#include <optional>
#include <string>

struct nurbs {
    nrb::SplinePtr spline;
};

// Splines with names and notes, or else the parts of one spline, which are made when they are taken.
struct nurbs_list {
    nrb::model::Document document;
    std::optional<nrb::refine::PartedSpline> parts = std::nullopt;
    bool named_by_axes = false; // parts: by their place on every axis

    [[nodiscard]] int64_t size() const noexcept;
    // Precondition: 0 <= index < size().
    [[nodiscard]] nrb::SplinePtr spline(int64_t index) const;
    [[nodiscard]] std::string name(int64_t index) const;
};

namespace nrb::capi {

// Hands a spline to the caller in a handle of its own.
inline void give(SplinePtr spline, ::nurbs **out) {
    *out = new ::nurbs{std::move(spline)};
}

} // namespace nrb::capi
