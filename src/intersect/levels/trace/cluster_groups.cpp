// SPDX-License-Identifier: MIT
#include "intersect/levels/trace/cluster_groups.h"

#include "base/disjoint_sets.h"
#include "intersect/levels/trace/open_intervals.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <optional>
#include <unordered_map>
#include <utility>

namespace nrb::intersect {

namespace {

// Between parts of what is near there may be some that are not quite.
ParameterRanges widened(const ParameterRanges &ranges) noexcept {
    ParameterRanges wide = ranges;
    for (Interval &range : wide) {
        const double size = range.upper - range.lower;
        range = {range.lower - size, range.upper + size};
    }
    return wide;
}

std::vector<Interval> along_axis(const std::vector<ParameterRanges> &parts, size_t k) {
    std::vector<Interval> all;
    std::ranges::transform(parts, std::back_inserter(all), [k](const auto &part) { return part[k]; });
    return all;
}

class Grouping {
public:
    Grouping(const std::vector<ParameterRanges> &parts, const pieces::PieceGrid &grid,
             const SurfaceBorders &borders)
        : parts_(parts), grid_(grid), borders_(borders), sets_(parts.size()), order_(parts.size()) {}

    std::vector<std::vector<size_t>> run() {
        join_neighbours();
        join_at_seams();
        join_at_poles();
        std::vector<std::vector<size_t>> groups;
        std::unordered_map<size_t, size_t> numbers;
        for (const size_t i : order_) {
            const auto [number, is_new] = numbers.try_emplace(sets_.find(i), groups.size());
            if (is_new) {
                groups.emplace_back();
            }
            groups[number->second].push_back(i);
        }
        return groups;
    }

private:
    // From one end of the first axis to the other.
    void join_neighbours() {
        std::vector<ParameterRanges> wide;
        std::ranges::transform(parts_, std::back_inserter(wide), widened);
        std::iota(order_.begin(), order_.end(), size_t{0});
        std::ranges::sort(order_, {}, [&](size_t i) { return std::pair(wide[i][0].lower, i); });
        OpenIntervals open(along_axis(wide, 1));
        for (const size_t i : order_) {
            const auto &[along, across] = wide[i];
            open.visit(across, along.lower, [&](size_t j) { sets_.join(j, i); });
            open.add(across, {i, along.upper});
        }
    }

    void join_at_seams() {
        for (size_t k = 0; k < 2; ++k) {
            if (!borders_.wraps(k)) {
                continue;
            }
            const Interval domain = domain_along(grid_, k);
            OpenIntervals at_end(along_axis(parts_, 1 - k));
            for (size_t j = 0; j < parts_.size(); ++j) {
                if (parts_[j][k].upper == domain.upper) {
                    at_end.add(parts_[j][1 - k], {j, 0});
                }
            }
            for (size_t i = 0; i < parts_.size(); ++i) {
                if (parts_[i][k].lower == domain.lower) {
                    at_end.visit(parts_[i][1 - k], 0, [&](size_t j) { sets_.join(i, j); });
                }
            }
        }
    }

    // Those at a side of one point.
    void join_at_poles() {
        for (size_t k = 0; k < 2; ++k) {
            for (const bool up : {false, true}) {
                if (!borders_.is_collapsed(k, up ? grid_.count(static_cast<int>(k)) - 1 : 0, up)) {
                    continue;
                }
                const Interval domain = domain_along(grid_, k);
                std::optional<size_t> first;
                for (size_t i = 0; i < parts_.size(); ++i) {
                    if (up ? parts_[i][k].upper == domain.upper : parts_[i][k].lower == domain.lower) {
                        first = first.value_or(i);
                        sets_.join(*first, i);
                    }
                }
            }
        }
    }

    const std::vector<ParameterRanges> &parts_;
    const pieces::PieceGrid &grid_;
    const SurfaceBorders &borders_;
    DisjointSets sets_;
    std::vector<size_t> order_;
};

} // namespace

std::vector<std::vector<size_t>> touching_groups(const std::vector<ParameterRanges> &parts,
                                                 const pieces::PieceGrid &grid,
                                                 const SurfaceBorders &borders) {
    return Grouping(parts, grid, borders).run();
}

Interval domain_along(const pieces::PieceGrid &grid, size_t axis) noexcept {
    const int k = static_cast<int>(axis);
    return {grid.break_at(k, 0), grid.break_at(k, grid.count(k))};
}

SortedPlaces::SortedPlaces(std::vector<std::array<double, 2>> places) : places_(std::move(places)) {
    std::ranges::sort(places_);
}

bool SortedPlaces::any_in(const ParameterRanges &part, const SurfaceBorders &borders, double room) const {
    const auto wide = [&](size_t k) {
        const double by = room * borders.period(k);
        return Interval{part[k].lower - by, part[k].upper + by};
    };
    const auto is_in = [&](double at, const Interval &range) {
        return at >= range.lower && at <= range.upper;
    };
    const Interval along = wide(0), across = wide(1);
    for (const int turn : {0, -1, 1}) {
        if (turn != 0 && !borders.wraps(0)) {
            continue;
        }
        const double by = turn * borders.period(0);
        auto i =
            std::ranges::lower_bound(places_, along.lower - by, {}, [](const auto &at) { return at[0]; });
        for (; i != places_.end() && (*i)[0] + by <= along.upper; ++i) {
            count_work(20);
            const double at = (*i)[1], period = borders.period(1);
            const bool beyond =
                borders.wraps(1) && (is_in(at - period, across) || is_in(at + period, across));
            if ((*i)[0] + by >= along.lower && (beyond || is_in(at, across))) {
                return true;
            }
        }
    }
    return false;
}

} // namespace nrb::intersect
