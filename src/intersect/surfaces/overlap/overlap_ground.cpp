// SPDX-License-Identifier: MIT
#include "intersect/surfaces/overlap/overlap_ground.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "closest/closest.h"
#include "closest/locator.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

constexpr double far_beyond = 1; // in lengths of pieces
constexpr int64_t work_of_a_nearest_place = 4000;

} // namespace

std::optional<OverlapGround::Point> OverlapGround::point(size_t surface, const double *at) const {
    const CrossPiece *const piece = solver_.piece_at(surface, at);
    if (piece == nullptr || piece->degrees[0] == 0 || piece->degrees[1] == 0) {
        return std::nullopt;
    }
    const std::array<double, 2> place = solver_.place_in(surface, *piece, at);
    if (!(std::abs(place[0] - 0.5) <= 0.5 + far_beyond && std::abs(place[1] - 0.5) <= 0.5 + far_beyond)) {
        return std::nullopt;
    }
    count_work(8 * piece->piece.coefficients());
    const CrossPiece::Point found = piece->evaluate(place);
    Point result{found.at, found.slope};
    for (size_t k = 0; k < 2; ++k) {
        result.slope[k] = (1 / (piece->range[k].upper - piece->range[k].lower)) * found.slope[k];
    }
    return result;
}

bool OverlapGround::find_foot(size_t surface, const Vector3 &of, double *at) const {
    constexpr int most_steps = 16;
    constexpr double near = 0x1p-50;
    double last = infinity;
    for (int i = 0; i < most_steps; ++i) {
        const std::optional<Point> own = point(surface, at);
        if (!own) {
            return false;
        }
        const std::array<double, 2> by = parameters_along(own->slope, of - own->at);
        const double step = length(by[0] * own->slope[0] + by[1] * own->slope[1]);
        if (!std::isfinite(step)) {
            return false;
        }
        if (step <= near || (step >= last / 2 && step <= 0x1p-40)) {
            return true;
        }
        last = step;
        at[0] += by[0];
        at[1] += by[1];
    }
    return false;
}

std::optional<std::array<double, 2>> OverlapGround::nearest(size_t surface, const Vector3 &of,
                                                            double near) const {
    const Spline &spline = *splines_[surface];
    const std::array<double, 3> x{frame_.original(0, of.x), frame_.original(1, of.y),
                                  frame_.original(2, of.z)};
    count_work(work_of_a_nearest_place);
    const double distance = frame_.unscaled(near);
    const closest::Foot foot = closest::locator_of(spline).nearest(
        {x.data(), nullptr, distance / 16, closest::usual_budget(spline), false, true});
    if (!(foot.distance <= distance)) {
        return std::nullopt;
    }
    return std::array<double, 2>{foot.params[0], foot.params[1]};
}

Interval OverlapGround::domain(size_t surface, size_t axis) const noexcept {
    const pieces::PieceGrid &own = grid(surface);
    const int k = static_cast<int>(axis);
    return {own.break_at(k, 0), own.break_at(k, own.count(k))};
}

double OverlapGround::apart(const CrossPlace &at, const CrossPlace &other) const {
    double most = 0;
    for (size_t s = 0; s < 2; ++s) {
        const std::optional<Point> own = point(s, &at[2 * s]);
        if (!own) {
            return infinity;
        }
        for (size_t k = 0; k < 2; ++k) {
            double by = at[2 * s + k] - other[2 * s + k];
            if (borders(s).wraps(k)) {
                const double period = borders(s).period(k);
                by -= period * std::round(by / period);
            }
            most = std::max(most, std::abs(by) * length(own->slope[k]));
        }
    }
    return most;
}

} // namespace nrb::intersect
