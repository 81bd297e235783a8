// SPDX-License-Identifier: MIT
#include "face/trims/piece_columns.h"

#include "base/numbers.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace nrb::face {

namespace {

// Pieces are stored in buckets, which are strips of the domain along axis 0. A piece as wide as the domain is
// in all of them. There are so few buckets that they hold at most this many items per piece.
constexpr double most_items = 16;
// How many places of a loop are tried, for each k, to find its left side before it counts as lying on others.
constexpr int most_probes = 16;

} // namespace

PassedSums summed(PassedSums sums) {
    std::sort(sums.begin(), sums.end(),
              [](const PassedSum &a, const PassedSum &b) { return a.loop < b.loop; });
    PassedSums result;
    for (const PassedSum &sum : sums) {
        if (result.empty() || result.back().loop != sum.loop) {
            result.push_back({sum.loop, 0});
        }
        result.back().value += sum.value;
    }
    return result;
}

PieceColumns::PieceColumns(FoldedPieces folded, const Covering &covering)
    : pieces_(std::move(folded.pieces)), passages_(std::move(folded.passages)), covering_(&covering) {
    fill_buckets();
    set_room();
}

void PieceColumns::set_room() noexcept {
    for (size_t k = 0; k < 2; ++k) {
        const Interval domain = covering_->domain(static_cast<int>(k));
        room_[k] = 16 * eps * std::max(std::abs(domain.lower), std::abs(domain.upper));
        for (const TrimPiece &piece : pieces_.all()) {
            room_[k] = std::max(room_[k], 2 * piece.noise[k]);
        }
    }
}

size_t PieceColumns::bucket(double u) const noexcept {
    const double column = (u - covering_->domain(0).lower) / covering_->period(0) * columns_;
    const auto last = static_cast<double>(starts_.size() - 2);
    return static_cast<size_t>(std::clamp(column, 0.0, last));
}

void PieceColumns::fill_buckets() {
    const auto &all = pieces_.all();
    const auto n = static_cast<double>(all.size());
    double widths = 0; // as shares of the domain
    for (const TrimPiece &piece : all) {
        widths += (piece.upper[0] - piece.lower[0]) / covering_->period(0);
    }
    const double columns =
        std::clamp(std::floor((most_items - 1) * n / std::max(widths, 1.0)), 1.0, 2 * n + 1);
    columns_ = columns;
    starts_.assign(static_cast<size_t>(columns) + 1, 0);
    const auto for_each = [&](auto &&put) {
        for (size_t i = 0; i < all.size(); ++i) {
            const size_t end = bucket(all[i].upper[0]);
            for (size_t b = bucket(all[i].lower[0]); b <= end; ++b) {
                put(b, i);
            }
        }
    };
    for_each([&](size_t b, size_t) { ++starts_[b + 1]; });
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    items_.resize(starts_.back());
    std::vector<size_t> next(starts_.begin(), starts_.end() - 1);
    for_each([&](size_t b, size_t i) {
        items_[next[b]++] = {all[i].lower, all[i].upper, static_cast<uint32_t>(i), passed(all[i])};
    });
}

std::optional<PassedSums> PieceColumns::sums(const Point2 &x, size_t except) const {
    PassedSums passed;
    if (walk(x, except, [&](int32_t loop, int value) { passed.push_back({loop, value}); })) {
        return std::nullopt;
    }
    return summed(std::move(passed));
}

// None where another piece is so near along axis k that rounding may put it on the wrong side.
std::optional<PassedSums> PieceColumns::sums_away_from_others(const Point2 &x, size_t except,
                                                              size_t k) const {
    auto found = sums(x, except);
    for (const double side : {-4.0, 4.0}) {
        Point2 beside = x;
        beside[k] += side * room_[k];
        const auto [lower, upper] = covering_->domain(static_cast<int>(k));
        const bool inside = lower <= beside[k] && beside[k] <= upper;
        if (found && inside && sums(beside, except) != found) {
            return std::nullopt;
        }
    }
    return found;
}

std::optional<PassedSums> PieceColumns::sums_left_of(int32_t loop) const {
    for (const size_t k : {size_t{0}, size_t{1}}) { // a loop that stays in one column may go around axis 1
        const std::vector<size_t> own = longest_pieces(loop, k);
        for (int probe = 0; probe < most_probes && !own.empty(); ++probe) {
            const size_t i = own[static_cast<size_t>(probe) % own.size()];
            const double share = (probe + 1) * 0.381966 - std::floor((probe + 1) * 0.381966);
            if (auto found = sums_left_of(i, k, share)) {
                return found;
            }
        }
    }
    return std::nullopt;
}

// The pieces of a loop are consecutive, and loops ascend.
std::vector<size_t> PieceColumns::longest_pieces(int32_t loop, size_t k) const {
    const auto &all = pieces_.all();
    const auto first = std::lower_bound(all.begin(), all.end(), loop,
                                        [](const TrimPiece &piece, int32_t i) { return piece.loop < i; });
    std::vector<size_t> own;
    for (auto piece = first; piece != all.end() && piece->loop == loop; ++piece) {
        const bool column = piece->lower[0] == piece->upper[0];
        if (column == (k == 1) && piece->lower[k] < piece->upper[k]) {
            own.push_back(static_cast<size_t>(piece - all.begin()));
        }
    }
    const auto length = [&](size_t i) { return all[i].upper[k] - all[i].lower[k]; };
    std::sort(own.begin(), own.end(), [&](size_t a, size_t b) { return length(a) > length(b); });
    return own;
}

// At a share of piece i along axis k. The ray from a place in the column of a vertical piece crosses what the
// ray from its right side crosses.
std::optional<PassedSums> PieceColumns::sums_left_of(size_t i, size_t k, double share) const {
    const TrimPiece &piece = pieces_.all()[i];
    const double at = piece.lower[k] + share * (piece.upper[k] - piece.lower[k]);
    if (!(piece.lower[k] < at && at < piece.upper[k])) {
        return std::nullopt;
    }
    Point2 x{piece.start[0], at};
    if (k == 0) {
        const double v = pieces_.point(piece, pieces_.place_of(piece, 0, at))[1];
        x = {at, std::clamp(v, piece.lower[1], piece.upper[1])};
    } else if (covering_->closed(0) && x[0] == covering_->domain(0).upper) {
        x[0] = covering_->domain(0).lower;
    }
    auto found = sums_away_from_others(x, i, 1 - k);
    if (found) {
        const bool past = k == 0 ? piece.start[0] > piece.end[0] : piece.start[1] < piece.end[1];
        found->push_back({piece.loop, past ? 1 : 0});
    }
    return found;
}

} // namespace nrb::face
