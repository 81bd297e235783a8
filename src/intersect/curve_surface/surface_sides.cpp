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
    struct Tangent {
        Vector3 point, normal; // of no length, if there is none
    };
    [[nodiscard]] Tangent tangent(const std::array<double, 2> &params) const {
        std::array<double, 9> values{};
        eval::evaluate_points(surface_, {}, 1, {params.data(), 1, 2, 2, 1}, {values.data(), 1, 9, 9, 1});
        const auto vector = [&](size_t i) {
            return Vector3{values[3 * i], values[3 * i + 1], values[3 * i + 2]};
        };
        const Vector3 u = vector(1), v = vector(2), normal = cross(scaled_to_one(u), scaled_to_one(v));
        const double size = length(scaled_to_one(u)) * length(scaled_to_one(v));
        return {vector(0), length(normal) > 1e-6 * size ? unit(normal) : Vector3{}};
    }
    // At a pole the one that is a little way off.
    [[nodiscard]] Vector3 normal(const std::array<double, 2> &params) const {
        std::array<double, 2> off = params;
        for (size_t k = 0; k < 2; ++k) {
            const auto [lower, upper] = seams_.domain(k + 1);
            off[k] += (lower / 2 + upper / 2 - off[k]) * 0x1p-16;
        }
        const Tangent here = tangent(params), there = tangent(off);
        return length(here.normal) > 0 ? here.normal : there.normal;
    }
    // The foot of a perpendicular tells the side; a border and an edge do not, nor a foot that is elsewhere.
    [[nodiscard]] int at(const double *x, const std::array<double, 2> &guess, double reach) const {
        const std::array<double, 2> start{seams_.in_domain(1, guess[0]), seams_.in_domain(2, guess[1])};
        const closest::Foot foot = closest::locator_of(surface_).local(x, start.data());
        const std::array<double, 2> params{foot.params[0], foot.params[1]};
        const Vector3 point = tangent(params).point;
        if (length(point - tangent(start).point) > reach) {
            return 0;
        }
        const Vector3 offset = Vector3{x[0], x[1], x[2]} - point;
        const double away = length(offset), height = dot(normal(params), offset);
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
