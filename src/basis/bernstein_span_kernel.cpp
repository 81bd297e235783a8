// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "basis/bernstein_span_kernel.cpp"
#include "base/dispatch.h"

#include <hwy/foreach_target.h>

#include "base/limits.h"
#include "base/numbers.h"
#include "basis/bernstein_span.h"
#include "numeric/binomial.h"
#include "numeric/double_double-inl.h"

#include <algorithm>
#include <iterator>

HWY_BEFORE_NAMESPACE();
namespace nrb::inline basis {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using namespace numeric::HWY_NAMESPACE;

using Four = hn::CappedTag<double, 4>;
using V = hn::Vec<Four>;
using Number = DoubleDoubleLanes<V>;

constexpr int most = max_degree + 1;
constexpr int four_lanes = static_cast<int>(hn::MaxLanes(Four()));

// The two factors of each point in a step of de Boor's algorithm at a place in the support: the parts of the
// support ahead of the place and after its start, relative to the length of the support.
struct Shares {
    HWY_ALIGN double parts[4][most + 4]; // high and low parts of the share ahead, then of the share after

    HWY_INLINE Shares() {}

    // For the supports from before[i] to from[i], i < count; up to three more elements are read.
    HWY_INLINE void set(const double *before, const double *from, double place, int count) {
        const Four d;
        const V at = hn::Set(d, place);
        for (int i = 0; i < count; i += four_lanes) {
            const Number ahead = exact_sum(hn::LoadU(d, from + i), hn::Neg(at));
            const Number after = exact_sum(at, hn::Neg(hn::LoadU(d, before + i)));
            const Number slope = inverse(after + ahead);
            store(ahead * slope, after, i, 0);
            store(after * slope, ahead, i, 2);
        }
    }
    [[nodiscard]] HWY_INLINE Number ahead(int i) const { return number(0, i); }
    [[nodiscard]] HWY_INLINE Number after(int i) const { return number(2, i); }

private:
    // A share is exactly 1 where the other is 0.
    HWY_INLINE void store(const Number &share, const Number &other, int i, int row) {
        const Four d;
        const auto whole = hn::Eq(other.high, hn::Zero(d));
        hn::StoreU(hn::IfThenElse(whole, hn::Set(d, 1.0), share.high), d, parts[row] + i);
        hn::StoreU(hn::IfThenElse(whole, hn::Zero(d), share.low), d, parts[row + 1] + i);
    }
    [[nodiscard]] HWY_INLINE Number number(int row, int i) const {
        return {hn::Set(Four(), parts[row][i]), hn::Set(Four(), parts[row + 1][i])};
    }
};

// The knots u_1, ..., u_p up to the start a of a span, and v_1, ..., v_p from its end b on, padded for vector
// loads.
struct LocalKnots {
    double u[most + 3], v[most + 3], all_a[most + 3];

    HWY_INLINE LocalKnots(const double *knots, int degree, int64_t span) {
        const double *middle = knots + span;
        std::fill(std::copy_n(middle + 1 - degree, degree, u), std::end(u), *middle);
        std::fill(std::copy_n(middle + 1, degree, v), std::end(v), middle[degree]);
        std::fill(std::begin(all_a), std::end(all_a), *middle);
    }
};

// Four components of the points of a span, and the knot insertion on them.
class FourComponents {
public:
    HWY_INLINE FourComponents(const double *weights, const double *points, int degree, int lanes, int part)
        : degree_(degree) {
        const Four d;
        for (int j = 0; j <= degree; ++j) {
            points_[j] =
                exact_product(hn::Set(d, weights[j]), hn::LoadU(d, points + int64_t{j} * lanes + part));
        }
    }

    // Turns the polar values at (u_(i+k), ..., u_p, a, ..., a, v_1, ..., v_i), with k - 1 arguments a, into
    // those with one more a.
    HWY_INLINE void insert_start(int k, const Shares &at_a) {
        for (int i = 0; i <= degree_ - k; ++i) {
            points_[i] = points_[i] * at_a.ahead(i) + points_[i + 1] * at_a.after(i);
        }
    }
    // Turns the polar values at (a, ..., a, b, ..., b, v_1, ..., v_(i-k+1)), with k - 1 arguments b, into
    // those with one more b.
    HWY_INLINE void insert_end(int k, const Shares &at_b) {
        for (int i = degree_; i >= k; --i) {
            points_[i] = points_[i - 1] * at_b.ahead(i - k) + points_[i] * at_b.after(i - k);
        }
    }
    HWY_INLINE void store(int lanes, double *out) const {
        const Four d;
        for (int i = 0; i <= degree_; ++i) {
            const V factor = hn::Set(d, binomial(degree_, i));
            const Number product = exact_product(points_[i].high, factor);
            const V sum = hn::Add(product.high, hn::MulAdd(points_[i].low, factor, product.low));
            hn::StoreU(sum, d, out + int64_t{i} * lanes);
        }
    }

private:
    int degree_;
    Number points_[most];
};

void fill_bernstein_span(const double *knots, int degree, int64_t span, const double *weights,
                         const double *points, int lanes, double *out) {
    const LocalKnots local(knots, degree, span);
    Shares shares;
    for (int part = 0; part < lanes; part += four_lanes) {
        FourComponents components(weights, points, degree, lanes, part);
        for (int k = 1; k <= degree; ++k) {
            shares.set(local.u + k - 1, local.v, knots[span], degree + 1 - k);
            components.insert_start(k, shares);
        }
        shares.set(local.all_a, local.v, knots[span + 1], degree);
        for (int k = 1; k <= degree; ++k) {
            components.insert_end(k, shares);
        }
        components.store(lanes, out + part);
    }
}

} // namespace HWY_NAMESPACE
} // namespace nrb::inline basis
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace nrb::inline basis {

namespace {

NURBS_FORMS(fill_bernstein_span);

} // namespace

void make_bernstein_span(const double *knots, int degree, int64_t span, const double *weights,
                         const double *points, int lanes, double *out) noexcept {
    out[PowerSpan::lower] = out[PowerSpan::upper] = nan_value;
    out[BernsteinSpan::a] = knots[span];
    out[BernsteinSpan::b] = knots[span + 1];
    NURBS_BEST(fill_bernstein_span)
    (knots, degree, span, weights, points, lanes, out + BernsteinSpan::head_size);
}

} // namespace nrb::inline basis
#endif
