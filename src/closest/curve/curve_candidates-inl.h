// SPDX-License-Identifier: MIT
// The leaves of a curve tree that may hold the nearest point. Included once per instruction set: see
// base/simd.h.
#if defined(NURBS_CLOSEST_CURVE_CURVE_CANDIDATES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef NURBS_CLOSEST_CURVE_CURVE_CANDIDATES_INL_H_
#undef NURBS_CLOSEST_CURVE_CURVE_CANDIDATES_INL_H_
#else
#define NURBS_CLOSEST_CURVE_CURVE_CANDIDATES_INL_H_
#endif

#include "closest/curve/curve_keys-inl.h"

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace nrb::closest {
namespace HWY_NAMESPACE {

struct Candidate {
    double bound;   // no point of the leaf has a smaller key
    double reached; // some point of the leaf has at most this key
    int64_t leaf;
};

// Collects all leaves whose bound is at most limit() in one pass over the tree, and sorts them by `reached`,
// the most promising first.
class CurveCandidates {
public:
    // x: the query point relative to the centre of the tree, in the tree's units.
    CurveCandidates(const CurveTree &tree, const Query &query, const double *x, double margin)
        : tree_(tree), query_(query), x_(x), margin_(margin), last_(tree.leaves() - 1) {
        if (query.range != nullptr) {
            first_ = tree.leaf_at(query.range->lower);
            last_ = tree.leaf_at(query.range->upper);
        }
        collect();
        std::sort(begin(), end(),
                  [](const Candidate &a, const Candidate &b) { return a.reached < b.reached; });
    }

    [[nodiscard]] const Candidate *begin() const noexcept { return data(); }
    [[nodiscard]] const Candidate *end() const noexcept { return data() + count_; }
    // An upper bound on the key of the best place, plus the margin.
    [[nodiscard]] double limit() const noexcept { return reached_ + margin_; }
    // Whether the whole leaf is in the range.
    [[nodiscard]] bool whole(int64_t leaf) const noexcept {
        return query_.range == nullptr || (tree_.domain(leaf).lower >= query_.range->lower &&
                                           tree_.domain(leaf).upper <= query_.range->upper);
    }

private:
    static constexpr int few = 96;

    struct Entry {
        double bound;
        int level; // -1: a block
        int64_t index;
    };

    [[nodiscard]] Candidate *begin() noexcept { return many_.empty() ? few_ : many_.data(); }
    [[nodiscard]] Candidate *end() noexcept { return begin() + count_; }
    [[nodiscard]] const Candidate *data() const noexcept { return many_.empty() ? few_ : many_.data(); }

    // Depth-first traversal of the tree, nearest children first.
    void collect() {
        Entry stack[(fan + 1) * 24];
        int height = 0;
        stack[height++] = {-std::numeric_limits<double>::infinity(), tree_.levels() - 1, 0};
        while (height > 0) {
            const Entry entry = stack[--height];
            if (entry.bound > limit()) {
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
            if (child.bound > limit()) {
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
            if (keys.bound[k] > limit()) {
                continue;
            }
            add({keys.bound[k], keys.reached[k], leaf});
            if (whole(leaf)) {
                reached_ = std::min(reached_, keys.reached[k]);
            }
        }
    }

    void add(const Candidate &candidate) {
        if (count_ == few && many_.empty()) {
            const double reach = limit();
            Candidate *const kept =
                std::remove_if(begin(), end(), [reach](const Candidate &c) { return c.bound > reach; });
            count_ = static_cast<int>(kept - begin());
            if (count_ > few / 2) {
                many_.assign(few_, few_ + count_);
            }
        }
        if (many_.empty()) {
            few_[count_] = candidate;
        } else {
            many_.push_back(candidate);
        }
        ++count_;
    }

    const CurveTree &tree_;
    const Query &query_;
    const double *x_;
    double margin_;
    int64_t first_ = 0;
    int64_t last_;
    double reached_ = std::numeric_limits<double>::infinity();
    int count_ = 0;
    Candidate few_[few];
    std::vector<Candidate> many_;
};

} // namespace HWY_NAMESPACE
} // namespace nrb::closest
HWY_AFTER_NAMESPACE();

#endif
