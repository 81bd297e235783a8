// SPDX-License-Identifier: MIT
#include "base/error.h"
#include "fit/offset/offset_side.h"
#include "fit/offset/offset_surface.h"
#include "model/shapes/surface_spline.h"

#include <algorithm>

namespace nrb::model {

namespace {

// The nested offsets and trims of a surface, innermost first, and the surface under them.
struct Chain {
    std::vector<const SurfaceShape *> steps;
    const SurfaceShape *base;
    Rectangle range; // in the parameters of the base
};

Chain chain_of(const SurfaceShape &surface, const Rectangle &range) {
    Chain chain{{}, &surface, range};
    while (chain.base->kind == SurfaceKind::offset || chain.base->kind == SurfaceKind::trimmed) {
        if (chain.base->kind == SurfaceKind::trimmed) {
            chain.range = range_in_basis(*chain.base, chain.range);
        }
        chain.steps.push_back(chain.base);
        chain.base = chain.base->basis.get();
    }
    std::ranges::reverse(chain.steps);
    return chain;
}

// 1 if the normal of the offset of a spline is that of the spline, -1 if it is opposite.
int side_of(const SplinePtr &spline, double distance, const fit::OffsetRule &rule) {
    const int side = fit::offset_side(spline, distance, rule);
    if (side == 0) {
        fail(Status::unsupported,
             "the normal of the surface at the distance %s, from which it is offset, is not known to be on "
             "one side",
             Number(distance).text);
    }
    return side;
}

// The total offset along the normal of the base: the sum of all distances, each with the sign that the
// normals before it give.
double distance_of(const Chain &chain, const SplinePtr &spline, const fit::OffsetRule &rule) {
    double sum = 0;
    bool mirrored = false, known = true; // known: whether `side` is that at `sum`
    int side = 1;
    for (const SurfaceShape *step : chain.steps) {
        if (step->kind == SurfaceKind::trimmed) {
            mirrored ^= step->u_forward != step->v_forward;
        } else if (step->distance != 0) {
            side = known ? side : side_of(spline, sum, rule);
            sum += (mirrored ? -side : side) * step->distance;
            known = false;
        }
    }
    return sum;
}

} // namespace

MadeSurface made_surface(const SurfaceShape &surface, const Rectangle &range, const SurfaceRule &rule) {
    const Chain chain = chain_of(surface, range);
    const fit::OffsetRule patches{rule.tolerance, rule.most_patches, rule.left};
    MadeSurface made{surface_spline(*chain.base, chain.range)};
    if (const double distance = distance_of(chain, made.spline, patches); distance != 0) {
        fit::OffsetSurface offset = fit::offset_surface(made.spline, distance, patches);
        made = {std::move(offset.spline), offset.bound};
    }
    for (const SurfaceShape *step : chain.steps) {
        made.spline =
            step->kind == SurfaceKind::trimmed ? directed(*step, std::move(made.spline)) : made.spline;
    }
    return made;
}

} // namespace nrb::model
