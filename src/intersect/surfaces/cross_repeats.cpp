// SPDX-License-Identifier: MIT
#include "intersect/surfaces/cross_repeats.h"

#include "base/watch.h"
#include "intersect/surfaces/arc_places.h"

#include <algorithm>
#include <tuple>

namespace nrb::intersect {

namespace {

// In lengths of pieces: arcs that are no farther beyond the border of their piece may be on it.
constexpr double on_border = 0x1p-26;
// In lengths of boxes, along coordinate k: what is shorter is nothing.
constexpr double least_rest = 0x1p-24;

class Repeats {
public:
    Repeats(const CrossSurface &a, const CrossSurface &b, CrossParts &found) : places_(a, b), found_(found) {}

    void run() {
        if (std::ranges::none_of(found_.arcs, &CrossArc::along)) {
            return;
        }
        std::vector<size_t> along;
        for (size_t i = 0; i < found_.arcs.size(); ++i) {
            found_.arcs[i].along ? along.push_back(i) : keep(found_.arcs[i]);
        }
        std::ranges::sort(along, {}, [&](size_t i) { return rank(i); });
        for (const size_t i : along) {
            work_ended() ? leave_open(found_.arcs[i]) : add(found_.arcs[i]);
        }
        found_.arcs = std::move(kept_);
    }

private:
    // The order in which arcs are kept: first those in their own piece, then those that are less far beyond
    // it, then those in the lower piece.
    [[nodiscard]] std::tuple<double, std::array<int64_t, 4>, size_t> rank(size_t i) const {
        const CrossArc &arc = found_.arcs[i];
        return {arc.far <= on_border ? 0 : arc.far, spot_of(arc, arc.ends[0]).index, i};
    }
    void keep(const CrossArc &arc) {
        kept_.push_back(arc);
        spots_.push_back({spot_of(arc, arc.ends[0]), spot_of(arc, arc.ends[1])});
        numbers_[spots_.back()[0].index].push_back(kept_.size() - 1);
    }
    // The position along the way of an arc: coordinate k, with the sign that makes it rise from the first end
    // to the last one.
    static double along(const CrossArc &arc, const CrossPlace &z) noexcept {
        return arc.box.chart.direction() * z[arc.box.chart.axis()];
    }
    static Interval way_of(const CrossArc &arc) noexcept {
        return {along(arc, arc.ends[0].at), along(arc, arc.ends[1].at)};
    }

    void add(const CrossArc &arc) {
        std::vector<Interval> rest{way_of(arc)};
        const std::array<CrossSpot, 2> spots{spot_of(arc, arc.ends[0]), spot_of(arc, arc.ends[1])};
        for (const size_t other : places_.near(spots[0].index, numbers_)) {
            count_work(10);
            take(common(arc, spots, kept_[other], spots_[other]), rest);
        }
        for (const Interval &part : rest) {
            if (part.upper - part.lower > least_rest) {
                arc.far <= on_border ? keep_part(arc, part) : leave_open(arc);
            }
        }
    }
    static void take(const Interval &common, std::vector<Interval> &rest) {
        std::vector<Interval> left;
        for (const Interval &part : rest) {
            if (!(common.lower < common.upper)) {
                left.push_back(part);
                continue;
            }
            const Interval before{part.lower, std::min(part.upper, common.lower)},
                after{std::max(part.lower, common.upper), part.upper};
            for (const Interval &side : {before, after}) {
                if (side.lower < side.upper) {
                    left.push_back(side);
                }
            }
        }
        rest = std::move(left);
    }
    // The interval of the way of an arc that another arc covers; {1, 0} if there is none. Arcs with a zero in
    // common are one curve as far as both go.
    [[nodiscard]] Interval common(const CrossArc &arc, const std::array<CrossSpot, 2> &spots,
                                  const CrossArc &other, const std::array<CrossSpot, 2> &of_other) const {
        const Interval way = way_of(arc), way_of_other = way_of(other);
        std::array<double, 2> ends{};
        for (size_t end = 0; end < 2; ++end) {
            CrossPlace z{};
            if (places_.is_zero_of(arc, of_other[end], z)) {
                ends[end] = along(arc, z);
            } else if (places_.is_zero_of(other, spots[end], z) &&
                       along(other, z) >= way_of_other.lower - least_rest &&
                       along(other, z) <= way_of_other.upper + least_rest) {
                ends[end] = end == 0 ? way.lower : way.upper;
            } else {
                return {1, 0};
            }
        }
        const Interval shared{std::max(ends[0], way.lower), std::min(ends[1], way.upper)};
        return shared.upper - shared.lower > least_rest ? shared : Interval{1, 0};
    }
    void keep_part(const CrossArc &arc, const Interval &part) {
        CrossArc rest = arc;
        const size_t k = arc.box.chart.axis();
        const Interval way = way_of(arc);
        for (size_t end = 0; end < 2; ++end) {
            const double at = end == 0 ? part.lower : part.upper;
            if (at == (end == 0 ? way.lower : way.upper)) {
                continue;
            }
            CrossEnd &cut = rest.ends[end];
            const double share = (at - way.lower) / (way.upper - way.lower);
            for (size_t i = 0; i < 4; ++i) {
                cut.at[i] = (1 - share) * arc.ends[0].at[i] + share * arc.ends[1].at[i];
            }
            if (!arc.box.solve(k, cut.at)) {
                leave_open(arc);
                return;
            }
            cut.coordinate = k;
            cut.open = false;
        }
        keep(rest);
    }
    void leave_open(const CrossArc &arc) { found_.clusters.push_back({ranges_of(arc.box)}); }

    ArcPlaces places_;
    CrossParts &found_;
    std::vector<CrossArc> kept_;
    std::vector<std::array<CrossSpot, 2>> spots_; // of what is kept
    NumbersOfPieces numbers_;
};

} // namespace

void remove_repeats(const CrossSurface &a, const CrossSurface &b, CrossParts &found) {
    Repeats(a, b, found).run();
}

} // namespace nrb::intersect
