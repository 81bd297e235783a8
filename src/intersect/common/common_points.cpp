// SPDX-License-Identifier: MIT
#include "intersect/common/common_points.h"

#include "base/watch.h"
#include "eval/evaluate.h"
#include "intersect/common/triple_search.h"
#include "intersect/levels/trace/cluster_groups.h"

#include <algorithm>
#include <utility>

namespace nrb::intersect {

namespace {

// Merges duplicates and adjoining open parts, and moves the results into the domain.
class Gathering {
public:
    Gathering(const std::array<const Spline *, 3> &surfaces, const std::array<SurfaceBorders, 3> &borders,
              std::vector<CommonPoint> found)
        : surfaces_(surfaces), borders_(borders), found_(std::move(found)) {}

    CommonPoints run() {
        add_points();
        std::ranges::for_each(result_.list, [&](CommonPoint &point) { keep_in_domain(point); });
        add_open();
        std::ranges::sort(result_.list, {}, &CommonPoint::at);
        return std::move(result_);
    }

private:
    // Drops duplicates. A point on a knot line, or on a line at which parts were halved, is found in the
    // parts on both sides; and so is a point beside such a line by no more than the boxes of parts overlap.
    void add_points() {
        std::vector<CommonPoint> points;
        std::ranges::copy_if(found_, std::back_inserter(points),
                             [](const CommonPoint &x) { return x.kind == HitKind::crossing; });
        std::ranges::sort(points, {}, &CommonPoint::at);
        for (const CommonPoint &point : points) {
            count_work(20 * std::ssize(result_.list));
            const auto same = std::ranges::find_if(
                result_.list, [&](const CommonPoint &other) { return is_same(point, other); });
            if (same == result_.list.end()) {
                result_.list.push_back(point);
            }
        }
    }
    [[nodiscard]] bool is_same(const CommonPoint &a, const CommonPoint &b) const noexcept {
        for (size_t i = 0; i < 6; ++i) {
            const Interval domain = domain_of(i);
            const double period = period_of(i), room = 4 * shift_of_sides * (domain.upper - domain.lower);
            const auto meet = [&](double shift) {
                return a.range[i].lower + shift <= b.range[i].upper + room &&
                       a.range[i].upper + shift >= b.range[i].lower - room;
            };
            if (!meet(0) && !(period > 0 && (meet(period) || meet(-period)))) {
                return false;
            }
        }
        return true;
    }

    void keep_in_domain(CommonPoint &point) const noexcept {
        for (size_t i = 0; i < 6; ++i) {
            const Interval domain = domain_of(i);
            Interval &range = point.range[i];
            range = {std::min(std::max(range.lower, domain.lower), point.at[i]),
                     std::max(std::min(range.upper, domain.upper), point.at[i])};
        }
    }
    [[nodiscard]] Interval domain_of(size_t i) const noexcept {
        return surfaces_[i / 2]->axis(static_cast<int>(i % 2)).domain();
    }

    // Open parts that touch each other on the first surface are merged.
    void add_open() {
        std::vector<CommonPoint> open;
        std::vector<ParameterRanges> ranges;
        for (const CommonPoint &x : found_) {
            if (x.kind == HitKind::undecided) {
                open.push_back(x);
                ranges.push_back({x.range[0], x.range[1]});
            }
        }
        for (const std::vector<size_t> &group :
             touching_groups(ranges, pieces::piece_grid_of(*surfaces_[0]), borders_[0])) {
            CommonPoint all = open[group.front()];
            for (const size_t member : group) {
                enclose(open[member], all);
            }
            set_middle(all);
            result_.list.push_back(all);
        }
    }
    [[nodiscard]] double period_of(size_t i) const noexcept {
        const SurfaceBorders &borders = borders_[i / 2];
        return borders.wraps(i % 2) ? borders.period(i % 2) : 0;
    }
    // Extends `all` over `own`, across seams if that is shorter.
    void enclose(const CommonPoint &own, CommonPoint &all) const noexcept {
        for (size_t i = 0; i < 6; ++i) {
            Interval least{-infinity, infinity};
            for (const double shift : {0.0, period_of(i), -period_of(i)}) {
                const Interval both{std::min(all.range[i].lower, own.range[i].lower + shift),
                                    std::max(all.range[i].upper, own.range[i].upper + shift)};
                least = both.upper - both.lower < least.upper - least.lower ? both : least;
            }
            all.range[i] = least;
        }
    }
    // Ranges on both sides of a seam are moved so that they begin in the domain.
    void set_middle(CommonPoint &open) const {
        for (size_t i = 0; i < 6; ++i) {
            const Interval domain = domain_of(i);
            Interval &range = open.range[i];
            const double shift = range.lower < domain.lower ? period_of(i) : 0;
            range = {range.lower + shift, range.upper + shift};
            const double middle = range.lower / 2 + range.upper / 2;
            open.at[i] = std::clamp(middle > domain.upper ? middle - period_of(i) : middle, domain.lower,
                                    domain.upper);
        }
        eval::evaluate_points(*surfaces_[0], {}, 0, {open.at.data(), 1, 2, 2, 1},
                              {open.point.data(), 1, 3, 3, 1});
    }

    const std::array<const Spline *, 3> &surfaces_;
    const std::array<SurfaceBorders, 3> &borders_;
    std::vector<CommonPoint> found_;
    CommonPoints result_;
};

} // namespace

CommonPoints common_points(const std::array<const Spline *, 3> &surfaces, double tolerance) {
    const auto &[a, b, c] = surfaces;
    const UsualLimit usual(usual_work(a->point_count() + b->point_count() + c->point_count()));
    const LimitedSearch limited;
    const std::array<SurfaceBorders, 3> borders{SurfaceBorders(pieces::piece_grid_of(*a)),
                                                SurfaceBorders(pieces::piece_grid_of(*b)),
                                                SurfaceBorders(pieces::piece_grid_of(*c))};
    TripleSearch search(surfaces, borders);
    std::vector<CommonPoint> found = search.run(tolerance);
    return Gathering(surfaces, borders, std::move(found)).run();
}

} // namespace nrb::intersect
