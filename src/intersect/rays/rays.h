// SPDX-License-Identifier: MIT
// Where rays meet a surface.
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
    ray_hit = 1,       // proven to be one, for a surface and a ray that rounding has moved
    ray_certified = 2, // nothing is nearer; without a hit: there is none
    ray_touch = 4,     // as far as rounding can tell
    ray_back = 8,      // from the side that the normal does not point to
};

struct RayAnswer {
    std::array<double, 2> params{};
    double t = 0;
    int32_t status = 0;
    Interval ts{};       // of a touch: where it may be
    bool inside = false; // of a Bezier piece, for certain
};

// The meets that come first, of those up to the hit.
struct FirstMeets {
    std::optional<RayAnswer> hit, touch;
    double room = 0;      // how far rounding may move t
    bool complete = true; // whether there are no others

    [[nodiscard]] double touch_from() const noexcept { return touch ? touch->ts.lower : infinity; }
    // Whether the touch may be before the hit.
    [[nodiscard]] bool touches_before() const noexcept {
        return touch_from() < (hit ? hit->t - 64 * room : infinity);
    }
    // Of the two meets the one that is told, with its status. None: NaN.
    [[nodiscard]] RayAnswer answer() const noexcept;
};

// Which places of a surface count: 1 if all of a box of parameters does, -1 if none of it does, 0 where that is not known,
// so that a hit there is a touch. Empty: all.
using PlaceFilter = std::function<int(const std::array<Interval, 2> &box)>;

// Calls with one ray after the other. Precondition: a surface in space; finite origins, directions with a length.
class RayCaster {
public:
    explicit RayCaster(const Spline &surface, PlaceFilter filter = {});
    ~RayCaster();
    RayCaster(const RayCaster &) = delete;
    RayCaster &operator=(const RayCaster &) = delete;

    [[nodiscard]] FirstMeets first(const RayQuery &query);
    // All of them, rising. Returns whether they are proven to be; room: how far rounding may move t.
    bool all(const RayQuery &query, std::vector<RayAnswer> &out, double *room = nullptr);

private:
    class Cast;
    std::unique_ptr<Cast> cast_;
};

} // namespace nrb::intersect
