// SPDX-License-Identifier: MIT
#include "numeric/exact_sum.h"

#include "numeric/power_of_two.h"

namespace nrb::inline numeric {

namespace {

void add_limbs(std::array<uint64_t, 3> &sum, const std::array<uint64_t, 3> &other) noexcept {
    uint64_t carry = 0;
    for (size_t i = 0; i < sum.size(); ++i) {
        const uint64_t with = other[i] + carry;
        carry = with < carry ? 1 : 0;
        sum[i] += with;
        carry += sum[i] < with ? 1 : 0;
    }
}

std::array<uint64_t, 3> negated(std::array<uint64_t, 3> limbs) noexcept {
    for (uint64_t &limb : limbs) {
        limb = ~limb;
    }
    add_limbs(limbs, {1, 0, 0});
    return limbs;
}

} // namespace

void ExactSum::add(const Int128 &term, int shift) noexcept {
    const auto high = static_cast<uint64_t>(term.high());
    const uint64_t sign = term.high() < 0 ? ~uint64_t{0} : 0;
    if (shift == 0) {
        return add_limbs(limbs_, {term.low(), high, sign});
    }
    add_limbs(limbs_, {term.low() << shift, high << shift | term.low() >> (64 - shift),
                       sign << shift | high >> (64 - shift)});
}

ExactSum &ExactSum::operator+=(const ExactSum &other) noexcept {
    add_limbs(limbs_, other.limbs_);
    return *this;
}

ExactSum &ExactSum::operator-=(const ExactSum &other) noexcept {
    add_limbs(limbs_, negated(other.limbs_));
    return *this;
}

DoubleDouble ExactSum::scaled(int exponent) const noexcept {
    const std::array<uint64_t, 3> size = negative() ? negated(limbs_) : limbs_;
    DoubleDouble sum;
    for (size_t half = 6; half-- > 0;) { // halves of limbs are doubles without rounding
        const auto bits = static_cast<double>(size[half / 2] >> (half % 2 * 32) & 0xffffffffu);
        sum = sum + DoubleDouble(times_power_of_two(bits, static_cast<int>(half) * 32 + exponent));
    }
    return negative() ? -sum : sum;
}

} // namespace nrb::inline numeric
