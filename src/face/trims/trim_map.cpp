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

TrimMap::TrimMap(FoldedPieces folded, const Covering &covering, const std::vector<LoopShape> &loops,
                 bool turn, bool astray)
    : columns_(std::move(folded), covering), covering_(&covering), turned_(loops.size(), false) {
    orient(loops, turn, astray);
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
    // Both ends of a closed axis are the same place.
    for (const int k : {0, 1}) {
        const Interval domain = covering_->domain(k);
        double &coordinate = at[static_cast<size_t>(k)];
        if (covering_->closed(k) && (coordinate == domain.lower || coordinate == domain.upper)) {
            coordinate = domain.upper;
            on = on || columns_.walk(at, PieceColumns::none, [](int32_t, int) {});
            coordinate = domain.lower;
        }
    }
    on = columns_.walk(at, PieceColumns::none, add) || on;
    return value;
}

int TrimMap::value_at_top(double u) const noexcept {
    int value = corner_;
    for (const SeamPassage &passage : columns_.passages()) {
        value += passage.at <= u                              ? 0
                 : turned_[static_cast<size_t>(passage.loop)] ? -passage.upwards
                                                              : passage.upwards;
    }
    return value;
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

// Where a surface closes, a loop may run along both sides of its seams, as the loop of a whole torus does; or
// two loops around an axis may coincide, as those of a torus that is cut open do. A connected face has no
// more such loops.
std::vector<std::optional<PassedSums>> TrimMap::checked_sums(const std::vector<LoopShape> &loops) const {
    const bool closed = covering_->closed(0) || covering_->closed(1);
    int alone = closed ? 1 : 0, around = closed ? 2 : 0;
    std::vector<std::optional<PassedSums>> left;
    for (size_t i = 0; i < loops.size(); ++i) {
        left.push_back(columns_.sums_left_of(static_cast<int32_t>(i)));
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

// Crossings give differences of values only; this sets the value at the corner. Loops that run along each
// other, as on both sides of a seam, leave slivers between them by rounding. Therefore the two consecutive
// values that hold over most of the sample columns become 0 and 1. If one value alone holds nearly
// everywhere, it is the slivers that decide whether that is 1, but only where is_told_by_around(); else
// mostly_inside() decides.
void TrimMap::set_corner(const std::vector<LoopShape> &loops, bool astray) {
    constexpr double sliver = 0x1p-20, most_astray = 0x1p-7; // of all columns together
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
        const double above = height(dominant + 1), below = height(dominant - 1);
        const bool tells = above != below && is_told_by_around(loops);
        lower = (tells ? above < below : mostly_inside(loops)) ? dominant - 1 : dominant;
    }
    corner_ = -lower;
    if (!astray && total - height(lower) - height(lower + 1) > most_astray * total) {
        fail_astray();
    }
}

// Whether slivers decide: loops that run around an axis have the inside to their left, however thin it is.
// But two of them in one place may just cut open a surface that closes along both axes.
bool TrimMap::is_told_by_around(const std::vector<LoopShape> &loops) const {
    const auto around = std::ranges::count_if(loops, &LoopShape::around);
    return around % 2 == 1 || (around > 0 && !(covering_->closed(0) && covering_->closed(1)));
}

// Names a loop whose left side is not inside, if there is one.
void TrimMap::fail_astray() const {
    for (int32_t loop = 0; loop < static_cast<int32_t>(turned_.size()); ++loop) {
        const bool turned = turned_[static_cast<size_t>(loop)];
        int value = corner_ + (turned ? 1 : 0);
        for (const PassedSum &sum : columns_.sums_left_of(loop).value_or(PassedSums{})) {
            value += turned_[static_cast<size_t>(sum.loop)] ? -sum.value : sum.value;
        }
        if (value != 1) {
            fail(Status::orientation,
                 "loop %d has its left side where other loops have their right side, or crosses one", loop);
        }
    }
    fail(Status::orientation, "the loops go around some places twice: they cross or coincide");
}

// For loops by which one value holds nearly everywhere: whether those that do not run around an axis enclose
// more than half of the domain, or nothing but holes.
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
    for (const TrimPiece &piece : pieces().all()) {
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

std::vector<TrimMap::ColumnPart> TrimMap::parts_of_column(double u) const {
    struct Crossing {
        double v;
        int passed;
    };
    std::vector<Crossing> crossings;
    columns_.in_column(u, [&](const TrimPiece &piece) {
        const double v = pieces().point(piece, pieces().place_of(piece, 0, u))[1];
        crossings.push_back({v, passed(piece)});
    });
    std::sort(crossings.begin(), crossings.end(),
              [](const Crossing &x, const Crossing &y) { return x.v > y.v; });
    crossings.push_back({covering_->domain(1).lower, 0});
    int value = value_at_top(u);
    double above = covering_->domain(1).upper;
    std::vector<ColumnPart> parts;
    for (const Crossing &crossing : crossings) {
        parts.push_back({{crossing.v, above}, value});
        value += crossing.passed;
        above = crossing.v;
    }
    return parts;
}

void TrimMap::add_column(double u, Heights &heights) const {
    for (const ColumnPart &part : parts_of_column(u)) {
        heights[part.value] += std::max(part.v.upper - part.v.lower, 0.0);
    }
}

} // namespace nrb::face
