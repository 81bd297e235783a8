// SPDX-License-Identifier: MIT
#include "intersect/pairs/near_search.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "intersect/open_pairs.h"
#include "intersect/pairs/periods.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

// For pieces whose weights have no certain sign, so that nothing else is known about them.
constexpr int most_halvings = 16;
// For the halves of a piece: their memory counts as well, since they are kept.
constexpr int64_t work_of_halves = 4000;

bool is_certain(const closest::PairCell &cell) noexcept {
    return cell.piece && cell.piece->positive();
}

// Precondition: the cell is a piece.
Interval range_of(const closest::PairCell &cell) noexcept {
    return {cell.piece->parameter({0.0})[0], cell.piece->parameter({1.0})[0]};
}

bool is_jump(const std::vector<double> &jumps, double t) noexcept {
    return std::ranges::binary_search(jumps, t);
}

} // namespace

NearSearch::NearSearch(const Spline &a, const Spline &b)
    : frame_(pieces::frame_of({{&a, &b}})), a_(a, frame_), b_(b, frame_), domain_a_(a.axis(0).domain()),
      domain_b_(b.axis(0).domain()), jumps_a_(jumps_of(a)), jumps_b_(jumps_of(b)),
      degrees_(a.axis(0).degree() + b.axis(0).degree()), dim_(a.dim()) {}

NearSearch::NearSearch(const Spline &curve) : NearSearch(curve, curve) {
    with_itself_ = true;
    closed_ = closes(curve);
}

double NearSearch::framed_noise() const noexcept {
    return 4 * (a_.moved() + b_.moved()) + 64 * (degrees_ + 2) * eps;
}

NearCells NearSearch::find(double tolerance) {
    tolerance_ = frame_.scaled(tolerance);
    stack_.push_back({&a_.root(), &b_.root()});
    return run();
}

NearCells NearSearch::refine(std::span<const NearCell> cells) {
    tolerance_ = 0;
    for (const NearCell &cell : cells) {
        stack_.push_back({cell.of_a, cell.of_b});
    }
    return run();
}

NearCells NearSearch::run() {
    result_ = {};
    result_.complete = look_at_all(
        stack_, [this](const Pair &pair) { look(pair); }, [this](const Pair &pair) { add_unknown(pair); });
    return std::move(result_);
}

void NearSearch::look(const Pair &pair) {
    a_.tighten(*pair.a);
    b_.tighten(*pair.b);
    count_work(8 * dim_);
    const double apart =
        closest::box_distance(pair.a->box, pair.b->box, dim_) - pair.a->moved - pair.b->moved - 16 * eps;
    if (apart > near()) {
        return;
    }
    if (with_itself_ && pair.a->piece && pair.b->piece && is_decided_by_order(pair)) {
        return;
    }
    if (!is_certain(*pair.a) || !is_certain(*pair.b)) {
        divide(pair);
        return;
    }
    const Judge::Verdict verdict = judge_.look(sloped(*pair.a), sloped(*pair.b), near(), framed_noise());
    if (verdict == Judge::Verdict::cell) {
        add(pair);
    } else if (verdict == Judge::Verdict::open) {
        divide(pair);
    }
}

bool NearSearch::is_apart(const Pair &pair) const noexcept {
    const Interval a = range_of(*pair.a), b = range_of(*pair.b);
    const bool apart = a.upper < b.lower || (a.upper == b.lower && is_jump(jumps_a_, a.upper));
    return apart && !is_seam(a, b);
}

// Parts that coincide, overlap or follow each other are near in any case: only their halves can tell what
// they hold.
bool NearSearch::is_decided_by_order(const Pair &pair) {
    if (range_of(*pair.b).upper <= range_of(*pair.a).lower) {
        return true; // found as (b, a)
    }
    if (is_apart(pair)) {
        return false;
    }
    if (!is_certain(*pair.a) || !is_certain(*pair.b) || !is_simple(pair)) {
        divide(pair);
    } else if (std::min(pair.a->size, pair.b->size) <= 64 * near()) {
        add_joined(pair, NearCell::Kind::simple); // parts before them may be near parts after them
    }
    return true;
}

bool NearSearch::is_seam(Interval a, Interval b) const noexcept {
    return closed_ && a.lower == domain_a_.lower && b.upper == domain_a_.upper;
}

// Whether the derivatives have no zero along a common vector, so that the parts together do not intersect
// themselves. With a tolerance, they must be nowhere so small that places within it of each other are farther
// apart along the curve than a few times the tolerance.
bool NearSearch::is_simple(const Pair &pair) {
    const pieces::Slopes &a = *sloped(*pair.a).slopes, &b = *sloped(*pair.b).slopes;
    const double of_a = norm(a.mean(), dim_), of_b = norm(b.mean(), dim_);
    if (!(of_a > 0) || !(of_b > 0)) {
        return false;
    }
    direction_.resize(static_cast<size_t>(dim_));
    for (size_t c = 0; c < direction_.size(); ++c) {
        direction_[c] = a.mean()[c] / of_a + b.mean()[c] / of_b;
    }
    const double length = norm(direction_.data(), dim_);
    if (!(length > 0)) {
        return false;
    }
    for (double &x : direction_) {
        x /= length;
    }
    const double share = tolerance_ > framed_noise() ? 0.25 : 0;
    return a.along(direction_.data()).lower > share * a.largest() &&
           b.along(direction_.data()).lower > share * b.largest();
}

pieces::SlopedPiece NearSearch::sloped(PairCell &cell) {
    if (cell.mark == 0) {
        slopes_.emplace_back(*cell.piece);
        cell.mark = slopes_.size();
    }
    return {&*cell.piece, &slopes_[cell.mark - 1]};
}

void NearSearch::add(const Pair &pair) {
    NearCell cell = judge_.cell();
    cell.gap = frame_.unscaled(cell.gap);
    set_segments(pair, cell);
    result_.list.push_back(cell);
}

void NearSearch::add_joined(const Pair &pair, NearCell::Kind kind) {
    add_unknown(pair);
    NearCell &cell = result_.list.back();
    cell.kind = kind;
    cell.gap = 0;
    set_segments(pair, cell);
}

void NearSearch::set_segments(const Pair &pair, NearCell &cell) const {
    const auto segment = [](const Jumps &jumps, const PairCell &part) {
        return std::ranges::upper_bound(jumps, part.piece->parameter({0.5})[0]) - jumps.begin();
    };
    cell.segment_a = segment(jumps_a_, *pair.a);
    cell.segment_b = segment(jumps_b_, *pair.b);
    cell.of_a = pair.a;
    cell.of_b = pair.b;
}

// Cells of several pieces stand for the whole curve.
void NearSearch::add_unknown(const Pair &pair) {
    const auto part = [](const PairCell &cell, Interval domain) {
        return cell.piece ? range_of(cell) : domain;
    };
    NearCell cell{};
    cell.kind = NearCell::Kind::unknown;
    cell.a = cell.core_a = part(*pair.a, domain_a_);
    cell.b = cell.core_b = part(*pair.b, domain_b_);
    cell.at_a = cell.a.lower / 2 + cell.a.upper / 2;
    cell.at_b = cell.b.lower / 2 + cell.b.upper / 2;
    cell.gap = infinity;
    result_.list.push_back(cell);
}

void NearSearch::divide(const Pair &pair) {
    // Groups of pieces are divided before pieces.
    const auto rank = [](const PairCell &cell) { return cell.piece ? cell.size : cell.size + 1e3; };
    const bool first = rank(*pair.a) >= rank(*pair.b);
    const PairCell &larger = first ? *pair.a : *pair.b;
    const bool is_certain_one = !larger.piece || is_certain(larger);
    if (divide(pair, first) || (is_certain_one && divide(pair, !first))) {
        return;
    }
    if (!is_certain(*pair.a) || !is_certain(*pair.b)) {
        add_unknown(pair);
    } else if (with_itself_ && !is_apart(pair)) {
        add_joined(pair, NearCell::Kind::fold);
    } else if (judge_.look_at_tiny(sloped(*pair.a), sloped(*pair.b), near(), framed_noise()) ==
               Judge::Verdict::cell) {
        add(pair);
    }
}

// Later parts are pushed first, so that earlier ones are looked at first.
bool NearSearch::divide(const Pair &pair, bool first) {
    PairCell &cell = first ? *pair.a : *pair.b;
    const bool is_new = cell.children.empty();
    const bool small = is_certain(cell) ? cell.size <= near() / 4 : cell.halvings >= most_halvings;
    if (small || !(first ? a_ : b_).split(cell)) {
        return false;
    }
    count_work(is_new ? work_of_halves : 0);
    for (auto child = cell.children.rbegin(); child != cell.children.rend(); ++child) {
        stack_.push_back({first ? &*child : pair.a, first ? pair.b : &*child});
    }
    return true;
}

} // namespace nrb::intersect
