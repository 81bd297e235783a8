// SPDX-License-Identifier: MIT
#include "intersect/surfaces/cross_search.h"

#include "base/numbers.h"
#include "base/watch.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

namespace nrb::intersect {

namespace {

constexpr int most_blind_halvings = 16; // of pieces that have weights of no certain sign
constexpr int64_t few_rounds = 4;       // if the work left is enough for fewer, crowds are given up
// The largest number of pairs of adjacent parts of one surface that are divided in any case. Only small parts
// count: of large ones, there are as many as it takes where the surface bends.
constexpr size_t most_side_by_side = 2048;
constexpr double small_side_by_side = 0x1p-12; // area, relative to the piece
// In units of the errors of points: smaller parts do not tell apart what is no thicker.
constexpr double thick = 32;

// Whether the normals in the middles are parallel, regardless of their signs, up to an angle with this
// cosine.
bool are_parallel(const CrossCell &a, const CrossCell &b, double least_cosine) noexcept {
    const Vector3 of_a = cross(a.slope(0), a.slope(1)), of_b = cross(b.slope(0), b.slope(1));
    return std::abs(dot(of_a, of_b)) >= least_cosine * length(of_a) * length(of_b);
}

// Whether a plane through the normal and one of the derivatives in the middle of either part separates both:
// for parts in about one plane, a line in it.
bool are_side_by_side(const CrossCell &a, const CrossCell &b) {
    const double room = 4 * (a.error() + b.error());
    count_work(200);
    for (const CrossCell *cell : {&a, &b}) {
        const Vector3 normal = cross(cell->slope(0), cell->slope(1));
        for (const size_t axis : {size_t{0}, size_t{1}}) {
            const Vector3 across = cross(normal, cell->slope(axis));
            const double size = length(across);
            if (!(size > 0)) {
                continue;
            }
            const Vector3 unit = (1 / size) * across;
            const Interval of_a = a.hull_along(unit), of_b = b.hull_along(unit);
            if (of_a.lower - of_b.upper > room || of_b.lower - of_a.upper > room) {
                return true;
            }
        }
    }
    return false;
}

} // namespace

CrossSearch::CrossSearch(const Spline &a, const Spline &b, const SurfaceBorders &borders_a,
                         const SurfaceBorders &borders_b)
    : frame_(pieces::frame_of({{&a, &b}})), a_(a, frame_, borders_a, side_shifts[0]),
      b_(b, frame_, borders_b, side_shifts[1]), crowds_(a_.ground, b_.ground), solver_(a_.ground, b_.ground),
      contact_(solver_) {}

CrossSearch::CrossSearch(const Spline &g, const SurfaceBorders &borders)
    : CrossSearch(g, g, borders, borders) {
    self_.emplace(a_.ground);
}

CrossParts CrossSearch::run(double tolerance) {
    tolerance_ = frame_.scaled(tolerance);
    if (self_ && self_->is_one_sheet()) {
        return {};
    }
    crowds_.allow(work_left());
    find_pieces();
    SearchSteps steps;
    int64_t left = work_left();
    while (!pairs_.empty()) {
        const int64_t before = std::exchange(left, work_left());
        if (few_rounds * (before - left) > left) {
            give_up_crowds();
        }
        size_t looked = 0;
        for (; looked < pairs_.size() && !work_ended(); ++looked) {
            look(pairs_[looked]);
            steps.next(next_.size());
        }
        add_left(std::span(pairs_).subspan(looked));
        settle_crowds();
        pairs_ = std::exchange(next_, {});
    }
    return std::move(found_);
}

// Pairs that multiply in one place must not use up the work for all others: pairs of pieces with far more of
// them than most have are left open.
void CrossSearch::give_up_crowds() {
    const std::vector<size_t> counts = crowds_.counts_of(pairs_);
    const size_t most = CrossCrowds::far_above(counts);
    std::erase_if(pairs_, [&](const Pair &pair) {
        const bool crowd = counts[pair.of] > most;
        if (crowd) {
            add(pair);
        }
        return crowd;
    });
}

// Decides at the end of a round whether the flat pairs are halved, or left open as they are because their
// pairs of pieces are crowded. lies_on() is evaluated only for pairs that are clearly thicker than the
// tolerance: thinner parts seem to lie on a surface even where they only touch it.
void CrossSearch::settle_crowds() {
    constexpr double thick_to_lie = 32;
    for (const FlatPair &flat : flat_) {
        crowds_.count(flat.pair.of, flat.thickness > tolerance_);
    }
    for (const FlatPair &flat : flat_) {
        if (crowds_.are_many() && flat.thickness > thick_to_lie * tolerance_ &&
            crowds_.is_asked_for(flat.pair.of)) {
            crowds_.tell(flat.pair.of, lies_on(flat.pair));
        }
    }
    crowds_.settle();
    for (const auto &[pair, cut, thickness] : flat_) {
        crowds_.is_crowded(pair.of) ? add(pair) : halve(pair, cut);
    }
    flat_.clear();
    settle_side_by_side();
}

// Halves the pairs of adjacent parts of one surface, but leaves small ones open where they are too many:
// where a surface turns back along a curve, there are more and more.
void CrossSearch::settle_side_by_side() {
    const auto is_small = [](const Pair &pair) {
        return std::max(pair.a->length(0) * pair.a->length(1), pair.b->length(0) * pair.b->length(1)) <=
               small_side_by_side;
    };
    std::vector<Pair> small;
    std::ranges::copy_if(side_by_side_, std::back_inserter(small), is_small);
    const std::vector<size_t> counts = crowds_.counts_of(small);
    const size_t most =
        small.size() <= most_side_by_side ? small.size() : CrossCrowds::share_of(most_side_by_side, counts);
    for (const Pair &pair : side_by_side_) {
        is_small(pair) && counts[pair.of] > most ? add(pair) : halve_both(pair);
    }
    side_by_side_.clear();
}

void CrossSearch::find_pieces() {
    stack_.emplace_back(&a_.cells.root(), &b_.cells.root());
    while (!stack_.empty()) {
        const auto [a, b] = stack_.back();
        stack_.pop_back();
        work_ended() ? add_unknown(*a, *b) : look_at(*a, *b);
    }
}

void CrossSearch::look_at(PairCell &a, PairCell &b) {
    a_.cells.tighten(a);
    b_.cells.tighten(b);
    count_work(24);
    const double room = a.moved + b.moved + 16 * eps;
    for (size_t c = 0; c < 3; ++c) {
        if (a.box[c] - b.box[3 + c] > room || b.box[c] - a.box[3 + c] > room) {
            return;
        }
    }
    if (is_positive(a) && is_positive(b)) {
        count_work(work_of_a_pair);
        CrossCell &root_a = a_.root(a), &root_b = b_.root(b);
        pairs_.push_back({&root_a, &root_b, crowds_.add(root_a.piece(), root_b.piece())});
    } else {
        divide(a, b);
    }
}

// Divides groups of pieces first, then the larger piece.
void CrossSearch::divide(PairCell &a, PairCell &b) {
    const auto rank = [](const PairCell &cell) {
        return is_positive(cell) ? -1 : cell.piece ? cell.size : cell.size + 1e3;
    };
    const bool first = rank(a) >= rank(b);
    PairCell &cell = first ? a : b;
    if ((cell.piece && cell.halvings >= most_blind_halvings) || !(first ? a_ : b_).cells.split(cell)) {
        add_unknown(a, b);
        return;
    }
    for (PairCell &child : cell.children) {
        first ? stack_.emplace_back(&child, &b) : stack_.emplace_back(&a, &child);
    }
}

void CrossSearch::look(Pair pair) {
    count_work(24);
    if (are_apart(*pair.a, *pair.b) || (self_ && is_of_one_surface(pair))) {
        return;
    }
    const bool ready = pair.a->prepare();
    if (!pair.b->prepare() || !ready) { // the larger one: otherwise ever more parts would be near all of it
        halve(pair, {pair.a->size() >= pair.b->size(), std::nullopt});
        return;
    }
    switch (set_chart(pair)) {
    case CrossChart::Verdict::apart:
        return;
    case CrossChart::Verdict::chart:
        look_for_arc(pair);
        return;
    case CrossChart::Verdict::bent:
    case CrossChart::Verdict::flat:
        look_at_flat(pair);
    }
}

// Makes a chart of the pair; where tangent planes nearly coincide, one in a shear if there is no other.
CrossChart::Verdict CrossSearch::set_chart(Pair &pair) {
    constexpr double nearly = 0.9;
    box_.a = pair.a;
    box_.b = pair.b;
    cut_.reset();
    parts_ = {};
    const CrossChart::Verdict verdict = box_.chart.set(*pair.a, *pair.b);
    if (verdict == CrossChart::Verdict::apart || verdict == CrossChart::Verdict::chart || pair.no_shear ||
        !are_parallel(*pair.a, *pair.b, nearly)) {
        return verdict;
    }
    first_is_x_ = pair.a->size() <= pair.b->size();
    switch (first_is_x_ ? shear_.set(*pair.a, *pair.b, tolerance_)
                        : shear_.set(*pair.b, *pair.a, tolerance_)) {
    case CrossShear::Verdict::apart:
        return CrossChart::Verdict::apart;
    case CrossShear::Verdict::bounded:
        if (!shear_.come_apart() && shear_.height() <= tolerance_) {
            return verdict;
        }
        break;
    case CrossShear::Verdict::useless:
        pair.no_shear = true;
        return verdict;
    case CrossShear::Verdict::open:
        return verdict;
    }
    const CrossChart::Verdict sheared = box_.chart.set_sheared(first_is_x_ ? 0 : 1, shear_);
    keep_cut(pair);
    return sheared;
}

// Keeps what the shear suggests to halve. If its unknowns are only weakly coupled, tangent planes are nowhere
// the same: there is no contact, and it is halving along k that is left to do.
void CrossSearch::keep_cut(Pair &pair) {
    parts_ = shear_.parts();
    cut_ = {shear_.cut().first == first_is_x_, shear_.cut().axis};
    if (box_.chart.is_coupled()) {
        pair.no_contact = true;
        cut_ = {first_is_x_, box_.chart.axis() % 2};
    }
}

// Whether the shear leaves only little of a pair that touches nowhere: such pairs are no crowd, however many
// there are.
bool CrossSearch::is_little_left() const noexcept {
    constexpr double little = 0x1p-6;
    return parts_.left <= little && shear_.touch_nowhere();
}

void CrossSearch::look_for_arc(const Pair &pair) {
    const ArcFinder::Verdict verdict = finder_.look(box_);
    if (verdict == ArcFinder::Verdict::arc) {
        count_work(work_of_a_kept_part);
        found_.arcs.push_back(finder_.arc());
    } else if (verdict == ArcFinder::Verdict::open) {
        divide({pair.a, pair.b, pair.of, true, pair.no_contact, pair.no_shear}, usual_cut(pair));
    }
}

CrossSearch::Cut CrossSearch::usual_cut(const Pair &pair) const noexcept {
    if (cut_) {
        return *cut_;
    }
    const bool by_rows = box_.chart.has_rows();
    return {by_rows ? box_.chart.first_bends_more() : pair.a->size() >= pair.b->size(), std::nullopt};
}

// Whether a pair of parts of one surface needs no charts, because both are proven to be in one sheet, are the
// same or adjacent, or are in one place to within the tolerance.
bool CrossSearch::is_of_one_surface(Pair &pair) {
    switch (self_->look(*pair.a, *pair.b)) {
    case SelfPairs::Verdict::touching:
        are_in_one_place(pair) ? add(pair) : side_by_side_.push_back(pair);
        return true;
    case SelfPairs::Verdict::one_sheet:
        return true;
    case SelfPairs::Verdict::near:
        pair.no_contact = true; // where sheets part from each other, many places look like contacts
        if (!are_in_one_place(pair)) {
            return false;
        }
        add(pair);
        return true;
    case SelfPairs::Verdict::apart:
        return false;
    }
    return false;
}

// Whether both are so small that the tolerance does not tell them apart.
bool CrossSearch::are_in_one_place(const Pair &pair) const noexcept {
    return std::max(pair.a->size(), pair.b->size()) <= tolerance_ / 8;
}

// The thickness of both parts together along a normal of either, whichever is less. Negative: they are apart
// along one of them.
double CrossSearch::thickness(const Pair &pair) {
    const Vector3 of_a = cross(pair.a->slope(0), pair.a->slope(1)),
                  of_b = cross(pair.b->slope(0), pair.b->slope(1));
    double least = infinity;
    for (const Vector3 &normal : {of_a, of_b}) {
        const double size = length(normal);
        if (!(size > 0)) {
            continue;
        }
        const Vector3 unit = (1 / size) * normal;
        const Interval a = pair.a->points_along(unit), b = pair.b->points_along(unit);
        const double between = dot(unit, pair.a->centre() - pair.b->centre()),
                     room = pair.a->wide_error() + pair.b->wide_error();
        count_work(200);
        if (between + a.lower - b.upper > room || between + a.upper - b.lower < -room) {
            return -1;
        }
        least = std::min(least, std::max(b.upper, between + a.upper) - std::min(b.lower, between + a.lower));
    }
    return least;
}

// Whether the smaller part is along the larger one, judged by the distance of its middle.
bool CrossSearch::are_along(const Pair &pair) const {
    const bool first = pair.a->size() <= pair.b->size();
    return are_parallel(*pair.a, *pair.b, 0.999) &&
           distance_of_middle(first ? *pair.a : *pair.b, first ? *pair.b : *pair.a) <= tolerance_;
}

bool CrossSearch::lies_on(const Pair &pair) const {
    const bool first = pair.a->size() <= pair.b->size();
    return intersect::lies_on(first ? *pair.a : *pair.b, first ? *pair.b : *pair.a, tolerance_);
}

bool CrossSearch::look_for_contact(Pair &pair) {
    constexpr double largest = 0.5;
    if (pair.graph || pair.no_contact || std::min(pair.a->size(), pair.b->size()) > largest ||
        !are_parallel(*pair.a, *pair.b, 0.98)) {
        return false;
    }
    switch (contact_.look(*pair.a, *pair.b)) {
    case ContactChart::Verdict::contact:
        count_work(work_of_a_kept_part);
        found_.contacts.push_back({ranges_of(*pair.a, *pair.b), contact_.place(), contact_.change()});
        return true;
    case ContactChart::Verdict::apart:
        pair.no_contact = true;
        return false;
    case ContactChart::Verdict::open:
        return false;
    }
    return false;
}

void CrossSearch::look_at_flat(Pair pair) {
    const double thickness = this->thickness(pair), error = pair.a->piece().error + pair.b->piece().error;
    if (thickness < 0 || look_for_contact(pair)) {
        return;
    }
    const Cut cut = usual_cut(pair);
    if (thickness <= thick * error) {
        if (!pair.graph && !are_side_by_side(*pair.a, *pair.b)) {
            add(pair);
        }
        return;
    }
    const bool thin = thickness <= tolerance_, crowded = crowds_.is_crowded(pair.of);
    if (crowded && (thin || are_parallel(*pair.a, *pair.b, 0.8))) {
        add(pair);
    } else if (!is_little_left() && (thin || are_along(pair))) {
        flat_.push_back({pair, cut, thickness});
    } else {
        divide(pair, cut);
    }
}

} // namespace nrb::intersect
