// SPDX-License-Identifier: MIT
#include "intersect/common/triple_search.h"

#include "base/numbers.h"
#include "base/watch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nrb::intersect {

namespace {

constexpr int most_blind_halvings = 16; // of pieces whose weights have no certain sign
// Limits on the triples of the next generation: the larger one of a number, and of a multiple of the triples
// of pieces.
constexpr size_t most_parts = 1 << 10, times_as_many = 16;

// Whether three boxes intersect, if gaps of up to `room` are closed.
template <class Lower, class Upper>
bool have_common_box(double room, Lower &&lower, Upper &&upper) {
    for (size_t c = 0; c < 3; ++c) {
        const double from = std::max({lower(0, c), lower(1, c), lower(2, c)}),
                     to = std::min({upper(0, c), upper(1, c), upper(2, c)});
        if (from - to > room) {
            return false;
        }
    }
    return true;
}

// The parameter at a local parameter of a piece.
double parameter_at(const Interval &range, double place) noexcept {
    const double at = range.lower * (1 - place) + range.upper * place;
    return place == 1 ? range.upper : std::clamp(at, range.lower, range.upper);
}

} // namespace

TripleSearch::TripleSearch(const std::array<const Spline *, 3> &surfaces,
                           const std::array<SurfaceBorders, 3> &borders)
    : frame_(pieces::frame_of(surfaces)) {
    for (size_t s = 0; s < 3; ++s) {
        sides_.emplace_back(*surfaces[s], frame_, borders[s], side_shifts[0]);
    }
}

std::vector<CommonPoint> TripleSearch::run(double tolerance) {
    tolerance_ = frame_.scaled(tolerance);
    find_pieces();
    const size_t most = std::max(most_parts, times_as_many * parts_.size());
    SearchSteps steps;
    while (!parts_.empty()) {
        for (const TripleParts &parts : parts_) {
            work_ended() || next_.size() > most ? add_open(parts) : look(parts);
            steps.next(next_.size());
        }
        parts_ = std::exchange(next_, {});
    }
    return std::move(found_);
}

void TripleSearch::find_pieces() {
    stack_.push_back({&sides_[0].cells.root(), &sides_[1].cells.root(), &sides_[2].cells.root()});
    while (!stack_.empty()) {
        const Cells cells = stack_.back();
        stack_.pop_back();
        work_ended() ? add_unknown(cells) : look_at(cells);
    }
}

void TripleSearch::look_at(const Cells &cells) {
    double room = 16 * eps;
    for (size_t s = 0; s < 3; ++s) {
        sides_[s].cells.tighten(*cells[s]);
        room += 2 * cells[s]->moved;
    }
    count_work(40);
    if (!have_common_box(
            room, [&](size_t s, size_t c) { return cells[s]->box[c]; },
            [&](size_t s, size_t c) { return cells[s]->box[3 + c]; })) {
        return;
    }
    if (std::ranges::all_of(cells, [](const PairCell *cell) { return is_positive(*cell); })) {
        parts_.push_back(
            {&sides_[0].root(*cells[0]), &sides_[1].root(*cells[1]), &sides_[2].root(*cells[2])});
    } else {
        divide(cells);
    }
}

// Groups of pieces are divided before pieces, and larger cells before smaller ones.
void TripleSearch::divide(const Cells &cells) {
    const auto rank = [](const PairCell *cell) {
        return is_positive(*cell) ? -1 : cell->piece ? cell->size : cell->size + 1e3;
    };
    const auto s = static_cast<size_t>(std::ranges::max_element(cells, {}, rank) - cells.begin());
    PairCell &cell = *cells[s];
    if ((cell.piece && cell.halvings >= most_blind_halvings) || !sides_[s].cells.split(cell)) {
        add_unknown(cells);
        return;
    }
    for (PairCell &child : cell.children) {
        Cells smaller = cells;
        smaller[s] = &child;
        stack_.push_back(smaller);
    }
}

void TripleSearch::look(const TripleParts &parts) {
    count_work(40);
    const double room = 2 * (parts[0]->error() + parts[1]->error() + parts[2]->error());
    if (!have_common_box(
            room, [&](size_t s, size_t c) { return parts[s]->box()[c].lower; },
            [&](size_t s, size_t c) { return parts[s]->box()[c].upper; })) {
        return;
    }
    for (size_t s = 0; s < 3; ++s) {
        if (!parts[s]->prepare()) {
            halve(parts, s);
            return;
        }
    }
    switch (chart_.set(parts)) {
    case TripleChart::Verdict::apart:
        return;
    case TripleChart::Verdict::chart:
        look_at_chart(parts);
        return;
    case TripleChart::Verdict::bent:
        halve(parts, chart_.most_bent());
        return;
    case TripleChart::Verdict::flat:
        halve(parts, static_cast<size_t>(std::ranges::max_element(
                                             parts, {}, [](const CrossCell *part) { return part->size(); }) -
                                         parts.begin()));
    }
}

// A common point counts if its range is small and well inside of the wide parts, for which the chart is
// proven.
void TripleSearch::look_at_chart(const TripleParts &parts) {
    const TripleChart::Found found = chart_.solution();
    if (outside(found.range)) {
        return;
    }
    const bool inside = std::ranges::all_of(found.range, [](const Interval &x) {
        return x.lower > -widening && x.upper < 1 + widening && x.upper - x.lower < widening;
    });
    inside ? add_point(parts, found) : halve(parts, chart_.most_bent());
}

void TripleSearch::halve(const TripleParts &parts, size_t first) {
    const double error = parts[0]->piece().error + parts[1]->piece().error + parts[2]->piece().error,
                 small = std::max(4 * error, tolerance_ / 4);
    for (size_t i = 0; i < 3; ++i) {
        const size_t s = (first + i) % 3;
        const CrossCell::Halves halves =
            parts[s]->size() > small ? parts[s]->halves(sides_[s].parts) : CrossCell::Halves{};
        if (halves[0] != nullptr) {
            for (CrossCell *half : halves) {
                TripleParts smaller = parts;
                smaller[s] = half;
                next_.push_back(smaller);
            }
            return;
        }
    }
    add_open(parts);
}

void TripleSearch::add_open(const TripleParts &parts) {
    count_work(work_of_a_kept_part);
    CommonPoint &open = found_.emplace_back();
    open.kind = HitKind::undecided;
    for (size_t i = 0; i < 6; ++i) {
        const CrossCell &part = *parts[i / 2];
        const Interval &range = part.piece().range[i % 2];
        const double lower = part.lower(i % 2);
        const double from = parameter_at(range, lower), to = parameter_at(range, lower + part.length(i % 2));
        open.range[i] = {std::min(from, to),
                         std::max(from, to)}; // ranges of a few ulps may round into the wrong order
    }
}

// A group of pieces stands for the whole surface.
void TripleSearch::add_unknown(const Cells &cells) {
    count_work(work_of_a_kept_part);
    CommonPoint &open = found_.emplace_back();
    open.kind = HitKind::undecided;
    for (size_t i = 0; i < 6; ++i) {
        const PairCell &cell = *cells[i / 2];
        const pieces::PieceGrid &grid = sides_[i / 2].ground.grid;
        const size_t k = i % 2;
        const int axis = static_cast<int>(k);
        open.range[i] = cell.piece
                            ? Interval{cell.piece->parameter({0, 0})[k], cell.piece->parameter({1, 1})[k]}
                            : Interval{grid.break_at(axis, 0), grid.break_at(axis, grid.count(axis))};
    }
}

void TripleSearch::add_point(const TripleParts &parts, const TripleChart::Found &found) {
    count_work(work_of_a_kept_part);
    CommonPoint &hit = found_.emplace_back();
    for (size_t i = 0; i < 6; ++i) {
        const CrossCell &part = *parts[i / 2];
        const size_t k = i % 2;
        const Interval &range = part.piece().range[k];
        const auto parameter = [&](double place) {
            const double at = part.lower(k) + part.length(k) * place;
            return range.lower * (1 - at) + range.upper * at;
        };
        const double rounding = 4 * eps * std::max(std::abs(range.lower), std::abs(range.upper));
        hit.range[i] = {parameter(found.range[i].lower) - rounding,
                        parameter(found.range[i].upper) + rounding};
        hit.at[i] = std::clamp(parameter(found.at[i]), range.lower, range.upper);
    }
    const Vector3 x = parts[0]->piece().evaluate(parts[0]->in_piece(found.at.data())).at;
    hit.point = {frame_.original(0, x.x), frame_.original(1, x.y), frame_.original(2, x.z)};
}

} // namespace nrb::intersect
