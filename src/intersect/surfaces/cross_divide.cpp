// SPDX-License-Identifier: MIT
#include "base/numbers.h"
#include "base/watch.h"
#include "intersect/surfaces/cross_search.h"

#include <algorithm>
#include <iterator>

namespace nrb::intersect {

namespace {

constexpr Interval none{infinity, -infinity};
constexpr int64_t work_of_a_half = 48; // of a pair, for its memory

} // namespace

void CrossSearch::divide(const Pair &pair, const Cut &cut) {
    if (!take_parts(pair)) {
        halve(pair, cut);
    }
}

void CrossSearch::halve(const Pair &pair, const Cut &cut) {
    const double error = 4 * (pair.a->piece().error + pair.b->piece().error);
    const bool pole = pair.a->has_pole() || pair.b->has_pole(); // where parts never have a chart
    const double small = pole ? std::max(error, tolerance_ / 4) : error;
    for (const bool of_a : {cut.first, !cut.first}) {
        CrossCell &cell = of_a ? *pair.a : *pair.b;
        const CrossCell::Halves halves =
            cell.size() > small
                ? cell.halves((of_a ? a_ : b_).parts, of_a == cut.first ? cut.axis : std::nullopt)
                : CrossCell::Halves{};
        for (CrossCell *half : halves) {
            if (half != nullptr) {
                count_work(work_of_a_half);
                next_.push_back({of_a ? half : pair.a, of_a ? pair.b : half, pair.of, pair.graph,
                                 pair.no_contact, pair.no_shear});
            }
        }
        if (halves[0] != nullptr) {
            return;
        }
    }
    if (!pair.graph) {
        add(pair);
    }
}

// Replaces the pair by what the shear leaves of it, if that is far less. False: it is not, or parts would be
// too small.
bool CrossSearch::take_parts(const Pair &pair) {
    const CrossCell &x = first_is_x_ ? *pair.a : *pair.b, &y = first_is_x_ ? *pair.b : *pair.a;
    std::array<CrossCell *, 2> of_x{};
    CrossCell *const of_y = parts_.count > 0 ? y.part((first_is_x_ ? b_ : a_).parts, parts_.of_y) : nullptr;
    for (size_t i = 0; i < parts_.count && of_y != nullptr; ++i) {
        of_x[i] = x.part((first_is_x_ ? a_ : b_).parts, parts_.of_x[i]);
    }
    if (of_x[0] == nullptr || (parts_.count == 2 && of_x[1] == nullptr)) {
        return false;
    }
    for (CrossCell *part : of_x) {
        if (part != nullptr) {
            next_.push_back({first_is_x_ ? part : of_y, first_is_x_ ? of_y : part, pair.of, pair.graph,
                             pair.no_contact, pair.no_shear});
        }
    }
    return true;
}

// Halves both parts of a pair of adjacent ones, which has no chart because the surface meets itself between
// them.
void CrossSearch::halve_both(const Pair &pair) {
    const double small = 4 * (pair.a->piece().error + pair.b->piece().error);
    const auto halves = [&](CrossCell &cell, CrossSide &side) {
        cell.prepare(); // so that the cells of both sides choose the same axis
        const CrossCell::Halves both = cell.size() > small ? cell.halves(side.parts) : CrossCell::Halves{};
        return both[0] != nullptr ? both : CrossCell::Halves{&cell, nullptr};
    };
    const auto of_a = halves(*pair.a, a_), of_b = halves(*pair.b, b_);
    if (of_a[1] == nullptr && of_b[1] == nullptr) {
        add(pair);
        return;
    }
    for (CrossCell *a : of_a) {
        for (CrossCell *b : of_b) {
            if (a != nullptr && b != nullptr) {
                next_.push_back({a, b, pair.of});
            }
        }
    }
}

std::array<Interval, 4> ranges_of(const CrossCell &a, const CrossCell &b) noexcept {
    const std::array<Interval, 2> of_a = a.ranges(), of_b = b.ranges();
    return {of_a[0], of_a[1], of_b[0], of_b[1]};
}

std::array<Interval, 4> ranges_of(const CrossBox &box) noexcept {
    return ranges_of(*box.a, *box.b);
}

void CrossSearch::add(const Pair &pair) {
    count_work(work_of_a_kept_part);
    found_.clusters.push_back({ranges_of(*pair.a, *pair.b)});
}

// Leaves open the pairs that there was no work for; where these are many, as one cluster for each pair of
// pieces.
void CrossSearch::add_left(std::span<const Pair> pairs) {
    constexpr size_t most = 1 << 16;
    if (pairs.size() <= most) {
        std::ranges::for_each(pairs, [this](const Pair &pair) { add(pair); });
        return;
    }
    std::vector<CrossCluster> parts(crowds_.counts_of(pairs).size(), {{none, none, none, none}});
    for (const Pair &pair : pairs) {
        const std::array<Interval, 4> ranges = ranges_of(*pair.a, *pair.b);
        for (size_t i = 0; i < 4; ++i) {
            Interval &all = parts[pair.of].ranges[i];
            all = {std::min(all.lower, ranges[i].lower), std::max(all.upper, ranges[i].upper)};
        }
    }
    std::ranges::copy_if(parts, std::back_inserter(found_.clusters), [](const CrossCluster &part) {
        return part.ranges[0].lower <= part.ranges[0].upper;
    });
}

// Leaves a pair of nodes of the trees open: a single piece with its parameters, a group of pieces as all of
// the surface.
void CrossSearch::add_unknown(const PairCell &a, const PairCell &b) {
    count_work(work_of_a_kept_part);
    CrossCluster &cluster = found_.clusters.emplace_back();
    const auto set = [&](const PairCell &cell, const pieces::PieceGrid &grid, size_t at) {
        for (size_t k = 0; k < 2; ++k) {
            const int axis = static_cast<int>(k);
            cluster.ranges[at + k] = {grid.break_at(axis, 0), grid.break_at(axis, grid.count(axis))};
            if (cell.piece) {
                cluster.ranges[at + k] = {cell.piece->parameter({0, 0})[k], cell.piece->parameter({1, 1})[k]};
            }
        }
    };
    set(a, a_.ground.grid, 0);
    set(b, b_.ground.grid, 2);
}

} // namespace nrb::intersect
