// SPDX-License-Identifier: MIT
#include "intersect/curve_surface/meet_search.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "intersect/open_pairs.h"
#include "numeric/norm.h"

#include <algorithm>

namespace nrb::intersect {

namespace {

constexpr int dim = 3;
// For pieces whose weights have no certain sign, so that nothing else is known about them.
constexpr int most_blind_halvings = 16;
constexpr int64_t work_of_a_kept_cell = 4000; // so that memory is limited by the work

bool has_points(const closest::PairCell &cell) noexcept {
    return cell.piece && cell.piece->positive();
}

// Whether the parameters cannot be halved any more along the axis on which the patch is much longer.
bool is_exhausted(const SlopedPatch &patch) noexcept {
    const double along[] = {norm(patch.mean(0), dim), norm(patch.mean(1), dim)};
    const size_t longer = along[0] >= along[1] ? 0 : 1;
    const double lower = patch.piece->parameter({0, 0})[longer],
                 upper = patch.piece->parameter({1, 1})[longer], middle = lower / 2 + upper / 2;
    constexpr double much = 4;
    return !(middle > lower && middle < upper) && along[longer] >= much * along[1 - longer];
}

} // namespace

MeetSearch::MeetSearch(const Spline &curve, const Spline &surface, const Seams &seams)
    : frame_(pieces::frame_of({{&curve, &surface}})), curve_cells_(curve, frame_),
      surface_cells_(surface, frame_), seams_(seams),
      degrees_(curve.axis(0).degree() + surface.axis(0).degree() + surface.axis(1).degree()) {}

double MeetSearch::framed_noise() const noexcept {
    return 4 * (curve_cells_.moved() + surface_cells_.moved()) + 64 * (degrees_ + 2) * eps;
}

MeetCells MeetSearch::find(double tolerance) {
    tolerance_ = frame_.scaled(tolerance);
    stack_.push_back({&curve_cells_.root(), &surface_cells_.root()});
    return run();
}

MeetCells MeetSearch::refine(std::span<const MeetCell> cells) {
    tolerance_ = 0;
    for (const MeetCell &cell : cells) {
        stack_.push_back({cell.of_curve, cell.of_surface});
    }
    return run();
}

MeetCells MeetSearch::run() {
    result_ = {};
    result_.complete = look_at_all(
        stack_, [this](const Pair &pair) { look(pair); }, [this](const Pair &pair) { add_unknown(pair); });
    return std::move(result_);
}

void MeetSearch::look(const Pair &pair) {
    curve_cells_.tighten(*pair.curve);
    surface_cells_.tighten(*pair.surface);
    count_work(8 * dim);
    const double apart = closest::box_distance(pair.curve->box, pair.surface->box, dim) - pair.curve->moved -
                         pair.surface->moved - 16 * eps;
    if (apart > near()) {
        return;
    }
    if (!has_points(*pair.curve) || !has_points(*pair.surface)) {
        divide(pair, false);
        return;
    }
    const MeetJudge::Verdict verdict =
        judge_.look(sloped_arc(*pair.curve), sloped_patch(*pair.surface), near(), framed_noise());
    if (verdict == MeetJudge::Verdict::cell) {
        add(pair);
    } else if (verdict == MeetJudge::Verdict::open) {
        divide(pair, judge_.curve_is_long());
    }
}

pieces::SlopedPiece MeetSearch::sloped_arc(PairCell &cell) {
    if (cell.mark == 0) {
        arc_slopes_.emplace_back(*cell.piece);
        cell.mark = arc_slopes_.size();
    }
    return {&*cell.piece, &arc_slopes_[cell.mark - 1]};
}

SlopedPatch MeetSearch::sloped_patch(PairCell &cell) {
    if (cell.mark == 0) {
        patch_slopes_.emplace_back(*cell.piece);
        cell.mark = patch_slopes_.size();
    }
    return {&*cell.piece, &patch_slopes_[cell.mark - 1]};
}

void MeetSearch::add(const Pair &pair) {
    count_work(work_of_a_kept_cell);
    MeetCell cell = judge_.cell();
    cell.gap = frame_.unscaled(cell.gap);
    const pieces::LocalParam middle = pair.surface->piece->parameter({0.5, 0.5});
    cell.segments = seams_.segments({pair.curve->piece->parameter({0.5})[0], middle[0], middle[1]});
    cell.of_curve = pair.curve;
    cell.of_surface = pair.surface;
    result_.list.push_back(cell);
}

// Cells of several pieces stand for the whole curve or surface.
void MeetSearch::add_unknown(const Pair &pair) {
    MeetCell cell{};
    cell.kind = MeetCell::Kind::unknown;
    cell.box = {seams_.domain(0), seams_.domain(1), seams_.domain(2)};
    const auto set = [&cell](size_t first, const PairCell &part) {
        if (part.piece) {
            const pieces::LocalParam lower = part.piece->parameter({0, 0}),
                                     upper = part.piece->parameter({1, 1});
            for (int k = 0; k < part.piece->axes(); ++k) {
                const auto at = static_cast<size_t>(k);
                cell.box[first + at] = {lower[at], upper[at]};
            }
        }
    };
    set(0, *pair.curve);
    set(1, *pair.surface);
    cell.core = cell.box;
    for (size_t k = 0; k < 3; ++k) {
        cell.at[k] = cell.box[k].lower / 2 + cell.box[k].upper / 2;
    }
    cell.gap = infinity;
    result_.list.push_back(cell);
}

void MeetSearch::divide(const Pair &pair, bool curve_is_long) {
    if (curve_is_long && divide_one(pair, true)) {
        return;
    }
    // Groups of pieces are divided before pieces.
    const auto rank = [](const PairCell &cell) { return cell.piece ? cell.size : cell.size + 1e3; };
    // Where only the bending of one of them is in the way of a chart, that one is divided first, if it is not
    // much smaller.
    constexpr double much = 4;
    const bool both = has_points(*pair.curve) && has_points(*pair.surface);
    const double favour = !both || !judge_.has_chart() ? 1 : judge_.curve_bends_more() ? much : 1 / much;
    const bool curve_first = favour * rank(*pair.curve) >= rank(*pair.surface);
    const PairCell &larger = curve_first ? *pair.curve : *pair.surface,
                   &smaller = curve_first ? *pair.surface : *pair.curve;
    // If the parameters of the larger one have no more digits, dividing a much smaller one gains little.
    const bool helps = !larger.piece || 4 * rank(smaller) >= rank(larger);
    if (divide_one(pair, curve_first) || (helps && divide_one(pair, !curve_first))) {
        return;
    }
    if (!has_points(*pair.curve) || !has_points(*pair.surface)) {
        add_unknown(pair);
    } else if (judge_.look_at_tiny(sloped_arc(*pair.curve), sloped_patch(*pair.surface), near(),
                                   framed_noise()) == MeetJudge::Verdict::cell) {
        add(pair);
    }
}

// Later parts are pushed first, so that earlier ones are looked at first.
bool MeetSearch::divide_one(const Pair &pair, bool of_curve) {
    PairCell &cell = of_curve ? *pair.curve : *pair.surface;
    const bool small = has_points(cell) ? cell.size <= near() / 4 : cell.halvings >= most_blind_halvings;
    const bool has_no_digits = !of_curve && has_points(cell) && is_exhausted(sloped_patch(cell));
    if (small || has_no_digits || !(of_curve ? curve_cells_ : surface_cells_).split(cell)) {
        return false;
    }
    for (auto child = cell.children.rbegin(); child != cell.children.rend(); ++child) {
        stack_.push_back({of_curve ? &*child : pair.curve, of_curve ? pair.surface : &*child});
    }
    return true;
}

} // namespace nrb::intersect
