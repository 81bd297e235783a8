// SPDX-License-Identifier: MIT
#include "intersect/surfaces/overlap/overlap_borders.h"

#include "base/error.h"
#include "base/numbers.h"
#include "base/watch.h"
#include "intersect/curve_surface/curve_surface.h"
#include "refine/parts/iso.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

constexpr int places_of_a_half = 32;

class BorderFinder {
public:
    BorderFinder(const OverlapGround &ground, double tolerance, double near)
        : ground_(ground), follower_(ground), tolerance_(tolerance), near_(near) {}

    std::optional<OverlapBorders> run() {
        if (!add_sides(0) || !add_sides(1)) {
            return std::nullopt;
        }
        for (size_t side = 0; side < found_.sides.size(); ++side) {
            if (work_ended() || !add_runs(side)) {
                return std::nullopt;
            }
        }
        return std::move(found_);
    }

private:
    // False: the surface has a jump inside.
    bool add_sides(size_t surface) {
        const pieces::PieceGrid &grid = ground_.grid(surface);
        const SurfaceBorders &borders = ground_.borders(surface);
        for (size_t axis = 0; axis < 2; ++axis) {
            const int k = static_cast<int>(axis);
            for (int64_t i = 1; i < grid.count(k); ++i) {
                if (grid.jumps(k, i)) {
                    return false;
                }
            }
            for (size_t end = 0; end < 2 && !borders.wraps(axis); ++end) {
                if (!borders.is_collapsed(axis, end == 0 ? 0 : grid.count(k) - 1, end == 1)) {
                    add_side(surface, axis, end);
                }
            }
        }
        return true;
    }
    void add_side(size_t surface, size_t axis, size_t end) {
        OverlapSide side{surface, axis, end, 0, {}, false, 0, nullptr};
        const Interval domain = ground_.domain(surface, axis);
        side.at = end == 0 ? domain.lower : domain.upper;
        side.range = ground_.domain(surface, 1 - axis);
        side.closes = ground_.borders(surface).wraps(1 - axis);
        side.period = ground_.borders(surface).period(1 - axis);
        eval::AxisRule rule;
        rule.left = end == 1;
        side.curve = refine::iso(ground_.spline(surface), static_cast<int>(axis), side.at, rule);
        found_.sides.push_back(std::move(side));
    }

    [[nodiscard]] static CrossPlace place_of(const OverlapSide &side,
                                             const std::array<double, 3> &at) noexcept {
        CrossPlace place{};
        place[side.fixed()] = side.at;
        place[side.free()] = at[0];
        place[2 * (1 - side.surface)] = at[1];
        place[2 * (1 - side.surface) + 1] = at[2];
        return place;
    }

    // False: it is left open what the side does.
    bool add_runs(size_t index) {
        const OverlapSide &side = found_.sides[index];
        const SurfaceHits hits = curve_surface(*side.curve, ground_.spline(1 - side.surface), tolerance_);
        if (!hits.complete) {
            return false;
        }
        const size_t first = found_.runs.size();
        for (const SurfaceHit &hit : hits.list) {
            if (hit.kind != HitKind::overlap) {
                found_.single.push_back(place_of(side, hit.at));
            } else if (!add_run(index, hit)) {
                return false;
            }
        }
        if (!join_over_seam(side, first)) {
            return false;
        }
        return std::all_of(found_.runs.begin() + static_cast<std::ptrdiff_t>(first), found_.runs.end(),
                           [&](OverlapRun &run) { return set_ends(side, run); });
    }
    bool add_run(size_t index, const SurfaceHit &hit) {
        const OverlapSide &side = found_.sides[index];
        OverlapRun run{index, false, {place_of(side, hit.at)}, {}};
        for (const double end : {hit.range[0].lower, hit.range[0].upper}) {
            CrossPlace from = run.places.front();
            const double start = hit.at[0];
            std::vector<CrossPlace> way;
            for (int i = 1; i <= places_of_a_half; ++i) {
                const double to = i == places_of_a_half ? end : start + (end - start) * i / places_of_a_half;
                const std::optional<CrossPlace> next = follower_.next(side, from, to);
                if (!next) {
                    return false;
                }
                from = *next;
                way.push_back(from);
            }
            run.places.insert(run.places.end(), way.begin(), way.end());
        }
        std::ranges::sort(run.places, {}, [&](const CrossPlace &place) { return place[side.free()]; });
        const double length = hit.range[0].upper - hit.range[0].lower;
        run.closed = side.closes && length >= (1 - 0x1p-40) * side.period;
        found_.runs.push_back(std::move(run));
        return true;
    }
    bool set_ends(const OverlapSide &side, OverlapRun &run) const {
        run.ends = {run.places.front(), run.places.back()};
        return run.closed ||
               std::ranges::all_of(run.ends, [&](CrossPlace &end) { return set_end(side, end); });
    }

    // Joins the run that ends where the side closes with the one that begins there.
    bool join_over_seam(const OverlapSide &side, size_t first) {
        std::vector<OverlapRun> &runs = found_.runs;
        if (!side.closes || runs.size() < first + 2) {
            return true;
        }
        const size_t free = side.free();
        OverlapRun &last = runs.back();
        const std::vector<CrossPlace> begun = runs[first].places;
        if (begun.front()[free] != side.range.lower || last.places.back()[free] != side.range.upper) {
            return true;
        }
        for (const CrossPlace &place : begun) {
            const std::optional<CrossPlace> next =
                follower_.next(side, last.places.back(), place[free] + side.period);
            if (!next) {
                return false;
            }
            last.places.push_back(*next);
        }
        runs.erase(runs.begin() + static_cast<std::ptrdiff_t>(first));
        return true;
    }

    // How far in space a change of parameter k leads, to first order.
    [[nodiscard]] static double far(const OverlapGround::Point &at, size_t k, double by) noexcept {
        return std::abs(by) * length(at.slope[k]);
    }
    // Moves the end of a run to a corner of its side, or to a side of the other surface; false: it is near
    // neither.
    bool set_end(const OverlapSide &side, CrossPlace &end) const {
        const size_t own = side.surface, other = 1 - own;
        const std::optional<OverlapGround::Point> here = ground_.point(own, &end[2 * own]),
                                                  there = ground_.point(other, &end[2 * other]);
        if (!here || !there) {
            return false;
        }
        bool is_end = false;
        for (const double corner : {side.range.lower, side.range.upper}) {
            if (!side.closes && far(*here, 1 - side.axis, end[side.free()] - corner) <= near_ / 4) {
                const std::optional<CrossPlace> at = follower_.next(side, end, corner);
                if (!at) {
                    return false;
                }
                end = *at;
                is_end = true;
            }
        }
        if (!is_end && !cross_side(side, *here, *there, end)) {
            return false;
        }
        snap(other, *there, end);
        return true;
    }
    // Moves an end to the nearest side of the other surface that crosses this side; false: none is near.
    bool cross_side(const OverlapSide &side, const OverlapGround::Point &here,
                    const OverlapGround::Point &there, CrossPlace &end) const {
        constexpr double least_sine = 1e-3;
        const OverlapSide *nearest = nullptr;
        double least = 4 * near_;
        for (const OverlapSide &other : found_.sides) {
            if (other.surface == side.surface) {
                continue;
            }
            const double apart = far(there, other.axis, end[other.fixed()] - other.at);
            const Vector3 &own_way = here.slope[1 - side.axis], &way = there.slope[1 - other.axis];
            if (apart <= least && length(cross(own_way, way)) > least_sine * length(own_way) * length(way)) {
                least = apart;
                nearest = &other;
            }
        }
        if (nearest == nullptr) {
            return false;
        }
        end[nearest->fixed()] = nearest->at;
        constexpr int steps = 8;
        double gap = infinity;
        for (int i = 0; i < steps; ++i) {
            const auto own = ground_.point(side.surface, &end[2 * side.surface]),
                       other = ground_.point(nearest->surface, &end[2 * nearest->surface]);
            if (!own || !other) {
                return false;
            }
            const Vector3 away = other->at - own->at;
            gap = length(away);
            const std::array<double, 2> by =
                parameters_along({own->slope[1 - side.axis], -1 * other->slope[1 - nearest->axis]}, away);
            end[side.free()] += by[0];
            end[nearest->free()] += by[1];
        }
        return gap <= near_;
    }
    // Moves an end that is almost on a side of the surface onto it.
    void snap(size_t surface, const OverlapGround::Point &there, CrossPlace &end) const {
        for (const OverlapSide &other : found_.sides) {
            if (other.surface == surface &&
                far(there, other.axis, end[other.fixed()] - other.at) <= near_ / 4) {
                end[other.fixed()] = other.at;
            }
        }
    }

    const OverlapGround &ground_;
    OverlapFollower follower_;
    double tolerance_, near_;
    OverlapBorders found_;
};

} // namespace

std::optional<CrossPlace> OverlapFollower::next(const OverlapSide &side, const CrossPlace &from,
                                                double to) const {
    const size_t own = side.surface, other = 1 - own;
    CrossPlace place = from;
    place[side.free()] = to;
    const auto here = ground_.point(own, &from[2 * own]), there = ground_.point(other, &from[2 * other]),
               next = ground_.point(own, &place[2 * own]);
    if (!here || !there || !next) {
        return std::nullopt;
    }
    const std::array<double, 2> by =
        parameters_along(there->slope, (to - from[side.free()]) * here->slope[1 - side.axis]);
    place[2 * other] += by[0];
    place[2 * other + 1] += by[1];
    return ground_.find_foot(other, next->at, &place[2 * other]) ? std::optional(place) : std::nullopt;
}

std::optional<CrossPlace> OverlapFollower::at(const OverlapSide &side, const OverlapRun &run,
                                              double t) const {
    const auto nearest = std::ranges::min_element(
        run.places, {}, [&](const CrossPlace &place) { return std::abs(place[side.free()] - t); });
    return next(side, *nearest, t);
}

std::optional<OverlapBorders> overlap_borders(const OverlapGround &ground, double tolerance, double near) {
    try {
        return BorderFinder(ground, tolerance, near).run();
    } catch (const Error &) { // weights vanish on a side, or it has no digits
        return std::nullopt;
    }
}

} // namespace nrb::intersect
