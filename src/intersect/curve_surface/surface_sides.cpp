// SPDX-License-Identifier: MIT
#include "intersect/curve_surface/surface_sides.h"

#include "base/numbers.h"
#include "closest/locator.h"
#include "eval/curve_point.h"
#include "numeric/norm.h"
#include "numeric/vector3.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nrb::intersect {

namespace {

// A way along the curve from a place on, up or down, near which the surface is at parameters of its own.
struct SpaceWay {
    double from;
    std::array<double, 2> on_surface;
    bool up;
    double first, most; // lengths of the first step and of all, in parameters of the curve
    double width;       // how far from the place on the surface its foot may be to begin with
};

class SideOfSurface {
public:
    SideOfSurface(const Spline &curve, const Spline &surface, const Seams &seams, double noise)
        : curve_(curve), surface_(surface), seams_(seams), noise_(noise) {}

    // 1 or -1: above or below; 0 where the curve ends before, or the surface does, or it goes too far.
    [[nodiscard]] int along(const SpaceWay &way) const {
        const Interval domain = seams_.domain(0);
        const std::vector<double> from = point(way.from);
        for (double step = way.first; step <= way.most; step *= 4) {
            const double t = way.up ? way.from + step : way.from - step;
            if (seams_.period(0) == 0 && (t < domain.lower || t > domain.upper)) {
                return 0;
            }
            const std::vector<double> x = point(t);
            const double reach = way.width + 4 * distance(from.data(), x.data(), 3) + 8 * noise_;
            if (const int side = at(x.data(), way.on_surface, reach)) {
                return side;
            }
        }
        return 0;
    }

private:
    [[nodiscard]] std::vector<double> point(double t) const {
        return eval::curve_point(curve_, seams_.in_domain(0, t), false);
    }
    // The point and both derivatives.
    [[nodiscard]] std::array<Vector3, 3> jet(const double *params) const {
        std::array<double, 9> values{};
        eval::evaluate_points(surface_, {}, 1, {params, 1, 2, 2, 1}, {values.data(), 1, 9, 9, 1});
        const auto vector = [&](size_t i) {
            return Vector3{values[3 * i], values[3 * i + 1], values[3 * i + 2]};
        };
        return {vector(0), vector(1), vector(2)};
    }
    // The foot of a perpendicular tells the side; a border and an edge do not, nor a foot that is elsewhere.
    [[nodiscard]] int at(const double *x, const std::array<double, 2> &guess, double reach) const {
        const double start[] = {seams_.in_domain(1, guess[0]), seams_.in_domain(2, guess[1])};
        const closest::Foot foot = closest::locator_of(surface_).local(x, start);
        const std::array<Vector3, 3> here = jet(foot.params.data());
        if (length(here[0] - jet(start)[0]) > reach) {
            return 0;
        }
        const Vector3 offset = Vector3{x[0], x[1], x[2]} - here[0],
                      normal = unit(cross(scaled_to_one(here[1]), scaled_to_one(here[2])));
        const double away = length(offset), height = dot(normal, offset);
        const bool perpendicular = std::abs(height) > 0.5 * away;
        return !perpendicular || !(away > 2 * noise_) ? 0 : height > 0 ? 1 : -1;
    }

    const Spline &curve_, &surface_;
    const Seams &seams_;
    double noise_;
};

} // namespace

bool changes_side(const Spline &curve, const Spline &surface, const Seams &seams, const MeetGroup &group,
                  double reach, double noise) {
    const Interval domain = seams.domain(0), part = group.box[0];
    const double length = domain.upper - domain.lower, size = std::max(std::abs(part.lower), length),
                 width = part.upper - part.lower, first = std::max(width / 16, 16 * eps * size),
                 most = std::min(std::max(16 * width, 0x1p-20 * length), length / 4);
    const auto last =
        std::ranges::max_element(group.cells, {}, [](const MeetCell &x) { return x.box[0].upper; });
    const MeetPlace &at_first = group.cells.front().at, &at_last = last->at;
    const SpaceWay down{part.lower, {at_first[1], at_first[2]}, false, first, most, reach},
        up{part.upper, {at_last[1], at_last[2]}, true, first, most, reach};
    const SideOfSurface side(curve, surface, seams, noise);
    return side.along(down) * side.along(up) < 0;
}

} // namespace nrb::intersect
