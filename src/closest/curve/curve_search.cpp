// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "closest/curve/curve_search.cpp"
#include "base/dispatch.h"

#include <hwy/foreach_target.h>

#include "base/scratch.h"
#include "base/watch.h"
#include "closest/curve/curve_candidates-inl.h"
#include "closest/curve/curve_search.h"
#include "closest/curve/segment-inl.h"
#include "numeric/binomial.h"
#include "numeric/norm.h"

HWY_BEFORE_NAMESPACE();
namespace nrb::closest {
namespace HWY_NAMESPACE {

template <class Shape>
class CurveSearch {
public:
    CurveSearch(const CurveTree &tree, const Query &query, const Shape &shape)
        : tree_(tree), query_(query), shape_(shape),
          scratch_(static_cast<size_t>((stack_height + 1) * shape.size() + tree.dim() + max_degree + 1)),
          tools_(shape, scratch_.take(static_cast<size_t>(shape.size()))),
          x_(scratch_.take(static_cast<size_t>(tree.dim()))), norms_(scratch_.take(max_degree + 1)),
          segments_(scratch_.take(static_cast<size_t>(stack_height * shape.size()))),
          binomials_(binomials(tree.degree())), sign_(query.farthest ? -1 : 1),
          margin_(std::ldexp(query.tolerance + distance_noise(tree, query.point), -tree.exponent())),
          best_(tree, sign_, margin_), budget_(query.most_pieces()) {
        for (int c = 0; c < tree.dim(); ++c) {
            const double centre = tree.centre()[static_cast<size_t>(c)];
            x_[c] = std::ldexp(query.point[c] - centre, -tree.exponent());
            if (!std::isfinite(x_[c])) { // overflow: opposite signs, both near the largest number
                x_[c] = std::ldexp(query.point[c], -tree.exponent()) - std::ldexp(centre, -tree.exponent());
            }
        }
    }

    CurveSearchResult run() {
        const CurveCandidates candidates(tree_, query_, x_, margin_);
        for (const Candidate &candidate : candidates) {
            // The bound is NaN if squares overflow; the negated comparison then has the leaf examined.
            if (!(candidate.bound > std::min(candidates.limit(), best_.key() + margin_))) {
                examine(candidate.leaf, candidates.whole(candidate.leaf));
            }
        }
        if (!best_.found()) {
            best_.note({query_.range == nullptr ? 0 : tree_.leaf_at(query_.range->lower), 0,
                        std::numeric_limits<double>::infinity()});
        }
        count(budget_used_ % looks_between_counts);
        const bool certified = certified_ && tree_.sound() && budget_used_ <= budget_ && in_range();
        return {best_.best(), certified, best_.unique(), budget_used_};
    }

    CurvePlace local(int64_t leaf, double s) {
        leaf_ = leaf;
        parts_[0] = load(leaf, true);
        minimum(segment(0), s);
        return best_.best();
    }

private:
    static constexpr int stack_height = 64; // more halvings of a leaf than its parameter interval can take
    static constexpr double at_end = 0x1p-40;
    static constexpr int64_t looks_between_counts = 64, work_of_a_look = 16;

    // A part [a, b] of a leaf. Bits of `known`: a local minimum is known to be at the lower end (1), at the
    // upper end (2).
    struct LeafPart {
        double a;
        double b;
        int known;
    };

    [[nodiscard]] double *segment(int i) noexcept { return segments_ + i * shape_.size(); }

    // Loads the leaf relative to the query point, or the part of it that lies in the range.
    LeafPart load(int64_t leaf, bool whole) {
        const int lanes = shape_.lanes(), dim = tree_.dim();
        const double *HWY_RESTRICT records = tree_.records(leaf);
        double *HWY_RESTRICT to = segment(0);
        for (int i = 0; i <= shape_.degree(); ++i) {
            const double w = records[(i + 1) * lanes - 1];
            std::copy_n(records + i * lanes, lanes, to + i * lanes);
            for (int c = 0; c < dim; ++c) {
                to[i * lanes + c] -= w * x_[c];
            }
        }
        if (whole) {
            return {0, 1, 0};
        }
        const Interval domain = tree_.domain(leaf);
        const double length = domain.upper - domain.lower;
        const double a = std::clamp((query_.range->lower - domain.lower) / length, 0.0, 1.0);
        const double b = std::clamp((query_.range->upper - domain.lower) / length, 0.0, 1.0);
        if (b < 1) {
            tools_.split(to, b, to, segment(1));
        }
        if (a > 0) {
            tools_.split(to, b > 0 ? std::min(a / b, 1.0) : 0.0, segment(1), to);
        }
        return {a, b, 0};
    }

    void examine(int64_t leaf, bool whole) {
        leaf_ = leaf;
        parts_[0] = load(leaf, whole);
        bool untested = !in_range();
        for (int height = 1; height > 0;) {
            if (++budget_used_ > budget_ || work_ended_) {
                certified_ = certified_ && !work_ended_;
                return;
            }
            if (budget_used_ % looks_between_counts == 0) {
                count(looks_between_counts);
            }
            if (!untested && !in_range()) {
                certified_ = false; // then no polynomial can decide anything
                return;
            }
            if (best_.found() && sign_ > 0 && best_.goal() == 0) {
                return; // nothing is nearer by more than the tolerance
            }
            height = untested ? divide(height) : step(height);
            untested = false;
        }
    }

    void count(int64_t looks) {
        const int64_t degree = shape_.degree();
        count_work((looks * work_of_a_look * degree + steps_ * (degree * degree / 8 + 8)) * shape_.lanes());
        steps_ = 0;
        work_ended_ = work_ended();
    }

    // Whether there is a best place that is near enough for products with its squared distance not to
    // overflow.
    [[nodiscard]] bool in_range() const noexcept { return best_.found() && best_.best().square < 0x1p900; }

    // Decides the part on top of the stack, or replaces it by two.
    int step(int height) {
        const LeafPart part = parts_[height - 1];
        const double *records = segment(height - 1);
        if (tools_.beyond(records, best_.goal(), sign_, binomials_, norms_)) {
            note_end(records, 0, part.a);
            note_end(records, shape_.degree(), part.b);
            return height - 1;
        }
        if (height == stack_height) {
            certified_ = false;
            return height - 1;
        }
        return divide(height);
    }

    int divide(int height) {
        LeafPart &part = parts_[height - 1];
        double *records = segment(height - 1);
        double s = 0;
        int known = 0;
        if (part.known == 0) {
            current_ = height - 1;
            const double found = minimum(records, shape_.degree() == 0 ? 0.0 : guess(records));
            if (found < at_end || found > 1 - at_end) {
                part.known = found < at_end ? 1 : 2;
                return height; // to be tested against the minimum that was found
            }
            s = found;
            known = 3;
        } else {
            s = middle_of(records);
        }
        tools_.split(records, s, segment(height), records);
        const LeafPart whole = part;
        const double middle = whole.a + s * (whole.b - whole.a);
        // The upper part replaces the whole on the stack; the lower part is pushed on top of it.
        parts_[height - 1] = {middle, whole.b, (known & 1) | (whole.known & 2)};
        parts_[height] = {whole.a, middle, (known & 2) | (whole.known & 1)};
        return height + 1;
    }

    // The image of the parameter 1/2 after the reparametrization that makes the weights at both ends equal.
    // If these weights differ much, most of the curve is crowded into one end of its parameter interval.
    [[nodiscard]] double middle_of(const double *records) const noexcept {
        const int p = shape_.degree(), lanes = shape_.lanes();
        const double ratio = records[lanes - 1] / records[(p + 1) * lanes - 1];
        if (!(ratio < 0.25 || ratio > 4) || p == 0) {
            return 0.5;
        }
        const double root = std::pow(ratio, 1.0 / p);
        return std::clamp(root / (1 + root), 0x1p-10, 1 - 0x1p-10);
    }

    // A starting place: the nearest point of the chord, or the farther one of the two ends.
    [[nodiscard]] double guess(const double *records) const noexcept {
        const int p = shape_.degree(), last = shape_.lanes() - 1;
        const double *start = records, *end = records + p * shape_.lanes();
        if (query_.farthest) {
            return tools_.end_square(records, 0) > tools_.end_square(records, p) ? 0 : 1;
        }
        double along = 0, square = 0;
        for (int c = 0; c < last; ++c) {
            const double chord = end[c] * start[last] - start[c] * end[last];
            along -= start[c] * chord;
            square += chord * chord;
        }
        const double s = along * end[last] / square; // place on the chord; weighted if rational
        return s > 0 ? std::min(s, 1.0) : 0.0;
    }

    // A Newton step. Where the key is not convex, a fixed step downhill; from a maximum it may go either way.
    static double next_place(double s, double g, double h) noexcept {
        if (h > 0) {
            return s - g / h;
        }
        const bool down = g > 0 || (g == 0 && s > 0.5);
        return g == 0 && !(h < 0) ? s : s + (down ? -0.25 : 0.25);
    }

    // Damped Newton iteration from s to a local minimum of the key on the segment, which is recorded.
    double minimum(const double *records, double s) {
        Slope slope = tools_.slope(records, s);
        for (int i = 0; i < 60; ++i) {
            const double g = sign_ * slope.first, h = sign_ * slope.second;
            double target = next_place(s, g, h);
            target = target > 0 ? std::min(target, 1.0) : 0.0;
            const double move = std::abs(target - s);
            if (!(move > 0)) {
                break;
            }
            Slope next = tools_.slope(records, target);
            ++steps_;
            for (int back = 0; sign_ * next.square > sign_ * slope.square && back < 8 && move > 0x1p-30;
                 ++back) {
                target = 0.5 * (s + target);
                next = tools_.slope(records, target);
                ++steps_;
            }
            s = target;
            slope = next;
            if (move < 0x1p-50) {
                break;
            }
        }
        note(s, slope.square);
        return s;
    }

    void note(double s, double square) {
        const LeafPart &part = parts_[current_];
        best_.note({leaf_, part.a + s * (part.b - part.a), square});
    }

    void note_end(const double *records, int i, double s) {
        best_.note({leaf_, s, tools_.end_square(records, i)});
    }

    const CurveTree &tree_;
    const Query &query_;
    Shape shape_;
    Scratch scratch_;
    SegmentTools<Shape> tools_;
    double *x_;
    double *norms_;
    double *segments_;
    const double *binomials_;
    double sign_;
    double margin_;
    BestPlaces best_;
    bool certified_ = true, work_ended_ = work_ended();
    int64_t budget_, budget_used_ = 0;
    int64_t steps_ = 0; // evaluations made by minimum() since work was last counted
    int64_t leaf_ = 0;
    int current_ = 0; // index of the part that is being divided
    LeafPart parts_[stack_height + 1];
};

template <class Task>
auto with_shape(const CurveTree &tree, const Query &query, Task &&task) {
    if (tree.lanes() != 4) {
        return task(CurveSearch<SegmentShape<-1, 0>>(tree, query, {tree.degree(), tree.lanes()}));
    }
    if (tree.degree() != 3) {
        return task(CurveSearch<SegmentShape<-1, 4>>(tree, query, {tree.degree(), 4}));
    }
    return task(CurveSearch<SegmentShape<3, 4>>(tree, query, {3, 4}));
}

CurveSearchResult run_search(const CurveTree &tree, const Query &query) {
    return with_shape(tree, query, [](auto &&search) { return search.run(); });
}

CurvePlace run_descent(const CurveTree &tree, const Query &query, int64_t leaf, double s) {
    return with_shape(tree, query, [&](auto &&search) { return search.local(leaf, s); });
}

} // namespace HWY_NAMESPACE
} // namespace nrb::closest
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace nrb::closest {

NURBS_FORMS(run_search);
NURBS_FORMS(run_descent);

double distance_noise(const CurveTree &tree, const double *point) noexcept {
    const double reach = tree.size() + norm(point, tree.dim());
    return tree.rounding() * std::numeric_limits<double>::epsilon() * reach + underflow_noise;
}

CurveSearchResult search(const CurveTree &tree, const Query &query) {
    return NURBS_BEST(run_search)(tree, query);
}

CurvePlace descend(const CurveTree &tree, const double *point, int64_t leaf, double s) {
    return NURBS_BEST(run_descent)(tree, {point, nullptr, 0, 1}, leaf, s);
}

} // namespace nrb::closest
#endif
