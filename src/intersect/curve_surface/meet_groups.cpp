// SPDX-License-Identifier: MIT
#include "intersect/curve_surface/meet_groups.h"

#include "base/numbers.h"
#include "base/watch.h"

#include <algorithm>
#include <tuple>

namespace nrb::intersect {

namespace {

using PeriodCounts = std::array<int, 3>;

Interval moved(Interval part, double by) noexcept {
    return {part.lower + by, part.upper + by};
}

// A cell that touches another one if it is moved by so many periods.
struct Touch {
    size_t cell;
    PeriodCounts periods;
};

class Touches {
public:
    Touches(std::span<const MeetCell> cells, const Seams &seams)
        : cells_(cells), seams_(seams), of_(cells.size()) {}

    std::vector<std::vector<Touch>> run() {
        std::vector<size_t> order(cells_.size());
        for (size_t i = 0; i < order.size(); ++i) {
            order[i] = i;
        }
        std::ranges::sort(order, {}, [this](size_t i) { return cells_[i].box[0].lower; });
        sweep(order);
        look_across_seam_of_curve();
        return std::move(of_);
    }

private:
    void sweep(const std::vector<size_t> &order) {
        std::vector<size_t> open;
        for (const size_t i : order) {
            std::erase_if(open, [&](size_t j) { return cells_[j].box[0].upper < cells_[i].box[0].lower; });
            count_work(20 * std::ssize(open));
            for (const size_t j : open) {
                look(j, i, 0);
            }
            open.push_back(i);
        }
    }
    void look_across_seam_of_curve() {
        const Interval domain = seams_.domain(0);
        std::vector<size_t> first, last;
        for (size_t i = 0; i < cells_.size(); ++i) {
            if (cells_[i].box[0].lower <= domain.lower) {
                first.push_back(i);
            }
            if (cells_[i].box[0].upper >= domain.upper) {
                last.push_back(i);
            }
        }
        if (first.empty() || last.empty() || seams_.period(0) == 0) {
            return;
        }
        count_work(20 * std::ssize(first) * std::ssize(last));
        for (const size_t i : first) {
            for (const size_t j : last) {
                look(j, i, 1);
            }
        }
    }

    // Cell i after j, moved by a period of the curve or not, and by those of the surface.
    void look(size_t j, size_t i, int turn) {
        const MeetCell &a = cells_[j], &b = cells_[i];
        if (turn == 0 && a.segments[0] != b.segments[0]) {
            return;
        }
        for (int u = -1; u <= 1; ++u) {
            for (int v = -1; v <= 1 && touch(a, b, 1, u); ++v) {
                if (touch(a, b, 2, v) && (i != j || turn != 0 || u != 0 || v != 0)) {
                    of_[j].push_back({i, {turn, u, v}});
                    of_[i].push_back({j, {-turn, -u, -v}});
                }
            }
        }
    }
    [[nodiscard]] bool touch(const MeetCell &a, const MeetCell &b, size_t k, int turn) const {
        if (turn == 0) {
            return a.segments[k] == b.segments[k] && a.box[k].lower <= b.box[k].upper &&
                   b.box[k].lower <= a.box[k].upper;
        }
        const Interval domain = seams_.domain(k);
        const bool at_seam = turn > 0 ? a.box[k].upper >= domain.upper && b.box[k].lower <= domain.lower
                                      : a.box[k].lower <= domain.lower && b.box[k].upper >= domain.upper;
        return at_seam && seams_.period(k) > 0;
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
        if (a.box[k].lower > b.box[k].upper || b.box[k].lower > a.box[k].upper) {
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
        std::vector<Touch> members{{first, {}}};
        seen[first] = true;
        MeetGroup &group = groups.emplace_back();
        for (size_t i = 0; i < members.size(); ++i) {
            const Touch member = members[i];
            group.cells.push_back(moved_by(cells[member.cell], member.periods, seams));
            for (const auto &[next, by] : touches[member.cell]) {
                if (!seen[next]) {
                    seen[next] = true;
                    const PeriodCounts &own = member.periods;
                    members.push_back({next, {own[0] + by[0], own[1] + by[1], own[2] + by[2]}});
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
