// SPDX-License-Identifier: MIT
#include "closest/patch/patch_search.h"

#include "base/numbers.h"
#include "base/watch.h"
#include "closest/patch/critical/patch_critical.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nrb::closest {

namespace {

constexpr int deepest = 48;              // halvings of an axis
constexpr int most_rounds = 8;           // improvements by one item
constexpr int64_t work_of_a_look = 1000; // mostly descents; the products come in addition
constexpr int64_t turn = 12; // items examined in a row for one leaf, or for one part that was put off

} // namespace

PatchSearch::PatchSearch(const PieceGrid &pieces, const PatchTree &tree, const Query &query)
    : PatchMinima(pieces, query), tree_(tree) {
    const int64_t count = pieces.shape().coefficients();
    cost_ = std::max<int64_t>(1, count * count / 65536);
    work_ = work_of_a_look + 2 * count * std::min(count, pieces::most_squared) * pieces.shape().lanes;
}

void PatchSearch::spend() {
    spent_ += cost_;
    count_work(work_);
}

// Descends from the best centre seen, for a first value.
void PatchSearch::start(const PatchTree::Centre &centre) {
    const PatchMemory::Hold hold(memory_);
    const double *values = items_.values(centre.piece);
    const PatchBox part = box(centre.piece);
    best_.piece = centre.piece;
    for (size_t k = 0; k < static_cast<size_t>(pieces_.shape().axes); ++k) {
        best_.at[k] = std::clamp(centre.at[k], part.lower[k], part.upper[k]);
    }
    best_.value = sign_ * descent_.descend(values, part, sign_, floor_, best_.at).distance;
    best_.error =
        moved(centre.piece, best_.at) + pieces_.value_error() * (std::abs(best_.value) + pieces_.radius());
    if (!std::isfinite(best_.value)) {
        best_.value = infinity;
    }
}

// Pieces that may hold the best point come first, so that little is left to examine, and so that the best
// point found is a good one if the budget ends early.
void PatchSearch::search() {
    PatchCandidates candidates(pieces_, tree_, query_, items_.x(), tolerance_ + noise_);
    start(candidates.start());
    PatchCandidates::Groups groups;
    candidates.order(upper(), groups);
    for (const PatchCandidates::Group &group : groups) {
        if (group.bound > upper()) {
            break;
        }
        if (spent() && overdraft_ <= 0) {
            incomplete_ = true;
            break;
        }
        search_piece(group);
    }
    search_later();
}

void PatchSearch::search_piece(const PatchCandidates::Group &group) {
    const auto counts = [&](const Candidate &c) { return c.bound <= upper(); };
    const PatchMemory::Hold hold(memory_);
    PatchItem whole = items_.whole(group.piece);
    items_.measure(whole);
    const PatchBox part = box(group.piece);
    const bool most = std::count_if(group.first, group.last, counts) > 5 && query_.range == nullptr;
    if (most && !spent()) { // the proof may succeed for the whole piece at once
        const PatchMemory::Hold again(memory_);
        PatchItem item = whole;
        bool fresh = false;
        int axis = -1;
        spend();
        if (item.sound && finished(item, fresh, axis)) {
            return;
        }
    }
    for (const Candidate *leaf = group.first; leaf != group.last && counts(*leaf); ++leaf) {
        pause_ = spent_ + turn * cost_;
        search_leaf(whole, part, tree_.leaf(leaf->node));
    }
}

// Continues with the parts that were put off, in increasing order of order().
void PatchSearch::search_later() {
    const int64_t size = pieces_.shape().values();
    while (!later_.empty() && !spent()) {
        const PatchMemory::Hold hold(memory_);
        PutOff entry = later_.pop().item;
        double *values = memory_.take(size);
        std::copy_n(entry.values.data(), size, values);
        entry.item.values = values;
        pause_ = spent_ + turn * cost_;
        if (best_.value < entry.best) {
            examine(entry.item, false);
        } else {
            split(entry.item, entry.axis);
        }
    }
    incomplete_ = incomplete_ || !later_.empty();
}

// Examines the part of a leaf that lies in the range of the query.
void PatchSearch::search_leaf(const PatchItem &whole, const PatchBox &part, const PatchTree::Leaf &leaf) {
    const PatchMemory::Hold hold(memory_);
    PatchItem item = whole;
    if (tree_.parts() == 1) { // a copy, as halving overwrites the values
        item.values = memory_.take(pieces_.shape().values());
        std::copy_n(whole.values, pieces_.shape().values(), item.values);
    }
    for (int k = 0; k < pieces_.shape().axes; ++k) {
        const auto at = static_cast<size_t>(k);
        const int i = leaf.part[at], n = tree_.parts();
        const double first = static_cast<double>(i) / n, last = static_cast<double>(i + 1) / n;
        const double lower = std::max(first, part.lower[at]), upper = std::min(last, part.upper[at]);
        if (!(lower < upper)) {
            return;
        }
        if (lower != first || upper != last) {
            item = items_.part(item, k, lower, upper);
        } else if (n > 1) {
            item = items_.part(item, k, lower, upper, tree_.matrix(k, i));
        }
    }
    examine(item, true);
}

PatchGoal PatchSearch::goal(double value, const PatchItem &item) const noexcept {
    PatchGoal result;
    const double error = item.moved + best_.error;
    result.sign = sign_;
    result.worth = best_.value - 1e-2 * noise_;
    result.rho = sign_ * (value + error);
    result.margin = 2 * std::abs(result.rho) * std::max(0.0, tolerance_ + 0.875 * noise_ - error);
    return result;
}

void PatchSearch::examine(PatchItem &item, bool fresh) {
    if (spent()) {
        incomplete_ = true;
        if (fresh && overdraft_ > 0) {
            --overdraft_;
            items_.measure(item);
            improve(item, {0.5, 0.5, 0.5});
        }
        return;
    }
    spend();
    items_.measure(item);
    int axis = -1;
    if (!item.sound) {
        if (fresh) {
            improve(item, {0.5, 0.5, 0.5});
        }
    } else if (finished(item, fresh, axis)) {
        return;
    }
    axis = axis >= 0 ? axis : longest_axis(pieces_.shape(), item);
    if (spent_ >= pause_ && later_.size() < most_put_off) {
        put_off(item, axis);
    } else {
        split(item, axis);
    }
}

void PatchSearch::put_off(const PatchItem &item, int axis) {
    const double *values = item.values;
    later_.push(-order(item), {best_.value, item, axis, {values, values + pieces_.shape().values()}});
}

// An estimate of the least value in an item, by a ball about its middle. It only sets the order of the
// search: rounding is not included.
double PatchSearch::order(const PatchItem &item) const {
    const PatchMemory::Hold hold(memory_);
    const PatchShape &shape = pieces_.shape();
    double *middle = memory_.take(shape.dim), radius = 0;
    descent_.point(item.values, {0.5, 0.5, 0.5}, middle);
    const double *q = item.values;
    for (int64_t i = 0; i < shape.coefficients(); ++i, q += shape.lanes) {
        const double w = q[shape.dim];
        radius = std::max(radius, norm_of(shape.dim, [&](int c) { return q[c] / w - middle[c]; }));
    }
    const double order = sign_ * norm(middle, shape.dim) - (item.sound ? radius : 0);
    return std::isfinite(order) ? order : infinity;
}

void PatchSearch::split(PatchItem &item, int axis) {
    if (axis < 0 || item.length[static_cast<size_t>(axis)] < std::ldexp(1.0, -deepest)) {
        incomplete_ = true;
        return;
    }
    const PatchMemory::Hold hold(memory_);
    PatchItem lower = items_.halve_item(item, axis);
    examine(lower, false);
    examine(item, false);
}

// For patches of so many coefficients that their squares cost too much: excludes an item by the ball of its
// coefficients (for the farthest point), or by a half space orthogonal to the direction of its middle.
bool PatchSearch::excluded_by_plane(const PatchItem &item) {
    const double limit = lower() + item.moved + best_.error + 4 * pieces_.value_error() * item.reach;
    if (query_.farthest) {
        return item.reach <= -limit;
    }
    if (limit <= 0) {
        return true;
    }
    const PatchMemory::Hold hold(memory_);
    const PatchShape &shape = pieces_.shape();
    double *direction = memory_.take(shape.dim);
    descent_.point(item.values, {0.5, 0.5, 0.5}, direction);
    const double length = norm(direction, shape.dim) * (1 + (shape.dim + 8) * eps);
    const double *q = item.values;
    for (int64_t i = 0; i < shape.coefficients(); ++i, q += shape.lanes) {
        double height = 0;
        for (int c = 0; c < shape.dim; ++c) {
            height += q[c] * direction[c];
        }
        if (!(height >= limit * length * q[shape.dim])) {
            return false;
        }
    }
    return true;
}

bool PatchSearch::finished_without_squares(const PatchItem &item, bool &fresh) {
    if (excluded_by_plane(item)) {
        return true;
    }
    const bool better = fresh && improve(item, {0.5, 0.5, 0.5});
    fresh = false;
    return better && excluded_by_plane(item);
}

// Whether no point of the item counts any more, once the minima found in it have been recorded.
bool PatchSearch::finished(const PatchItem &item, bool &fresh, int &axis) {
    const PatchShape &shape = pieces_.shape();
    if (shape.coefficients() > pieces::most_squared) {
        return finished_without_squares(item, fresh);
    }
    const PatchMemory::Hold hold(memory_);
    const int64_t products = shape.products();
    double *work = memory_.take(pieces::product_work(shape));
    double *squares = memory_.take(products), *values = memory_.take(products);
    double *weights = shape.weighted ? memory_.take(products) : nullptr;
    square_patch(shape, pieces_.tables(), item.values, work, squares, weights);
    const PatchGap gap{squares, weights, values};
    Verdict verdict = Verdict::improved;
    for (int round = 0; round < most_rounds && verdict == Verdict::improved; ++round) {
        verdict = prove(item, gap, fresh, axis);
    }
    return verdict == Verdict::finished;
}

// Whether all points of the item are worse than the best one by more than counts.
bool PatchSearch::is_worse(const PatchItem &item, const PatchGap &gap) {
    const PatchGoal goal_of_others = goal(upper(), item);
    return goal_of_others.rho >= 0 ? PatchProof(pieces_, descent_, item, goal_of_others, gap).positive()
                                   : sign_ > 0;
}

PatchSearch::Verdict PatchSearch::prove(const PatchItem &item, const PatchGap &gap, bool &fresh, int &axis) {
    constexpr AxisValues middle{0.5, 0.5, 0.5};
    if (is_worse(item, gap)) {
        return Verdict::finished;
    }
    PatchGoal least = goal(lower(), item);
    const bool beyond = least.rho <= 0 && sign_ > 0;
    least.rho = std::max(0.0, least.rho);
    PatchProof proof(pieces_, descent_, item, least, gap);
    const bool not_nearer = proof.positive() || beyond;
    if (not_nearer && !asks_for_others()) {
        return Verdict::finished;
    }
    extra_ += not_nearer ? 1 : 0;
    if (not_nearer && proof.flat(4 * noise_)) {
        consider(item, middle, descent_.distance(item.values, middle), false);
        return Verdict::finished;
    }
    AxisValues guess{};
    const bool convex = proof.convex(best_in(item, guess) ? &guess : nullptr);
    if (proof.found() && improve_to(item, proof.at(), proof.distance())) {
        return Verdict::improved;
    }
    if (convex && (!all_ || is_least(item, gap, proof))) {
        consider(item, proof.at(), proof.distance(), proof.strict());
        return Verdict::finished;
    }
    if (fresh && !not_nearer) {
        fresh = false;
        if (improve(item, middle)) {
            return Verdict::improved;
        }
    }
    // Rounding is proportional to the reach of an item, so that from time to time the item is halved along
    // its longest axis, whatever the second derivatives are.
    const bool wide = item.depth % 3 == 2 && item.reach > 1.25 * least.rho;
    axis = wide ? longest_axis(pieces_.shape(), item) : proof.widest_axis();
    return not_nearer && item.depth > deepest ? Verdict::finished : Verdict::open;
}

// With weights, a minimum of F is not that of the distance unless F is near 0 there. Tests whether the
// minimum that was found is the least of the distance in this item, if its value counts at all.
bool PatchSearch::is_least(const PatchItem &item, const PatchGap &gap, const PatchProof &found) {
    const double value = sign_ * found.distance();
    if (!pieces_.shape().weighted || value > upper()) {
        return true;
    }
    PatchGoal least = goal(value - 0.875 * noise_, item);
    least.rho = std::max(0.0, least.rho);
    PatchProof proof(pieces_, descent_, item, least, gap);
    return proof.positive() || proof.convex(&found.at());
}

bool PatchSearch::improve(const PatchItem &item, AxisValues at) {
    const double distance = descent_.descend(item.values, {}, sign_, floor_, at).distance;
    return improve_to(item, at, distance);
}

Foot PatchSearch::nearest() {
    if (items_.far_away()) {
        return any_point();
    }
    search();
    Foot result = foot(best_);
    const double rounded = sign_ * pieces_.scaled(result.distance) - best_.value;
    const bool unproven = incomplete_ || !std::isfinite(best_.value);
    result.status |= unproven ? closest_budget : rounded <= noise_ / 8 ? closest_certified : closest_coarse;
    result.status |= not_unique_ ? closest_not_unique : 0;
    result.examined = spent_;
    return result;
}

// For a tolerance larger than rounding: finds the minima among the critical points of all pieces that come
// near enough. The proofs of search() do not suffice, as they disregard what is worse by less than the
// tolerance.
void PatchSearch::search_minima() {
    const double tolerance = std::exchange(tolerance_, 0.0);
    search();
    tolerance_ = tolerance;
    PatchCandidates candidates(pieces_, tree_, query_, items_.x(), tolerance_ + noise_);
    PatchCandidates::Groups groups;
    candidates.order(upper(), groups);
    std::vector<int64_t> pieces;
    for (const PatchCandidates::Group &group : groups) {
        pieces.push_back(group.piece);
    }
    Query rest = query_;
    rest.tolerance = 0;
    rest.budget = std::max<int64_t>(1, query_.most_pieces() - spent_);
    const MinimumCandidates found = minimum_candidates(pieces_, rest, pieces, upper());
    for (const MinimumCandidate &candidate : found.candidates) {
        others_.push_back({candidate.piece, candidate.at, candidate.distance, 0, candidate.certain});
    }
    incomplete_ = incomplete_ || found.gaps.incomplete;
    connected_ = found.gaps.connected;
    doubtful_ = found.gaps.doubtful;
}

std::vector<Foot> PatchSearch::all() {
    if (items_.far_away()) {
        return {any_point()};
    }
    if (tolerance_ > noise_ && pieces_.shape().coefficients() <= pieces::most_squared) {
        search_minima();
    } else {
        all_ = true;
        search();
    }
    const std::vector<FootCandidate> kept = distinct_minima();
    int32_t status = incomplete_ ? closest_budget : connected_ || doubtful_ ? 0 : closest_certified;
    status |= kept.size() > 1 || connected_ ? closest_not_unique : 0;
    std::vector<Foot> result;
    for (const FootCandidate &place : kept) {
        result.push_back(foot(place));
        result.back().status |= status;
    }
    std::sort(result.begin(), result.end(), [](const Foot &a, const Foot &b) { return a.params < b.params; });
    return result;
}

} // namespace nrb::closest
