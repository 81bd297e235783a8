// SPDX-License-Identifier: MIT
#include "closest/pair/pair_search.h"

#include "base/error.h"
#include "base/numbers.h"
#include "base/watch.h"
#include "closest/foot.h"
#include "closest/pair/pair_bound.h"
#include "closest/pair/pair_regions.h"
#include "eval/evaluate.h"
#include "numeric/norm.h"
#include "pieces/best_first.h"
#include "spline/kind.h"

#include <algorithm>
#include <cmath>

namespace nrb::closest {

namespace {

struct CellPair {
    PairCell *a, *b;
    bool bounded; // by a descent and by separating surfaces
};

int highest_degree(const Spline &spline) noexcept {
    int degree = 0;
    for (int k = 0; k < spline.axes(); ++k) {
        degree = std::max(degree, spline.axis(k).degree());
    }
    return degree;
}

constexpr int64_t work_of_a_look = 400; // at a pair: memory and the boxes of its parts

using Entry = pieces::BestFirst<CellPair>::Entry;

class PairSearch {
public:
    // tolerance, far: in units of the frame.
    PairSearch(const Spline &a, const Spline &b, const pieces::Frame &frame, double tolerance, int64_t budget,
               const Regions &regions, double far)
        : a_(a, frame), b_(b, frame), regions_(a, b, regions), dim_(a.dim()),
          degrees_(highest_degree(a) + highest_degree(b)), tolerance_(tolerance), budget_(budget),
          upper_(far) {}

    // An allowance for rounding: of the pieces examined, and of the final evaluation of the points on both
    // splines.
    [[nodiscard]] double noise() const noexcept {
        return 4 * (a_.moved() + b_.moved()) + 64 * (degrees_ + 2) * eps;
    }

    void run() {
        dive();
        queue_.run(
            budget_, [&](const Entry &top) { return -top.bound < limit(); },
            [&](const Entry &top) {
                count_work(work_of_a_look);
                if (regions_.exclude(*top.item.a, *top.item.b)) {
                    return;
                }
                bounds(top.item) ? bound(top.item, -top.bound) : divide(top.item, -top.bound);
            });
    }

    [[nodiscard]] double at_least() const noexcept {
        return std::max(0.0, std::min(-queue_.bound(), upper_));
    }
    [[nodiscard]] double at_most() const noexcept { return upper_; }
    // Whether places at that distance are known.
    [[nodiscard]] bool found() const noexcept { return found_; }
    // The best places; left: whether a place is the upper end of its piece.
    struct Best {
        pieces::LocalParam a{}, b{};
        std::array<bool, max_axes> left_a{}, left_b{};
    };
    [[nodiscard]] const Best &best() const noexcept { return best_; }

private:
    // Pairs at this distance or more do not count. It is infinite before a distance is known if `far` is, and
    // NaN, which excludes nothing, if the tolerance is infinite, too.
    [[nodiscard]] double limit() const noexcept { return upper_ - tolerance_ - noise(); }

    // Whether the pair still lacks bounds that can be computed.
    static bool bounds(const CellPair &pair) noexcept {
        return pair.a->piece && pair.b->piece && pair.a->piece->positive() && pair.b->piece->positive() &&
               !pair.bounded;
    }

    // Finds a first distance, so that pairs can be excluded from the beginning: descends to a pair of pieces
    // by way of the nearest children.
    void dive() {
        Entry pair = entry({&a_.root(), &b_.root(), false}, 0);
        while (budget_ > 0 && !work_ended() && descend(pair)) {
            --budget_;
        }
        if (budget_ > 0 && bounds(pair.item)) {
            --budget_;
            bound(pair.item, -pair.bound);
        } else {
            push(pair);
        }
    }
    // Replaces the pair by the nearest pair that a child of a group forms, and queues the others. False if
    // neither cell is a group.
    bool descend(Entry &pair) {
        const PairCell *a = pair.item.a, *b = pair.item.b;
        if (a->piece && b->piece) {
            return false;
        }
        std::vector<Entry> children =
            divided(pair.item, -pair.bound, !a->piece && (b->piece || rank(*a) >= rank(*b)));
        if (children.empty()) {
            return false;
        }
        const auto nearest =
            std::min_element(children.begin(), children.end(), [this](const Entry &x, const Entry &y) {
                return std::pair(-x.bound, between(x.item)) < std::pair(-y.bound, between(y.item));
            });
        std::swap(*nearest, children.back());
        pair = children.back();
        children.pop_back();
        push(children);
        return true;
    }
    // The distance between the centres of the boxes.
    [[nodiscard]] double between(const CellPair &pair) const noexcept {
        const double *a = pair.a->box, *b = pair.b->box;
        return norm_of(dim_, [&](int c) { return (a[c] + a[dim_ + c] - b[c] - b[dim_ + c]) / 2; });
    }

    // Makes a queue entry; the pieces are made if the boxes of their discs are not far enough apart.
    Entry entry(const CellPair &pair, double least) {
        if (!(apart(*pair.a, *pair.b) >= limit())) {
            a_.tighten(*pair.a);
            b_.tighten(*pair.b);
        }
        return {-std::max(least, apart(*pair.a, *pair.b)), pair};
    }
    [[nodiscard]] double apart(const PairCell &a, const PairCell &b) const noexcept {
        return box_distance(a.box, b.box, dim_) - a.moved - b.moved - 16 * eps;
    }
    void push(const Entry &pair) {
        if (-pair.bound >= limit()) {
            queue_.leave_out(pair.bound);
        } else {
            queue_.push(pair.bound, pair.item);
        }
    }
    void push(const std::vector<Entry> &pairs) {
        for (const Entry &pair : pairs) {
            push(pair);
        }
    }

    void bound(const CellPair &pair, double lower) {
        const pieces::BezierPiece &a = *pair.a->piece, &b = *pair.b->piece;
        PairPlace place;
        place.a.fill(0.5);
        place.b.fill(0.5);
        descent_.run(a, b, place);
        const double moved = a.moved() + b.moved();
        const pieces::LocalParam on_a = a.parameter(place.a), on_b = b.parameter(place.b);
        if (place.distance + moved < upper_ && regions_.hold(on_a, on_b)) {
            upper_ = place.distance + moved;
            found_ = true;
            best_.a = on_a;
            best_.b = on_b;
            for (size_t k = 0; k < max_axes; ++k) {
                best_.left_a[k] = place.a[k] >= 1;
                best_.left_b[k] = place.b[k] >= 1;
            }
        }
        const double found = std::isfinite(place.distance) ? bound_.lower(a, b, place, limit()) : lower;
        push(Entry{-std::max(lower, found), {pair.a, pair.b, true}});
    }

    void divide(const CellPair &pair, double lower) {
        const bool first = rank(*pair.a) >= rank(*pair.b);
        std::vector<Entry> children = divided(pair, lower, first);
        if (children.empty()) {
            children = divided(pair, lower, !first);
        }
        if (children.empty()) {
            queue_.leave_out(-lower); // both are points
        }
        push(children);
    }
    // The cell of higher rank is divided first: groups before pieces, larger ones before smaller ones.
    [[nodiscard]] static double rank(const PairCell &cell) noexcept {
        return cell.piece ? cell.size : cell.size + 1e3;
    }

    // The pairs with the children of the first cell, or of the second one; empty if there are none.
    std::vector<Entry> divided(const CellPair &pair, double lower, bool first) {
        PairCell &cell = first ? *pair.a : *pair.b;
        std::vector<Entry> pairs;
        if ((first ? a_ : b_).split(cell)) {
            for (PairCell &child : cell.children) {
                pairs.push_back(entry({first ? &child : pair.a, first ? pair.b : &child, false}, lower));
            }
        }
        return pairs;
    }

    PairCells a_, b_;
    PairRegions regions_;
    int dim_, degrees_;
    double tolerance_;
    int64_t budget_;
    double upper_; // a proven upper bound, in the frame
    bool found_ = false;
    Best best_;
    pieces::BestFirst<CellPair> queue_; // ordered by negated lower bounds
    PairDescent descent_;
    PairBound bound_;
};

std::vector<double> point_of(const Spline &spline, const pieces::LocalParam &params,
                             const std::array<bool, max_axes> &left) {
    std::vector<double> x(static_cast<size_t>(spline.dim()));
    eval::AxisRules rules{};
    for (size_t k = 0; k < max_axes; ++k) {
        rules[k].left = left[k];
    }
    eval::evaluate_points(spline, rules, 0, {params.data(), 1, spline.axes(), spline.axes()},
                          {x.data(), 1, spline.dim(), spline.dim()});
    return x;
}

PairSearch::Best lower_corners(const Spline &a, const Spline &b) {
    PairSearch::Best corners;
    for (int k = 0; k < a.axes(); ++k) {
        corners.a[static_cast<size_t>(k)] = a.axis(k).domain().lower;
    }
    for (int k = 0; k < b.axes(); ++k) {
        corners.b[static_cast<size_t>(k)] = b.axis(k).domain().lower;
    }
    return corners;
}

} // namespace

PairDistance pair_distance(const Spline &a, const Spline &b, double tolerance, int64_t budget) {
    return pair_distance(a, b, tolerance, budget, {}, infinity);
}

// If no pair of pieces could be examined, any points of both splines will do, unless they have to be in
// regions or within a distance.
PairDistance pair_distance(const Spline &a, const Spline &b, double tolerance, int64_t budget,
                           const Regions &regions, double far) {
    check_same_dimension(a, b);
    const LimitedSearch limited;
    const pieces::Frame frame = pieces::frame_of({{&a, &b}});
    PairSearch search(a, b, frame, frame.scaled(tolerance), budget, regions, frame.scaled(far));
    search.run();
    PairDistance result;
    const double least = std::max(0.0, frame.unscaled(search.at_least()) - underflow_noise);
    result.rounding = frame.unscaled(2 * search.noise()) + 2 * underflow_noise;
    const bool any = std::isinf(far) && regions.a == nullptr && regions.b == nullptr;
    if (!search.found() && !any) {
        result.at_least = least;
        result.at_most = infinity;
        return result;
    }
    const PairSearch::Best best = search.found() ? search.best() : lower_corners(a, b);
    result.params_a = best.a;
    result.params_b = best.b;
    result.left_a = best.left_a;
    result.left_b = best.left_b;
    const std::vector<double> from = point_of(a, best.a, best.left_a), to = point_of(b, best.b, best.left_b);
    result.at_most = distance(from.data(), to.data(), a.dim());
    if (!std::isfinite(result.at_most)) {
        fail(Status::not_representable, "the distance overflows double precision");
    }
    result.at_least = std::min(least, result.at_most);
    result.certified =
        std::isfinite(result.rounding) && result.at_most - result.at_least <= tolerance + result.rounding;
    return result;
}

} // namespace nrb::closest
