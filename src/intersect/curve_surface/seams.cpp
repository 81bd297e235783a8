// SPDX-License-Identifier: MIT
#include "intersect/curve_surface/seams.h"

#include "eval/evaluate.h"
#include "eval/frames/magnitude.h"
#include "intersect/pairs/periods.h"
#include "refine/knots/bezier_rows.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

Seams::Seams(const Spline &curve, const Spline &surface)
    : curve_(curve),
      surface_(surface), breaks_{Breaks(curve.axis(0)), Breaks(surface.axis(0)), Breaks(surface.axis(1))} {
    jumps_[0] = jumps_of(curve);
    set_jumps(0);
    set_jumps(1);
}

void Seams::set_jumps(int axis) {
    const KnotVector &knots = surface_.axis(axis);
    std::vector<double> &jumps = jumps_[static_cast<size_t>(axis) + 1];
    for (const double t : refine::breaks_of(knots)) {
        const Interval domain = knots.domain();
        if (t > domain.lower && t < domain.upper && multiplicity(knots.knots(), t) > knots.degree() &&
            !are_one_line(line(axis, t, true), line(axis, t, false))) {
            jumps.push_back(t);
        }
    }
}

// 2 q + 1 points in each span determine a rational curve of degree q.
Seams::Rows Seams::line(int axis, double t, bool left) const {
    const int other = 1 - axis;
    const KnotVector &along = surface_.axis(other);
    const std::vector<double> breaks = refine::breaks_of(along);
    const int samples = 2 * along.degree() + 1;
    std::vector<double> params;
    for (size_t i = 0; i + 1 < breaks.size(); ++i) {
        for (int j = 0; j < samples; ++j) {
            const double share = (j + 0.5) / samples, s = breaks[i] * (1 - share) + breaks[i + 1] * share;
            params.insert(params.end(), {axis == 0 ? t : s, axis == 0 ? s : t});
        }
    }
    eval::AxisRules rules{};
    rules[static_cast<size_t>(axis)].left = left;
    Rows rows(params.size() / 2);
    eval::evaluate_points(surface_, rules, 0, {params.data(), static_cast<int64_t>(rows.size()), 2, 2, 1},
                          {rows.front().data(), static_cast<int64_t>(rows.size()), 3, 3, 1});
    return rows;
}

bool Seams::are_one_line(const Rows &x, const Rows &y) const {
    const double size = eval::active_size(surface_);
    return std::equal(x.begin(), x.end(), y.begin(), [size](const auto &a, const auto &b) {
        return are_one_point(a.data(), b.data(), 3, size);
    });
}

double Seams::period(size_t k) const {
    const auto [lower, upper] = domain(k);
    if (!closes_[k]) {
        closes_[k] = k == 0 ? periodic(k) && closes(curve_)
                            : are_one_line(line(static_cast<int>(k) - 1, lower, false),
                                           line(static_cast<int>(k) - 1, upper, true));
    }
    return *closes_[k] ? upper - lower : 0;
}

bool Seams::is_pole(size_t k, bool upper) const {
    std::optional<bool> &pole = poles_[2 * k + (upper ? 1 : 0)];
    if (!pole) {
        const Interval domain = this->domain(k);
        const Rows rows = line(static_cast<int>(k) - 1, upper ? domain.upper : domain.lower, upper);
        const double size = eval::active_size(surface_);
        pole = period(3 - k) > 0 && std::all_of(rows.begin(), rows.end(), [&](const auto &x) {
                   return are_one_point(x.data(), rows.front().data(), 3, size);
               });
    }
    return *pole;
}

bool Seams::ends_at(size_t k, bool upper) const {
    return period(k) == 0 && (k == 0 || !is_pole(k, upper));
}

bool Seams::reach_end(const MeetBox &box) const {
    for (size_t k = 0; k < 3; ++k) {
        const auto [lower, upper] = domain(k);
        if ((box[k].lower <= lower && ends_at(k, false)) || (box[k].upper >= upper && ends_at(k, true))) {
            return true;
        }
    }
    return false;
}

std::array<int64_t, 3> Seams::segments(const MeetPlace &at) const {
    std::array<int64_t, 3> parts{};
    for (size_t k = 0; k < 3; ++k) {
        parts[k] = std::ranges::upper_bound(jumps_[k], at[k]) - jumps_[k].begin();
    }
    return parts;
}

double Seams::in_domain(size_t k, double t) const {
    const auto [lower, upper] = domain(k);
    if ((t < lower || t > upper) && period(k) > 0) {
        t -= std::floor((t - lower) / period(k)) * period(k);
    }
    return std::clamp(t, lower, upper);
}

Interval Seams::range(size_t k, Interval part) const {
    const auto [lower, upper] = domain(k);
    if (part.lower >= lower && part.upper <= upper) {
        return part;
    }
    const double length = period(k), by = std::floor((part.lower - lower) / length) * length;
    return part.upper - part.lower >= length ? domain(k) : Interval{part.lower - by, part.upper - by};
}

} // namespace nrb::intersect
