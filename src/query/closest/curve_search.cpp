#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "query/closest/curve_search.cpp"
#include "base/simd.h"

#include <hwy/foreach_target.h>

#include "base/norm.h"
#include "base/scratch.h"
#include "basis/binomial.h"
#include "query/closest/curve_search.h"
#include "query/closest/segment-inl.h"

HWY_BEFORE_NAMESPACE();
namespace nrb {
namespace HWY_NAMESPACE {

constexpr int fan = CurveTree::fan;

// Keys are what is made smallest: the distance, or its negative for the farthest point. Of eight children: no point
// has a smaller key than `bound`, some point has at most `reached`.
struct Keys {
    double bound[fan];
    double reached[fan];
};

HWY_INLINE void block_keys(const double *HWY_RESTRICT block, const double *HWY_RESTRICT x, int dim,
                           bool farthest, Keys &keys) {
    const double *HWY_RESTRICT inverse = block + 2 * dim * fan;
    const double *HWY_RESTRICT deviation = inverse + fan;
    double along[fan] = {}, first[fan] = {}, last[fan] = {};
    for (int c = 0; c < dim; ++c) {
        const double *HWY_RESTRICT start = block + c * fan;
        const double *HWY_RESTRICT chord = block + (dim + c) * fan;
        for (int k = 0; k < fan; ++k) {
            const double d = x[c] - start[k];
            along[k] += d * chord[k];
            first[k] += d * d;
            const double e = d - chord[k];
            last[k] += e * e;
        }
    }
    if (farthest) {
        for (int k = 0; k < fan; ++k) {
            keys.reached[k] = -std::sqrt(std::max(first[k], last[k]));
            keys.bound[k] = keys.reached[k] - deviation[k];
        }
        return;
    }
    double place[fan], square[fan] = {};
    for (int k = 0; k < fan; ++k) {
        place[k] = std::min(std::max(along[k] * inverse[k], 0.0), 1.0);
    }
    for (int c = 0; c < dim; ++c) {
        const double *HWY_RESTRICT start = block + c * fan;
        const double *HWY_RESTRICT chord = block + (dim + c) * fan;
        for (int k = 0; k < fan; ++k) {
            const double d = x[c] - start[k] - place[k] * chord[k];
            square[k] += d * d;
        }
    }
    for (int k = 0; k < fan; ++k) {
        const double distance = std::sqrt(square[k]);
        keys.bound[k] = distance - deviation[k];
        keys.reached[k] = distance + deviation[k];
    }
}

HWY_INLINE void node_bounds(const double *HWY_RESTRICT node, const double *HWY_RESTRICT x, int dim,
                            bool farthest, double *HWY_RESTRICT bound) {
    double square[fan] = {};
    for (int c = 0; c < dim; ++c) {
        const double *HWY_RESTRICT lower = node + c * fan;
        const double *HWY_RESTRICT upper = node + (dim + c) * fan;
        for (int k = 0; k < fan; ++k) {
            const double below = lower[k] - x[c], above = x[c] - upper[k];
            const double outside = std::max(std::max(below, above), 0.0);
            const double far = std::max(-below, -above);
            const double d = farthest ? far : outside;
            square[k] += d * d;
        }
    }
    for (int k = 0; k < fan; ++k) {
        bound[k] = farthest ? -std::sqrt(square[k]) : std::sqrt(square[k]);
    }
}

template <class Shape>
class CurveSearch {
public:
    CurveSearch(const CurveTree &tree, const Query &query, const Shape &shape)
        : tree_(tree), query_(query), shape_(shape),
          scratch_(
              static_cast<size_t>((stack_height + 1) * shape.size() + tree.dim() + NURBS_MAX_DEGREE + 1)),
          tools_(shape, scratch_.take(static_cast<size_t>(shape.size()))),
          x_(scratch_.take(static_cast<size_t>(tree.dim()))), norms_(scratch_.take(NURBS_MAX_DEGREE + 1)),
          segments_(scratch_.take(static_cast<size_t>(stack_height * shape.size()))),
          binomials_(binomials(tree.degree())), sign_(query.farthest ? -1 : 1),
          margin_(query.tolerance + distance_noise(tree, query.point)) {
        for (int c = 0; c < tree.dim(); ++c) {
            x_[c] = query.point[c] - tree.centre()[static_cast<size_t>(c)];
        }
        if (query.range != nullptr) {
            first_ = tree.leaf_at(query.range->lower);
            last_ = tree.leaf_at(query.range->upper);
        } else {
            last_ = tree.leaves() - 1;
        }
    }

    CurveSearchResult run() {
        collect();
        std::sort(candidates_, candidates_ + candidate_count_,
                  [](const Candidate &a, const Candidate &b) { return a.reached < b.reached; });
        for (int i = 0; i < candidate_count_; ++i) {
            if (candidates_[i].bound <= reached_ + margin_) {
                examine(candidates_[i].leaf);
            }
        }
        return {best_, certified_ && budget_used_ <= query_.budget, unique()};
    }

    CurvePlace local(int64_t leaf, double s) {
        leaf_ = leaf;
        parts_[0] = load(leaf);
        minimum(segment(0), s);
        return best_;
    }

private:
    static constexpr int most_candidates = 96;
    static constexpr int stack_height = 60;
    static constexpr int most_rivals = 16;
    // Halvings of a leaf beyond which nothing is left of it.
    static constexpr double shortest = 0x1p-46;
    static constexpr double at_end = 0x1p-40;

    struct Candidate {
        double bound;
        double reached;
        int64_t leaf;
    };
    struct Entry {
        double bound;
        int level; // -1: a block
        int64_t index;
    };
    // A part [a, b] of a leaf, on which a local minimum is known to be at the lower end (1) or the upper end (2).
    struct Part {
        double a;
        double b;
        int known;
    };

    // Goes through the tree, nearest children first, and keeps the leaves that may hold the nearest point.
    void collect() {
        Entry stack[(fan + 1) * 24];
        int height = 0;
        stack[height++] = {-std::numeric_limits<double>::infinity(), tree_.levels() - 1, 0};
        while (height > 0) {
            const Entry entry = stack[--height];
            if (entry.bound > reached_ + margin_) {
                continue;
            }
            if (entry.level < 0) {
                collect_block(entry.index);
            } else {
                height = push_children(entry, stack, height);
            }
        }
    }

    int push_children(const Entry &entry, Entry *stack, int height) const {
        double bound[fan];
        node_bounds(tree_.node(entry.level, entry.index), x_, tree_.dim(), query_.farthest, bound);
        const int64_t below = entry.level == 0 ? tree_.block_count() : tree_.node_count(entry.level - 1);
        const auto count = static_cast<int>(std::min<int64_t>(fan, below - entry.index * fan));
        const int bottom = height;
        for (int k = 0; k < count; ++k) {
            const Entry child{bound[k], entry.level - 1, entry.index * fan + k};
            if (child.bound > reached_ + margin_) {
                continue;
            }
            int place = height++;
            for (; place > bottom && stack[place - 1].bound < child.bound; --place) {
                stack[place] = stack[place - 1];
            }
            stack[place] = child;
        }
        return height;
    }

    void collect_block(int64_t block) {
        Keys keys;
        block_keys(tree_.block(block), x_, tree_.dim(), query_.farthest, keys);
        const int64_t first = std::max(first_, block * fan), last = std::min(last_, block * fan + fan - 1);
        for (int64_t leaf = first; leaf <= last; ++leaf) {
            const auto k = static_cast<size_t>(leaf - block * fan);
            if (keys.bound[k] > reached_ + margin_) {
                continue;
            }
            if (candidate_count_ == most_candidates) {
                make_room();
            }
            candidates_[candidate_count_++] = {keys.bound[k], keys.reached[k], leaf};
            if (whole(leaf)) {
                reached_ = std::min(reached_, keys.reached[k]);
            }
        }
    }

    // Forgets candidates that are out of reach by now, or examines them all.
    void make_room() {
        Candidate *const end =
            std::remove_if(candidates_, candidates_ + candidate_count_,
                           [this](const Candidate &c) { return c.bound > reached_ + margin_; });
        candidate_count_ = static_cast<int>(end - candidates_);
        if (candidate_count_ > most_candidates / 2) {
            for (int i = 0; i < candidate_count_; ++i) {
                examine(candidates_[i].leaf);
            }
            candidate_count_ = 0;
        }
    }

    [[nodiscard]] bool whole(int64_t leaf) const noexcept {
        return query_.range == nullptr || (tree_.domain(leaf).lower >= query_.range->lower &&
                                           tree_.domain(leaf).upper <= query_.range->upper);
    }

    [[nodiscard]] double *segment(int i) noexcept { return segments_ + i * shape_.size(); }

    // The leaf about the query point, or the part of it in the range.
    Part load(int64_t leaf) {
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
        if (whole(leaf)) {
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

    // The square of the distance that no point may fall below (exceed) for the proof.
    [[nodiscard]] double goal() const noexcept {
        const double distance = std::sqrt(best_.square) - sign_ * margin_;
        return distance > 0 ? distance * distance : 0;
    }

    void examine(int64_t leaf) {
        leaf_ = leaf;
        parts_[0] = load(leaf);
        bool untested = best_.leaf < 0;
        for (int height = 1; height > 0;) {
            if (++budget_used_ > query_.budget) {
                return;
            }
            if (best_.leaf >= 0 && sign_ > 0 && goal_ == 0) {
                return; // nothing is nearer by more than the tolerance
            }
            height = untested ? divide(height) : step(height);
            untested = false;
        }
    }

    // Decides about the uppermost part, or puts two in its place.
    int step(int height) {
        const Part part = parts_[height - 1];
        const double *records = segment(height - 1);
        if (tools_.beyond(records, goal_, sign_, binomials_, norms_)) {
            note_end(records, 0, part.a);
            note_end(records, shape_.degree(), part.b);
            return height - 1;
        }
        if (part.b - part.a < shortest || height == stack_height) {
            certified_ = false;
            return height - 1;
        }
        return divide(height);
    }

    int divide(int height) {
        Part &part = parts_[height - 1];
        double *records = segment(height - 1);
        double s = 0.5;
        int known = 0;
        if (part.known == 0) {
            current_ = height - 1;
            const double found = minimum(records, shape_.degree() == 0 ? 0.0 : guess(records));
            if (found < at_end || found > 1 - at_end) {
                part.known = found < at_end ? 1 : 2;
                return height; // to be tested with what was found
            }
            s = found;
            known = 3;
        }
        tools_.split(records, s, segment(height), records);
        const Part whole = part;
        const double middle = whole.a + s * (whole.b - whole.a);
        // the lower part is above the upper one, which took the place of the whole
        parts_[height - 1] = {middle, whole.b, (known & 1) | (whole.known & 2)};
        parts_[height] = {whole.a, middle, (known & 2) | (whole.known & 1)};
        return height + 1;
    }

    // Where the nearest point of the chord is, or the end that is farther.
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
        const double s = along * end[last] / square; // of the chord; by weights when rational
        return s > 0 ? std::min(s, 1.0) : 0.0;
    }

    // Damped Newton from s to a local minimum of the key on the segment, which is noted.
    double minimum(const double *records, double s) {
        Slope slope = tools_.slope(records, s);
        for (int i = 0; i < 60; ++i) {
            const double g = sign_ * slope.first, h = sign_ * slope.second;
            double target = h > 0 ? s - g / h : s - std::copysign(1.0, g) * (g != 0 ? 0.25 : 0.0);
            target = target > 0 ? std::min(target, 1.0) : 0.0;
            const double move = std::abs(target - s);
            if (!(move > 0)) {
                break;
            }
            Slope next = tools_.slope(records, target);
            for (int back = 0; sign_ * next.square > sign_ * slope.square && back < 8 && move > 0x1p-30;
                 ++back) {
                target = 0.5 * (s + target);
                next = tools_.slope(records, target);
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
        const Part &part = parts_[current_];
        CurvePlace place{leaf_, part.a + s * (part.b - part.a), square};
        note(place);
    }

    void note_end(const double *records, int i, double s) {
        const double square = tools_.end_square(records, i);
        if (sign_ * std::sqrt(square) <= reached_ + margin_) {
            note(CurvePlace{leaf_, s, square});
        }
    }

    // The best place, and those that are about as good.
    void note(const CurvePlace &place) {
        const double key = sign_ * std::sqrt(place.square);
        if (best_.leaf < 0 || sign_ * place.square < sign_ * best_.square) {
            if (best_.leaf >= 0) {
                add_rival(best_);
            }
            best_ = place;
            goal_ = goal();
            reached_ = std::min(reached_, key);
        } else if (key <= reached_ + margin_) {
            add_rival(place);
        }
    }

    void add_rival(const CurvePlace &place) { rivals_[rival_count_++ % most_rivals] = place; }

    // Whether no rival is both as near as the best place and a point elsewhere: points around the best one are as near
    // to `margin` over a distance of about sqrt(2 * margin * distance).
    [[nodiscard]] bool unique() {
        const double distance = std::sqrt(best_.square), limit = sign_ * distance + margin_;
        for (int i = 0; i < std::min(rival_count_, most_rivals); ++i) {
            if (sign_ * std::sqrt(rivals_[i].square) <= limit &&
                square_between(best_, rivals_[i]) > 64 * margin_ * (distance + margin_)) {
                return false;
            }
        }
        return true;
    }

    double square_between(const CurvePlace &a, const CurvePlace &b) {
        point_of(a, segment(0));
        point_of(b, segment(1));
        double sum = 0;
        for (int c = 0; c < shape_.lanes() - 1; ++c) {
            const double d = segment(0)[c] - segment(1)[c];
            sum += d * d;
        }
        return sum;
    }

    void point_of(const CurvePlace &place, double *out) {
        double *lower = segment(2);
        tools_.split(tree_.records(place.leaf), place.s, lower, segment(3));
        const double *record = lower + shape_.degree() * shape_.lanes();
        for (int c = 0; c < shape_.lanes(); ++c) {
            out[c] = record[c] / record[shape_.lanes() - 1];
        }
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
    int64_t first_ = 0;
    int64_t last_ = 0;
    double reached_ = std::numeric_limits<double>::infinity();
    CurvePlace best_;
    double goal_ = 0;
    bool certified_ = true;
    int64_t budget_used_ = 0;
    int64_t leaf_ = 0;
    int current_ = 0;
    int candidate_count_ = 0;
    int rival_count_ = 0;
    Candidate candidates_[most_candidates];
    Part parts_[stack_height + 1];
    CurvePlace rivals_[most_rivals];
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
} // namespace nrb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace nrb {

HWY_EXPORT(run_search);
HWY_EXPORT(run_descent);

double distance_noise(const CurveTree &tree, const double *point) noexcept {
    const double reach = tree.size() + norm(point, tree.dim());
    return tree.rounding() * std::numeric_limits<double>::epsilon() * reach;
}

CurveSearchResult search(const CurveTree &tree, const Query &query) {
    return HWY_DYNAMIC_DISPATCH(run_search)(tree, query);
}

CurvePlace descend(const CurveTree &tree, const double *point, int64_t leaf, double s) {
    return HWY_DYNAMIC_DISPATCH(run_descent)(tree, {point, nullptr, 0, 1}, leaf, s);
}

} // namespace nrb
#endif
