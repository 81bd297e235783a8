// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "base/finite.cpp"
#include "base/dispatch.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "base/finite.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace nrb::inline base {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Doubles = hn::ScalableTag<double>;
using Register = hn::Vec<Doubles>;

// Comparisons with NaN are false, so a NaN `value` leaves `known` unchanged.
HWY_INLINE Register larger(Register known, Register value) {
    return hn::IfThenElse(hn::Lt(known, value), value, known);
}

HWY_INLINE Register smaller(Register known, Register value) {
    return hn::IfThenElse(hn::Lt(value, known), value, known);
}

// Number of independent accumulators.
inline constexpr size_t strands = 4;

// Passes whole vectors to `more`, each with the index of its accumulator, and the remaining values to `rest`.
template <class More, class Rest>
HWY_INLINE void visit(std::span<const double> values, const More &more, const Rest &rest) {
    const Doubles d;
    const size_t lanes = hn::Lanes(d);
    size_t i = 0;
    for (; i + strands * lanes <= values.size(); i += strands * lanes) {
        for (size_t k = 0; k < strands; ++k) {
            more(hn::LoadU(d, values.data() + i + k * lanes), k);
        }
    }
    for (; i < values.size(); ++i) {
        rest(values[i]);
    }
}

// Whether no value has all exponent bits of `mask` set. Values that are not finite have all eleven exponent
// bits set; values from 2^961 on have the first five set. The tests are done on integers because arithmetic
// with such values would raise floating-point exceptions.
bool find_below(std::span<const double> values, uint64_t mask) {
    const hn::RebindToUnsigned<Doubles> bits;
    const auto exponent = hn::Set(bits, mask);
    const auto none = hn::Zero(bits);
    hn::Vec<decltype(bits)> found[strands] = {none, none, none, none};
    bool all = true;
    visit(
        values,
        [&](Register v, size_t k) HWY_ATTR {
            const auto high = hn::Eq(hn::And(hn::BitCast(bits, v), exponent), exponent);
            found[k] = hn::Or(found[k], hn::VecFromMask(bits, high));
        },
        [&](double x) { all = all && (std::bit_cast<uint64_t>(x) & mask) != mask; });
    const auto any = hn::Or(hn::Or(found[0], found[1]), hn::Or(found[2], found[3]));
    return all && hn::AllTrue(bits, hn::Eq(any, none));
}

double find_largest(std::span<const double> values) {
    const Doubles d;
    Register found[strands] = {hn::Zero(d), hn::Zero(d), hn::Zero(d), hn::Zero(d)};
    double last = 0;
    visit(
        values, [&](Register v, size_t k) HWY_ATTR { found[k] = larger(found[k], hn::Abs(v)); },
        [&](double x) { last = std::max(last, std::abs(x)); });
    const auto all = hn::Max(hn::Max(found[0], found[1]), hn::Max(found[2], found[3]));
    return std::max(last, hn::GetLane(hn::MaxOfLanes(d, all)));
}

Extremes find_extremes(std::span<const double> values) {
    const Doubles d;
    const auto first = hn::Set(d, values[0]);
    Register low[strands] = {first, first, first, first};
    Register high[strands] = {first, first, first, first};
    Extremes last{values[0], values[0]};
    visit(
        values,
        [&](Register v, size_t k) HWY_ATTR {
            low[k] = smaller(low[k], v);
            high[k] = larger(high[k], v);
        },
        [&](double x) {
            last = {std::min(last.smallest, x), std::max(last.largest, x)};
        });
    const auto lowest = hn::Min(hn::Min(low[0], low[1]), hn::Min(low[2], low[3]));
    const auto highest = hn::Max(hn::Max(high[0], high[1]), hn::Max(high[2], high[3]));
    return {std::min(last.smallest, hn::GetLane(hn::MinOfLanes(d, lowest))),
            std::max(last.largest, hn::GetLane(hn::MaxOfLanes(d, highest)))};
}

} // namespace HWY_NAMESPACE
} // namespace nrb::inline base
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace nrb::inline base {

NURBS_FORMS(find_below);
NURBS_FORMS(find_largest);
NURBS_FORMS(find_extremes);

bool all_finite(std::span<const double> values) noexcept {
    return NURBS_BEST(find_below)(values, 0x7ff0000000000000);
}

bool all_moderate(std::span<const double> values) noexcept {
    return NURBS_BEST(find_below)(values, 0x7c00000000000000);
}

double largest_magnitude(std::span<const double> values) noexcept {
    return NURBS_BEST(find_largest)(values);
}

Extremes extremes(std::span<const double> values) noexcept {
    return NURBS_BEST(find_extremes)(values);
}

} // namespace nrb::inline base
#endif
