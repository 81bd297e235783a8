// SPDX-License-Identifier: MIT
// Coons surfaces and volumes from their boundaries, and the boundaries of surfaces and volumes.
#include "checks.h"
#include "guard.h"
#include "lists.h"

#include "base/tolerance.h"
#include "build/coons/boundary.h"
#include "build/coons/coons.h"
#include "build/coons/coons_volume.h"

#include <cmath>

using namespace nrb;
using namespace nrb::capi;

namespace {

std::vector<SplinePtr> splines_at(const nurbs *const *handles, int64_t count, const char *name) {
    return handles == nullptr ? std::vector<SplinePtr>() : splines_of(count, handles, name);
}

build::PatchCurves curves_of(const nurbs *const *boundaries, const nurbs *const *cross) {
    require(boundaries, "boundaries");
    return build::make_patch_curves(splines_at(boundaries, 4, "boundaries"), splines_at(cross, 4, "cross"));
}

void check_twists_given(const double *twists, int32_t dim) {
    require(twists, "twists");
    for (int64_t i = 0; i < build::corner_count * int64_t{dim}; ++i) {
        if (!std::isfinite(twists[i])) {
            fail(Status::point_not_finite, "twists[%lld][%lld] = %s is not finite",
                 static_cast<long long>(i / dim), static_cast<long long>(i % dim), Number(twists[i]).text);
        }
    }
}

void check_rule(int32_t twist, const double *twists, bool has_cross, int32_t dim) {
    if (twist < NURBS_TWIST_COMPATIBLE || twist > NURBS_TWIST_ADINI) {
        fail(Status::twist_rule, "twist = %d, expected one of the NURBS_TWIST_ constants", twist);
    }
    if (!has_cross && (twist == NURBS_TWIST_COMPATIBLE || twist == NURBS_TWIST_AVERAGE)) {
        fail(Status::twist_rule, "twist = %d takes the twists of cross tangents, but cross is NULL", twist);
    }
    if (twist == NURBS_TWIST_GIVEN) {
        check_twists_given(twists, dim);
    } else if (twists != nullptr) {
        fail(Status::twist_rule, "twists are given, expected NULL unless twist is NURBS_TWIST_GIVEN");
    }
}

} // namespace

nurbs_status nurbs_boundaries(const nurbs *g, nurbs_list **out) {
    return guard([&] {
        require_out(out);
        std::vector<SplinePtr> boundaries = build::boundaries_of(spline_of(g));
        NamedSplines named;
        for (size_t i = 0; i < boundaries.size(); ++i) {
            named.push_back({std::to_string(i / 2) + (i % 2 == 0 ? "-" : "+"), std::move(boundaries[i])});
        }
        give_list(std::move(named), out);
    });
}

nurbs_status nurbs_surface_coons(const nurbs *const *boundaries, double tolerance, nurbs **out) {
    return guard([&] {
        require_out(out);
        check_tolerance(tolerance);
        give(build::surface_coons(curves_of(boundaries, nullptr), tolerance), out);
    });
}

nurbs_status nurbs_surface_coons_hermite(const nurbs *const *boundaries, const nurbs *const *cross,
                                         int32_t twist, const double *twists, double tolerance, double *bound,
                                         nurbs **out) {
    return guard([&] {
        require_out(out);
        check_tolerance(tolerance);
        const build::PatchCurves curves = curves_of(boundaries, cross);
        check_rule(twist, twists, cross != nullptr, curves.dim());
        check_apart({memory("bound", bound, 1)}, {memory("twists", twists, 4 * int64_t{curves.dim()})});
        build::HermitePatch made = build::surface_coons_hermite(curves, {twist, twists}, tolerance);
        give(std::move(made.surface), out);
        if (bound != nullptr) {
            *bound = made.twist_gap;
        }
    });
}

nurbs_status nurbs_coons_gaps(const nurbs *const *boundaries, const nurbs *const *cross, double *positions,
                              double *tangents, double *twists) {
    return guard([&] {
        require(positions, "positions");
        check_apart(
            {memory("positions", positions, 4), memory("tangents", tangents, 8), memory("twists", twists, 4)},
            {});
        const build::CornerGaps gaps = build::corner_gaps(curves_of(boundaries, cross));
        for (size_t i = 0; i < build::corner_count; ++i) {
            positions[i] = gaps.positions[i];
            for (size_t k = 0; k < 2 && tangents != nullptr; ++k) {
                tangents[2 * i + k] = gaps.tangents[i][k];
            }
            if (twists != nullptr) {
                twists[i] = gaps.twists[i];
            }
        }
    });
}

nurbs_status nurbs_volume_coons(const nurbs *const *faces, double tolerance, nurbs **out) {
    return guard([&] {
        require_out(out);
        check_tolerance(tolerance);
        require(faces, "faces");
        give(build::volume_coons(splines_of(6, faces, "faces"), tolerance), out);
    });
}
