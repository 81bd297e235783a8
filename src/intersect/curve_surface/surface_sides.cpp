// SPDX-License-Identifier: MIT
#include "intersect/curve_surface/surface_sides.h"

#include "base/numbers.h"
#include "closest/locator.h"
#include "eval/curve_point.h"
#include "eval/frames/magnitude.h"
#include "numeric/norm.h"
#include "numeric/vector3.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nrb::intersect {

namespace {

// A walk along the curve from a place, up or down; near that place the surface has the given parameters.
struct SpaceWay {
    double from;
    std::array<double, 2> on_surface;
    bool up;
    double first, most; // distances of the first and of the last allowed sample, in parameters of the curve
    double width;       // how far from the place on the surface the foot point may be at the start
};

// A side, and the normal that points to the positive one.
struct Side {
    int sign = 0; // 1 or -1; 0: not known
    Vector3 normal;
};

class SideOfSurface {
public:
    SideOfSurface(const Spline &curve, const Spline &surface, const Seams &seams, double noise)
        : curve_(curve), surface_(surface), seams_(seams), noise_(noise) {}

    // The side along a walk; unknown if the curve or the surface ends first, or the walk becomes too long.
    [[nodiscard]] Side along(const SpaceWay &way) const {
        const Interval domain = seams_.domain(0);
        const std::vector<double> from = point(way.from);
        double step = way.first;
        while (step <= way.most) {
            const double t = way.up ? way.from + step : way.from - step;
            if (seams_.period(0) == 0 && (t < domain.lower || t > domain.upper)) {
                return {};
            }
            const std::vector<double> x = point(t);
            const double reach = way.width + 4 * distance(from.data(), x.data(), 3) + 8 * noise_;
            const Side side = at(x.data(), way.on_surface, reach);
            if (side.sign != 0) {
                return side;
            }
            step *= 4;
        }
        return {};
    }

private:
    using Params = std::array<double, 2>;

    [[nodiscard]] std::vector<double> point(double t) const {
        return eval::curve_point(curve_, seams_.in_domain(0, t), false);
    }
    [[nodiscard]] std::array<Vector3, 3> jet(const Params &params) const {
        std::array<double, 9> values{};
        eval::evaluate_points(surface_, {}, 1, {params.data(), 1, 2, 2, 1}, {values.data(), 1, 9, 9, 1});
        const auto vector = [&](size_t i) {
            return Vector3{values[3 * i], values[3 * i + 1], values[3 * i + 2]};
        };
        return {vector(0), vector(1), vector(2)};
    }
    static constexpr double little = 0x1p-16;

    // The unit normal; 0 where the surface is folded or a line of it is one point without a normal, as far as
    // that can be told.
    [[nodiscard]] Vector3 normal(const Params &params) const {
        for (size_t k = 0; k < 2; ++k) {
            const auto [lower, upper] = seams_.domain(k + 1);
            const double room = little * (upper - lower);
            for (const bool last : {false, true}) {
                if (std::abs(params[k] - (last ? upper : lower)) < room && seams_.is_pole(k + 1, last)) {
                    return normal_of_pole(k, last ? upper - room : lower + room);
                }
            }
        }
        return regular_normal(params, little * eval::active_size(surface_));
    }
    // The unit normal; 0 where a derivative, over the length of the domain, is shorter than `least`, or both
    // are parallel.
    [[nodiscard]] Vector3 regular_normal(const Params &params, double least) const {
        const std::array<Vector3, 3> here = jet(params);
        const Vector3 across = cross(unit(here[1]), unit(here[2]));
        bool regular = length(across) > little;
        for (size_t k = 0; k < 2; ++k) {
            const auto [lower, upper] = seams_.domain(k + 1);
            regular = regular && length(here[k + 1]) * (upper - lower) > least;
        }
        return regular ? unit(across) : Vector3{};
    }
    // From samples all around the pole; the apex of a cone has no normal.
    [[nodiscard]] Vector3 normal_of_pole(size_t k, double beside) const {
        constexpr int samples = 8;
        const auto [lower, upper] = seams_.domain(2 - k);
        Vector3 first{};
        for (int i = 0; i < samples; ++i) {
            Params params{beside, beside};
            params[1 - k] = lower + (upper - lower) * (i + 0.5) / samples;
            const Vector3 up = regular_normal(params, 0);
            first = i == 0 ? up : first;
            if (!(dot(first, up) > 0.99)) {
                return {};
            }
        }
        return first;
    }
    // The foot point of a perpendicular determines the side. A border or an edge does not, nor does a foot
    // point that is farther than `reach` from the guess.
    [[nodiscard]] Side at(const double *x, const Params &guess, double reach) const {
        const Params start{seams_.in_domain(1, guess[0]), seams_.in_domain(2, guess[1])};
        const closest::Foot foot = closest::locator_of(surface_).local(x, start.data());
        const Params params{foot.params[0], foot.params[1]};
        const Vector3 point = jet(params)[0];
        if (length(point - jet(start)[0]) > reach) {
            return {};
        }
        const Vector3 offset = Vector3{x[0], x[1], x[2]} - point, up = normal(params);
        const double away = length(offset), height = dot(up, offset);
        const bool perpendicular = std::abs(height) > 0.5 * away;
        return {!perpendicular || !(away > 2 * noise_) ? 0 : height > 0 ? 1 : -1, up};
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
    const Side before = side.along(down), after = side.along(up);
    return before.sign * after.sign < 0 && dot(before.normal, after.normal) > 0;
}

} // namespace nrb::intersect
