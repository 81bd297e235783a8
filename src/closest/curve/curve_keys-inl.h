// SPDX-License-Identifier: MIT
// Bounds on the distances of a point from eight leaves, or eight boxes, of a curve tree at once. Included
// once per instruction set: see base/simd.h.
#if defined(NURBS_CLOSEST_CURVE_CURVE_KEYS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef NURBS_CLOSEST_CURVE_CURVE_KEYS_INL_H_
#undef NURBS_CLOSEST_CURVE_CURVE_KEYS_INL_H_
#else
#define NURBS_CLOSEST_CURVE_CURVE_KEYS_INL_H_
#endif

#include "base/numbers.h"
#include "closest/curve/curve_tree.h"

#include <algorithm>
#include <cmath>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace nrb::closest {
namespace HWY_NAMESPACE {

constexpr int fan = CurveTree::fan;

// A key is the distance, or the negated distance when the farthest point is sought, so that the search always
// minimizes keys. For each of eight children: no point has a key below `bound`, and some point has a key of
// at most `reached`.
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
            const double end = -std::sqrt(std::max(first[k], last[k]));
            keys.bound[k] = end - deviation[k];
            keys.reached[k] = deviation[k] < infinity ? end : infinity;
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

} // namespace HWY_NAMESPACE
} // namespace nrb::closest
HWY_AFTER_NAMESPACE();

#endif
