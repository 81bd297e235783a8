// SPDX-License-Identifier: MIT
// Intersections of rays with a surface.
#pragma once

#include "intersect/rays/ray.h"
#include "spline/spline.h"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace nrb::intersect {

enum RayStatus : int32_t {
    ray_hit = 1,       // proven to be one, for a surface and a ray within rounding of the given ones
    ray_certified = 2, // proven that nothing is nearer; without a hit: that there is none
    ray_touch = 4,     // as far as rounding can tell
    ray_back = 8,      // from the back, the side to which the normal does not point
};

struct RayAnswer {
    std::array<double, 2> params{};
    double t = 0;
    int32_t status = 0;
    Interval ts{};       // of a touch: its possible range
    bool inside = false; // certainly in the interior of a Bezier piece
};

// The nearest proven hit and the nearest touch. Touches beyond the hit need not be found.
struct FirstMeets {
    std::optional<RayAnswer> hit, touch;
    double room = 0;      // how far rounding may move t
    bool complete = true; // proven that nothing else comes before

    [[nodiscard]] double touch_from() const noexcept { return touch ? touch->ts.lower : infinity; }
    // Whether the touch may come before the hit.
    [[nodiscard]] bool touches_before() const noexcept {
        return touch_from() < (hit ? hit->t - 64 * room : infinity);
    }
    // The hit or the touch to be reported, with its status; NaN if there is none.
    [[nodiscard]] RayAnswer answer() const noexcept;
};

// Which places of a surface count: 1 if all of a box of parameters does, -1 if none of it does, 0 if that is
// unknown, so that a hit there is a touch. Empty: all places count.
using PlaceFilter = std::function<int(const std::array<Interval, 2> &box)>;

// Intersects one ray after another with a surface. Precondition: a surface in space; finite origins,
// directions with a length.
class RayCaster {
public:
    explicit RayCaster(const Spline &surface, PlaceFilter filter = {});
    ~RayCaster();
    RayCaster(const RayCaster &) = delete;
    RayCaster &operator=(const RayCaster &) = delete;

    [[nodiscard]] FirstMeets first(const RayQuery &query);
    // Appends all intersections, by ascending t. Returns whether they are proven to be hits, and all of them;
    // room: how far rounding may move t.
    bool all(const RayQuery &query, std::vector<RayAnswer> &out, double *room = nullptr);

private:
    class Cast;
    std::unique_ptr<Cast> cast_;
};

} // namespace nrb::intersect
