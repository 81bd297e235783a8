// SPDX-License-Identifier: MIT
#include "intersect/surfaces/cross_crowds.h"

#include "base/numbers.h"
#include "base/watch.h"

#include <algorithm>
#include <iterator>

namespace nrb::intersect {

namespace {

Vector3 point_of(const CrossCell &part, const std::array<double, 2> &place) noexcept {
    return part.piece().evaluate(part.in_piece(place.data())).at;
}

// The distance of a point from its foot point on the surface of a part, looked for from the middle of the
// part; infinite if a step leaves `within`, places in the part.
double distance_to(const CrossCell &part, const Vector3 &from, const std::array<Interval, 2> &within) {
    constexpr int most_steps = 4;
    std::array<double, 2> at{0.5, 0.5};
    for (int i = 0;; ++i) {
        count_work(300);
        const CrossPiece::Point point = part.piece().evaluate(part.in_piece(at.data()));
        const Vector3 away = from - point.at, u = part.length(0) * point.slope[0],
                      v = part.length(1) * point.slope[1];
        if (i == most_steps) {
            return length(away);
        }
        const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), determinant = uu * vv - uv * uv;
        at[0] += (dot(away, u) * vv - dot(away, v) * uv) / determinant;
        at[1] += (dot(away, v) * uu - dot(away, u) * uv) / determinant;
        for (size_t k = 0; k < 2; ++k) {
            if (!(at[k] >= within[k].lower && at[k] <= within[k].upper)) {
                return infinity;
            }
        }
    }
}

// All of the piece and a little more, as places in the part.
std::array<Interval, 2> piece_around(const CrossCell &part) noexcept {
    const auto along = [&](size_t k) {
        return Interval{part.in_part(k, -widening), part.in_part(k, 1 + widening)};
    };
    return {along(0), along(1)};
}

} // namespace

double distance_of_middle(const CrossCell &part, const CrossCell &other) {
    constexpr Interval wide{-widening, 1 + widening};
    return distance_to(other, point_of(part, {0.5, 0.5}), {wide, wide});
}

bool lies_on(const CrossCell &part, const CrossCell &other, double tolerance) {
    constexpr std::array<std::array<double, 2>, 3> around{{{-1.1, 0.4}, {1.9, -0.8}, {0.7, 2.2}}};
    return std::ranges::all_of(around, [&](const std::array<double, 2> &at) {
        std::array<double, 2> place{};
        for (size_t k = 0; k < 2; ++k) {
            place[k] = std::clamp(at[k], part.in_part(k, 0), part.in_part(k, 1));
        }
        return distance_to(other, point_of(part, place), piece_around(other)) <= tolerance;
    });
}

CrossCrowds::Number CrossCrowds::add(const CrossPiece &a, const CrossPiece &b) {
    count_work(100);
    pairs_.push_back({{grounds_[0]->grid.piece({a.index[0], a.index[1]}),
                       grounds_[1]->grid.piece({b.index[0], b.index[1]})},
                      0,
                      0,
                      0,
                      false});
    return static_cast<Number>(pairs_.size() - 1);
}

void CrossCrowds::count(Number pair, bool along) {
    PiecePair &own = pairs_[pair];
    if (own.near++ == 0) {
        counted_.push_back(pair);
    }
    own.along += along ? 1 : 0;
    ++near_;
    along_ += along ? 1 : 0;
}

void CrossCrowds::tell(Number pair, bool lies_on) {
    PiecePair &own = pairs_[pair];
    ++own.asked;
    if (lies_on) {
        own.crowded = true;
        found_.push_back(pair);
    }
}

void CrossCrowds::settle() {
    if (are_many()) {
        find_crowds();
    }
    for (const Number pair : counted_) {
        pairs_[pair].near = pairs_[pair].along = 0;
        pairs_[pair].asked = 0;
    }
    counted_.clear();
    found_.clear();
    near_ = along_ = 0;
}

void CrossCrowds::find_crowds() {
    for (const Number pair : found_) {
        mark_neighbours(pairs_[pair]);
    }
    const auto share = [&](size_t most, size_t least) {
        return times_ * std::max(most / counted_.size(), least);
    };
    const size_t share_near = share(most_near, least_near), share_along = share(most_along, least_along);
    for (const Number number : counted_) {
        PiecePair &pair = pairs_[number];
        pair.crowded = pair.crowded || pair.near > share_near || pair.along > share_along;
    }
}

size_t CrossCrowds::share_of(size_t most, const std::vector<size_t> &counts) noexcept {
    const auto used = static_cast<size_t>(std::ranges::count_if(counts, [](size_t n) { return n > 0; }));
    return std::max(most / std::max(used, size_t{1}), least_near);
}

size_t CrossCrowds::far_above(const std::vector<size_t> &counts) {
    std::vector<size_t> used;
    std::ranges::copy_if(counts, std::back_inserter(used), [](size_t n) { return n > 0; });
    if (used.empty()) {
        return least_near;
    }
    const auto middle = used.begin() + std::ssize(used) / 2;
    std::ranges::nth_element(used, middle);
    return std::max(8 * *middle, least_near);
}

// A piece that has weights of no certain sign is examined in parts, so that one pair of pieces may have
// several numbers.
void CrossCrowds::mark_neighbours(const PiecePair &pair) {
    if (numbers_.empty()) {
        count_work(100 * std::ssize(pairs_));
        for (size_t i = 0; i < pairs_.size(); ++i) {
            numbers_[key(pairs_[i].pieces[0], pairs_[i].pieces[1])].push_back(static_cast<Number>(i));
        }
    }
    const std::vector<int64_t> near_a = neighbours(0, pair.pieces[0]), near_b = neighbours(1, pair.pieces[1]);
    count_work(100 * std::ssize(near_a) * std::ssize(near_b));
    for (const int64_t a : near_a) {
        for (const int64_t b : near_b) {
            const auto known = numbers_.find(key(a, b));
            if (known == numbers_.end()) {
                continue;
            }
            for (const Number number : known->second) {
                pairs_[number].crowded = true;
            }
        }
    }
}

// The piece itself and those around it, across seams too.
std::vector<int64_t> CrossCrowds::neighbours(size_t surface, int64_t piece) const {
    const pieces::PieceGrid &grid = grounds_[surface]->grid;
    const SurfaceBorders &borders = grounds_[surface]->borders;
    const pieces::PieceGrid::Index index = grid.index(piece);
    const auto along = [&](size_t k) {
        const int64_t n = grid.count(static_cast<int>(k)), i = index[k];
        std::vector<int64_t> near{i};
        for (const bool up : {false, true}) {
            if (borders.goes_on(k, i, up)) {
                near.push_back((i + (up ? 1 : n - 1)) % n);
            }
        }
        return near;
    };
    std::vector<int64_t> all;
    for (const int64_t u : along(0)) {
        for (const int64_t v : along(1)) {
            all.push_back(grid.piece({u, v}));
        }
    }
    return all;
}

} // namespace nrb::intersect
