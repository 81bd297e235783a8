// SPDX-License-Identifier: MIT
#include "intersect/curve_surface/meet_groups.h"

#include "base/numbers.h"
#include "base/watch.h"

#include <algorithm>
#include <iterator>
#include <tuple>

namespace nrb::intersect {

namespace {

using PeriodCounts = std::array<int, 3>;

Interval moved(Interval part, double by) noexcept {
    return {part.lower + by, part.upper + by};
}

bool overlap(Interval a, Interval b) noexcept {
    return a.lower <= b.upper && b.lower <= a.upper;
}

// A cell, and the periods by which it is moved.
struct Member {
    size_t cell;
    PeriodCounts periods;
};

// A cell that touches another one if it is moved by these periods, -1 to 1. The type is small, because if all
// cells are near each other there are as many as pairs of cells.
struct Touch {
    Touch(size_t i, const PeriodCounts &by) noexcept
        : cell(static_cast<uint32_t>(i)), moves{static_cast<int8_t>(by[0]), static_cast<int8_t>(by[1]),
                                                static_cast<int8_t>(by[2])} {}
    [[nodiscard]] PeriodCounts after(const PeriodCounts &own) const noexcept {
        return {own[0] + moves[0], own[1] + moves[1], own[2] + moves[2]};
    }
    uint32_t cell;
    std::array<int8_t, 3> moves;
};

class Touches {
public:
    Touches(std::span<const MeetCell> cells, const Seams &seams)
        : cells_(cells), seams_(seams), of_(cells.size()) {}

    std::vector<std::vector<Touch>> run() {
        for (int turns = 13; turns < 27; ++turns) { // no move, and one of every two opposite ones
            look_across({turns / 9 - 1, turns / 3 % 3 - 1, turns % 3 - 1});
        }
        return std::move(of_);
    }

private:
    // Of a sweep: a cell that stays, or one that is moved.
    struct Item {
        size_t cell;
        bool moves;
    };

    // The axis on which cells are shortest in comparison with the extent of all, of those along which nothing
    // is moved.
    [[nodiscard]] size_t sweep_axis(const PeriodCounts &periods) const noexcept {
        std::array<double, 3> shares{};
        for (size_t k = 0; k < 3; ++k) {
            Interval all{infinity, -infinity};
            for (const MeetCell &cell : cells_) {
                shares[k] += cell.box[k].upper - cell.box[k].lower;
                all = {std::min(all.lower, cell.box[k].lower), std::max(all.upper, cell.box[k].upper)};
            }
            shares[k] =
                periods[k] == 0 && all.upper > all.lower ? shares[k] / (all.upper - all.lower) : infinity;
        }
        return static_cast<size_t>(std::ranges::min_element(shares) - shares.begin());
    }
    void sweep(std::vector<Item> items, const PeriodCounts &periods) {
        const size_t k = sweep_axis(periods);
        const auto box = [&](size_t i) {
            return periods[k] == 0 ? cells_[i].box[k] : Interval{0, 0}; // all overlap
        };
        std::ranges::stable_sort(items, {}, [&](const Item &item) { return box(item.cell).lower; });
        std::array<std::vector<size_t>, 2> open; // those that are moved, and those that stay
        for (const Item &item : items) {
            std::vector<size_t> &others = open[item.moves ? 1 : 0];
            std::erase_if(others, [&](size_t i) { return box(i).upper < box(item.cell).lower; });
            count_work(10 * std::ssize(others));
            for (const size_t i : others) {
                look(item.moves ? i : item.cell, item.moves ? item.cell : i, periods);
            }
            open[item.moves ? 0 : 1].push_back(item.cell);
        }
    }

    [[nodiscard]] bool is_at(const MeetCell &cell, size_t k, bool upper) const noexcept {
        return upper ? cell.box[k].upper >= seams_.domain(k).upper
                     : cell.box[k].lower <= seams_.domain(k).lower;
    }
    // The cells from which such a move leads across seams.
    [[nodiscard]] std::vector<size_t> cells_at(const PeriodCounts &periods) const {
        std::vector<size_t> found;
        for (size_t i = 0; i < cells_.size(); ++i) {
            bool all = true;
            for (size_t k = 0; k < 3; ++k) {
                all = all && (periods[k] == 0 || is_at(cells_[i], k, periods[k] > 0));
            }
            if (all) {
                found.push_back(i);
            }
        }
        return found;
    }
    void look_across(const PeriodCounts &periods) {
        const std::vector<size_t> from = cells_at(periods),
                                  to = cells_at({-periods[0], -periods[1], -periods[2]});
        for (size_t k = 0; k < 3; ++k) {
            if (from.empty() || to.empty() || (periods[k] != 0 && seams_.period(k) == 0)) {
                return;
            }
        }
        std::vector<Item> items;
        std::ranges::transform(from, std::back_inserter(items), [](size_t i) { return Item{i, false}; });
        std::ranges::transform(to, std::back_inserter(items), [](size_t i) { return Item{i, true}; });
        sweep(std::move(items), periods);
    }

    // Records that cell i, moved by the periods, touches cell j, if it does.
    void look(size_t j, size_t i, const PeriodCounts &periods) {
        if (periods == PeriodCounts{} && i <= j) {
            return; // found as (i, j), or the same cell
        }
        const MeetCell &a = cells_[j], &b = cells_[i];
        for (size_t k = 0; k < 3; ++k) {
            if (periods[k] == 0 && (a.segments[k] != b.segments[k] || !overlap(a.box[k], b.box[k]))) {
                return;
            }
        }
        of_[j].emplace_back(i, periods);
        of_[i].emplace_back(j, PeriodCounts{-periods[0], -periods[1], -periods[2]});
    }

    std::span<const MeetCell> cells_;
    const Seams &seams_;
    std::vector<std::vector<Touch>> of_;
};

MeetCell moved_by(MeetCell cell, const PeriodCounts &periods, const Seams &seams) {
    for (size_t k = 0; k < 3; ++k) {
        if (periods[k] == 0) {
            continue;
        }
        const double by = periods[k] * seams.period(k);
        cell.box[k] = moved(cell.box[k], by);
        cell.core[k] = moved(cell.core[k], by);
        cell.at[k] += by;
    }
    return cell;
}

} // namespace

void MeetGroup::fit() noexcept {
    box.fill({infinity, -infinity});
    for (const MeetCell &cell : cells) {
        for (size_t k = 0; k < 3; ++k) {
            box[k] = {std::min(box[k].lower, cell.box[k].lower), std::max(box[k].upper, cell.box[k].upper)};
        }
    }
}

const MeetCell &MeetGroup::nearest() const noexcept {
    return *std::ranges::min_element(cells, {}, &MeetCell::gap);
}

bool MeetGroup::has(MeetCell::Kind kind) const noexcept {
    return std::ranges::any_of(cells, [kind](const MeetCell &cell) { return cell.kind == kind; });
}

bool MeetGroup::is_still() const noexcept {
    return std::ranges::all_of(cells, &MeetCell::still);
}

bool touch(const MeetCell &a, const MeetCell &b) noexcept {
    for (size_t k = 0; k < 3; ++k) {
        if (!overlap(a.box[k], b.box[k])) {
            return false;
        }
    }
    return true;
}

std::vector<MeetGroup> groups_of(std::span<const MeetCell> cells, const Seams &seams) {
    const std::vector<std::vector<Touch>> touches = Touches(cells, seams).run();
    std::vector<bool> seen(cells.size(), false);
    std::vector<MeetGroup> groups;
    for (size_t first = 0; first < cells.size(); ++first) {
        if (seen[first]) {
            continue;
        }
        std::vector<Member> members{{first, {}}};
        seen[first] = true;
        MeetGroup &group = groups.emplace_back();
        for (size_t i = 0; i < members.size(); ++i) {
            const Member member = members[i];
            group.cells.push_back(moved_by(cells[member.cell], member.periods, seams));
            group.cells.back().index = member.cell;
            for (const Touch &next : touches[member.cell]) {
                if (!seen[next.cell]) {
                    seen[next.cell] = true;
                    members.push_back({next.cell, next.after(member.periods)});
                }
            }
        }
        group.fit();
        std::ranges::sort(group.cells, {}, [](const MeetCell &cell) {
            return std::tuple(cell.box[0].lower, cell.box[1].lower, cell.box[2].lower);
        });
    }
    return groups;
}

} // namespace nrb::intersect
