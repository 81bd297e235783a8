// SPDX-License-Identifier: MIT
#include "intersect/surfaces/self/injective.h"

#include "base/numbers.h"
#include "base/watch.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace nrb::intersect {

namespace {

constexpr size_t most_of_pairs = 16; // number of pieces that a rectangle may reach over
constexpr size_t most_at_pole = 64;  // the same at a pole
constexpr int most_sectors = 16;     // that a piece at a pole is cut into

// Whether the last layer of control points of `lower` along an axis equals the first one of `upper`, to
// rounding.
bool have_one_side(const CrossPiece &lower, const CrossPiece &upper, size_t axis) noexcept {
    const int64_t row = lower.degrees[1] + 1, layers = lower.degrees[axis] + 1,
                  others = lower.degrees[1 - axis] + 1;
    const double near = 2 * (lower.error + upper.error);
    for (int64_t j = 0; j < others; ++j) {
        const int64_t first = axis == 0 ? j : j * row,
                      last = axis == 0 ? (layers - 1) * row + j : j * row + layers - 1;
        const double w = lower.piece.weight(last);
        bool are_one = std::abs(w - upper.piece.weight(first)) <= 64 * eps * w;
        for (int c = 0; c < 3; ++c) {
            are_one = are_one && std::abs(lower.piece.point(last)[c] - upper.piece.point(first)[c]) <= near;
        }
        if (!are_one) {
            return false;
        }
    }
    return true;
}

} // namespace

InjectiveParts::InjectiveParts(CrossGround &ground) : ground_(ground) {
    for (size_t k = 0; k < 2; ++k) {
        for (int64_t i = 1; i < ground_.grid.count(static_cast<int>(k)); ++i) {
            jumps_ = jumps_ || !ground_.borders.goes_on(k, i, false);
        }
    }
    set_blocks();
}

int64_t InjectiveParts::block_of(const pieces::PieceGrid::Index &index) const {
    return block_[static_cast<size_t>(index[0] * ground_.grid.count(1) + index[1])];
}

bool InjectiveParts::is_continuous(const PieceRect &rect) const {
    std::array<std::vector<Part>, 2> parts;
    return !jumps_ || cut(rect, most_at_pole, parts);
}

bool InjectiveParts::is_all_proven() const {
    return std::ranges::all_of(block_, [](int64_t block) { return block == 0; });
}

// Bisection: a rectangle that is not proven is cut in the middle of its longer side.
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

bool InjectiveParts::is_proven(const PieceRect &rect, size_t most_parts) {
    const std::array<double, 4> key{rect[0].lower, rect[0].upper, rect[1].lower, rect[1].upper};
    if (const auto known = known_.find(key); known != known_.end()) {
        return known->second;
    }
    const std::vector<Pole> poles = poles_of(rect);
    bool proven = false;
    if (poles.empty()) {
        proven = is_injective(rect, most_parts);
    } else if (poles.size() == 1) {
        const size_t other = 1 - poles[0].axis;
        PieceRect ring = rect;
        ring[other] = {0, count(other)};
        const bool all = ring[other].lower == rect[other].lower && ring[other].upper == rect[other].upper;
        proven = (!all && is_proven(ring, most_parts)) ||
                 is_injective_at_pole(rect, poles[0], std::max(most_parts, most_at_pole));
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

// The parts of pieces in a rectangle, along both axes; false if they are too many, or the surface ends or
// jumps inside.
bool InjectiveParts::cut(const PieceRect &rect, size_t most_parts,
                         std::array<std::vector<Part>, 2> &parts) const {
    for (size_t k = 0; k < 2; ++k) {
        const int64_t n = ground_.grid.count(static_cast<int>(k));
        if (!(rect[k].upper - rect[k].lower <= static_cast<double>(most_parts) + 1)) {
            return false;
        }
        for (auto i = static_cast<int64_t>(std::floor(rect[k].lower)); static_cast<double>(i) < rect[k].upper;
             ++i) {
            const auto start = static_cast<double>(i);
            parts[k].push_back(
                {(i % n + n) % n,
                 {std::max(rect[k].lower - start, 0.0), std::min(rect[k].upper - start, 1.0)}});
        }
    }
    return parts[0].size() * parts[1].size() <= most_parts && is_whole(parts);
}

bool InjectiveParts::is_whole(const std::array<std::vector<Part>, 2> &parts) const {
    for (size_t k = 0; k < 2; ++k) {
        for (size_t i = 1; i < parts[k].size(); ++i) {
            const int64_t above = parts[k][i].index;
            if (!ground_.borders.goes_on(k, above, false) && !is_closed_at(k, above, parts[1 - k])) {
                return false;
            }
        }
    }
    return true;
}

bool InjectiveParts::is_closed_at(size_t axis, int64_t above, const std::vector<Part> &along) const {
    return above > 0 && std::ranges::all_of(along, [&](const Part &part) {
               const auto piece_at = [&](int64_t index) {
                   return axis == 0 ? ground_.piece({index, part.index}) : ground_.piece({part.index, index});
               };
               const CrossPiece *const lower = piece_at(above - 1), *const upper = piece_at(above);
               return lower != nullptr && upper != nullptr && have_one_side(*lower, *upper, axis);
           });
}

// False: the weights are not positive, or a degree is 0.
bool InjectiveParts::add(const Part &along_u, const Part &along_v, std::vector<Tangents> &parts) const {
    const CrossPiece *const piece = ground_.piece({along_u.index, along_v.index});
    if (piece == nullptr || piece->degrees[0] == 0 || piece->degrees[1] == 0) {
        return false;
    }
    parts.emplace_back(*piece, std::array<Interval, 2>{along_u.places, along_v.places});
    return true;
}

bool InjectiveParts::is_injective(const PieceRect &rect, size_t most_parts) const {
    std::array<std::vector<Part>, 2> parts;
    if (!cut(rect, most_parts, parts)) {
        return false;
    }
    std::vector<Tangents> all;
    for (const Part &along_u : parts[0]) {
        for (const Part &along_v : parts[1]) {
            if (!add(along_u, along_v, all)) {
                return false;
            }
        }
    }
    return are_cones_apart(all);
}

// Tries more and more sectors, in each of which directions differ less.
bool InjectiveParts::is_injective_at_pole(const PieceRect &rect, const Pole &pole, size_t most_parts) const {
    std::array<std::vector<Part>, 2> parts;
    const size_t other = 1 - pole.axis;
    if (!cut(rect, most_parts, parts)) {
        return false;
    }
    if (pole.end == 1) {
        std::ranges::reverse(parts[pole.axis]);
    }
    const bool closed =
        rect[other].lower == 0 && rect[other].upper == count(other) && ground_.borders.wraps(other);
    for (int sectors = 1; sectors <= most_sectors; sectors *= 2) {
        std::vector<std::vector<Tangents>> columns;
        if (!set_columns(parts, pole.axis, sectors, columns)) {
            return false;
        }
        if (are_polar_cones_apart(columns, pole.axis, pole.end, closed)) {
            return true;
        }
    }
    return false;
}

bool InjectiveParts::set_columns(const std::array<std::vector<Part>, 2> &parts, size_t axis, int sectors,
                                 std::vector<std::vector<Tangents>> &columns) const {
    for (const Part &whole : parts[1 - axis]) {
        const double length = (whole.places.upper - whole.places.lower) / sectors;
        for (int s = 0; s < sectors; ++s) {
            const Part sector{whole.index,
                              {whole.places.lower + s * length, s + 1 == sectors
                                                                    ? whole.places.upper
                                                                    : whole.places.lower + (s + 1) * length}};
            std::vector<Tangents> &column = columns.emplace_back();
            for (const Part &part : parts[axis]) {
                if (!(axis == 0 ? add(part, sector, column) : add(sector, part, column))) {
                    return false;
                }
            }
        }
    }
    return true;
}

} // namespace nrb::intersect
