// SPDX-License-Identifier: MIT
#include "face/trims/trim_map.h"

#include "base/error.h"
#include "base/numbers.h"
#include "face/trims/nesting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace nrb::face {

namespace {

constexpr size_t none = std::numeric_limits<size_t>::max();
// Items for each piece, at most, that columns may take: pieces that are as wide as the domain lie in all of them.
constexpr double most_items = 16;
// Places of a loop at which its left side is looked for before it counts as hidden by others.
constexpr int most_probes = 16;

} // namespace

TrimMap::TrimMap(FoldedPieces folded, const Covering &covering, const std::vector<LoopShape> &loops,
                 bool turn, bool astray)
    : pieces_(std::move(folded.pieces)), passages_(std::move(folded.passages)), covering_(&covering),
      turned_(loops.size(), false) {
    fill_buckets();
    set_room();
    orient(loops, turn, astray);
}

void TrimMap::set_room() noexcept {
    for (size_t k = 0; k < 2; ++k) {
        const Interval domain = covering_->domain(static_cast<int>(k));
        room_[k] = 16 * eps * std::max(std::abs(domain.lower), std::abs(domain.upper));
        for (const TrimPiece &piece : pieces_.all()) {
            room_[k] = std::max(room_[k], 2 * piece.noise[k]);
        }
    }
}

size_t TrimMap::bucket(double u) const noexcept {
    const double column = (u - covering_->domain(0).lower) / covering_->period(0) * columns_;
    const auto last = static_cast<double>(starts_.size() - 2);
    return static_cast<size_t>(std::clamp(column, 0.0, last));
}

void TrimMap::fill_buckets() {
    const auto &all = pieces_.all();
    const auto n = static_cast<double>(all.size());
    double widths = 0; // in domains
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
        const int32_t passed = all[i].start[0] < all[i].end[0] ? -1 : 1;
        items_[next[b]++] = {all[i].lower, all[i].upper, static_cast<uint32_t>(i), passed};
    });
}

// Adds what is passed on the way from x; true if x lies on a piece. The columns of a piece reach from its left end to before its
// right one, so that each column meets one of two neighbours that go on.
template <class Add>
bool TrimMap::walk(const Point2 &x, size_t except, Add &&add) const {
    bool on = false;
    const size_t b = bucket(x[0]);
    for (size_t i = starts_[b]; i < starts_[b + 1]; ++i) {
        const Item &item = items_[i];
        if (x[1] > item.upper[1] || x[0] < item.lower[0] || x[0] > item.upper[0] || item.piece == except) {
            continue;
        }
        int side = 1;
        if (x[1] >= item.lower[1]) {
            side = pieces_.side(pieces_.all()[item.piece], x);
            on = on || side == 0;
        }
        if (side > 0 && x[0] < item.upper[0]) {
            add(pieces_.all()[item.piece].loop, item.passed);
        }
    }
    for (const SeamPassage &passage : passages_) {
        if (passage.at > x[0]) {
            add(passage.loop, passage.upwards);
        }
    }
    return on;
}

int TrimMap::side(const Point2 &x) const noexcept {
    bool on = false;
    const std::optional<int> found = sum(x, on);
    return !found ? -1 : on ? 0 : *found > 0 ? 1 : -1;
}

std::optional<int> TrimMap::value(const Point2 &x) const noexcept {
    bool on = false;
    const std::optional<int> found = sum(x, on);
    return on ? std::nullopt : found;
}

std::optional<int> TrimMap::sum(const Point2 &x, bool &on) const noexcept {
    Point2 at = x;
    for (const int k : {0, 1}) {
        const Interval domain = covering_->domain(k);
        double &coordinate = at[static_cast<size_t>(k)];
        if (covering_->closed(k)) {
            coordinate = covering_->in_domain(at)[static_cast<size_t>(k)];
        } else if (!(domain.lower <= coordinate && coordinate <= domain.upper)) {
            return std::nullopt;
        }
    }
    int value = corner_;
    const auto add = [&](int32_t loop, int passed) {
        value += turned_[static_cast<size_t>(loop)] ? -passed : passed;
    };
    // The other end of a closed axis is the same place.
    for (const int k : {0, 1}) {
        const Interval domain = covering_->domain(k);
        double &coordinate = at[static_cast<size_t>(k)];
        if (covering_->closed(k) && (coordinate == domain.lower || coordinate == domain.upper)) {
            coordinate = domain.upper;
            on = on || walk(at, none, [](int32_t, int) {});
            coordinate = domain.lower;
        }
    }
    on = walk(at, none, add) || on;
    return value;
}

int TrimMap::value_at_top(double u) const noexcept {
    int value = corner_;
    for (const SeamPassage &passage : passages_) {
        value += passage.at <= u                              ? 0
                 : turned_[static_cast<size_t>(passage.loop)] ? -passage.upwards
                                                              : passage.upwards;
    }
    return value;
}

std::optional<PassedSums> TrimMap::sums(const Point2 &x, size_t except) const {
    PassedSums passed;
    if (walk(x, except, [&](int32_t loop, int value) { passed.push_back({loop, value}); })) {
        return std::nullopt;
    }
    std::sort(passed.begin(), passed.end(),
              [](const PassedSum &a, const PassedSum &b) { return a.loop < b.loop; });
    PassedSums result;
    for (const PassedSum &sum : passed) {
        if (result.empty() || result.back().loop != sum.loop) {
            result.push_back({sum.loop, 0});
        }
        result.back().value += sum.value;
    }
    return result;
}

// None where another piece is as near, along axis k, as rounding may move both: by that it may lie on the wrong side.
std::optional<PassedSums> TrimMap::sums_away_from_others(const Point2 &x, size_t except, size_t k) const {
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

std::optional<PassedSums> TrimMap::sums_left_of(int32_t loop) const {
    for (const size_t k : {size_t{0}, size_t{1}}) { // loops that stay in a column may go around axis 1
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

// The pieces of a loop follow one another.
std::vector<size_t> TrimMap::longest_pieces(int32_t loop, size_t k) const {
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

// At a share of a piece along axis k. What is passed from a place in the column of an upright piece is what is passed from the
// right side of it.
std::optional<PassedSums> TrimMap::sums_left_of(size_t i, size_t k, double share) const {
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

void TrimMap::orient(const std::vector<LoopShape> &loops, bool turn, bool astray) {
    for (size_t i = 0; i < loops.size(); ++i) {
        if (!loops[i].around && std::abs(loops[i].area) <= loops[i].noise) {
            fail(Status::orientation, "loop %zu encloses nothing", i);
        }
    }
    const std::vector<std::optional<PassedSums>> left = checked_sums(loops);
    if (turn) {
        turn_loops(loops, left);
    }
    if (!loops.empty()) {
        set_corner(loops, astray);
    }
}

// Where a surface closes, a loop may run along both sides of its seams, as that of all of a torus does, or two may run around it in
// one place, as those of a torus do that is cut open. No face that hangs together has more of them.
std::vector<std::optional<PassedSums>> TrimMap::checked_sums(const std::vector<LoopShape> &loops) const {
    const bool closed = covering_->closed(0) || covering_->closed(1);
    int alone = closed ? 1 : 0, around = closed ? 2 : 0;
    std::vector<std::optional<PassedSums>> left;
    for (size_t i = 0; i < loops.size(); ++i) {
        left.push_back(sums_left_of(static_cast<int32_t>(i)));
        if (!left.back() && --(loops[i].around ? around : alone) < 0) {
            fail(Status::orientation, "loop %zu lies on others", i);
        }
    }
    return left;
}

// A loop that lies on others stays as it is.
void TrimMap::turn_loops(std::vector<LoopShape> loops, const std::vector<std::optional<PassedSums>> &found) {
    std::vector<PassedSums> left;
    for (size_t i = 0; i < loops.size(); ++i) {
        loops[i].around = loops[i].around || !found[i];
        left.push_back(found[i].value_or(PassedSums{}));
    }
    turned_ = Nesting(loops, left).loops_to_turn();
}

// What is passed says how much values differ. Loops that run along each other, as both sides of a seam do, leave slivers between
// them, so that what holds over most of the columns decides.
void TrimMap::set_corner(const std::vector<LoopShape> &loops, bool astray) {
    constexpr double sliver = 0x1p-20, most_astray = 0x1p-7; // of all columns
    corner_ = 0;
    Heights heights;
    for (const double u : probe_columns()) {
        add_column(u, heights);
    }
    double total = 0;
    int dominant = 0, lower = 0;
    const auto height = [&](int value) { return heights.contains(value) ? heights.at(value) : 0.0; };
    for (const auto &[value, own] : heights) {
        total += own;
        dominant = own > height(dominant) ? value : dominant;
        for (const int below : {value - 1, value}) {
            lower = height(below) + height(below + 1) > height(lower) + height(lower + 1) ? below : lower;
        }
    }
    if (height(dominant) >= (1 - sliver) * total) {
        lower = mostly_inside(loops) ? dominant - 1 : dominant;
    }
    corner_ = -lower;
    if (!astray && total - height(lower) - height(lower + 1) > most_astray * total) {
        fail_astray();
    }
}

// Names a loop that has its right side where others have the left one, if there is one.
void TrimMap::fail_astray() const {
    for (int32_t loop = 0; loop < static_cast<int32_t>(turned_.size()); ++loop) {
        const bool turned = turned_[static_cast<size_t>(loop)];
        int value = corner_ + (turned ? 1 : 0);
        for (const PassedSum &sum : sums_left_of(loop).value_or(PassedSums{})) {
            value += turned_[static_cast<size_t>(sum.loop)] ? -sum.value : sum.value;
        }
        if (value != 1) {
            fail(Status::orientation,
                 "loop %d has its left side where other loops have their right side, or crosses one", loop);
        }
    }
    fail(Status::orientation, "the loops go around some places twice: they cross or coincide");
}

// Where one value holds nearly everywhere: whether loops that do not run around enclose more than half of the domain, or nothing
// but holes.
bool TrimMap::mostly_inside(const std::vector<LoopShape> &loops) const {
    double area = 0;
    for (size_t i = 0; i < loops.size(); ++i) {
        area += loops[i].around ? 0 : turned_[i] ? -loops[i].area : loops[i].area;
    }
    return !(area > 0) || area > covering_->period(0) * covering_->period(1) / 2;
}

std::vector<double> TrimMap::probe_columns() const {
    constexpr size_t most_loops = 64, most_gaps = 16;
    std::vector<double> ends{covering_->domain(0).lower, covering_->domain(0).upper}, columns;
    std::vector<const TrimPiece *> widest(std::min(turned_.size(), most_loops), nullptr);
    const auto width = [](const TrimPiece &piece) { return piece.upper[0] - piece.lower[0]; };
    for (const TrimPiece &piece : pieces_.all()) {
        ends.push_back(piece.lower[0]);
        ends.push_back(piece.upper[0]);
        const auto loop = static_cast<size_t>(piece.loop);
        if (loop < widest.size() && (widest[loop] == nullptr || width(piece) > width(*widest[loop]))) {
            widest[loop] = &piece;
        }
    }
    for (const TrimPiece *piece : widest) {
        if (piece != nullptr && width(*piece) > 0) {
            columns.push_back(piece->lower[0] + 0.381966 * width(*piece));
        }
    }
    std::sort(ends.begin(), ends.end());
    std::vector<Interval> gaps;
    for (size_t i = 0; i + 1 < ends.size(); ++i) {
        gaps.push_back({ends[i], ends[i + 1]});
    }
    const size_t count = std::min(gaps.size(), most_gaps);
    std::partial_sort(gaps.begin(), gaps.begin() + static_cast<std::ptrdiff_t>(count), gaps.end(),
                      [](Interval a, Interval b) { return a.upper - a.lower > b.upper - b.lower; });
    for (size_t i = 0; i < count && gaps[i].upper - gaps[i].lower > 0x1p-20 * covering_->period(0); ++i) {
        columns.push_back(gaps[i].lower / 2 + gaps[i].upper / 2);
    }
    return columns;
}

void TrimMap::add_column(double u, Heights &heights) const {
    struct Crossing {
        double v;
        int passed;
    };
    std::vector<Crossing> crossings;
    const size_t b = bucket(u);
    for (size_t i = starts_[b]; i < starts_[b + 1]; ++i) {
        const TrimPiece &piece = pieces_.all()[items_[i].piece];
        if (piece.lower[0] <= u && u < piece.upper[0]) {
            const double v = pieces_.point(piece, pieces_.place_of(piece, 0, u))[1];
            crossings.push_back({v, passed(piece)});
        }
    }
    std::sort(crossings.begin(), crossings.end(),
              [](const Crossing &x, const Crossing &y) { return x.v > y.v; });
    crossings.push_back({covering_->domain(1).lower, 0});
    int value = value_at_top(u);
    double above = covering_->domain(1).upper;
    for (const Crossing &crossing : crossings) {
        heights[value] += std::max(above - crossing.v, 0.0);
        value += crossing.passed;
        above = crossing.v;
    }
}

} // namespace nrb::face
