// SPDX-License-Identifier: MIT
// DoubleDouble (numeric/double_double.h) in the lanes of vectors, for coefficients that are needed by the
// million. Included once for every instruction set: see base/simd.h.
#if defined(NURBS_NUMERIC_DOUBLE_DOUBLE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef NURBS_NUMERIC_DOUBLE_DOUBLE_INL_H_
#undef NURBS_NUMERIC_DOUBLE_DOUBLE_INL_H_
#else
#define NURBS_NUMERIC_DOUBLE_DOUBLE_INL_H_
#endif

#include <cstdint>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace nrb::inline numeric {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// The constructors are written out, because compiler-generated ones would not be compiled for the instruction
// set.
template <class V>
struct DoubleDoubleLanes {
    HWY_INLINE DoubleDoubleLanes() {}
    HWY_INLINE DoubleDoubleLanes(V high_part, V low_part) : high(high_part), low(low_part) {}

    V high;
    V low;
};

// a + b exactly (Knuth's two-sum).
template <class V>
HWY_INLINE DoubleDoubleLanes<V> exact_sum(V a, V b) {
    const V sum = hn::Add(a, b);
    const V part = hn::Sub(sum, a);
    return {sum, hn::Add(hn::Sub(a, hn::Sub(sum, part)), hn::Sub(b, part))};
}

// a + b exactly. Precondition: |a| >= |b|.
template <class V>
HWY_INLINE DoubleDoubleLanes<V> ordered_sum(V a, V b) {
    const V sum = hn::Add(a, b);
    return {sum, hn::Sub(b, hn::Sub(sum, a))};
}

// The upper half of a 53-bit significand: rounded to 26 bits, so that the remainder has 26 bits and a sign.
// Works on the bits, because Dekker's multiplication by 2^27 + 1 overflows for large finite numbers;
// truncates where rounding would overflow.
template <class V>
HWY_INLINE V upper_half(V a) {
    const hn::DFromV<V> d;
    const hn::RebindToUnsigned<decltype(d)> bits;
    const auto half = hn::Set(bits, uint64_t{1} << 26);
    const auto kept = hn::Set(bits, ~uint64_t{0} << 27);
    const V rounded = hn::BitCast(d, hn::And(hn::Add(hn::BitCast(bits, a), half), kept));
    return hn::IfThenElse(hn::IsFinite(rounded), rounded, hn::And(a, hn::BitCast(d, kept)));
}

// a * b exactly: by a fused multiply-add, or else from halves.
template <class V>
HWY_INLINE DoubleDoubleLanes<V> exact_product(V a, V b) {
    const V product = hn::Mul(a, b);
#if !HWY_NATIVE_FMA
    const V upper_a = upper_half(a);
    const V upper_b = upper_half(b);
    const V lower_a = hn::Sub(a, upper_a);
    const V lower_b = hn::Sub(b, upper_b);
    const V crossed = hn::Add(hn::Mul(upper_a, lower_b), hn::Mul(lower_a, upper_b));
    const V rest = hn::Add(hn::Sub(hn::Mul(upper_a, upper_b), product), crossed);
    return {product, hn::Add(rest, hn::Mul(lower_a, lower_b))};
#else
    return {product, hn::MulSub(a, b, product)};
#endif
}

template <class V>
HWY_INLINE DoubleDoubleLanes<V> operator+(const DoubleDoubleLanes<V> &a, const DoubleDoubleLanes<V> &b) {
    const DoubleDoubleLanes<V> sum = exact_sum(a.high, b.high);
    return ordered_sum(sum.high, hn::Add(sum.low, hn::Add(a.low, b.low)));
}

template <class V>
HWY_INLINE DoubleDoubleLanes<V> operator-(const DoubleDoubleLanes<V> &a, const DoubleDoubleLanes<V> &b) {
    return a + DoubleDoubleLanes<V>{hn::Neg(b.high), hn::Neg(b.low)};
}

template <class V>
HWY_INLINE DoubleDoubleLanes<V> operator*(const DoubleDoubleLanes<V> &a, const DoubleDoubleLanes<V> &b) {
    const DoubleDoubleLanes<V> product = exact_product(a.high, b.high);
    const V crossed = hn::MulAdd(a.high, b.low, hn::Mul(a.low, b.high));
    return ordered_sum(product.high, hn::Add(product.low, crossed));
}

// The rounded inverse, corrected by a Newton step.
template <class V>
HWY_INLINE DoubleDoubleLanes<V> inverse(const DoubleDoubleLanes<V> &a) {
    const hn::DFromV<V> d;
    const V one = hn::Set(d, 1.0);
    const V rounded = hn::Div(one, a.high);
    const DoubleDoubleLanes<V> product = exact_product(rounded, a.high);
    const V rest = hn::Sub(hn::Sub(hn::Sub(one, product.high), product.low), hn::Mul(rounded, a.low));
    return ordered_sum(rounded, hn::Mul(rounded, rest));
}

} // namespace HWY_NAMESPACE
} // namespace nrb::inline numeric
HWY_AFTER_NAMESPACE();

#endif
