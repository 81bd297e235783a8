// SPDX-License-Identifier: MIT
// Rays: a place they are cast at is not missed with a certificate, whatever the surface.
#include "fuzz/harness.h"

#include <array>
#include <cmath>

namespace {

using fuzz::Input;

constexpr int64_t most = 64;
using Point = std::array<double, 3>;

Point any_point(Input &in, const fuzz::Spline &s) {
    Point x{};
    for (double &c : x) {
        c = in.rarely() ? in.anything() : in.coin() ? in.number() : s.size() * (2 * in.unit() - 1);
    }
    return x;
}

void first(const nurbs *g, const Point &from, const Point &along, bool aimed) {
    double uv[2] = {0, 0}, t = 0;
    int32_t status = 0;
    if (!FUZZ_OK(nurbs_surface_rays(g, 1, from.data(), 0, 0, along.data(), 0, 0, uv, &t, &status))) {
        return;
    }
    const bool found = (status & (NURBS_RAY_HIT | NURBS_RAY_TOUCH)) != 0;
    FUZZ_REQUIRE(found == !std::isnan(t));
    FUZZ_REQUIRE((status & ~0x0f) == 0);
    if (aimed && (status & NURBS_RAY_CERTIFIED) != 0) {
        FUZZ_REQUIRE(found && t <= 1 + 1e-6);
    }
    double domain[2];
    for (int32_t k = 0; k < 2 && found; ++k) {
        FUZZ_REQUIRE(nurbs_domain(g, k, domain) == NURBS_OK);
        FUZZ_REQUIRE(uv[k] >= domain[0] && uv[k] <= domain[1]);
    }
}

void all(const nurbs *g, const Point &from, const Point &along, const double *range) {
    double uv[2 * most], t[most];
    int32_t kinds[most], complete = -1;
    int64_t count = 0;
    if (FUZZ_OK(nurbs_surface_ray_hits(g, from.data(), along.data(), range, most, uv, t, kinds, &count,
                                       &complete))) {
        FUZZ_REQUIRE(count >= 0 && count <= most && (complete == 0 || complete == 1));
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Input in(data, size);
    const fuzz::Spline s = fuzz::any_spline(in);
    const fuzz::Handle g(fuzz::create(s));
    if (!g) {
        return 0;
    }
    const Point from = any_point(in, s);
    Point along = any_point(in, s);
    first(g.get(), from, along, false);
    const double range[] = {in.number(), in.coin() ? HUGE_VAL : in.number()};
    all(g.get(), from, along, range);
    if (s.degrees.size() == 2 && s.dim == 3) {
        const double uv[] = {fuzz::any_param(in, g.get(), 0, true), fuzz::any_param(in, g.get(), 1, true)};
        Point at{};
        if (FUZZ_OK(nurbs_eval(g.get(), 1, uv, 0, 0, at.data(), 0, 0, 0))) {
            double apart = 0;
            for (size_t c = 0; c < 3; ++c) {
                along[c] = at[c] - from[c];
                apart = std::max(apart, std::abs(along[c]));
            }
            const bool clear = apart > 1e-3 * s.size() && std::isfinite(apart) && apart < 1e3 * s.size();
            first(g.get(), from, along, clear);
        }
    }
    nurbs_call_options call;
    FUZZ_REQUIRE(nurbs_call_options_init(&call, sizeof call) == NURBS_OK);
    call.work = in.below(1000) + 1;
    int32_t status = 0;
    FUZZ_OK(nurbs_surface_rays_with(g.get(), 1, from.data(), 0, 0, along.data(), 0, 0, nullptr, nullptr,
                                    &status, &call));
    return 0;
}
