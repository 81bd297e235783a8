// SPDX-License-Identifier: MIT
#include "numeric/exact_sum.h"

#include "numeric/power_of_two.h"

#include <bit>

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

// Takes the 106 bits from the leading one on, in two halves; the bits dropped are below 2^-105 of the value.
DoubleDouble ExactSum::scaled(int exponent) const noexcept {
    std::array<uint64_t, 3> size = negative() ? negated(limbs_) : limbs_;
    if (zero()) {
        return {};
    }
    int lowest = exponent + 64; // exponent of the lower of the two limbs in use
    for (; size[2] == 0; lowest -= 64) {
        size = {0, size[0], size[1]};
    }
    const int shift = std::countl_zero(size[2]);
    if (shift > 0) {
        size[2] = size[2] << shift | size[1] >> (64 - shift);
        size[1] = size[1] << shift | size[0] >> (64 - shift);
    }
    constexpr int half = 53, rest = 64 - half;
    const auto high = static_cast<double>(size[2] >> rest);
    const auto low = static_cast<double>((size[2] << half | size[1] >> rest) >> rest);
    lowest += 64 + rest - shift; // exponent of the upper half
    const DoubleDouble sum =
        DoubleDouble::ordered_sum(times_power_of_two(high, lowest), times_power_of_two(low, lowest - half));
    return negative() ? -sum : sum;
}

} // namespace nrb::inline numeric
