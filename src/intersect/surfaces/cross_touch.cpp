// SPDX-License-Identifier: MIT
#include "intersect/surfaces/cross_touch.h"

#include "base/numbers.h"
#include "base/watch.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

constexpr size_t most_cells = 64, most_normals = 4; // of each surface
constexpr int most_cuts = 256;
constexpr double small_part = 0x1p-5; // in the frame, where the surfaces have a size of about 1

bool are_apart(const std::vector<CrossCell> &a, const std::vector<CrossCell> &b) noexcept {
    return std::ranges::all_of(a, [&](const CrossCell &one) {
        return std::ranges::all_of(b, [&](const CrossCell &other) { return are_apart(one, other); });
    });
}

// What a range of parameters covers of the pieces along an axis, across seams too: the index of each piece,
// and the places in it.
std::vector<std::pair<int64_t, Interval>> covered(const CrossGround &ground, size_t axis,
                                                  const Interval &range) {
    std::vector<std::pair<int64_t, Interval>> parts;
    const int k = static_cast<int>(axis);
    const pieces::PieceGrid &grid = ground.grid;
    const double period = ground.borders.wraps(axis) ? ground.borders.period(axis) : 0;
    for (const double shift : {0.0, period, -period}) {
        const double lower = range.lower + shift, upper = range.upper + shift;
        const int64_t n = grid.count(k);
        if (upper < grid.break_at(k, 0) || lower > grid.break_at(k, n)) {
            continue;
        }
        for (int64_t i = grid.find(k, lower); i <= grid.find(k, upper); ++i) {
            const double start = grid.break_at(k, i), length = grid.break_at(k, i + 1) - start;
            const Interval places{std::max((lower - start) / length, 0.0),
                                  std::min((upper - start) / length, 1.0)};
            if (places.lower < places.upper && parts.size() <= most_cells) {
                parts.emplace_back(i, places);
            }
        }
        if (period == 0) {
            break;
        }
    }
    return parts;
}

} // namespace

// False: there are too many, weights are not positive, or the ranges cover nothing.
bool CrossTouch::add_parts(size_t surface, const std::array<Interval, 4> &ranges, Cells &cells) const {
    const auto along_u = covered(*grounds_[surface], 0, ranges[2 * surface]),
               along_v = covered(*grounds_[surface], 1, ranges[2 * surface + 1]);
    if (along_u.size() * along_v.size() > most_cells) {
        return false;
    }
    const size_t before = cells.size();
    for (const auto &[i, u] : along_u) {
        for (const auto &[j, v] : along_v) {
            const CrossPiece *const piece = grounds_[surface]->piece({i, j});
            if (piece == nullptr) {
                return false;
            }
            cells.emplace_back(*piece, std::array<Interval, 2>{u, v});
            count_work(4 * piece->piece.coefficients() * (piece->degrees[0] + piece->degrees[1] + 2));
        }
    }
    return cells.size() > before;
}

bool CrossTouch::are_small(const Cells &cells, double most) noexcept {
    for (size_t c = 0; c < 3; ++c) {
        Interval all{infinity, -infinity};
        for (const CrossCell &cell : cells) {
            all = {std::min(all.lower, cell.box()[c].lower - cell.error()),
                   std::max(all.upper, cell.box()[c].upper + cell.error())};
        }
        if (!(all.upper - all.lower <= most)) {
            return false;
        }
    }
    return true;
}

double CrossTouch::thickness(const Cells &cells, const Vector3 &unit) noexcept {
    Interval all{infinity, -infinity};
    for (const CrossCell &cell : cells) {
        const double from = dot(unit, cell.centre() - cells.front().centre()), room = cell.wide_error();
        const Interval own = cell.points_along(unit);
        all = {std::min(all.lower, from + own.lower - room), std::max(all.upper, from + own.upper + room)};
    }
    return all.upper - all.lower;
}

// Cuts a half, a quarter or an eighth off one end of range i, the largest that is apart from the other
// surface.
bool CrossTouch::cut(size_t i, bool upper, const Cells &other, std::array<Interval, 4> &ranges) const {
    for (const double share : {0.5, 0.25, 0.125}) {
        std::array<Interval, 4> part = ranges;
        const Interval &all = ranges[i];
        const double at =
            upper ? all.upper - share * (all.upper - all.lower) : all.lower + share * (all.upper - all.lower);
        (upper ? part[i].lower : part[i].upper) = at;
        Cells cells;
        if (at > all.lower && at < all.upper && add_parts(i / 2, part, cells) && are_apart(cells, other)) {
            (upper ? ranges[i].upper : ranges[i].lower) = at;
            return true;
        }
    }
    return false;
}

void CrossTouch::narrow(std::array<Interval, 4> &ranges) const {
    bool any = true;
    for (int cuts = 0; any && cuts < most_cuts && !work_ended();) {
        any = false;
        for (size_t surface = 0; surface < 2; ++surface) {
            Cells other;
            if (!add_parts(1 - surface, ranges, other)) {
                return;
            }
            for (size_t i = 2 * surface; i < 2 * surface + 2; ++i) {
                for (const bool upper : {false, true}) {
                    any = cut(i, upper, other, ranges) || any;
                    ++cuts;
                }
            }
        }
    }
}

bool CrossTouch::is_apart(const std::array<Interval, 4> &ranges) const {
    Cells a, b;
    return add_parts(0, ranges, a) && add_parts(1, ranges, b) && are_apart(a, b);
}

bool CrossTouch::is_spot(const std::array<Interval, 4> &ranges) const {
    const double most = 16 * std::sqrt(tolerance_);
    Cells cells;
    return add_parts(0, ranges, cells) && add_parts(1, ranges, cells) && are_small(cells, most);
}

bool CrossTouch::is_touch(const std::array<Interval, 4> &ranges) const {
    Cells cells;
    if (!add_parts(0, ranges, cells)) {
        return false;
    }
    const size_t of_a = cells.size();
    if (!add_parts(1, ranges, cells) || !are_small(cells, small_part) ||
        !std::ranges::all_of(cells, [](CrossCell &cell) { return cell.prepare(); })) {
        return false;
    }
    bool near = are_small(cells, tolerance_);
    for (size_t i = 0; i < cells.size() && !near; ++i) {
        if ((i < of_a ? i : i - of_a) >= most_normals) {
            continue;
        }
        const Vector3 normal = cross(cells[i].slope(0), cells[i].slope(1));
        const double size = length(normal);
        near = size > 0 && thickness(cells, (1 / size) * normal) <= tolerance_;
    }
    return near;
}

} // namespace nrb::intersect
