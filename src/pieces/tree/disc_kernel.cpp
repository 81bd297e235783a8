// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pieces/tree/disc_kernel.cpp"
#include "base/dispatch.h"

#include <hwy/foreach_target.h>

#include "pieces/tree/disc_kernel.h"

#include <limits>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace nrb::pieces {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Eight = hn::CappedTag<double, 8>;
inline constexpr int eight_lanes = static_cast<int>(hn::MaxLanes(Eight()));

// The numbers of discs i, i + 1, ... of a family.
struct FloatColumns {
    const float *family;
    int64_t width;
    int dim;
    double apart;

    [[nodiscard]] HWY_INLINE auto column(int k, int64_t i) const {
        return hn::PromoteTo(Eight(), hn::LoadU(hn::Rebind<float, Eight>(), family + k * width + i));
    }
    [[nodiscard]] HWY_INLINE auto from_centre(double x, int c, int64_t i) const {
        return hn::Sub(hn::Set(Eight(), x), column(c, i));
    }
    [[nodiscard]] HWY_INLINE auto radius(int64_t i) const { return column(dim, i); }
    [[nodiscard]] HWY_INLINE auto normal(int c, int64_t i) const { return column(dim + 1 + c, i); }
    [[nodiscard]] HWY_INLINE auto low(int64_t i) const { return column(2 * dim + 1, i); }
    [[nodiscard]] HWY_INLINE auto high(int64_t i) const { return column(2 * dim + 2, i); }
};

struct ByteColumns {
    const int8_t *family;
    const int16_t *normals;
    const float *frame;
    int64_t width;
    int dim;
    double apart;

    template <class Integer>
    [[nodiscard]] HWY_INLINE auto doubles(const Integer *from) const {
        const auto integers = hn::LoadU(hn::Rebind<Integer, Eight>(), from);
        return hn::PromoteTo(Eight(), hn::PromoteTo(hn::Rebind<int32_t, Eight>(), integers));
    }
    [[nodiscard]] HWY_INLINE auto column(int k, int64_t i) const { return doubles(family + k * width + i); }
    [[nodiscard]] HWY_INLINE auto scaled(int k, int64_t i, double scale) const {
        return hn::Mul(hn::Set(Eight(), scale), column(k, i));
    }
    [[nodiscard]] HWY_INLINE auto from_centre(double x, int c, int64_t i) const {
        const Eight d;
        return hn::NegMulAdd(hn::Set(d, double{frame[dim]}), column(c, i), hn::Set(d, x - double{frame[c]}));
    }
    [[nodiscard]] HWY_INLINE auto radius(int64_t i) const {
        const Eight d;
        const double scale = frame[dim + 1];
        return hn::MulAdd(hn::Set(d, scale), column(dim, i), hn::Set(d, 127 * scale));
    }
    [[nodiscard]] HWY_INLINE auto normal(int c, int64_t i) const {
        return hn::Mul(hn::Set(Eight(), normal_unit), doubles(normals + c * width + i));
    }
    [[nodiscard]] HWY_INLINE auto low(int64_t i) const { return scaled(dim + 1, i, double{frame[dim + 2]}); }
    [[nodiscard]] HWY_INLINE auto high(int64_t i) const { return scaled(dim + 2, i, double{frame[dim + 2]}); }
};

// The distance of x from all points p of a disc. Along n it is at least the distance of the heights; across
// n, the length of x - c less the radius. The root of a difference that cancels is taken of a lower (or
// upper) bound of it.
template <bool kNormals, bool kFarthest, class Columns>
HWY_INLINE void bound_all(const Columns &family, int64_t width, int dim, const double *HWY_RESTRICT x,
                          const DiscBounds &out) {
    const Eight d;
    const auto zero = hn::Zero(d);
    const auto apart = hn::Set(d, family.apart);
    const auto slack = hn::Set(d, (dim + 8) * std::numeric_limits<double>::epsilon());
    for (int64_t i = 0; i < width; i += eight_lanes) {
        auto square = zero, height = zero;
        for (int c = 0; c < dim; ++c) {
            const auto delta = family.from_centre(x[c], c, i);
            square = hn::MulAdd(delta, delta, square);
            if (kNormals) {
                height = hn::MulAdd(delta, family.normal(c, i), height);
            }
        }
        const auto radius = family.radius(i);
        const auto centre = hn::Sqrt(square);
        auto bound = zero;
        if (kNormals) {
            const auto low = family.low(i);
            const auto high = family.high(i);
            const auto rest = hn::NegMulAdd(height, height, square);
            const auto off = hn::Mul(slack, square);
            if (kFarthest) {
                const auto across = hn::Add(hn::Sqrt(hn::Max(zero, hn::Add(rest, off))), radius);
                const auto along = hn::Max(hn::Abs(hn::Sub(height, low)), hn::Abs(hn::Sub(height, high)));
                bound = hn::Sqrt(hn::MulAdd(along, along, hn::Mul(across, across)));
            } else {
                const auto root = hn::Sqrt(hn::Max(zero, hn::Sub(rest, off)));
                const auto across = hn::Max(zero, hn::Sub(root, radius));
                const auto along = hn::Max(zero, hn::Max(hn::Sub(height, high), hn::Sub(low, height)));
                bound = hn::Sqrt(hn::MulAdd(along, along, hn::Mul(across, across)));
            }
        } else {
            bound = kFarthest ? hn::Add(centre, radius) : hn::Max(zero, hn::Sub(centre, radius));
        }
        hn::StoreU(kFarthest ? hn::Neg(bound) : bound, d, out.bounds + i);
        hn::StoreU(hn::Add(kFarthest ? hn::Neg(centre) : centre, apart), d, out.centres + i);
    }
}

template <class Columns>
HWY_INLINE void bounds_of(const Columns &family, int64_t width, int dim, bool normals, const double *x,
                          bool farthest, const DiscBounds &out) {
    if (normals) {
        farthest ? bound_all<true, true>(family, width, dim, x, out)
                 : bound_all<true, false>(family, width, dim, x, out);
    } else {
        farthest ? bound_all<false, true>(family, width, dim, x, out)
                 : bound_all<false, false>(family, width, dim, x, out);
    }
}

void bounds(const FloatDiscs &family, int64_t width, int dim, bool normals, const double *x, bool farthest,
            const DiscBounds &out) {
    bounds_of(FloatColumns{family.columns, width, dim, family.apart}, width, dim, normals, x, farthest, out);
}

void byte_bounds(const ByteDiscs &family, int64_t width, int dim, bool normals, const double *x,
                 bool farthest, const DiscBounds &out) {
    bounds_of(ByteColumns{family.columns, family.normals, family.frame, width, dim, family.apart}, width, dim,
              normals, x, farthest, out);
}

} // namespace HWY_NAMESPACE
} // namespace nrb::pieces
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace nrb::pieces {

NURBS_FORMS(bounds);
NURBS_FORMS(byte_bounds);

int64_t disc_columns(int dim, bool normals) noexcept {
    return dim + 1 + (normals ? dim + 2 : 0);
}

void bound_discs(const FloatDiscs &family, int64_t width, int dim, bool normals, const double *x,
                 bool farthest, const DiscBounds &out) noexcept {
    NURBS_BEST(bounds)(family, width, dim, normals, x, farthest, out);
}

void bound_discs(const ByteDiscs &family, int64_t width, int dim, bool normals, const double *x,
                 bool farthest, const DiscBounds &out) noexcept {
    NURBS_BEST(byte_bounds)(family, width, dim, normals, x, farthest, out);
}

} // namespace nrb::pieces
#endif
