// SPDX-License-Identifier: MIT
#include "intersect/surfaces/self/injective.h"

#include "base/watch.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace nrb::intersect {

namespace {

constexpr size_t most_of_pairs = 16; // cells that a rectangle may reach over
constexpr size_t most_at_pole = 64;  // the same at a side that is one point
constexpr int most_sectors = 16;     // of a piece there

bool is_all_of_piece(const Interval &places) noexcept {
    return places.lower == 0 && places.upper == 1;
}

} // namespace

InjectiveParts::InjectiveParts(CrossGround &ground) : ground_(ground) {
    set_blocks();
}

int64_t InjectiveParts::block_of(const pieces::PieceGrid::Index &index) const {
    return block_[static_cast<size_t>(index[0] * ground_.grid.count(1) + index[1])];
}

bool InjectiveParts::is_all_proven() const {
    return std::ranges::all_of(block_, [](int64_t block) { return block == 0; });
}

// The longer side of what is not proven is cut in the middle.
void InjectiveParts::set_blocks() {
    using Block = std::array<std::array<int64_t, 2>, 2>; // [axis]: the first, and beyond the last
    const int64_t n = ground_.grid.count(0), m = ground_.grid.count(1);
    block_.assign(static_cast<size_t>(n * m), -1);
    std::vector<Block> open{{{{0, n}, {0, m}}}};
    for (int64_t blocks = 0; !open.empty() && !work_ended();) {
        const Block block = open.back();
        open.pop_back();
        const auto [u, v] = block;
        const PieceRect rect{Interval{static_cast<double>(u[0]), static_cast<double>(u[1])},
                             Interval{static_cast<double>(v[0]), static_cast<double>(v[1])}};
        const int64_t count = (u[1] - u[0]) * (v[1] - v[0]);
        if (is_proven(rect, static_cast<size_t>(count))) {
            for (int64_t i = u[0]; i < u[1]; ++i) {
                std::fill_n(block_.begin() + (i * m + v[0]), v[1] - v[0], blocks);
            }
            ++blocks;
        } else if (count > 1) {
            const size_t axis = u[1] - u[0] >= v[1] - v[0] ? 0 : 1;
            Block lower = block, upper = block;
            lower[axis][1] = upper[axis][0] = std::midpoint(block[axis][0], block[axis][1]);
            open.push_back(upper);
            open.push_back(lower);
        }
    }
}

bool InjectiveParts::is_proven(const PieceRect &rect) {
    return is_proven(rect, most_of_pairs);
}

bool InjectiveParts::is_proven(const PieceRect &rect, size_t most_cells) {
    const std::array<double, 4> key{rect[0].lower, rect[0].upper, rect[1].lower, rect[1].upper};
    if (const auto known = known_.find(key); known != known_.end()) {
        return known->second;
    }
    const std::vector<Pole> poles = poles_of(rect);
    bool proven = false;
    if (poles.empty()) {
        proven = is_injective(rect, most_cells);
    } else if (poles.size() == 1) {
        const size_t other = 1 - poles[0].axis;
        PieceRect ring = rect;
        ring[other] = {0, count(other)};
        const bool all = ring[other].lower == rect[other].lower && ring[other].upper == rect[other].upper;
        proven = (!all && is_proven(ring, most_cells)) ||
                 is_injective_at_pole(rect, poles[0], std::max(most_cells, most_at_pole));
    }
    known_.emplace(key, proven);
    return proven;
}

std::vector<InjectiveParts::Pole> InjectiveParts::poles_of(const PieceRect &rect) const {
    std::vector<Pole> poles;
    for (size_t k = 0; k < 2; ++k) {
        const int64_t last = ground_.grid.count(static_cast<int>(k)) - 1;
        if (rect[k].lower <= 0 && ground_.borders.is_collapsed(k, 0, false)) {
            poles.push_back({k, 0});
        }
        if (rect[k].upper >= count(k) && ground_.borders.is_collapsed(k, last, true)) {
            poles.push_back({k, 1});
        }
    }
    return poles;
}

// False: the surface ends or jumps inside, or these are too many.
bool InjectiveParts::cut(const PieceRect &rect, size_t most_cells,
                         std::array<std::vector<Part>, 2> &parts) const {
    for (size_t k = 0; k < 2; ++k) {
        const int64_t n = ground_.grid.count(static_cast<int>(k));
        if (!(rect[k].upper - rect[k].lower <= static_cast<double>(most_cells) + 1)) {
            return false;
        }
        for (auto i = static_cast<int64_t>(std::floor(rect[k].lower)); static_cast<double>(i) < rect[k].upper;
             ++i) {
            const auto start = static_cast<double>(i);
            const int64_t index = (i % n + n) % n;
            const Interval places{std::max(rect[k].lower - start, 0.0), std::min(rect[k].upper - start, 1.0)};
            if (!parts[k].empty() && !ground_.borders.goes_on(k, index, false)) {
                return false;
            }
            parts[k].push_back({index, places});
        }
    }
    return parts[0].size() * parts[1].size() <= most_cells;
}

// Null: nothing is known of its derivatives.
CrossCell *InjectiveParts::cell(const Part &along_u, const Part &along_v, Cells &cells) {
    const pieces::PieceGrid::Index index{along_u.index, along_v.index};
    const CrossPiece *const piece = ground_.piece(index);
    if (piece == nullptr) {
        return nullptr;
    }
    const std::array<Interval, 2> places{along_u.places, along_v.places};
    CrossCell *made = nullptr;
    if (is_all_of_piece(places[0]) && is_all_of_piece(places[1])) {
        made = &whole_.try_emplace(ground_.grid.piece(index), *piece, places).first->second;
    } else {
        made = &cells.made.emplace_back(*piece, places);
        count_work(4 * piece->piece.coefficients() * (piece->degrees[0] + piece->degrees[1] + 2));
    }
    return made->prepare() ? made : nullptr;
}

bool InjectiveParts::is_injective(const PieceRect &rect, size_t most_cells) {
    std::array<std::vector<Part>, 2> parts;
    if (!cut(rect, most_cells, parts)) {
        return false;
    }
    Cells cells;
    for (const Part &along_u : parts[0]) {
        for (const Part &along_v : parts[1]) {
            CrossCell *const own = cell(along_u, along_v, cells);
            if (own == nullptr) {
                return false;
            }
            cells.all.push_back(own);
        }
    }
    return are_cones_apart(cells.all);
}

// In more and more sectors, in which directions differ less.
bool InjectiveParts::is_injective_at_pole(const PieceRect &rect, const Pole &pole, size_t most_cells) {
    std::array<std::vector<Part>, 2> parts;
    const size_t other = 1 - pole.axis;
    if (!cut(rect, most_cells, parts)) {
        return false;
    }
    const bool closed =
        rect[other].lower == 0 && rect[other].upper == count(other) && ground_.borders.wraps(other);
    for (int sectors = 1; sectors <= most_sectors; sectors *= 2) {
        Cells cells;
        std::vector<std::vector<CrossCell *>> columns;
        if (!set_columns(parts, pole.axis, sectors, cells, columns)) {
            return false;
        }
        if (pole.end == 1) {
            std::ranges::for_each(columns, [](auto &column) { std::ranges::reverse(column); });
        }
        if (are_polar_cones_apart(columns, pole.axis, pole.end, closed)) {
            return true;
        }
    }
    return false;
}

bool InjectiveParts::set_columns(const std::array<std::vector<Part>, 2> &parts, size_t axis, int sectors,
                                 Cells &cells, std::vector<std::vector<CrossCell *>> &columns) {
    for (const Part &whole : parts[1 - axis]) {
        const double length = (whole.places.upper - whole.places.lower) / sectors;
        for (int s = 0; s < sectors; ++s) {
            const Part sector{whole.index,
                              {whole.places.lower + s * length, s + 1 == sectors
                                                                    ? whole.places.upper
                                                                    : whole.places.lower + (s + 1) * length}};
            std::vector<CrossCell *> &column = columns.emplace_back();
            for (const Part &part : parts[axis]) {
                CrossCell *const own = axis == 0 ? cell(part, sector, cells) : cell(sector, part, cells);
                if (own == nullptr) {
                    return false;
                }
                column.push_back(own);
            }
        }
    }
    return true;
}

} // namespace nrb::intersect
